//! A point that moves in the plane, seen from its nearest periodic image.

use super::flow::Number;

/// The centre of a pattern carried along by a uniform flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingCentre {
    /// At t = 0.
    pub position: [f64; 2],
    /// Of the uniform flow; 0 for a pattern at rest.
    pub velocity: [f64; 2],
    /// Size of the periodic box, > 0; none in infinite space.
    pub period: Option<[f64; 2]>,
}

impl MovingCentre {
    /// At rest in the origin of infinite space.
    pub const ORIGIN: Self = Self {
        position: [0.0; 2],
        velocity: [0.0; 2],
        period: None,
    };

    /// From the nearest image of the centre to a position.
    pub(super) fn towards(&self, position: [f64; 3], time: f64) -> [f64; 2] {
        std::array::from_fn(|i| {
            let distance = position[i] - self.position[i] - self.velocity[i] * time;
            match self.period {
                Some(period) => distance - period[i] * libm::round(distance / period[i]),
                None => distance,
            }
        })
    }

    pub(super) fn numbers(&self) -> [Number; 6] {
        let [x, y] = self.position;
        let [u, v] = self.velocity;
        let [a, b] = self.period.unwrap_or([1.0; 2]);
        [
            ("centre x", x, "a finite number", true),
            ("centre y", y, "a finite number", true),
            ("mean velocity x", u, "a finite number", true),
            ("mean velocity y", v, "a finite number", true),
            ("period x", a, "> 0", a > 0.0),
            ("period y", b, "> 0", b > 0.0),
        ]
    }
}
