//! Checks a folder of programs in one go: each must have exactly the errors that its comments name.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

/// Lines with their errors' codes.
type Errors = BTreeSet<(u64, String)>;

/// Checks every program of a folder.
///
/// # Panics
/// Where errors are missing, or others come.
pub(crate) fn check(folder: &str) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let project = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("ui_rustc");
    let cases = collect(&root.join(folder), &project);
    write_manifest(&root, &project);
    let found = run(&project);
    let mut faults = String::new();
    for (name, expected) in &cases {
        let found = found.get(name).cloned().unwrap_or_default();
        for (line, code) in expected.difference(&found) {
            faults.push_str(&format!("{name}.rs:{line}: {code} is missing\n"));
        }
        for (line, code) in found.difference(expected) {
            faults.push_str(&format!("{name}.rs:{line}: {code} was not expected\n"));
        }
    }
    assert!(!cases.is_empty(), "no program in {folder}");
    assert!(faults.is_empty(), "{faults}");
}

/// Copies the programs into the project, and reads what they expect.
fn collect(folder: &Path, project: &Path) -> BTreeMap<String, Errors> {
    let programs = project.join("src/bin");
    // What an earlier run left there may have been removed since.
    let _ = fs::remove_dir_all(&programs);
    fs::create_dir_all(&programs).expect("a folder for the programs");
    let mut cases = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("the folder of cases") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("a program");
        fs::write(programs.join(format!("{name}.rs")), &text).expect("a copy of the program");
        let expected: Errors = (1..)
            .zip(text.lines())
            .filter_map(|(line, text)| text.split_once("//~ ").map(|(_, codes)| (line, codes)))
            .flat_map(|(line, codes)| codes.split_whitespace().map(move |code| (line, code.to_owned())))
            .collect();
        assert!(!expected.is_empty(), "{name}.rs expects no error");
        cases.insert(name, expected);
    }
    cases
}

fn write_manifest(root: &Path, project: &Path) {
    let manifest = format!(
        "[package]\nname = \"ui-rustc\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nallotrope = {{ path = {:?} }}\n",
        root
    );
    fs::write(project.join("Cargo.toml"), manifest).expect("a manifest");
    // The same versions as the workspace has.
    let lock = root.join("../Cargo.lock");
    if lock.exists() {
        fs::copy(lock, project.join("Cargo.lock")).expect("a copy of the lock file");
    }
}

/// The errors of each program.
fn run(project: &Path) -> BTreeMap<String, Errors> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["check", "--bins", "--keep-going", "--quiet", "--message-format=json"])
        .current_dir(project)
        .env("CARGO_TARGET_DIR", project.join("target"))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    let mut found: BTreeMap<String, Errors> = BTreeMap::new();
    let mut reports = 0;
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(report) = serde_json::from_str::<Value>(line) else { continue };
        if report["reason"] != "compiler-message" || report["message"]["level"] != "error" {
            continue;
        }
        reports += 1;
        let message = &report["message"];
        let Some(code) = message["code"]["code"].as_str() else { continue };
        let spans = message["spans"].as_array().map(Vec::as_slice).unwrap_or_default();
        let line = spans.iter().find(|span| span["is_primary"] == true).and_then(|span| span["line_start"].as_u64());
        let name = report["target"]["name"].as_str().unwrap_or_default().to_owned();
        found.entry(name).or_default().insert((line.unwrap_or(0), code.to_owned()));
    }
    assert!(reports > 0, "{}", String::from_utf8_lossy(&output.stderr));
    found
}
