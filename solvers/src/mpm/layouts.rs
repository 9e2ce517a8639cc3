//! The layouts in which the fluid is compiled. Each costs build time, so six are always there and the others stand
//! behind the feature `all-layouts`.

use allotrope::prelude::*;

use super::driver::Driver;
use super::fluid_2d::Fluid2;
use super::fluid_3d::Fluid3;
use super::parameters::Mpm;
use super::stability;
use crate::{Built, LayoutInfo, Scene, SceneError};

/// A line makes a pair of layouts: its name, the layout of particles, that of the grid, and a word about it.
macro_rules! layout_pairs {
    ($($(#[$condition:meta])* $name:literal: $particles:ty, $grid:ty, $about:literal;)*) => {
        /// The pairs, the default first.
        pub(super) const LAYOUTS: &[LayoutInfo] = &[$($(#[$condition])* LayoutInfo { name: $name, about: $about },)*];

        /// The simulation of a scene in a pair of layouts.
        pub(super) fn build(scene: &Scene, layout: &str) -> Built {
            match layout {
                $($(#[$condition])* $name => in_layouts::<$particles, $grid>(scene),)*
                _ => Err(SceneError::new(&*scene.file, format!("`{layout}` is no layout of its solver"))),
            }
        }
    };
}

layout_pairs! {
    "aos+row": Aos, Aos, "particles and nodes interleaved, the grid row by row";
    "soa+row": Soa, Aos, "an array for each member of particles, nodes interleaved";
    "soa+soa": Soa, Soa, "an array for each member of particles and nodes";
    "split+split": Split, Split, "an array for each component of particles and nodes";
    "aosoa16+row": AoSoA<16>, Aos, "particles in groups of 16, an array for each member in a group; nodes interleaved";
    "aosoa16+blocked4": AoSoA<16>, Blocked<4>, "particles in groups of 16; the grid in blocks of 4 nodes an axis";
    #[cfg(feature = "all-layouts")]
    "aos+soa": Aos, Soa, "particles interleaved, an array for each member of nodes";
    #[cfg(feature = "all-layouts")]
    "aos+split": Aos, Split, "particles interleaved, an array for each component of nodes";
    #[cfg(feature = "all-layouts")]
    "aos+blocked4": Aos, Blocked<4>, "particles interleaved; the grid in blocks of 4 nodes an axis";
    #[cfg(feature = "all-layouts")]
    "soa+split": Soa, Split, "an array for each member of particles and each component of nodes";
    #[cfg(feature = "all-layouts")]
    "soa+blocked4": Soa, Blocked<4>, "an array for each member of particles; the grid in blocks of 4 nodes an axis";
    #[cfg(feature = "all-layouts")]
    "split+row": Split, Aos, "an array for each component of particles, nodes interleaved";
    #[cfg(feature = "all-layouts")]
    "split+soa": Split, Soa, "an array for each component of particles and each member of nodes";
    #[cfg(feature = "all-layouts")]
    "split+blocked4": Split, Blocked<4>, "an array for each component of particles; the grid in blocks of 4";
    #[cfg(feature = "all-layouts")]
    "aosoa16+soa": AoSoA<16>, Soa, "particles in groups of 16, an array for each member of nodes";
    #[cfg(feature = "all-layouts")]
    "aosoa16+split": AoSoA<16>, Split, "particles in groups of 16, an array for each component of nodes";
}

/// Why a scene makes no sense in a layout, if it does not.
pub(super) fn unfit(_scene: &Scene, _layout: &str) -> Option<&'static str> {
    None
}

fn in_layouts<P, G>(scene: &Scene) -> Built
where
    P: Layout<I> + 'static,
    G: Layout<Ij> + Layout<Ijk> + 'static,
{
    let particles = scene.particles()?;
    stability::check(scene, &particles)?;
    Ok(if scene.dimensions == 2 {
        Box::new(Driver::<Fluid2<P, G>>::new(scene, &particles, Mpm::plane(scene))?)
    } else {
        Box::new(Driver::<Fluid3<P, G>>::new(scene, &particles, Mpm::space(scene))?)
    })
}
