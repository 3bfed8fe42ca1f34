//! What a simulation has: its fields, its diagnostics, how it is drawn.

/// What a field of the particles holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Scalar,
    /// As many numbers as space has dimensions.
    Vector,
    /// A whole number: a count, a name.
    Integer,
}

/// A field of the particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Its name in files and on the command line.
    pub name: String,
    /// What it holds.
    pub kind: Kind,
    /// Its place among the values of a particle, that of its first component.
    pub first: usize,
    /// How many values it has.
    pub components: usize,
}

impl Field {
    /// Its place among the values of a particle.
    pub fn places(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.components
    }

    /// The names of its components: `name` itself where there is one.
    pub fn headings(&self) -> Vec<String> {
        match self.components {
            1 => vec![self.name.clone()],
            n => ["x", "y", "z"][..n]
                .iter()
                .map(|axis| format!("{}_{axis}", self.name))
                .collect(),
        }
    }

    /// Its value of a particle with these: the length of a vector.
    pub fn length(&self, values: &[f64]) -> f64 {
        match (self.kind, &values[self.places()]) {
            (Kind::Vector, vector) => vector.iter().map(|u| u * u).sum::<f64>().sqrt(),
            (_, value) => value[0],
        }
    }
}

/// What fields are drawn over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Abscissa {
    /// A coordinate.
    Along(usize),
    /// The distance from a point.
    From([f64; 3]),
}

/// How a simulation is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Over what.
    pub abscissa: Abscissa,
    /// What that is called.
    pub label: &'static str,
    /// How far from the line through the middle of the window a particle may be to be drawn over
    /// the abscissa; `None`: as far as it likes.
    pub half_width: Option<f64>,
    /// Whether the curve of the exact solution ends where it leaves the particles far behind: it
    /// would leave them no room.
    pub is_cut: bool,
    /// What the length of a vector is called on maps.
    pub length: &'static str,
}

/// What a simulation has, from its start to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// Particles at the start.
    pub particles: usize,
    /// Mean spacing at the start.
    pub spacing: f64,
    /// Duration.
    pub duration: f64,
    /// The fields of a particle, `position` first.
    pub fields: Vec<Field>,
    /// The fields that an exact solution has, by their places in `fields`.
    pub compared: Vec<usize>,
    /// Whether the compared fields are one state, which has an error of its own and a
    /// reconstruction.
    pub is_state: bool,
    /// The fields of a snapshot, by their places in `fields`.
    pub snapshot: Vec<usize>,
    /// What is measured between steps, beside time, steps and the last step.
    pub diagnostics: Vec<String>,
    /// The sums.
    pub sums: Vec<String>,
    /// Of which of them it is known what they should be: [`Simulation::expected`](super::Simulation).
    pub known: Vec<bool>,
    /// Whether all are conserved.
    pub is_conserving: bool,
    /// Why it is not known, where it is not.
    pub leak: &'static str,
    /// How it is drawn.
    pub view: View,
}

/// A field by its name and kind.
pub(crate) fn fields(dimension: usize, all: &[(&str, Kind)]) -> Vec<Field> {
    let mut first = 0;
    let field = |&(name, kind): &(&str, Kind)| {
        let components = match kind {
            Kind::Vector => dimension,
            Kind::Scalar | Kind::Integer => 1,
        };
        first += components;
        Field {
            name: name.to_owned(),
            kind,
            first: first - components,
            components,
        }
    };
    all.iter().map(field).collect()
}

impl Description {
    /// The field of that name.
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// How many values a particle has.
    pub fn width(&self) -> usize {
        self.fields.last().map_or(0, |field| field.places().end)
    }

    /// The names of the values of a particle.
    pub fn headings(&self) -> Vec<String> {
        self.fields.iter().flat_map(Field::headings).collect()
    }

    /// The fields that an exact solution has.
    pub fn compared(&self) -> impl Iterator<Item = &Field> {
        self.compared.iter().map(|&place| &self.fields[place])
    }

    /// The names of the values of an exact solution, with something before each.
    pub fn exact_headings(&self, before: &str) -> Vec<String> {
        let headings = self.compared().flat_map(Field::headings);
        headings.map(|name| format!("{before}{name}")).collect()
    }
}
