//! Films as MP4, made of the pictures by the program `ffmpeg`, where it is installed.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use crate::lab::errors::LabError;

const PROGRAM: &str = "ffmpeg";

/// Whether `ffmpeg` can be called.
pub fn available() -> bool {
    let mut command = Command::new(PROGRAM);
    command.arg("-version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Makes a film (H.264) of the first `count` pictures `frame_0000.png`, `frame_0001.png` and so on of a folder, so many
/// a second. It is written beside its place and then renamed.
///
/// # Errors
/// If `ffmpeg` is not installed; its own last line, if it fails.
pub fn write(frames: &Path, count: u64, frames_a_second: f64, path: &Path) -> Result<(), LabError> {
    write_by(Path::new(PROGRAM), frames, count, frames_a_second, path)
}

fn write_by(program: &Path, frames: &Path, count: u64, frames_a_second: f64, path: &Path) -> Result<(), LabError> {
    let fault = |why: String| LabError::failure(format!("`{}` cannot be written: {why}", path.display()));
    let path_in_full = std::path::absolute(path).map_err(|error| fault(error.to_string()))?;
    let mut beside = path_in_full.clone().into_os_string();
    beside.push(format!(".{}.part", std::process::id()));
    let beside = PathBuf::from(beside);
    let outcome = call(program, frames, count, frames_a_second, &beside).and_then(|output| {
        if output.status.success() {
            return std::fs::File::open(&beside)
                .and_then(|film| film.sync_all())
                .and_then(|()| std::fs::rename(&beside, &path_in_full))
                .map_err(|error| error.to_string());
        }
        let text = String::from_utf8_lossy(&output.stderr);
        let last = text.lines().map(str::trim).rfind(|line| !line.is_empty());
        Err(format!("`ffmpeg` failed: {}", last.map_or_else(|| output.status.to_string(), str::to_string)))
    });
    outcome.map_err(|why| {
        // What was begun is not left lying about.
        let _ = std::fs::remove_file(&beside);
        fault(why)
    })
}

/// The program runs in the folder of the pictures, since it would take a `%` of a folder's name for a place of digits.
fn call(program: &Path, frames: &Path, count: u64, frames_a_second: f64, output: &Path) -> Result<Output, String> {
    if !frames.is_dir() {
        return Err(format!("there is no folder `{}` with pictures", frames.display()));
    }
    let mut command = Command::new(program);
    command.current_dir(frames).stdin(Stdio::null());
    command.args(["-nostdin", "-y", "-v", "error", "-framerate", &frames_a_second.to_string()]);
    command.args(["-start_number", "0", "-i", "frame_%04d.png"]);
    // Pictures of a longer run that was in the folder before are left out.
    command.args(["-frames:v", &count.to_string()]);
    // The colours of this pixel format are stored for four pixels at once: sides are made even.
    command.args(["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-pix_fmt", "yuv420p"]);
    command.args(["-movflags", "+faststart", "-f", "mp4"]).arg(output);
    command.output().map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => {
            "the program `ffmpeg`, which makes films, is not installed; install it, or take a GIF".to_string()
        }
        _ => format!("`ffmpeg` cannot be called: {error}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_the_program_it_is_said_to_be_missing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("film.mp4");
        let error = write_by(&folder.path().join("no-such-program"), folder.path(), 3, 25.0, &path).unwrap_err();
        let message = error.to_string();
        assert!(
            message.starts_with(&format!("`{}` cannot be written: the program `ffmpeg`", path.display())),
            "{message}"
        );
        assert!(message.ends_with("is not installed; install it, or take a GIF"), "{message}");
        assert_eq!(error.status(), 1);
        let error = write_by(Path::new(PROGRAM), &folder.path().join("none"), 3, 25.0, &path).unwrap_err().to_string();
        assert!(error.contains("there is no folder `"), "{error}");
    }

    /// A script in the place of the program, which tells what it was asked for.
    #[cfg(unix)]
    fn stand_in(folder: &Path, script: &str) -> PathBuf {
        use std::os::unix::fs::PermissionsExt;
        let program = folder.join("stand-in.sh");
        std::fs::write(&program, format!("#!/bin/sh\nfor last; do :; done\n{script}\n")).unwrap();
        std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).unwrap();
        program
    }

    #[cfg(unix)]
    #[test]
    fn the_program_s_last_word_is_told_and_nothing_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let program =
            stand_in(folder.path(), "echo half > \"$last\"; echo one >&2; echo 'no space ' >&2; echo >&2; exit 3");
        let path = folder.path().join("film.mp4");
        std::fs::write(&path, "kept").unwrap();
        let message = write_by(&program, folder.path(), 3, 25.0, &path).unwrap_err().to_string();
        assert_eq!(message, format!("`{}` cannot be written: `ffmpeg` failed: no space", path.display()));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "kept");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[cfg(unix)]
    #[test]
    fn the_program_works_beside_and_its_file_is_renamed() {
        let folder = tempfile::tempdir().unwrap();
        let program = stand_in(folder.path(), "printf '%s|' \"$(pwd)\" \"$@\" > \"$last\"");
        let frames = folder.path().join("100% frames");
        std::fs::create_dir(&frames).unwrap();
        let path = folder.path().join("film.mp4");
        write_by(&program, &frames, 3, 12.5, &path).unwrap();
        let told = std::fs::read_to_string(&path).unwrap();
        let words: Vec<&str> = told.split('|').collect();
        assert!(words[0].ends_with("/100% frames"), "{told}");
        for pair in [
            ["-framerate", "12.5"],
            ["-i", "frame_%04d.png"],
            ["-frames:v", "3"],
            ["-c:v", "libx264"],
            ["-pix_fmt", "yuv420p"],
        ] {
            assert!(words.windows(2).any(|words| words == pair), "{pair:?} is not in {told}");
        }
        assert!(words[words.len() - 2].ends_with(".part"), "{told}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
    }
}
