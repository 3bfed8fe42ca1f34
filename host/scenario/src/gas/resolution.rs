//! How many particles there are, and how they are placed.

use std::path::{Path, PathBuf};

use crate::bound::FRACTION;
use crate::entry::Entry;
use crate::error::Fault;
use crate::resolution::{file, particles};
use crate::section::Section;
use crate::{Domain, Side};

use super::profile::Profile;

/// How many particles, and how they are placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Resolution {
    /// In all regions together, at least 1; exact in one dimension, elsewhere about that
    /// many. 0 for a file, which says how many.
    pub particles: usize,
    /// How they are placed.
    pub arrangement: Arrangement,
    /// What all of them have the same of.
    pub share: Share,
    /// A square lattice turned by `atan(p/q)`: `[p, q]`, both at least 1, no common factor.
    pub rotation: Option<[u32; 2]>,
    /// Where the lattice of a region begins.
    pub anchor: Anchor,
    /// Of the random numbers of jitter and glass.
    pub seed: u64,
    /// Largest displacement of a particle of a lattice along each direction, in spacings; in
    /// [0, 0.5).
    pub jitter: f64,
}

/// How the particles are placed at t = 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Arrangement {
    /// One dimension: equally spaced. Two and three: [`Arrangement::Square`] and
    /// [`Arrangement::Cubic`]. In a profile of varying density: [`Arrangement::Sampled`].
    EqualMass,
    /// A square lattice; two dimensions.
    Square,
    /// A triangular lattice; two dimensions.
    Hexagonal,
    /// A cubic lattice; three dimensions.
    Cubic,
    /// Hexagonal layers, closely packed; three dimensions.
    ClosePacked,
    /// Particles of equal mass, as dense as the profile.
    Sampled,
    /// Random, then relaxed until it is even.
    Glass,
    /// As a CSV file says.
    File(PathBuf),
}

/// What all particles have the same of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Share {
    /// Mass: denser gas, smaller spacing.
    Mass,
    /// Volume: denser gas, heavier particles.
    Volume,
}

/// Where the lattice of a region begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Particles are the middles of cells that fill the region: half a spacing from its faces.
    Middle,
    /// The first particle lies in the region's lower corner, as in many other codes: the
    /// region's own gas reaches half a spacing beyond its lower faces, and as much less at the
    /// upper ones.
    Corner,
}

const ARRANGEMENTS: &[(&str, Arrangement)] = &[
    ("equal-mass", Arrangement::EqualMass),
    ("square", Arrangement::Square),
    ("hexagonal", Arrangement::Hexagonal),
    ("cubic", Arrangement::Cubic),
    ("close-packed", Arrangement::ClosePacked),
    ("sampled", Arrangement::Sampled),
    ("glass", Arrangement::Glass),
    ("file", Arrangement::File(PathBuf::new())),
];

const ANCHORS: &[(&str, Anchor)] = &[("middle", Anchor::Middle), ("corner", Anchor::Corner)];

const SHARES: &[(&str, Share)] = &[("mass", Share::Mass), ("volume", Share::Volume)];

/// `[resolution]`; a file is looked for in `folder`.
pub(super) fn resolution(
    section: &Section<'_>,
    folder: &Path,
    domain: &Domain,
    profile: Option<&Profile>,
) -> Result<Resolution, Fault> {
    let entry = section.required("arrangement")?;
    let arrangement = match entry.choice(ARRANGEMENTS)? {
        Arrangement::File(_) => return from_file(section, folder),
        arrangement => arrangement,
    };
    if let Some(file) = section.optional("file") {
        let reason = format!("the arrangement is {}", entry.shown());
        let cure = "take `file` out, or set arrangement = \"file\"";
        return Err(file.does_not_fit(reason, cure));
    }
    let particles = particles(section)?;
    fits(&entry, &arrangement, domain.extent.lower.len(), profile)?;
    let share = section.optional("share");
    let resolution = Resolution {
        particles,
        share: share
            .as_ref()
            .map_or(Ok(Share::Mass), |entry| entry.choice(SHARES))?,
        rotation: rotation(section, &arrangement, domain)?,
        anchor: anchor(section, &arrangement, domain)?,
        seed: match section.optional("seed") {
            Some(entry) => seed(&entry)?,
            None => 1,
        },
        jitter: jitter(section, &arrangement)?,
        arrangement,
    };
    // One dimension has no other name for equally spaced particles.
    let own_masses = resolution.arrangement == Arrangement::Sampled
        || resolution.arrangement == Arrangement::EqualMass && domain.extent.lower.len() > 1;
    if let (Some(share), Share::Volume, true) = (&share, resolution.share, own_masses) {
        let reason = format!("arrangement = {} gives equal masses", entry.shown());
        let cure = "take `share` out, or choose a lattice: square, hexagonal, cubic, close-packed";
        return Err(share.does_not_fit(reason, cure));
    }
    let is_lattice = !matches!(
        resolution.arrangement,
        Arrangement::Sampled | Arrangement::EqualMass
    );
    if let (Some(profile), Share::Mass, true) = (profile, resolution.share, is_lattice)
        && !profile.is_uniform()
    {
        let reason = format!("equal masses do not make the density of {}", profile.name());
        let cure = "set share = \"volume\", or arrangement = \"sampled\"";
        return Err(entry.does_not_fit(reason, cure));
    }
    Ok(resolution)
}

fn seed(entry: &Entry<'_>) -> Result<u64, Fault> {
    entry.whole(
        0..=u64::from(u32::MAX),
        "0 to 4294967295",
        "give any whole number, for example 1",
    )
}

fn from_file(section: &Section<'_>, folder: &Path) -> Result<Resolution, Fault> {
    section.only("arrangement = \"file\"", &["arrangement"], &["file"])?;
    Ok(Resolution {
        particles: 0,
        arrangement: Arrangement::File(file(section, folder)?),
        share: Share::Mass,
        rotation: None,
        anchor: Anchor::Middle,
        seed: 1,
        jitter: 0.0,
    })
}

/// That the arrangement exists in this dimension, and has a density to follow.
fn fits(
    entry: &Entry<'_>,
    arrangement: &Arrangement,
    dimension: usize,
    profile: Option<&Profile>,
) -> Result<(), Fault> {
    let own = match arrangement {
        Arrangement::Square | Arrangement::Hexagonal => 2,
        Arrangement::Cubic | Arrangement::ClosePacked => 3,
        _ => dimension,
    };
    if own != dimension {
        let reason = format!("it is a lattice of {own} dimensions, dimension = {dimension}");
        let cure = "dimension 1 takes equal-mass, 2 square or hexagonal, 3 cubic or close-packed; \
                    glass goes with all";
        return Err(entry.does_not_fit(reason, cure));
    }
    if *arrangement == Arrangement::Sampled && profile.is_none() {
        let reason = "it follows the density of a [profile], there is none".to_owned();
        return Err(entry.does_not_fit(reason, "set arrangement = \"equal-mass\""));
    }
    Ok(())
}

fn rotation(
    section: &Section<'_>,
    arrangement: &Arrangement,
    domain: &Domain,
) -> Result<Option<[u32; 2]>, Fault> {
    let Some(entry) = section.optional("rotation") else {
        return Ok(None);
    };
    let square = matches!(arrangement, Arrangement::Square | Arrangement::EqualMass);
    if domain.sides != [[Side::Periodic; 2]; 2] || !square {
        let reason = "only square lattices between periodic sides can be turned".to_owned();
        return Err(entry.does_not_fit(reason, "take `rotation` out"));
    }
    let whole = |entry: &Entry<'_>| {
        entry.whole(
            0..=1000_u32,
            "0 to 1000",
            "give a small whole number, as in rotation = [1, 2]",
        )
    };
    let entries = entry.list("a pair of whole numbers")?;
    let [p, q] = entries.as_slice() else {
        return Err(entry.wrong_type("a pair of whole numbers"));
    };
    let (p, q) = (whole(p)?, whole(q)?);
    // Turned by 0 or 90 degrees it is itself.
    if p == 0 || q == 0 {
        return Ok(None);
    }
    let (mut divisor, mut rest) = (p, q);
    while rest > 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    Ok(Some([p / divisor, q / divisor]))
}

fn anchor(
    section: &Section<'_>,
    arrangement: &Arrangement,
    domain: &Domain,
) -> Result<Anchor, Fault> {
    let Some(entry) = section.optional("anchor") else {
        return Ok(Anchor::Middle);
    };
    let anchor = entry.choice(ANCHORS)?;
    let is_lattice = !matches!(arrangement, Arrangement::Sampled | Arrangement::Glass);
    let periodic = domain.sides.iter().all(|ends| *ends == [Side::Periodic; 2]);
    if anchor == Anchor::Corner && !(is_lattice && periodic) {
        let reason = "only lattices between periodic sides can begin in a corner".to_owned();
        return Err(entry.does_not_fit(reason, "take `anchor` out"));
    }
    Ok(anchor)
}

fn jitter(section: &Section<'_>, arrangement: &Arrangement) -> Result<f64, Fault> {
    let Some(entry) = section.optional("jitter") else {
        return Ok(0.0);
    };
    if *arrangement == Arrangement::Glass {
        let reason = "a glass starts from random places of its own".to_owned();
        return Err(entry.does_not_fit(reason, "take `jitter` out"));
    }
    entry.number(FRACTION)
}
