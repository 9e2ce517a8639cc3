//! What the macros' expansions call. Nothing here is for users: it changes with the macros, whose version is locked.

pub use crate::contract::{Contracted, FuseAny, FuseKnown};
pub use crate::enumeration::Code;
pub use crate::exchange::{
    compare_exchange, fetch_add, fetch_and, fetch_max, fetch_min, fetch_or, fetch_sub, fetch_xor, swap,
};
pub use crate::field::{Entries, EntryTuples, Handle, Storage};
pub use crate::index::wide;
pub use crate::launch::{Batch, InLanes, Lane, Lanes, Mask, Part, Width, ends};
pub use crate::launch::{Border, Checkerboard, Colored, Sieve, Sifted, TwoColours, sift, sifted};
pub use crate::launch::{
    Cell, Options, Outs, Partial, Reduction, Run, Space, Strip, Task, interior, launch, launch_inside,
    launch_inside_keyed, launch_keyed, launch_own, of_branch, over, range, reduction, still,
};
pub use crate::layout::{Brick, Head, ListSpec, Root, TreeSpec};
pub use crate::number::{BitAnd, BitOr, BitXor, ComponentMul, Max, Min, Product, Sum};
pub use crate::record::{
    At, ElementList, MemberMuts, MemberRefs, MemberSpec, PartMut, PartRef, Path, Tag, Under, Whole,
};
pub use crate::scatter::{Coordinates, Key, Op, Scattered, Sink, Target, key};
pub use crate::view::{
    Accumulate, Based, Beside, Boxed, Buffer, Corners, Free, Held, Linear, OfLoop, Other, Own, OwnFree, Read, Row,
    Site, Together, Var, View, assert_packed, buffer, exclusive, negative, shared,
};
pub use crate::view::{EightCorners, Whose};

pub use crate::capture::{Hold, Lend, Wrap, assert_shared};
pub use crate::unchecked::Unchecked;

pub use crate::serial::{
    NotAnAccess, border, byte_offset, clamped, cold, get_unchecked, index_tuples, indices, interior_indices,
    interior_tuples, lend, locate, max, min, ndrange, or, path, read, read_at, row, row_tuples, set_unchecked, tags,
    wrapped, write, write_at,
};
