//! Points and weights `∫ ψ dξ ≈ Σ ω_k ψ(ξ_k)` for the particles at t = 0.

use std::f64::consts::TAU;
use std::path::Path;

use crate::scenario::Extent;
use crate::scenario::linear::{Arrangement, LinearScenario};
use crate::scenario::table::{self, Column};
use crate::setup::{CloudError, LARGEST, Places};

/// Points and weights, in the scenario's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadrature {
    /// `ξ_k`; 0 beyond the dimension.
    pub positions: Vec<[f64; 3]>,
    /// The same from the middle of the domain, in its lengths: free of any unit, to the bit
    /// where the points are no file's.
    pub places: Vec<[f64; 3]>,
    /// `ω_k`, > 0, in the mean volume of a particle.
    pub shares: Vec<f64>,
    /// The state at the points, one after the other, where a file holds it.
    pub values: Option<Vec<f64>>,
    /// What a careful reader should know of the file that holds them.
    pub doubts: Vec<String>,
}

/// Why there are no particles.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum QuadratureError {
    /// More than ids can count.
    #[error("{particles} particles are more than the {LARGEST} that a run may have")]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    TooMany {
        /// How many were asked for.
        particles: usize,
    },
    /// A lattice of far more points than were asked for.
    #[error(
        "the lattice that fits has {fitted:.3e} particles where {particles} were asked for: the \
         domain is thinner than their spacing in some direction"
    )]
    #[diagnostic(help(
        "leave the thin direction out (a lower dimension), or use more particles (-n, \
         resolution.particles)"
    ))]
    Flat {
        /// How many there would be.
        fitted: f64,
        /// How many were asked for.
        particles: usize,
    },
    /// A file that is no cloud.
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(#[from] Box<CloudError>),
}

impl Quadrature {
    /// Refuses more particles than ids can count.
    ///
    /// # Errors
    /// That.
    pub fn check_size(scenario: &LinearScenario) -> Result<(), QuadratureError> {
        let particles = scenario.resolution.particles;
        match particles <= LARGEST {
            true => Ok(()),
            false => Err(QuadratureError::TooMany { particles }),
        }
    }

    /// Points at these parts of the lengths of a box.
    fn of_parts(extent: &Extent, parts: &[[f64; 3]], shares: Vec<f64>) -> Self {
        let dimension = extent.lower.len();
        let place =
            |s: &[f64; 3]| std::array::from_fn(|i| if i < dimension { s[i] - 0.5 } else { 0.0 });
        Self {
            positions: parts.iter().map(|&s| point(extent, s)).collect(),
            places: parts.iter().map(place).collect(),
            shares,
            values: None,
            doubts: Vec::new(),
        }
    }

    /// The particles of a scenario at t = 0.
    ///
    /// # Errors
    /// More than ids can count, or a file that cannot be used.
    pub fn of(scenario: &LinearScenario) -> Result<Self, QuadratureError> {
        Self::check_size(scenario)?;
        let extent = &scenario.domain.extent;
        let particles = scenario.resolution.particles;
        Ok(match &scenario.resolution.arrangement {
            Arrangement::Lattice => lattice(extent, particles)?,
            Arrangement::Distorted { amplitude } => distorted(extent, particles, *amplitude)?,
            Arrangement::LowDiscrepancy => low_discrepancy(extent, particles),
            Arrangement::File(path) => file(path, scenario)?,
        })
    }
}

/// Lengths of a box, 1 beyond its dimension.
fn lengths(extent: &Extent) -> [f64; 3] {
    std::array::from_fn(|i| match extent.lower.get(i) {
        Some(lower) => extent.upper[i] - lower,
        None => 1.0,
    })
}

/// The point of a box at parts `s` of its lengths.
fn point(extent: &Extent, s: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| match extent.lower.get(i) {
        Some(lower) => lower + (extent.upper[i] - lower) * s[i],
        None => 0.0,
    })
}

/// Cells along each direction, about `particles` of them in all, as cubic as they can be: a
/// direction in which the box is thinner than a cell has one, and the others share the rest.
fn counts(extent: &Extent, particles: usize) -> [usize; 3] {
    let lengths = lengths(extent);
    let mut wide: Vec<usize> = (0..extent.lower.len()).collect();
    loop {
        let volume: f64 = wide.iter().map(|&i| lengths[i]).product();
        let spacing = libm::pow(volume / particles as f64, 1.0 / wide.len() as f64);
        let thin = |&i: &usize| wide.len() > 1 && lengths[i] < 0.5 * spacing;
        if let Some(place) = wide.iter().position(thin) {
            wide.remove(place);
            continue;
        }
        return std::array::from_fn(|i| match wide.contains(&i) {
            true if wide.len() == 1 => particles,
            true => ((lengths[i] / spacing).round() as usize).max(1),
            false => 1,
        });
    }
}

/// The middles of equal cells (2.1), as parts of the lengths; the last direction runs fastest.
///
/// # Errors
/// More than twice as many as were asked for, a handful aside.
fn middles(extent: &Extent, particles: usize) -> Result<Vec<[f64; 3]>, QuadratureError> {
    let counts = counts(extent, particles);
    let fitted: f64 = counts.iter().map(|&count| count as f64).product();
    if !(fitted <= 2.0 * particles as f64 + 8.0) {
        return Err(QuadratureError::Flat { fitted, particles });
    }
    let middle = |k: usize, n: usize| (k as f64 + 0.5) / n as f64;
    let [nx, ny, nz] = counts;
    let mut middles = Vec::with_capacity(nx * ny * nz);
    for i in 0..nx {
        for j in 0..ny {
            let plane = (0..nz).map(|k| [middle(i, nx), middle(j, ny), middle(k, nz)]);
            middles.extend(plane);
        }
    }
    Ok(middles)
}

/// (2.1): the middles of equal cells.
fn lattice(extent: &Extent, particles: usize) -> Result<Quadrature, QuadratureError> {
    distorted(extent, particles, 0.0)
}

/// The lattice under the map `s_i -> s_i + α sin 2πs_i Π_(j≠i) cos 2πs_j` of the unit box onto
/// itself, weights `h^D det`: a smooth map, so that the order of (2.1) is kept (1.10). One to one
/// for `2πα < 1`.
fn distorted(
    extent: &Extent,
    particles: usize,
    amplitude: f64,
) -> Result<Quadrature, QuadratureError> {
    let dimension = extent.lower.len();
    let middles = middles(extent, particles)?;
    let (mut parts, mut shares) = (Vec::new(), Vec::new());
    for s in middles {
        let angle = s.map(|s| TAU * s);
        let sine = angle.map(libm::sin);
        let cosine: [f64; 3] = std::array::from_fn(|i| {
            if i < dimension {
                libm::cos(angle[i])
            } else {
                1.0
            }
        });
        let others = |i: usize| -> f64 {
            let factors = (0..3).filter(|&j| j != i).map(|j| cosine[j]);
            factors.product()
        };
        parts.push(std::array::from_fn(|i| {
            s[i] + amplitude * sine[i] * others(i)
        }));
        // ∂(new s_i)/∂s_j.
        let slope = |i: usize, j: usize| match (i < dimension, j < dimension) {
            (true, true) if i == j => 1.0 + TAU * amplitude * cosine[i] * others(i),
            (true, true) => -TAU * amplitude * sine[i] * sine[j] * cosine[3 - i - j],
            _ if i == j => 1.0,
            _ => 0.0,
        };
        let minor = |j: usize| {
            let [a, b] = [[1, 2], [0, 2], [0, 1]][j];
            slope(1, a) * slope(2, b) - slope(1, b) * slope(2, a)
        };
        let determinant = slope(0, 0) * minor(0) - slope(0, 1) * minor(1) + slope(0, 2) * minor(2);
        shares.push(determinant);
    }
    Ok(Quadrature::of_parts(extent, &parts, shares))
}

/// Roberts' sequence (2018): `s_i = frac(1/2 + k/φ^(i+1))`, `φ^(D+1) = φ + 1`, of low discrepancy;
/// equal weights. Exact to O(log N/N) only: gradients of its sums converge more slowly than on a
/// lattice.
fn low_discrepancy(extent: &Extent, particles: usize) -> Quadrature {
    let dimension = extent.lower.len();
    let mut root: f64 = 1.5;
    for _ in 0..64 {
        root = libm::pow(1.0 + root, 1.0 / (dimension + 1) as f64);
    }
    let steps: [f64; 3] = std::array::from_fn(|i| 1.0 / libm::pow(root, (i + 1) as f64));
    let place = |k: usize| {
        steps.map(|step| {
            let s = 0.5 + (k + 1) as f64 * step;
            s - s.floor()
        })
    };
    let parts: Vec<_> = (0..particles).map(place).collect();
    Quadrature::of_parts(extent, &parts, vec![1.0; particles])
}

/// Positions, weights and, without an initial state in the scenario, values from a CSV file.
fn file(path: &Path, scenario: &LinearScenario) -> Result<Quadrature, QuadratureError> {
    let dimension = scenario.dimension;
    let mut names = match scenario.initial {
        Some(_) => Vec::new(),
        None => scenario.system.names(dimension),
    };
    names.insert(0, "weight".to_owned());
    let quadrature = table::read(path, |table| {
        let need = format!(
            "need position_x and so on (dimension = {dimension}), {}",
            names.join(", ")
        );
        let mut known: Vec<&str> = names.iter().map(String::as_str).collect();
        known.extend(["position", "position_x", "position_y", "position_z"]);
        table.spelled(&known)?;
        let position = table.vector("position", dimension, &need)?;
        let columns: Vec<Column> = names
            .iter()
            .map(|name| table.required(name, &need))
            .collect::<Result<_, _>>()?;
        let (mut positions, mut shares, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let mut places = Places::new(&scenario.domain);
        table.rows(|row| {
            let mut place = [0.0; 3];
            for (i, (x, column)) in place.iter_mut().zip(&position).enumerate() {
                *x = row.within(column, scenario.domain.bounds(i))?;
            }
            positions.push(place);
            places.push(place, row.place());
            shares.push(row.positive(&columns[0])?);
            for column in &columns[1..] {
                values.push(row.number(column)?);
            }
            Ok(())
        })?;
        places.check_apart(table)?;
        let doubt = places.contradiction(&shares).map(|found| {
            format!(
                "line {}: weight = {}, but its neighbours leave the particle a volume of {:.4e}{}: \
                 weights are volumes, and waves run at wrong speeds where they are not",
                places.line(found.particle).number,
                found.claimed,
                found.room,
                found.extent(),
            )
        });
        let extent = &scenario.domain.extent;
        let (lengths, count) = (lengths(extent), shares.len() as f64);
        for share in &mut shares {
            *share *= count / extent.volume();
        }
        let place = |x: &[f64; 3]| std::array::from_fn(|i| (x[i] - extent.middle(i)) / lengths[i]);
        Ok(Quadrature {
            places: positions.iter().map(place).collect(),
            positions,
            shares,
            doubts: doubt.into_iter().collect(),
            values: scenario.initial.is_none().then_some(values),
        })
    })?;
    Ok(quadrature)
}
