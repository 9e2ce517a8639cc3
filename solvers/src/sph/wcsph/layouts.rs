//! The layouts in which the kernels are compiled: of particles, and of neighbours. Each pair costs build time, so one for
//! each way of finding neighbours is always there and the others stand behind the feature `all-layouts`.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::driver::Driver;
#[cfg(feature = "all-layouts")]
use super::records::HotParticle;
use super::setup::WcsphSetup;
use crate::layout_pairs::layout_pairs;
use crate::scene::Particles;
use crate::sph::neighbours::{CellLists, HashedCells, NeighbourLists, Search, SortedCells};
use crate::{Built, Scene};

/// A layout of particles, in a plane and in space.
trait OfParticles {
    type In<X: Spatial>: Layout<I> + 'static;
}

/// Any layout that names no members serves all records.
macro_rules! for_all_records {
    ($($layout:ty),*) => {$(
        impl OfParticles for $layout {
            type In<X: Spatial> = Self;
        }
    )*};
}

for_all_records!(Aos, Soa, Split, AoSoA<16>);

/// What neighbours read lies together, the rest apart.
#[cfg(feature = "all-layouts")]
struct Hot;

#[cfg(feature = "all-layouts")]
impl OfParticles for Hot {
    type In<X: Spatial> = HotParticle<X>;
}

/// A way of finding neighbours, in a plane and in space.
trait OfNeighbours {
    type In<X: Spatial>: Search<X> + 'static;
}

macro_rules! ways {
    ($($name:ident: $search:ident;)*) => {$(
        struct $name;
        impl OfNeighbours for $name {
            type In<X: Spatial> = $search<X>;
        }
    )*};
}

ways! {
    InLists: NeighbourLists;
    InSorted: SortedCells;
    InCells: CellLists;
    InHash: HashedCells;
}

/// There is no grid.
#[expect(clippy::extra_unused_type_parameters, reason = "lists of pairs ask for each")]
const fn no_grid<N>() -> bool {
    false
}

layout_pairs! {
    in_layouts, no_grid;
    "aos+lists": Aos, InLists, "particles interleaved; for each a stored list of neighbours, with a skin";
    "aos+sorted": Aos, InSorted, "particles interleaved, in the order of their cells; where each cell begins";
    #[cfg(feature = "all-layouts")]
    "soa+sorted": Soa, InSorted, "an array for each member of particles, in the order of their cells";
    #[cfg(feature = "all-layouts")]
    "hot+lists": Hot, InLists, "what neighbours read together, accelerations apart; stored lists";
    "aos+cells": Aos, InCells, "particles interleaved; for each cell a list of those in it";
    "aos+hash": Aos, InHash, "the same, cells found by hashing, without bounds";
    #[cfg(feature = "all-layouts")]
    "soa+lists": Soa, InLists, "an array for each member of particles; stored lists";
    #[cfg(feature = "all-layouts")]
    "split+lists": Split, InLists, "an array for each component of particles; stored lists";
    #[cfg(feature = "all-layouts")]
    "aosoa16+lists": AoSoA<16>, InLists, "particles in groups of 16, an array for each member in a group; stored lists";
    #[cfg(feature = "all-layouts")]
    "split+sorted": Split, InSorted, "an array for each component of particles, in the order of their cells";
    #[cfg(feature = "all-layouts")]
    "aosoa16+sorted": AoSoA<16>, InSorted, "particles in groups of 16, in the order of their cells";
    #[cfg(feature = "all-layouts")]
    "hot+sorted": Hot, InSorted, "what neighbours read together, accelerations apart, in the order of cells";
    #[cfg(feature = "all-layouts")]
    "soa+cells": Soa, InCells, "an array for each member of particles; lists of cells";
    #[cfg(feature = "all-layouts")]
    "split+cells": Split, InCells, "an array for each component of particles; lists of cells";
    #[cfg(feature = "all-layouts")]
    "aosoa16+cells": AoSoA<16>, InCells, "particles in groups of 16; lists of cells";
    #[cfg(feature = "all-layouts")]
    "hot+cells": Hot, InCells, "what neighbours read together, accelerations apart; lists of cells";
    #[cfg(feature = "all-layouts")]
    "soa+hash": Soa, InHash, "an array for each member of particles; lists of cells found by hashing";
    #[cfg(feature = "all-layouts")]
    "split+hash": Split, InHash, "an array for each component of particles; lists of cells found by hashing";
    #[cfg(feature = "all-layouts")]
    "aosoa16+hash": AoSoA<16>, InHash, "particles in groups of 16; lists of cells found by hashing";
    #[cfg(feature = "all-layouts")]
    "hot+hash": Hot, InHash, "what neighbours read together, accelerations apart; lists of cells found by hashing";
}

/// No scene makes no sense in a layout.
pub(super) fn unfit(_: &Scene, _: &str) -> Option<&'static str> {
    None
}

fn in_layouts<P: OfParticles, N: OfNeighbours>(scene: &Scene) -> Built {
    let (setup, particles) = (scene.setup::<WcsphSetup>()?, scene.particles()?);
    match scene.dimensions {
        2 => in_dimensions::<Ij, P, N>(scene, setup, &particles),
        _ => in_dimensions::<Ijk, P, N>(scene, setup, &particles),
    }
}

fn in_dimensions<X: Spatial, P: OfParticles, N: OfNeighbours>(
    scene: &Scene,
    setup: &WcsphSetup,
    particles: &Particles,
) -> Built {
    Ok(Box::new(Driver::<X, P::In<X>, N::In<X>>::new(scene, setup, particles)?))
}
