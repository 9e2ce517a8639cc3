//! A file is written beside its place, brought to the disk and then renamed, so that there is never half a file.

use core::sync::atomic::{AtomicU64, Ordering};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// Writes a file, or leaves what was there. When this returns the file is on the disk.
pub(super) fn write(path: &Path, content: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let beside = beside(path);
    let written = File::create(&beside).and_then(|mut file| {
        content(&mut file)?;
        file.sync_all()
    });
    written.and_then(|()| fs::rename(&beside, path)).and_then(|()| keep_name(path)).inspect_err(|_| {
        // Nothing is left lying about; that it cannot be removed either is no news.
        let _ = fs::remove_file(&beside);
    })
}

/// A name in the same folder that no other writer uses, in this process or another.
fn beside(path: &Path) -> PathBuf {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.{}.part", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed)));
    beside.into()
}

/// Brings a new name to the disk: on Unix a folder is a file of names.
fn keep_name(path: &Path) -> io::Result<()> {
    let above = path.parent().filter(|above| !above.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if cfg!(unix) { File::open(above)?.sync_all() } else { Ok(()) }
}
