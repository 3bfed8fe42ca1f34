//! Boxes and balls of two and three dimensions.

use super::arrange::Arranger;
use super::block::Block;
use super::{Placed, SetupError};
use crate::scenario::{Ball, Extent, Region, Scenario, Share};

/// How many times as many points as a ball keeps the lattice around it may have: a quarter of a ball
/// may lie in the domain, and its box is 1.3 to 1.9 times as large.
const MOST_AROUND: f64 = 8.0;

/// The particles of the regions of a scenario.
///
/// A ball takes over the particles of the lattice under it, in its own state; where that
/// would give it another mass a particle, or where nothing lies under it, it gets a lattice
/// of its own, and those under it go. The particles of the box around keep their mass.
pub(super) fn place(scenario: &Scenario) -> Result<Vec<Placed>, SetupError> {
    let of_one = Shares::new(scenario);
    let mut arranger = Arranger::new(scenario);
    let mut particles = Vec::new();
    for (number, region) in scenario.regions.iter().enumerate() {
        if region.ball.is_some() {
            continue;
        }
        let block = Block::new(&region.extent, &scenario.domain);
        let volume = of_one.volume(region);
        refuse_empty(number, block.volume() / volume)?;
        let points = arranger.points(&block, volume, block.volume() / volume)?;
        particles.extend(filled(scenario, region, block.volume(), &points));
    }
    for (number, region) in scenario.regions.iter().enumerate() {
        let Some(ball) = &region.ball else {
            continue;
        };
        if takes_over(scenario, region, ball, &particles) {
            for particle in within(ball, scenario.dimension, &mut particles) {
                let mass = particle.mass * (region.density / particle.density);
                *particle = placed(scenario, region, particle.position, mass);
            }
            continue;
        }
        let inside = |point: &[f64; 3]| holds(ball, &point[..scenario.dimension]);
        particles.retain(|particle| !inside(&particle.position));
        let volume = clipped(ball, &scenario.domain.extent);
        let share = volume / of_one.volume(region);
        refuse_empty(number, share)?;
        let block = Block::new(&ball.extent(), &scenario.domain);
        let asked = MOST_AROUND * share;
        let mut points = arranger.points(&block, of_one.volume(region), asked)?;
        points.retain(|point| inside(point) && in_domain(scenario, point));
        refuse_empty(number, points.len() as f64)?;
        particles.extend(filled(scenario, region, volume, &points));
    }
    Ok(particles)
}

/// Points in the state of a region, which they share out evenly.
pub(super) fn filled(
    scenario: &Scenario,
    region: &Region,
    volume: f64,
    points: &[[f64; 3]],
) -> Vec<Placed> {
    let mass = region.density * volume / points.len() as f64;
    let place = |&point| placed(scenario, region, point, mass);
    points.iter().map(place).collect()
}

fn placed(scenario: &Scenario, region: &Region, position: [f64; 3], mass: f64) -> Placed {
    let mut velocity = [0.0; 3];
    velocity[..scenario.dimension].copy_from_slice(&region.velocity);
    let law = &scenario.materials[region.material].law;
    Placed {
        position,
        velocity,
        mass,
        density: region.density,
        pressure: region.pressure,
        energy: law.energy(region.density, region.pressure),
        // Reading sees to it that there are at most 256.
        material: region.material as u8,
    }
}

/// What a particle gets.
struct Shares {
    share: Share,
    /// Mass or volume of one.
    one: f64,
}

impl Shares {
    fn new(scenario: &Scenario) -> Self {
        let share = scenario.resolution.share;
        let amount = |region: &Region, volume: f64| match share {
            Share::Mass => region.density * volume,
            Share::Volume => volume,
        };
        let balls = || {
            scenario
                .regions
                .iter()
                .filter_map(|region| region.ball.as_ref())
        };
        let total: f64 = scenario
            .regions
            .iter()
            .map(|region| match &region.ball {
                Some(ball) => amount(region, clipped(ball, &scenario.domain.extent)),
                None => {
                    let full = Block::new(&region.extent, &scenario.domain).volume();
                    // Balls on one another count twice: the total is approximate anyway.
                    let covered: f64 = balls().map(|ball| clipped(ball, &region.extent)).sum();
                    amount(region, (full - covered).max(0.0))
                }
            })
            .sum();
        Self {
            share,
            one: total / scenario.resolution.particles as f64,
        }
    }

    /// The volume that one particle has in a region.
    fn volume(&self, region: &Region) -> f64 {
        match self.share {
            Share::Mass => self.one / region.density,
            Share::Volume => self.one,
        }
    }
}

/// Whether the particles under a ball can become its own: they fill it, and each would have
/// the mass that its share asks for.
fn takes_over(scenario: &Scenario, region: &Region, ball: &Ball, particles: &[Placed]) -> bool {
    let whole = clipped(ball, &scenario.domain.extent);
    let covered: f64 = scenario
        .regions
        .iter()
        .filter(|other| other.ball.is_none())
        .map(|other| clipped(ball, &other.extent))
        .sum();
    let mut under = particles
        .iter()
        .filter(|particle| holds(ball, &particle.position[..scenario.dimension]))
        .peekable();
    // 1e-3: what the quadrature of the volumes may be off.
    under.peek().is_some()
        && covered > (1.0 - 1e-3) * whole
        && (scenario.resolution.share == Share::Volume
            || under.all(|particle| particle.density == region.density))
}

fn within<'a>(
    ball: &'a Ball,
    dimension: usize,
    particles: &'a mut [Placed],
) -> impl Iterator<Item = &'a mut Placed> {
    let inside = move |particle: &&mut Placed| holds(ball, &particle.position[..dimension]);
    particles.iter_mut().filter(inside)
}

fn holds(ball: &Ball, point: &[f64]) -> bool {
    ball.distance_squared(point) < ball.radius * ball.radius
}

fn in_domain(scenario: &Scenario, point: &[f64; 3]) -> bool {
    let Extent { lower, upper } = &scenario.domain.extent;
    let bounds = lower.iter().zip(upper);
    point
        .iter()
        .zip(bounds)
        .all(|(x, (lower, upper))| (lower..=upper).contains(&x))
}

/// A region whose share is below half a particle gets none.
fn refuse_empty(region: usize, share: f64) -> Result<(), SetupError> {
    if share < 0.5 {
        return Err(SetupError::EmptyRegion { region, share });
    }
    Ok(())
}

/// The volume of the part of a ball that lies in a box; in two and three dimensions by
/// quadrature, good to 1e-4 of the ball.
pub(super) fn clipped(ball: &Ball, extent: &Extent) -> f64 {
    let squared = ball.radius * ball.radius;
    slices(&ball.center, squared, &extent.lower, &extent.upper)
}

fn slices(center: &[f64], squared: f64, lower: &[f64], upper: &[f64]) -> f64 {
    let ([c, center @ ..], [l, lower @ ..], [u, upper @ ..]) = (center, lower, upper) else {
        return 1.0;
    };
    let radius = squared.max(0.0).sqrt();
    let (low, high) = (l.max(c - radius), u.min(c + radius));
    if !(low < high) {
        return 0.0;
    }
    if center.is_empty() {
        return high - low;
    }
    const SLICES: u32 = 256;
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let slice = |i: u32| {
        // Crowded at the ends, where the height falls to 0 like a root.
        let s = (f64::from(i) + 0.5) / f64::from(SLICES) * 2.0 - 1.0;
        let x = middle + half * (1.5 * s - 0.5 * s * s * s);
        let width = half * 1.5 * (1.0 - s * s) * 2.0 / f64::from(SLICES);
        width * slices(center, squared - (x - c) * (x - c), lower, upper)
    };
    (0..SLICES).map(slice).sum()
}
