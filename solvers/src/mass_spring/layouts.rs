//! The layouts in which the kernels are compiled. Each costs build time, so six are always there and the others stand
//! behind the feature `all-layouts`.

use allotrope::layout;
use allotrope::prelude::*;

use super::connectivity::{Connectivity, List, Matrix, Rows};
use super::driver::Driver;
use super::setup::SpringsSetup;
use crate::{Built, LayoutInfo, Scene, SceneError};

/// Blocks of pairs behind pointers, each pair active by itself.
type Pointer = layout!(pointer(ij).bitmasked(ij, 8).soa);

/// A line makes a pair of layouts: its name, the layout of masses, the connectivity, and a word about it.
macro_rules! layout_pairs {
    ($($(#[$condition:meta])* $name:literal: $masses:ty, $connectivity:ty, $sparse:literal, $about:literal;)*) => {
        /// The pairs, the default first.
        pub(super) const LAYOUTS: &[LayoutInfo] =
            &[$($(#[$condition])* LayoutInfo { name: $name, about: $about, sparse: $sparse },)*];

        /// The simulation of a scene in a pair of layouts.
        pub(super) fn build(scene: &Scene, layout: &str) -> Built {
            match layout {
                $($(#[$condition])* $name => Ok(Box::new(Driver::<$masses, $connectivity>::new(scene)?)),)*
                _ => Err(SceneError::new(&*scene.file, format!("`{layout}` is no layout of its solver"))),
            }
        }

        /// More masses than this are too many for a layout.
        fn most_masses(layout: &str) -> usize {
            match layout {
                $($(#[$condition])* $name => <$connectivity as Connectivity<$masses>>::MOST_MASSES,)*
                _ => usize::MAX,
            }
        }
    };
}

layout_pairs! {
    "aos+list": Aos, List<Aos>, true, "masses interleaved; one list of springs, each of which adds to both its masses";
    "soa+list": Soa, List<Soa>, true, "an array for each member of masses and springs; one list of springs";
    "aos+rows": Aos, Rows, true, "masses interleaved, each with a list of its springs";
    "soa+rows": Soa, Rows, true, "an array for each member of masses, each with a list of its springs";
    "aos+pointer": Aos, Matrix<Pointer>, true, "masses interleaved; a table of all pairs in blocks of 8 x 8 where there are springs";
    "aos+dense": Aos, Matrix<Soa>, false, "masses interleaved; a table of all pairs, for at most 2048 masses";
    #[cfg(feature = "all-layouts")]
    "split+list": Split, List<Split>, true, "an array for each component of masses and springs; one list of springs";
    #[cfg(feature = "all-layouts")]
    "aosoa8+list": AoSoA<8>, List<AoSoA<8>>, true, "masses and springs in groups of 8; one list of springs";
    #[cfg(feature = "all-layouts")]
    "split+rows": Split, Rows, true, "an array for each component of masses, each with a list of its springs";
    #[cfg(feature = "all-layouts")]
    "aos+sparse4": Aos, Matrix<Sparse<4>>, true, "masses interleaved; a table of all pairs in whole blocks of 4 x 4";
}

/// Why a scene makes no sense in a layout, if it does not.
pub(super) fn unfit(scene: &Scene, layout: &str) -> Option<&'static str> {
    let Ok(SpringsSetup { masses, .. }) = scene.setup() else {
        return Some("it is a scene of another solver");
    };
    (masses.len() > most_masses(layout))
        .then_some("too large: a dense table of all pairs is for at most 2048 masses; take `aos+list`")
}
