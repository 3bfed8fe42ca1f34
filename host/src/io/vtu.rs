//! A cloud of particles as an unstructured grid of VTK, for ParaView: one vertex for each
//! particle, data on the points (VTK file formats, "XML File Formats", UnstructuredGrid).

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataArray, DataSet, IOBuffer,
    UnstructuredGridPiece, Version, VertexNumbers, Vtk,
};

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

    /// The grid as VTK knows it.
    fn grid(&self) -> UnstructuredGridPiece {
        let vertices = self.positions.len() as u64;
        let scalars = self.scalars.iter().map(|(name, values)| {
            let values = IOBuffer::F64(values.clone());
            DataArray::new(*name, 1).with_buf(values)
        });
        let vectors = self.vectors.iter().map(|(name, values)| {
            let values = IOBuffer::F64(values.as_flattened().to_vec());
            DataArray::new(*name, 3).with_buf(values)
        });
        let integers = self.integers.iter().map(|(name, values)| {
            let values = IOBuffer::U32(values.clone());
            DataArray::new(*name, 1).with_buf(values)
        });
        let fields = scalars.chain(vectors).chain(integers);
        UnstructuredGridPiece {
            points: IOBuffer::F64(self.positions.as_flattened().to_vec()),
            cells: Cells {
                cell_verts: VertexNumbers::XML {
                    connectivity: (0..vertices).collect(),
                    offsets: (1..=vertices).collect(),
                },
                types: vec![CellType::Vertex; self.positions.len()],
            },
            data: Attributes {
                point: fields.map(Attribute::DataArray).collect(),
                cell: vec![],
            },
        }
    }
}

/// Writes a `.vtu` file: values as base64, every bit kept; the time as `TimeValue`.
///
/// # Errors
/// A field that is not as long as the positions, or two of one name; a file that cannot be made.
pub fn write_vtu(path: &Path, cloud: &Cloud<'_>) -> Result<(), WriteError> {
    cloud
        .check()
        .map_err(|error| WriteError::new(path, error))?;
    let vtk = Vtk {
        version: Version::new((1, 0)),
        // Whatever machine writes: the same bytes.
        byte_order: ByteOrder::LittleEndian,
        title: String::new(),
        file_path: None,
        data: DataSet::inline(cloud.grid()),
    };
    whole(path, |file| {
        let mut text = Vec::new();
        vtk.write_xml(&mut text)?;
        let (head, rest) = text.split_at(piece(&text)?);
        file.write_all(head)?;
        file.write_all(time_value(cloud.time).as_bytes())?;
        file.write_all(PIECE)?;
        if cloud.positions.is_empty() {
            // vtkio leaves a count of 0 out, and VTK then refuses the file.
            file.write_all(b" NumberOfCells=\"0\"")?;
        }
        file.write_all(&rest[PIECE.len()..])
    })
}

/// The time as ParaView looks for it; vtkio leaves field data out.
fn time_value(time: f64) -> String {
    format!(
        "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" \
         format=\"ascii\">{time:?}</DataArray></FieldData>"
    )
}

const PIECE: &[u8] = b"<Piece";

/// Where the one piece of the grid starts.
fn piece(text: &[u8]) -> std::io::Result<usize> {
    let start = text.windows(PIECE.len()).position(|part| part == PIECE);
    start.ok_or_else(|| invalid("vtkio wrote no piece".to_owned()))
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
    use vtkio::model::Piece;

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

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|x| x.to_bits()).collect()
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

        let vtk = Vtk::import(&path).unwrap();
        let DataSet::UnstructuredGrid { mut pieces, .. } = vtk.data else {
            panic!("not an unstructured grid");
        };
        let Piece::Inline(piece) = pieces.remove(0) else {
            panic!("not inline");
        };
        let points = piece.points.into_vec::<f64>().unwrap();
        assert_eq!(bits(&points), bits(positions.as_flattened()));
        assert_eq!(piece.cells.types, vec![CellType::Vertex; 5]);
        let topology = VertexNumbers::XML {
            connectivity: vec![0, 1, 2, 3, 4],
            offsets: vec![1, 2, 3, 4, 5],
        };
        assert_eq!(piece.cells.cell_verts, topology);

        let mut read = piece.data.point.into_iter().map(|field| match field {
            Attribute::DataArray(array) => array,
            Attribute::Field { name, .. } => panic!("{name} is no array"),
        });
        for (name, values) in &scalars {
            let array = read.next().unwrap();
            assert_eq!((array.name, array.elem.num_comp()), ((*name).to_owned(), 1));
            assert_eq!(bits(&array.data.into_vec().unwrap()), bits(values));
        }
        for (name, values) in &vectors {
            let array = read.next().unwrap();
            assert_eq!((array.name.as_str(), array.num_comp()), (*name, 3));
            let expected = bits(values.as_flattened());
            assert_eq!(bits(&array.data.into_vec().unwrap()), expected);
        }
        for (name, values) in &integers {
            let array = read.next().unwrap();
            assert_eq!((array.name.as_str(), array.num_comp()), (*name, 1));
            assert_eq!(&array.data.into_vec::<u32>().unwrap(), values);
        }
        assert!(read.next().is_none());
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
            std::fs::read_to_string(path).unwrap()
        };
        let first = text("a.vtu", &cloud);
        assert_eq!(first, text("b.vtu", &cloud));
        assert!(first.contains(">0.125</DataArray></FieldData><Piece"));
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
        let text = std::fs::read_to_string(path).unwrap();
        for count in ["NumberOfPoints", "NumberOfCells"] {
            assert!(
                text.contains(&format!(" {count}=\"0\"")),
                "VTK needs {count}"
            );
        }
        Vtk::parse_xml(text.as_bytes()).unwrap();
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
