//! The layouts in which the kernels are compiled. Each costs build time, so six are always there and the others stand
//! behind the feature `all-layouts`.

use allotrope::prelude::*;

use super::continuum::{plane, space};
use super::driver::Driver;
use super::fluid::Fluid;
use super::materials::Model;
use super::medium::Medium;
use super::stability;
use crate::scene::{Material, Particles, Scheme, Transfer, Wall};
use crate::{Built, LayoutInfo, Scene, SceneError};

/// A layout of particles, whatever their record.
trait OfPoints {
    type Fluid: Layout<I> + 'static;
    type Affine2: Layout<I> + 'static;
    type Affine3: Layout<I> + 'static;
    type Plain2: Layout<I> + 'static;
    type Plain3: Layout<I> + 'static;
    type Polynomial2: Layout<I> + 'static;
    type Polynomial3: Layout<I> + 'static;
}

/// Any layout that names no members serves all records.
macro_rules! for_all_records {
    ($($layout:ty),*) => {$(
        impl OfPoints for $layout {
            type Fluid = Self;
            type Affine2 = Self;
            type Affine3 = Self;
            type Plain2 = Self;
            type Plain3 = Self;
            type Polynomial2 = Self;
            type Polynomial3 = Self;
        }
    )*};
}

for_all_records!(Aos, Soa, Split, AoSoA<16>);

/// What both transfers touch lies together, what only the material needs lies apart.
struct Hot;

impl OfPoints for Hot {
    // A fluid's particles are hot all over.
    type Fluid = Aos;
    type Affine2 = plane::HotAffine;
    type Affine3 = space::HotAffine;
    type Plain2 = plane::HotPlain;
    type Plain3 = space::HotPlain;
    type Polynomial2 = plane::HotPolynomial;
    type Polynomial3 = space::HotPolynomial;
}

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
    "soa+soa": Soa, Soa, "an array for each member of particles and nodes";
    "split+split": Split, Split, "an array for each component of particles and nodes";
    "aosoa16+row": AoSoA<16>, Aos, "particles in groups of 16, an array for each member in a group; nodes interleaved";
    "hot+row": Hot, Aos, "members of particles that transfers need together, the others apart; nodes interleaved";
    "aosoa16+blocked4": AoSoA<16>, Blocked<4>, "particles in groups of 16; the grid in blocks of 4 nodes an axis";
    #[cfg(feature = "all-layouts")]
    "soa+row": Soa, Aos, "an array for each member of particles, nodes interleaved";
    #[cfg(feature = "all-layouts")]
    "hot+blocked4": Hot, Blocked<4>, "members of particles that transfers need together, the others apart; blocks of 4";
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

/// Whether a scene is a fluid alone, between walls without friction, in the usual transfer.
fn is_fluid(scene: &Scene) -> bool {
    let fluid = matches!(&*scene.materials, [Material { model: Model::Fluid { .. }, .. }]);
    fluid
        && scene.transfer == Transfer::default()
        && scene.colliders.is_empty()
        && scene.walls.iter().flatten().all(|wall| *wall == Wall::default())
}

/// Why a scene makes no sense in a layout, if it does not.
pub(super) fn unfit(scene: &Scene, layout: &str) -> Option<&'static str> {
    (layout.starts_with("hot+") && is_fluid(scene))
        .then_some("every member of a fluid's particles is used by both transfers, so that none can lie apart")
}

fn in_layouts<P, G>(scene: &Scene) -> Built
where
    P: OfPoints,
    G: Layout<Ij> + Layout<Ijk> + 'static,
{
    let particles = scene.particles()?;
    stability::check(scene, &particles)?;
    if is_fluid(scene) {
        return match scene.dimensions {
            2 => boxed::<Fluid<Ij, P::Fluid, G>>(scene, &particles),
            _ => boxed::<Fluid<Ijk, P::Fluid, G>>(scene, &particles),
        };
    }
    match (scene.transfer.scheme, scene.dimensions) {
        (Scheme::Apic, 2) => boxed::<plane::Continuum<plane::Affine, P::Affine2, G>>(scene, &particles),
        (Scheme::Apic, _) => boxed::<space::Continuum<space::Affine, P::Affine3, G>>(scene, &particles),
        (Scheme::Pic | Scheme::Flip { .. }, 2) => {
            boxed::<plane::Continuum<plane::Plain, P::Plain2, G>>(scene, &particles)
        }
        (Scheme::Pic | Scheme::Flip { .. }, _) => {
            boxed::<space::Continuum<space::Plain, P::Plain3, G>>(scene, &particles)
        }
        (Scheme::PolyPic { .. }, 2) => {
            boxed::<plane::Continuum<plane::Polynomial, P::Polynomial2, G>>(scene, &particles)
        }
        (Scheme::PolyPic { .. }, _) => {
            boxed::<space::Continuum<space::Polynomial, P::Polynomial3, G>>(scene, &particles)
        }
    }
}

fn boxed<M: Medium + 'static>(scene: &Scene, particles: &Particles) -> Built {
    Ok(Box::new(Driver::<M>::new(scene, particles)?))
}
