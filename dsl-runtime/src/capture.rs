//! What a loop's body uses of the kernel's variables: copies where that is possible, so that stores to fields cannot be
//! thought to change them.

/// The largest value behind a reference that is copied into a job's frame.
const SMALL: usize = 512;

/// Wraps a reference for [`hold`](Hold::hold).
#[derive(Debug)]
pub struct Wrap<'a, T: ?Sized>(pub &'a T);

/// A copy of the value.
#[derive(Clone, Copy, Debug)]
pub struct Held<'a, T> {
    copy: T,
    original: &'a T,
}

impl<T> Held<'_, T> {
    /// The value.
    #[inline(always)]
    pub fn get(&self) -> &T {
        if const { size_of::<T>() <= SMALL } { &self.copy } else { self.original }
    }
}

/// The value itself, where it cannot be copied.
#[derive(Debug)]
pub struct Lent<'a, T: ?Sized>(&'a T);

impl<T: ?Sized> Lent<'_, T> {
    /// The value.
    #[inline(always)]
    pub fn get(&self) -> &T {
        self.0
    }
}

/// Method resolution prefers this to [`Lend`], where the value is `Copy`.
pub trait Hold<'a> {
    /// What is held.
    type Held;
    /// Takes the copy.
    fn hold(self) -> Self::Held;
}
impl<'a, T: Copy> Hold<'a> for Wrap<'a, T> {
    type Held = Held<'a, T>;
    #[inline(always)]
    fn hold(self) -> Held<'a, T> {
        Held { copy: *self.0, original: self.0 }
    }
}

/// For all values.
pub trait Lend<'a> {
    /// What is lent.
    type Lent;
    /// Takes the reference.
    fn hold(self) -> Self::Lent;
}
impl<'a, T: ?Sized> Lend<'a> for &Wrap<'a, T> {
    type Lent = Lent<'a, T>;
    #[inline(always)]
    fn hold(self) -> Lent<'a, T> {
        Lent(self.0)
    }
}

/// What a parallel loop's body may use: anything that threads may share.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be used in a parallel loop: threads cannot share it",
    label = "not shared between threads",
    note = "cells, `Rc` and raw pointers would race; hand in plain values or `&T` of them, or write `#[serial]` before the loop"
)]
pub trait Shared {}
impl<T: Sync + ?Sized> Shared for T {}

/// Refuses what threads cannot share, at the place of its use.
#[inline(always)]
pub fn assert_shared<T: Shared + ?Sized>(_: &T) {}
