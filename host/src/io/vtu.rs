//! A cloud of particles as an unstructured grid of VTK, for ParaView: one vertex for each
//! particle, data on the points (VTK file formats, "XML File Formats", UnstructuredGrid).

use std::collections::BTreeSet;
use std::io::{BufWriter, Write};
use std::ops::Range;
use std::path::Path;

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;

use super::table::{WriteError, whole};

/// Particles at one time: fields by name, each with one value for each particle.
#[derive(Clone, Copy, Debug)]
pub struct Cloud<'a> {
    /// Positions; components beyond the dimension of space are 0.
    pub positions: &'a [[f64; 3]],
    /// Fields of one number: density, pressure ...
    pub scalars: &'a [(&'a str, Vec<f64>)],
    /// Fields of three components: velocity ...
    pub vectors: &'a [(&'a str, Vec<[f64; 3]>)],
    /// Fields of counts and names: ids, neighbours, materials ...
    pub integers: &'a [(&'a str, Vec<u32>)],
    /// The time.
    pub time: f64,
}

impl Cloud<'_> {
    /// Whether it can be written: every field as long as the positions, under a name of its own.
    pub(super) fn check(&self) -> std::io::Result<()> {
        let particles = self.positions.len();
        if u32::try_from(particles).is_err() {
            return Err(invalid(format!(
                "{particles} particles: need at most {}",
                u32::MAX
            )));
        }
        let scalars = self.scalars.iter().map(|(name, v)| (*name, v.len()));
        let vectors = self.vectors.iter().map(|(name, v)| (*name, v.len()));
        let integers = self.integers.iter().map(|(name, v)| (*name, v.len()));
        let mut names = BTreeSet::new();
        for (name, values) in scalars.chain(vectors).chain(integers) {
            if values != particles {
                return Err(invalid(format!(
                    "field {name:?} has {values} values for {particles} particles"
                )));
            }
            if name.is_empty() || name.contains(char::is_control) {
                return Err(invalid(format!("{name:?} is not a name for a field")));
            }
            if !names.insert(name) {
                return Err(invalid(format!("two fields are called {name:?}")));
            }
        }
        Ok(())
    }

    /// The arrays of the file, in its order.
    fn arrays(&self) -> Vec<Array<'_>> {
        let mut arrays = Vec::new();
        let mut add = |part, name, components, values| {
            arrays.push(Array {
                part,
                name,
                components,
                values,
            });
        };
        for (name, values) in self.scalars {
            add(GridPart::PointData, *name, 1, Numbers::Floats(values));
        }
        for (name, values) in self.vectors {
            let values = values.as_flattened();
            add(GridPart::PointData, *name, 3, Numbers::Floats(values));
        }
        for (name, values) in self.integers {
            add(GridPart::PointData, *name, 1, Numbers::Integers(values));
        }
        let positions = self.positions.as_flattened();
        add(GridPart::Points, "Points", 3, Numbers::Floats(positions));
        let n = self.positions.len() as u64;
        add(GridPart::Cells, "connectivity", 1, Numbers::Count(0..n));
        add(GridPart::Cells, "offsets", 1, Numbers::Count(1..n + 1));
        add(GridPart::Cells, "types", 1, Numbers::Vertices(n));
        arrays
    }
}

/// A part of a piece of a grid.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GridPart {
    PointData,
    Points,
    Cells,
}

impl GridPart {
    const ALL: [Self; 3] = [Self::PointData, Self::Points, Self::Cells];

    fn tag(self) -> &'static str {
        match self {
            Self::PointData => "PointData",
            Self::Points => "Points",
            Self::Cells => "Cells",
        }
    }
}

/// An array of the file.
struct Array<'a> {
    part: GridPart,
    name: &'a str,
    components: usize,
    values: Numbers<'a>,
}

/// What an array holds.
enum Numbers<'a> {
    Floats(&'a [f64]),
    Integers(&'a [u32]),
    /// Whole numbers one after the other.
    Count(Range<u64>),
    /// So many cells of one point each, which VTK calls 1.
    Vertices(u64),
}

impl Numbers<'_> {
    /// The name of their type.
    fn kind(&self) -> &'static str {
        match self {
            Self::Floats(_) => "Float64",
            Self::Integers(_) => "UInt32",
            Self::Count(_) => "Int64",
            Self::Vertices(_) => "UInt8",
        }
    }

    /// How many bytes they are.
    fn bytes(&self) -> u64 {
        match self {
            Self::Floats(values) => 8 * values.len() as u64,
            Self::Integers(values) => 4 * values.len() as u64,
            Self::Count(range) => 8 * (range.end - range.start),
            Self::Vertices(cells) => *cells,
        }
    }

    /// Writes them, least significant byte first.
    fn write(&self, file: &mut impl Write) -> std::io::Result<()> {
        match self {
            Self::Floats(values) => values
                .iter()
                .try_for_each(|x| file.write_all(&x.to_le_bytes())),
            Self::Integers(values) => values
                .iter()
                .try_for_each(|n| file.write_all(&n.to_le_bytes())),
            Self::Count(range) => range
                .clone()
                .try_for_each(|n| file.write_all(&n.to_le_bytes())),
            Self::Vertices(cells) => (0..*cells).try_for_each(|_| file.write_all(&[1])),
        }
    }
}

/// Writes a `.vtu` file: values as base64, every bit kept; the time as `TimeValue`.
///
/// Not appended as they are: meshio finds the wrong array at some offsets of such a file.
///
/// # Errors
/// A field that is not as long as the positions, or two of one name; a file that cannot be made.
pub fn write_vtu(path: &Path, cloud: &Cloud<'_>) -> Result<(), WriteError> {
    cloud
        .check()
        .map_err(|error| WriteError::new(path, error))?;
    whole(path, |file| write_grid(&mut BufWriter::new(file), cloud))
}

fn write_grid(file: &mut impl Write, cloud: &Cloud<'_>) -> std::io::Result<()> {
    let (arrays, n, time) = (cloud.arrays(), cloud.positions.len(), cloud.time);
    // Whatever machine writes: the same bytes.
    write!(
        file,
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<UnstructuredGrid>\n\
         <FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" \
         format=\"ascii\">{time:?}</DataArray></FieldData>\n\
         <Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{n}\">\n"
    )?;
    for part in GridPart::ALL {
        writeln!(file, "<{}>", part.tag())?;
        for array in arrays.iter().filter(|array| array.part == part) {
            let (kind, name) = (array.values.kind(), escaped(array.name));
            write!(file, "<DataArray type=\"{kind}\" Name=\"{name}\"")?;
            // meshio makes columns of numbers where they are said to have one component.
            if array.components > 1 {
                write!(file, " NumberOfComponents=\"{}\"", array.components)?;
            }
            file.write_all(b" format=\"binary\">")?;
            // How many bytes follow, and the bytes, in one.
            let mut encoder = EncoderWriter::new(&mut *file, &STANDARD);
            encoder.write_all(&array.values.bytes().to_le_bytes())?;
            array.values.write(&mut encoder)?;
            encoder.finish()?;
            drop(encoder);
            file.write_all(b"</DataArray>\n")?;
        }
        writeln!(file, "</{}>", part.tag())?;
    }
    file.write_all(b"</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")?;
    file.flush()
}

/// Text as the value of an XML attribute, or between tags.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn invalid(text: String) -> std::io::Error {
    std::io::Error::new(std::io::ErrorKind::InvalidInput, text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use base64::Engine;

    /// Numbers that a conversion to text or to 32 bits would change.
    const AWKWARD: [f64; 5] = [0.1, -0.0, 5e-324, f64::MAX, f64::NAN];

    type Fields = (
        Vec<[f64; 3]>,
        [(&'static str, Vec<f64>); 2],
        [(&'static str, Vec<[f64; 3]>); 1],
        [(&'static str, Vec<u32>); 1],
    );

    fn fields() -> Fields {
        let positions = AWKWARD.map(|x| [x, 1.0 / 3.0, -x]).to_vec();
        let turned = AWKWARD.map(|x| 0.7 * x).to_vec();
        (
            positions,
            [("density", AWKWARD.to_vec()), ("a < b & \"c\"", turned)],
            [("velocity", AWKWARD.map(|x| [1e300, x, x / 3.0]).to_vec())],
            [("id", vec![0, 7, 1 << 31, u32::MAX, 1])],
        )
    }

    #[test]
    fn a_file_read_back_holds_the_same_bits() {
        let (positions, scalars, vectors, integers) = fields();
        let cloud = Cloud {
            positions: &positions,
            scalars: &scalars,
            vectors: &vectors,
            integers: &integers,
            time: 0.1,
        };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cloud.vtu");
        write_vtu(&path, &cloud).unwrap();

        let bytes = std::fs::read(&path).unwrap();
        let arrays = read(&bytes);
        let names: Vec<&str> = arrays.iter().map(|array| array.name.as_str()).collect();
        let expected =
            "density,a &lt; b &amp; &quot;c&quot;,velocity,id,Points,connectivity,offsets,types";
        assert_eq!(names.join(","), expected);
        let floats =
            |values: &[f64]| -> Vec<u8> { values.iter().flat_map(|x| x.to_le_bytes()).collect() };
        let counts =
            |values: [u64; 5]| -> Vec<u8> { values.iter().flat_map(|n| n.to_le_bytes()).collect() };
        let integers: Vec<u8> = integers[0].1.iter().flat_map(|n| n.to_le_bytes()).collect();
        let expected = [
            ("Float64", "1", floats(&scalars[0].1)),
            ("Float64", "1", floats(&scalars[1].1)),
            ("Float64", "3", floats(vectors[0].1.as_flattened())),
            ("UInt32", "1", integers),
            ("Float64", "3", floats(positions.as_flattened())),
            ("Int64", "1", counts([0, 1, 2, 3, 4])),
            ("Int64", "1", counts([1, 2, 3, 4, 5])),
            ("UInt8", "1", vec![1; 5]),
        ];
        for (array, (kind, components, values)) in arrays.iter().zip(expected) {
            assert_eq!(array.kind, kind, "{}", array.name);
            assert_eq!(array.components, components, "{}", array.name);
            assert_eq!(array.values, values, "{}", array.name);
        }
    }

    /// An array of a file, as its attributes say.
    struct Read {
        name: String,
        kind: String,
        components: String,
        values: Vec<u8>,
    }

    /// The arrays of a file.
    fn read(bytes: &[u8]) -> Vec<Read> {
        let text = std::str::from_utf8(bytes).unwrap();
        let binary = text.split("<DataArray ").skip(2);
        let arrays = binary.map(|tag| {
            let attribute = |name: &str| {
                let (_, rest) = tag.split_once(&format!("{name}=\"")).unwrap();
                rest.split_once('"').unwrap().0.to_owned()
            };
            assert_eq!(attribute("format"), "binary");
            let (_, rest) = tag.split_once('>').unwrap();
            let (encoded, _) = rest.split_once('<').unwrap();
            let decoded = STANDARD.decode(encoded).unwrap();
            let (length, values) = decoded.split_at(8);
            let length = u64::from_le_bytes(length.try_into().unwrap()) as usize;
            assert_eq!(length, values.len());
            Read {
                name: attribute("Name"),
                kind: attribute("type"),
                components: match tag.contains("NumberOfComponents") {
                    true => attribute("NumberOfComponents"),
                    false => "1".to_owned(),
                },
                values: values.to_vec(),
            }
        });
        arrays.collect()
    }

    #[test]
    fn equal_clouds_are_equal_files_and_carry_their_time() {
        let (positions, scalars, vectors, integers) = fields();
        let cloud = Cloud {
            positions: &positions,
            scalars: &scalars,
            vectors: &vectors,
            integers: &integers,
            time: 0.125,
        };
        let folder = tempfile::tempdir().unwrap();
        let text = |name: &str, cloud: &Cloud<'_>| {
            let path = folder.path().join(name);
            write_vtu(&path, cloud).unwrap();
            std::fs::read(path).unwrap()
        };
        let first = text("a.vtu", &cloud);
        assert_eq!(first, text("b.vtu", &cloud));
        let head = String::from_utf8_lossy(&first).into_owned();
        assert!(
            head.contains("\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.125</DataArray>")
        );
        let later = Cloud {
            time: 0.25,
            ..cloud
        };
        assert_ne!(first, text("c.vtu", &later));
    }

    #[test]
    fn no_particles_are_a_file_too() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("none.vtu");
        let cloud = Cloud {
            positions: &[],
            scalars: &[("density", vec![])],
            vectors: &[],
            integers: &[],
            time: 0.0,
        };
        write_vtu(&path, &cloud).unwrap();
        let bytes = std::fs::read(path).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        for count in ["NumberOfPoints", "NumberOfCells"] {
            assert!(
                text.contains(&format!(" {count}=\"0\"")),
                "VTK needs {count}"
            );
        }
        assert!(read(&bytes).iter().all(|array| array.values.is_empty()));
    }

    #[test]
    fn unequal_lengths_and_equal_names_are_errors_and_leave_no_file() {
        let positions = [[0.0; 3]; 2];
        let good = Cloud {
            positions: &positions,
            scalars: &[],
            vectors: &[],
            integers: &[],
            time: 0.0,
        };
        let scalars = [("density", vec![1.0])];
        let vectors = [("velocity", vec![[0.0; 3]; 3])];
        let integers = [("id", vec![])];
        let twice = [("mass", vec![1.0; 2]), ("mass", vec![2.0; 2])];
        let with = |scalars| Cloud { scalars, ..good };
        let folder = tempfile::tempdir().unwrap();
        for (cloud, expected) in [
            (with(&scalars), "\"density\" has 1 values for 2 particles"),
            (
                Cloud {
                    vectors: &vectors,
                    ..good
                },
                "\"velocity\" has 3 values",
            ),
            (
                Cloud {
                    integers: &integers,
                    ..good
                },
                "\"id\" has 0 values",
            ),
            (with(&twice), "two fields are called \"mass\""),
        ] {
            let error = write_vtu(&folder.path().join("x.vtu"), &cloud).unwrap_err();
            let source = std::error::Error::source(&error).unwrap().to_string();
            assert!(source.contains(expected), "{source}");
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
