//! Tells the program which compiler built it: times are those of its code.

use std::process::Command;

fn main() {
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let told =
        Command::new(compiler).arg("--version").output().ok().and_then(|done| String::from_utf8(done.stdout).ok());
    println!("cargo::rustc-env=ALLOTROPE_COMPILER={}", told.as_deref().map_or("an unknown compiler", str::trim));
    println!("cargo::rerun-if-changed=build.rs");
}
