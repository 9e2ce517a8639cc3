//! Particles as PLY, the Stanford polygon format (binary, little endian), which mesh viewers and point cloud programs
//! read.

use allotrope_solvers::Simulation;

use crate::lab::errors::LabError;

/// The lines before the data: a comment, the number of points, and the properties of each by type and name.
fn header(comment: &str, count: usize, properties: &[(&str, &str)]) -> Vec<u8> {
    let properties: String = properties.iter().map(|(kind, name)| format!("property {kind} {name}\n")).collect();
    format!("ply\nformat binary_little_endian 1.0\ncomment {comment}\nelement vertex {count}\n{properties}end_header\n")
        .into_bytes()
}

/// The particles in the order in which they were given: `x y z` in metres (in 2D `z` is zero), `vx vy vz` in m/s,
/// `pressure` in Pa where they have one, `material`.
pub fn particles(simulation: &dyn Simulation) -> Vec<u8> {
    let count = simulation.particles();
    let pressures = simulation.pressures();
    let floats = ["x", "y", "z", "vx", "vy", "vz", "pressure"].map(|name| ("float", name));
    let floats = if pressures.is_empty() { &floats[..6] } else { &floats[..] };
    let properties = [floats, &[("uint", "material")]].concat();
    let mut bytes = header(&format!("step {}, time {} s", simulation.steps(), simulation.time()), count, &properties);
    bytes.reserve(4 * properties.len() * count);
    let motion = simulation.positions().into_iter().zip(simulation.velocities());
    for (n, ((x, v), material)) in motion.zip(simulation.material_of()).enumerate() {
        for value in x.into_iter().chain(v).chain(pressures.get(n).copied()) {
            bytes.extend_from_slice(&(value as f32).to_le_bytes());
        }
        bytes.extend_from_slice(&material.to_le_bytes());
    }
    bytes
}

/// Points of one's own: `x y z`, and any number of values that have names, each as long as there are points.
///
/// # Errors
/// If a name is no single word of ASCII or is used twice, or there are more or fewer values than points.
///
/// ```
/// use allotrope_lab::lab::export::ply;
///
/// let file = ply::points("two points", &[[0.0; 3], [1.0; 3]], &[("heat", &[20.0, 25.0])]).unwrap();
/// assert_eq!(file.len() - file.windows(11).position(|bytes| bytes == b"end_header\n").unwrap() - 11, 2 * 4 * 4);
/// ```
pub fn points(comment: &str, positions: &[[f32; 3]], values: &[(&str, &[f32])]) -> Result<Vec<u8>, LabError> {
    let mut properties = ["x", "y", "z"].map(|name| ("float", name)).to_vec();
    for &(name, values) in values {
        let fault = |why: String| Err(LabError::usage(format!("`{name}` cannot be written as PLY: {why}")));
        if name.is_empty() || !name.bytes().all(|byte| byte.is_ascii_graphic()) {
            return fault("a name is one word of letters, digits and signs".into());
        }
        if properties.contains(&("float", name)) {
            return fault("the name is used twice".into());
        }
        if values.len() != positions.len() {
            return fault(format!("there are {} values of {} points", values.len(), positions.len()));
        }
        properties.push(("float", name));
    }
    // A line of its own: whatever follows a break would be read as the header's next line.
    let comment = comment.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut bytes = header(&comment, positions.len(), &properties);
    for (n, position) in positions.iter().enumerate() {
        for value in position.iter().copied().chain(values.iter().map(|(_, values)| values[n])) {
            bytes.extend_from_slice(&value.to_le_bytes());
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_written_with_their_values() {
        let positions = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
        let file = points("two\nlines", &positions, &[("a", &[7.0, 8.0]), ("b", &[9.0, 10.0])]).unwrap();
        let header = "ply\nformat binary_little_endian 1.0\ncomment two lines\nelement vertex 2\nproperty float \
                      x\nproperty float y\nproperty float z\nproperty float a\nproperty float b\nend_header\n";
        let (read, data) = file.split_at(header.len());
        assert_eq!(std::str::from_utf8(read), Ok(header));
        let numbers: Vec<f32> = data.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
        assert_eq!(numbers, [1.0, 2.0, 3.0, 7.0, 9.0, 4.0, 5.0, 6.0, 8.0, 10.0]);
    }

    #[test]
    fn what_readers_would_misread_is_refused() {
        let refused = |values: &[(&str, &[f32])]| points("", &[[0.0; 3]], values).unwrap_err().to_string();
        let message = "`a b` cannot be written as PLY: a name is one word of letters, digits and signs";
        assert_eq!(refused(&[("a b", &[1.0])]), message);
        assert_eq!(refused(&[("x", &[1.0])]), "`x` cannot be written as PLY: the name is used twice");
        assert_eq!(refused(&[("a", &[])]), "`a` cannot be written as PLY: there are 0 values of 1 points");
    }
}
