//! The built-in scenes; the first is the default.

use crate::SceneInfo;

pub(super) const SCENES: &[SceneInfo] = &[
    SceneInfo {
        name: "mpm88",
        about: "2D: 8192 particles of fluid fall into a box of 128 x 128 nodes",
        text: include_str!("../../scenes/mpm88.toml"),
        gate: None,
    },
    SceneInfo {
        name: "bunny",
        about: "3D: the Stanford bunny of fluid is dropped into a box of 64 x 64 x 64 nodes",
        text: include_str!("../../scenes/bunny.toml"),
        gate: None,
    },
];
