//! `#[kernel(unchecked)]`, and accesses without checks.

use allotrope::prelude::*;

use super::Node;

/// Defines a kernel twice: checked and unchecked.
macro_rules! both {
    ($checked:ident $unchecked:ident $parameters:tt $(-> $result:ty)? $body:block) => {
        both!(@ [#[kernel]] $checked $parameters [$($result)?] $body);
        both!(@ [#[kernel(unchecked)]] $unchecked $parameters [$($result)?] $body);
    };
    (@ [$(#[$kernel:meta])*] $name:ident ($($parameter:ident: $type:ty),*) [$($result:ty)?] $body:block) => {
        $(#[$kernel])*
        fn $name($($parameter: $type),*) $(-> $result)? $body
    };
}

both! {
    work work_unchecked
    (from: &Field<Node, _, Ij>, to: &mut Field<Node, _, Ij>, sums: &mut Field<f32, _>, at: &Field<IVec2, _>) -> f32
    {
        let mut total = 0.0;
        for (i, j) in ndrange!(1..9, 1..15) {
            to.m[(i, j)] = from.m[(i - 1, j)] + from.m[(i, j + 1)];
            total += to.m[(i, j)];
        }
        for p in at {
            let base = at[p];
            for (a, b) in unroll!(-1..2, -1..2) {
                let offset = ivec2(a, b);
                to.v[base + offset] += vec2(a as f32, from.m[base + offset]);
            }
            to.m[base].max_assign(from.m[(base.x, base.y - 1)]);
            sums[base.x] += from.v[base].x;
        }
        for i in 0..10 {
            for k in 0..16 {
                to.v[(i, k)].y += to.v[(i, 0)].x;
            }
        }
        total
    }
}

fn start<L: Layout<Ij>>() -> Field<Node, L, Ij> {
    let mut field = Field::<Node, L>::new([10, 16]);
    for i in 0..10 {
        for j in 0..16 {
            field.set([i, j], Node { v: vec2(i as f32, j as f32), m: (i * j % 7) as f32 });
        }
    }
    field
}

#[test]
fn unchecked_kernels_do_as_the_checked_ones() {
    fn run<L: Layout<Ij>, M: Layout<I>>() {
        let from = start::<L>();
        let mut at = Field::<IVec2, M>::new([500]);
        for p in 0..500 {
            at.set(p, ivec2(1 + p * 5 % 8, 1 + p * 3 % 14));
        }
        for threads in 1..=3 {
            let schedule = Schedule { threads, grain: 16, ..Schedule::default() };
            let (mut a, mut b) = (start::<L>(), start::<L>());
            let (mut sums, mut others) = (Field::<f32, M>::new([10]), Field::<f32, M>::new([10]));
            let total = schedule.run(|| work(&from, &mut a, &mut sums, &at));
            // SAFETY: `at` holds places of the inner cells, and the fields are as large as the ranges.
            let other = schedule.run(|| unsafe { work_unchecked(&from, &mut b, &mut others, &at) });
            assert_eq!(total, other);
            assert!(a.iter().eq(b.iter()));
            assert_eq!(sums.to_vec(), others.to_vec());
            assert!(total > 0.0 && sums.get(5) > 0.0);
        }
    }
    run::<Aos, Soa>();
    run::<Blocked<4>, AoSoA<8>>();
    run::<layout!(dense(ji).split), Aos>();
}

/// Generic, a method, with a value that it returns.
struct Scale(f32);

impl Scale {
    /// # Safety
    /// `at` holds indices of `u`.
    #[kernel(unchecked)]
    fn gather<T: Copy + Into<f32> + Sync, L: Layout<I>>(&self, u: &Field<f32, L>, at: &Field<u32, L>, add: T) -> f32 {
        let mut sum = 0.0;
        for p in at {
            sum += self.0 * u[at[p]] + add.into();
        }
        sum
    }

    #[kernel(unchecked)]
    fn fill<const N: usize>(u: &mut Field<f32, AoSoA<N>>, (low, high): (f32, f32)) {
        for p in u {
            u[p] = if p % 2 == 0 { low } else { high };
        }
    }
}

#[test]
fn unchecked_methods_with_generics() {
    let u = Field::<f32, Soa>::new([4]).with_background(2.0);
    let at = Field::<u32, Soa>::new([100]).with_background(3);
    // SAFETY: 3 is an index of four elements.
    assert_eq!(unsafe { Scale(3.0).gather::<u8, Soa>(&u, &at, 1) }, 700.0);
    let mut u = Field::<f32, AoSoA<4>>::new([6]);
    // SAFETY: it has no index but the loop's own.
    unsafe { Scale::fill::<4>(&mut u, (1.0, 2.0)) };
    assert_eq!(u.to_vec(), [1.0, 2.0, 1.0, 2.0, 1.0, 2.0]);
}

/// With debug assertions the promise is checked.
#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "kernel `gather`: index [4] is out of range of field `u`, whose shape is [4]")]
fn broken_promises_are_found_with_debug_assertions() {
    let at = Field::<u32, Soa>::new([1]).with_background(4);
    // SAFETY: none, which debug assertions find before anything is read.
    unsafe { Scale(1.0).gather(&Field::<f32, Soa>::new([4]), &at, 0u8) };
}

/// A permutation, which the kernel cannot know to be one.
///
/// Reads of what was written in the same iteration see it, however the loop holds its values.
#[kernel]
fn permute(to: &mut Field<Node, _>, from: &Field<f32, _>, order: &Field<u32, _>) {
    for p in from {
        // SAFETY: `order` is a permutation of the fields' indices, so that no two iterations have the same.
        unsafe {
            to.m.set_unchecked(order[p], from.get_unchecked(p));
            to.m.set_unchecked(order[p], to.m.get_unchecked(order[p]) + 1.0);
        }
    }
    for p in to {
        to.m[p] *= 2.0;
        // SAFETY: the iteration's own element.
        let read = unsafe { to.m.get_unchecked(p) };
        // SAFETY: as above.
        unsafe { to.m.set_unchecked(p, read + 0.5) };
        to.v[p] = vec2(to.m[p], read);
    }
    // SAFETY: there are two elements at least.
    unsafe { to.m.set_unchecked(0, to.get_unchecked(1).m) };
}

#[test]
fn accesses_without_checks() {
    fn run<L: Layout<I>>() {
        let mut order = Field::<u32, L>::new([101]);
        order.copy_from_slice(&(0..101).map(|p| p * 10 % 101).collect::<Vec<_>>());
        let mut from = Field::<f32, Soa>::new([101]);
        from.copy_from_slice(&(0..101).map(|p| p as f32).collect::<Vec<_>>());
        for threads in 1..=3 {
            let mut to = Field::<Node, L>::new([101]);
            Schedule { threads, grain: 8, ..Schedule::default() }.run(|| permute(&mut to, &from, &order));
            for p in 1..101 {
                let value = 2.0 * (p as f32 + 1.0);
                let node = to.get(p * 10 % 101);
                assert_eq!(node, Node { m: value + 0.5, v: vec2(value + 0.5, value) });
            }
            assert_eq!(to.get(0).m, to.get(1).m);
        }
    }
    run::<Aos>();
    run::<Soa>();
    run::<AoSoA<8>>();
    run::<layout!(dense(i).dense(i, 16).split)>();
}
