//! The built-in scenes; the first is the default.

use super::gates;
use crate::SceneInfo;

/// A line makes a scene: its name, a word about it, and its check.
macro_rules! scenes {
    ($($name:literal: $about:literal, $gate:expr;)*) => {
        pub(super) const SCENES: &[SceneInfo] = &[$(SceneInfo {
            name: $name,
            about: $about,
            text: include_str!(concat!("../../../scenes/wcsph/", $name, ".toml")),
            gate: $gate,
        },)*];
    };
}

scenes! {
    "dam-break": "2D: a column of water collapses in a tank (Martin & Moyce 1952)", Some(gates::dam_break);
    "dam-break-3d": "3D: a column of water collapses in a tank, between side walls", None;
    "hydrostatic": "2D: water at rest in a tank, under gravity that rises slowly", Some(gates::hydrostatic);
    "elliptical-drop": "2D: a drop is stretched into an ellipse", Some(gates::elliptical_drop);
    "spheric2": "3D: water that was let go meets a box (Kleefsman et al. 2005)", None;
    "bunny-drop": "3D: the Stanford bunny of fluid is dropped into a tank", None;
}
