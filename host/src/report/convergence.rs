//! What `motes converge` tells: a table for people, one JSON object for programs, a picture.

mod picture;

use std::fmt;

use serde::Serialize;

use super::figure::FigureError;
use crate::study::{Level, PowerLaw, Study};

/// What a study came to. Serialised, it is the object that `--json` prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Convergence {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the scalar.
    pub scalar: String,
    /// The field compared.
    pub field: String,
    /// The norm of the orders.
    pub norm: &'static str,
    /// The coarsest first.
    pub levels: Vec<Level>,
    /// From each level to the next; `null` where there is none.
    pub orders: Vec<Option<f64>>,
    /// The slope of the line through all levels; `null` where there is none.
    pub observed_order: Option<f64>,
    /// `r theta`; `null` where no theorem applies.
    pub predicted_order: Option<f64>,
    /// `min(r theta, m - theta (m + s))`; `null` likewise.
    pub guaranteed_order: Option<f64>,
    /// `eps = factor h^exponent`, as it was in the runs.
    pub width: Option<PowerLaw>,
    /// What a careful reader should know.
    pub warnings: Vec<String>,
}

impl Convergence {
    /// Of a study; `warnings` of its runs come after its own.
    pub fn new(
        study: &Study,
        (scenario, field, scalar): (&str, &str, &str),
        warnings: Vec<String>,
    ) -> Self {
        Self {
            scenario: scenario.to_owned(),
            scalar: scalar.to_owned(),
            field: field.to_owned(),
            norm: study.norm.name(),
            levels: study.levels.clone(),
            orders: study.orders(),
            observed_order: study.fit().map(|law| law.exponent),
            predicted_order: study.theory.map(|theory| theory.predicted_order()),
            guaranteed_order: study.theory.map(|theory| theory.guaranteed_order()),
            width: study.width(),
            warnings: study.warnings().into_iter().chain(warnings).collect(),
        }
    }

    /// The picture of the study it was made of, as SVG text.
    ///
    /// # Errors
    /// A picture that cannot be drawn.
    pub fn picture(&self, study: &Study) -> Result<String, FigureError> {
        let title = format!(
            "{}: error of {}, {}",
            self.scenario, self.field, self.scalar
        );
        let error = format!("{} error", shown(self.norm));
        picture::picture(&title, &error, study)
    }
}

/// The name of a norm in a text.
fn shown(norm: &str) -> String {
    norm.replacen('l', "L", 1)
}

impl fmt::Display for Convergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let norm = shown(self.norm);
        writeln!(
            f,
            "{}: error of {}, {}\n",
            self.scenario, self.field, self.scalar
        )?;
        let heading = format!("{norm} order");
        writeln!(
            f,
            "{:>10}{:>12}{:>12}{:>12}{:>12}{:>12}{heading:>12}",
            "n", "h", "eps", "L1", "L2", "Linf"
        )?;
        let orders = std::iter::once(&None).chain(&self.orders);
        for (level, order) in self.levels.iter().zip(orders) {
            write!(f, "{:>10}", level.n)?;
            for number in [level.h, level.eps, level.l1, level.l2, level.linf] {
                write!(f, "{number:>12.4e}")?;
            }
            match order {
                Some(order) => writeln!(f, "{order:>12.2}")?,
                None => writeln!(f, "{:>12}", "-")?,
            }
        }
        match self.observed_order {
            Some(order) => writeln!(f, "\nobserved   {order:.2}: {norm}, least squares")?,
            None => writeln!(f, "\nobserved   none")?,
        }
        match (self.predicted_order, self.guaranteed_order) {
            (Some(predicted), Some(guaranteed)) => {
                writeln!(f, "predicted  {predicted:.2}: r theta")?;
                let nothing = if guaranteed > 0.0 { "" } else { ": nothing" };
                writeln!(
                    f,
                    "guaranteed {guaranteed:.2}: Theorems 2 and 3, for any cloud{nothing}"
                )?;
            }
            _ => writeln!(f, "predicted  none: no theorem covers gas dynamics")?,
        }
        match &self.width {
            Some(law) => write!(f, "eps        {:.3} h^{:.3}", law.factor, law.exponent)?,
            None => write!(f, "eps        no power of h")?,
        }
        for warning in &self.warnings {
            write!(f, "\nwarning: {warning}")?;
        }
        Ok(())
    }
}
