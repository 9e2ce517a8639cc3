//! Particles and grids as VTK's XML files, which ParaView and others read: `.vtp`, `.vti`, and `.pvd` for a series.
//!
//! Arrays lie behind the XML, appended raw, little endian, each after its number of bytes in 64 bits.

use allotrope_solvers::{Array, Simulation, Values};

/// The particles in the order in which they were given, as points (`.vtp`), each a vertex: `position` is the points
/// themselves, all other arrays of the particles are data of points. Vectors of a plane have a third component of zero.
pub fn particles(simulation: &dyn Simulation) -> Vec<u8> {
    let count = simulation.particles();
    let arrays = simulation.particle_arrays();
    let (points, others): (Vec<_>, Vec<_>) = arrays.iter().partition(|array| array.name == "position");
    let mut file = File::default();
    let points: String = points.into_iter().map(|array| file.array(array, |n| n)).collect();
    let data: String = others.into_iter().map(|array| file.array(array, |n| n)).collect();
    let connectivity = file.element("Int32", "connectivity", 1, (0..count as u32).flat_map(u32::to_le_bytes));
    let offsets = file.element("Int32", "offsets", 1, (1..=count as u32).flat_map(u32::to_le_bytes));
    file.finish(
        "PolyData",
        &format!(
            "<PolyData>\n{}<Piece NumberOfPoints=\"{count}\" NumberOfVerts=\"{count}\" NumberOfLines=\"0\" \
             NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n{data}</PointData>\n<Points>\n{points}</Points>\n\
             <Verts>\n{connectivity}{offsets}</Verts>\n</Piece>\n</PolyData>\n",
            time(simulation)
        ),
    )
}

/// The nodes of the grid as an image (`.vti`) that begins at the origin, one cell apart; its arrays are data of points.
/// Vectors of a plane have a third component of zero.
pub fn grid(simulation: &dyn Simulation) -> Vec<u8> {
    let mut shape = simulation.grid_shape();
    shape.resize(3, 1);
    let cell = simulation.extent()[0] / shape[0] as f64;
    // The simulation's last axis is the fastest, here it is the first.
    let [columns, rows, layers] = [shape[0], shape[1], shape[2]];
    let place = |n: usize| (n % columns * rows + n / columns % rows) * layers + n / (columns * rows);
    let mut file = File::default();
    let data: String = simulation.grid_arrays().iter().map(|array| file.array(array, place)).collect();
    let extent = format!("0 {} 0 {} 0 {}", columns - 1, rows - 1, layers - 1);
    file.finish(
        "ImageData",
        &format!(
            "<ImageData WholeExtent=\"{extent}\" Origin=\"0 0 0\" Spacing=\"{cell} {cell} {cell}\">\n{}<Piece \
             Extent=\"{extent}\">\n<PointData>\n{data}</PointData>\n</Piece>\n</ImageData>\n",
            time(simulation)
        ),
    )
}

/// The series of files (`.pvd`) that ParaView plays: the time in seconds of each, and its name from the folder of the
/// series on.
pub fn pvd(entries: &[(f64, String)]) -> String {
    let sets: String = entries
        .iter()
        .map(|(time, file)| {
            format!("<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{}\"/>\n", escaped(file))
        })
        .collect();
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
         <Collection>\n{sets}</Collection>\n</VTKFile>\n"
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The simulated seconds, as ParaView finds them in a single file.
fn time(simulation: &dyn Simulation) -> String {
    format!(
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}\
         </DataArray>\n</FieldData>\n",
        simulation.time()
    )
}

/// What is appended to the XML.
#[derive(Default)]
struct File {
    appended: Vec<u8>,
}

impl File {
    /// Appends an array whose element `n` of the file is the element `place(n)` that it holds.
    fn array(&mut self, array: &Array, place: impl Fn(usize) -> usize) -> String {
        match &array.values {
            Values::F32(values) => self.values(array, "Float32", values, f32::to_le_bytes, place),
            Values::F64(values) => self.values(array, "Float64", values, f64::to_le_bytes, place),
            Values::U32(values) => self.values(array, "UInt32", values, u32::to_le_bytes, place),
        }
    }

    fn values<T: Copy, const N: usize>(
        &mut self,
        array: &Array,
        kind: &str,
        values: &[T],
        bytes: fn(T) -> [u8; N],
        place: impl Fn(usize) -> usize,
    ) -> String {
        let components = array.components;
        let padding: &[u8] = if components == 2 { &[0; N] } else { &[] };
        let elements = (0..values.len() / components).flat_map(|n| {
            let element = &values[place(n) * components..][..components];
            element.iter().flat_map(move |&value| bytes(value)).chain(padding.iter().copied())
        });
        self.element(kind, array.name, if components == 2 { 3 } else { components }, elements)
    }

    /// Appends bytes, and gives the XML element that tells where they are.
    fn element(&mut self, kind: &str, name: &str, components: usize, bytes: impl Iterator<Item = u8>) -> String {
        let offset = self.appended.len();
        self.appended.extend([0; 8]);
        self.appended.extend(bytes);
        let length = (self.appended.len() - offset - 8) as u64;
        self.appended[offset..offset + 8].copy_from_slice(&length.to_le_bytes());
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" \
             offset=\"{offset}\"/>\n"
        )
    }

    fn finish(self, kind: &str, content: &str) -> Vec<u8> {
        let head = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n{content}<AppendedData encoding=\"raw\">\n_"
        );
        [head.as_bytes(), &self.appended, b"\n</AppendedData>\n</VTKFile>\n"].concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_names_times_and_files() {
        let text = pvd(&[(0.0, "a_0000.vtp".into()), (0.025, "b & \"c\".vtp".into())]);
        let sets: Vec<&str> = text.lines().filter(|line| line.starts_with("<DataSet")).collect();
        let wanted = [
            r#"<DataSet timestep="0" group="" part="0" file="a_0000.vtp"/>"#,
            r#"<DataSet timestep="0.025" group="" part="0" file="b &amp; &quot;c&quot;.vtp"/>"#,
        ];
        assert_eq!(sets, wanted);
    }

    #[test]
    fn arrays_follow_each_other_after_their_lengths() {
        let mut file = File::default();
        let plane = Array { name: "velocity", components: 2, values: Values::F32(vec![1.0, 2.0, 3.0, 4.0]) };
        let number = Array { name: "material", components: 1, values: Values::U32(vec![7, 8]) };
        assert!(file.array(&plane, |n| 1 - n).contains("NumberOfComponents=\"3\" format=\"appended\" offset=\"0\""));
        assert!(file.array(&number, |n| n).contains("type=\"UInt32\" Name=\"material\""));
        let (length, rest) = file.appended.split_first_chunk().unwrap();
        assert_eq!(u64::from_le_bytes(*length), 24);
        let floats: Vec<f32> = rest[..24].as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
        assert_eq!(floats, [3.0, 4.0, 0.0, 1.0, 2.0, 0.0]);
        assert_eq!(rest[24..], [8, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 8, 0, 0, 0]);
    }
}
