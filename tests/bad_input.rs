//! What is wrong with what the program is given is told in one line, with a status.

use std::path::Path;
use std::process::{Command, Output};

/// A command, what is in its environment, the status and the whole of what it says.
struct Case {
    environment: &'static [(&'static str, &'static str)],
    arguments: &'static str,
    status: i32,
    message: &'static str,
}

/// What cannot be asked for.
const fn wrong(arguments: &'static str, message: &'static str) -> Case {
    Case { environment: &[], arguments, status: 2, message }
}

/// What the machine cannot do.
const fn machine(arguments: &'static str, message: &'static str) -> Case {
    Case { environment: &[], arguments, status: 3, message }
}

const COMMAND_LINES: &[Case] = &[
    wrong("rnu", "unrecognized subcommand `rnu`; did you mean `run`?"),
    wrong(
        "run",
        "the following required arguments were not provided: <SOLVER>; `allotrope --help` tells what there is",
    ),
    wrong("run mmp", "there is no solver `mmp`; did you mean `mpm`?"),
    wrong("scene show mpm88 --solver mmp", "there is no solver `mmp`; did you mean `mpm`?"),
    wrong("scene show mpm89 --solver mpm", "scene `mpm89`: `mpm` has no scene of this name; did you mean `mpm88`?"),
    wrong("list more", "unexpected argument `more` found; `allotrope --help` tells what there is"),
    wrong("run mpm --stpes 9", "unexpected argument `--stpes` found; did you mean `--steps`?"),
    wrong("run mpm --scene bunyn", "scene `bunyn`: `mpm` has no scene of this name; did you mean `bunny`?"),
    wrong(
        "run mpm --scene no/such.toml",
        "scene `no/such.toml`: cannot be read: No such file or directory (os error 2)",
    ),
    wrong("run mpm --layout sao+soa", "`mpm` has no layout `sao+soa`; did you mean `soa+soa`?"),
    wrong(
        "run mpm --schedule tiled",
        "there is no schedule `tiled`; known are `auto`, `serial`, `private`, `colored`, `atomic`",
    ),
    wrong("bench mpm --schedules serail", "there is no schedule `serail`; did you mean `serial`?"),
    wrong("report mmp", "there is no solver `mmp`; did you mean `mpm`?"),
    wrong("report mpm --scene bunyn", "scene `bunyn`: `mpm` has no scene of this name; did you mean `bunny`?"),
    wrong("report mpm --layouts soa+sao", "`mpm` has no layout `soa+sao`; did you mean `soa+soa`?"),
    wrong("report mpm --schedules serail", "there is no schedule `serail`; did you mean `serial`?"),
    wrong("report mpm --layouts ,", "`--layouts` and `--schedules` each want at least one name"),
    wrong("report mpm --budget 1e9", "`--budget 1000000000` is longer than a day, 86400 s"),
    wrong("report mpm --counts no/such.json", "`no/such.json` cannot be read: No such file or directory (os error 2)"),
    wrong("search mpm --steps 5", "`--steps` makes no sense of a search; `--budget` does"),
    wrong("search mpm --budget 1e9", "`--budget 1000000000` is longer than a day, 86400 s"),
    wrong("search springs --intervals 4", "`--intervals` makes no sense: `springs` sorts nothing"),
    wrong("search mpm --intervals often", "`--intervals often`: a number of steps, 0 for never, or `auto` is wanted"),
    wrong("run mpm --tuned no/such.toml", "`no/such.toml` cannot be read: No such file or directory (os error 2)"),
    wrong(
        "bench mpm --sweep length",
        "invalid value `length` for `--sweep <AXIS>` [possible values: size, particles-per-cell, sparsity, threads, order]; `allotrope --help` tells \
         what there is",
    ),
    wrong(
        "bench mpm --points 1,2",
        "the following required arguments were not provided: --sweep <AXIS>; `allotrope --help` tells what there is",
    ),
    wrong("bench mpm --sweep threads --points ,", "`--points` wants at least one value"),
    wrong("bench mpm --sweep threads --points 1,two", "point `two` of `--sweep threads` is no whole number above zero"),
    wrong(
        "bench mpm --sweep particles-per-cell --points 4,-1",
        "point `-1` of `--sweep particles-per-cell` is no number above zero",
    ),
    wrong(
        "bench mpm --sweep sparsity --points 2",
        "point `2` of `--sweep sparsity` is no number above zero and at most 1",
    ),
    wrong(
        "bench mpm --sweep sparsity --points 0.1,0.9",
        "point `0.9` of `--sweep sparsity` cannot be: the scene fills 0.156 of its cells, and can be given more room alone",
    ),
    wrong(
        "bench mpm --sweep order --points often",
        "point `often` of `--sweep order` cannot be: a number of steps, 0 for never, or `auto` is wanted",
    ),
    wrong(
        "bench mpm --sweep size --particles 100",
        "`--particles` is what `--sweep size` changes; leave it out, or ask for `--points`",
    ),
    wrong(
        "bench mpm --sweep order --reorder 8",
        "`--reorder` is what `--sweep order` changes; leave it out, or ask for `--points`",
    ),
    wrong(
        "bench mpm --sweep size --json x.json",
        "the argument `--sweep <AXIS>` cannot be used with `--json <FILE>`; `allotrope --help` tells what there is",
    ),
    wrong("convert-cost mpm aos+row aos+row", "`aos+row` is changed into itself; ask for two layouts"),
    wrong("convert-cost mpm aos+row soa+sao", "`mpm` has no layout `soa+sao`; did you mean `soa+soa`?"),
    wrong("convert-cost mmp aos+row soa+soa", "there is no solver `mmp`; did you mean `mpm`?"),
    wrong(
        "convert-cost mpm aos+row",
        "the following required arguments were not provided: <B>; `allotrope --help` tells what there is",
    ),
    wrong(
        "convert-cost mpm aos+row soa+soa --schedule serail",
        "there is no schedule `serail`; did you mean `serial`?",
    ),
    wrong("count mpm --layouts ,", "`--layouts` wants at least one name"),
    wrong("count mpm --threads 2", "accesses are counted on one thread, so that their order is always the same"),
    wrong(
        "count mpm --first-level 32",
        "invalid value `32` for `--first-level <KIB,WAYS>`: KiB and ways are wanted, with a comma between them: `32,8`",
    ),
    wrong("compare taichi --workloads jacoby", "there is no workload `jacoby`; did you mean `jacobi`?"),
    wrong("compare taichi --workloads ,", "`--workloads` wants at least one name"),
    wrong("compare taichi --pairs 4", "invalid value `4` for `--pairs <N>`: 4 is not in 5..=1000"),
    wrong(
        "run mpm --reorder often",
        "invalid value `often` for `--reorder <N>`: a number of steps, 0 for never, or `auto` is wanted",
    ),
    wrong("bench mpm --layouts ,", "`--layouts` and `--schedules` each want at least one name"),
    wrong("run mpm --threads 0", "invalid value `0` for `--threads <N>`: it must be at least 1"),
    wrong("run mpm --threads two", "invalid value `two` for `--threads <N>`: a whole number above zero is wanted"),
    wrong(
        "run mpm --threads 100000",
        "invalid value `100000` for `--threads <N>`: 100000 threads are more than the 256 that are supported",
    ),
    wrong("run mpm --steps 0", "invalid value `0` for `--steps <N>`: it must be at least 1"),
    wrong("run mpm --particles 99999999999", "scene `mpm88`: `particles = 99999999999` is not from 1 to 33554432"),
    wrong("bench mpm --grid 3", "scene `mpm88`: `grid = 3` cannot be; an axis takes from 10 to 32768 nodes"),
    wrong("run mpm --shading colour", "there is no shading `colour`; known are `velocity`, `material`, `pressure`"),
    wrong(
        "run mpm --export obj",
        "invalid value `obj` for `--export <A,B>` [possible values: ply, npz, vtk]; `allotrope --help` tells what \
         there is",
    ),
    wrong(
        "run mpm --progress loud",
        "invalid value `loud` for `--progress <P>` [possible values: auto, bar, plain, json, none]; `allotrope --help` \
         tells what there is",
    ),
    wrong(
        "run mpm --frames 5 --every 5",
        "the argument `--frames <N>` cannot be used with `--every <N>`; `allotrope --help` tells what there is",
    ),
    wrong(
        "run mpm --frames 0 --gif",
        "`--frames 0` asks for no frames, of which `--gif`, `--mp4`, `--sheet` or `--export` would be made",
    ),
    wrong("run mpm --set dt", "scene `mpm88`: the override `dt` is not `key=value`; write, for example, `dt=1e-4`"),
    wrong("run mpm --set dt.x=1", "scene `mpm88`: the override `dt.x=1` goes into `dt`, which is a number"),
    wrong(
        "bench mpm --set body.7.seed=1",
        "scene `mpm88`: the override `body.7.seed=1` names no element of `body`, a list of 1; they are counted from \
         0, as in `body.0`",
    ),
    wrong(
        "run mpm --set lenght=2",
        "scene `mpm88`: `lenght` is not a key of a scene; did you mean `length`? (from the override `lenght=2`)",
    ),
    wrong(
        "run mpm --scene bunny --elevation 90",
        "scene `bunny`: `camera.elevation = 90.0` is not between -89 and 89 degrees, where up and down are seen (from \
         the override `camera.elevation=90.0`)",
    ),
    wrong("run mpm --zoom 0", "invalid value `0` for `--zoom <F>`: it must be above zero"),
    wrong("run mpm --azimuth inf", "invalid value `inf` for `--azimuth <A>`: a finite number is wanted"),
    wrong("run mpm --checkpoint-every 0", "invalid value `0` for `--checkpoint-every <N>`: it must be at least 1"),
    wrong(
        "run mpm --check --steps 5",
        "the argument `--check` cannot be used with `--steps <N>`; `allotrope --help` tells what there is",
    ),
    wrong("map x:Vce2 Aos", "record `x:Vce2`: column 3, `Vce2`: there is no element type `Vce2`; did you mean `Vec2`?"),
    wrong(
        "map f32 dens(ij).aos",
        "layout `dens(ij).aos`: column 1, `dens`: there is no node or place `dens`; did you mean `dense`?",
    ),
    wrong(
        "map f32 dense(ij).place([v])",
        "layout `dense(ij).place([v])`: column 18, `v`: the record is a bare element without a member `v`; write `.aos`, or `.split` for components apart",
    ),
    wrong(
        "map f32",
        "the following required arguments were not provided: <LAYOUT>...; `allotrope --help` tells what there is",
    ),
    wrong(
        "map f32 Aos --shape 8x8",
        "invalid value `8x8` for `--shape <N,M>`: one to four numbers with commas between them are wanted, `64,48` say",
    ),
    wrong(
        "map f32 dense(ij).aos --shape 8",
        "shape `8`: it has 1 extents, and the layout `dense(ij).aos` goes over `ij`; write `16,16`, say",
    ),
    wrong(
        "map f32 Aos --shape 2000000000,2000000000",
        "shape `2000000000,2000000000`: so many elements have more bytes than a machine can address; write a smaller shape",
    ),
    wrong(
        "map [u8;2000000] Aos",
        "record `[u8;2000000]`: column 5, `2000000`: the array is too long; a record of at most 1048576 bytes can be drawn",
    ),
    wrong(
        "map f32 Aos --active all",
        "the layout `Aos` has no sparse nodes, so that all its elements are active; leave the activity out",
    ),
    wrong(
        "map f32 Sparse<4> --active disk",
        "activity `disk`: column 1, `disk`: there is no pattern `disk`; did you mean `disc`?",
    ),
    wrong(
        "map f32 Sparse<4> --shape 4096,4096 --active all",
        "activity `all`: column 1, `all`: 16777216 elements are more than the 1048576 that can be looked at; write a smaller shape, or boxes: `0..8,0..8`",
    ),
    wrong("map f32 Aos --lines 0", "invalid value `0` for `--lines <N>`: 0 is not in 1..=2000"),
    wrong("map f32 Aos Soa", "`Soa` is a second layout; several are drawn on a page, with `--html FILE`"),
    wrong(
        "map f32 Aos --out a.svg --html b.html",
        "the argument `--out <FILE>` cannot be used with `--html <FILE>`; `allotrope --help` tells what there is",
    ),
    wrong("map f32 Aos --out .", "`.` cannot be written: it is a folder"),
    machine("map f32 Aos --out file/below", "`file/below` cannot be written: Not a directory (os error 20)"),
    wrong("scene chekc", "unrecognized subcommand `chekc`; did you mean `check`?"),
    wrong("scene show bunyn", "scene `bunyn`: `mpm` has no scene of this name; did you mean `bunny`?"),
    wrong(
        "completions sh",
        "invalid value `sh` for `<SHELL>` [possible values: bash, elvish, fish, powershell, zsh]; `allotrope --help` \
         tells what there is",
    ),
    wrong("bench mpm --json .", "`.` cannot be written: it is a folder"),
    machine("run mpm --out file/below", "folder `file/below` cannot be written to: Not a directory (os error 20)"),
    machine("bench mpm --json file/below", "`file/below` cannot be written: Not a directory (os error 20)"),
];

const ENVIRONMENTS: &[Case] = &[
    Case {
        environment: &[("ALLOTROPE_CPU", "mmx")],
        arguments: "list",
        status: 2,
        message: "ALLOTROPE_CPU: `mmx` is no instruction set: it is `baseline`, `avx2` or `avx512`",
    },
    Case {
        environment: &[("ALLOTROPE_THREADS", "0")],
        arguments: "list",
        status: 2,
        message: "ALLOTROPE_THREADS=0: give a number of threads from 1 to 256",
    },
    Case {
        environment: &[("ALLOTROPE_THREADS", "many")],
        arguments: "run mpm",
        status: 2,
        message: "ALLOTROPE_THREADS=many: give a number of threads from 1 to 256",
    },
];

/// A built-in scene of which a piece is replaced, and what is then said of the file `scene.toml`.
struct Edit {
    scene: &'static str,
    piece: &'static str,
    by: &'static str,
    message: &'static str,
}

const POOL: &str = include_str!("../solvers/scenes/mpm88.toml");
const BUNNY: &str = include_str!("../solvers/scenes/bunny.toml");

const fn edit(scene: &'static str, piece: &'static str, by: &'static str, message: &'static str) -> Edit {
    Edit { scene, piece, by, message }
}

const SCENES: &[Edit] = &[
    edit(POOL, "length = 1.0", "lenght = 1.0", "`lenght` is not a key of a scene; did you mean `length`?"),
    edit(
        POOL,
        "density = 1.0",
        "density = \"heavy\"",
        "`material.density = \"heavy\"` is a text, where a number is wanted",
    ),
    edit(
        POOL,
        "density = 1.0",
        "density = -1.0",
        "`material.density = -1.0` must be above zero; write, for example, `density = 1.0`",
    ),
    edit(
        POOL,
        "to = [0.6, 0.6]",
        "to = [0.6, 1.6]",
        "`body[0]` puts particle 4 at (0.355284, 1.431760) outside the domain, which reaches from 0.0039 on each axis \
         to (0.9883, 0.9883)",
    ),
    edit(
        POOL,
        "dt = 2e-4",
        "dt = 2e-3",
        "`dt = 2e-3` is unstable: with sound at 20.0000, particles at up to 1.0000 and cells of 0.007812 it must be at \
         most 2.668e-4",
    ),
    edit(
        POOL,
        "solver = \"mpm\"",
        "solver = \"mpn\"",
        "`solver` is wrong: there is no solver `mpn`; did you mean `mpm`?",
    ),
    edit(POOL, "version = 1", "version = 7", "`version = 7` must be there and 1, the version of the schema"),
    edit(POOL, "grid = 128", "grid = = 128", "line 6 is not TOML: extra `=`, expected nothing"),
    edit(POOL, "shape = \"box\"", "shape = \"bix\"", "`body[0].shape = \"bix\"` is no shape; did you mean `box`?"),
    edit(
        BUNNY,
        "bunny.obj",
        "gone.obj",
        "`body[0].file = \"gone.obj\"` cannot be read: No such file or directory (os error 2)",
    ),
    edit(
        BUNNY,
        "bunny.obj",
        "open.obj",
        "`body[0].file = \"open.obj\"` is not closed: 3 edges open, with a face on one side only, the first from \
         (0, 0, 0) to (1, 0, 0)",
    ),
    edit(
        BUNNY,
        "bunny.obj",
        "words.obj",
        "`body[0].file = \"words.obj\"` is not a readable OBJ file: position parse error",
    ),
    edit(
        POOL,
        "version = 1",
        "include = \"gone.toml\"\nversion = 1",
        "`include = \"gone.toml\"` needs `gone.toml`, which cannot be read: No such file or directory (os error 2)",
    ),
    edit(
        POOL,
        "version = 1",
        "include = \"scene.toml\"\nversion = 1",
        "`include = \"scene.toml\"` goes round in a circle: `scene.toml`, `scene.toml`",
    ),
    edit(
        POOL,
        "stiffness = 400.0",
        "model = \"honey\"",
        "`material.model = \"honey\"` is no model; known are `fluid`, `neo-hookean`, `corotated`, `snow`, `sand`",
    ),
    edit(
        POOL,
        "stiffness = 400.0",
        "model = \"snow\"\nstiffness = 400.0",
        "`material.stiffness = 400.0` is not a key of a material of the model `snow`, which takes `young`, `poisson`, \
         `hardening`, `compression`, `stretch`, `density`, `model`, `name`",
    ),
    edit(
        POOL,
        "stiffness = 400.0",
        "model = \"corotated\"\nyoung = 1e3\npoisson = 0.5",
        "`material.poisson = 0.5` must be above -1 and below 0.5, where a solid would bear no change of volume; \
         write, for example, `poisson = 0.3`",
    ),
    edit(
        POOL,
        "shape = \"box\"",
        "shape = \"box\"\nmaterial = \"jelly\"",
        "`body[0].material = \"jelly\"` is not the name of a material; known are `fluid`",
    ),
    edit(
        POOL,
        "[material]",
        "[transfer]\nscheme = \"aipc\"\n\n[material]",
        "`transfer.scheme = \"aipc\"` is no scheme; did you mean `apic`?",
    ),
    edit(
        POOL,
        "[material]",
        "[walls.flor]\ncontact = \"slip\"\n\n[material]",
        "`walls.flor` is not a key of a scene; did you mean `floor`?",
    ),
    edit(
        POOL,
        "[material]",
        "[walls]\ncontact = \"slippy\"\n\n[material]",
        "`walls.contact = \"slippy\"` is no contact; did you mean `slip`?",
    ),
    edit(
        POOL,
        "[material]",
        "[[collider]]\nshape = \"bal\"\n\n[material]",
        "`collider[0].shape = \"bal\"` is no shape; did you mean `ball`?",
    ),
    edit(
        POOL,
        "[material]",
        "[camera]\nzoom = 2.0\n\n[material]",
        "`camera = { zoom = 2.0 }` is for `dimensions = 3`; the whole of a plane is seen",
    ),
    edit(
        BUNNY,
        "[material]",
        "[camera]\nelevation = 90.0\n\n[material]",
        "`camera.elevation = 90.0` is not between -89 and 89 degrees, where up and down are seen",
    ),
    edit(
        POOL,
        "seed = 88",
        "seed = 88\naligned = true",
        "`body[0].particles = 8192` asks for random particles, and `aligned` puts them on the grid's lattice; leave \
         one out",
    ),
];

const CHECKPOINTS: &[Case] = &[
    wrong("run --resume gone.npz", "checkpoint `gone.npz` cannot be read: No such file or directory (os error 2)"),
    wrong("run --resume .", "checkpoint `.` cannot be read: Is a directory (os error 21)"),
    wrong(
        "run --resume file",
        "checkpoint `file` is cut off, damaged or no `.npz` file at all (4 bytes): invalid Zip archive: Could not find \
         EOCD",
    ),
];

fn allotrope(folder: &Path, arguments: &str, environment: &[(&str, &str)]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    command.args(arguments.split_whitespace()).current_dir(folder);
    command.env_remove("ALLOTROPE_CPU").env_remove("ALLOTROPE_THREADS").envs(environment.iter().copied());
    command.output().unwrap()
}

/// That a command says this one line on the standard error, and nothing else, and leaves the folder as it was.
fn says(folder: &Path, Case { environment, arguments, status, message }: &Case) {
    let before = names(folder);
    let output = allotrope(folder, arguments, environment);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(said, format!("error: {message}\n"), "`{arguments}` {environment:?}");
    assert_eq!(output.status.code(), Some(*status), "`{arguments}` {environment:?}: {said}");
    assert!(output.stdout.is_empty(), "`{arguments}` {environment:?}");
    assert_eq!(names(folder), before, "`{arguments}` {environment:?}");
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = entries.collect();
    names.sort();
    names
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "kept").unwrap();
    folder
}

#[test]
fn command_lines() {
    let folder = folder();
    COMMAND_LINES.iter().for_each(|case| says(folder.path(), case));
    // All solvers are named, however many there are.
    let names: Vec<_> = allotrope_solvers::solvers().iter().map(|solver| solver.name).collect();
    let message = format!("there is no solver `teapot`; known are `{}`", names.join("`, `"));
    says(folder.path(), &wrong("bench teapot", message.leak()));
    assert_eq!(std::fs::read_to_string(folder.path().join("file")).unwrap(), "kept");
}

#[test]
fn environments() {
    let folder = folder();
    ENVIRONMENTS.iter().for_each(|case| says(folder.path(), case));
}

#[test]
fn scene_files() {
    let folder = folder();
    std::fs::write(folder.path().join("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    std::fs::write(folder.path().join("words.obj"), "v 0 zero 0\n").unwrap();
    let file = folder.path().join("scene.toml");
    for Edit { scene, piece, by, message } in SCENES {
        assert!(scene.contains(piece), "{piece}");
        std::fs::write(&file, scene.replace(piece, by)).unwrap();
        let message: &'static str = format!("scene `scene.toml`: {message}").leak();
        says(folder.path(), &wrong("run mpm --scene scene.toml", message));
        says(folder.path(), &wrong("scene check scene.toml", message));
    }
    std::fs::write(&file, [0xff, 0xfe, 0x00]).unwrap();
    says(folder.path(), &wrong("bench mpm --scene scene.toml", "scene `scene.toml`: is not a text in UTF-8"));
}

#[test]
fn checkpoints() {
    let folder = folder();
    CHECKPOINTS.iter().for_each(|case| says(folder.path(), case));
}

/// Runs under a limit that the shell sets.
#[cfg(target_os = "linux")]
fn limited(folder: &Path, limit: &str, arguments: &str) -> (Option<i32>, String) {
    let program = env!("CARGO_BIN_EXE_allotrope");
    let script = format!("{limit}; exec '{program}' {arguments}");
    let mut command = Command::new("sh");
    command.args(["-c", &script]).current_dir(folder);
    let output = command.env_remove("ALLOTROPE_CPU").env_remove("ALLOTROPE_THREADS").output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[cfg(target_os = "linux")]
#[test]
fn short_memory_is_the_machine_s_fault() {
    let folder = folder();
    let (status, said) = limited(folder.path(), "ulimit -v 600000", "run mpm --grid 9000");
    assert_eq!(status, Some(3), "{said}");
    let refused = "a field of shape [9000, 9000] needs 972000000 bytes, which the system refuses";
    // On a machine that has less than this left it is refused before.
    let before =
        said.starts_with("error: scene `mpm88`: `grid = 9000 x 9000` takes 0.91 GiB for its 81000000 nodes, and ");
    let message = format!("error: scene `mpm88`: {refused}; take fewer particles or a coarser grid\n");
    assert!(said == message || before, "{said}");
    assert_eq!(names(folder.path()), ["file"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_the_machine_s_fault() {
    let folder = folder();
    let out = folder.path().join("out");
    // Of files, by their size: a picture fits into 2 MiB, the particles of 200000 do not.
    let (status, said) = limited(
        folder.path(),
        "ulimit -f 4096",
        "run mpm --particles 200000 --grid 256 --steps 2 --every 1 --export npz --out out --quiet",
    );
    assert_eq!(status, Some(3), "{said}");
    assert_eq!(said, "error: `out/particles_0000.npz` cannot be written: File too large (os error 27)\n");
    assert_eq!(names(&out), ["frame_0000.png"], "nothing is left half written");
    image::open(out.join("frame_0000.png")).unwrap();
    // Of the standard output.
    let (status, said) = limited(folder.path(), "true", "list > /dev/full");
    assert_eq!(status, Some(3), "{said}");
    assert_eq!(said, "error: the standard output cannot be written: No space left on device (os error 28)\n");
}
