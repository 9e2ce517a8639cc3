//! Builds a folder of programs in one go: each must have exactly the errors that its comments name, or none and run.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

/// Lines with their errors' codes.
type Errors = BTreeSet<(u64, String)>;

/// What must be done with programs that have no errors.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Until {
    Checked,
    Run,
}

/// Checks every program of a folder: it has the errors that its comments name, such as `//~ E0596`, and no others.
///
/// # Panics
/// Where errors are missing, or others come.
pub(crate) fn refuse(folder: &str) {
    let (project, programs) = project(folder, "ui_rustc", "2024");
    let found = build(&project, "check").errors;
    let mut faults = String::new();
    for (name, text) in &programs {
        let (expected, found) = (expected(text), found.get(name).cloned().unwrap_or_default());
        if expected.is_empty() {
            faults.push_str(&format!("{name}.rs expects no error\n"));
        }
        for (line, code) in expected.difference(&found) {
            faults.push_str(&format!("{name}.rs:{line}: {code} is missing\n"));
        }
        for (line, code) in found.difference(&expected) {
            faults.push_str(&format!("{name}.rs:{line}: {code} was not expected\n"));
        }
    }
    assert!(faults.is_empty(), "{faults}");
}

/// Checks that every program of a folder compiles in an edition, and runs it if asked to.
///
/// # Panics
/// Where one does not compile, or fails.
pub(crate) fn accept(folder: &str, edition: &str, until: Until) {
    let (project, programs) = project(folder, &format!("ui_pass_{edition}"), edition);
    let built = build(&project, if until == Until::Run { "build" } else { "check" });
    assert!(built.succeeded, "{}", built.messages);
    if until == Until::Run {
        for name in programs.keys() {
            let program = target(&project).join("debug").join(name).with_extension(env::consts::EXE_EXTENSION);
            let output = Command::new(program).output().expect("the program starts");
            assert!(output.status.success(), "{name}.rs\n{}", String::from_utf8_lossy(&output.stderr));
        }
    }
}

/// The errors that a program's comments name.
fn expected(text: &str) -> Errors {
    (1..)
        .zip(text.lines())
        .filter_map(|(line, text)| text.split_once("//~ ").map(|(_, codes)| (line, codes)))
        .flat_map(|(line, codes)| codes.split_whitespace().map(move |code| (line, code.to_owned())))
        .collect()
}

/// Whether a program is one of an edition: one that needs another says so with `//@ edition 2024`.
fn is_of(text: &str, edition: &str) -> bool {
    !text.lines().any(|line| line.strip_prefix("//@ edition ").is_some_and(|needed| needed != edition))
}

/// Makes a project of a folder's programs; gives where it is, and their texts by name.
fn project(folder: &str, name: &str, edition: &str) -> (PathBuf, BTreeMap<String, String>) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let project = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let binaries = project.join("src/bin");
    // What an earlier run left there may have been removed since.
    let _ = fs::remove_dir_all(&binaries);
    fs::create_dir_all(&binaries).expect("a folder for the programs");
    let mut programs = BTreeMap::new();
    for entry in fs::read_dir(root.join(folder)).expect("the folder of programs") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("a program");
        if is_of(&text, edition) {
            fs::write(binaries.join(format!("{name}.rs")), &text).expect("a copy of the program");
            programs.insert(name, text);
        }
    }
    assert!(!programs.is_empty(), "no program in {folder}");
    let package =
        format!("[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"{edition}\"\n\n[workspace]\n\n");
    let manifest = format!(
        "{package}[dependencies]\nallotrope = {{ path = {root:?} }}\n\n[profile.dev]\ndebug = false\nincremental = false\n"
    );
    fs::write(project.join("Cargo.toml"), manifest).expect("a manifest");
    // The same versions as the workspace has.
    let lock = root.join("../Cargo.lock");
    if lock.exists() {
        fs::copy(lock, project.join("Cargo.lock")).expect("a copy of the lock file");
    }
    (project, programs)
}

/// Where all projects are built, since what they depend on is the same.
fn target(project: &Path) -> PathBuf {
    project.with_file_name("programs")
}

/// What came of a build.
struct Built {
    succeeded: bool,
    /// The errors of each program.
    errors: BTreeMap<String, Errors>,
    /// Rustc's and cargo's words.
    messages: String,
}

fn build(project: &Path, command: &str) -> Built {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args([command, "--bins", "--keep-going", "--quiet", "--message-format=json"])
        .current_dir(project)
        .env("CARGO_TARGET_DIR", target(project))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    let mut built = Built { succeeded: output.status.success(), errors: BTreeMap::new(), messages: String::new() };
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(report) = serde_json::from_str::<Value>(line) else { continue };
        if report["reason"] != "compiler-message" || report["message"]["level"] != "error" {
            continue;
        }
        let message = &report["message"];
        built.messages.push_str(message["rendered"].as_str().unwrap_or_default());
        let Some(code) = message["code"]["code"].as_str() else { continue };
        let spans = message["spans"].as_array().map(Vec::as_slice).unwrap_or_default();
        let line = spans.iter().find(|span| span["is_primary"] == true).and_then(|span| span["line_start"].as_u64());
        let name = report["target"]["name"].as_str().unwrap_or_default().to_owned();
        built.errors.entry(name).or_default().insert((line.unwrap_or(0), code.to_owned()));
    }
    built.messages.push_str(&String::from_utf8_lossy(&output.stderr));
    built
}
