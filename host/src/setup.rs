//! Stub until the set-ups land.
use crate::scenario::Scenario;
#[derive(Clone, Copy, Debug)]
pub struct Placed { pub position: [f64; 3], pub velocity: [f64; 3], pub mass: f64, pub density: f64, pub pressure: f64, pub energy: f64, pub material: u8 }
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SetupError {
    #[error("region {region} would get no particle: it holds {share:.3} of one")]
    #[diagnostic(help("use more particles (-n, resolution.particles), or remove the region"))]
    EmptyRegion { region: usize, share: f64 },
}
pub fn particles(_: &Scenario) -> Result<Vec<Placed>, SetupError> { Ok(vec![]) }
pub fn apportion(masses: &[f64], particles: usize) -> Result<Vec<u32>, SetupError> {
    let total: f64 = masses.iter().sum();
    let shares: Vec<f64> = masses.iter().map(|mass| mass / total * particles as f64).collect();
    let mut counts: Vec<u32> = shares.iter().map(|share| (share + 1e-9).floor() as u32).collect();
    let mut order: Vec<usize> = (0..masses.len()).collect();
    let remainder = |i: usize| shares[i] - f64::from(counts[i]);
    order.sort_by(|&a, &b| remainder(b).total_cmp(&remainder(a)));
    let missing = particles.saturating_sub(counts.iter().map(|&count| count as usize).sum());
    for &region in order.iter().cycle().take(missing) { counts[region] += 1; }
    match counts.iter().position(|&count| count == 0) {
        Some(region) => Err(SetupError::EmptyRegion { region, share: shares[region] }),
        None => Ok(counts),
    }
}
