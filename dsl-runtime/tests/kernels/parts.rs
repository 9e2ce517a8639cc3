//! Reductions into entries of arrays, components and parts of tuples; accumulation into components at any index.

use allotrope::prelude::*;

#[kernel]
fn histogram(u: &Field<f32, _, Ij>) -> ([u32; 8], [[f64; 2]; 3]) {
    let mut counts = [0; 8];
    let mut sums = [[0.0; 2]; 3];
    for (i, j) in u {
        let value = u[(i, j)];
        counts[value as usize] += 1;
        sums[(i % 3) as usize][0] += f64::from(value);
        sums[(i % 3) as usize][1] -= 1.0;
        sums[2][1] -= 0.5;
    }
    (counts, sums)
}

fn ramp<L: Layout<Ij>>() -> Field<f32, L, Ij> {
    let mut u = Field::<f32, L>::new([37, 11]);
    for i in 0..37 {
        for j in 0..11 {
            u.set((i, j), ((i * 5 + j * 3) % 8) as f32 + 0.25);
        }
    }
    u
}

#[test]
fn entries_of_arrays() {
    fn run<L: Layout<Ij>>() {
        let u = ramp::<L>();
        for threads in [1, 3] {
            let (counts, sums) = Schedule { threads, grain: 16, ..Schedule::default() }.run(|| histogram(&u));
            let mut expected = ([0; 8], [[0.0; 2]; 3]);
            for (n, value) in u.iter().enumerate() {
                expected.0[value as usize] += 1;
                expected.1[n / 11 % 3][0] += f64::from(value);
                expected.1[n / 11 % 3][1] -= 1.0;
                expected.1[2][1] -= 0.5;
            }
            assert_eq!((counts, sums), expected, "the numbers are exact");
        }
    }
    run::<Aos>();
    run::<AoSoA<4>>();
    run::<Blocked<4>>();
    run::<Morton<4>>();
}

#[test]
fn floats_have_the_same_bits_on_any_number_of_threads() {
    let mut u = Field::<f32, Soa>::new([100, 1000]);
    (0..100).for_each(|i| (0..1000).for_each(|j| u.set((i, j), ((i * 31 + j * 17) % 8000) as f32 / 1000.1)));
    let run =
        |threads| Schedule { threads, ..Schedule::default() }.run(|| histogram(&u)).1.map(|s| s.map(f64::to_bits));
    assert_eq!(run(1), run(2));
    assert_eq!(run(1), run(5));
}

#[kernel]
fn extremes(points: &Field<Vec3, _>) -> ((Vec3, Vec3), (Vec3A, i64, u8), Mat2) {
    let mut bounds = (Vec3::splat(f32::INFINITY), Vec3::splat(f32::NEG_INFINITY));
    let mut other = (Vec3A::ONE, 5, 0);
    let mut matrix = Mat2::ZERO;
    for p in points {
        let x = points[p];
        bounds.0.min_assign(x);
        bounds.1.max_assign(x);
        other.0.y += x.y;
        other.0.z -= 1.0;
        other.0 += Vec3A::X;
        if x.x > 2.0 {
            other.1 -= 1;
            continue;
        }
        other.2 |= 1 << p;
        matrix.x_axis.y += x.z;
        matrix.y_axis[0] -= 2.0;
    }
    (bounds, other, matrix)
}

#[test]
fn components_and_parts_of_tuples() {
    fn run<L: Layout<I>>() {
        let mut points = Field::<Vec3, L>::new([5]);
        (0..5).for_each(|p| points.set(p, vec3(p as f32, -(p as f32), 0.5)));
        let ((low, high), (sum, count, bits), matrix) = extremes(&points);
        assert_eq!((low, high), (vec3(0.0, -4.0, 0.5), vec3(4.0, 0.0, 0.5)));
        assert_eq!((sum, count, bits), (Vec3A::new(6.0, -9.0, -4.0), 3, 0b111));
        assert_eq!(matrix, Mat2::from_cols(vec2(0.0, 1.5), vec2(-6.0, 0.0)));
    }
    run::<Aos>();
    run::<Split>();
    run::<AoSoA<2>>();
}

#[kernel]
fn scaled(u: &Field<f32, _>, mut by: Vec2) -> (Vec2, [i32; 2]) {
    let mut product = [1, 1];
    for p in u {
        by *= 2.0;
        product[p as usize % 2] *= 3;
    }
    for _ in u {
        by *= vec2(1.0, 0.5);
    }
    (by, product)
}

#[test]
fn products() {
    let u = Field::<f32, Aos>::new([5]);
    assert_eq!(scaled(&u, vec2(1.0, -1.0)), (vec2(32.0, -1.0), [27, 9]));
}

#[derive(Record, Clone, Copy, Debug, PartialEq, Default)]
struct Node {
    v: Vec3,
    m: Mat2,
    slots: [i16; 3],
    least: Vec2,
}

#[kernel]
fn scatter(at: &Field<u32, _>, nodes: &mut Field<Node, _>) {
    for p in at {
        let q = at[p];
        nodes.v[q].y += 1.0;
        nodes.v[q].z -= 0.5;
        nodes.m[q].y_axis.x += p as f32;
        nodes.slots[q][p as usize % 3] += 1;
        nodes.least[q].x.min_assign(-(p as f32));
    }
}

#[test]
fn components_at_any_index() {
    fn run<L: Layout<I>>() {
        let mut at = Field::<u32, Aos>::new([300]);
        (0..300).for_each(|p| at.set(p, (p * 7 % 4) as u32));
        for scatter_by in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
            let mut nodes = Field::<Node, L>::new([4]);
            nodes.fill(Node { v: vec3(-0.0, 0.0, 0.0), least: vec2(0.0, f32::NAN), m: Mat2::ZERO, ..Node::default() });
            let schedule = Schedule { threads: 3, scatter: scatter_by, grain: 16, ..Schedule::default() };
            schedule.run(|| scatter(&at, &mut nodes));
            for q in 0..4 {
                let node = nodes.get(q);
                let own = || (0..300).filter(|p| p * 7 % 4 == q);
                assert_eq!(node.v, vec3(0.0, 75.0, -37.5));
                assert!(node.v.x.is_sign_negative(), "the other components keep their bits");
                assert_eq!(node.m, Mat2::from_cols(Vec2::ZERO, vec2(own().sum::<i32>() as f32, 0.0)));
                assert_eq!(node.slots, [0, 1, 2].map(|slot| own().filter(|p| p % 3 == slot).count() as i16));
                assert_eq!(node.least.x, -(own().max().expect("some") as f32));
                assert!(node.least.y.is_nan(), "{scatter_by:?}");
            }
        }
    }
    run::<Aos>();
    run::<Soa>();
    run::<Split>();
    run::<AoSoA<2>>();
}
