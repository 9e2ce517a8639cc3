//! What is wrong with a scene, in one line.

use std::fmt;

/// A fault of a scene: the file, the key and its value where there is one, and what to write instead.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    file: String,
    key: Option<String>,
    message: String,
    memory: bool,
}

impl SceneError {
    /// A fault of the whole file, or of a built-in scene.
    pub fn new(file: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: file.into(), key: None, message: message.into(), memory: false }
    }

    /// That the machine refuses the memory for a scene.
    pub(crate) fn memory(file: impl Into<String>, message: impl fmt::Display) -> Self {
        Self::new(file, format!("{message}; take fewer particles or a coarser grid")).of_memory()
    }

    /// The same, but as a lack of memory.
    pub(crate) fn of_memory(mut self) -> Self {
        self.memory = true;
        self
    }

    /// Whether the machine lacks the memory, which is no fault of the scene.
    pub fn is_memory(&self) -> bool {
        self.memory
    }

    /// A fault of one key. `key` may tell the value: `dt = -1`.
    pub(crate) fn at(file: impl Into<String>, key: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: file.into(), key: Some(key.into()), message: message.into(), memory: false }
    }

    /// The way to the key from the top, with the numbers of lists: `body`, `0`, `velocity`. Empty, if it is a fault of
    /// no key.
    pub(crate) fn path(&self) -> Vec<String> {
        let key = self.key.as_deref().unwrap_or_default();
        let key = key.split(" = ").next().unwrap_or_default();
        key.split(['.', '[', ']']).filter(|part| !part.is_empty()).map(str::to_string).collect()
    }

    /// The same with a word about it in parentheses.
    pub(crate) fn with_note(mut self, note: &str) -> Self {
        self.message = format!("{} ({note})", self.message);
        self
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, key, message, .. } = self;
        match key {
            Some(key) => write!(f, "scene `{file}`: `{key}` {message}"),
            None => write!(f, "scene `{file}`: {message}"),
        }
    }
}

impl std::error::Error for SceneError {}
