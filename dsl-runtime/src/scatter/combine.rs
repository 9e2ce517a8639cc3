//! Combining lines of scalars with an operator that is known at run time.

use crate::element::{Kind, Scalar};
use crate::number::{BitAnd, BitOr, BitXor, Max, Min, Operator, Product, Sum};

/// An accumulation operator as data.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    /// `+=` and `-=`.
    Add,
    /// `*=`.
    Mul,
    /// `min_assign`.
    Min,
    /// `max_assign`.
    Max,
    /// `&=`.
    And,
    /// `|=`.
    Or,
    /// `^=`.
    Xor,
}

impl Op {
    /// Whether zeroed memory holds identities. (A sum's exact one is -0, but 0 differs in no sum other than -0.)
    pub(super) fn identity_is_zero(self) -> bool {
        matches!(self, Self::Add | Self::Or | Self::Xor)
    }
}

/// Scalars at equal distances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) kind: Kind,
    pub(super) op: Op,
    /// Bytes from the root to the first.
    pub(super) offset: usize,
    /// Bytes between neighbours.
    pub(super) step: usize,
    pub(super) count: usize,
}

/// Calls a function with the scalar and operator types of a line.
macro_rules! by_type {
    ($line:expr, $f:ident($($argument:expr),*)) => {
        match $line.kind {
            Kind::F32 => by_type!(@number f32, $line, $f($($argument),*)),
            Kind::F64 => by_type!(@number f64, $line, $f($($argument),*)),
            Kind::I8 => by_type!(@bits i8, $line, $f($($argument),*)),
            Kind::I16 => by_type!(@bits i16, $line, $f($($argument),*)),
            Kind::I32 => by_type!(@bits i32, $line, $f($($argument),*)),
            Kind::I64 => by_type!(@bits i64, $line, $f($($argument),*)),
            Kind::U8 => by_type!(@bits u8, $line, $f($($argument),*)),
            Kind::U16 => by_type!(@bits u16, $line, $f($($argument),*)),
            Kind::U32 => by_type!(@bits u32, $line, $f($($argument),*)),
            Kind::U64 => by_type!(@bits u64, $line, $f($($argument),*)),
            Kind::Bool => match $line.op {
                Op::And => $f::<bool, BitAnd>($($argument),*),
                Op::Or => $f::<bool, BitOr>($($argument),*),
                Op::Xor => $f::<bool, BitXor>($($argument),*),
                _ => unreachable!("`bool` is no number: its sums do not compile"),
            },
        }
    };
    (@number $scalar:ty, $line:expr, $f:ident($($argument:expr),*)) => {
        match $line.op {
            Op::Add => $f::<$scalar, Sum>($($argument),*),
            Op::Mul => $f::<$scalar, Product>($($argument),*),
            Op::Min => $f::<$scalar, Min>($($argument),*),
            Op::Max => $f::<$scalar, Max>($($argument),*),
            Op::And | Op::Or | Op::Xor => unreachable!("bit operators on floats do not compile"),
        }
    };
    (@bits $scalar:ty, $line:expr, $f:ident($($argument:expr),*)) => {
        match $line.op {
            Op::And => $f::<$scalar, BitAnd>($($argument),*),
            Op::Or => $f::<$scalar, BitOr>($($argument),*),
            Op::Xor => $f::<$scalar, BitXor>($($argument),*),
            _ => by_type!(@number $scalar, $line, $f($($argument),*)),
        }
    };
}

/// Combines a line of a copy into the field's, and fills the copy's with identities.
///
/// # Safety
/// The line lies within both memories, and the caller has it to itself.
pub(super) unsafe fn combine_line(field: *mut u8, copy: *mut u8, line: Line) {
    // SAFETY: as the caller promises.
    by_type!(line, combine(unsafe { field.add(line.offset) }, unsafe { copy.add(line.offset) }, line));
}

/// Fills a line with identities, or with zeros.
///
/// # Safety
/// The line lies within the memory, and the caller has it to itself.
pub(super) unsafe fn set_line(copy: *mut u8, line: Line, identity: bool) {
    // SAFETY: as the caller promises.
    by_type!(line, set(unsafe { copy.add(line.offset) }, line, identity));
}

/// Scalars that are looked at together: if none was touched, the field's are left alone.
const PAGE: usize = 1024;

fn combine<S: Scalar, O: Operator<S>>(field: *mut u8, copy: *mut u8, line: Line) {
    // Zeroed memory stands for a sum's identity.
    let idle = if line.op.identity_is_zero() { zero::<S>() } else { O::IDENTITY };
    if line.step == size_of::<S>() && line.offset.is_multiple_of(size_of::<S>()) {
        // SAFETY: the line is `count` scalars without gaps, aligned as fields are; field and copy are different memories.
        let (field, copy) = unsafe {
            (
                core::slice::from_raw_parts_mut(field.cast::<S>(), line.count),
                core::slice::from_raw_parts_mut(copy.cast::<S>(), line.count),
            )
        };
        for (field, copy) in field.chunks_mut(PAGE).zip(copy.chunks_mut(PAGE)) {
            if copy.iter().fold(true, |all, &value| all & (value == idle)) {
                continue;
            }
            for (to, from) in field.iter_mut().zip(copy.iter_mut()) {
                *to = O::apply(*to, *from);
                *from = idle;
            }
        }
        return;
    }
    for n in 0..line.count {
        // SAFETY: the caller has the line's scalars to itself in both memories.
        unsafe {
            let (to, from) = (field.add(n * line.step).cast::<S>(), copy.add(n * line.step).cast::<S>());
            let value = from.read_unaligned();
            if value != idle {
                to.write_unaligned(O::apply(to.read_unaligned(), value));
                from.write_unaligned(idle);
            }
        }
    }
}

/// The value of zero bytes.
fn zero<S: Scalar>() -> S {
    // SAFETY: zero bytes are a value of every scalar.
    unsafe { core::mem::zeroed() }
}

fn set<S: Scalar, O: Operator<S>>(copy: *mut u8, line: Line, identity: bool) {
    let value = if identity && !line.op.identity_is_zero() { O::IDENTITY } else { zero::<S>() };
    for n in 0..line.count {
        // SAFETY: the caller has the line's scalars to itself.
        unsafe { copy.add(n * line.step).cast::<S>().write_unaligned(value) };
    }
}
