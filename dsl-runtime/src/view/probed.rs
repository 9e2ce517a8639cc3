//! Accesses as recordings see them.

use super::Site;
use crate::axes::{Axes, MAX_AXES};
use crate::field::Handle;
use crate::layout::Layout;
use crate::probe::{self, Access, Index, Touch};
use crate::record::{ElementList, Names, Path, Record};

/// Tells of an access to a path at a place, if there is a recording. Where none can be, nothing of this is compiled.
#[inline(always)]
pub(super) fn note<R: Record, L: Layout<X>, X: Axes, P: Path<R>>(
    handle: &Handle<'_, R, L, X>,
    site: &'static Site,
    place: impl FnOnce() -> [u32; MAX_AXES],
    access: Access,
    index: Index,
) {
    // What `cargo bench --bench probe` compares with: a library in which nothing stands here at all.
    #[cfg(not(allotrope_unprobed))]
    if const { probe::AVAILABLE } && probe::is_recording() {
        touch::<R, L, X, P>(handle, site, place(), access, index);
    }
    #[cfg(allotrope_unprobed)]
    let _ = (handle, site, place, access, index);
}

/// The same, where there is one.
#[cfg_attr(allotrope_unprobed, expect(dead_code, reason = "nothing asks"))]
#[cold]
#[inline(never)]
fn touch<R: Record, L: Layout<X>, X: Axes, P: Path<R>>(
    handle: &Handle<'_, R, L, X>,
    site: &'static Site,
    place: [u32; MAX_AXES],
    access: Access,
    index: Index,
) {
    for m in P::OFFSET..P::OFFSET + <P::Value as Record>::Elements::MEMBERS.len() {
        let spec = R::Elements::MEMBERS[m];
        let (address, step) = handle.component(m, place);
        probe::touch(&Touch {
            field: site.field,
            member: Names::<R>::ALL[m],
            access,
            index,
            region: handle.region(m, place),
            address: address.addr(),
            components: spec.components,
            scalar: spec.scalar,
            step,
        });
    }
}
