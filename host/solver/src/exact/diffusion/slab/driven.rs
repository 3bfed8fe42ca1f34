//! What an end that something drives adds to a slab.

use super::End;
use super::drive::Course;
use super::eigenmodes::Eigenmode;
use super::layers::{Layers, Profile};

/// An end that something drives.
#[derive(Debug)]
pub(super) struct Driven {
    /// g.
    pub(super) course: Course,
    /// W.
    pub(super) steady: Profile,
    /// z.
    pub(super) late: Profile,
    /// `psi_n/lambda_n`.
    pub(super) weights: Vec<f64>,
}

impl Driven {
    /// Of end 0, below, or 1; none if nothing drives it.
    pub(super) fn new(
        layers: &Layers,
        modes: &[Eigenmode],
        ends: &[End; 2],
        side: usize,
        initial: f64,
    ) -> Option<Self> {
        let end = &ends[side];
        let less = if end.is_a_flux() { 0.0 } else { initial };
        let course = Course::new(end.drive()?.clone(), less);
        let open = ends.iter().all(End::is_a_flux);
        let source = if open { -1.0 / layers.length() } else { 0.0 };
        let source = Profile::uniform(source, layers.layers.len());
        let (unit, outwards) = if side == 0 {
            ([1.0, 0.0], -1.0)
        } else {
            ([0.0, 1.0], 1.0)
        };
        let steady = layers.steady(ends, &source, unit);
        let weight = |mode: &Eigenmode| end.weight(mode.ends[side], outwards) / mode.rate();
        Some(Self {
            late: layers.steady(ends, &steady, [0.0; 2]),
            weights: modes.iter().map(weight).collect(),
            steady,
            course,
        })
    }
}

impl End {
    /// psi for phi and F at this end, `outwards` -1 below and 1 above.
    fn weight(&self, [phi, flux]: [f64; 2], outwards: f64) -> f64 {
        match self {
            Self::NoFlux => 0.0,
            Self::Value(_) => outwards * flux,
            Self::Flux(_) => phi,
            Self::Exchange { rate, .. } => -rate * phi,
        }
    }
}
