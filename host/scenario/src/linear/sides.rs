//! Which sides of the domain, and which walls, an initial state goes with.

use super::{Conductor, ConvectionDiffusion, System};
use crate::entry::Entry;
use crate::error::Fault;
use crate::{Domain, Side};

/// That a wave fills the domain periodically, that a round pulse meets no side, and that a
/// polynomial has the diffusivity that it goes with.
pub(super) fn check_sides(
    kind: &Entry<'_>,
    name: &str,
    system: &System,
    domain: &Domain,
) -> Result<(), Fault> {
    if let System::ConvectionDiffusion(diffusion) = system {
        return check_diffusion(kind, name, diffusion, domain);
    }
    let is_sound = matches!(system, System::Acoustics { .. });
    let sides = || domain.sides.iter().flatten();
    let need = match (name, domain.sides.len()) {
        // Along a line the pulse has images, but no echo.
        ("gaussian", 1) if is_sound && sides().any(|&side| side == Side::Mirror) => Side::Free,
        ("gaussian", 2..) if is_sound => Side::Free,
        ("gaussian", _) => return Ok(()),
        _ => Side::Periodic,
    };
    if sides().all(|&side| side == need) {
        return Ok(());
    }
    let (word, why) = match need {
        Side::Free => ("free", "its solution is that of a pulse in the open"),
        _ => ("periodic", "it has whole wavelengths in the domain"),
    };
    let cure = format!("set all of domain.sides to \"{word}\", or choose another initial state");
    Err(kind.does_not_fit(why.to_owned(), &cure))
}

fn check_diffusion(
    kind: &Entry<'_>,
    name: &str,
    diffusion: &ConvectionDiffusion,
    domain: &Domain,
) -> Result<(), Fault> {
    let profile = &diffusion.profile;
    if name == "legendre" && !matches!(profile, Conductor::Parabola { .. }) {
        let reason = format!("it goes with a parabola, the profile is {}", profile.name());
        let cure = "set profile = { kind = \"parabola\" } in [system], or choose another \
                    initial state";
        return Err(kind.does_not_fit(reason, cure));
    }
    let is_free = domain
        .sides
        .iter()
        .flatten()
        .any(|&side| side == Side::Free);
    if name == "modes" && (is_free || !diffusion.is_closed()) {
        let reason = "it has whole wavelengths in the domain, and no slope at a wall";
        let cure = "set all of domain.sides to \"periodic\" or \"mirror\" without a [[wall]] \
                    that lets something through, or choose another initial state";
        return Err(kind.does_not_fit(reason.to_owned(), cure));
    }
    Ok(())
}
