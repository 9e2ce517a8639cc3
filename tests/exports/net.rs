//! A simulation without a grid, pressure or materials, whose particles are joined and whose steps change their size.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use allotrope_lab::lab::bench;
use allotrope_lab::lab::checkpoint::Checkpoint;
use allotrope_lab::lab::convert_cost::{self, convert_cost};
use allotrope_lab::lab::export::{npz, ply, vtk};
use allotrope_lab::lab::machine::NamedSchedule;
use allotrope_lab::lab::render::{Camera, Picture, Shading};
use allotrope_lab::lab::report as page;
use allotrope_lab::lab::run::{Calendar, Export, Outputs, Plan, Progress, run};
use allotrope_lab::lab::sweep::{self, Axis, sweep};
use allotrope_solvers::scene::{Basics, Keys, Particles};
use allotrope_solvers::{
    Array, Built, Energy, LayoutInfo, Read, Scene, SceneError, Setup, Simulation, SolverInfo, State, StepError, Totals,
    Values,
};

use super::{attribute, pixel, vtk_arrays, vtk_parts, wholes};
use crate::support::mpm;

/// Masses along each axis.
const SIDE: usize = 5;

/// Metres between neighbours.
const SPACING: f64 = 0.125;

/// A net of masses with springs between neighbours, that flies on as it was thrown.
#[derive(Clone, Debug, Default)]
struct Net {
    dimensions: usize,
    steps: u64,
    /// Seconds that have passed, and of the last step.
    clock: [f64; 2],
    /// By which factor its steps are longer than they could be.
    slow: u32,
    /// Whether it forgets what it is told.
    deaf: bool,
}

const THROWN: f64 = 0.5;

impl Net {
    fn masses(&self) -> usize {
        if self.dimensions == 1 { SIDE } else { SIDE * SIDE }
    }

    /// Column and row of a mass.
    fn place(n: usize) -> [usize; 2] {
        [n % SIDE, n / SIDE]
    }

    /// Seconds of the step after so many.
    fn next_dt(steps: u64) -> f64 {
        0.01 * (1 + steps % 3) as f64
    }
}

impl Simulation for Net {
    fn kernel_names(&self) -> &'static [&'static str] {
        &["forces", "update"]
    }
    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        let dt = Self::next_dt(self.steps);
        self.clock = [self.clock[0] + dt, dt];
        self.steps += 1;
        // Some time, so that medians are above zero.
        for part in spent {
            let start = std::time::Instant::now();
            std::thread::sleep(self.slow * Duration::from_micros(100));
            *part += start.elapsed();
        }
        Ok(())
    }
    fn steps(&self) -> u64 {
        self.steps
    }
    fn dt(&self) -> f64 {
        self.clock[1]
    }
    fn time(&self) -> f64 {
        self.clock[0]
    }
    fn dimensions(&self) -> usize {
        self.dimensions
    }
    fn particles(&self) -> usize {
        self.masses()
    }
    fn extent(&self) -> [f64; 3] {
        std::array::from_fn(|axis| if axis < self.dimensions { 1.0 } else { 0.0 })
    }
    fn spacing(&self) -> f64 {
        SPACING
    }
    fn bytes(&self) -> usize {
        48 * self.masses()
    }
    fn positions(&self) -> Vec<[f64; 3]> {
        let at = |n| {
            let [column, row] = Self::place(n).map(|n| 0.25 + SPACING * n as f64);
            [
                column + THROWN * self.clock[0],
                if self.dimensions > 1 { row } else { 0.0 },
                if self.dimensions > 2 { 0.5 } else { 0.0 },
            ]
        };
        (0..self.masses()).map(at).collect()
    }
    fn velocities(&self) -> Vec<[f64; 3]> {
        vec![[THROWN, 0.0, 0.0]; self.masses()]
    }
    fn links(&self) -> Vec<[u32; 2]> {
        let pairs = (0..self.masses()).flat_map(|n| {
            let [column, row] = Self::place(n);
            let right = (column + 1 < SIDE).then_some([n as u32, n as u32 + 1]);
            let below = (self.dimensions > 1 && row + 1 < SIDE).then_some([n as u32, (n + SIDE) as u32]);
            right.into_iter().chain(below)
        });
        pairs.collect()
    }
    fn particle_arrays(&self) -> Vec<Array> {
        let d = self.dimensions;
        let double = |name, vectors: Vec<[f64; 3]>| {
            let values = Values::F64(vectors.into_iter().flat_map(|x| x.into_iter().take(d)).collect());
            Array { name, components: d, values }
        };
        vec![double("position", self.positions()), double("velocity", self.velocities())]
    }
    fn save(&self) -> State {
        let clock = Array { name: "clock", components: 2, values: Values::F64(self.clock.to_vec()) };
        State { steps: self.steps, arrays: vec![clock] }
    }
    fn restore(&mut self, state: &State) -> Result<(), String> {
        let [Array { name: "clock", values: Values::F64(clock), .. }] = &state.arrays[..] else {
            return Err("array `clock` is missing".into());
        };
        if self.deaf {
            return Ok(());
        }
        self.clock = clock[..].try_into().map_err(|_| "array `clock` holds other than two values")?;
        self.steps = state.steps;
        Ok(())
    }
    fn energy(&self) -> Energy {
        Energy::default()
    }
    fn totals(&self) -> Totals {
        let mass = self.masses() as f64;
        Totals { mass, momentum: [THROWN * mass, 0.0, 0.0], angular_momentum: [0.0; 3] }
    }
}

impl Setup for Net {
    fn extent(&self) -> [f64; 3] {
        Simulation::extent(self)
    }
    fn particles(&self, _scene: &Scene) -> Result<Particles, SceneError> {
        Ok(Particles { x: self.positions(), v: self.velocities(), ..Particles::default() })
    }
}

fn read(_keys: &Keys<'_>, basics: &Basics<'_>) -> Read {
    Ok(Arc::new(net(basics.dimensions)))
}

fn build(scene: &Scene, layout: &str) -> Built {
    let slow = if layout == "rows" { 4 } else { 1 };
    Ok(Box::new(Net { slow, deaf: layout == "deaf", ..scene.setup::<Net>()?.clone() }))
}

static SOLVER: SolverInfo = SolverInfo {
    name: "net",
    about: "",
    dimensions: 1..=3,
    keys: &[],
    read,
    scenes: &[],
    layouts: &[
        LayoutInfo { name: "flat", about: "", sparse: false },
        LayoutInfo { name: "rows", about: "", sparse: false },
        LayoutInfo { name: "deaf", about: "", sparse: false },
    ],
    unfit: |scene, layout| (layout == "rows" && scene.steps == 1).then_some("it is too large"),
    build,
};

fn net(dimensions: usize) -> Net {
    Net { dimensions, ..Net::default() }
}

fn scene(dimensions: usize) -> Scene {
    let mpm88 = mpm().scene("mpm88").unwrap();
    let setup = Arc::new(net(dimensions));
    Scene { file: "net".into(), solver: "net".into(), dimensions, gravity: [0.0; 3], setup, ..mpm88 }
}

fn picture(dimensions: usize) -> Picture {
    Camera::new(&net(dimensions), &scene(dimensions), Shading::Velocity).picture(&net(dimensions))
}

fn light(rgb: [i32; 3]) -> i32 {
    rgb.into_iter().sum()
}

#[test]
fn springs_are_lines_and_masses_are_dots_in_the_plane() {
    let picture = picture(2);
    assert_eq!((picture.width, picture.height), (800, 800));
    let at = |x: f64, y: f64| light(pixel(&picture, (800.0 * x) as usize, (800.0 * (1.0 - y)) as usize));
    let background = at(0.1, 0.1);
    for n in 0..SIDE * SIDE {
        let [column, row] = Net::place(n).map(|n| 0.25 + SPACING * n as f64);
        let (dot, hole) = (at(column, row), at(column + 0.5 * SPACING, row + 0.5 * SPACING));
        assert_eq!(hole, background, "nothing is between the springs at {column}, {row}");
        assert!(dot > background + 200, "a mass at {column}, {row}");
        for (x, y) in [(column + 0.5 * SPACING, row), (column, row + 0.5 * SPACING)] {
            let joined = if x > column { x < 0.75 } else { y < 0.75 };
            assert_eq!(at(x, y) > background + 60, joined, "a spring at {x}, {y}");
            assert!(at(x, y) < dot, "masses stand out");
        }
    }
}

#[test]
fn a_line_of_masses_lies_in_a_strip() {
    let picture = picture(1);
    assert_eq!((picture.width, picture.height), (800, 100));
    let at = |column: usize, row: usize| light(pixel(&picture, column, row));
    for n in 0..SIDE {
        assert!(at(200 + 100 * n, 50) > at(20, 20) + 200, "mass {n}");
    }
    assert!(at(250, 50) > at(20, 20) + 60 && at(250, 30) == at(20, 20));
    assert!(at(150, 50) == at(20, 20) && at(650, 50) == at(20, 20), "nothing hangs out of the line");
}

#[test]
fn springs_are_rods_in_space() {
    let (picture, scene) = (picture(3), scene(3));
    let empty = Scene { setup: scene.setup.clone(), ..scene.clone() };
    // The same camera at nothing but the tank: what differs is the net.
    let tank = Camera::new(&net(3), &empty, Shading::Velocity).picture(&Unjoined(net(3), 0));
    let dots = Camera::new(&net(3), &empty, Shading::Velocity).picture(&Unjoined(net(3), 1));
    let differ = |a: &Picture, b: &Picture| a.rgb.chunks(3).zip(b.rgb.chunks(3)).filter(|(a, b)| a != b).count();
    let (all, one) = (differ(&picture, &tank), differ(&dots, &tank));
    assert!(one > 20 && one < 3_000, "one mass in {one} pixels");
    // Masses may hide each other's shadows.
    assert!((15 * one..30 * one).contains(&all), "the net in {all} pixels, a mass in {one}");
    let unjoined = Camera::new(&net(3), &empty, Shading::Velocity).picture(&Unjoined(net(3), 25));
    let rods = differ(&picture, &unjoined);
    assert!((40 * 50..40 * 800).contains(&rods), "40 springs in {rods} pixels");
}

/// The first masses of a net, of which each is joined with itself.
struct Unjoined(Net, usize);

impl Simulation for Unjoined {
    fn kernel_names(&self) -> &'static [&'static str] {
        self.0.kernel_names()
    }
    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        self.0.step_timed(spent)
    }
    fn steps(&self) -> u64 {
        self.0.steps()
    }
    fn dt(&self) -> f64 {
        self.0.dt()
    }
    fn time(&self) -> f64 {
        self.0.time()
    }
    fn dimensions(&self) -> usize {
        self.0.dimensions()
    }
    fn particles(&self) -> usize {
        self.1
    }
    fn extent(&self) -> [f64; 3] {
        Simulation::extent(&self.0)
    }
    fn spacing(&self) -> f64 {
        self.0.spacing()
    }
    fn bytes(&self) -> usize {
        self.0.bytes()
    }
    fn positions(&self) -> Vec<[f64; 3]> {
        self.0.positions()[..self.1].to_vec()
    }
    fn velocities(&self) -> Vec<[f64; 3]> {
        self.0.velocities()[..self.1].to_vec()
    }
    fn links(&self) -> Vec<[u32; 2]> {
        (0..self.1 as u32).map(|n| [n, n]).collect()
    }
    fn particle_arrays(&self) -> Vec<Array> {
        Vec::new()
    }
    fn save(&self) -> State {
        self.0.save()
    }
    fn restore(&mut self, state: &State) -> Result<(), String> {
        self.0.restore(state)
    }
    fn energy(&self) -> Energy {
        self.0.energy()
    }
    fn totals(&self) -> Totals {
        self.0.totals()
    }
}

#[test]
fn springs_come_back_from_ply_as_edges() {
    let net = net(2);
    let bytes = ply::particles(&net);
    let end = bytes.windows(11).position(|piece| piece == b"end_header\n").unwrap() + 11;
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    let vertices = "element vertex 25\nproperty float x\nproperty float y\nproperty float z\nproperty float vx\n\
                    property float vy\nproperty float vz\nproperty uint material\n";
    assert!(header.contains(vertices), "{header}");
    assert!(header.ends_with("element edge 40\nproperty int vertex1\nproperty int vertex2\nend_header\n"), "{header}");
    let edges = &bytes[end + 25 * 28..];
    assert_eq!(wholes(edges), net.links().concat());
}

#[test]
fn springs_come_back_from_vtp_as_lines() {
    for dimensions in [1, 2, 3] {
        let net = net(dimensions);
        let bytes = vtk::particles(&net);
        let (xml, data) = vtk_parts(&bytes);
        let piece = xml.split('<').find(|element| element.starts_with("Piece")).unwrap();
        assert_eq!(attribute(piece, "NumberOfLines"), net.links().len().to_string());
        let (before, lines) = xml.split_once("<Lines>").unwrap();
        let (lines, _) = lines.split_once("</Lines>").unwrap();
        let cells = vtk_arrays(lines, data);
        assert_eq!(wholes(cells["connectivity"].2), net.links().concat());
        let offsets: Vec<u32> = (1..=net.links().len() as u32).map(|n| 2 * n).collect();
        assert_eq!(wholes(cells["offsets"].2), offsets);
        let vertices = vtk_arrays(before, data);
        assert_eq!(wholes(vertices["connectivity"].2), (0..net.masses() as u32).collect::<Vec<_>>());
        let (kind, components, points) = &vertices["position"];
        assert_eq!((kind.as_str(), *components), ("Float64", 3));
        let points: Vec<f64> = points.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        assert_eq!(points, net.positions().concat());
    }
}

fn plan(out: &Path, calendar: Calendar, shading: Option<Shading>) -> Plan {
    Plan {
        solver: &SOLVER,
        scene: scene(2),
        scene_folder: None,
        layout: "flat",
        schedule: NamedSchedule::find("auto").unwrap(),
        threads: Some(1),
        deterministic: false,
        calendar,
        outputs: Outputs {
            shading,
            export: vec![Export::Ply, Export::Npz, Export::Vtk],
            gif: true,
            ..Outputs::default()
        },
        out: out.to_path_buf(),
    }
}

/// The times in s that a series tells.
fn times(out: &Path) -> Vec<f64> {
    let text = std::fs::read_to_string(out.join("particles.pvd")).unwrap();
    let sets = text.lines().filter(|line| line.starts_with("<DataSet"));
    sets.map(|line| attribute(line, "timestep").parse().unwrap()).collect()
}

#[test]
fn a_run_without_a_grid_makes_no_files_of_it_and_tells_the_times_of_its_steps() {
    let folder = tempfile::tempdir().unwrap();
    let calendar = Calendar { steps: 5, every: Some(2), checkpoint_every: Some(4) };
    run(&plan(folder.path(), calendar, None), None, Progress::None, true).unwrap();
    let names = |out: &Path| {
        let entries = std::fs::read_dir(out).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<_> = entries.collect();
        names.sort();
        names
    };
    let frames = (0..4).flat_map(|n| {
        ["frame_000N.png", "particles_000N.npz", "particles_000N.ply", "particles_000N.vtp"]
            .map(|name| name.replace('N', &n.to_string()))
    });
    let others = ["animation.gif", "checkpoint.npz", "particles.pvd", "sheet.png"].map(String::from);
    let mut wanted: Vec<_> = frames.chain(others).collect();
    wanted.sort();
    assert_eq!(names(folder.path()), wanted);
    // Steps take 0.01, 0.02, 0.03 s and so on, over and over.
    let close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(close(&times(folder.path()), &[0.0, 0.03, 0.07, 0.09]), "{:?}", times(folder.path()));

    // Gone on with, it tells the times of the earlier part too.
    let checkpoint = Checkpoint::load(&folder.path().join("checkpoint.npz")).unwrap();
    assert_eq!(checkpoint.header.steps_done, 5);
    let longer = Calendar { steps: 8, every: Some(2), checkpoint_every: None };
    run(&plan(folder.path(), longer, None), Some(&checkpoint), Progress::None, true).unwrap();
    assert!(close(&times(folder.path()), &[0.0, 0.03, 0.07, 0.12, 0.15]), "{:?}", times(folder.path()));
    let arrays = npz::read(&std::fs::read(folder.path().join("particles_0004.npz")).unwrap()).unwrap().arrays;
    let (_, components, Values::F64(x)) = &arrays[0] else { panic!("{arrays:?}") };
    assert!(*components == 2 && (x[0] - 0.25 - THROWN * 0.15).abs() < 1e-12, "{x:?}");
}

#[test]
fn pressure_is_not_shown_where_there_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let calendar = Calendar { steps: 5, every: Some(2), checkpoint_every: None };
    let plan = plan(&folder.path().join("out"), calendar, Some(Shading::Pressure));
    let error = run(&plan, None, Progress::None, true).unwrap_err();
    let message = "`--shading pressure` cannot be: particles of `net` have no pressure";
    assert_eq!((error.status(), error.to_string().as_str()), (2, message));
    assert!(!plan.out.exists());
}

fn bench_plan(scene: Scene) -> bench::Plan {
    bench::Plan {
        solver: &SOLVER,
        name: "net".into(),
        scene,
        layouts: vec!["flat", "rows"],
        schedules: vec![NamedSchedule::find("auto").unwrap()],
        threads: Some(1),
        steps: Some(22),
        hardware: false,
    }
}

#[test]
fn a_bench_without_a_grid_reports_none() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    bench::bench(&bench_plan(scene(2)), Some(&file)).unwrap();
    let report: bench::Report = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    assert_eq!((report.particles, report.grid.len(), report.rows.len()), (25, 0, 2));
    assert!(report.rows.iter().all(|row| row.ms_per_step > 0.2 && row.state_error == 0.0), "{report:?}");
}

#[test]
fn a_page_ranks_the_faster_layout_first_and_tells_what_cannot_be_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let plan = |sweep| page::Plan {
        bench: bench::Plan { layouts: vec!["rows", "flat"], ..bench_plan(scene(2)) },
        scene: Vec::new(),
        command: vec!["report".into(), "net".into()],
        budget: 1.0,
        sweep,
        counts: None,
        out: folder.path().to_path_buf(),
    };
    page::report(&plan(false)).unwrap();
    let html = std::fs::read_to_string(folder.path().join(page::FILE)).unwrap();
    // Steps of 0.8 ms against such of 0.2 ms.
    assert!(html.contains("Choose <code>flat</code>: a step takes 0."), "{html}");
    assert!(html.contains("Slower than the best beyond the noise: <code>rows</code>."), "{html}");
    let unmapped = "since the solver does not tell where their records lie: <code>rows</code> and <code>flat</code>.";
    assert!(html.contains(unmapped), "{html}");
    // What is refused is refused before anything is measured.
    std::fs::remove_file(folder.path().join(page::FILE)).unwrap();
    let error = page::report(&plan(true)).unwrap_err();
    assert!(error.status() == 2 && error.to_string().contains("has as many particles as its scenes tell"), "{error}");
    assert!(!folder.path().join(page::FILE).exists());
}

/// What a change costs, as the report in a file says.
fn cost(layouts: [&'static str; 2]) -> Result<convert_cost::Report, String> {
    let folder = tempfile::tempdir().unwrap();
    let plan = convert_cost::Plan {
        solver: &SOLVER,
        name: "net".into(),
        scene: scene(2),
        layouts,
        schedule: NamedSchedule::find("auto").unwrap(),
        threads: Some(1),
        steps: Some(44),
    };
    let file = folder.path().join("cost.json");
    convert_cost(&plan, Some(&file)).map_err(|error| error.to_string())?;
    Ok(serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap())
}

#[test]
fn a_change_pays_towards_the_faster_layout_alone() {
    // Steps of 0.8 ms against such of 0.2 ms: far apart also on a machine that is busy.
    let faster = cost(["rows", "flat"]).unwrap().change;
    assert!(faster.gain_ms > 0.1 && faster.pays_after.is_some(), "{faster:?}");
    assert!(faster.pays_after.unwrap() as f64 >= faster.ms / faster.gain_ms, "{faster:?}");
    let slower = cost(["flat", "rows"]).unwrap().change;
    assert!(slower.gain_ms < -0.1 && slower.pays_after.is_none(), "{slower:?}");
}

#[test]
fn a_state_that_does_not_go_over_is_told_before_any_time() {
    // After 44 steps, which take 0.87 s, masses that fly at 0.5 m/s.
    let message = cost(["flat", "deaf"]).unwrap_err();
    assert!(message.starts_with("the state of flat does not go over to deaf: particle "), "{message}");
    assert!(message.ends_with(" differs by 4.350e-1"), "{message}");
}

#[test]
fn sweeps_leave_out_what_does_not_fit_and_refuse_what_cannot_be() {
    let folder = tempfile::tempdir().unwrap();
    let swept = |axis, points: &[&str], scene| {
        let points = points.iter().map(|point| point.to_string()).collect();
        let plan = sweep::Plan { bench: bench_plan(scene), axis, points };
        sweep(&plan, folder.path()).map_err(|error| error.to_string())
    };
    assert_eq!(
        swept(Axis::Order, &[], scene(2)),
        Err("`--sweep order` cannot be, since the solver `net` sorts nothing".into())
    );
    assert_eq!(
        swept(Axis::ParticlesPerCell, &["1"], scene(2)),
        Err("`--sweep particles-per-cell` cannot be, since the solver `net` has no grid".into())
    );
    assert_eq!(
        swept(Axis::Size, &["9"], scene(2)),
        Err("scene `net`: `particles = 9` cannot be, since the solver `net` has as many particles as its scenes tell"
            .into())
    );
    // One step is told to be too much for one of the layouts.
    swept(Axis::Threads, &["1"], Scene { steps: 1, ..scene(2) }).unwrap();
    let csv = std::fs::read_to_string(folder.path().join("sweep.csv")).unwrap();
    let lines: Vec<_> = csv.lines().collect();
    assert!(lines.len() == 2 && lines[1].starts_with("1,25,,1,flat,auto,"), "{csv}");
}
