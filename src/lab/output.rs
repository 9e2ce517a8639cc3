//! Files are written beside their place, brought to the disk and then renamed, so that there is never half a file; and
//! text is printed.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::errors::LabError;

/// Writes a file, or leaves what was there. When this returns the file is on the disk.
///
/// # Errors
/// One line that names the file; of the machine, since what can be known beforehand is checked beforehand.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), LabError> {
    let beside = beside(path);
    let written = File::create(&beside).and_then(|mut file| {
        file.write_all(bytes)?;
        file.sync_all()
    });
    written.and_then(|()| fs::rename(&beside, path)).and_then(|()| keep_name(path)).map_err(|error| {
        // Nothing is left lying about; that it cannot be removed either is no news.
        let _ = fs::remove_file(&beside);
        LabError::machine(format!("`{}` cannot be written: {error}", path.display()))
    })
}

/// Prints results, and writes them as a line of JSON where a file is wanted.
///
/// # Errors
/// As [`write()`] and [`print()`].
pub fn results(text: &str, report: &impl serde::Serialize, json: Option<&Path>) -> Result<(), LabError> {
    print(text)?;
    json.map_or(Ok(()), |path| write(path, line_of_json(report)?.as_bytes()))
}

/// A value as a line of JSON.
///
/// # Errors
/// If it cannot be one.
pub fn line_of_json(value: &impl serde::Serialize) -> Result<String, LabError> {
    let line = serde_json::to_string(value).map_err(|error| LabError::failure(error.to_string()))?;
    Ok(format!("{line}\n"))
}

/// Where a file is written before it gets its name.
fn beside(path: &Path) -> PathBuf {
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.part", std::process::id()));
    PathBuf::from(beside)
}

/// Brings a new name to the disk: on Unix a folder is a file of names.
fn keep_name(path: &Path) -> std::io::Result<()> {
    if cfg!(unix) { File::open(above(path))?.sync_all() } else { Ok(()) }
}

/// The folder in which a file lies.
fn above(path: &Path) -> &Path {
    match path.parent() {
        Some(above) if !above.as_os_str().is_empty() => above,
        _ => Path::new("."),
    }
}

/// Makes a folder, with those above it, checks that files can be written into it, and removes what a run that was
/// killed in the middle of a file has left there.
///
/// # Errors
/// One line that names the folder.
pub fn folder(path: &Path) -> Result<(), LabError> {
    let probe = path.join(format!(".{}.part", std::process::id()));
    let fault = |error| LabError::machine(format!("folder `{}` cannot be written to: {error}", path.display()));
    fs::create_dir_all(path)
        .and_then(|()| fs::write(&probe, []))
        .and_then(|()| fs::remove_file(&probe))
        .map_err(fault)?;
    for entry in fs::read_dir(path).map_err(fault)?.flatten() {
        if entry.file_name().to_str().is_some_and(left_over) {
            // Whoever removed it first did what was wanted.
            let _ = fs::remove_file(entry.path());
        }
    }
    Ok(())
}

/// Whether a name is that of an unfinished file, such as `frame_0007.png.1234.part`, or that of a probe of a folder.
fn left_over(name: &str) -> bool {
    let stem = name.strip_suffix(".part").and_then(|stem| stem.rsplit_once('.'));
    let Some((name, process)) = stem else { return false };
    let ours = ["frame_", "particles", "grid", "checkpoint.", "sheet.", "animation.", "sweep.", "report."];
    !process.is_empty()
        && process.bytes().all(|digit| digit.is_ascii_digit())
        && (name.is_empty() || ours.iter().any(|start| name.starts_with(start)))
}

/// Checks that a file can be written, before the work whose result it is to hold.
///
/// # Errors
/// One line that names the file.
pub fn writable(path: &Path) -> Result<(), LabError> {
    let message = |why: &str| format!("`{}` cannot be written: {why}", path.display());
    if path.is_dir() {
        return Err(LabError::usage(message("it is a folder")));
    }
    let probe = above(path).join(format!(".{}.part", std::process::id()));
    fs::write(&probe, [])
        .and_then(|()| fs::remove_file(&probe))
        .map_err(|error| LabError::machine(message(&error.to_string())))
}

/// Prints text to the standard output. That nobody reads it any more (`allotrope list | head -1`) is no fault.
///
/// # Errors
/// If it cannot be written for another reason.
pub fn print(text: &str) -> Result<(), LabError> {
    let mut output = std::io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(LabError::machine(format!("the standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_whole_or_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame_0000.png");
        write(&path, b"first").unwrap();
        write(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        let error = write(&folder.path().join("no/such"), b"").unwrap_err();
        assert_eq!(error.status(), 3);
        assert!(error.to_string().contains("no/such` cannot be written: "), "{error}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn only_unfinished_files_of_ours_are_removed() {
        let made = tempfile::tempdir().unwrap();
        let unfinished = ["frame_0007.png.1234.part", "checkpoint.npz.1.part", ".77.part"];
        let others = ["notes.1.part", "frame_0007.png", "frame_1.png.part", "frame_1..part", ".part"];
        let names = [&unfinished[..], &others].concat();
        for name in &names {
            fs::write(made.path().join(name), []).unwrap();
        }
        folder(made.path()).unwrap();
        let left: Vec<_> = names.into_iter().filter(|name| made.path().join(name).exists()).collect();
        assert_eq!(left, others);
    }
}
