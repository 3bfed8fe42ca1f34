//! Energy added at t = 0.

use super::{Placed, SetupError};
use crate::scenario::Scenario;

/// Adds every deposit to the particles within its radius `R`, with the weights
/// `m (1 - (r/R)^2)^2`. They are divided by their sum, so the energies add up to the
/// deposit but for rounding, also where a wall cuts the ball.
pub(super) fn add(scenario: &Scenario, particles: &mut [Placed]) -> Result<(), SetupError> {
    for (number, deposit) in scenario.deposits.iter().enumerate() {
        let ball = &deposit.ball;
        let squared = |particle: &Placed| ball.distance_squared(&particle.position);
        let factor = |particle: &Placed| {
            let part = 1.0 - squared(particle) / (ball.radius * ball.radius);
            part.max(0.0) * part.max(0.0)
        };
        let total: f64 = particles.iter().map(|p| p.mass * factor(p)).sum();
        if !(total > 0.0) {
            let nearest = particles.iter().map(squared).fold(f64::INFINITY, f64::min);
            return Err(SetupError::EmptyDeposit {
                deposit: number,
                radius: ball.radius,
                nearest: nearest.sqrt(),
            });
        }
        for particle in particles.iter_mut() {
            let factor = factor(particle);
            if factor > 0.0 {
                particle.energy += deposit.energy * (factor / total);
                let law = &scenario.materials[usize::from(particle.material)].law;
                particle.pressure = law.pressure(particle.density, particle.energy);
            }
        }
    }
    Ok(())
}
