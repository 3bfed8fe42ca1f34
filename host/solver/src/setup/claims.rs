//! Whether the volumes that particles claim are the room that they have.
//!
//! The volumes `v_k = m_k/ρ_k` of a gas, or the weights of a quadrature, fill space once: with a cut-off
//! as wide as the claim, `h_k = 1.2 v_k^(1/D)`,
//!
//! `s_k = Σ_(l≠k) v_l W(x_k - x_l, h_k) / (1 - v_k W(0, h_k))`
//!
//! is 1 in a cloud at peace with itself, whatever its masses are, about one half at a free edge, and
//! 3/8 in the corner of a cube. Claims on a lattice that are all twice what they should be make 3.2,
//! 2.5 and 2.2 of it in one to three dimensions, claims that are half of it 0.03, 0.27 and 0.39; where
//! they are much too small nobody is near: 0.

use super::coincidence::Room;
use super::tree::Tree;

/// Claims that contradict the places of the particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contradiction {
    /// The particle that shows it.
    pub particle: usize,
    /// Whether most particles do so: then it is the cloud, else these few.
    pub is_of_most: bool,
    /// How many were found.
    pub count: usize,
    /// What it claims.
    pub claimed: f64,
    /// The room that it has among its neighbours.
    pub room: f64,
}

impl Contradiction {
    /// How much of the cloud is like that, for the end of a sentence.
    pub fn extent(&self) -> String {
        match (self.is_of_most, self.count) {
            (true, _) => ", and so it is for most particles".to_owned(),
            (false, 1) => String::new(),
            (false, count) => format!(", and so it is for {count} particles"),
        }
    }
}

/// Between which a median of `s_k` is that of a cloud, by the dimension: corners of small cubes are not
/// below, and clouds at random, where it is 1/(1 - v_k W(0, h_k)), not above.
const SOUND: [[f64; 2]; 3] = [[0.25, 2.7], [0.35, 2.2], [0.35, 2.0]];

/// The `s_k` below which a particle claims less than its neighbours leave it.
const ALONE: f64 = 0.05;

/// So many others within 0.35 of a spacing that is claimed, who fill it, leave no room for the claim.
const CROWD: usize = 8;

/// Particles below which a cloud has no middle.
const LEAST: usize = 8;

/// Particles that the median is taken of.
const SAMPLE: usize = 4096;

/// Most neighbours that are looked at.
const MOST: usize = 4096;

/// The first contradiction between places and volumes in a box whose sides `mirrored` are walls.
pub fn contradiction(
    positions: &[[f64; 3]],
    volumes: &[f64],
    room: &Room,
    mirrored: &[[bool; 2]; 3],
) -> Option<Contradiction> {
    let dimension = room.lengths.iter().filter(|&&length| length > 0.0).count();
    if positions.len() < LEAST || dimension == 0 {
        return None;
    }
    let cloud = Cloud {
        tree: Tree::new(positions),
        positions,
        volumes,
        room,
        mirrored,
        dimension,
    };
    let step = positions.len().div_ceil(SAMPLE);
    let mut shares: Vec<(f64, usize)> = (0..positions.len())
        .step_by(step)
        .map(|k| (cloud.share(k), k))
        .collect();
    shares.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (median, _) = shares[shares.len() / 2];
    let [least, most] = SOUND[cloud.dimension - 1];
    let is_sound = |share: f64| least <= share && share <= most;
    if !is_sound(median) {
        // The first of those that are off to the same side.
        let alike = |share: f64| !is_sound(share) && (share > 1.0) == (median > 1.0);
        let off = shares.iter().filter(|(share, _)| alike(*share));
        let particle = off.clone().map(|&(_, k)| k).min()?;
        return Some(cloud.found(particle, true, off.count() * step));
    }
    let off: Vec<usize> = (0..positions.len())
        .filter(|&k| cloud.is_alone(k) || cloud.is_crowded(k))
        .collect();
    let &particle = off.first()?;
    Some(cloud.found(particle, false, off.len()))
}

struct Cloud<'a> {
    tree: Tree,
    positions: &'a [[f64; 3]],
    volumes: &'a [f64],
    room: &'a Room,
    mirrored: &'a [[bool; 2]; 3],
    dimension: usize,
}

/// The width in claimed spacings.
const WIDTH: f64 = 1.2;

impl Cloud<'_> {
    fn found(&self, particle: usize, is_of_most: bool, count: usize) -> Contradiction {
        Contradiction {
            particle,
            is_of_most,
            count: count.min(self.positions.len()),
            claimed: self.volumes[particle],
            room: self.room_of(particle),
        }
    }

    /// The side of the cube of that volume.
    fn side(&self, volume: f64) -> f64 {
        match self.dimension {
            1 => volume,
            2 => volume.sqrt(),
            _ => libm::cbrt(volume),
        }
    }

    /// `ζ(q)` of the cubic spline M4, and its factor.
    fn cut_off(&self, q: f64) -> f64 {
        use std::f64::consts::PI;
        let factor = [2.0 / 3.0, 10.0 / (7.0 * PI), 1.0 / PI][self.dimension - 1];
        let outer = (2.0 - q).max(0.0);
        let inner = (1.0 - q).max(0.0);
        factor * (0.25 * outer * outer * outer - inner * inner * inner)
    }

    /// Visits the others within a radius, images in walls and periods too.
    fn others(&self, k: usize, radius: f64, visitor: &mut impl FnMut(usize, f64) -> bool) {
        let mut centers = vec![self.positions[k]];
        for i in 0..self.dimension {
            let (lower, upper) = (
                self.room.lower[i],
                self.room.lower[i] + self.room.lengths[i],
            );
            for place in 0..centers.len() {
                let x = centers[place][i];
                let mut image = |moved: f64| {
                    let mut center = centers[place];
                    center[i] = moved;
                    centers.push(center);
                };
                if self.room.periodic[i] {
                    if x - radius < lower {
                        image(x + self.room.lengths[i]);
                    }
                    if x + radius > upper {
                        image(x - self.room.lengths[i]);
                    }
                }
                if self.mirrored[i][0] && x - radius < lower {
                    image(lower - (x - lower));
                }
                if self.mirrored[i][1] && x + radius > upper {
                    image(upper + (upper - x));
                }
            }
        }
        for (place, center) in centers.iter().enumerate() {
            let mut other = |l: usize, squared: f64| (place == 0 && l == k) || visitor(l, squared);
            if !self.tree.around(center, radius, &mut other) {
                return;
            }
        }
    }

    /// `s_k`; infinite where too many lie within the claim to be counted.
    fn share(&self, k: usize) -> f64 {
        self.share_up_to(k, f64::INFINITY)
    }

    /// The same, or a part of it that is larger than `enough`.
    fn share_up_to(&self, k: usize, enough: f64) -> f64 {
        let volume = self.volumes[k];
        let width = WIDTH * self.side(volume);
        let cell = self.side_power(width);
        let rest = 1.0 - volume * self.cut_off(0.0) / cell;
        let (mut sum, mut seen) = (0.0, 0);
        self.others(k, 2.0 * width, &mut |l, squared| {
            sum += self.volumes[l] * self.cut_off(squared.sqrt() / width) / cell;
            seen += 1;
            seen < MOST && sum <= enough * rest
        });
        match seen < MOST {
            true => sum / rest,
            false => f64::INFINITY,
        }
    }

    fn side_power(&self, length: f64) -> f64 {
        (0..self.dimension).map(|_| length).product()
    }

    fn is_alone(&self, k: usize) -> bool {
        self.share_up_to(k, ALONE) < ALONE
    }

    fn is_crowded(&self, k: usize) -> bool {
        let radius = 0.35 * self.side(self.volumes[k]);
        let (mut filled, mut seen) = (0.0, 0);
        self.others(k, radius, &mut |l, _| {
            filled += self.volumes[l];
            seen += 1;
            seen < MOST
        });
        let ball = [2.0, std::f64::consts::PI, 4.0 / 3.0 * std::f64::consts::PI];
        let ball = ball[self.dimension - 1] * self.side_power(radius);
        // Where the others are at odds too, it is not this one that shows it.
        seen >= CROWD && (seen == MOST || filled < 4.0 * ball)
    }

    /// The room of a particle: `1/Σ_l W(x_k - x_l, h)` with `h^D` 1.2^D times itself.
    fn room_of(&self, k: usize) -> f64 {
        let excess = |width: f64| {
            let mut sum = self.cut_off(0.0);
            self.others(k, 2.0 * width, &mut |_, squared| {
                sum += self.cut_off(squared.sqrt() / width);
                true
            });
            sum - self.side_power(WIDTH)
        };
        let longest = self.room.lengths.iter().copied().fold(0.0, f64::max);
        let (mut low, mut high) = (1e-12 * longest, longest);
        for _ in 0..60 {
            let middle = (low * high).sqrt();
            match excess(middle) < 0.0 {
                true => low = middle,
                false => high = middle,
            }
        }
        self.side_power(low) / self.side_power(WIDTH)
    }
}
