//! Inflow and outflow sides in solver units.

use motes_core::cutoff::CutOff as _;
use motes_core::domain::Axis;
use motes_core::equation::gas::{Far, Inflow, Opening, Particle, Width, Zone};
use motes_core::scalar::Scalar;

use super::far::{self, Surroundings, far};
use super::packing::packing;
use crate::scenario::{self, Scenario, Share, Side, fineness};
use crate::setup::{Placed, SetupError};
use crate::units::SolverUnits;

/// What is beyond inflow and outflow sides: the `f64` twin of [`Opening`].
#[derive(Clone, Debug, PartialEq)]
pub struct OpenSides {
    /// The direction, from 0.
    pub axis: usize,
    /// What is beyond its lower and its upper side.
    pub zones: [OpenZone; 2],
    /// The gas far beyond them, where it is known.
    pub far: [Option<Far<f64>>; 2],
}

/// What is beyond a side.
#[derive(Clone, Debug, PartialEq)]
pub enum OpenZone {
    /// What the domain says.
    Shut,
    /// Gas that comes in.
    Inflow(Incoming),
    /// Gas that goes out, up to this distance from the side.
    Outflow(f64),
}

/// Gas that comes in: see [`Inflow`].
#[derive(Clone, Debug, PartialEq)]
pub struct Incoming {
    /// The state of its particles.
    pub particle: Particle<f64, 3>,
    /// Their density.
    pub density: f64,
    /// The thickness of a layer.
    pub spacing: f64,
    /// The particles of a layer.
    pub layer: Vec<[f64; 3]>,
    /// How far from the side layers enter.
    pub depth: f64,
    /// The spacings of its lattice along the directions.
    pub cell: [f64; 3],
}

/// Depth of a zone in reaches of the cut-off: more than the two over which densities and
/// forces look, since the outermost particles widen their cut-off for want of neighbours.
const DEPTH: f64 = 3.0;

impl OpenSides {
    /// Those of a scenario, if it has any.
    pub(super) fn new(
        scenario: &Scenario,
        units: &SolverUnits,
        axes: &[Axis<f64>; 3],
        placed: &[Placed],
        particles: &[Particle<f64, 3>],
    ) -> Result<Option<Self>, SetupError> {
        let Some(axis) = scenario.domain.open_direction() else {
            return Ok(None);
        };
        let support = f64::from(scenario.cut_off.shape.support());
        let most = particles.len();
        let fineness = fineness(most, scenario.dimension);
        let eta = scenario.cut_off.width.spacings(fineness);
        let incoming = scenario
            .inflow
            .as_ref()
            .map(|inflow| Incoming::new(inflow, scenario, units, axes, (axis, support, most, eta)));
        let incoming = incoming.transpose()?;
        let widest = match scenario.cut_off.width {
            scenario::Width::Constant { epsilon } => epsilon / units.length,
            scenario::Width::Adaptive { .. } => particles
                .iter()
                .chain(incoming.as_ref().map(|incoming| &incoming.particle))
                .map(|particle| particle.epsilon)
                .fold(0.0, f64::max),
        };
        let zone = |side: Side| match (side, &incoming) {
            (Side::Inflow, Some(incoming)) => OpenZone::Inflow(incoming.clone()),
            (Side::Outflow, _) => OpenZone::Outflow(DEPTH * support * widest),
            _ => OpenZone::Shut,
        };
        let width = match scenario.cut_off.width {
            scenario::Width::Constant { epsilon } => Width::Constant {
                epsilon: epsilon / units.length,
            },
            scenario::Width::Adaptive { .. } => Width::Adaptive {
                eta,
                packing: packing(&scenario.resolution.arrangement),
            },
        };
        let cell = incoming.as_ref().map_or([1.0; 3], |incoming| incoming.cell);
        let surroundings = Surroundings {
            scenario,
            units,
            axis,
            placed,
            excess: far::excess(scenario.cut_off.shape, width, &cell[..scenario.dimension]),
        };
        let sides = scenario.domain.sides[axis];
        let depth = DEPTH * support * widest;
        let inflow = incoming.as_ref().map_or(depth, |incoming| incoming.depth);
        Ok(Some(Self {
            axis,
            zones: sides.map(zone),
            far: far(sides, &surroundings, [inflow, depth]),
        }))
    }

    /// What comes in.
    pub fn incoming(&self) -> Option<&Incoming> {
        self.zones.iter().find_map(|zone| match zone {
            OpenZone::Inflow(incoming) => Some(incoming),
            _ => None,
        })
    }

    /// The layer of what comes in, in the scalar and dimension of the run; empty without.
    pub fn layer<S: Scalar, const D: usize>(&self) -> Vec<[S; D]> {
        let layer = self.incoming().map_or(&[][..], |incoming| &incoming.layer);
        layer.iter().map(rounded).collect()
    }

    /// The same in the scalar and dimension of the run, with its layer kept by the caller.
    pub fn rounded<'a, S: Scalar, const D: usize>(&self, layer: &'a [[S; D]]) -> Opening<'a, S, D> {
        let far = self.rounded_far();
        let zone = |end: usize| match &self.zones[end] {
            OpenZone::Shut => Zone::Shut,
            OpenZone::Outflow(depth) => Zone::Outflow(S::from_f64(*depth)),
            OpenZone::Inflow(incoming) => {
                let inflow = incoming.rounded(layer);
                match far[end].filter(Far::is_subsonic) {
                    Some(far) => Zone::Reservoir(inflow, far),
                    None => Zone::Inflow(inflow),
                }
            }
        };
        Opening {
            axis: self.axis,
            zones: [zone(0), zone(1)],
        }
    }

    /// The gas far beyond them, in the scalar of the run.
    pub fn rounded_far<S: Scalar>(&self) -> [Option<Far<S>>; 2] {
        self.far.map(|far| far.as_ref().map(far::rounded))
    }
}

impl Incoming {
    /// A square or cubic lattice, as fine as the scenario's share says: of equal masses or of
    /// equal volumes. Across the flow it fits the domain; along the flow it is stretched by as
    /// much as it is squeezed there.
    ///
    /// # Errors
    /// A layer of more particles than the gas has at the start.
    fn new(
        inflow: &scenario::Inflow,
        scenario: &Scenario,
        units: &SolverUnits,
        axes: &[Axis<f64>; 3],
        (axis, support, most, eta): (usize, f64, usize, f64),
    ) -> Result<Self, SetupError> {
        let density = inflow.density / units.density();
        // The mean mass is 1, and the mean volume.
        let volume = match scenario.resolution.share {
            Share::Mass => 1.0 / density,
            Share::Volume => 1.0,
        };
        let mean = match scenario.dimension {
            1 => volume,
            2 => volume.sqrt(),
            _ => libm::cbrt(volume),
        };
        let mut spacing = volume;
        let mut cells = [1.0; 3];
        let mut layer = vec![[0.0; 3]];
        for i in (0..scenario.dimension).filter(|&i| i != axis) {
            let length = axes[i].upper - axes[i].lower;
            let count = (length / mean).round().max(1.0);
            let fitted = count * layer.len() as f64;
            if !(fitted <= most as f64 + 8.0) {
                return Err(SetupError::Inflow {
                    fitted,
                    particles: most,
                });
            }
            let cell = length / count;
            cells[i] = cell;
            let places = (0..count as usize).map(|k| axes[i].lower + cell * (k as f64 + 0.5));
            let places: Vec<f64> = places.collect();
            let row = |point: [f64; 3]| {
                places.iter().map(move |&place| {
                    let mut point = point;
                    point[i] = place;
                    point
                })
            };
            layer = layer.into_iter().flat_map(row).collect();
            spacing /= cell;
        }
        for point in &mut layer {
            point[axis] = 0.5 * spacing;
        }
        cells[axis] = spacing;
        let law = &scenario.materials[inflow.material].law;
        let mut velocity = [0.0; 3];
        for (to, from) in velocity.iter_mut().zip(&inflow.velocity) {
            *to = from / units.velocity;
        }
        let (epsilon, width) = match scenario.cut_off.width {
            scenario::Width::Adaptive { .. } => (eta * mean, eta * mean),
            scenario::Width::Constant { epsilon } => (mean, epsilon / units.length),
        };
        Ok(Self {
            particle: Particle {
                position: [0.0; 3],
                velocity,
                mass: density * volume,
                energy: law.energy(inflow.density, inflow.pressure) / units.energy(),
                epsilon,
                material: inflow.material as u8,
            },
            density,
            spacing,
            layer,
            depth: (DEPTH * support * width).max(2.0 * spacing),
            cell: cells,
        })
    }

    /// The same in the scalar and dimension of the run.
    fn rounded<'a, S: Scalar, const D: usize>(&self, layer: &'a [[S; D]]) -> Inflow<'a, S, D> {
        Inflow {
            particle: Particle {
                position: [S::ZERO; D],
                velocity: rounded(&self.particle.velocity),
                mass: S::from_f64(self.particle.mass),
                energy: S::from_f64(self.particle.energy),
                epsilon: S::from_f64(self.particle.epsilon),
                material: self.particle.material,
            },
            density: S::from_f64(self.density),
            spacing: S::from_f64(self.spacing),
            layer,
            depth: S::from_f64(self.depth),
        }
    }
}

/// A vector in the scalar and dimension of the run.
fn rounded<S: Scalar, const D: usize>(vector: &[f64; 3]) -> [S; D] {
    std::array::from_fn(|i| S::from_f64(vector[i]))
}
