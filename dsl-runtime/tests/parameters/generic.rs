//! Kernels that are generic: over numbers, records, axes, layouts, constants and functions; in `impl` blocks, with all of these.

use allotrope::prelude::*;
use allotrope::{AnyMember, Element, MemberMut};

use super::Node;

/// One kernel for both precisions, its members of any record.
#[kernel]
fn relax<T: Real>(from: &Member<T, _, Ij>, to: &mut Member<T, _, Ij>, rate: T) -> T {
    let mut change = T::ZERO;
    let mut count = 0;
    for (i, j) in to.interior(1) {
        let around = from[(i - 1, j)] + from[(i + 1, j)] + from[(i, j - 1)] + from[(i, j + 1)];
        let new = from[(i, j)] + rate * (around / T::from(4.0) - from[(i, j)]);
        change.max_assign((new - from[(i, j)]).abs());
        count += 1;
        to[(i, j)] = new;
    }
    change * T::from_i32(count)
}

/// Accumulation at any index, and reductions of generic elements.
#[kernel]
fn count_into<T: Real, const N: usize>(values: &Field<T, _>, bins: &mut Field<T, _>) -> [T; N] {
    let mut all = [T::ZERO; N];
    for i in values {
        let bin = values[i].floor().to_i32().rem_euclid(N as i32);
        bins[bin] += T::ONE;
        all[bin as usize] += T::ONE;
    }
    all
}

/// Any element, over any axes.
#[kernel]
fn copy<E: Element, X: Axes>(from: &Field<E, _, X>, to: &mut Field<E, _, X>) {
    for at in to {
        to[at] = from[at];
    }
}

/// Any record: whole, and by a function of the caller's.
#[kernel]
fn update<R: Record>(field: &mut Field<R, _>, change: impl Fn(R) -> R + Sync) {
    for p in field {
        field[p] = change(field[p]);
    }
}

/// One layout for two fields, a constant for another's.
#[kernel]
fn swap<L: Layout<I>, const N: usize>(a: &mut Field<f32, L>, b: &mut Field<f32, L>, c: &mut Field<f32, AoSoA<N>>) {
    for i in a {
        let (x, y) = (a[i], b[i]);
        a[i] = y;
        b[i] = x;
        c[i] = x * N as f32;
    }
}

#[test]
fn numbers_of_both_precisions() {
    fn run<T: Real, L: Layout<Ij>>(tolerance: f64) -> Vec<f64> {
        let mut a = Field::<T, L>::new([9, 11]);
        a.set([4, 5], T::from(16.0));
        let mut b = a.clone();
        let mut changes = Vec::new();
        for _ in 0..3 {
            changes.push(relax(&a, &mut b, T::from(0.5)).to_f64());
            std::mem::swap(&mut a, &mut b);
        }
        // The same with the turbofish, into a member of a record.
        let mut members = Field::<[T; 1], L>::new([9, 11]);
        let mut other = Field::<T, L>::new([9, 11]);
        copy::<T, Ij>(&a, &mut other);
        assert_eq!(relax::<T>(&a, &mut b, T::ZERO), T::ZERO);
        copy::<[T; 1], Ij>(&members.clone(), &mut members);
        assert_eq!(other.to_vec(), a.to_vec());
        assert!((a.to_vec().into_iter().sum::<T>().to_f64() - 16.0).abs() < tolerance);
        changes
    }
    let expected = run::<f64, Aos>(1e-12);
    assert_eq!(expected[0], 8.0 * 63.0);
    assert_eq!(run::<f64, Soa>(1e-12), expected);
    let changes = run::<f32, layout!(dense(ji).split)>(1e-5);
    assert!(changes.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-3), "{changes:?} {expected:?}");
}

#[test]
fn constants_and_accumulation() {
    fn run<T: Real, L: Layout<I>>() {
        let mut values = Field::<T, L>::new([1000]);
        values.copy_from_slice(&(0..1000).map(|n| T::from_f64(f64::from(n) / 10.0)).collect::<Vec<_>>());
        let mut bins = Field::<T, L>::new([7]);
        for threads in 1..=3 {
            let schedule = Schedule { threads, grain: 64, ..Schedule::default() };
            bins.fill(T::ZERO);
            let all = schedule.run(|| count_into::<T, 7>(&values, &mut bins));
            assert_eq!(all.map(Real::to_f64), [150.0, 150.0, 140.0, 140.0, 140.0, 140.0, 140.0]);
            assert_eq!(bins.to_vec(), all);
        }
    }
    run::<f32, Aos>();
    run::<f64, Soa>();
    run::<f32, AoSoA<8>>();
}

#[test]
fn elements_records_and_axes() {
    fn run<E: Element + PartialEq + std::fmt::Debug, A: Layout<Ijk>, B: Layout<Ijk>>(value: impl Fn(usize) -> E) {
        let mut from = Field::<E, A>::new([3, 4, 5]);
        from.copy_from_slice(&(0..60).map(&value).collect::<Vec<_>>());
        let mut to = Field::<E, B>::new([3, 4, 5]);
        copy(&from, &mut to);
        assert_eq!(to.get([1, 2, 3]), value(20 + 10 + 3));
        assert_eq!(to.to_vec(), from.to_vec());
    }
    run::<f32, Aos, Soa>(|n| n as f32);
    run::<Vec3, Split, Aos>(|n| vec3(n as f32, 1.0, -1.0));
    run::<[u8; 3], layout!(dense(kji).aos), Split>(|n| [n as u8; 3]);
    let mut single = Field::<bool, Aos>::new([]);
    copy::<bool, O>(&Field::<bool, Aos>::new([]).with_background(true), &mut single);
    assert!(single.get(()));

    fn change<L: Layout<I>>() {
        let mut nodes = Field::<Node, L>::new([50]);
        update(&mut nodes, |node| Node { m: node.m + 1.0, ..node });
        update::<Node>(&mut nodes, |node| Node { v: Vec2::X * node.m, ..node });
        assert!(nodes.iter().all(|node| node == Node { v: Vec2::X, m: 1.0 }));
    }
    change::<Aos>();
    change::<Soa>();
    change::<AoSoA<4>>();
}

#[test]
fn layouts_in_common() {
    fn run<L: Layout<I>>() {
        let (mut a, mut b) = (Field::<f32, L>::new([20]).with_background(1.0), Field::<f32, L>::new([20]));
        let mut c = Field::<f32, AoSoA<4>>::new([20]);
        swap(&mut a, &mut b, &mut c);
        swap::<L, 4>(&mut b, &mut a, &mut c);
        swap(&mut a, &mut b, &mut c);
        assert_eq!((a.get(19), b.get(3), c.get(7)), (0.0, 1.0, 4.0));
    }
    run::<Aos>();
    run::<Soa>();
    run::<AoSoA<8>>();
}

/// A solver over any number, in any layout of its own.
struct Solver<T: Real, L: Layout<Ij>> {
    heat: Field<T, L, Ij>,
    next: Field<T, L, Ij>,
    source: T,
}

impl<T: Real, L: Layout<Ij>> Solver<T, L> {
    fn new(shape: [usize; 2], source: T) -> Self {
        Self { heat: Field::new(shape), next: Field::new(shape), source }
    }

    /// A method that is a kernel: it takes its fields beside what it reads of itself.
    #[kernel]
    fn add<const N: usize>(source: &Self, heat: &mut Field<T, L, Ij>, weights: [T; N]) {
        for (i, j) in heat {
            heat[(i, j)] += source.source * weights[(i as usize + j as usize) % N];
        }
    }

    #[kernel]
    fn scaled(&self, heat: &Field<T, L, Ij>, by: impl Fn(T) -> T + Sync) -> T {
        let mut sum = T::ZERO;
        for ij in heat {
            sum += by(heat[ij]) * self.source;
        }
        sum
    }

    fn step(&mut self) -> T {
        let mut next = std::mem::replace(&mut self.next, Field::new([0, 0]));
        Self::add(self, &mut next, [T::ONE, T::from(2.0)]);
        relax(&self.heat, &mut next, T::ONE);
        let sum = self.scaled(&next, |x| x + T::ONE);
        self.next = std::mem::replace(&mut self.heat, next);
        sum
    }
}

#[test]
fn kernels_in_generic_impl_blocks() {
    fn run<T: Real, L: Layout<Ij>>() {
        let mut solver = Solver::<T, L>::new([4, 4], T::from(3.0));
        // All but the four inner cells: six of weight 1, six of weight 2.
        assert_eq!(solver.step(), T::from(3.0 * (3.0 * 18.0 + 16.0)));
        assert_eq!(solver.heat.get([0, 1]), T::from(6.0));
        Solver::<T, L>::add::<1>(&Solver::new([1, 1], T::ONE), &mut solver.heat, [T::ONE]);
        assert_eq!(solver.heat.get([0, 1]), T::from(7.0));
    }
    run::<f32, Aos>();
    run::<f64, Soa>();
    run::<f32, layout!(dense(ji).split)>();
}

/// A function around kernels, generic over the member.
fn fill_all<T: Real>(member: &mut impl allotrope::AnyMemberMut<T, I>, value: T) -> T {
    fill(member, value);
    AnyMember::get(member, 0)
}

#[kernel]
fn fill<T: Real>(member: &mut Member<T, _>, value: T) {
    for i in member {
        member[i] = value;
    }
}

#[test]
fn kernels_called_by_generic_functions() {
    fn run<L: Layout<I>>() {
        let mut nodes = Field::<Node, L>::new([5]);
        let mass: &mut MemberMut<'_, Node, L, I, _> = &mut nodes.members_mut().m;
        assert_eq!(fill_all(mass, 2.5), 2.5);
        assert_eq!(nodes.get(4), Node { v: Vec2::ZERO, m: 2.5 });
    }
    run::<Aos>();
    run::<Split>();
    run::<AoSoA<4>>();
}

#[test]
fn functions_of_real_numbers() {
    fn check<T: Real>(tolerance: f64) {
        let x = T::from(0.75);
        let near = |a: T, b: f64| assert!((a.to_f64() - b).abs() < tolerance, "{a} {b}");
        near(x.sqrt() + x.exp() * x.sin().atan2(x.cos()), 0.75f64.sqrt() + 0.75f64.exp() * 0.75);
        near(x.powi(3).mul_add(x, x.powf(T::from(2.0))), 0.75f64.powi(4) + 0.5625);
        near(T::PI / T::TAU, 0.5);
        near((-x).rem_euclid(T::from(0.5)).hypot(T::ONE).copysign(-x), -(0.25f64.hypot(1.0)));
        near(x.clamp(T::ZERO, T::from(0.5)).max(T::from_i32(-3)).min(T::from_f64(1.0 / 3.0)), 1.0 / 3.0);
        assert_eq!((T::from(2.9).to_i32(), T::from(-2.9).to_i32(), T::NAN.to_i32()), (2, -2, 0));
        assert!(T::NAN.is_nan() && !T::INFINITY.is_finite() && T::MAX.is_finite() && (-T::ZERO).is_sign_negative());
        assert_eq!((T::ONE + T::EPSILON) - T::ONE, T::EPSILON);
        assert_eq!([T::ONE; 3].into_iter().sum::<T>(), T::from(3.0));
        assert!(random::<T>(1, 2) < T::ONE);
        let (least, denormal) = (T::MIN_POSITIVE, T::MIN_POSITIVE / T::from(2.0));
        assert!(denormal > T::ZERO && -denormal < T::ZERO);
        assert_eq!([denormal, -denormal, -T::ZERO].map(Real::flushed), [T::ZERO; 3]);
        assert_eq!([least, -least, x, T::INFINITY].map(Real::flushed), [least, -least, x, T::INFINITY]);
        assert!(T::NAN.flushed().is_nan());
    }
    check::<f32>(1e-6);
    check::<f64>(1e-14);
}
