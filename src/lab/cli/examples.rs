//! What each command's help ends with. Lines that begin with the program's name are parsed by a test.

/// Of the program.
pub(super) const ALL: &str = "\
Examples:
  allotrope list                                # what there is
  allotrope run mpm --scene bunny --gif         # pictures and an animation in allotrope-out
  allotrope bench mpm                           # the same scene in many layouts
  allotrope report mpm                          # the same as a page, allotrope-report/report.html

Exit status:
  0    done
  1    a run broke down, or a check failed
  2    what was asked for cannot be
  3    the machine failed: a disk is full, a place cannot be written, memory is short
  130  ended by Ctrl-C (143: by SIGTERM); `run` tells how to go on";

/// Of `list`.
pub(super) const LIST: &str = "\
Examples:
  allotrope list";

/// Of `run`.
pub(super) const RUN: &str = "\
Examples:
  allotrope run mpm                             # the first scene, with 60 pictures in allotrope-out
  allotrope run mpm --scene my.toml --set dt=1e-4 --every 50 --gif
  allotrope run mpm --scene bunny --layout soa+soa --azimuth 60 --zoom 1.5 --out bunny
  allotrope run mpm --export npz,vtk --checkpoint-every 500 --deterministic
  allotrope run --resume allotrope-out/checkpoint.npz
  allotrope run mpm --frames 0 --progress json  # no pictures; a line of JSON for each event

Ctrl-C ends a run after its step, with a checkpoint and what is made of the pictures so far; a second one ends it at
once. Exit status: 0 done, 1 the run broke down or a check failed, 2 what was asked for cannot be, 3 the machine failed
(disk, memory), 130 and 143 ended by a signal.";

/// Of `bench`.
pub(super) const BENCH: &str = "\
Examples:
  allotrope bench mpm                           # all layouts that fit the first scene
  allotrope bench mpm --layouts aos+row,soa+soa --schedules private,atomic
  allotrope bench mpm --particles 1048576 --grid 1024 --threads 1 --json bench.json
  allotrope bench mpm --sweep size --layouts aos+row,soa+soa --out sizes
  allotrope bench mpm --sweep threads --points 1,2
  allotrope bench mpm --particles 100000 --sweep order --points 0,16,auto

A sweep has its results on the disk after each point: the same command goes on after the last one.";

/// Of `report`.
pub(super) const REPORT: &str = "\
Examples:
  allotrope report mpm                          # all layouts that fit the first scene, in allotrope-report/report.html
  allotrope report wcsph --scene dam-break --particles 5000 --threads 1 --out dam-break
  allotrope report mpm --particles 100000 --grid 512 --sweep --budget 60
  allotrope report mpm --layouts aos+row,soa+soa --counts counts.json

The page holds all that it shows and needs no network: it can be sent, read on a phone and printed. It tells of the scene and the machine, ranks the
layouts with intervals of 95 %, shows where their time goes and where their records lie in memory, and gives below each table the command that makes
its numbers again. All layouts must end in the same state before anything is timed.";

/// Of `search`.
pub(super) const SEARCH: &str = "\
Examples:
  allotrope search mpm                          # half a minute, the first scene
  allotrope search mpm --particles 1048576 --grid 1024 --budget 120 --out tuned.toml
  allotrope run mpm --tuned tuned.toml          # with what was found

All candidates take the same steps in interleaved pieces, and must end in the same state; after each round the slower half is dropped, but for those
that cannot be told from the better one. Ratios have intervals of 95 %. What is searched is the start of the scene.";

/// Of `count`.
pub(super) const COUNT: &str = "\
Examples:
  allotrope count mpm                           # one step of the first scene, the layouts side by side
  allotrope count mpm --layouts aos+row --steps 4 --out heat
  allotrope count mpm --first-level 48,12 --second-level 1024,16 --json counts.json

Needs a program that was built with `--features probe`, or with debug assertions: others have nothing that counts.
Loops run on one thread; numbers are the same on every machine. What stands outside of parallel loops is not counted.";

/// Of `convert-cost`.
pub(super) const CONVERT_COST: &str = "\
Examples:
  allotrope convert-cost mpm aos+row soa+soa    # of the first scene
  allotrope convert-cost mpm aos+row aosoa16+blocked4 --particles 200000 --grid 512 --json cost.json

The state is read from one layout and written into the other, both of which are there; before anything is timed, both
must come to the same positions from it. Times are medians of interleaved repetitions; intervals of 95 %.";

/// Of `compare`.
pub(super) const COMPARE: &str = "\
Examples:
  allotrope compare taichi --python taichi/bin/python";

/// Of `compare taichi`.
pub(super) const COMPARE_TAICHI: &str = "\
Examples:
  allotrope compare taichi                      # where `python3` has Taichi; our times alone where it has not
  allotrope compare taichi --python taichi/bin/python --threads 1
  allotrope compare taichi --workloads jacobi,mpm88-1m --pairs 15 --json taichi.json

`allotrope list` tells the workloads. Both sides have the same inputs, and their results are compared before anything is timed. `tuned` is Taichi as an
expert would write it (scatters in a serial loop without atomic adds, rows instead of a condition at each cell).";

/// Of `map`.
pub(super) const MAP: &str = "\
Examples:
  allotrope map 'x: Vec2, v: Vec2, m: f32' Aos --out aos.svg
  allotrope map 'x: Vec2, v: Vec2, m: f32' 'AoSoA<16>' --shape 100 --out aosoa.svg
  allotrope map 'v: Vec2, m: f32' 'dense(ij).dense(ij, 4).soa' --shape 10,12 --out blocks.svg
  allotrope map 'v: Vec3, m: f32' 'dense(ijk).place([v], [split(m)])' --out groups.svg
  allotrope map 'v: Vec2, m: f32' 'pointer(ij).bitmasked(ij, 8).aos' --shape 64,64 --active disc --out sparse.svg
  allotrope map 'id: u32' 'dense(ij).dynamic(k, 64, chunk = 8).aos' --active '0,0,0..20; 3,1,0..5' --out lists.svg
  allotrope map f32 'hash(ij).morton(ij, 8).aos' --active '-4..4,-4..4; 1000,2000' --out unbounded.svg
  allotrope map 'x: Vec2, m: f32' Aos Soa 'AoSoA<8>' --shape 40 --html layouts.html

RECORD is a list of members with their types, or one type: f32, f64, i8 to i64, u8 to u64, bool, glam's vectors, matrices and
quaternions (Vec2, DVec3, IVec2, Mat3, Quat, ..), arrays [T; N] of these, and records in braces: node: {v: Vec2, m: f32}.
LAYOUT is what stands in `layout!(..)`, or a layout with a name: Aos, Soa, Split, AoSoA<N>, Blocked<N>, Morton<N>, Sparse<N>,
SparseHash<N>. The quotes keep the shell from reading brackets and spaces.

A row of the picture is a cache line. Nothing is compiled or allocated for it, so that layouts of any size can be drawn. In a
program, `field.memory_map()` tells the same of a field, and `allotrope_lab::lab::map::Drawing` draws it.";

/// Of `scene`.
pub(super) const SCENE: &str = "\
Examples:
  allotrope scene check my.toml other.toml
  allotrope scene show bunny";

/// Of `scene check`.
pub(super) const SCENE_CHECK: &str = "\
Examples:
  allotrope scene check my.toml other.toml      # status 2 if one of them is wrong";

/// Of `scene show`.
pub(super) const SCENE_SHOW: &str = "\
Examples:
  allotrope scene show mpm88                    # a start for a scene of your own
  allotrope scene show dam-break --solver mpm   # where several solvers have a scene of this name
  allotrope scene show my.toml --set dt=1e-4";

/// Of `completions`.
pub(super) const COMPLETIONS: &str = "\
Examples:
  allotrope completions bash                    # put it where bash looks for completions
  allotrope completions fish";
