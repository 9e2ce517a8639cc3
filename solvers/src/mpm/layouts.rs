//! The layouts in which the kernels are compiled. Each costs build time, so six are always there and the others stand
//! behind the feature `all-layouts`.

#[cfg(feature = "all-layouts")]
use allotrope::layout;
use allotrope::prelude::*;

use super::continuum::{Affine, Continuum, Dimensions, HotAffine, HotPlain, HotPolynomial, Plain, Polynomial};
use super::driver::Driver;
use super::fluid::Fluid;
use super::materials::Model;
use super::medium::Medium;
use super::setup::{Material, MpmSetup, Scheme, Transfer};
use super::stability;
use crate::layout_pairs::layout_pairs;
use crate::scene::{Particles, Wall};
use crate::{Built, Scene, SceneError};

/// A layout of particles, whatever their record.
trait OfPoints {
    /// Whether, with a grid that has bounds, transfers other than the usual are compiled in the default build too.
    const COMMON: bool;
    type Fluid: Layout<I> + 'static;
    type Affine<X: Dimensions>: Layout<I> + 'static;
    type Plain<X: Dimensions>: Layout<I> + 'static;
    type Polynomial<X: Dimensions>: Layout<I> + 'static;
}

/// Any layout that names no members serves all records.
macro_rules! for_all_records {
    ($($layout:ty: $common:literal),*) => {$(
        impl OfPoints for $layout {
            const COMMON: bool = $common;
            type Fluid = Self;
            type Affine<X: Dimensions> = Self;
            type Plain<X: Dimensions> = Self;
            type Polynomial<X: Dimensions> = Self;
        }
    )*};
}

for_all_records!(Aos: true, Soa: true, Split: false, AoSoA<16>: false);

/// What both transfers touch lies together, what only the material needs lies apart.
struct Hot;

impl OfPoints for Hot {
    const COMMON: bool = false;
    // A fluid's particles are hot all over.
    type Fluid = Aos;
    type Affine<X: Dimensions> = HotAffine<X>;
    type Plain<X: Dimensions> = HotPlain<X>;
    type Polynomial<X: Dimensions> = HotPolynomial<X>;
}

/// `pointer(..).pointer(.., 4).dense(.., 4).aos`, over any axes.
#[cfg(feature = "all-layouts")]
type Tree4 = layout::Grown<
    layout::Grid<{ layout::ALL }>,
    layout::Table<
        layout::Entry,
        layout::Table<layout::Dense<{ layout::ALL }, 4, 4, 4, 4, layout::Entry>, layout::Leaf>,
    >,
    Block4,
>;
/// `pointer(..).bitmasked(.., 4).aos`, over any axes.
#[cfg(feature = "all-layouts")]
type Bits4 =
    layout::Grown<layout::Grid<{ layout::ALL }>, layout::Table<layout::Entry, layout::Leaf>, layout::Masked<Block4>>;
#[cfg(feature = "all-layouts")]
type Block4 = layout::Dense<{ layout::ALL }, 4, 4, 4, 4, layout::PlaceAos>;

/// Whether a grid's memory follows what is active.
const fn follows<G: Layout<Ij>>() -> bool {
    G::SPARSE
}

layout_pairs! {
    in_layouts, follows;
    "aos+row": Aos, Aos, "particles and nodes interleaved, the grid row by row";
    "soa+soa": Soa, Soa, "an array for each member of particles and nodes";
    "hot+row": Hot, Aos, "members of particles that transfers need together, the others apart; nodes interleaved";
    "aosoa16+blocked4": AoSoA<16>, Blocked<4>, "particles in groups of 16; the grid in blocks of 4 nodes an axis";
    "aos+hash4": Aos, SparseHash<4>, "particles interleaved; blocks of 4 nodes an axis where there are particles, found by hashing";
    "aos+sparse4": Aos, Sparse<4>, "the same, found by pointers";
    #[cfg(feature = "all-layouts")]
    "aos+tree4": Aos, Tree4, "particles interleaved; blocks of 4 nodes an axis under pointers to pointers";
    #[cfg(feature = "all-layouts")]
    "aos+bits4": Aos, Bits4, "particles interleaved; blocks of 4 nodes an axis under pointers, each node active by itself";
    #[cfg(feature = "all-layouts")]
    "split+split": Split, Split, "an array for each component of particles and nodes";
    #[cfg(feature = "all-layouts")]
    "aosoa16+row": AoSoA<16>, Aos, "particles in groups of 16, an array for each member in a group; nodes interleaved";
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
fn is_fluid(setup: &MpmSetup) -> bool {
    let fluid = matches!(&*setup.materials, [Material { model: Model::Fluid { .. }, .. }]);
    fluid
        && setup.transfer == Transfer::default()
        && setup.colliders.is_empty()
        && setup.walls.iter().flatten().all(|wall| *wall == Wall::default())
}

/// Whether the memory of a layout's grid follows the particles.
fn is_sparse(layout: &str) -> bool {
    LAYOUTS.iter().any(|info| info.name == layout && info.sparse)
}

/// The layouts of the default build in which all transfers are compiled.
const COMMON: &[&str] = &["aos+row", "soa+soa", "aos+sparse4"];

/// Whether all transfers are compiled in a pair of layouts.
const fn has_all_transfers<P: OfPoints, G: Layout<X>, X: Axes>() -> bool {
    P::COMMON && !G::UNBOUNDED || cfg!(feature = "all-layouts")
}

/// Why a scene makes no sense in a layout, if it does not.
pub(super) fn unfit(scene: &Scene, layout: &str) -> Option<&'static str> {
    let Ok(setup) = scene.setup::<MpmSetup>() else { return Some("it is a scene of another solver") };
    if setup.sparse && !is_sparse(layout) {
        return Some(
            "its domain is larger than a dense grid can be: take a layout with a sparse one, such as `aos+hash4`",
        );
    }
    if !COMMON.contains(&layout) && setup.transfer != Transfer::default() && !cfg!(feature = "all-layouts") {
        return Some(
            "in the default build transfers other than APIC with quadratic splines and least squares go with some layouts alone: build with `--features all-layouts`",
        );
    }
    (layout.starts_with("hot+") && is_fluid(setup))
        .then_some("every member of a fluid's particles is used by both transfers, so that none can lie apart")
}

fn in_layouts<P, G>(scene: &Scene) -> Built
where
    P: OfPoints,
    G: Layout<Ij> + Layout<Ijk> + 'static,
{
    let setup = scene.setup::<MpmSetup>()?;
    let particles = scene.particles()?;
    stability::check(scene, setup, &particles)?;
    match scene.dimensions {
        2 => in_dimensions::<Ij, P, G>(scene, setup, &particles),
        _ => in_dimensions::<Ijk, P, G>(scene, setup, &particles),
    }
}

fn in_dimensions<X, P, G>(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Built
where
    X: Dimensions,
    P: OfPoints,
    G: Layout<X> + 'static,
{
    if is_fluid(setup) {
        return boxed::<Fluid<X, P::Fluid, G>>(scene, setup, particles);
    }
    // A condition on types: what it leaves out is not compiled.
    if const { has_all_transfers::<P, G, X>() } {
        return match setup.transfer.scheme {
            Scheme::Apic => boxed::<Continuum<X, Affine<true>, P::Affine<X>, G>>(scene, setup, particles),
            Scheme::Pic | Scheme::Flip { .. } => boxed::<Continuum<X, Plain, P::Plain<X>, G>>(scene, setup, particles),
            Scheme::PolyPic { .. } => boxed::<Continuum<X, Polynomial, P::Polynomial<X>, G>>(scene, setup, particles),
        };
    }
    if setup.transfer != Transfer::default() {
        return Err(SceneError::new(
            &*scene.file,
            "its transfer is not in this build in the layout that was asked for",
        ));
    }
    boxed::<Continuum<X, Affine<false>, P::Affine<X>, G>>(scene, setup, particles)
}

fn boxed<M: Medium + 'static>(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Built {
    Ok(Box::new(Driver::new::<M>(scene, setup, particles)?))
}
