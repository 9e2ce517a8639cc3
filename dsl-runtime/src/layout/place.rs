//! Places: how the cells of the innermost node hold the members of a record.

use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;
use crate::layout::{Inner, node::Digit};
use crate::record::{MAX_MEMBERS, MemberSpec};

/// What a place does, as data.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub enum Spec {
    /// Record after record.
    Aos,
    /// For each member, all its values.
    Soa,
    /// For each scalar component, all its values.
    Split,
    /// Groups of members, each interleaved, one group after another.
    Groups(&'static [&'static [GroupEntry]]),
    /// The same of some members: the others stand in other branches.
    Some(&'static [&'static [GroupEntry]]),
}

/// A member in a group of `.place(..)`.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct GroupEntry {
    /// Its name's bytes, big-endian, zero-padded on the right.
    pub name: (u128, u128),
    /// Whether its components stand apart: `split(c)`.
    pub split: bool,
}

/// How the innermost node's cells hold a record: the end of a layout's chain.
#[doc(hidden)]
pub trait Place: Copy + Send + Sync + Sealed + 'static {
    /// What it does.
    const SPEC: Spec;
    /// The bytes that each cell (of interleaved records) or run begins at a multiple of.
    const PAD: usize = 1;
}

macro_rules! places {
    ($($name:ident $spec:expr, $doc:literal;)*) => {$(
        #[doc = $doc]
        #[derive(Clone, Copy, Debug)]
        pub struct $name;
        impl Sealed for $name {}
        impl Place for $name {
            const SPEC: Spec = $spec;
        }
    )*};
}
places! {
    PlaceAos Spec::Aos, "`.aos`: record after record, components in declared order, rounded up to the widest scalar.";
    PlaceSoa Spec::Soa, "`.soa`: for each member, all its values.";
    PlaceSplit Spec::Split, "`.split`: for each scalar component of each member, all its values.";
}

/// Stands for a record where the cells of a node are pointers or lists.
#[derive(Clone, Copy, Debug)]
pub struct Entry;
impl Sealed for Entry {}
impl Place for Entry {
    const SPEC: Spec = Spec::Aos;
}

/// `.pad(64)`: each cell of interleaved records, or each run of what stands apart, begins at a multiple of so many bytes.
#[derive(Clone, Copy, Debug)]
pub struct Padded<const BYTES: usize, P>(core::marker::PhantomData<fn() -> P>);
impl<const BYTES: usize, P> Sealed for Padded<BYTES, P> {}
impl<const BYTES: usize, P: Place> Place for Padded<BYTES, P> {
    const SPEC: Spec = P::SPEC;
    const PAD: usize = {
        assert!(BYTES.is_power_of_two() && BYTES <= 4096, "`pad` takes a power of two up to 4096");
        BYTES
    };
}

/// `.place([v, m], [flags])`: groups of the members of `R`, each interleaved, one group after another.
///
/// A record with parameters is written with them:
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope::spatial::*;
///
/// #[derive(Record, Clone, Copy, Default)]
/// struct Node<X: Spatial> { v: X::Vec<f32>, m: f32 }
///
/// type Apart<X> = layout!(Node<X>: dense(ij).place([m], [v]));
///
/// let mut grid = Field::<Node<Ij>, Apart<Ij>>::new([4, 4]);
/// grid.set([1, 2], Node { v: Vec2::ONE, m: 2.0 });
/// assert_eq!(grid.get([1, 2]).v, Vec2::ONE);
/// ```
///
/// Then a member that is unknown, or left out, is an error where a field is made:
///
/// ```compile_fail,E0080
/// # use allotrope::prelude::*;
/// # use allotrope::spatial::*;
/// # #[derive(Record, Clone, Copy, Default)]
/// # struct Node<X: Spatial> { v: X::Vec<f32>, m: f32 }
/// type Apart<X> = layout!(Node<X>: dense(ij).place([m]));
/// let grid = Field::<Node<Ij>, Apart<Ij>>::new([4, 4]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PlaceGroups<R, G>(core::marker::PhantomData<fn() -> (R, G)>);
impl<R, G> Sealed for PlaceGroups<R, G> {}
impl<R: Copy + 'static, G: Groups> Place for PlaceGroups<R, G> {
    const SPEC: Spec = Spec::Groups(G::GROUPS);
}

/// `.place([v, m])` in a branch: groups of some members of `R`; the others stand in other branches.
#[derive(Clone, Copy, Debug)]
pub struct PlaceSome<R, G>(core::marker::PhantomData<fn() -> (R, G)>);
impl<R, G> Sealed for PlaceSome<R, G> {}
impl<R: Copy + 'static, G: Groups> Place for PlaceSome<R, G> {
    const SPEC: Spec = Spec::Some(G::GROUPS);
}

/// A member's name in a group.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Named<const HIGH: u128, const LOW: u128>;
/// A member's name in a group, its components taken apart.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Taken<const HIGH: u128, const LOW: u128>;

/// A name in a group.
#[doc(hidden)]
pub trait Name: Copy + 'static {
    /// The name and whether it is split.
    const ENTRY: GroupEntry;
}
impl<const HIGH: u128, const LOW: u128> Name for Named<HIGH, LOW> {
    const ENTRY: GroupEntry = GroupEntry { name: (HIGH, LOW), split: false };
}
impl<const HIGH: u128, const LOW: u128> Name for Taken<HIGH, LOW> {
    const ENTRY: GroupEntry = GroupEntry { name: (HIGH, LOW), split: true };
}

/// A group: a tuple of names.
#[doc(hidden)]
pub trait Group: Copy + 'static {
    /// Its names.
    const ENTRIES: &'static [GroupEntry];
}
/// All groups: a tuple of groups.
#[doc(hidden)]
pub trait Groups: Copy + 'static {
    /// The groups.
    const GROUPS: &'static [&'static [GroupEntry]];
}
macro_rules! groups {
    ($($($name:ident)+;)*) => {$(
        impl<$($name: Name),+> Group for ($($name,)+) {
            const ENTRIES: &'static [GroupEntry] = &[$($name::ENTRY),+];
        }
        impl<$($name: Group),+> Groups for ($($name,)+) {
            const GROUPS: &'static [&'static [GroupEntry]] = &[$($name::ENTRIES),+];
        }
    )*};
}
groups! {
    A; A B; A B C; A B C D; A B C D E; A B C D E F; A B C D E F G; A B C D E F G H; A B C D E F G H J; A B C D E F G H J K;
    A B C D E F G H J K M; A B C D E F G H J K M N; A B C D E F G H J K M N O; A B C D E F G H J K M N O P;
    A B C D E F G H J K M N O P Q; A B C D E F G H J K M N O P Q R;
}

/// A place stands where a node could: nothing below it.
impl<P: Place, X: Axes> Inner<X> for P {
    type Place = P;
    const EXTENT: PerAxis = [1; MAX_AXES];
    const CELLS: usize = 1;
    const LEAF: usize = 0;
    const RUN: usize = 0;
    const RUN_AXIS: usize = 0;
    const ROWS: usize = 1;
    const DIGITS: &'static [Digit] = &[];
    const GRAIN: usize = 0;
    #[inline(always)]
    fn term(_: usize, _: usize, _: usize, _: usize) -> usize {
        0
    }
}

/// A run of values in the innermost node's memory: `repeats` times N items.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stream {
    /// Bytes of one cell.
    pub(crate) item: usize,
    /// How many runs stand one after another: the components of a split member.
    pub(crate) repeats: usize,
}

/// Where a member stands: its stream, and the offset in the stream's item.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seat {
    pub(crate) stream: usize,
    pub(crate) offset: usize,
    pub(crate) split: bool,
    pub(crate) scalar: usize,
}

/// All streams of a record under a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Streams {
    pub(crate) streams: [Stream; MAX_MEMBERS],
    pub(crate) count: usize,
    pub(crate) seats: [Seat; MAX_MEMBERS],
    /// The widest scalar, or the padding where it is wider: every run begins at a multiple of it.
    pub(crate) align: usize,
}

/// `n` rounded up to a multiple of `to`.
#[inline(always)]
pub(crate) const fn round_up(n: usize, to: usize) -> usize {
    n.div_ceil(to) * to
}

/// Whether a name is what a group says, or that of a member of the record which the group says: `node.v` for `node`.
const fn named(name: &str, packed: (u128, u128)) -> bool {
    let name = name.as_bytes();
    let mut b = 0;
    while b < 32 {
        let (half, shift) = if b < 16 { (packed.0, 120 - 8 * b) } else { (packed.1, 120 - 8 * (b - 16)) };
        let byte = (half >> shift) as u8;
        if byte == 0 {
            break;
        }
        if b >= name.len() || name[b] != byte {
            return false;
        }
        b += 1;
    }
    b == name.len() || name[b] == b'.'
}

impl Streams {
    /// The seat of a member that stands elsewhere.
    pub(crate) const NOWHERE: Seat = Seat { stream: MAX_MEMBERS, offset: 0, split: false, scalar: 1 };
    const EMPTY: Self = Self {
        streams: [Stream { item: 0, repeats: 1 }; MAX_MEMBERS],
        count: 0,
        seats: [Self::NOWHERE; MAX_MEMBERS],
        align: 1,
    };

    /// Adds a member to the open stream, or as a stream of its own.
    const fn seat(mut self, m: usize, member: MemberSpec, split: bool) -> Self {
        let stream = &mut self.streams[self.count];
        if split {
            stream.item = member.scalar;
            stream.repeats = member.components;
            self.seats[m] = Seat { stream: self.count, offset: 0, split: true, scalar: member.scalar };
        } else {
            self.seats[m] = Seat { stream: self.count, offset: stream.item, split: false, scalar: member.scalar };
            stream.item += member.components * member.scalar;
        }
        self
    }

    /// Ends the open stream, its items rounded up to their widest scalar.
    const fn close(mut self, members: &[MemberSpec]) -> Self {
        let mut widest = 1;
        let mut m = 0;
        while m < members.len() {
            if self.seats[m].stream == self.count && members[m].scalar > widest {
                widest = members[m].scalar;
            }
            m += 1;
        }
        self.streams[self.count].item = round_up(self.streams[self.count].item, widest);
        self.count += 1;
        self
    }

    /// The streams of a record's members under a place, with cells or runs that begin at multiples of `pad`.
    pub(crate) const fn of(spec: Spec, pad: usize, members: &[MemberSpec], names: &[&str]) -> Self {
        let mut this = Self::EMPTY;
        let mut m = 0;
        while m < members.len() {
            if members[m].scalar > this.align {
                this.align = members[m].scalar;
            }
            m += 1;
        }
        let all = !matches!(spec, Spec::Some(_));
        if pad > this.align {
            this.align = pad;
        }
        m = 0;
        match spec {
            Spec::Aos => {
                while m < members.len() {
                    this = this.seat(m, members[m], false);
                    m += 1;
                }
                this = this.close(members);
                this.streams[0].item = round_up(this.streams[0].item, pad);
            }
            Spec::Soa | Spec::Split => {
                while m < members.len() {
                    this = this.seat(m, members[m], matches!(spec, Spec::Split)).close(members);
                    m += 1;
                }
            }
            Spec::Groups(groups) | Spec::Some(groups) => {
                let mut g = 0;
                while g < groups.len() {
                    let (group, mut open) = (groups[g], false);
                    // The interleaved members of the group first, then those taken apart.
                    let mut pass = 0;
                    while pass < 2 {
                        let mut e = 0;
                        while e < group.len() {
                            if group[e].split == (pass == 1) {
                                let (mut m, mut found) = (0, false);
                                while m < names.len() {
                                    if named(names[m], group[e].name) {
                                        assert!(
                                            this.seats[m].stream == MAX_MEMBERS,
                                            "`.place(..)` names a member twice"
                                        );
                                        this = this.seat(m, members[m], pass == 1);
                                        if pass == 1 {
                                            this = this.close(members);
                                        } else {
                                            open = true;
                                        }
                                        found = true;
                                    }
                                    m += 1;
                                }
                                assert!(found, "`.place(..)` names a member that the record does not have");
                            }
                            e += 1;
                        }
                        if pass == 0 && open {
                            this = this.close(members);
                        }
                        pass += 1;
                    }
                    g += 1;
                }
                while m < members.len() {
                    assert!(
                        !all || this.seats[m].stream < MAX_MEMBERS,
                        "`.place(..)` leaves a member of the record out"
                    );
                    m += 1;
                }
            }
        }
        this
    }

    /// Bytes of one run of `cells` cells; runs begin at multiples of `align`.
    #[inline(always)]
    const fn run(&self, s: usize, cells: usize, align: usize) -> usize {
        round_up(cells * self.streams[s].item, align)
    }

    /// Where stream `s` of a node of `cells` cells begins.
    #[inline(always)]
    pub(crate) const fn start(&self, s: usize, cells: usize, align: usize) -> usize {
        let (mut bytes, mut t) = (0, 0);
        while t < s {
            bytes += self.streams[t].repeats * self.run(t, cells, align);
            t += 1;
        }
        bytes
    }

    /// All bytes of a node of `cells` cells.
    pub(crate) const fn bytes(&self, cells: usize, align: usize) -> usize {
        self.start(self.count, cells, align)
    }

    /// Bytes between the components of member `m` in a node of `cells` cells.
    #[inline(always)]
    pub(crate) const fn component(&self, m: usize, cells: usize, align: usize) -> usize {
        let seat = self.seats[m];
        if seat.split { self.run(seat.stream, cells, align) } else { seat.scalar }
    }

    /// Whether member `m` stands here.
    pub(crate) const fn holds(&self, m: usize) -> bool {
        self.seats[m].stream < MAX_MEMBERS
    }

    /// Bytes between the values of member `m` of neighbouring cells.
    #[inline(always)]
    pub(crate) const fn stride(&self, m: usize) -> usize {
        self.streams[self.seats[m].stream].item
    }

    /// Whether every component of member `m` lies at a multiple of its size.
    pub(crate) const fn aligned(&self, m: usize) -> bool {
        let seat = self.seats[m];
        seat.offset.is_multiple_of(seat.scalar) && self.stride(m).is_multiple_of(seat.scalar)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEMBERS: [MemberSpec; 3] =
        [MemberSpec::of::<glam::Vec2>(), MemberSpec::of::<bool>(), MemberSpec::of::<f64>()];

    #[test]
    fn interleaved_records_round_up_to_the_widest_scalar() {
        let streams = Streams::of(Spec::Aos, 1, &MEMBERS, &["x", "flag", "mass"]);
        assert_eq!((streams.count, streams.stride(0)), (1, 24));
        assert_eq!(streams.seats.map(|s| s.offset)[..3], [0, 8, 9]);
        assert!(streams.aligned(0) && streams.aligned(1) && !streams.aligned(2));
    }

    #[test]
    fn split_members_stand_component_by_component() {
        let streams = Streams::of(Spec::Split, 1, &MEMBERS, &["x", "flag", "mass"]);
        assert_eq!(streams.start(1, 5, 8), 2 * 24);
        assert_eq!(streams.component(0, 5, 8), 24);
        assert_eq!(streams.bytes(5, 8), 48 + 8 + 40);
    }

    #[test]
    fn names_are_compared_byte_by_byte() {
        assert!(named("v", ((b'v' as u128) << 120, 0)));
        assert!(!named("vv", ((b'v' as u128) << 120, 0)));
        assert!(!named("", ((b'v' as u128) << 120, 0)));
        assert!(named("v.x", ((b'v' as u128) << 120, 0)));
        let (high, low) = (u128::from_be_bytes(*b"abcdefghijklmnop"), u128::from_be_bytes(*b"qrstuvwxyzabcdef"));
        assert!(named("abcdefghijklmnopqrstuvwxyzabcdef", (high, low)));
        assert!(!named("abcdefghijklmnopqrstuvwxyzabcdefg", (high, low)));
        assert!(named("abcdefghijklmnop", (high, 0)) && !named("abcdefghijklmnop", (high, low)));
    }
}
