//! Forces and powers of settled densities, by the law of [`super::motion`].

use crate::cutoff::CutOff;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::{Cells, Grid};
use crate::pairs::{Engine, Settled};
use crate::scalar::Scalar;

use super::density::{DensityNode, DensitySums, Width};
use super::dynamics::{GasDynamics, Lowest};
use super::motion::Motion;
use super::node::{GasNode, GasSums};
use super::options::EnergyForm;
use super::physics::{Physics, Sorted, Thermal};
use super::state::{Gas, Row};
use super::storage::{RatesOf, Workspace};
use super::terms::NodeOf;
use super::viscosity::{Local, Viscosity};
use super::waves::Means;

/// `√(1/2)`: a partner of the same kind is felt as softer than the particle itself.
const FELT: f64 = core::f64::consts::FRAC_1_SQRT_2;

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Densities and rates at the positions of `gas`, with velocities and energies predicted
    /// over `dt` by the rates that `gas` holds. Closes the step: half a kick with the old
    /// rates, half a kick with the new ones, which take their place.
    pub(crate) fn rates(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, P::Shown, D>,
        dt: S,
    ) -> Result<(), Error> {
        let grid = self.densities(engine, gas, work, dt)?;
        self.proven(engine, || self.prove_state(gas, dt))?;
        self.motion_rates(engine, gas, work, grid, dt)
    }

    /// Forces and powers of settled densities; closes the step.
    fn motion_rates(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, P::Shown, D>,
        grid: Grid<S, D>,
        dt: S,
    ) -> Result<(), Error> {
        let n = gas.len();
        *work.grid = Some(grid);
        let cells = work.cells.cells(grid, n);
        let densities = work.densities.get(..n).unwrap_or(&[]);
        let (Some(nodes), Some(rates)) = (work.nodes.get_mut(..n), work.rates.get_mut(..n)) else {
            return Err(Error::Lengths);
        };
        let sigma = S::from_f64(self.cut_off.normalisation::<D>());
        let excesses = self.excesses(gas, &cells, dt);
        for ((node, settled), &id) in nodes.iter_mut().zip(densities).zip(cells.order()) {
            if let Some(row) = gas.row(id) {
                *node = self.gas_node(settled, &row, &excesses, sigma, dt);
            }
        }
        let mut cloud = Sorted {
            engine,
            gas,
            cells,
            dt,
        };
        P::refine(self, &mut cloud, nodes, &mut work.gradients)?;
        let law = self.motion();
        if self.viscosity.needs_divergence() {
            // The sum of (3.12) holds div u; the pressures play no part in it.
            cloud.engine.evaluate(&law, &cells, nodes, rates)?;
            self.add_pressures(nodes, rates, densities.iter().map(|settled| &settled.node));
        }
        cloud.engine.evaluate(&law, &cells, nodes, rates)?;
        let settled = densities.iter().map(|settled| &settled.node);
        self.close_motion(cloud.gas, &cells, rates, (settled, &excesses), dt);
        P::close_energy(self, &mut cloud, nodes, rates)?;
        let mut problem = Lowest::default();
        for &id in cells.order() {
            if let Some(row) = cloud.gas.row(id) {
                problem.add(id, self.problem(&row, id));
            }
        }
        problem.result()
    }

    /// The law.
    pub(super) fn motion(&self) -> Motion<C, V, P> {
        Motion {
            cut_off: self.cut_off,
            viscosity: self.viscosity,
            terms: self.physics,
        }
    }

    /// What a particle shows in (3.10) and (3.12).
    fn gas_node(
        &self,
        settled: &Settled<DensityNode<S, D>, DensitySums<S, D>>,
        row: &Row<'_, S, D>,
        excesses: &Means<S>,
        sigma: S,
        dt: S,
    ) -> NodeOf<S, P, D> {
        let (settled, sums) = (&settled.node, &settled.sums);
        let velocity = row.predicted(dt);
        let (density, epsilon) = (self.density(row.mass, settled.density), settled.epsilon);
        let energy = self.expected_energy(row, density, dt);
        let (pressure, sound_speed) = self.pressure(row.material, density, energy);
        let pressure = self
            .pressure_beyond(row.position, &velocity, excesses, [density, sound_speed])
            .unwrap_or(pressure);
        let gradient = sigma / epsilon.powi(D + 2);
        GasNode {
            mass: row.mass,
            measure: self.measure(row.mass),
            pressure: pressure / (settled.omega * settled.density) / settled.density,
            gradient,
            scale: self.cut_off.scale(S::ONE / epsilon),
            sound_speed,
            stiffness: sound_speed * (row.mass.sqrt() / settled.density),
            density,
            epsilon,
            velocity,
            terms: self.physics.shown(&Thermal {
                material: row.material,
                density,
                pressure,
                energy,
                moment: self.moment(settled, sums, gradient),
            }),
        }
    }

    /// The second moment of the cut-off's gradient; not below the smallest Ω.
    #[inline(always)]
    fn moment(&self, settled: &DensityNode<S, D>, sums: &DensitySums<S, D>, gradient: S) -> S {
        let moment = match self.width {
            Width::Adaptive { .. } => settled.omega,
            Width::Constant { .. } => {
                -(sums.first * gradient) / (S::count(D as u32) * settled.density)
            }
        };
        moment.greater(self.smallest_omega)
    }

    /// Adds the viscosity's pressure to that of each particle.
    fn add_pressures<'s>(
        &self,
        nodes: &mut [NodeOf<S, P, D>],
        rates: &RatesOf<S, P, D>,
        densities: impl Iterator<Item = &'s DensityNode<S, D>>,
    ) {
        for ((node, rate), settled) in nodes.iter_mut().zip(rates).zip(densities) {
            node.pressure += self.viscous_pressure(node, settled, rate.sums.compression);
        }
    }

    /// The viscosity's pressure of a particle, `q/(Ω ρ²)` as that of (3.10); 0 where it has none.
    #[inline(always)]
    fn viscous_pressure(
        &self,
        node: &NodeOf<S, P, D>,
        settled: &DensityNode<S, D>,
        compression: S,
    ) -> S {
        if !self.viscosity.needs_divergence() {
            return S::ZERO;
        }
        let weight = S::ONE / (settled.density * settled.omega);
        let q = self.viscosity.pressure(&Local {
            density: node.density,
            sound_speed: node.sound_speed,
            epsilon: node.epsilon,
            divergence: -(compression * weight),
        });
        q * weight / settled.density
    }

    /// Kicks velocities, and internal energies where they go by leap-frog.
    fn close_motion<'s>(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        rates: &RatesOf<S, P, D>,
        (densities, excesses): (
            impl Iterator<Item = &'s DensityNode<S, D>> + Clone,
            &Means<S>,
        ),
        dt: S,
    ) {
        let means = [
            excesses,
            &self.divergences(gas, cells, rates, densities.clone()),
        ];
        let has_gradients = self.physics.need_gradients();
        for ((rate, settled), &id) in rates.iter().zip(densities).zip(cells.order()) {
            let (node, sums) = (&rate.node, &rate.sums);
            let Some(mut row) = gas.row(id) else { continue };
            let divergence = settled.divergence(sums);
            match self.domain.passed(row.position) {
                None => {
                    let viscous = self.viscous_pressure(node, settled, sums.compression);
                    let heat = node.measure * (viscous * sums.compression) + sums.power;
                    self.close_row(&mut row, node, sums, heat, dt);
                }
                Some(side) => {
                    self.close_beyond(side, &mut row, (node, sums), divergence, means, dt);
                }
            }
            *row.density = node.density;
            if !has_gradients {
                *row.divergence = divergence;
                *row.viscosity_factor = S::ONE;
            }
            *row.approach = sums.approach;
            let felt = sums.stiffest * (settled.density / row.mass.sqrt());
            let speed = node.sound_speed.greater(felt * S::from_f64(FELT));
            let diffusivity = self.physics.diffusivity(&node.terms);
            *row.signal = self.signal(&row, speed, sums.approach, diffusivity);
        }
    }

    /// Kicks a particle inside the domain.
    #[inline(always)]
    fn close_row(
        &self,
        row: &mut Row<'_, S, D>,
        node: &NodeOf<S, P, D>,
        sums: &GasSums<S, D>,
        heat: S,
        dt: S,
    ) {
        if self.physics.energy() == EnergyForm::Total {
            // What is kinetic now is not after the kick; the sum is what goes on.
            *row.energy += row.kinetic_energy();
        }
        row.kick(dt, self.with_external(node.mass, sums.force));
        match self.physics.energy() {
            EnergyForm::LeapFrog => {
                let power = node.measure * (node.pressure * sums.compression) + sums.power;
                self.close_energy(row, node.density, [power, heat], dt);
            }
            EnergyForm::Exact | EnergyForm::Total => *row.heat = heat,
        }
    }
}
