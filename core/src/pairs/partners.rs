//! What lies between a particle and a partner that it visits.

use super::law::{Law, Separation};
use super::visit::Partner;
use crate::cutoff::CutOff;
use crate::scalar::Scalar;

impl<S: Scalar, const D: usize> Partner<S, D> {
    /// What lies between, for a law whose scale is the same for all particles.
    pub fn apart<W: Law<S, D>>(&self, law: &W, scale: S) -> Separation<S, D> {
        let (cut_off, scales) = (law.cut_off(), [scale; 2]);
        Separation {
            r: self.r,
            distance_squared: self.distance_squared,
            zeta: cut_off.shapes_of_pair::<D, _>(W::NEEDS, self.distance_squared, scales),
        }
    }
}
