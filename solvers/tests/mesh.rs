//! Meshes: read, checked, measured and filled.

#[path = "mesh/distance.rs"]
mod distance;
#[path = "mesh/formats.rs"]
mod formats;

use allotrope_solvers::mesh::read_obj;

const BUNNY: &[u8] = include_bytes!("../scenes/bunny.obj");

/// A unit cube of quadrilaterals, away from the origin, with some faces left out.
fn cube(faces: &[usize]) -> String {
    let mut text = String::new();
    for n in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(n >> axis & 1) + 10.0);
        text += &format!("v {x} {y} {z}\n");
    }
    let all = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"];
    for &face in faces {
        text += &format!("f {}\n", all[face]);
    }
    text
}

fn fault(text: &str) -> String {
    read_obj(text.as_bytes()).and_then(|mesh| mesh.closed()).unwrap_err().to_string()
}

#[test]
fn the_bunny_has_its_volume_and_is_filled_to_within_a_percent() {
    let bunny = read_obj(BUNNY).unwrap().closed().unwrap();
    assert!((bunny.volume() - 194.288).abs() < 1e-3, "{}", bunny.volume());
    for spacing in [0.4, 0.25, 0.15625] {
        let points = bunny.fill(spacing);
        let ratio = points.len() as f64 * spacing.powi(3) / bunny.volume();
        assert!((ratio - 1.0).abs() < 0.01, "spacing {spacing}: {ratio}");
        let (low, high) = bunny.bounds();
        assert!(points.iter().all(|x| (0..3).all(|axis| low[axis] < x[axis] && x[axis] < high[axis])));
    }
}

#[test]
fn scaling_and_moving_keep_what_is_inside() {
    let bunny = read_obj(BUNNY).unwrap().closed().unwrap();
    let count = bunny.fill(0.4).len();
    let placed = bunny.clone().placed(0.05, [0.5, 0.26, 0.5]);
    assert!((placed.volume() - bunny.volume() * 0.05f64.powi(3)).abs() < 1e-12);
    assert!(placed.fill(0.4 * 0.05).len().abs_diff(count) <= count / 500);
}

#[test]
fn a_cube_is_filled_exactly_though_rays_run_along_its_edges() {
    let cube = read_obj(cube(&[0, 1, 2, 3, 4, 5]).as_bytes()).unwrap().closed().unwrap();
    assert!((cube.volume() - 1.0).abs() < 1e-12);
    // Lattices whose rays meet the diagonals of faces, and one with a point on the cube's middle lines.
    for n in [1, 2, 3, 4, 5, 8, 16] {
        let points = cube.fill(1.0 / f64::from(n));
        assert_eq!(points.len(), (n * n * n) as usize, "{n} points a side");
    }
}

#[test]
fn an_octahedron_with_vertices_on_rays_is_filled_inside_only() {
    let text = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
                f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    let mesh = read_obj(text.as_bytes()).unwrap().closed().unwrap();
    assert!((mesh.volume() - 4.0 / 3.0).abs() < 1e-12);
    for (spacing, tolerance) in [(0.4, 0.25), (0.08, 0.03), (0.016, 0.003)] {
        let points = mesh.fill(spacing);
        assert!(points.iter().all(|[x, y, z]| x.abs() + y.abs() + z.abs() <= 1.0 + 1e-9));
        let ratio = points.len() as f64 * f64::powi(spacing, 3) * 0.75;
        assert!((ratio - 1.0).abs() < tolerance, "spacing {spacing}: {ratio}");
    }
}

#[test]
fn open_meshes_are_refused_with_number_and_place() {
    assert_eq!(
        fault(&cube(&[0, 1, 2, 3, 4])),
        "is not closed: 4 edges open, with a face on one side only, the first from (11, 11, 10) to (11, 10, 10)"
    );
    assert_eq!(fault("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").split(',').next(), Some("is not closed: 3 edges open"));
}

#[test]
fn faces_of_mixed_orientation_and_crowded_edges_are_refused() {
    let turned = cube(&[0, 1, 2, 3, 4]) + "f 2 6 8 4\n";
    assert!(
        fault(&turned)
            .starts_with("is not closed: 4 edges between faces of opposite orientation, the first from (11, 11, 10)")
    );
    let crowded = cube(&[0, 1, 2, 3, 4, 5, 5]);
    assert!(fault(&crowded).contains("edges shared by more than two faces"));
}

#[test]
fn vertices_written_once_a_face_are_welded() {
    let text = cube(&[0, 1, 2, 3, 4, 5]);
    let vertices: Vec<&str> = text.lines().filter(|line| line.starts_with('v')).collect();
    let mut split = String::new();
    let mut count = 0;
    for face in text.lines().filter_map(|line| line.strip_prefix("f ")) {
        for corner in face.split(' ') {
            split += &format!("{}\n", vertices[corner.parse::<usize>().unwrap() - 1]);
        }
        split += &format!("f {} {} {} {}\n", count + 1, count + 2, count + 3, count + 4);
        count += 4;
    }
    assert!((read_obj(split.as_bytes()).unwrap().closed().unwrap().volume() - 1.0).abs() < 1e-12);
}

#[test]
fn what_is_no_mesh_is_refused() {
    assert_eq!(fault(""), "has no faces");
    assert!(fault("v 1 2\nf 1 1 1\n").starts_with("is not a readable OBJ file"));
    assert!(fault("v 0 0 0\nf 1 2 3\n").starts_with("is not a readable OBJ file"));
    assert!(fault("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").starts_with("has a vertex that is not finite"));
}
