//! The layouts in which the kernels are compiled. Each costs build time, so one for each way to hold springs is always
//! there and the others stand behind the feature `all-layouts`.

use allotrope::layout;
use allotrope::prelude::*;

use super::connectivity::{Connectivity, List, MOST_DENSE, Matrix, Rows};
use super::driver::Driver;
use super::setup::SpringsSetup;
use crate::layout_pairs::layout_pairs;
use crate::{Built, Scene};

/// Blocks of pairs behind pointers, each pair active by itself.
type Pointer = layout!(pointer(ij).bitmasked(ij, 8).soa);

/// Whether memory follows the springs that there are.
const fn is_sparse<C: Connectivity<Aos>>() -> bool {
    C::MOST_MASSES > MOST_DENSE
}

fn in_layouts<M: Layout<I> + 'static, C: Connectivity<M> + 'static>(scene: &Scene) -> Built {
    Ok(Box::new(Driver::<M, C>::new(scene)?))
}

layout_pairs! {
    in_layouts, is_sparse;
    "aos+list": Aos, List<Aos>, "masses interleaved; one list of springs, each of which adds to both its masses";
    #[cfg(feature = "all-layouts")]
    "soa+list": Soa, List<Soa>, "an array for each member of masses and springs; one list of springs";
    "aos+rows": Aos, Rows, "masses interleaved, each with a list of its springs";
    #[cfg(feature = "all-layouts")]
    "soa+rows": Soa, Rows, "an array for each member of masses, each with a list of its springs";
    "aos+pointer": Aos, Matrix<Pointer>, "masses interleaved; a table of all pairs in blocks of 8 x 8 where there are springs";
    "aos+dense": Aos, Matrix<Soa>, "masses interleaved; a table of all pairs, for at most 2048 masses";
    #[cfg(feature = "all-layouts")]
    "split+list": Split, List<Split>, "an array for each component of masses and springs; one list of springs";
    #[cfg(feature = "all-layouts")]
    "aosoa8+list": AoSoA<8>, List<AoSoA<8>>, "masses and springs in groups of 8; one list of springs";
    #[cfg(feature = "all-layouts")]
    "split+rows": Split, Rows, "an array for each component of masses, each with a list of its springs";
    #[cfg(feature = "all-layouts")]
    "aos+sparse4": Aos, Matrix<Sparse<4>>, "masses interleaved; a table of all pairs in whole blocks of 4 x 4";
}

/// Why a scene makes no sense in a layout, if it does not.
pub(super) fn unfit(scene: &Scene, layout: &str) -> Option<&'static str> {
    let Ok(SpringsSetup { masses, .. }) = scene.setup() else {
        return Some("it is a scene of another solver");
    };
    let dense = LAYOUTS.iter().any(|pair| pair.name == layout && !pair.sparse);
    (dense && masses.len() > MOST_DENSE)
        .then_some("too large: a dense table of all pairs is for at most 2048 masses; take `aos+list`")
}
