//! A module of Rust source, put together of its parts: head, imports, items.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use motes_core::cloud::Frame;
use motes_core::cutoff::Named;

use crate::scenario::formula::ELEMENTARY;

/// The longest line of imports.
const WIDTH: usize = 100;

/// A module that is being written. Numbers in it have the digits that read back to the same bits.
#[derive(Clone, Debug, Default)]
pub(super) struct Module {
    /// Lines of its doc.
    head: Vec<String>,
    imports: BTreeMap<&'static str, BTreeSet<String>>,
    items: Vec<String>,
    frame: Option<Frame>,
    /// Whether it is a whole run, with numbers of a user that may look like others.
    is_run: bool,
}

/// What an expression of the core's is: the name of its type, the type's arguments, and how it is made.
#[derive(Clone, Debug)]
pub(super) struct Constructor {
    /// The name of the type.
    pub name: &'static str,
    /// Its arguments, in angle brackets, or nothing.
    pub types: String,
    /// The expression.
    pub call: String,
}

impl Constructor {
    /// The whole type.
    pub fn of_type(&self) -> String {
        format!("{}{}", self.name, self.types)
    }

    /// How it is made: by a function of that name, which is added where it depends on the scalar.
    pub fn made(&self, module: &mut Module, name: &str, doc: &str) -> String {
        if self.types.is_empty() {
            return self.call.clone();
        }
        self.function(module, name, doc);
        format!("{name}()")
    }

    /// Adds a function that makes it.
    pub fn function(&self, module: &mut Module, name: &str, doc: &str) {
        let of_type = self.of_type();
        module.import("motes_core::scalar", ["Scalar"]);
        module.item(format!(
            "/// {doc}\npub fn {name}<S: Scalar>() -> {of_type} {{\n    {}\n}}\n",
            self.call
        ));
    }
}

impl Module {
    /// The module of a scenario; `command`: what makes it, for its first line.
    pub fn new(command: &str) -> Self {
        let command = command.split_whitespace().collect::<Vec<_>>().join(" ");
        let mut module = Self::default();
        module.say(&format!("Made by `{command}`, not by hand."));
        module.say("");
        module.say(
            "Before a device runs it in a scalar, `motes run` tells whether the scalar can hold it.",
        );
        module
    }

    /// Adds a line to its doc.
    pub fn say(&mut self, line: &str) {
        self.head.push(line.to_owned());
    }

    /// Imports names from a path.
    pub fn import<'n>(&mut self, path: &'static str, names: impl IntoIterator<Item = &'n str>) {
        let names = names.into_iter().map(str::to_owned);
        self.imports.entry(path).or_default().extend(names);
    }

    /// Adds an item.
    pub fn item(&mut self, text: impl Into<String>) {
        self.items.push(text.into());
    }

    /// Adds a public constant.
    pub fn constant(&mut self, doc: &str, name: &str, of_type: &str, value: &str) {
        self.item(format!(
            "/// {doc}\npub const {name}: {of_type} = {value};\n"
        ));
    }

    /// Adds the name of the scenario, and how many particles it has.
    pub fn cloud(&mut self, name: &str, particles: usize) {
        self.constant(
            "The name of the scenario.",
            "NAME",
            "&str",
            &format!("{name:?}"),
        );
        let particles = particles.to_string();
        self.constant("Number of particles.", "PARTICLES", "usize", &particles);
    }

    /// Adds how many cells its particles take, and one.
    pub fn cells(&mut self, cells: u64) {
        let cells = cells.to_string();
        self.constant("Cells they can take, and one.", "CELLS", "usize", &cells);
    }

    /// Adds the cut-off.
    pub fn cut_off(&mut self, cut_off: Named) {
        self.import("motes_core::cutoff", ["Named as CutOff"]);
        let cut_off = format!("CutOff::{cut_off:?}");
        self.constant("The cut-off.", "CUT_OFF", "CutOff", &cut_off);
    }

    /// Adds the way from the solver's numbers to those of formulas, `FRAME`, once.
    pub fn frame(&mut self, frame: Frame) {
        if self.frame.is_some() {
            return;
        }
        self.import("motes_core::cloud", ["Frame"]);
        self.import("motes_core::equation::linear::systems", ["Units"]);
        let (middle, units) = (frame.middle, frame.units);
        self.item(format!(
            "/// The way between the solver's numbers and those of the scenario.
pub const FRAME: Frame = Frame {{
    middle: {middle:?},
    units: Units {{
        length: {:?},
        velocity: {:?},
    }},
}};\n",
            units.length, units.velocity
        ));
        self.frame = Some(frame);
    }

    /// Says how the run that it is goes.
    pub fn run(&mut self) {
        self.is_run = true;
        for line in [
            "",
            "In memory that lies still, `static` on a device, and to the end:",
            "",
            "```ignore",
            "let mut run = start::<f32>(&mut memory)?;",
            "while run.step()?.is_some() {}",
            "run.state().digest() // that of `motes run` with this scalar",
            "```",
        ] {
            self.say(line);
        }
    }

    /// The text.
    pub fn text(&self) -> String {
        let mut head = String::new();
        for line in &self.head {
            let _ = writeln!(head, "{}", format!("//! {line}").trim_end());
        }
        let items = self.items.join("\n");
        if items.contains("libm::") {
            head += "//!\n//! It needs the crate `libm`, in the version of `motes-core`.\n";
        }
        if self.is_run {
            head += "#![allow(clippy::approx_constant)]\n";
        }
        let elementary = match items.contains("elementary::") {
            true => format!(
                "\n#[allow(dead_code, reason = \"formulas use some of it\")]
#[rustfmt::skip]
mod elementary {{\n{ELEMENTARY}}}\n"
            ),
            false => String::new(),
        };
        let mut imports: Vec<String> = self.imports.iter().map(|(p, n)| import(p, n)).collect();
        // As rustfmt has it: a list stands behind the modules beside it.
        imports.sort_unstable();
        format!("{head}\n{}\n{items}{elementary}", imports.concat())
    }
}

/// A line of imports, broken where it is too long.
fn import(path: &str, names: &BTreeSet<String>) -> String {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    if let [name] = names[..] {
        return format!("use {path}::{name};\n");
    }
    let line = format!("use {path}::{{{}}};\n", names.join(", "));
    if line.len() <= WIDTH + 1 {
        return line;
    }
    let mut text = format!("use {path}::{{\n");
    let mut row = String::new();
    for name in names {
        if row.len() + name.len() + 6 > WIDTH {
            let _ = writeln!(text, "   {row}");
            row.clear();
        }
        let _ = write!(row, " {name},");
    }
    let _ = writeln!(text, "   {row}");
    text + "};\n"
}

/// A number of a program.
pub(super) fn literal(value: f64) -> String {
    match value {
        f64::INFINITY => "f64::INFINITY".to_owned(),
        f64::NEG_INFINITY => "f64::NEG_INFINITY".to_owned(),
        _ => format!("{value:?}"),
    }
}

/// A number in the scalar of a run.
pub(super) fn number(value: f64) -> String {
    format!("S::from_f64({})", literal(value))
}

/// Numbers in the scalar of a run.
pub(super) fn vector(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|&value| number(value)).collect();
    format!("[{}]", values.join(", "))
}
