//! The workloads on our side. Inputs and sizes are those of `benches/peers`.

use allotrope::prelude::*;
use allotrope_solvers::scene::Reorder;

use super::bandwidth::Stream;
use crate::lab::errors::LabError;
use crate::workloads::stencils::ramp;
use crate::workloads::{bodies, sparse, stencils, streams};

/// Particles are sorted by cell every so many steps: within these the fastest cross some cells, and the cost of a sort is
/// spread thin.
const SORTED_EVERY: u64 = 32;

/// One computation that other systems are asked for too.
#[derive(Clone, Copy, Debug)]
pub struct Workload {
    /// Its name, here and in reports.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// The loop that tells what memory can do, for what moves memory.
    pub(super) stream: Option<Stream>,
    /// Calls that belong together.
    pub(super) round: usize,
    /// Makes its fields.
    pub(super) build: fn() -> Result<Box<dyn Work>, LabError>,
}

/// A workload with its fields.
pub(super) trait Work {
    /// Useful bytes that a call moves: what has to be read and written, each once.
    fn bytes(&self) -> usize;
    /// Does it once.
    fn call(&mut self) -> Result<(), LabError>;
    /// A number that tells whether the first call was right.
    fn result(&self) -> f64;
}

/// Calls it so often.
pub(super) fn repeat(schedule: &Schedule, work: &mut dyn Work, calls: usize) -> Result<(), LabError> {
    schedule.run(|| (0..calls).try_for_each(|_| work.call()))
}

/// A workload of fields, what it does to them, and what it makes of them.
struct Of<S, C, R> {
    bytes: usize,
    fields: S,
    call: C,
    result: R,
}

impl<S, C: FnMut(&mut S), R: Fn(&S) -> f64> Work for Of<S, C, R> {
    fn bytes(&self) -> usize {
        self.bytes
    }

    fn call(&mut self) -> Result<(), LabError> {
        (self.call)(&mut self.fields);
        Ok(())
    }

    fn result(&self) -> f64 {
        (self.result)(&self.fields)
    }
}

fn of<S: 'static>(
    bytes: usize,
    fields: S,
    call: impl FnMut(&mut S) + 'static,
    result: impl Fn(&S) -> f64 + 'static,
) -> Result<Box<dyn Work>, LabError> {
    Ok(Box::new(Of { bytes, fields, call, result }))
}

/// A line makes a workload: its name, a word about it, the loop beside it, and what makes it.
macro_rules! workloads {
    ($($name:literal: $about:literal, $stream:expr, $round:expr, $build:expr;)*) => {
        /// All of them, in the order of reports.
        pub const WORKLOADS: &[Workload] =
            &[$(Workload { name: $name, about: $about, stream: $stream, round: $round, build: $build }),*];
    };
}

workloads! {
    "saxpy": "y += a x of 2^24 values", Some(Stream::Update), 1, saxpy;
    "sum": "the sum of 2^24 values", Some(Stream::Read), 1, sum;
    "jacobi": "Jacobi's 5-point step over 2048^2", Some(Stream::Scale), 1, jacobi;
    "laplacian7": "the 7-point Laplacian of 192^3", Some(Stream::Scale), 1, laplacian;
    "histogram": "2^22 keys to 256 counts", Some(Stream::Read), 1, histogram;
    "julia": "a Julia set of 640 x 320, 50 iterations", Some(Stream::Scale), 1, julia;
    "nbody": "direct forces of 4096 bodies", Some(Stream::Scale), 1, nbody;
    "mpm88-8k": "a step of MLS-MPM, 8192 particles on 128^2", Some(Stream::Update), 1, || fluid(8192, 128, Reorder::Never);
    "mpm88-1m": "the same, 2^20 particles on 1024^2, sorting included", Some(Stream::Update), SORTED_EVERY as usize,
        || fluid(1 << 20, 1024, Reorder::Every(SORTED_EVERY));
    "sparse-laplacian": "the 7-point Laplacian of 3 M voxels of a shell in 512^3", Some(Stream::Scale), 1, shell;
    "sparse-scale": "scaling the same voxels", Some(Stream::Scale), 1, scaling;
    "launch": "a loop over one cell", None, 1, launch;
}

fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for value in values {
        sum += value;
        count += 1;
    }
    sum / f64::from(count.max(1))
}

fn line(size: usize) -> Field<f32, Aos> {
    let mut x = Field::new([size]);
    x.copy_from_slice(&ramp(size));
    x
}

fn saxpy() -> Result<Box<dyn Work>, LabError> {
    let size = 1 << 24;
    let fields = (line(size), Field::<f32, Aos>::new([size]));
    of(12 * size, fields, |(x, y)| streams::saxpy(0.5, x, y), |(_, y)| mean(y.iter().map(f64::from)))
}

fn sum() -> Result<Box<dyn Work>, LabError> {
    let size = 1 << 24;
    of(4 * size, (line(size), 0.0), |(x, sum)| *sum = streams::sum(x), |(_, sum)| f64::from(*sum))
}

fn jacobi() -> Result<Box<dyn Work>, LabError> {
    let n = 2048;
    let mut u = Field::<f32, Aos>::new([n, n]);
    u.copy_from_slice(&ramp(n * n));
    let fields = (u, Field::<f32, Aos>::new([n, n]));
    of(8 * n * n, fields, |(u, v)| stencils::jacobi(0.25, u, v), |(_, v)| mean(v.iter().map(f64::from)))
}

fn laplacian() -> Result<Box<dyn Work>, LabError> {
    let n = 192;
    let mut p = Field::<f32, Aos>::new([n; 3]);
    p.copy_from_slice(&ramp(n * n * n));
    let fields = (p, Field::<f32, Aos>::new([n; 3]));
    let square = |(_, q): &(_, Field<f32, Aos, Ijk>)| mean(q.iter().map(|q| f64::from(q).powi(2)));
    of(8 * n * n * n, fields, |(p, q)| stencils::laplacian(p, q), square)
}

fn histogram() -> Result<Box<dyn Work>, LabError> {
    let list: Vec<i32> = (0..1u32 << 22).map(|n| (n.wrapping_mul(2_654_435_761) >> 24) as i32).collect();
    let mut keys = Field::<i32, Aos>::new([list.len()]);
    keys.copy_from_slice(&list);
    let centre = |(_, counts): &(_, Field<i32, Aos>)| {
        let counts = counts.to_vec().into_iter().map(f64::from);
        let moment: f64 = counts.clone().enumerate().map(|(key, count)| key as f64 * count).sum();
        moment / counts.sum::<f64>()
    };
    let fields = (keys, Field::<i32, Aos>::new([256]));
    of(4 * list.len(), fields, |(keys, counts)| bodies::histogram(keys, counts), centre)
}

fn julia() -> Result<Box<dyn Work>, LabError> {
    let counts = Field::<u32, Aos>::new([640, 320]);
    let bytes = 4 * counts.len();
    of(bytes, counts, |counts| bodies::julia(counts, 0.19), |counts| mean(counts.iter().map(f64::from)))
}

fn nbody() -> Result<Box<dyn Work>, LabError> {
    let count = 4096;
    let mut x = Field::<Vec3, Soa>::new([count]);
    for n in 0..count {
        x.set(n, Vec3::from_array([n * 37 % count, n * 91 % count, n].map(|n| n as f32 / count as f32)));
    }
    let fields = (x, Field::<Vec3, Soa>::new([count]));
    let size = |(_, a): &(_, Field<Vec3, Soa>)| mean(a.iter().map(|a| f64::from(a.length())));
    of(24 * count, fields, |(x, a)| bodies::gravitate(x, a), size)
}

/// The solver's own fluid, with particles sorted every so many steps.
fn fluid(particles: usize, nodes: usize, reorder: Reorder) -> Result<Box<dyn Work>, LabError> {
    let solver = allotrope_solvers::solver("mpm").map_err(LabError::usage)?;
    let scene = solver.scene("mpm88")?.with_grid(nodes)?.with_particles(particles)?.with_reorder(reorder)?;
    let simulation = (solver.build)(&scene, "aos+row")?;
    // Particles (9 numbers) are read twice and written once, nodes (3 numbers) are cleared, accumulated (read and written),
    // updated (read and written) and gathered.
    let bytes = 4 * (3 * 9 * particles + 6 * 3 * nodes * nodes);
    Ok(Box::new(Fluid { bytes, simulation }))
}

/// A solver's simulation, of which a call takes a step.
struct Fluid {
    bytes: usize,
    simulation: Box<dyn allotrope_solvers::Simulation>,
}

impl Work for Fluid {
    fn bytes(&self) -> usize {
        self.bytes
    }

    fn call(&mut self) -> Result<(), LabError> {
        Ok(self.simulation.step()?)
    }

    fn result(&self) -> f64 {
        mean(self.simulation.velocities().into_iter().map(|v| v[1]))
    }
}

type ShellLayout = layout!(pointer(ijk).bitmasked(ijk, 8).soa);
type Shell = Field<sparse::Two, ShellLayout, Ijk>;

fn active_shell() -> Shell {
    let mut field = Field::<sparse::Two, ShellLayout>::new([sparse::SIDE; 3]);
    sparse::shell(&mut field);
    field
}

fn shell() -> Result<Box<dyn Work>, LabError> {
    let field = active_shell();
    let square = |field: &Shell| mean(field.active_iter().map(|(_, cell)| f64::from(cell.w).powi(2)));
    of(8 * field.active_len(), field, sparse::laplacian, square)
}

fn scaling() -> Result<Box<dyn Work>, LabError> {
    let field = active_shell();
    let square = |field: &Shell| mean(field.active_iter().map(|(_, cell)| f64::from(cell.u).powi(2)));
    of(8 * field.active_len(), field, |field| sparse::scale(field, 1.0001), square)
}

fn launch() -> Result<Box<dyn Work>, LabError> {
    of(4, Field::<f32, Aos>::new([1]), bodies::empty, |one| f64::from(one.get([0])))
}
