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
            gate: $gate,
        },)*];
    };
}

scenes! {
    "mpm88": "2D: 8192 particles of fluid fall into a box of 128 x 128 nodes", Some(gates::free_fall);
    "three-materials": "2D: jelly and snow fall into water", None;
    "dam-break": "2D: a column of water collapses in a tank", Some(gates::dam_break);
    "bunny": "3D: the Stanford bunny of fluid is dropped into a box of 64 x 64 x 64 nodes", Some(gates::free_fall);
    "bunny-large": "3D: the bunny of fluid splashes on the floor of a hall of 1024^3 nodes, for sparse grids", None;
    "snowball": "3D: two snowballs meet in the air and burst", Some(gates::free_fall);
    "sand-column": "2D: a column of sand slumps over a rough floor", Some(gates::sand_column);
    "disks": "2D: two elastic disks collide and part", Some(gates::disks);
    "spinning-disk": "2D: an elastic disk that spins freely", Some(gates::spinning_disk);
}
