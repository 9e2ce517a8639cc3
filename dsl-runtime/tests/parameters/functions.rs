//! `#[func]`: functions that read members which a kernel hands to them.

use allotrope::prelude::*;

use super::Node;

/// The value at a point, from the four elements around it, in any precision.
#[func]
fn bilinear<T: Real>(q: Read<T, _, Ij>, x: Vec2) -> T {
    let base = x.floor();
    let (i, j, t) = (base.x as i32, base.y as i32, x - base);
    let (s, t) = (T::from(t.x), T::from(t.y));
    let low = q[(i, j)] * (T::ONE - t) + q.clamped((i, j + 1)) * t;
    let high = q.or((i + 1, j), T::ZERO) * (T::ONE - t) + q.wrapped(ivec2(i + 1, j + 1)) * t;
    low * (T::ONE - s) + high * s
}

/// A function that hands its member on, and one that asks for the extents.
#[func]
pub(crate) fn slope(q: Read<f32, _, Ij>, at: IVec2) -> Vec2 {
    assert!(q.len() == q.shape()[0] * q.shape()[1], "{} of {:?}", q[at], at);
    let difference = |a: IVec2, b: IVec2| middle(q, a) - middle(q, b);
    vec2(difference(at + IVec2::X, at - IVec2::X), difference(at + IVec2::Y, at - IVec2::Y))
}

#[func]
#[inline]
fn middle(q: Read<f32, _, Ij>, at: IVec2) -> f32 {
    0.5 * q.clamped(at) + 0.5 * q.clamped(at + IVec2::ONE)
}

/// Whole records, one member of them by a component, and a list.
#[func]
fn energy(nodes: Read<Node, _, Ij>, weights: Read<f32, _>, at: IVec2) -> f32 {
    nodes[at].m * nodes[(at.x, at.y)].v.x * weights[at.y]
}

struct Mpm {
    scale: f32,
}

impl Mpm {
    #[func]
    fn gather<L: Layout<Ij>>(&self, v: Read<Vec2, L, Ij>, m: Read<f32, L, Ij>, at: (i32, i32)) -> Vec2 {
        let mut sum = Vec2::ZERO;
        for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let near = (at.0 + a, at.1 + b);
            sum += v.wrapped(near) * m.wrapped(near);
        }
        self.scale * sum
    }

    #[kernel]
    fn advance(&self, points: &mut Field<Node, _>, grid: &Field<Node, _, Ij>) {
        for p in points {
            let at = points.v[p];
            points.v[p] = self.gather(grid.v, grid.m, (at.x as i32, at.y as i32));
            points.m[p] += bilinear(grid.m, at);
        }
    }
}

/// Members of the field that the loop writes, where it writes others; a reduction; the top level.
#[kernel]
fn kinds(grid: &mut Field<Node, _, Ij>, u: &Member<f32, _, Ij>, weights: &[f32]) -> f32 {
    let mut total = 0.0;
    for ij in grid {
        grid.v[ij] = slope(grid.m, ij) + slope(u, ij);
    }
    for ij in u {
        total += energy(grid, list(weights), ij);
    }
    for i in weights.interior(1) {
        total += single(weights, i);
    }
    #[serial]
    for ij in grid {
        grid.v[ij].x += bilinear(grid.m, ij.as_vec2());
    }
    total + bilinear(grid.m, vec2(1.5, 2.5)) + bilinear(u, Vec2::ONE)
}

/// An ordinary generic function takes what is handed to it as well.
fn list<T>(list: T) -> T {
    list
}

#[func]
fn single(q: Read<f32, _>, i: i32) -> f32 {
    q[i - 1] * q[i + 1]
}

fn start<L: Layout<Ij>>() -> Field<Node, L, Ij> {
    let mut field = Field::<Node, L>::new([6, 9]);
    for i in 0..6 {
        for j in 0..9 {
            field.set([i, j], Node { v: vec2(i as f32, j as f32), m: (i * i + 3 * j) as f32 });
        }
    }
    field
}

/// What `bilinear` computes, by another way.
fn expected(value: impl Fn(i32, i32) -> f32, x: Vec2) -> f32 {
    let (i, j, s, t) = (x.x as i32, x.y as i32, x.x.fract(), x.y.fract());
    let outside = if i + 1 < 6 { value(i + 1, j) } else { 0.0 };
    value(i, j) * (1.0 - s) * (1.0 - t)
        + value(i, (j + 1).min(8)) * (1.0 - s) * t
        + outside * s * (1.0 - t)
        + value((i + 1) % 6, (j + 1) % 9) * s * t
}

#[test]
fn methods_and_functions_read_what_they_are_handed() {
    fn run<L: Layout<Ij>, P: Layout<I>>() {
        let grid = start::<L>();
        let mut points = Field::<Node, P>::new([40]);
        for p in 0..40 {
            points.set(p, Node { v: vec2(p as f32 * 0.147, p as f32 * 0.22), m: 1.0 });
        }
        let before = points.clone();
        for threads in 1..=3 {
            points.copy_from(&before);
            let schedule = Schedule { threads, grain: 4, ..Schedule::default() };
            schedule.run(|| Mpm { scale: 0.5 }.advance(&mut points, &grid));
            for p in 0..40 {
                let x = before.get(p).v;
                let m = expected(|i, j| grid.get([i, j]).m, x);
                assert!((points.get(p).m - 1.0 - m).abs() < 1e-4, "{p}");
                let (i, j) = (x.x as i32, x.y as i32);
                let near = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)];
                let sum: Vec2 = near.map(|(i, j)| grid.get([i % 6, j % 9])).map(|node| node.v * node.m).iter().sum();
                assert!(points.get(p).v.abs_diff_eq(0.5 * sum, 1e-4));
            }
        }
    }
    run::<Aos, Soa>();
    run::<Soa, AoSoA<8>>();
    run::<layout!(dense(ji).dense(ij, (2, 4)).split), Aos>();
}

#[test]
fn fields_members_records_and_slices_are_handed_on() {
    fn run<L: Layout<Ij>, M: Layout<Ij>>() -> (f32, Vec<Node>) {
        let mut grid = start::<L>();
        let other = start::<M>();
        let weights: Vec<f32> = (0..9).map(|n| n as f32).collect();
        let total = kinds(&mut grid, &other.members().m, &weights);
        (total, grid.iter().collect())
    }
    let (total, nodes) = run::<Aos, Aos>();
    let field = start::<Aos>();
    // Central differences of i^2 + 3 j, from the mean of an element and the one behind it.
    assert_eq!(nodes[2 * 9 + 4].v, 2.0 * vec2(10.0, 6.0) + vec2(field.get([2, 4]).m, 0.0));
    assert!(total != 0.0);
    assert_eq!(run::<Soa, Blocked<4>>(), (total, nodes.clone()));
    assert_eq!(run::<Split, Morton<2>>(), (total, nodes.clone()));
    assert_eq!(run::<AoSoA<4>, layout!(dense(ji).aos)>(), (total, nodes));
}

#[test]
fn functions_are_called_from_anywhere() {
    let field = start::<Blocked<2>>();
    assert_eq!(bilinear(&field.members().m, vec2(1.5, 2.0)), 8.5);
    assert_eq!(bilinear::<f64>(&Field::<f64, Soa>::new([3, 3]).with_background(2.0), vec2(0.5, 0.5)), 2.0);
    assert_eq!(single(&[2.0, 3.0, 4.0][..], 1), 8.0);
}

#[test]
#[should_panic(expected = "kernel `look`: index [9] is out of range of field `u`, whose shape is [9]")]
fn an_index_outside_names_the_kernel() {
    #[kernel]
    fn look(u: &Field<f32, _>, out: &mut Field<f32, _>) {
        for i in out {
            out[i] = single(u, i + 1);
        }
    }
    look(&Field::<f32, Aos>::new([9]), &mut Field::<f32, Aos>::new([8]));
}
