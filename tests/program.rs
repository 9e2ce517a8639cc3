//! The program, as it is called.

use std::path::Path;
use std::process::{Command, Output};

use allotrope_lab::lab::bench::Report;

fn allotrope(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    command.args(arguments).env_remove("ALLOTROPE_CPU").env_remove("ALLOTROPE_THREADS");
    command.output().unwrap()
}

fn succeeds(arguments: &[&str]) -> String {
    let output = allotrope(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The one line with which a command is refused.
fn refused(arguments: &[&str]) -> String {
    let output = allotrope(arguments);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
    assert!(message.starts_with("error: "), "{message}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    message["error: ".len()..].trim_end().to_string()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn list_tells_what_there_is() {
    let text = succeeds(&["list"]);
    for name in ["mpm", "mpm88", "bunny", "aos+row", "soa+soa", "split+split", "aosoa16+blocked4", "private", "atomic"]
    {
        assert!(text.split_whitespace().any(|word| word.trim_end_matches(':') == name), "{name}");
    }
}

#[test]
fn misuse_is_told_in_one_line_with_status_2() {
    let cases: &[(&[&str], &str)] = &[
        (&["rnu"], "unrecognized subcommand `rnu`; did you mean `run`?"),
        (&["run", "mmp"], "there is no solver `mmp`; did you mean `mpm`?"),
        (&["bench", "teapot"], "there is no solver `teapot`; known are `mpm`"),
        (&["run", "mpm", "--scene", "bunyn"], "scene `bunyn`: `mpm` has no scene of this name; did you mean `bunny`?"),
        (&["run", "mpm", "--scene", "no/such.toml"], "scene `no/such.toml`: cannot be read: No such file"),
        (
            &["run", "mpm", "--layout", "aosoa16+blocked"],
            "`mpm` has no layout `aosoa16+blocked`; did you mean `aosoa16+blocked4`?",
        ),
        (&["bench", "mpm", "--layouts", "aos+row,xyz"], "`mpm` has no layout `xyz`; known are `aos+row`"),
        (&["bench", "mpm", "--layouts", ","], "`--layouts` and `--schedules` each want at least one name"),
        (&["bench", "mpm", "--schedules", "serail"], "there is no schedule `serail`; did you mean `serial`?"),
        (&["run", "mpm", "--schedule", "coloured"], "there is no schedule `coloured`; known are `auto`, `serial`"),
        (&["run", "mpm", "--threads", "0"], "invalid value `0` for `--threads <N>`: it must be at least 1"),
        (
            &["run", "mpm", "--threads", "100000"],
            "invalid value `100000` for `--threads <N>`: 100000 threads are more than the",
        ),
        (
            &["run", "mpm", "--threads", "two"],
            "invalid value `two` for `--threads <N>`: a whole number above zero is wanted",
        ),
        (&["run", "mpm", "--steps", "0"], "invalid value `0` for `--steps <N>`"),
        (&["run", "mpm", "--stpes", "9"], "unexpected argument `--stpes` found; did you mean `--steps`?"),
        (&["run", "mpm", "--particles", "99999999999"], "scene `mpm88`: `particles = 99999999999` is not from 1 to"),
        (&["bench", "mpm", "--grid", "3"], "scene `mpm88`: `grid = 3` cannot be"),
        (&["run"], "the following required arguments were not provided: <SOLVER>"),
    ];
    for (arguments, wanted) in cases {
        let message = refused(arguments);
        assert!(message.contains(wanted), "{arguments:?}\n  gives {message}\n  wanted {wanted}");
    }
}

#[test]
fn what_cannot_be_written_is_refused_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "kept").unwrap();
    let below = file.join("below");
    let message = refused(&["run", "mpm", "--steps", "1", "--out", below.to_str().unwrap()]);
    assert!(message.starts_with(&format!("folder `{}` cannot be written to: ", below.display())), "{message}");
    let message = refused(&["bench", "mpm", "--steps", "1", "--json", below.to_str().unwrap()]);
    assert!(message.starts_with(&format!("`{}` cannot be written: ", below.display())), "{message}");
    let message = refused(&["bench", "mpm", "--steps", "1", "--json", folder.path().to_str().unwrap()]);
    assert!(message.ends_with("cannot be written: it is a folder"), "{message}");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
    assert_eq!(names(folder.path()), ["file"]);
}

#[test]
fn a_scene_file_is_refused_by_file_key_and_value() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pool.toml");
    let pool = include_str!("../solvers/scenes/mpm88.toml");
    let path_text = path.to_str().unwrap();
    let cases = [
        ("length = 1.0", "lenght = 1.0", "`lenght` is not a key of a scene; did you mean `length`?"),
        ("density = 1.0", "density = \"heavy\"", "`material.density = \"heavy\"` is a text, where a number is wanted"),
        ("density = 1.0", "density = -1.0", "`material.density = -1.0` must be above zero"),
        ("to = [0.6, 0.6]", "to = [0.6, 1.6]", "`body[0]` puts particle"),
        ("dt = 2e-4", "dt = 2e-3", "`dt = 2e-3` is unstable"),
        ("solver = \"mpm\"", "solver = \"mpn\"", "`solver` is wrong: there is no solver `mpn`; did you mean `mpm`?"),
    ];
    for (piece, by, wanted) in cases {
        std::fs::write(&path, pool.replace(piece, by)).unwrap();
        let message =
            refused(&["run", "mpm", "--scene", path_text, "--out", folder.path().join("out").to_str().unwrap()]);
        assert!(message.starts_with(&format!("scene `{path_text}`: {wanted}")), "{message}");
        assert_eq!(names(folder.path()), ["pool.toml"], "nothing is made before the scene is known to be right");
    }
    std::fs::write(&path, [0xff, 0xfe, 0x00]).unwrap();
    assert!(refused(&["bench", "mpm", "--scene", path_text]).ends_with("is not a text in UTF-8"));
}

#[test]
fn the_environment_is_checked_too() {
    for (variable, value) in [("ALLOTROPE_CPU", "mmx"), ("ALLOTROPE_THREADS", "0"), ("ALLOTROPE_THREADS", "many")] {
        let output = Command::new(env!("CARGO_BIN_EXE_allotrope")).arg("list").env(variable, value).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(
            message.starts_with("error: ") && message.contains(variable) && message.lines().count() == 1,
            "{message}"
        );
    }
}

#[test]
fn a_run_that_breaks_down_stops_with_one_line_and_status_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fast.toml");
    let fast = include_str!("../solvers/scenes/mpm88.toml").replace("[0.0, -9.8]", "[0.0, -2e5]");
    std::fs::write(&path, fast).unwrap();
    let out = folder.path().join("out");
    let output = allotrope(&["run", "mpm", "--scene", path.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.starts_with("error: stopped at step 1: particle 0 at (") && message.lines().count() == 1,
        "{message}"
    );
    assert_eq!(names(&out), ["frame_0000.png"]);
}

#[test]
fn run_writes_pictures_that_show_the_fluid() {
    for (scene, size, steps) in [("mpm88", (800, 800), "20"), ("bunny", (800, 700), "4")] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("made/here");
        let text = succeeds(&[
            "run",
            "mpm",
            "--scene",
            scene,
            "--layout",
            "soa+row",
            "--steps",
            steps,
            "--frames",
            "2",
            "--out",
            out.to_str().unwrap(),
        ]);
        assert!(text.contains(&format!("{steps} steps")) && text.contains("steps a second"), "{text}");
        assert_eq!(names(&out), ["frame_0000.png", "frame_0001.png", "frame_0002.png"]);
        let picture = |n: usize| image::open(out.join(format!("frame_000{n}.png"))).unwrap().to_rgb8();
        let (first, last) = (picture(0), picture(2));
        assert_eq!(first.dimensions(), size);
        assert_ne!(first, last, "{scene} does not move");
        // Fluid is bluish or warm and bright; there is about as much of it as the scene holds.
        let bright = first.pixels().filter(|pixel| pixel.0.iter().any(|&component| component > 120)).count() as f64;
        let share = bright / f64::from(size.0 * size.1);
        assert!((0.04..0.3).contains(&share), "{scene}: {share}");
    }
}

#[test]
fn bench_compares_layouts_and_writes_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bench.json");
    let text = succeeds(&[
        "bench",
        "mpm",
        "--layouts",
        "aos+row,aosoa16+blocked4",
        "--schedules",
        "private,serial",
        "--particles",
        "2000",
        "--grid",
        "48",
        "--threads",
        "2",
        "--steps",
        "22",
        "--json",
        path.to_str().unwrap(),
    ]);
    assert!(text.contains("2000 particles, 48 x 48 nodes") && text.contains("2 threads"), "{text}");
    assert!(text.contains("all 4 end in the same state") && text.contains("in 11 interleaved repetitions"), "{text}");
    let table: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("layout")).collect();
    assert_eq!(table.len(), 5, "{text}");
    for column in ["schedule", "ms/step", "spread", "scatter", "grid", "gather", "ns/particle", "MiB", "ratio"] {
        assert!(table[0].contains(column), "{column}");
    }

    let line = std::fs::read_to_string(&path).unwrap();
    assert_eq!(line.lines().count(), 1);
    assert_eq!(names(folder.path()), ["bench.json"]);
    assert!(
        line.starts_with(r#"{"solver":"mpm","scene":"mpm88","particles":2000,"grid":[48,48],"threads":2,"isa":""#),
        "{line}"
    );
    let keys = [
        r#""rows":[{"layout":"aos+row","schedule":"private","ms_per_step":"#,
        r#","spread":"#,
        r#","kernels":{"scatter":"#,
        r#","grid":"#,
        r#","gather":"#,
        r#","bytes":"#,
        r#","state_error":0.0},{"#,
    ];
    let mut rest = line.as_str();
    for key in keys {
        (_, rest) = rest.split_once(key).unwrap_or_else(|| panic!("{key} is not in its place in {line}"));
    }

    let report: Report = serde_json::from_str(&line).unwrap();
    let rows: Vec<_> = report.rows.iter().map(|row| (row.layout.as_str(), row.schedule.as_str())).collect();
    let layouts = [
        ("aos+row", "private"),
        ("aos+row", "serial"),
        ("aosoa16+blocked4", "private"),
        ("aosoa16+blocked4", "serial"),
    ];
    assert_eq!(rows, layouts);
    for row in &report.rows {
        assert!(row.ms_per_step > 0.0 && row.spread >= 0.0 && row.state_error < 1e-6, "{row:?}");
        assert!((2000 * 36 + 48 * 48 * 12..200_000).contains(&row.bytes), "{row:?}");
        let kernels: f64 = row.kernels.0.iter().map(|(_, time)| time).sum();
        // Medians of the parts against the median of the whole, on a machine that may be busy.
        assert!(row.kernels.0.len() == 3 && (0.3..2.0).contains(&(kernels / row.ms_per_step)), "{row:?}");
    }
}

#[test]
fn a_bench_of_many_particles_sorts_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bench.json");
    let json = path.to_str().unwrap();
    succeeds(&[
        "bench",
        "mpm",
        "--layouts",
        "soa+soa",
        "--particles",
        "70000",
        "--grid",
        "256",
        "--steps",
        "2",
        "--json",
        json,
    ]);
    let report: Report = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert!(report.rows[0].kernels.0.iter().any(|(name, _)| name == "sort"));
}
