//! Fields without axes, and over four.

use allotrope::prelude::*;

use crate::Node;

#[kernel]
fn weigh(masses: &Field<f32, _>, all: &mut Field<Node, _, O>, largest: &mut Field<f32, _, O>) -> f32 {
    for p in masses {
        all.m[()] += masses[p];
        all.v[()] += vec2(masses[p], 1.0);
        largest[()].max_assign(masses[p]);
    }
    all.m[()]
}

#[kernel]
fn scale(masses: &mut Field<f32, _>, by: &Field<f32, _, O>) {
    for p in masses {
        masses[p] *= by[()];
    }
    #[serial]
    for p in 0..2 {
        masses[p] += by[()];
    }
}

#[kernel]
fn touch(one: &mut Field<f32, _, O>) -> i32 {
    let mut visits = 0;
    for at in one {
        one[at] += 1.0;
        visits += 1;
    }
    one[()] = 2.0 * one[()];
    visits
}

#[test]
fn a_field_without_axes_is_one_record() {
    fn run<L: Layout<O>>() {
        let mut masses = Field::<f32, Soa>::new([20_000]);
        masses.fill(0.5);
        masses.set(77, 3.5);
        for scatter in [Scatter::Auto, Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
            let (mut all, mut largest) = (Field::<Node, L>::new([]), Field::<f32, L>::new([]));
            let mass = Schedule { scatter, ..Schedule::default() }.run(|| weigh(&masses, &mut all, &mut largest));
            assert_eq!(mass, 10_003.0);
            assert_eq!(all.get(()), Node { v: vec2(10_003.0, 20_000.0), m: 10_003.0 });
            assert_eq!(largest.get(()), 3.5);
        }
        let mut one = Field::<f32, L>::new([]).with_background(2.0);
        assert_eq!((one.len(), one.shape(), one.to_vec()), (1, [], vec![2.0]));
        scale(&mut masses, &one);
        assert_eq!((masses.get(0), masses.get(77), masses.get(78)), (3.0, 7.0, 1.0));
        assert_eq!(touch(&mut one), 1);
        assert_eq!(one.get(()), 6.0);
        assert_eq!(one.relayout::<Morton<4>>().get(()), 6.0);
    }
    run::<Aos>();
    run::<Split>();
    run::<AoSoA<16>>();
    run::<Blocked<8>>();
    run::<Morton<2>>();
}

#[kernel]
fn advect(f: &Field<i32, _, Ijkl>, next: &mut Field<i32, _, Ijkl>) -> i32 {
    let mut sum = 0;
    for (x, y, u, v) in next.interior(1) {
        next[(x, y, u, v)] = f[(x - 1, y, u, v)] + 2 * f[(x, y + 1, u, v)] + f[(x, y, u - 1, v)] + f[(x, y, u, v + 1)];
        sum += next[(x, y, u, v)];
    }
    sum
}

#[kernel]
fn advect_vectors(f: &Field<i32, _, Ijkl>, next: &mut Field<i32, _, Ijkl>) -> i32 {
    let mut sum = 0;
    for at in next.interior(1) {
        next[at] = f[at - IVec4::X] + 2 * f[at + IVec4::Y] + f[at + IVec4::new(0, 0, -1, 0)] + f[at + IVec4::W];
        sum += next[at];
    }
    sum
}

#[kernel]
fn count(counts: &mut Field<i32, _, Ijkl>, shape: [i32; 4]) {
    for (i, j, k, l) in ndrange!(0..shape[0], 0..shape[1], 0..shape[2], 0..shape[3]) {
        counts[(i, j, k, l)] = 1000 * i + 100 * j + 10 * k + l;
    }
}

#[test]
fn four_axes() {
    fn run<L: Layout<Ijkl>>(step: impl Fn(&Field<i32, L, Ijkl>, &mut Field<i32, L, Ijkl>) -> i32) {
        let shape = [5, 4, 3, 6];
        let mut f = Field::<i32, L>::new(shape);
        count(&mut f, shape.map(|extent| extent as i32));
        assert_eq!((f.get((4, 3, 2, 5)), f.get([1, 0, 2, 0])), (4325, 1020));
        let mut next = Field::<i32, L>::new(shape);
        let sum = step(&f, &mut next);
        let mut expected = 0;
        for at in
            (0..5).flat_map(|i| (0..4).flat_map(move |j| (0..3).flat_map(move |k| (0..6).map(move |l| [i, j, k, l]))))
        {
            let inside = at.iter().zip(shape).all(|(&n, extent)| n > 0 && n + 1 < extent as i32);
            let value = if inside { 5 * f.get(at) - 1000 + 200 - 10 + 1 } else { 0 };
            assert_eq!(next.get(IVec4::from_array(at)), value, "{at:?}");
            expected += value;
        }
        assert_eq!(sum, expected);
    }
    run::<Aos>(advect);
    run::<Soa>(advect_vectors);
    run::<Blocked<2>>(advect);
    run::<Morton<4>>(advect_vectors);
    run::<layout!(dense(lijk).dense(ijkl, (2, 1, 3, 4)).aos)>(advect);
}
