//! Why a run cannot be, or did not end.

use motes_core::error::Error;

/// A run that did not reach its end.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum RunError {
    /// The solver stopped.
    #[error("at t = {time}, step {step}: {error}")]
    Solver {
        /// When, in the scenario's units.
        time: f64,
        /// In which step.
        step: u64,
        /// Why.
        error: Error,
    },
    /// In fixed point what comes next cannot be proven to stay in the range of the format.
    #[error("at t = {time}, step {step}: {error}")]
    #[diagnostic(help(
        "the bound is one of all particles and may be far above what would come: --check-overflow \
         looks at every operation, five times slower; --allow-unproven goes on and warns"
    ))]
    Unproven {
        /// When, in the scenario's units.
        time: f64,
        /// In which step.
        step: u64,
        /// Of what.
        error: Error,
    },
    /// The solver cannot begin.
    #[error("at t = 0, before the first step: {}", facts(error))]
    #[diagnostic(help("{}", cure_of_start(error)))]
    Start {
        /// Why.
        error: Error,
    },
    /// Who looked at the run stopped it.
    #[error("at t = {time}: {reason}")]
    Look {
        /// When, in the scenario's units.
        time: f64,
        /// Why.
        reason: String,
    },
    /// What it was to go on from is not of this run.
    #[error("the run cannot go on from there: {error}")]
    #[diagnostic(help(
        "it was kept by another version of motes, or of another scenario: begin the run anew"
    ))]
    Resume {
        /// Why.
        error: Error,
    },
    /// A number of the plan does not fit the scalar.
    #[error("{what} is {value:.3e} in solver units, which `{scalar}` cannot hold to 1 %")]
    #[diagnostic(help("{}", wider(*value, scalar)))]
    Format {
        /// Which number.
        what: &'static str,
        /// How large it is.
        value: f64,
        /// The scalar.
        scalar: String,
    },
    /// Gradients that are made in floats only.
    #[error("gradient.kind = \"linear-exact\" is for floats, and `{scalar}` is fixed point")]
    #[diagnostic(help("run with --scalar f64 or f32, or take [gradient] out"))]
    Gradient {
        /// The scalar.
        scalar: String,
    },
    /// Two particles in one place.
    #[error(
        "particles {first} and {second} lie in one place, {place}, in `{scalar}`{}",
        if *count > 1 { format!("; so do {count} in all") } else { String::new() }
    )]
    #[diagnostic(help(
        "keep one particle a place: take the other out, or move them apart. Where the scalar rounds \
         two places to one, use a format with more fractional bits, or a smaller domain"
    ))]
    Coincident {
        /// The one with the lower id.
        first: usize,
        /// The other.
        second: usize,
        /// How many lie where one before lies.
        count: usize,
        /// Where, in the scenario's units.
        place: String,
        /// The scalar.
        scalar: String,
    },
    /// A step so short that the run has no end.
    #[error("at t = {time:?} the stable step is {step:.3e}: {steps:.1e} of them to the end")]
    #[diagnostic(help(
        "a speed, a diffusivity or a rate is out of proportion to time.end, or has become so: look \
         at its unit"
    ))]
    Endless {
        /// When, in the scenario's units.
        time: f64,
        /// The step, likewise.
        step: f64,
        /// How many would follow.
        steps: f64,
    },
    /// The caller asked for it.
    #[error("interrupted at t = {time}, after {step} steps: no results were written")]
    Interrupted {
        /// When.
        time: f64,
        /// After how many steps.
        step: u64,
    },
    /// Not enough memory.
    #[error(
        "{particles} particles need about {needed:.1} GiB, this machine has {available:.1} GiB free"
    )]
    #[diagnostic(help("use fewer particles (-n, resolution.particles)"))]
    Memory {
        /// How many.
        particles: usize,
        /// GiB that they take.
        needed: f64,
        /// GiB that there are.
        available: f64,
    },
    /// A cut-off that does not go with the cloud.
    #[error("epsilon = {epsilon:e} is {spacings:.3} spacings: {error}")]
    #[diagnostic(help(
        "epsilon = eta L (h/L)^theta, h the spacing and L = h N^(1/D): give another eta, or epsilon \
         itself; 1.5 to 4 spacings are usual"
    ))]
    Width {
        /// ε, in the scenario's unit of length.
        epsilon: f64,
        /// The same in mean spacings.
        spacings: f64,
        /// What the solver says of it.
        error: Error,
    },
    /// A step that is not stable.
    #[error("time.step = {step:e} is above the stable limit {limit:.6e} at t = {time:?}")]
    #[diagnostic(help("use a smaller step, a larger epsilon, or leave time.step out"))]
    Step {
        /// The step asked for.
        step: f64,
        /// The largest stable one.
        limit: f64,
        /// When.
        time: f64,
    },
    /// A norm that grows faster than that of any solution.
    #[error(
        "at t = {time:?} the energy norm is {norm:.6e}, but no solution grows beyond {bound:.6e}"
    )]
    #[diagnostic(help(
        "the run has become unstable or the cloud too thin: use a smaller time.courant, a larger \
         epsilon or more particles; time.growth-margin is how much more is let pass"
    ))]
    Growth {
        /// When.
        time: f64,
        /// What it has grown to.
        norm: f64,
        /// What it may have grown to.
        bound: f64,
    },
    /// A norm that is no number.
    #[error("at t = {time:?} the energy norm is no number any more")]
    #[diagnostic(help(
        "the run has become unstable, or a reaction grows without end: use a smaller time.courant or \
         time.step, or a slower reaction"
    ))]
    Lost {
        /// When.
        time: f64,
    },
}

/// What holds a number that a scalar does not.
fn wider(value: f64, scalar: &str) -> &'static str {
    match (scalar.starts_with('q'), value.abs() > 1.0) {
        (true, true) => {
            "use a format with more integer bits, or fewer particles: lengths are counted in particle \
             spacings"
        }
        (true, false) => {
            "use a format with more fractional bits: masses, velocities and energies are counted in \
             those of the first state"
        }
        (false, _) => {
            "use f64, or fewer particles: lengths are counted in particle spacings, masses, velocities \
             and energies in those of the first state"
        }
    }
}

impl RunError {
    /// The same of a solver that has made no step: its cure is none of smaller ones.
    pub(crate) fn at_start(self) -> Self {
        match self {
            Self::Solver { error, .. } => Self::Start { error },
            other => other,
        }
    }

    /// What an error of the solver is at a time, in the step of that number.
    pub(crate) fn solver(time: f64, step: u64, error: Error) -> Self {
        match error {
            Error::Interrupted => Self::Interrupted { time, step },
            Error::Unproven { .. } => Self::Unproven { time, step, error },
            error => Self::Solver { time, step, error },
        }
    }

    /// Whether the scenario has to be another one for the run to be made at all.
    pub fn is_of_input(&self) -> bool {
        matches!(
            self,
            Self::Format { .. }
                | Self::Gradient { .. }
                | Self::Coincident { .. }
                | Self::Memory { .. }
                | Self::Width { .. }
                | Self::Step { .. }
        )
    }
}

/// What an error of the core says, without its cure.
fn facts(error: &Error) -> String {
    let text = error.to_string();
    let facts = text.split_once(": ").map_or(&*text, |(facts, _)| facts);
    facts.to_owned()
}

/// What to do about it before the first step, where steps are not at fault.
fn cure_of_start(error: &Error) -> String {
    let text = error.to_string();
    let cure = text.split_once(": ").map_or("", |(_, cure)| cure);
    match error {
        Error::Epsilon { .. } => {
            "use a larger eta, and look at the particles around that one: they may \
                                  be few, or lie in one place"
                .to_owned()
        }
        Error::NotFinite { .. } => {
            "use a wider format (--scalar), or a state at t = 0 whose numbers \
                                    are less unlike"
                .to_owned()
        }
        Error::NegativeEnergy { .. } => "give the gas more energy at t = 0, or use a wider format \
                                         (--scalar)"
            .to_owned(),
        _ => cure.to_owned(),
    }
}
