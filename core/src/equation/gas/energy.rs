//! Two more ways to sum the energy of a gas: [`EnergyForm::Exact`] and [`EnergyForm::Total`].
//!
//! Both have the forces of [`Motion`], with the velocities of now.
//!
//! [`EnergyForm::Exact`]: super::EnergyForm::Exact
//! [`EnergyForm::Total`]: super::EnergyForm::Total

use crate::cutoff::{CutOff, Needs};
use crate::domain::Wall;
use crate::error::Error;
use crate::neighbours::Image;
use crate::pairs::{Ground, Law, Separation, by_pairs};
use crate::scalar::{Number, Scalar};

use super::motion::{Motion, NEEDS, reflected};
use super::node::GasSums;
use super::options::Options;
use super::terms::{NodeOf, NodeOver, Terms};
use super::viscosity::Viscosity;
use super::walls::{Reversal, apart_as};

/// The work that the forces of [`Motion`] do, of the velocities of now and of their rates.
#[derive(Clone, Copy, Debug)]
pub struct PairWork<C, V, T>(pub Motion<C, V, T>);

/// The flow of total energy, (3.11), with the forces of [`Motion`].
#[derive(Clone, Copy, Debug)]
pub struct EnergyFlow<C, V, T>(pub Motion<C, V, T>);

macro_rules! law_of_energy {
    ($name:ident, |$of:ident, $seen:ident, $k:ident, $l:ident, $r:ident, $to_k:ident, $to_l:ident| $pair:block) => {
        impl<S, C, V, const D: usize> Law<S, D> for $name<C, V, Options<S, D>>
        where
            S: Scalar,
            C: CutOff,
            V: Viscosity<S>,
        {
            type Node = NodeOf<S, Options<S, D>, D>;
            type Sums = GasSums<S, D>;
            type CutOff = C;
            const NEEDS: Needs = NEEDS;

            fn cut_off(&self) -> C {
                self.0.cut_off
            }
            #[inline(always)]
            fn scale<N: Number<Scalar = S>>(&self, node: &NodeOver<N, S, Options<S, D>, D>) -> N {
                node.scale
            }

            #[inline(always)]
            fn pair<N: Number<Scalar = S>>(
                &self,
                k: &NodeOver<N, S, Options<S, D>, D>,
                l: &NodeOver<N, S, Options<S, D>, D>,
                apart: &Separation<N, D>,
                to_k: &mut GasSums<N, D>,
                to_l: &mut GasSums<N, D>,
            ) {
                self.add([k, l], apart, None, to_k, to_l);
            }

            #[inline(always)]
            fn pair_behind<N: Number<Scalar = S>>(
                &self,
                pair: [&NodeOver<N, S, Options<S, D>, D>; 2],
                image: &Image<D>,
                apart: &Separation<N, D>,
                to_k: &mut GasSums<N, D>,
                to_l: &mut GasSums<N, D>,
            ) {
                let seen = self.0.terms.seen(image);
                self.add(pair, apart, seen.as_ref(), to_k, to_l);
            }

            fn proof(
                &self,
                ground: &Ground<'_, '_, S, D>,
                nodes: &[Self::Node],
            ) -> Result<(), Error> {
                if self.0.terms.is_bounded() && self.0.prove(ground, nodes, 1.0).is_ok() {
                    return Ok(());
                }
                by_pairs(self, ground, nodes, |node, wall| self.reflected(node, wall))
            }

            fn reflected(&self, node: &Self::Node, wall: &Wall<S>) -> Self::Node {
                reflected::<S, Options<S, D>, D>(node, wall)
            }
        }

        impl<S: Scalar, C, V: Viscosity<S>, const D: usize> $name<C, V, Options<S, D>> {
            /// Adds the term of a pair; `seen`: how the viscous stress sees `l`.
            #[inline(always)]
            fn add<N: Number<Scalar = S>>(
                &self,
                [$k, $l]: [&NodeOver<N, S, Options<S, D>, D>; 2],
                apart: &Separation<N, D>,
                $seen: Option<&Reversal<N, D>>,
                $to_k: &mut GasSums<N, D>,
                $to_l: &mut GasSums<N, D>,
            ) {
                let $of = self.0.exchanged($k, $l, apart, $seen);
                let $r = &apart.r;
                $pair
            }
        }
    };
}

law_of_energy!(PairWork, |of, seen, k, l, r, to_k, to_l| {
    let half = N::literal(0.5);
    let mut v = [N::zero(); D];
    let mut w = [N::zero(); D];
    for i in 0..D {
        v[i] = k.terms.velocity_now[i] - l.terms.velocity_now[i];
        w[i] = k.terms.acceleration[i] - l.terms.acceleration[i];
    }
    let (now, gain) = (N::dot(&v, r), N::dot(&w, r));
    match &of.directions {
        None => {
            let share_k = of.pressure_k + half * of.viscous;
            let share_l = of.pressure_l + half * of.viscous;
            to_k.power += share_k * now + of.heat;
            to_l.power += share_l * now - of.heat;
            to_k.power_slope += share_k * gain;
            to_l.power_slope += share_l * gain;
        }
        Some([r_k, r_l]) => {
            let share = half * of.viscous;
            let (braked, slowed) = (share * now, share * gain);
            to_k.power += of.pressure_k * N::dot(&v, r_k) + braked + of.heat;
            to_l.power += of.pressure_l * N::dot(&v, r_l) + braked - of.heat;
            to_k.power_slope += of.pressure_k * N::dot(&w, r_k) + slowed;
            to_l.power_slope += of.pressure_l * N::dot(&w, r_l) + slowed;
        }
    }
    if let Some([of_k, of_l]) = &of.drag {
        if let Some(seen) = seen {
            v = apart_as(Some(seen), &k.terms.velocity_now, &l.terms.velocity_now);
            let turned = seen.rate(&l.terms.acceleration);
            w = apart_as(None, &k.terms.acceleration, &turned);
        }
        to_k.power += N::dot(of_k, &v);
        to_l.power += N::dot(of_l, &v);
        to_k.power_slope += N::dot(of_k, &w);
        to_l.power_slope += N::dot(of_l, &w);
    }
});

law_of_energy!(EnergyFlow, |of, seen, k, l, r, to_k, to_l| {
    let along =
        |of: &NodeOver<N, S, Options<S, D>, D>, r: &[N; D]| N::dot(&of.terms.velocity_now, r);
    let (along_k, along_l) = (along(k, r), along(l, r));
    let pressed = match &of.directions {
        None => of.pressure_k * along_l + of.pressure_l * along_k,
        Some([r_k, r_l]) => of.pressure_k * along(l, r_k) + of.pressure_l * along(k, r_l),
    };
    let flow = pressed + N::literal(0.5) * (of.viscous * (along_k + along_l));
    to_k.power += of.heat - flow;
    to_l.power += flow - of.heat;
    if let Some([of_k, of_l]) = &of.drag {
        let beyond = match seen {
            None => l.terms.velocity_now,
            Some(seen) => seen.velocity(&l.terms.velocity_now),
        };
        let flow = N::dot(of_k, &beyond) + N::dot(of_l, &k.terms.velocity_now);
        to_k.power -= flow;
        to_l.power += flow;
    }
});
