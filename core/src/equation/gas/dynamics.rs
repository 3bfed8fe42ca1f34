//! The gas solver: densities, rates, stable time step.

use crate::cutoff::CutOff;
use crate::domain::Domain;
use crate::error::{Error, Quantity};
use crate::material::EquationOfState;
use crate::neighbours::{Cells, Grid, sort};
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::density::{Density, DensityNode, MAX_PASSES, Width};
use super::motion::{GasNode, Motion};
use super::state::{Gas, Row, Workspace};
use super::viscosity::{Local, Viscosity};

/// Times the cloud may be sorted anew while the widths settle. Only a first state with a bad
/// guess of ε needs more than two.
const MAX_SORTS: u32 = 40;

/// A gas and how it is solved. All quantities in solver units: mean spacing, reference
/// density and reference sound speed are of order 1.
#[derive(Clone, Copy, Debug)]
pub struct GasDynamics<S, C, V, E, const D: usize> {
    /// Where the gas is.
    pub domain: Domain<S, D>,
    /// ζ.
    pub cut_off: C,
    /// ε.
    pub width: Width<S>,
    /// Π and q.
    pub viscosity: V,
    /// p(ρ, e).
    pub equation_of_state: E,
    /// The factor of the stable time step, in (0, 1].
    pub courant: S,
    /// The smallest Ω that is accepted.
    pub smallest_omega: S,
}

impl<S, C, V, E, const D: usize> GasDynamics<S, C, V, E, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
{
    /// Makes the densities and rates of a state whose positions, velocities, energies and
    /// expected ε have been set. Must run once before the first step.
    pub fn prepare(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
    ) -> Result<(), Error> {
        if !gas.is_consistent() {
            return Err(Error::Lengths);
        }
        gas.force.fill([S::ZERO; D]);
        gas.power.fill(S::ZERO);
        gas.divergence.fill(S::ZERO);
        self.rates(engine, gas, work, S::ZERO)
    }

    /// The stable time step `C min_k ε_k/signal_k` of a state that has been prepared, or
    /// `longest` if that is shorter.
    pub fn time_step(&self, gas: &Gas<'_, S, D>, longest: S) -> Result<S, Error> {
        let mut smallest = longest;
        for (particle, (&epsilon, &signal)) in gas.epsilon.iter().zip(gas.signal.iter()).enumerate()
        {
            // A gas without sound and motion bounds nothing.
            if signal > S::ZERO {
                let step = self.courant * (epsilon / signal);
                if !(step > S::ZERO) {
                    let quantity = Quantity::TimeStep;
                    return Err(Error::NotFinite {
                        particle: particle as u32,
                        quantity,
                    });
                }
                smallest = smallest.lesser(step);
            }
        }
        Ok(smallest)
    }

    /// Densities and rates at the positions of `gas`, with velocities and energies predicted
    /// over `dt` by the rates that `gas` holds. Closes the step: half a kick with the old
    /// rates, half a kick with the new ones, which take their place.
    pub(crate) fn rates(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        dt: S,
    ) -> Result<(), Error> {
        let grid = self.densities(engine, gas, work, dt)?;
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
                *node = self.node(&settled.node, &row, sigma, dt);
            }
        }
        if self.viscosity.needs_divergence() {
            // The sum of (3.12) holds div u; the pressures play no part in it.
            engine.sweep(&motion, &cells, nodes, rates)?;
            for ((node, rate), settled) in nodes.iter_mut().zip(rates.iter()).zip(densities) {
                let weight = S::ONE / (node.density * settled.node.omega);
                let q = self.viscosity.pressure(&Local {
                    density: node.density,
                    sound_speed: node.sound_speed,
                    epsilon: node.epsilon,
                    divergence: -(rate.sums.compression * weight),
                });
                node.pressure += q * weight / node.density;
            }
        }
        engine.sweep(&motion, &cells, nodes, rates)?;
        let mut problem = Lowest::default();
        for ((rate, settled), &id) in rates.iter().zip(densities).zip(cells.order()) {
            let (node, sums) = (&rate.node, &rate.sums);
            let Some(mut row) = gas.row(id) else { continue };
            let power = node.mass * (node.pressure * sums.compression) + sums.heating;
            row.kick(dt, sums.force, power);
            *row.divergence = -(sums.compression / (node.density * settled.node.omega));
            *row.signal = self.viscosity.signal(node.sound_speed, sums.approach);
            problem.add(id, row.problem(id));
        }
        problem.result()
    }

    /// Sorts the cloud and settles ρ, ε and Ω of every particle; leaves them in
    /// `work.densities`, in sorted order, and in `gas`.
    fn densities(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, D>,
        dt: S,
    ) -> Result<Grid<S, D>, Error> {
        let law = Density::<S, C, D>::new(self.cut_off, self.width);
        let n = gas.len();
        let (Some(nodes), Some(settled)) =
            (work.density_nodes.get_mut(..n), work.densities.get_mut(..n))
        else {
            return Err(Error::Lengths);
        };
        self.expect_epsilon(gas, dt);
        for _ in 0..MAX_SORTS {
            let support = S::count(self.cut_off.support());
            let epsilons: &[S] = gas.epsilon;
            let reach = |id: usize| support * law.limit(*epsilons.get(id).unwrap_or(&S::ONE));
            let grid = sort(&self.domain, gas.position, reach, &mut work.cells)?;
            let cells = work.cells.cells(grid, n);
            engine.sorted();
            for (node, &id) in nodes.iter_mut().zip(cells.order()) {
                if let Some(row) = gas.row(id) {
                    *node = law.node(row.mass, *row.epsilon);
                }
            }
            engine.sweep(&law, &cells, nodes, settled)?;
            if self.accept(
                gas,
                &cells,
                settled.iter().map(|s| (&s.node, s.sums.partners)),
            )? {
                return Ok(grid);
            }
        }
        let most = gas
            .epsilon
            .iter()
            .enumerate()
            .reduce(|a, b| if b.1 > a.1 { b } else { a });
        Err(Error::Isolated {
            particle: most.map_or(0, |(particle, _)| particle as u32),
        })
    }

    /// Where the gas is going, ε goes too: `dε/dt = ε div u/D`. A guess that saves passes.
    fn expect_epsilon(&self, gas: &mut Gas<'_, S, D>, dt: S) {
        match self.width {
            Width::Constant { epsilon } => gas.epsilon.fill(epsilon),
            Width::Adaptive { .. } => {
                let share = dt / S::count(D as u32);
                let bound = S::from_f64(0.25);
                for (epsilon, &divergence) in gas.epsilon.iter_mut().zip(gas.divergence.iter()) {
                    let change = (share * divergence).lesser(bound).greater(-bound);
                    *epsilon += *epsilon * change;
                }
            }
        }
    }

    /// Takes ρ, ε and neighbour counts over into `gas`. `false` where a particle outgrew the
    /// neighbours at hand; its ε is then the next guess.
    fn accept<'s>(
        &self,
        gas: &mut Gas<'_, S, D>,
        cells: &Cells<'_, S, D>,
        settled: impl Iterator<Item = (&'s DensityNode<S, D>, S)>,
    ) -> Result<bool, Error> {
        let mut complete = true;
        let mut problem = Lowest::default();
        for ((node, partners), &id) in settled.zip(cells.order()) {
            let Some(row) = gas.row(id) else { continue };
            *row.epsilon = node.epsilon;
            *row.density = node.density;
            *row.neighbours = partners - S::ONE;
            if node.epsilon > node.limit {
                complete = false;
            } else if !(node.passes < S::count(MAX_PASSES)) && node.density == S::ZERO {
                problem.add(id, Some(Error::Epsilon { particle: id }));
            } else if !(node.omega > self.smallest_omega) {
                problem.add(id, Some(Error::Omega { particle: id }));
            } else if !(partners > S::ONE) {
                problem.add(id, Some(Error::Isolated { particle: id }));
            }
        }
        if complete {
            problem.result()?;
        }
        Ok(complete)
    }

    /// What a particle shows in (3.10) and (3.12).
    fn node(
        &self,
        settled: &DensityNode<S, D>,
        row: &Row<'_, S, D>,
        sigma: S,
        dt: S,
    ) -> GasNode<S, D> {
        let (velocity, energy) = row.predicted(dt);
        let (density, epsilon) = (settled.density, settled.epsilon);
        let pressure = self.equation_of_state.pressure(density, energy);
        let inverse = S::ONE / epsilon;
        GasNode {
            mass: row.mass,
            pressure: pressure / (settled.omega * density) / density,
            gradient: sigma / epsilon.powi(D + 2),
            scale: self.cut_off.scale(inverse),
            sound_speed: self.equation_of_state.sound_speed(density, energy),
            density,
            epsilon,
            velocity,
        }
    }
}

/// The error of the particle with the lowest id: the same one whatever the order of search.
#[derive(Default)]
struct Lowest(Option<(u32, Error)>);

impl Lowest {
    #[inline(always)]
    fn add(&mut self, id: u32, error: Option<Error>) {
        if let Some(error) = error
            && self.0.is_none_or(|(lowest, _)| id < lowest)
        {
            self.0 = Some((id, error));
        }
    }

    fn result(self) -> Result<(), Error> {
        self.0.map_or(Ok(()), |(_, error)| Err(error))
    }
}
