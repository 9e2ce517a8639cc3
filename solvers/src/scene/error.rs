//! What is wrong with a scene, in one line.

use std::fmt;

/// A fault of a scene: the file, the key and its value where there is one, and what to write instead.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    file: String,
    key: Option<String>,
    message: String,
}

impl SceneError {
    /// A fault of the whole file, or of a built-in scene.
    pub fn new(file: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: file.into(), key: None, message: message.into() }
    }

    /// A fault of one key. `key` may tell the value: `dt = -1`.
    pub(crate) fn at(file: impl Into<String>, key: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: file.into(), key: Some(key.into()), message: message.into() }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, key, message } = self;
        match key {
            Some(key) => write!(f, "scene `{file}`: `{key}` {message}"),
            None => write!(f, "scene `{file}`: {message}"),
        }
    }
}

impl std::error::Error for SceneError {}
