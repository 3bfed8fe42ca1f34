//! The rates with all that [`Options`](super::Options) adds, by the law of
//! [`super::exchange`].

use crate::cutoff::CutOff;
use crate::domain::Beyond;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::{Cells, Grid};
use crate::pairs::{Engine, Settled};
use crate::scalar::Scalar;

use super::density::DensityNode;
use super::dynamics::{GasDynamics, Lowest};
use super::exchange::{Exchange, ExchangeNode, ExchangeSums, Sum};
use super::gradient::{Gradient, GradientNode, GradientSums, divergence};
use super::options::{EnergyForm, Options};
use super::state::{Gas, Row, Wave};
use super::storage::Workspace;
use super::switch::{Flow, balsara};
use super::viscosity::{Local, Viscosity};

/// The node and the sums of each particle, in sorted order.
type Rates<S, const D: usize> = [Settled<ExchangeNode<S, D>, ExchangeSums<S, D>>];

impl<S, C, V, E, const D: usize> GasDynamics<'_, S, C, V, E, Options<S, D>, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
{
    /// Forces and powers of settled densities; closes the step.
    pub(super) fn exchange_rates(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        grid: Grid<S, D>,
        dt: S,
    ) -> Result<(), Error> {
        let n = gas.len();
        let cells = work.cells.cells(grid, n);
        let densities = work.densities.get(..n).unwrap_or(&[]);
        let buffers = &mut work.exchange;
        let (Some(nodes), Some(rates)) = (buffers.nodes.get_mut(..n), buffers.rates.get_mut(..n))
        else {
            return Err(Error::Lengths);
        };
        let sigma = S::from_f64(self.cut_off.normalisation::<D>());
        for ((node, settled), &id) in nodes.iter_mut().zip(densities).zip(cells.order()) {
            if let Some(row) = gas.row(id) {
                *node = self.exchange_node(&settled.node, &row, sigma, dt);
            }
        }
        if self.physics.need_gradients() {
            let (Some(gradient_nodes), Some(gradients)) = (
                buffers.gradient_nodes.get_mut(..n),
                buffers.gradients.get_mut(..n),
            ) else {
                return Err(Error::Lengths);
            };
            self.gradients(engine, &cells, nodes, gradient_nodes, gradients)?;
            self.switch(gas, &cells, nodes, gradients, dt);
        }
        let mut law = Exchange {
            cut_off: self.cut_off,
            viscosity: self.viscosity,
            limited: self.physics.limited,
            conduction: self.physics.conduction,
            diffusion: self.physics.diffusion,
            sum: Sum::Forces,
        };
        if self.viscosity.needs_divergence() {
            engine.sweep(&law, &cells, nodes, rates)?;
            self.add_pressures(nodes, rates, densities.iter().map(|settled| &settled.node));
        }
        engine.sweep(&law, &cells, nodes, rates)?;
        let settled = densities.iter().map(|settled| &settled.node);
        self.close_motion(gas, &cells, rates, settled, dt);
        match self.physics.energy {
            EnergyForm::LeapFrog => {}
            EnergyForm::Exact => {
                for (node, &id) in nodes.iter_mut().zip(cells.order()) {
                    let Some(row) = gas.row(id) else { continue };
                    node.velocity_now = *row.velocity;
                    for (component, &force) in node.acceleration.iter_mut().zip(row.force.iter()) {
                        *component = force / row.mass;
                    }
                }
                law.sum = Sum::Work;
                engine.sweep(&law, &cells, nodes, rates)?;
                self.close_work(gas, &cells, rates, dt);
            }
            EnergyForm::Total => {
                law.sum = Sum::Flow;
                engine.sweep(&law, &cells, nodes, rates)?;
                self.close_flow(gas, &cells, rates, dt);
            }
        }
        let mut problem = Lowest::default();
        for &id in cells.order() {
            if let Some(row) = gas.row(id) {
                problem.add(id, self.problem(&row, id));
            }
        }
        problem.result()
    }

    /// What a particle shows, but for slopes and factors.
    fn exchange_node(
        &self,
        settled: &DensityNode<S, D>,
        row: &Row<'_, S, D>,
        sigma: S,
        dt: S,
    ) -> ExchangeNode<S, D> {
        let (velocity, energy) = row.predicted(dt, self.physics.energy);
        let (density, epsilon) = (*row.density, settled.epsilon);
        let (pressure, sound_speed) = self.pressure(row.material, density, energy);
        ExchangeNode {
            mass: row.mass,
            measure: self.measure(row.mass),
            force_pressure: pressure / (settled.omega * settled.density) / settled.density,
            pressure,
            gradient: sigma / epsilon.powi(D + 2),
            scale: self.cut_off.scale(S::ONE / epsilon),
            sound_speed,
            density,
            specific_volume: S::ONE / density,
            epsilon,
            energy,
            material: S::count(u32::from(row.material)),
            linear: S::ONE,
            factor: S::ONE,
            velocity,
            velocity_now: [S::ZERO; D],
            acceleration: [S::ZERO; D],
            energy_slope: [S::ZERO; D],
            slope: [[S::ZERO; D]; D],
        }
    }

    /// The gradients, into the results of the sweep.
    fn gradients(
        &self,
        engine: &mut impl Engine<S, D>,
        cells: &Cells<'_, S, D>,
        nodes: &[ExchangeNode<S, D>],
        gradient_nodes: &mut [GradientNode<S, D>],
        gradients: &mut [Settled<GradientNode<S, D>, GradientSums<S, D>>],
    ) -> Result<(), Error> {
        for (to, node) in gradient_nodes.iter_mut().zip(nodes) {
            *to = GradientNode {
                measure: node.measure,
                scale: node.scale,
                energy: node.energy,
                velocity: node.velocity,
            };
        }
        let law = Gradient {
            cut_off: self.cut_off,
        };
        engine.sweep(&law, cells, gradient_nodes, gradients)
    }

    /// Slopes and factors of the viscosity, from the velocity gradients.
    fn switch(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        nodes: &mut [ExchangeNode<S, D>],
        gradients: &[Settled<GradientNode<S, D>, GradientSums<S, D>>],
        dt: S,
    ) {
        for ((node, gradient), &id) in nodes.iter_mut().zip(gradients).zip(cells.order()) {
            let Some(row) = gas.row(id) else { continue };
            let slopes = gradient.sums.slopes();
            let gradient = slopes.velocity;
            if self.physics.conduction > S::ZERO {
                node.energy_slope = slopes.energy;
            }
            if self.physics.limited {
                node.slope = gradient;
            }
            if self.physics.balsara {
                node.factor = balsara(&gradient, node.sound_speed, node.epsilon);
            }
            if let Some(switch) = &self.physics.switch {
                let flow = Flow {
                    gradient,
                    divergence_before: *row.divergence,
                    epsilon: node.epsilon,
                    support: S::count(self.cut_off.support()),
                    signal: node.sound_speed + *row.approach,
                    dt,
                };
                node.linear = switch.factor(*row.viscosity_factor, &flow);
            }
            // What the switch goes on from; Balsara's factor is that of a moment.
            *row.viscosity_factor = match &self.physics.switch {
                Some(_) => node.linear,
                None => node.factor,
            };
            *row.divergence = divergence(&gradient);
        }
    }

    /// Adds the viscosity's pressure to that of each particle.
    fn add_pressures<'s>(
        &self,
        nodes: &mut [ExchangeNode<S, D>],
        rates: &Rates<S, D>,
        densities: impl Iterator<Item = &'s DensityNode<S, D>>,
    ) {
        for ((node, rate), settled) in nodes.iter_mut().zip(rates).zip(densities) {
            let weight = S::ONE / (settled.density * settled.omega);
            let q = self.viscosity.pressure(&Local {
                density: node.density,
                sound_speed: node.sound_speed,
                epsilon: node.epsilon,
                divergence: -(rate.sums.compression * weight),
            });
            node.force_pressure += q * weight / settled.density;
        }
    }

    /// Kicks velocities, and internal energies where they go by leap-frog.
    fn close_motion<'s>(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        rates: &Rates<S, D>,
        densities: impl Iterator<Item = &'s DensityNode<S, D>>,
        dt: S,
    ) {
        let has_gradients = self.physics.need_gradients();
        for ((rate, settled), &id) in rates.iter().zip(densities).zip(cells.order()) {
            let (node, sums) = (&rate.node, &rate.sums);
            let Some(mut row) = gas.row(id) else { continue };
            let divergence = -(sums.compression / (settled.density * settled.omega));
            match self.domain.beyond(row.position) {
                None => self.close_row(&mut row, node, sums, dt),
                Some(Beyond::Inflow) => row.hold(),
                Some(Beyond::Outflow(normal)) => {
                    let wave = Wave {
                        sound_speed: node.sound_speed,
                        divergence,
                        power: node.measure * (node.force_pressure * sums.compression),
                    };
                    row.leave(dt, normal, wave, self.physics.energy);
                }
            }
            if !has_gradients {
                *row.divergence = divergence;
                *row.viscosity_factor = S::ONE;
            }
            *row.approach = sums.approach;
            *row.signal = self.signal(&row, node.sound_speed, sums.approach);
        }
    }

    /// Kicks a particle inside the domain.
    #[inline(always)]
    fn close_row(
        &self,
        row: &mut Row<'_, S, D>,
        node: &ExchangeNode<S, D>,
        sums: &ExchangeSums<S, D>,
        dt: S,
    ) {
        if self.physics.energy == EnergyForm::Total {
            // What is kinetic now is not after the kick; the sum is what goes on.
            *row.energy += row.kinetic_energy();
        }
        row.kick(dt, self.with_external(node.mass, sums.force));
        if self.physics.energy == EnergyForm::LeapFrog {
            let power = node.measure * (node.force_pressure * sums.compression) + sums.power;
            row.heat(dt, power);
        }
    }

    /// Internal energy by the work of both halves of the step, with the velocities that make
    /// it equal to what kinetic energy loses: `u + dt/4 a` after its start, `u - dt/4 a`
    /// before its end.
    fn close_work(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        rates: &Rates<S, D>,
        dt: S,
    ) {
        let (half, quarter) = (dt.half(), dt.half().half());
        for (rate, &id) in rates.iter().zip(cells.order()) {
            let Some(row) = gas.row(id) else { continue };
            if self.domain.beyond(row.position).is_some() {
                continue;
            }
            let (power, slope) = (rate.sums.power, rate.sums.power_slope);
            *row.energy += half * ((*row.power + quarter * *row.power_slope) / row.mass);
            *row.energy += half * ((power - quarter * slope) / row.mass);
            (*row.power, *row.power_slope) = (power, slope);
        }
    }

    /// Total energy by leap-frog; what is not kinetic of it is internal.
    fn close_flow(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        rates: &Rates<S, D>,
        dt: S,
    ) {
        for (rate, &id) in rates.iter().zip(cells.order()) {
            let Some(mut row) = gas.row(id) else { continue };
            if self.domain.beyond(row.position).is_some() {
                continue;
            }
            let external = S::dot(&rate.node.velocity, &self.physics.plain.acceleration);
            row.heat(dt, rate.sums.power + row.mass * external);
            *row.energy -= row.kinetic_energy();
        }
    }
}
