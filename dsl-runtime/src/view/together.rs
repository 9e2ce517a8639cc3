//! `Together`: a path that iterations meet in, component by component atomically.

use core::cell::Cell;
use core::marker::PhantomData;
use core::mem::size_of;
use core::sync::atomic::{AtomicU8, AtomicU16, AtomicU32, AtomicU64, Ordering::Relaxed};

use super::Site;
use super::lane::Lane;
use super::probed::note;
use crate::axes::{Axes, MAX_AXES};
use crate::exchange::{Count, Exchange};
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::probe::{Access, Index};
use crate::record::{ElementList, Path, Record};

/// Reads and changes a path of a field at any index, whatever other iterations do there: each component by one relaxed atomic
/// operation, in no order. Records and vectors may tear between their components.
#[doc(hidden)]
#[derive(Debug)]
pub struct Together<'a, R, L, X, P> {
    lane: Lane<'a, R, L, X, P>,
    /// Whether one thread runs the whole loop, so that plain operations will do.
    alone: bool,
    /// Neither `Send` nor `Sync`: one thread's plain operations are its alone.
    owner: PhantomData<*mut ()>,
}

macro_rules! operations {
    ($($name:ident: $bound:ident, $doc:literal;)*) => {$(
        #[doc = $doc]
        ///
        /// # Panics
        /// Where the index lies outside of the shape.
        #[inline(always)]
        #[track_caller]
        pub fn $name(&self, index: impl IntoIndex<X>, by: P::Value) -> P::Value
        where
            P::Value: $bound,
        {
            let at = self.lane.locate(index);
            self.note(at, Access::Accumulate);
            if self.alone {
                // SAFETY: `at` lies within the shape, and this thread alone touches the field.
                return unsafe { self.change(at, |value| crate::exchange::$name(value, by)) };
            }
            // SAFETY: as `scalar` says.
            unsafe { P::Value::$name(self.scalar(at), by) }
        }
    )*};
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> Together<'a, R, L, X, P> {
    #[inline(always)]
    pub(crate) fn new(handle: Handle<'a, R, L, X>, site: &'static Site, alone: bool) -> Self {
        Self { lane: Lane::new(handle, site), alone, owner: PhantomData }
    }

    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, index: impl IntoIndex<X>) -> P::Value {
        self.read(self.lane.locate(index))
    }

    /// The value of the element nearest to an index.
    ///
    /// # Panics
    /// Where the field has no element.
    #[inline(always)]
    #[track_caller]
    pub fn clamped(&self, index: impl IntoIndex<X>) -> P::Value {
        self.read(self.lane.locate_by(index, crate::index::clamped::<X>))
    }

    /// The value at an index modulo the extents.
    ///
    /// # Panics
    /// Where the field has no element, or the index is larger than an `i64`.
    #[inline(always)]
    #[track_caller]
    pub fn wrapped(&self, index: impl IntoIndex<X>) -> P::Value {
        self.read(self.lane.locate_by(index, crate::index::wrapped::<X>))
    }

    /// The value at an index, or `value` where it lies outside of the shape.
    #[inline(always)]
    pub fn or(&self, index: impl IntoIndex<X>, value: P::Value) -> P::Value {
        self.lane.inside(index).map_or(value, |at| self.read(at))
    }

    /// Puts a value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn set(&self, index: impl IntoIndex<X>, value: P::Value) {
        self.write(self.lane.locate(index), None, value);
    }

    /// Puts those components of a value at an index which differ from what was read there.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn set_changes(&self, index: impl IntoIndex<X>, read: P::Value, value: P::Value) {
        self.write(self.lane.locate(index), Some(read), value);
    }

    operations! {
        swap: Exchange, "Puts a value, and returns the old one.";
        fetch_or: Exchange, "`|=`, and the old value.";
        fetch_and: Exchange, "`&=`, and the old value.";
        fetch_xor: Exchange, "`^=`, and the old value.";
        fetch_add: Count, "`+=`, and the old value.";
        fetch_sub: Count, "`-=`, and the old value.";
        fetch_min: Count, "The smaller of both, and the old value.";
        fetch_max: Count, "The larger of both, and the old value.";
    }

    /// Puts `new` where `current` is; returns what was there, as an error where it was something else.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn compare_exchange(
        &self,
        index: impl IntoIndex<X>,
        current: P::Value,
        new: P::Value,
    ) -> Result<P::Value, P::Value>
    where
        P::Value: Exchange,
    {
        let at = self.lane.locate(index);
        self.note(at, Access::Accumulate);
        if self.alone {
            // SAFETY: `at` lies within the shape, and this thread alone touches the field.
            return unsafe { self.change(at, |value| crate::exchange::compare_exchange(value, current, new)) };
        }
        // SAFETY: as `scalar` says.
        unsafe { P::Value::compare_exchange(self.scalar(at), current, new) }
    }

    /// Changes the value at an element by plain operations.
    ///
    /// # Safety
    /// The element lies within the shape, and this thread alone touches the field.
    #[inline(always)]
    unsafe fn change<T>(&self, at: [u32; MAX_AXES], change: impl FnOnce(&mut P::Value) -> T) -> T {
        // SAFETY: as the caller promises.
        let mut value = unsafe { self.lane.handle().read::<P>(at) };
        let result = change(&mut value);
        // SAFETY: as above.
        unsafe { self.lane.handle().write::<P>(at, value) };
        result
    }

    /// The address of an element that is one scalar: aligned, and during the launch touched by atomic operations alone.
    #[inline(always)]
    fn scalar(&self, at: [u32; MAX_AXES]) -> *mut P::Value
    where
        P::Value: Exchange,
    {
        let (start, _) = self.lane.address_mut(at);
        assert!(P::MEMBER.is_some() && start.addr().is_multiple_of(size_of::<P::Value>()));
        start.cast()
    }

    /// Tells a recording of an access.
    #[inline(always)]
    fn note(&self, at: [u32; MAX_AXES], access: Access) {
        note::<R, L, X, P>(self.lane.handle(), self.lane.site(), || at, access, Index::Computed);
    }

    #[inline(always)]
    fn read(&self, at: [u32; MAX_AXES]) -> P::Value {
        self.note(at, Access::Read);
        let handle = self.lane.handle();
        if self.alone {
            // SAFETY: `at` lies within the shape, and this thread alone touches the field.
            return unsafe { handle.read::<P>(at) };
        }
        with_scratch::<R, _>(|scratch| {
            // SAFETY: the scratch has room for every member at its own offset, and components come from values.
            unsafe {
                P::gather(|member| {
                    let copy = scratch.add(offset::<R>(member));
                    let spec = R::Elements::MEMBERS[member];
                    let (from, step) = handle.component(member, at);
                    for c in 0..spec.components {
                        load(from.wrapping_add(c * step), copy.add(c * spec.scalar), spec.scalar);
                    }
                    (copy, spec.scalar)
                })
            }
        })
    }

    /// Puts a value; with `read`, those components that differ from it.
    #[inline(always)]
    fn write(&self, at: [u32; MAX_AXES], read: Option<P::Value>, value: P::Value) {
        self.note(at, Access::Write);
        let handle = self.lane.handle();
        if self.alone {
            // SAFETY: `at` lies within the shape, and this thread alone touches the field.
            return unsafe { handle.write::<P>(at, value) };
        }
        with_scratch::<R, _>(|old| {
            with_scratch::<R, _>(|new| {
                // SAFETY: the scratch has room for every member at its own offset.
                let scatter = |value: P::Value, scratch: *mut u8| unsafe {
                    let written = Cell::new(0u32);
                    P::scatter(value, |member| {
                        written.set(written.get() | 1 << member);
                        (scratch.add(offset::<R>(member)), R::Elements::MEMBERS[member].scalar)
                    });
                    written.get()
                };
                if let Some(read) = read {
                    scatter(read, old);
                }
                let written = scatter(value, new);
                for member in (0..R::Elements::MEMBERS.len()).filter(|member| written & 1 << member != 0) {
                    let spec = R::Elements::MEMBERS[member];
                    let (to, step) = handle.component_mut(member, at);
                    for c in 0..spec.components {
                        let place = offset::<R>(member) + c * spec.scalar;
                        // SAFETY: within the scratch, which was written there; the component lies within the field, and is
                        // touched by atomic operations alone.
                        unsafe {
                            if read.is_none() || differ(old.add(place), new.add(place), spec.scalar) {
                                store(new.add(place), to.wrapping_add(c * step), spec.scalar);
                            }
                        }
                    }
                }
            });
        });
    }
}

/// Where a member's components lie in a scratch, one after another.
const fn offset<R: Record>(member: usize) -> usize {
    let (mut words, mut m) = (0, 0);
    while m < member {
        words += (R::Elements::MEMBERS[m].components * R::Elements::MEMBERS[m].scalar).div_ceil(8);
        m += 1;
    }
    8 * words
}

/// Works with memory for one record, zeroed and aligned to 8 bytes.
#[inline(always)]
fn with_scratch<R: Record, T>(work: impl FnOnce(*mut u8) -> T) -> T {
    const FEW: usize = 32;
    let words = const { offset::<R>(R::Elements::MEMBERS.len()) / 8 };
    if words <= FEW { work([0u64; FEW].as_mut_ptr().cast()) } else { work(vec![0u64; words].as_mut_ptr().cast()) }
}

macro_rules! by_size {
    ($size:expr, |$atomic:ident, $bits:ident| $work:expr) => {
        match $size {
            1 => {
                type $atomic = AtomicU8;
                type $bits = u8;
                $work
            }
            2 => {
                type $atomic = AtomicU16;
                type $bits = u16;
                $work
            }
            4 => {
                type $atomic = AtomicU32;
                type $bits = u32;
                $work
            }
            8 => {
                type $atomic = AtomicU64;
                type $bits = u64;
                $work
            }
            _ => unreachable!("scalars have 1, 2, 4 or 8 bytes"),
        }
    };
}

/// Copies a component by one atomic read.
///
/// # Safety
/// `from` is a component that is touched by atomic operations alone, aligned to its size; `to` is the caller's own, aligned too.
#[inline(always)]
unsafe fn load(from: *mut u8, to: *mut u8, size: usize) {
    assert!(from.addr().is_multiple_of(size));
    // SAFETY: as the caller promises.
    by_size!(size, |Atomic, Bits| unsafe { to.cast::<Bits>().write(Atomic::from_ptr(from.cast()).load(Relaxed)) });
}

/// Copies a component by one atomic write.
///
/// # Safety
/// As for [`load`], with the roles changed.
#[inline(always)]
unsafe fn store(from: *const u8, to: *mut u8, size: usize) {
    assert!(to.addr().is_multiple_of(size));
    // SAFETY: as the caller promises.
    by_size!(size, |Atomic, Bits| unsafe { Atomic::from_ptr(to.cast()).store(from.cast::<Bits>().read(), Relaxed) });
}

/// Whether the bytes of two components differ.
///
/// # Safety
/// Both are the caller's own, and aligned to their size.
#[inline(always)]
unsafe fn differ(a: *const u8, b: *const u8, size: usize) -> bool {
    // SAFETY: as the caller promises.
    by_size!(size, |Atomic, Bits| unsafe {
        const { assert!(size_of::<Atomic>() == size_of::<Bits>()) }
        a.cast::<Bits>().read() != b.cast::<Bits>().read()
    })
}
