//! Any gas that fills its domain as Rust source, in one to three dimensions.

use std::fmt::Write;

use motes_core::equation::gas::{Diffusion, NoSlip, Options, Plain, Switch, Width};
use motes_core::neighbours::cell_bound;

use super::module::{Module, literal, number, vector};
use super::run::{Start, domain};
use super::viscosity;
use crate::families::gas::{Plan, SMALLEST_OMEGA};
use crate::scenario::EquationOfState;

/// Where the core has gas dynamics.
const GAS: &str = "motes_core::equation::gas";

/// A gas that `motes export` does not write.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("`motes export` does not write `{name}`: {reason}")]
pub struct NoGas {
    name: String,
    reason: &'static str,
    #[help]
    cure: &'static str,
}

/// The source of a module that runs a gas.
///
/// # Errors
/// Inflow and outflow sides, and a background pressure.
pub(super) fn gas(module: Module, name: &str, plan: &Plan) -> Result<String, NoGas> {
    let refused = |reason, cure| {
        let name = name.to_owned();
        Err(NoGas { name, reason, cure })
    };
    if plan.opening.is_some() {
        return refused(
            "gas comes in or goes out through its sides, and how many particles there will be is not known",
            "close domain.sides; a device can run motes_core::integrator::OpenGas, set up by hand with \
             room for them",
        );
    }
    if plan.options.background > 0.0 {
        return refused(
            "its force.background is above 0: energies at the start depend on densities that the run \
             sums first",
            "set force.background = 0",
        );
    }
    Ok(match plan.dimension {
        1 => of::<1>(module, name, plan),
        2 => of::<2>(module, name, plan),
        _ => of::<3>(module, name, plan),
    })
}

/// The same in that dimension.
fn of<const D: usize>(mut module: Module, name: &str, plan: &Plan) -> String {
    let module = &mut module;
    let particles = plan.particles.len();
    let options = plan.options::<f64, D>();
    let (physics, storage) = match options.need_exchange() {
        true => ("Options", "OptionsStorage"),
        false => ("Plain", "PlainStorage"),
    };
    module.import(
        GAS,
        [
            "GasDynamics",
            "Particle",
            "Plain",
            "Width",
            physics,
            storage,
        ],
    );
    module.import("motes_core::integrator", ["LeapFrog"]);
    module.import("motes_core::material", ["Named as Material"]);
    module.cloud(name, particles);
    module.cells(u64::from(cell_bound(particles as u32)) + 1);
    module.cut_off(plan.cut_off);
    viscosity::viscosity(module, &plan.viscosity);
    let count = plan.materials.len();
    let materials = materials(module, &plan.materials);
    let call = match options.need_exchange() {
        true => self::options(module, &options),
        false => plain(module, &options.plain),
    };
    module.item(format!(
        "/// What the gas does beyond the paper's equations.
pub fn physics<S: Scalar>() -> {physics}<S, {D}> {{\n    {call}\n}}\n"
    ));
    module.item(format!(
        "/// The materials, by number.
pub fn materials<S: Scalar>() -> [Material<S>; {count}] {{\n    [{materials}]\n}}\n"
    ));
    domain(module, &plan.axes[..D]);
    cloud::<D>(module, plan);
    let width = match plan.width {
        Width::Constant { epsilon } => format!("Constant {{ epsilon: {} }}", number(epsilon)),
        Width::Adaptive { eta, packing } => {
            module.import(GAS, ["Packing"]);
            let eta = number(eta);
            format!("Adaptive {{ eta: {eta}, packing: Packing::{packing:?} }}")
        }
    };
    let start = Start {
        dimension: D,
        dynamics: format!(
            "GasDynamics<'m, S, CutOff, Viscosity<S>, Material<S>, {physics}<S, {D}>, {D}>"
        ),
        call: format!(
            "    let dynamics = GasDynamics {{
        domain: domain(),
        cut_off: CUT_OFF,
        width: Width::{width},
        viscosity: viscosity(),
        materials: lists.insert(materials()).as_slice(),
        physics: physics(),
        courant: {},
        smallest_omega: {},
    }};\n",
            number(plan.courant),
            number(SMALLEST_OMEGA)
        ),
        method: "LeapFrog".to_owned(),
        storage: format!("{storage}<S, {D}, PARTICLES, CELLS>"),
        lists: Some((format!("Option<[Material<S>; {count}]>"), "None")),
        step: None,
        end: plan.end,
    };
    start.write(module);
    module.text()
}

/// The particles at the start: a static `CLOUD`.
fn cloud<const D: usize>(module: &mut Module, plan: &Plan) {
    let mut text = format!(
        "/// The particles at the start, in solver units.
#[rustfmt::skip]
pub static CLOUD: [Particle<f64, {D}>; PARTICLES] = [\n"
    );
    for particle in &plan.particles {
        let (x, u) = (&particle.position[..D], &particle.velocity[..D]);
        let [mass, energy] = [particle.mass, particle.energy].map(literal);
        let (epsilon, material) = (literal(particle.epsilon), particle.material);
        let _ = writeln!(
            text,
            "    Particle {{ position: {x:?}, velocity: {u:?}, mass: {mass}, energy: {energy}, epsilon: \
             {epsilon}, material: {material} }},"
        );
    }
    module.item(text + "];\n");
}

/// The materials, one after the other.
fn materials(module: &mut Module, laws: &[EquationOfState]) -> String {
    let mut of = |law: &EquationOfState| {
        let (name, numbers) = match *law {
            EquationOfState::IdealGas { gamma } => ("IdealGas", format!("{gamma:?}")),
            EquationOfState::StiffenedGas {
                gamma,
                pressure_at_infinity,
            } => (
                "StiffenedGas",
                format!("{gamma:?}, {pressure_at_infinity:?}"),
            ),
            EquationOfState::Isothermal { sound_speed } => {
                ("Isothermal", format!("{sound_speed:?}"))
            }
            EquationOfState::Tait {
                density,
                sound_speed,
                exponent,
            } => (
                "Tait",
                format!("{density:?}, {sound_speed:?}, {exponent:?}"),
            ),
        };
        module.import("motes_core::material", [name]);
        format!("Material::{name}({name}::new({numbers}))")
    };
    let laws: Vec<String> = laws.iter().map(&mut of).collect();
    laws.join(", ")
}

/// Weights and external acceleration.
fn plain<const D: usize>(module: &mut Module, plain: &Plain<f64, D>) -> String {
    module.import(GAS, ["Weights"]);
    let Plain {
        weights,
        acceleration,
        far: _,
    } = plain;
    let acceleration = vector(acceleration);
    format!(
        "Plain {{ weights: Weights::{weights:?}, acceleration: {acceleration}, far: [None; 2] }}"
    )
}

/// All options.
fn options<const D: usize>(module: &mut Module, options: &Options<f64, D>) -> String {
    module.import(GAS, ["Diffusion", "EnergyForm", "NoSlip"]);
    let Options {
        plain,
        energy,
        limited,
        linear_exact,
        switch,
        balsara,
        conduction,
        diffusion:
            Diffusion {
                viscosity,
                bulk_viscosity,
                heat,
            },
        walls: NoSlip { velocity },
        background: _,
    } = options;
    let plain = self::plain(module, plain);
    let switch = match switch {
        None => "None".to_owned(),
        Some(Switch { minimum, decay }) => {
            module.import(GAS, ["Switch"]);
            let [minimum, decay] = [*minimum, *decay].map(number);
            format!("Some(Switch {{ minimum: {minimum}, decay: {decay} }})")
        }
    };
    let wall = |wall: &Option<[f64; D]>| match wall {
        None => "None".to_owned(),
        Some(velocity) => format!("Some({})", vector(velocity)),
    };
    let walls: Vec<String> = velocity
        .iter()
        .map(|[lower, upper]| format!("[{}, {}]", wall(lower), wall(upper)))
        .collect();
    let [conduction, viscosity, bulk, heat] =
        [*conduction, *viscosity, *bulk_viscosity, *heat].map(number);
    format!(
        "Options {{
        plain: {plain},
        energy: EnergyForm::{energy:?},
        limited: {limited},
        linear_exact: {linear_exact},
        switch: {switch},
        balsara: {balsara},
        conduction: {conduction},
        diffusion: Diffusion {{ viscosity: {viscosity}, bulk_viscosity: {bulk}, heat: {heat} }},
        walls: NoSlip {{ velocity: [{}] }},
        background: S::ZERO,
    }}",
        walls.join(", ")
    )
}
