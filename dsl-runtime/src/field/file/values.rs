//! The values of a member at one element, as bytes: its components in order.

use crate::axes::{Axes, MAX_AXES};
use crate::field::Field;
use crate::layout::Layout;
use crate::record::{ElementList, MemberSpec, Record};

/// The bytes of a member's values at one element.
pub(super) fn size(spec: &MemberSpec) -> usize {
    spec.components * spec.scalar
}

/// Appends the bytes of member `m` at a place.
pub(super) fn append<R: Record, L: Layout<X>, X: Axes>(
    field: &Field<R, L, X>,
    m: usize,
    at: [u32; MAX_AXES],
    to: &mut Vec<u8>,
) {
    let (handle, spec) = (field.handle(), &R::Elements::MEMBERS[m]);
    assert_within(at, handle.geometry.shape);
    let (first, distance) = handle.component(m, at);
    for component in 0..spec.components {
        let from = first.wrapping_add(component * distance);
        // SAFETY: a component of an element within the shape has so many bytes, all initialised; `&Field` keeps writers
        // away.
        to.extend_from_slice(unsafe { core::slice::from_raw_parts(from, spec.scalar) });
    }
}

/// Puts bytes, in the order of this machine, as member `m` at a place. Where one of them is no value, nothing is put and
/// that one returned.
pub(super) fn put<R: Record, L: Layout<X>, X: Axes>(
    field: &mut Field<R, L, X>,
    m: usize,
    at: [u32; MAX_AXES],
    bytes: &[u8],
) -> Result<(), i64> {
    let (handle, spec) = (field.handle(), &R::Elements::MEMBERS[m]);
    assert_within(at, handle.geometry.shape);
    assert_eq!(bytes.len(), size(spec), "the bytes of one element");
    if let Some(wrong) = R::Elements::wrong(m, bytes) {
        return Err(wrong);
    }
    // It becomes active, where it was not.
    let (first, distance) = handle.component_mut(m, at);
    for (component, from) in bytes.chunks_exact(spec.scalar).enumerate() {
        let to = first.wrapping_add(component * distance);
        // SAFETY: a component of an element within the shape has so many bytes, and these are of a value of its type;
        // `&mut Field` keeps others away, and `from` lies elsewhere.
        unsafe { core::ptr::copy_nonoverlapping(from.as_ptr(), to, spec.scalar) };
    }
    Ok(())
}

fn assert_within(at: [u32; MAX_AXES], shape: [u32; MAX_AXES]) {
    assert!(at.iter().zip(shape).all(|(&place, extent)| place < extent), "a place within the shape");
}
