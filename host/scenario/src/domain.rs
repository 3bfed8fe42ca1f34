//! Where it happens: boxes, balls, and the domain with its sides.

/// An axis-aligned box: `lower < upper` in every direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Extent {
    /// The corner with the smallest coordinates.
    pub lower: Vec<f64>,
    /// The corner with the largest coordinates.
    pub upper: Vec<f64>,
}

impl Extent {
    /// The product of its lengths.
    pub fn volume(&self) -> f64 {
        let lengths = self.lower.iter().zip(&self.upper);
        lengths.map(|(lower, upper)| upper - lower).product()
    }

    /// The coordinate of its middle along a direction; 0 beyond its dimension.
    pub fn middle(&self, axis: usize) -> f64 {
        let bounds = self.lower.get(axis).zip(self.upper.get(axis));
        bounds.map_or(0.0, |(lower, upper)| 0.5 * (lower + upper))
    }

    /// Whether a point is in it, its sides included.
    pub fn contains(&self, point: &[f64]) -> bool {
        let bounds = self.lower.iter().zip(&self.upper).zip(point);
        bounds
            .into_iter()
            .all(|((lower, upper), x)| (lower..=upper).contains(&x))
    }
}

/// The box that is simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    /// Its place.
    pub extent: Extent,
    /// A direction: the side at `lower`, the side at `upper`; both or none periodic. One
    /// direction at most has inflow and outflow sides, and one side at most is an inflow.
    pub sides: Vec<[Side; 2]>,
}

impl Domain {
    /// Between which coordinates a particle may be along a direction: infinite where the side
    /// is free.
    pub fn bounds(&self, axis: usize) -> [f64; 2] {
        let sides = self.sides[axis];
        let bound = |end: usize, side: f64, beyond: f64| match sides[end] {
            Side::Free => beyond,
            _ => side,
        };
        [
            bound(0, self.extent.lower[axis], f64::NEG_INFINITY),
            bound(1, self.extent.upper[axis], f64::INFINITY),
        ]
    }
}

/// What happens at a side of the domain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// What leaves comes in at the other side.
    Periodic,
    /// A wall: the gas is mirrored.
    Mirror,
    /// Nothing: particles may leave.
    Free,
    /// Gas comes in.
    Inflow,
    /// Gas goes out.
    Outflow,
}

impl Side {
    /// Whether gas is taken in or out there.
    pub fn is_open(self) -> bool {
        matches!(self, Self::Inflow | Self::Outflow)
    }
}

/// A ball: an interval in one dimension, a disc in two.
#[derive(Debug, Clone, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub center: Vec<f64>,
    /// > 0.
    pub radius: f64,
}

impl Ball {
    /// The box around it.
    pub fn extent(&self) -> Extent {
        Extent {
            lower: self.center.iter().map(|x| x - self.radius).collect(),
            upper: self.center.iter().map(|x| x + self.radius).collect(),
        }
    }

    /// Squared distance of a point from the centre.
    pub fn distance_squared(&self, point: &[f64]) -> f64 {
        let components = self.center.iter().zip(point);
        components.map(|(c, x)| (x - c) * (x - c)).sum()
    }
}
