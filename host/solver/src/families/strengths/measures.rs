//! Norms and sums of a cloud of strengths, in the scenario's units.

use super::simulation::Strengths;
use crate::engine::HostScalar;
use crate::sums::compensated;

impl<S: HostScalar> Strengths<S> {
    /// `(Σ w u·Pu)^(1/2)`, weights in the scenario's units.
    pub(super) fn norm(&self) -> f64 {
        self.norm_of(|_, u, of| of.copy_from_slice(u))
    }

    /// The same of the source, per time of the scenario's units.
    pub(super) fn source_norm(&self) -> f64 {
        let time = self.clock.time;
        self.norm_of(|x, _, of| self.solver.source(x, time, of)) / self.plan.unit_of_time()
    }

    /// The norm of what `of` makes of a place and its state.
    fn norm_of(&self, of: impl Fn(&[S], &[S], &mut [S])) -> f64 {
        let cloud = self.solver.cloud();
        // Values of size 1 have squares in every format.
        let size = self.plan.amplitude;
        let mut scaled = vec![S::ZERO; cloud.components];
        let rows = cloud.positions().zip(cloud.weight).zip(cloud.values());
        let terms = rows.map(|((x, w), u)| {
            of(x, u, &mut scaled);
            for u in &mut scaled {
                *u = S::from_f64(u.to_f64() / size);
            }
            let density = self.solver.energy_density(x, self.clock.time, &scaled);
            w.to_f64() * density.to_f64()
        });
        let squared = compensated(terms) * self.plan.unit_of_volume();
        // Rounding may leave less than nothing of nothing; what is no number stays none.
        if squared < 0.0 {
            0.0
        } else {
            size * squared.sqrt()
        }
    }

    /// `Σ_k q_k` of a component, in the scenario's units.
    pub(super) fn total(&self, component: usize) -> f64 {
        let volume = self.plan.unit_of_volume();
        let cloud = self.solver.cloud();
        let strengths = cloud.strengths(component);
        // A sum of rounded numbers would move where the exact one does not.
        if S::HAS_EXACT_SUMS {
            let nothing = S::product(S::ZERO, S::ZERO);
            return volume * S::wide_to_f64(strengths.fold(nothing, S::wide_sum));
        }
        volume * compensated(strengths.map(S::wide_to_f64))
    }

    /// `Σ_k |q_k|` likewise.
    fn size(&self, component: usize) -> f64 {
        let cloud = self.solver.cloud();
        let strengths = cloud.strengths(component);
        let sizes = strengths.map(|q| S::rounded(q).to_f64().abs());
        self.plan.unit_of_volume() * compensated(sizes)
    }

    /// What the drift of each component is compared with: `‖u‖ (V/P_ii)^(1/2)`, which `Σ_k |q_k|`
    /// would be with all the energy spread evenly in that component; of one that is 0 its own size
    /// would be rounding. The energy weighs components of unlike units against each other.
    pub(super) fn scales(&self) -> Vec<f64> {
        let cloud = self.solver.cloud();
        let volume =
            self.plan.unit_of_volume() * compensated(cloud.weight.iter().map(|w| w.to_f64()));
        let norm = self.norm();
        let scale = |component: usize| {
            let weight = self.energy_of(&[component]);
            let scale = norm * (volume / weight).sqrt();
            // A format may have no digits for the weight.
            if scale.is_finite() {
                scale
            } else {
                self.size(component)
            }
        };
        (0..self.plan.names.len()).map(scale).collect()
    }

    /// `u·Pu` at the first particle of a state with 1 in these components and 0 in the others; 0 without
    /// particles.
    pub(super) fn energy_of(&self, components: &[usize]) -> f64 {
        let cloud = self.solver.cloud();
        let mut u = vec![S::ZERO; cloud.components];
        for &component in components {
            u[component] = S::ONE;
        }
        let first = cloud.positions().next();
        first.map_or(0.0, |x| {
            let energy = self.solver.energy_density(x, self.clock.time, &u);
            energy.to_f64()
        })
    }
}
