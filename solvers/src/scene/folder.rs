//! Where the files that a scene names are looked for.

use std::path::PathBuf;

/// The files of the built-in scenes.
const BUILT_IN: &[(&str, &[u8])] = &[("bunny.obj", include_bytes!("../../scenes/bunny.obj"))];

/// Where the files that a scene names are looked for.
#[derive(Clone, Debug)]
pub enum Folder {
    /// Among the files that are compiled in.
    BuiltIn,
    /// In a folder.
    Path(PathBuf),
}

impl Folder {
    /// The file's bytes, or why they cannot be had.
    pub(super) fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        match self {
            Self::BuiltIn => match BUILT_IN.iter().find(|(known, _)| *known == name) {
                Some((_, bytes)) => Ok(bytes.to_vec()),
                None => Err("is not among the files of the built-in scenes".into()),
            },
            Self::Path(folder) => std::fs::read(folder.join(name)).map_err(|error| format!("cannot be read: {error}")),
        }
    }
}
