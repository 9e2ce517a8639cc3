//! Files are written beside their place and then renamed, so that there is never half a file; and text is printed.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::errors::LabError;

/// Writes a file, or leaves what was there.
///
/// # Errors
/// One line that names the file.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), LabError> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.part", std::process::id()));
    let beside = PathBuf::from(beside);
    fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path)).map_err(|error| {
        // Nothing is left lying about; that it cannot be removed either is no news.
        let _ = fs::remove_file(&beside);
        LabError::usage(format!("`{}` cannot be written: {error}", path.display()))
    })
}

/// Makes a folder, with those above it, and checks that files can be written into it.
///
/// # Errors
/// One line that names the folder.
pub fn folder(path: &Path) -> Result<(), LabError> {
    let probe = path.join(format!(".{}.part", std::process::id()));
    fs::create_dir_all(path)
        .and_then(|()| fs::write(&probe, []))
        .and_then(|()| fs::remove_file(&probe))
        .map_err(|error| LabError::usage(format!("folder `{}` cannot be written to: {error}", path.display())))
}

/// Checks that a file can be written, before the work whose result it is to hold.
///
/// # Errors
/// One line that names the file.
pub fn writable(path: &Path) -> Result<(), LabError> {
    let fault = |why: String| LabError::usage(format!("`{}` cannot be written: {why}", path.display()));
    if path.is_dir() {
        return Err(fault("it is a folder".into()));
    }
    let above = match path.parent() {
        Some(above) if !above.as_os_str().is_empty() => above,
        _ => Path::new("."),
    };
    let probe = above.join(format!(".{}.part", std::process::id()));
    fs::write(&probe, []).and_then(|()| fs::remove_file(&probe)).map_err(|error| fault(error.to_string()))
}

/// Prints text to the standard output. That nobody reads it any more (`allotrope list | head -1`) is no fault.
///
/// # Errors
/// If it cannot be written for another reason.
pub fn print(text: &str) -> Result<(), LabError> {
    let mut output = std::io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(LabError::failure(format!("the standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}
