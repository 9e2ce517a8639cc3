//! Where the files that a scene names are looked for.

use std::path::PathBuf;

/// The files of the built-in scenes that are not scenes themselves; a scene named `x` is the file `x.toml`.
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
    pub(crate) fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        match self {
            Self::BuiltIn => {
                let scenes = || crate::solvers().iter().flat_map(|solver| solver.scenes);
                let scene = |stem| scenes().find(|scene| scene.name == stem).map(|scene| scene.text.as_bytes());
                let other = BUILT_IN.iter().find(|(known, _)| *known == name).map(|(_, bytes)| *bytes);
                let bytes = other.or_else(|| scene(name.strip_suffix(".toml")?));
                bytes.map(<[u8]>::to_vec).ok_or_else(|| "is not among the files of the built-in scenes".into())
            }
            Self::Path(folder) => std::fs::read(folder.join(name)).map_err(|error| format!("cannot be read: {error}")),
        }
    }

    /// The name of a file in messages.
    pub(crate) fn label(&self, name: &str) -> String {
        match self {
            Self::BuiltIn => name.into(),
            Self::Path(folder) => folder.join(name).display().to_string(),
        }
    }
}
