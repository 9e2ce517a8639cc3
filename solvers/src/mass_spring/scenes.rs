//! The built-in scenes; the first is the default.

use super::gates;
use crate::SceneInfo;

/// A line makes a scene: its name, a word about it, and its check.
macro_rules! scenes {
    ($($name:literal: $about:literal, $gate:expr;)*) => {
        pub(super) const SCENES: &[SceneInfo] = &[$(SceneInfo {
            name: $name,
            about: $about,
            text: include_str!(concat!("../../scenes/", $name, ".toml")),
            gate: Some($gate),
        },)*];
    };
}

scenes! {
    "three-points": "2D: three masses, joined where they are near, fall on the floor of a box", gates::three_points;
    "cloth": "3D: a cloth of 128 x 128 masses, held by two corners, swings down", gates::cloth;
    "pendulum": "2D: a mass on a stiff spring swings from sixty degrees", gates::pendulum;
    "chain": "2D: a standing wave along a chain of a hundred springs", gates::chain;
}
