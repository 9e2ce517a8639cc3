//! Views: what a parallel loop may do to a member of a field. A file an access mode.

mod accumulate;
mod base;
mod beside;
mod free;
mod lane;
mod probed;
mod read;
mod readable;
mod row;
mod together;
mod topology;

use core::fmt;

pub use accumulate::Accumulate;
pub use accumulate::negative;
pub(crate) use base::Around;
pub use base::{Based, Corners, EightCorners};
pub use beside::Beside;
pub(crate) use free::Places;
pub use free::{Boxed, Free, Linear, Var};
pub use read::Read;
pub use readable::Readable;
pub(crate) use row::HELD;
pub use row::{Buffer, Held, OfLoop, Other, Own, Row, Whose, buffer};
pub use together::Together;

pub use free::OwnFree;

use crate::axes::{Axes, MAX_AXES, padded};
use crate::element::{Element, Packed};
use crate::field::{Handle, Source, SourceMut, Spans};
use crate::launch::{Border, Run, Space, Still, Task, TwoColours};
use crate::layout::{Geometry, Layout, Map};
use crate::record::{ElementList, Path, Record};
use crate::scatter::{Coordinates, Window};
use crate::store::paths::Paths;

/// What a panic in a kernel names.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Site {
    /// The kernel.
    pub kernel: &'static str,
    /// The field's parameter.
    pub field: &'static str,
}

impl Site {
    /// Tells of logical coordinates that lie outside of a field of this geometry.
    #[inline(always)]
    #[track_caller]
    pub(crate) fn out_of_range<X: Axes>(&self, at: [i64; MAX_AXES], geometry: &Geometry) -> ! {
        // One by one: an array would be put into memory in every iteration, lest it be needed here.
        self.out_of_range_at::<X>(at[0], at[1], at[2], at[3], *geometry)
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn out_of_range_at<X: Axes>(&self, i: i64, j: i64, k: i64, l: i64, geometry: Geometry) -> ! {
        self.missed(&[i, j, k, l][..X::RANK], &geometry.shape[..X::RANK], &geometry.origin[..X::RANK])
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn missed(&self, index: &[i64], shape: &[u32], origin: &[i32]) -> ! {
        let Self { kernel, field } = self;
        let spans = Spans(origin.iter().copied().zip(shape.iter().map(|&extent| i64::from(extent))));
        let indices = match origin.iter().all(|&first| first == 0) {
            true => String::new(),
            false => format!(" and whose indices are {spans}"),
        };
        panic!(
            "kernel `{kernel}`: index {index:?} is out of range of field `{field}`, whose shape is {shape:?}{indices}"
        )
    }
}

/// A field within a launch. With `WRITE` the launch holds the field's `&mut`.
///
/// It is `Copy`, so that every job has its own in its frame: the geometry is then known to be one and the same for all
/// members. Which members are read, owned or accumulated is what the kernel macro found; each view allows no more.
#[doc(hidden)]
pub struct View<'a, R, L, X, const WRITE: bool> {
    pub(crate) handle: Handle<'a, R, L, X>,
    pub(crate) site: &'static Site,
}

impl<R, L, X, const WRITE: bool> Clone for View<'_, R, L, X, WRITE> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, const WRITE: bool> Copy for View<'_, R, L, X, WRITE> {}
impl<R, L, X, const WRITE: bool> fmt::Debug for View<'_, R, L, X, WRITE> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "View of `{}`", self.site.field)
    }
}

/// A field that a loop only reads.
#[doc(hidden)]
#[inline(always)]
pub fn shared<'a, S: Source + ?Sized>(
    field: &'a S,
    site: &'static Site,
) -> View<'a, S::Record, S::Layout, S::Axes, false> {
    View { handle: field.handle(), site }
}

/// A field that a loop changes.
#[doc(hidden)]
#[inline(always)]
pub fn exclusive<'a, S: SourceMut + ?Sized>(
    field: &'a mut S,
    site: &'static Site,
) -> View<'a, S::Record, S::Layout, S::Axes, true> {
    View { handle: field.handle_mut(), site }
}

/// Refuses a slice that is no field, at its type.
#[doc(hidden)]
pub fn assert_packed<T: Packed>() {}

impl<'a, R: Record, L: Layout<X>, X: Axes, const WRITE: bool> View<'a, R, L, X, WRITE> {
    /// A job's memory of the field's blocks.
    #[inline(always)]
    pub fn paths(&self) -> Paths {
        self.handle.paths()
    }

    /// The same view for one job, with its memory of the field's blocks.
    ///
    /// The memory is read and written by views that are neither `Send` nor `Sync`, all made from this one.
    #[inline(always)]
    pub fn of_job<'b>(self, paths: &'b Paths) -> View<'b, R, L, X, WRITE>
    where
        'a: 'b,
    {
        if const { Map::<R, L, X>::any_sparse() } {
            // SAFETY: views made from this one live no longer than the memory, and those that use it stay on this thread.
            return View { handle: unsafe { self.handle.with_paths(paths) }, site: self.site };
        }
        self
    }

    /// As [`of_job`](Self::of_job) of the field whose memory the launch has at a place.
    #[inline(always)]
    pub fn of_task<'b, S: Space, T>(
        self,
        paths: &'b Paths,
        task: &Task<'b, S>,
        place: usize,
        _: &Still<'a, T>,
    ) -> View<'b, R, L, X, WRITE>
    where
        'a: 'b,
        T: Source<Record = R, Layout = L, Axes = X> + ?Sized,
    {
        if const { !WRITE && Still::<T>::KNOWN } {
            return View { handle: self.handle.at(task.still(place)), site: self.site };
        }
        self.of_job(paths)
    }

    /// The names of its members.
    #[inline(always)]
    pub fn tags(&self) -> R::Tags {
        R::TAGS
    }

    /// Which element a path names.
    #[inline(always)]
    pub fn member<P: Path<R>>(&self, _: P) -> usize {
        P::MEMBER.expect("an element is one member")
    }

    /// Elements in all.
    #[inline(always)]
    #[allow(clippy::len_without_is_empty, reason = "as the field's own")]
    pub fn len(&self) -> usize {
        self.handle.geometry.len()
    }

    /// Elements along each axis.
    #[inline(always)]
    pub fn shape(&self) -> X::Extents {
        self.handle.geometry.extents::<X>()
    }

    /// The first index along each axis.
    #[inline(always)]
    pub fn origin(&self) -> X::Index {
        X::index(self.handle.geometry.origin)
    }

    /// The border of the field.
    pub fn border(&self, width: u32) -> Border {
        Border::new::<X>(&self.handle.geometry, width)
    }

    /// A view that reads a path at any index.
    #[inline(always)]
    pub fn read<P: Path<R>>(self, _: P) -> Read<'a, R, L, X, P> {
        Read::new(self.handle, self.site)
    }

    /// A view that reads a path at the run's elements, moved by constant offsets.
    #[inline(always)]
    pub fn row<'b, const N: usize, S: Space, P: Path<R>, H: Whose>(
        self,
        run: &Run<'_, S>,
        _: P,
        offset: [i64; N],
        _: H,
        copy: &'b Buffer<<P::Value as Record>::Elements>,
    ) -> Row<'a, 'b, R, L, X, P, S, H> {
        Row::new(self.handle, self.site, run, padded(offset), copy)
    }

    /// The field as one that a job may reach all of.
    #[inline(always)]
    pub fn all(self) -> Reached<'a, R, L, X> {
        Reached { window: Window::whole(&self.handle.geometry), handle: self.handle }
    }

    /// Reads a path at an index, whatever else the loop does there.
    ///
    /// # Safety
    /// The index lies within the shape, and no other iteration writes the element meanwhile.
    #[inline(always)]
    pub unsafe fn get_unchecked<P: Path<R>>(self, _: P, index: impl crate::index::IntoIndex<X>) -> P::Value {
        let at = self.promised(index);
        // SAFETY: as the caller promises. The block is looked up anew, since the caller may be on any thread.
        unsafe { self.handle.without_paths().read::<P>(at) }
    }

    /// The place of an index that a caller has promised to lie within the shape; checked with debug assertions.
    #[inline(always)]
    fn promised(&self, index: impl crate::index::IntoIndex<X>) -> [u32; MAX_AXES] {
        let (at, geometry) = (index.coordinates(), &self.handle.geometry);
        if cfg!(debug_assertions) && crate::index::within::<X>(at, geometry).is_none() {
            self.site.out_of_range::<X>(at, geometry);
        }
        geometry.place(at)
    }

    /// Where a loop accumulates.
    #[inline(always)]
    pub fn key(&self, index: impl crate::index::IntoIndex<X>) -> Coordinates<X> {
        Coordinates(index.coordinates(), core::marker::PhantomData)
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes> View<'a, R, L, X, true> {
    /// A view that reads and writes a path at the run's own elements, at once.
    #[inline(always)]
    pub fn own<S: Space, P: Path<R>, H: Whose>(self, run: &Run<'_, S>, _: P, _: H) -> Own<'a, R, L, X, P, S, H> {
        Own::new(self.handle, self.site, run)
    }

    /// As [`own`](Self::own); what is written to short runs waits in registers for [`flush`](Held::flush).
    #[inline(always)]
    pub fn held<'b, S: Space, P: Path<R>, H: Whose>(
        self,
        run: &Run<'_, S>,
        _: P,
        buffer: &'b Buffer<<P::Value as Record>::Elements>,
        _: H,
    ) -> Held<'a, 'b, R, L, X, P, S, H> {
        Held::new(self.handle, self.site, run, buffer)
    }

    /// Writes a path at an index, whatever else the loop does there.
    ///
    /// # Safety
    /// The index lies within the shape, and no other iteration reads or writes the element meanwhile.
    #[inline(always)]
    pub unsafe fn set_unchecked<P: Path<R>>(self, _: P, index: impl crate::index::IntoIndex<X>, value: P::Value) {
        let at = self.promised(index);
        // SAFETY: as the caller promises. The block is looked up anew, since the caller may be on any thread.
        unsafe { self.handle.without_paths().write::<P>(at, value) }
    }

    /// A view that reads and writes a path where an index contains the loop's variables.
    #[inline(always)]
    pub fn own_free<S: Space, P: Path<R>>(self, _: &Task<'_, S>, _: P) -> OwnFree<'a, R, L, X, P> {
        OwnFree::new(self.handle, self.site)
    }

    /// A view that reads a path at the other colour than that of a loop which writes it.
    #[inline(always)]
    #[track_caller]
    pub fn beside<const N: usize, S: TwoColours, P: Path<R>>(
        self,
        _: &Task<'_, S>,
        _: P,
        offset: [i64; N],
    ) -> Beside<'a, R, L, X, P, S> {
        Beside::new(self.handle, self.site, offset)
    }

    /// Checks, before a launch, that indices which are moved and taken modulo the extents change their colour.
    ///
    /// # Panics
    /// Where an extent along which the offset moves is odd.
    #[track_caller]
    pub fn wraps_evenly<const N: usize>(self, offset: [i64; N]) {
        beside::assert_even(&self.handle.geometry.shape, &offset, self.site);
    }

    /// The field as this job accumulates into it.
    #[inline(always)]
    pub fn of_target<'b, S: Space>(self, task: &Task<'b, S>, slot: usize) -> Reached<'b, R, L, X>
    where
        'a: 'b,
    {
        let share = task.share(slot);
        Reached { handle: self.handle.at(share.root), window: share.window }
    }

    /// A view that accumulates into a path at any index, as the launch's schedule says.
    #[inline(always)]
    pub fn accumulate<'b, S: Space, P: Path<R>>(
        self,
        task: &Task<'b, S>,
        slot: usize,
        _: P,
    ) -> Accumulate<'b, R, L, X, P>
    where
        'a: 'b,
        P::Value: Element,
    {
        Accumulate::new(self.handle, self.site, task.atomic(), task.share(slot), slot)
    }

    /// A view that reads and changes a path at any index where iterations may meet, component by component atomically.
    #[inline(always)]
    pub fn together<S: Space, P: Path<R>>(self, task: &Task<'_, S>, _: P) -> Together<'a, R, L, X, P> {
        Together::new(self.handle, self.site, task.alone())
    }

    /// A view that accumulates into a path where iterations may also read and write it.
    #[inline(always)]
    pub fn accumulate_together<S: Space, P: Path<R>>(self, task: &Task<'_, S>, _: P) -> Accumulate<'a, R, L, X, P>
    where
        P::Value: Element,
    {
        Accumulate::whole(self.handle, self.site, !task.alone())
    }

    /// Whether every component that a path names lies at a multiple of its size, where it can be reached atomically.
    pub fn is_aligned<P: Path<R>>(&self, _: P) -> bool {
        let mut members = 0..R::Elements::MEMBERS.len();
        P::MEMBER.map_or_else(|| members.all(Map::<R, L, X>::aligned), Map::<R, L, X>::aligned)
    }
}

/// A field, and which of its elements a job may reach.
#[doc(hidden)]
pub struct Reached<'a, R, L, X> {
    handle: Handle<'a, R, L, X>,
    window: Window,
}

impl<R, L, X> Clone for Reached<'_, R, L, X> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X> Copy for Reached<'_, R, L, X> {}
impl<R, L, X> fmt::Debug for Reached<'_, R, L, X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Reached({:?})", self.window)
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Reached<'_, R, L, X> {
    /// Where the blocks around bases are kept.
    #[inline(always)]
    pub fn corners(&self) -> L::Corners {
        L::Corners::default()
    }

    /// The field around `base`, if the job may reach all of `base + low` to `base + high`, and with `FILLED` will write there.
    #[inline(always)]
    pub fn based<'b, const FILLED: bool, const N: usize>(
        self,
        corners: &'b L::Corners,
        base: impl crate::index::IntoIndex<X>,
        low: [i64; N],
        high: [i64; N],
    ) -> Option<Based<'b, L, X, FILLED>> {
        Based::new(&self.handle.geometry, &self.window, corners, base.coordinates(), low, high).map(
            #[inline(always)]
            |based| based.cornered(&self.handle),
        )
    }

    /// The same with the same offsets along all axes.
    #[inline(always)]
    pub fn based_all<'b, const FILLED: bool>(
        self,
        corners: &'b L::Corners,
        base: impl crate::index::IntoIndex<X>,
        low: i64,
        high: i64,
    ) -> Option<Based<'b, L, X, FILLED>> {
        let (low, high) = ([low; MAX_AXES], [high; MAX_AXES]);
        Based::around(&self.handle.geometry, &self.window, corners, base.coordinates(), low, high).map(
            #[inline(always)]
            |based| based.cornered(&self.handle),
        )
    }
}
