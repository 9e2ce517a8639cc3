//! From a closed mesh to particles: a body is filled with points, kernels weigh it, and it is written for viewers.
//! `cargo run --release --example mesh_to_particles [MESH [FOLDER]]`, where the mesh is an OBJ, PLY or STL file

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use allotrope::prelude::*;
use allotrope_lab::lab::errors::{self, LabError};
use allotrope_lab::lab::export::ply;
use allotrope_lab::lab::output;
use allotrope_lab::lab::render::Picture;
use allotrope_solvers::mesh::{self, ClosedMesh};

/// A point of the body.
#[derive(Record, Clone, Copy, Default)]
pub struct Point {
    /// Where it is.
    pub position: DVec3,
    /// From the centre of mass.
    pub distance: f32,
}

/// What the points say of the body, at density one.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// The volume of all points.
    pub volume: f64,
    /// The mean of their positions.
    pub centre: DVec3,
    /// The corners of the box around them.
    pub bounds: [DVec3; 2],
    /// The moments of inertia about the centre: of the axes, on the diagonal, and the products.
    pub inertia: DMat3,
}

/// Weighs the body, of whose volume each point has a share, and notes each point's distance from the centre of mass.
#[kernel]
pub fn weigh(points: &mut Field<Point, _>, share: f64) -> Body {
    let mut sum = DVec3::ZERO;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for p in points {
        sum += points.position[p]; // reductions: the same bits for any number of threads
        low.min_assign(points.position[p]);
        high.max_assign(points.position[p]);
    }
    let centre = sum / points.len() as f64; // what stands between loops is plain Rust
    let mut inertia = DMat3::ZERO;
    for p in points {
        let arm = points.position[p] - centre;
        points.distance[p] = arm.length() as f32;
        inertia += DMat3::from_diagonal(DVec3::splat(arm.length_squared()))
            - DMat3::from_cols(arm.x * arm, arm.y * arm, arm.z * arm);
    }
    Body { volume: share * points.len() as f64, centre, bounds: [low, high], inertia: share * inertia }
}

/// Reads a mesh and checks that it has an inside.
pub fn read(file: &Path) -> Result<ClosedMesh, LabError> {
    let name = file.display();
    let bytes = std::fs::read(file).map_err(|error| LabError::usage(format!("`{name}` cannot be read: {error}")))?;
    let mesh = mesh::read(&name.to_string(), &bytes).and_then(|mesh| mesh.closed());
    mesh.map_err(|error| LabError::usage(format!("`{name}` {error}")))
}

/// Points on a lattice of that spacing, wherever it lies inside of the mesh.
pub fn fill<L: Layout<I>>(mesh: &ClosedMesh, spacing: f64) -> Field<Point, L> {
    let positions = mesh.fill(spacing);
    let mut points = Field::<Point, L>::new([positions.len()]);
    for (p, position) in positions.into_iter().enumerate() {
        points.set(p, Point { position: position.into(), distance: 0.0 });
    }
    points
}

/// A picture of the points as balls, from gold at the centre of mass to purple, seen along the third axis and lit from
/// the upper left.
pub fn picture<L: Layout<I>>(points: &Field<Point, L>, body: &Body, spacing: f64) -> Picture {
    const SIDE: i32 = 640;
    let [low, high] = body.bounds;
    let scale = 0.9 * f64::from(SIDE) / (high - low).truncate().max_element();
    let radius = 0.75 * spacing * scale;
    let mut points: Vec<Point> = points.iter().collect();
    points.sort_by(|a, b| a.position.z.total_cmp(&b.position.z)); // the nearest are painted last
    let farthest = points.iter().map(|point| point.distance).fold(f32::MIN_POSITIVE, f32::max);
    let mut rgb = [11, 15, 26].repeat((SIDE * SIDE) as usize);
    for point in points {
        let middle = (point.position - 0.5 * (low + high)).truncate() * scale;
        let colour = vec3(255.0, 214.0, 120.0).lerp(vec3(150.0, 40.0, 130.0), point.distance / farthest).as_dvec3();
        let reach = radius.ceil() as i32;
        for (across, up) in (-reach..=reach).flat_map(|across| (-reach..=reach).map(move |up| (across, up))) {
            let pixel = middle.round().as_ivec2() + ivec2(across, up) + SIDE / 2;
            let side = (pixel.as_dvec2() - f64::from(SIDE / 2) - middle) / radius; // on the ball of radius one
            let inside = pixel.min_element() >= 0 && pixel.max_element() < SIDE;
            if inside && side.length_squared() < 1.0 {
                let normal = side.extend((1.0 - side.length_squared()).sqrt());
                let lit = colour * (0.3 + 0.7 * normal.dot(dvec3(-0.5, 0.6, 0.62)).max(0.0));
                let at = 3 * ((SIDE - 1 - pixel.y) * SIDE + pixel.x) as usize;
                rgb[at..at + 3].copy_from_slice(&lit.as_u8vec3().to_array());
            }
        }
    }
    Picture { width: SIDE as usize, height: SIDE as usize, rgb }
}

/// Writes the points as `mesh_to_particles.ply`, for programs that show meshes and point clouds, and their picture.
pub fn write<L: Layout<I>>(points: &Field<Point, L>, picture: &Picture, folder: &Path) -> Result<(), LabError> {
    let members = points.members();
    let positions: Vec<[f32; 3]> = members.position.to_vec().iter().map(|x| x.as_vec3().to_array()).collect();
    let particles = ply::points("a filled mesh", &positions, &[("distance", &members.distance.to_vec())])?;
    output::folder(folder)?;
    output::write(&folder.join("mesh_to_particles.ply"), &particles)?;
    output::write(&folder.join("mesh_to_particles.png"), &picture.png()?)
}

fn run() -> Result<(), LabError> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().unwrap_or_else(|| "solvers/scenes/bunny.obj".into());
    let folder = PathBuf::from(arguments.next().unwrap_or_else(|| "allotrope-out".into()));
    let mesh = read(Path::new(&file))?;
    let spacing = (mesh.volume() / 200_000.0).cbrt();
    let mut points = fill::<Soa>(&mesh, spacing);
    let body = weigh(&mut points, spacing.powi(3));
    let (off, moments) = (body.volume / mesh.volume() - 1.0, body.inertia.diagonal());
    println!("{file}: {} points, {spacing:.5} apart", points.len());
    println!("volume   {:.6e}, {:+.3} % off the mesh's own", body.volume, 100.0 * off);
    println!("centre   {:.5}", body.centre);
    println!("box      {:.5} to {:.5}", body.bounds[0], body.bounds[1]);
    println!("inertia  {:.4e} {:.4e} {:.4e} about the axes", moments.x, moments.y, moments.z);
    if off.abs() > 0.01 {
        let message = format!("the points miss the volume of `{file}` by {:.1} %: it may be thin", 100.0 * off);
        return Err(LabError::failure(message));
    }
    write(&points, &picture(&points, &body, spacing), &folder)?;
    println!("mesh_to_particles.ply and .png are in {}", folder.display());
    Ok(())
}

fn main() -> ExitCode {
    errors::report(run)
}
