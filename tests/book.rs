//! The book: every chapter is in its summary and among the tests of the documentation, its links lead somewhere, and its commands exist.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/book/src")
}

/// The chapters' names and texts.
fn chapters() -> Vec<(String, String)> {
    let files = fs::read_dir(source()).expect("the book's folder").map(|entry| entry.expect("an entry").path());
    let text = |path: PathBuf| {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        (name, fs::read_to_string(&path).expect("a chapter"))
    };
    let chapters = files.filter(|path| path.extension().is_some_and(|ending| ending == "md"));
    chapters.map(text).filter(|(name, _)| name != "SUMMARY").collect()
}

/// The targets of links: `[..](target)`.
fn links(text: &str) -> Vec<&str> {
    text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target).collect()
}

#[test]
fn every_chapter_is_listed_and_tested() {
    let names: BTreeSet<String> = chapters().into_iter().map(|(name, _)| name).collect();
    let summary = fs::read_to_string(source().join("SUMMARY.md")).expect("a summary");
    let listed: BTreeSet<String> = links(&summary).iter().map(|link| link.trim_end_matches(".md").to_owned()).collect();
    assert_eq!(listed, names);
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let module = fs::read_to_string(root.join("dsl-runtime/src/book.rs")).expect("the module of the book's tests");
    let (_, list) = module.split_once("\nchapters! {").expect("a list");
    let tested: BTreeSet<String> = list.trim_end().trim_end_matches('}').split_whitespace().map(String::from).collect();
    assert_eq!(tested, names);
}

#[test]
fn links_lead_somewhere() {
    let mut checked = 0;
    for (name, text) in chapters() {
        for link in links(&text).into_iter().filter(|link| !link.starts_with("http")) {
            let path = source().join(link.split('#').next().unwrap_or_default());
            assert!(path.exists(), "{name}.md links to {link}, which is not there");
            checked += 1;
        }
    }
    assert!(checked > 5, "only {checked} links");
}

/// The words of a line of a shell, of which some stand in quotes.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (n, piece) in line.split('\'').enumerate() {
        match n % 2 {
            0 => words.extend(piece.split_whitespace().map(String::from)),
            _ => words.push(piece.into()),
        }
    }
    words
}

/// Pictures of layouts in the book are those that the commands beside them make. With `ALLOTROPE_BLESS` set they are made anew.
#[test]
fn maps_are_what_their_commands_draw() {
    let mut checked = 0;
    for (name, text) in chapters() {
        for line in text.lines().filter(|line| line.starts_with("allotrope map ") && line.contains(" --out ")) {
            let words = words(line);
            let (arguments, file) = (&words[1..words.len() - 2], &words[words.len() - 1]);
            let output = Command::new(env!("CARGO_BIN_EXE_allotrope")).args(arguments).output().expect("runs");
            assert!(output.status.success(), "{name}.md: {line}: {}", String::from_utf8_lossy(&output.stderr));
            let path = source().join(file);
            if std::env::var_os("ALLOTROPE_BLESS").is_some() {
                fs::write(&path, &output.stdout).expect("a picture");
            }
            let kept = fs::read(&path).expect("a picture beside the chapter");
            assert!(kept == output.stdout, "{name}.md: {file} is not what `{line}` draws");
            assert!(links(&text).contains(&file.as_str()), "{name}.md does not show {file}");
            checked += 1;
        }
    }
    assert!(checked >= 1, "no map");
}

#[test]
fn commands_exist() {
    let mut checked = 0;
    for (name, text) in chapters() {
        for line in text.lines().filter(|line| line.starts_with("allotrope ")) {
            let words = words(line);
            let command = words.iter().skip(1).take_while(|word| !word.starts_with("--"));
            let output =
                Command::new(env!("CARGO_BIN_EXE_allotrope")).args(command).arg("--help").output().expect("runs");
            let help = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success(), "{name}.md: {line}");
            for option in line.split_whitespace().filter(|word| word.starts_with("--")) {
                assert!(help.contains(option), "{name}.md: {line}: there is no {option}");
            }
            checked += 1;
        }
    }
    assert!(checked >= 4, "only {checked} commands");
}
