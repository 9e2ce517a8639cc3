//! Runs that are interrupted, killed and gone on with.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use allotrope_lab::lab::export::npz;
use serde_json::Value;

/// A scene that is run in a moment, sorted every few steps.
const SMALL: &[&str] = &[
    "run",
    "mpm",
    "--layout",
    "soa+soa",
    "--particles",
    "600",
    "--grid",
    "32",
    "--reorder",
    "7",
    "--threads",
    "2",
    "--deterministic",
    "--export",
    "npz",
];

fn allotrope(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    command.args(arguments).env_remove("ALLOTROPE_CPU").env_remove("ALLOTROPE_THREADS");
    command
}

/// A run of the small scene into a folder.
fn small(out: &Path, more: &[&str]) -> Command {
    let mut command = allotrope(SMALL);
    command.arg("--out").arg(out).args(more);
    command
}

fn resume(out: &Path) -> Command {
    let mut command = allotrope(&["run", "--resume"]);
    command.arg(out.join("checkpoint.npz"));
    command
}

fn succeeds(mut command: Command) -> String {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The one line with which a command is refused.
fn refused(mut command: Command) -> String {
    let Output { status, stdout, stderr } = command.output().unwrap();
    let message = String::from_utf8(stderr).unwrap();
    assert_eq!(status.code(), Some(2), "{command:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{command:?}: {message}");
    assert!(stdout.is_empty(), "{command:?}");
    message.strip_prefix("error: ").unwrap().trim_end().to_string()
}

/// The files of a folder with their bytes, by name.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap()))
        .collect();
    files.sort();
    files
}

/// That two folders hold the same files, bit by bit.
fn same(a: &Path, b: &Path, when: &str) {
    let (a, b) = (files(a), files(b));
    let names = |files: &[(String, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&a), names(&b), "{when}");
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        assert!(a == b, "{when}: `{name}` differs");
    }
}

/// That a file that was told to be written is there and whole.
fn decodes(file: &Path) {
    let bytes = std::fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    match file.extension().and_then(|extension| extension.to_str()) {
        Some("npz") => drop(npz::read(&bytes).unwrap_or_else(|why| panic!("{}: {why}", file.display()))),
        _ => drop(image::load_from_memory(&bytes).unwrap_or_else(|why| panic!("{}: {why}", file.display()))),
    }
}

/// The files that lines of JSON tell of.
fn told(lines: &[String]) -> Vec<PathBuf> {
    let mut told = Vec::new();
    for line in lines {
        let event: Value = serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
        let lists = ["exports", "files"].into_iter().filter_map(|key| event[key].as_array()).flatten();
        told.extend(lists.chain([&event["file"]]).filter_map(Value::as_str).map(PathBuf::from));
    }
    told
}

#[test]
fn a_resumed_run_is_the_uninterrupted_one_to_the_bit() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, parted) = (folder.path().join("whole"), folder.path().join("parted"));
    let plan = ["--every", "20", "--checkpoint-every", "15", "--gif"];
    succeeds(small(&whole, &[&plan[..], &["--steps", "90"]].concat()));
    // The end of the shorter run is out of turn for frames and for sorting.
    succeeds(small(&parted, &[&plan[..], &["--steps", "52"]].concat()));
    let mut further = resume(&parted);
    further.args(["--steps", "90", "--threads", "2"]);
    let text = succeeds(further);
    assert!(text.contains("; resumed after step 52 of 90\n") && text.contains("\n38 steps (to "), "{text}");
    same(&whole, &parted, "after 52 of 90 steps");
    assert!(files(&whole).iter().any(|(name, _)| name == "animation.gif"));

    // Other threads, named again and with the same options: nothing is left to do, and nothing changes but the header.
    let mut again = resume(&parted);
    again.args(["mpm", "--scene", "mpm88", "--layout", "soa+soa", "--grid", "32", "--particles", "600", "--out"]);
    let text = succeeds({
        again.arg(&parted);
        again
    });
    assert!(text.contains("\n0 steps (to "), "{text}");
    same(&whole, &parted, "after nothing");
}

#[test]
fn a_checkpoint_of_something_else_is_refused_with_the_difference() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    succeeds(small(&out, &["--steps", "6", "--every", "3", "--checkpoint-every", "3"]));
    let file = out.join("checkpoint.npz");
    let path = file.display();
    let differs = |key: &str, there: &str, here: &str| {
        format!(
            "checkpoint `{path}` does not fit: `{key}` is {here} here and {there} there; leave out what was not asked \
             for then, or start anew without `--resume`"
        )
    };
    let cases: &[(&[&str], String)] = &[
        (&["mpn"], differs("solver", "mpm", "mpn")),
        (&["--layout", "aos+row"], differs("layout", "soa+soa", "aos+row")),
        (&["--reorder", "8"], differs("reorder", "7", "8")),
        (&["--every", "2"], differs("every", "3", "2")),
        (&["--frames", "0"], differs("every", "3", "not set")),
        (&["--shading", "material"], differs("shading", "not set", "material")),
        (&["--schedule", "atomic"], differs("schedule", "auto", "atomic")),
        (&["--export", "npz,ply"], differs("export", "npz", "ply,npz")),
        (&["--steps", "5"], format!("`--steps 5` are fewer than the 6 that are done in checkpoint `{path}`")),
        (
            &["--out", "elsewhere"],
            format!(
                "`--out elsewhere` is not the folder of checkpoint `{path}`, in which the run goes on; leave it out"
            ),
        ),
    ];
    for (more, wanted) in cases {
        let mut command = resume(&out);
        command.args(*more);
        assert_eq!(&refused(command), wanted, "{more:?}");
    }
    for (more, wanted) in [
        (["--scene", "bunny"], "`body[0].file` is \"bunny.obj\" here and not given there"),
        (["--set", "material.density=2"], "`material.density` is 2 here and 1.0 there"),
        (["--particles", "700"], "`body[0].particles` is 700 here and 600 there"),
        (["--grid", "64"], "`dt` is 0.0004 here and 0.0008 there"),
    ] {
        let mut command = resume(&out);
        command.args(["mpm", more[0], more[1]]);
        let cure = "leave out what was not asked for then, or start anew without `--resume`";
        assert_eq!(refused(command), format!("checkpoint `{path}` is of another scene: {wanted}; {cure}"), "{more:?}");
    }
}

#[test]
fn what_is_no_checkpoint_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    succeeds(small(&out, &["--steps", "6", "--every", "3", "--checkpoint-every", "3"]));
    let file = out.join("checkpoint.npz");
    let path = file.display();
    let whole = std::fs::read(&file).unwrap();
    let npz = npz::read(&whole).unwrap();
    let arrays: Vec<_> = npz
        .arrays
        .iter()
        .map(|(name, components, values)| allotrope_solvers::Array {
            name: name.clone().leak(),
            components: *components,
            values: values.clone(),
        })
        .collect();
    let text = |name: &str| npz.texts.iter().find(|(known, _)| known == name).unwrap().1.clone();
    let (header, scene) = (text("checkpoint.json"), text("scene.toml"));
    let with = |header: &str| npz::write(&arrays, &[("checkpoint.json", header), ("scene.toml", &scene)]).unwrap();
    assert_eq!(with(&header), whole, "nothing else is in it");

    let more = scene.replace("particles = 600", "particles = 601");
    assert_ne!(more, scene);
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let cut = |end: usize| whole[..end].to_vec();
    let cases = [
        (cut(whole.len() - 100), "is cut off, damaged or no `.npz` file at all"),
        (cut(0), "is cut off, damaged or no `.npz` file at all (0 bytes)"),
        (b"not a checkpoint".to_vec(), "is cut off, damaged or no `.npz` file at all (16 bytes)"),
        (
            std::fs::read(out.join("particles_0001.npz")).unwrap(),
            "is no checkpoint: `checkpoint.json` or `scene.toml` is missing in it",
        ),
        (with("{"), "has a faulty `checkpoint.json`: "),
        (with(&header.replace("\"layout\"", "\"lay\"")), "has a faulty `checkpoint.json`: missing field `layout`"),
        (
            with(&header.replace("\"format\": 2", "\"format\": 3")),
            "does not fit: `format` is 2 here and 3 there; go on with the program that wrote it",
        ),
        (
            with(&header.replace(&version, "\"version\": \"0.0.9\"")),
            "does not fit: `version` is \"0.1.0\" here and \"0.0.9\" there; go on with the program that wrote it",
        ),
        (
            npz::write(&arrays[1..], &[("checkpoint.json", &header), ("scene.toml", &scene)]).unwrap(),
            &*format!("does not fit: array `{}` is missing", arrays[0].name),
        ),
        (
            npz::write(&arrays, &[("checkpoint.json", &header), ("scene.toml", &more)]).unwrap(),
            "does not fit: array `identity` holds 600 values of its kind, where 601 are wanted",
        ),
    ];
    for (bytes, wanted) in cases {
        std::fs::write(&file, &bytes).unwrap();
        let message = refused(resume(&out));
        assert!(message.starts_with(&format!("checkpoint `{path}` {wanted}")), "{message}\n  wanted {wanted}");
    }
    std::fs::remove_file(&file).unwrap();
    assert!(refused(resume(&out)).starts_with(&format!("checkpoint `{path}` cannot be read: No such file")));

    std::fs::write(&file, &whole).unwrap();
    let gone = out.join("frame_0001.png");
    std::fs::remove_file(&gone).unwrap();
    let message = refused(resume(&out));
    assert!(message.starts_with(&format!("picture `{}` of the earlier part is missing", gone.display())), "{message}");
}

/// Waits until a run has told so many lines, and gives them.
fn lines(child: &mut std::process::Child, count: usize) -> (Vec<String>, BufReader<std::process::ChildStdout>) {
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    let mut lines = Vec::new();
    while lines.len() < count {
        let mut line = String::new();
        assert!(reader.read_line(&mut line).unwrap() > 0, "it ended after {lines:?}");
        lines.push(line);
    }
    (lines, reader)
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_a_checkpoint_and_tells_how_to_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole");
    let plan = ["--steps", "400", "--every", "100", "--progress", "json"];
    succeeds(small(&whole, &plan));
    for (name, status) in [("INT", 130), ("TERM", 143)] {
        let out = folder.path().join(name);
        let mut child = small(&out, &plan).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // The start and two frames; then a signal, as a terminal sends it.
        let (mut told_lines, reader) = lines(&mut child, 3);
        let signal = Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap();
        assert!(signal.success());
        told_lines.extend(reader.lines().map(Result::unwrap));
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{message}");
        let file = out.join("checkpoint.npz");
        let cure = format!(" of 400; go on with `allotrope run --resume {}`\n", file.display());
        assert!(message.starts_with("interrupted after step ") && message.ends_with(&cure), "{message}");
        let told = told(&told_lines);
        assert!(told.contains(&file) && told.contains(&out.join("sheet.png")), "{told_lines:?}");
        told.iter().for_each(|file| decodes(file));
        assert!(told_lines[told_lines.len() - 1].contains(r#""reason":"interrupted""#), "{told_lines:?}");
        succeeds(resume(&out));
        std::fs::remove_file(&file).unwrap();
        same(&whole, &out, name);
    }
}

#[cfg(unix)]
#[test]
fn a_second_signal_ends_a_run_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let plan = ["--steps", "1000000", "--every", "20", "--progress", "json"];
    let mut child = small(&out, &plan).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let (mut told_lines, reader) = lines(&mut child, 20);
    // After the first one a sheet is to be made of many pictures, which takes longer than to send the second.
    let script = format!("kill -INT {0}; kill -TERM {0}", child.id());
    assert!(Command::new("sh").args(["-c", &script]).status().unwrap().success());
    told_lines.extend(reader.lines().map(Result::unwrap));
    let output = child.wait_with_output().unwrap();
    assert!(matches!(output.status.code(), Some(130 | 143)), "{:?}", output.status);
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(!told_lines.iter().any(|line| line.contains(r#""event":"end""#)), "{told_lines:?}");
}

/// A generator of numbers from zero to one, for when to kill.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 40) as f64 / f64::from(1 << 24)
}

#[cfg(unix)]
#[test]
fn a_run_that_is_killed_twenty_times_ends_as_the_uninterrupted_one() {
    const PLAN: &[&str] = &["--steps", "240", "--every", "120", "--checkpoint-every", "30"];
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole");
    let start = Instant::now();
    succeeds(small(&whole, PLAN));
    let duration = start.elapsed();

    let seed = start.elapsed().as_nanos() as u64;
    let mut state = seed;
    let (mut kills, mut ends, mut legs) = (0, 0, 0);
    while kills < 20 || ends == 0 {
        let out = folder.path().join(format!("life{ends}"));
        let mut command = match out.join("checkpoint.npz").is_file() {
            true => resume(&out),
            false => small(&out, PLAN),
        };
        let mut child = command.args(["--progress", "json"]).stdout(Stdio::piped()).spawn().unwrap();
        if kills < 20 {
            let wait: Duration = duration.mul_f64(0.8 * random(&mut state));
            std::thread::sleep(wait);
            // If it has ended by itself, it was not killed.
            let _ = child.kill();
        }
        let output = child.wait_with_output().unwrap();
        legs += 1;
        assert!(legs < 200, "seed {seed}");
        // What was told before it was killed is whole; a line that was cut off was not told.
        let text = String::from_utf8(output.stdout).unwrap();
        let lines: Vec<_> = text.split_inclusive('\n').filter(|line| line.ends_with('\n')).map(String::from).collect();
        told(&lines).iter().for_each(|file| decodes(file));
        match output.status.code() {
            None => kills += 1,
            Some(0) => {
                same(&whole, &out, &format!("seed {seed}, {kills} kills"));
                ends += 1;
            }
            Some(other) => panic!("seed {seed}, {kills} kills: status {other}"),
        }
    }
}
