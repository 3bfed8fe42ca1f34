//! What [`Options`] makes before and after the sums over pairs: gradients, factors of the
//! viscosity, and the energy in its other forms.

use crate::cutoff::CutOff;
use crate::error::{Error, Quantity};
use crate::material::EquationOfState;
use crate::pairs::{Engine, Fields, Settled, holds};
use crate::scalar::Scalar;

use super::dynamics::GasDynamics;
use super::energy::{EnergyFlow, PairWork};
use super::exchange::Extras;
use super::gradient::{Gradient, GradientNode, GradientSums, divergence};
use super::options::{EnergyForm, Options, Plain};
use super::physics::{Physics, Sorted, Thermal};
use super::storage::{GradientBuffers, RatesOf};
use super::switch::{Flow, balsara};
use super::terms::NodeOf;
use super::viscosity::Viscosity;
use super::walls::NoSlip;

impl<S: Scalar, const D: usize> Physics<S, D> for Options<S, D> {
    fn plain(&self) -> &Plain<S, D> {
        &self.plain
    }
    fn diffusivity(&self, shown: &Extras<S, D>) -> S {
        shown.diffusivity
    }
    fn energy(&self) -> EnergyForm {
        self.energy
    }
    fn no_slip(&self) -> NoSlip<S, D> {
        self.walls
    }
    fn need_gradients(&self) -> bool {
        Self::need_gradients(self)
    }
    fn follows_density(&self) -> bool {
        !self.linear_exact
    }

    fn shown(&self, state: &Thermal<S>) -> Extras<S, D> {
        Extras {
            pressure: state.pressure,
            specific_volume: S::ONE / (state.density * state.moment),
            energy: state.energy - self.background / state.density,
            material: S::count(u32::from(state.material)),
            linear: S::ONE,
            factor: S::ONE,
            diffusivity: self.diffusion.heat / state.moment.lesser(S::ONE),
            ..Extras::ZERO
        }
    }

    fn refine<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        cloud: &mut Sorted<'_, '_, S, D, impl Engine<S, D>>,
        nodes: &mut [NodeOf<S, Self, D>],
        buffers: &mut GradientBuffers<'_, S, D>,
    ) -> Result<(), Error> {
        if !solver.physics.need_gradients() {
            return Ok(());
        }
        let n = nodes.len();
        let (Some(shown), Some(gradients)) =
            (buffers.nodes.get_mut(..n), buffers.sums.get_mut(..n))
        else {
            return Err(Error::Lengths);
        };
        for (shown, node) in shown.iter_mut().zip(nodes.iter()) {
            *shown = GradientNode {
                measure: node.measure,
                scale: node.scale,
                energy: node.terms.energy,
                velocity: node.velocity,
            };
        }
        let options = &solver.physics;
        let is_viscous = options.diffusion.is_viscous();
        let sticks = is_viscous && options.walls.is_any();
        let mut law = Gradient {
            cut_off: solver.cut_off,
            walls: options.walls,
        };
        solver.proven(cloud.engine, || {
            // What is made of the velocities of walls: twice their mean, or their sum.
            let made = 2.0f64.max(D as f64) * options.walls.fastest();
            holds::<S>(Quantity::Velocity, 0, made)
        })?;
        // What pressure and pseudo-viscosity see is a mirror: their gradients are others.
        let are_two = sticks && options.switches();
        if are_two || !sticks {
            law.walls = NoSlip::NONE;
        }
        cloud
            .engine
            .evaluate(&law, &cloud.cells, shown, gradients)?;
        solver.switch(cloud, nodes, gradients);
        if are_two {
            law.walls = options.walls;
            cloud
                .engine
                .evaluate(&law, &cloud.cells, shown, gradients)?;
        }
        match is_viscous {
            true => solver.stresses(cloud, nodes, gradients),
            false => Ok(()),
        }
    }

    fn close_energy<C: CutOff, V: Viscosity<S>, E: EquationOfState<S>>(
        solver: &GasDynamics<'_, S, C, V, E, Self, D>,
        cloud: &mut Sorted<'_, '_, S, D, impl Engine<S, D>>,
        nodes: &mut [NodeOf<S, Self, D>],
        rates: &mut RatesOf<S, Self, D>,
    ) -> Result<(), Error> {
        if solver.physics.energy == EnergyForm::LeapFrog {
            return Ok(());
        }
        for (node, &id) in nodes.iter_mut().zip(cloud.cells.order()) {
            let Some(row) = cloud.gas.row(id) else {
                continue;
            };
            let shown = &mut node.terms;
            shown.velocity_now = *row.velocity;
            for (component, &force) in shown.acceleration.iter_mut().zip(row.force.iter()) {
                *component = force / row.mass;
            }
        }
        match solver.physics.energy {
            EnergyForm::LeapFrog => {}
            EnergyForm::Exact => {
                let law = PairWork(solver.motion());
                cloud.engine.evaluate(&law, &cloud.cells, nodes, rates)?;
                solver.close_work(cloud, rates);
            }
            EnergyForm::Total => {
                let law = EnergyFlow(solver.motion());
                cloud.engine.evaluate(&law, &cloud.cells, nodes, rates)?;
                solver.close_flow(cloud, rates);
            }
        }
        Ok(())
    }
}

impl<S, C, V, E, const D: usize> GasDynamics<'_, S, C, V, E, Options<S, D>, D>
where
    S: Scalar,
    C: CutOff,
    V: Viscosity<S>,
    E: EquationOfState<S>,
{
    /// Slopes and factors of the viscosity, from the velocity gradients.
    fn switch<N>(
        &self,
        cloud: &mut Sorted<'_, '_, S, D, N>,
        nodes: &mut [NodeOf<S, Options<S, D>, D>],
        gradients: &[Settled<GradientNode<S, D>, GradientSums<S, D>>],
    ) {
        let rows = nodes.iter_mut().zip(gradients).zip(cloud.cells.order());
        for ((node, gradient), &id) in rows {
            let Some(row) = cloud.gas.row(id) else {
                continue;
            };
            let slopes = gradient.sums.slopes();
            if self.physics.linear_exact {
                node.terms.direction = self.direction(node, &gradient.sums);
            }
            let shown = &mut node.terms;
            let gradient = slopes.velocity;
            if self.physics.conduction > S::ZERO {
                shown.energy_slope = slopes.energy;
            }
            if self.physics.limited {
                shown.slope = gradient;
            }
            if self.physics.balsara {
                shown.factor = balsara(&gradient, node.sound_speed, node.epsilon);
            }
            if let Some(switch) = &self.physics.switch {
                let flow = Flow {
                    gradient,
                    divergence_before: *row.divergence,
                    epsilon: node.epsilon,
                    support: S::count(self.cut_off.support()),
                    signal: node.sound_speed + *row.approach,
                    dt: cloud.dt,
                };
                shown.linear = switch.factor(*row.viscosity_factor, &flow);
            }
            // What the switch goes on from; Balsara's factor is that of a moment.
            *row.viscosity_factor = match &self.physics.switch {
                Some(_) => shown.linear,
                None => shown.factor,
            };
            *row.divergence = divergence(&gradient);
        }
    }

    /// Internal energy by the work of both halves of the step, with the velocities that make
    /// it equal to what kinetic energy loses: `u + dt/4 a` after its start, `u - dt/4 a`
    /// before its end.
    fn close_work<N>(
        &self,
        cloud: &mut Sorted<'_, '_, S, D, N>,
        rates: &RatesOf<S, Options<S, D>, D>,
    ) {
        let dt = cloud.dt;
        let (half, quarter) = (dt.half(), dt.half().half());
        for (rate, &id) in rates.iter().zip(cloud.cells.order()) {
            let Some(row) = cloud.gas.row(id) else {
                continue;
            };
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
    fn close_flow<N>(
        &self,
        cloud: &mut Sorted<'_, '_, S, D, N>,
        rates: &RatesOf<S, Options<S, D>, D>,
    ) {
        let dt = cloud.dt;
        for (rate, &id) in rates.iter().zip(cloud.cells.order()) {
            let Some(mut row) = cloud.gas.row(id) else {
                continue;
            };
            if self.domain.beyond(row.position).is_some() {
                continue;
            }
            let external = S::dot(row.velocity, &self.physics.plain.acceleration);
            row.flow(dt, rate.sums.power + row.mass * external);
            *row.energy -= row.kinetic_energy();
        }
    }
}
