//! The rates of the paper's equations, by the law of [`super::motion`].

use crate::cutoff::CutOff;
use crate::domain::Beyond;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::Grid;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::density::DensityNode;
use super::dynamics::{GasDynamics, Lowest};
use super::motion::{GasNode, Motion};
use super::options::EnergyForm;
use super::physics::Physics;
use super::state::{Gas, Row, Wave};
use super::storage::Workspace;
use super::viscosity::{Local, Viscosity};

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Forces and powers of settled densities; closes the step.
    pub(super) fn motion_rates(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        grid: Grid<S, D>,
        dt: S,
    ) -> Result<(), Error> {
        let n = gas.len();
        let cells = work.cells.cells(grid, n);
        let motion = Motion {
            cut_off: self.cut_off,
            viscosity: self.viscosity,
        };
        let densities = work.densities.get(..n).unwrap_or(&[]);
        let (Some(nodes), Some(rates)) = (work.gas_nodes.get_mut(..n), work.rates.get_mut(..n))
        else {
            return Err(Error::Lengths);
        };
        let sigma = S::from_f64(self.cut_off.normalisation::<D>());
        for ((node, settled), &id) in nodes.iter_mut().zip(densities).zip(cells.order()) {
            if let Some(row) = gas.row(id) {
                *node = self.gas_node(&settled.node, &row, sigma, dt);
            }
        }
        if self.viscosity.needs_divergence() {
            // The sum of (3.12) holds div u; the pressures play no part in it.
            engine.sweep(&motion, &cells, nodes, rates)?;
            for ((node, rate), settled) in nodes.iter_mut().zip(rates.iter()).zip(densities) {
                let settled = &settled.node;
                let weight = S::ONE / (settled.density * settled.omega);
                let q = self.viscosity.pressure(&Local {
                    density: node.density,
                    sound_speed: node.sound_speed,
                    epsilon: node.epsilon,
                    divergence: -(rate.sums.compression * weight),
                });
                node.pressure += q * weight / settled.density;
            }
        }
        engine.sweep(&motion, &cells, nodes, rates)?;
        let mut problem = Lowest::default();
        for ((rate, settled), &id) in rates.iter().zip(densities).zip(cells.order()) {
            let (node, sums, settled) = (&rate.node, &rate.sums, &settled.node);
            let Some(mut row) = gas.row(id) else { continue };
            let power = node.measure * (node.pressure * sums.compression) + sums.heating;
            let divergence = -(sums.compression / (settled.density * settled.omega));
            match self.domain.beyond(row.position) {
                None => {
                    row.kick(dt, self.with_external(node.mass, sums.force));
                    row.heat(dt, power);
                }
                Some(Beyond::Inflow) => row.hold(),
                Some(Beyond::Outflow(normal)) => {
                    let wave = Wave {
                        sound_speed: node.sound_speed,
                        divergence,
                        power: node.measure * (node.pressure * sums.compression),
                    };
                    row.leave(dt, normal, wave, EnergyForm::LeapFrog);
                }
            }
            *row.divergence = divergence;
            *row.approach = sums.approach;
            *row.signal = self.signal(&row, node.sound_speed, sums.approach);
            problem.add(id, self.problem(&row, id));
        }
        problem.result()
    }

    /// What a particle shows in (3.10) and (3.12).
    fn gas_node(
        &self,
        settled: &DensityNode<S, D>,
        row: &Row<'_, S, D>,
        sigma: S,
        dt: S,
    ) -> GasNode<S, D> {
        let (velocity, energy) = row.predicted(dt, EnergyForm::LeapFrog);
        let (density, epsilon) = (*row.density, settled.epsilon);
        let (pressure, sound_speed) = self.pressure(row.material, density, energy);
        GasNode {
            mass: row.mass,
            measure: self.measure(row.mass),
            pressure: pressure / (settled.omega * settled.density) / settled.density,
            gradient: sigma / epsilon.powi(D + 2),
            scale: self.cut_off.scale(S::ONE / epsilon),
            sound_speed,
            density,
            epsilon,
            velocity,
        }
    }
}
