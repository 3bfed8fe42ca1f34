//! What a module has beside its equation: the domain, and how a run is started.

use std::fmt::Write;

use motes_core::domain::Axis;

use super::module::{Module, number};

/// The domain in the scalar of a run: a function `domain`.
pub(super) fn domain(module: &mut Module, axes: &[Axis<f64>]) {
    module.import("motes_core::domain", ["Axis", "Domain", "Side"]);
    let mut text = format!(
        "/// The domain, in solver units.
pub fn domain<S: Scalar>() -> Domain<S, {0}> {{
    Domain {{
        axes: [\n",
        axes.len()
    );
    for Axis {
        lower,
        upper,
        sides: [below, above],
    } in axes
    {
        let (lower, upper) = (number(*lower), number(*upper));
        let _ = write!(
            text,
            "            Axis {{
                lower: {lower},
                upper: {upper},
                sides: [Side::{below:?}, Side::{above:?}],
            }},\n"
        );
    }
    module.item(text + "        ],\n    }\n}\n");
}

/// How a run is started.
pub(super) struct Start {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// The type of the equation.
    pub dynamics: String,
    /// What makes it, and what comes before; the lists that it refers to are `lists`.
    pub call: String,
    /// The method.
    pub method: String,
    /// The storage of its particles.
    pub storage: String,
    /// What lies beside it in the memory of a run: its type and how it is empty.
    pub lists: Option<(String, &'static str)>,
    /// The step, if it is given.
    pub step: Option<f64>,
    /// Duration.
    pub end: f64,
}

impl Start {
    /// The memory of a run, `Memory`, and a function `start`, which puts `CLOUD` into it.
    pub fn write(&self, module: &mut Module) {
        module.import("motes_core::error", ["Error"]);
        module.import("motes_core::integrator", ["Stepper"]);
        module.import("motes_core::pairs", ["HalfLoop"]);
        module.import("motes_core::scalar", ["Scalar"]);
        module.run();
        let storage = &self.storage;
        let (dimension, dynamics) = (self.dimension, &self.dynamics);
        let taken = match &self.lists {
            None => {
                module.item(format!(
                    "/// All memory of a run but the stack.\npub type Memory<S> = {storage};\n"
                ));
                "let cloud = memory;"
            }
            Some((lists, empty)) => {
                module.item(format!(
                    "/// The memory of the particles.
pub type Storage<S> = {storage};

/// All memory of a run but the stack.
pub struct Memory<S: Scalar> {{
    cloud: Storage<S>,
    lists: {lists},
}}

impl<S: Scalar> Memory<S> {{
    /// No particles yet.
    pub const fn new() -> Self {{
        Self {{
            cloud: Storage::new(),
            lists: {empty},
        }}
    }}
}}

impl<S: Scalar> Default for Memory<S> {{
    fn default() -> Self {{
        Self::new()
    }}
}}\n"
                ));
                "let Memory { cloud, lists } = memory;"
            }
        };
        let stored = match self.lists {
            None => "Memory",
            Some(_) => "Storage",
        };
        let step = self
            .step
            .map(|step| format!("\n    run.step = Some({});", number(step)));
        let (keep, step, last) = match &step {
            None => ("", "", ""),
            Some(step) => ("let mut run = ", step.as_str(), ";"),
        };
        let end = number(self.end);
        let made = format!("Stepper::new(dynamics, method, HalfLoop, cloud)?.until({end})");
        let made = match keep.is_empty() {
            true => format!("Ok({made})"),
            false => format!("{keep}{made}{last}{step}\n    Ok(run)"),
        };
        module.item(format!(
            "/// A run between two steps.
pub type Run<'m, S> =
    Stepper<S, {dynamics}, HalfLoop, &'m mut {stored}<S>, {dimension}>;

/// A run at its start. Error: what the scalar cannot hold.
pub fn start<S: Scalar>(memory: &mut Memory<S>) -> Result<Run<'_, S>, Error> {{
    {taken}
    cloud.clear();
    for particle in &CLOUD {{
        cloud.push(particle.rounded())?;
    }}
{call}    let method = {method};
    {made}
}}\n",
            call = self.call,
            method = self.method,
        ));
    }
}
