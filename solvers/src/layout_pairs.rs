//! The lists of layouts in which solvers are compiled: one line a pair.

/// Makes `LAYOUTS` and `build` of a list of pairs: `name: first layout, second layout, about;`, the default first. `build` calls the function
/// `$in_layouts::<first, second>(scene)`, and `$sparse::<second>()` tells what [`LayoutInfo::sparse`](crate::LayoutInfo::sparse) says.
///
/// Each pair costs build time: a few are always there, and the others stand behind the feature `all-layouts`.
macro_rules! layout_pairs {
    (
        $in_layouts:ident, $sparse:ident;
        $($(#[$condition:meta])* $name:literal: $first:ty, $second:ty, $about:literal;)*
    ) => {
        /// The pairs, the default first.
        pub(super) const LAYOUTS: &[crate::LayoutInfo] = &[$($(#[$condition])* crate::LayoutInfo {
            name: $name,
            about: $about,
            sparse: $sparse::<$second>(),
        },)*];

        /// The simulation of a scene in a pair of layouts.
        pub(super) fn build(scene: &crate::Scene, layout: &str) -> crate::Built {
            match layout {
                $($(#[$condition])* $name => $in_layouts::<$first, $second>(scene),)*
                _ => Err(crate::SceneError::new(&*scene.file, format!("`{layout}` is no layout of its solver"))),
            }
        }
    };
}
pub(crate) use layout_pairs;
