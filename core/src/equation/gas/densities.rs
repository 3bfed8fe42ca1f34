//! Densities and widths of a whole cloud, by the law of [`super::density`].

use crate::cutoff::CutOff;
use crate::error::Error;
use crate::material::EquationOfState;
use crate::neighbours::{Cells, Grid, sort};
use crate::numbered::numbered;
use crate::pairs::Engine;
use crate::scalar::Scalar;

use super::density::{Density, DensityNode, MAX_PASSES, Width};
use super::dynamics::{GasDynamics, Lowest};
use super::physics::Physics;
use super::state::Gas;
use super::storage::Workspace;
use super::viscosity::Viscosity;

/// Times the cloud may be sorted anew while the widths settle. Only a first state with a bad
/// guess of ε needs more than two.
const MAX_SORTS: u32 = 40;

impl<S, C, V, E, P, const D: usize> GasDynamics<'_, S, C, V, E, P, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
    P: Physics<S, D>,
{
    /// Sorts the cloud and settles ρ, ε and Ω of every particle; leaves them in
    /// `work.densities`, in sorted order. The densities in `gas` are still those that the step came
    /// from.
    pub(super) fn densities(
        &self,
        engine: &mut impl Engine<S, D>,
        gas: &mut Gas<'_, S, D>,
        work: &mut Workspace<'_, S, P::Shown, D>,
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
            let grid = sort(&self.domain, gas.position, &reach, &mut work.cells)?;
            let cells = work.cells.cells(grid, n);
            engine.sorted();
            for (node, &id) in nodes.iter_mut().zip(cells.order()) {
                if let Some(row) = gas.row(id) {
                    *node = law.node(self.measure(row.mass), *row.epsilon);
                }
            }
            engine.evaluate(&law, &cells, nodes, settled)?;
            if self.accept(
                gas,
                &cells,
                settled.iter().map(|s| (&s.node, s.sums.partners)),
            )? {
                return Ok(grid);
            }
        }
        let most = numbered(gas.epsilon.iter()).reduce(|a, b| if b.1 > a.1 { b } else { a });
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

    /// Takes ε and neighbour counts over into `gas`. `false` where a particle outgrew the
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
}
