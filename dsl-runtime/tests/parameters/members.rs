//! Single members as parameters: of any record, in any layout, and bare fields and slices in their place.

use allotrope::AnyMember;
use allotrope::prelude::*;

/// What a conjugate gradient method holds of a cell.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Search {
    x: f32,
    solid: bool,
    p: f32,
    force: Vec2,
    r: f32,
}

#[kernel]
fn dot(a: &Member<f32, _, Ij>, b: &Member<f32, _, Ij>) -> f32 {
    let mut sum = 0.0;
    for ij in a {
        sum += a[ij] * b[ij];
    }
    sum
}

#[kernel]
fn axpy(y: &mut Member<f32, _, Ij>, a: f32, x: &Member<f32, _, Ij>) {
    for ij in y {
        y[ij] += a * x[ij];
    }
}

/// Neighbours by constant offsets and by a boundary rule, from one member to another.
#[kernel]
fn smooth(from: &Member<f32, _, Ij>, to: &mut Member<f32, _, Ij>) {
    for (i, j) in to.interior(1) {
        to[(i, j)] = 0.25 * (from[(i - 1, j)] + from[(i + 1, j)] + from[(i, j - 1)] + from[(i, j + 1)]);
    }
    for (i, j) in to.border(1) {
        let around = from.clamped((i - 1, j)) + from.clamped((i + 1, j)) + from.or((i, j - 1), 0.0);
        to[(i, j)] = around + from.wrapped((i, j + 1));
    }
}

/// Two members of one record, both to change.
#[kernel]
fn exchange(a: &mut Member<f32, _, Ij>, b: &mut Member<f32, _, Ij>) {
    for ij in a {
        let (old, new) = (a[ij], b[ij]);
        a[ij] = new;
        b[ij] = old;
    }
}

/// Sums and maxima into the first column, from all of the row.
#[kernel]
fn gather(sums: &mut Member<f32, _, Ij>, highest: &mut Member<f32, _, Ij>, from: &Member<f32, _, Ij>) {
    for (i, j) in from {
        sums[(i, j.min(0))] += from[(i, j)];
        highest[(i, j.min(0))].max_assign(from[(i, j)]);
    }
}

/// Components of a member, and the top level.
#[kernel]
fn turn(force: &mut Member<Vec2, _, Ij>) -> f32 {
    for ij in force {
        force[ij].x = -force[ij].y;
    }
    force[(0, 0)].y = 7.0;
    #[serial]
    for (i, j) in force {
        force[(i, j)] += vec2(0.0, 1.0);
    }
    let [height, width] = force.shape();
    assert_eq!(force.len(), height * width);
    force.get([0, 0]).y
}

/// A kernel that calls kernels, with a layout in common.
#[kernel]
fn twice<L: Layout<Ij>>(y: &mut Member<f32, L, Ij>, x: &Member<f32, L, Ij>) {
    axpy(y, 1.0, x);
    axpy(y, 1.0, x);
}

#[kernel]
fn pinned(y: &mut Member<f32, Soa, Ij>) {
    for (i, j) in y {
        y[(i, j)] = (i * 100 + j) as f32;
    }
}

const SHAPE: [usize; 2] = [13, 21];

fn start(i: i32, j: i32) -> Search {
    let n = (i * 31 + j * 7) % 17;
    Search {
        x: n as f32 - 5.0,
        solid: n % 3 == 0,
        p: (i - j) as f32,
        force: vec2(i as f32, j as f32),
        r: (n * n) as f32,
    }
}

fn filled<L: Layout<Ij>>() -> Field<Search, L, Ij> {
    let mut field = Field::<Search, L>::new(SHAPE);
    for i in 0..13 {
        for j in 0..21 {
            field.set([i, j], start(i, j));
        }
    }
    field
}

fn bare<L: Layout<Ij>>(value: impl Fn(Search) -> f32) -> Field<f32, L, Ij> {
    let mut field = Field::<f32, L>::new(SHAPE);
    for i in 0..13 {
        for j in 0..21 {
            field.set([i, j], value(start(i, j)));
        }
    }
    field
}

/// Runs everything on members of a record, and on bare fields of their values: both must agree, and what a kernel was not
/// given must be as it was.
fn agree<L: Layout<Ij>, M: Layout<Ij>>() {
    let mut grid = filled::<L>();
    let (mut x, mut p, mut r) = (bare::<M>(|s| s.x), bare::<M>(|s| s.p), bare::<M>(|s| s.r));
    assert_eq!(dot(&grid.members().x, &grid.members().p), dot(&x, &p));
    assert_eq!(dot(&grid.members().r, &r), dot(&r, &grid.members().r));

    let mut members = grid.members_mut();
    axpy(&mut members.x, 0.5, &members.p);
    axpy(&mut x, 0.5, &p);
    smooth(&members.x, &mut members.r);
    smooth(&x, &mut r);
    exchange(&mut members.p, &mut members.x);
    exchange(&mut p, &mut x);
    twice(&mut members.x, &members.r);
    twice(&mut x, &r);
    for scatter in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
        let schedule = Schedule { threads: 2, scatter, grain: 8, ..Schedule::default() };
        schedule.run(|| gather(&mut members.x, &mut members.p, &members.r));
        schedule.run(|| gather(&mut x, &mut p, &r));
    }
    assert_eq!(AnyMember::to_vec(&members.x), AnyMember::to_vec(&x));
    assert_eq!(turn(&mut members.force), 8.0);

    for (member, bare) in
        [(grid.members().x.to_vec(), &x), (grid.members().p.to_vec(), &p), (grid.members().r.to_vec(), &r)]
    {
        assert_eq!(member, bare.to_vec());
    }
    for i in 0..13 {
        for j in 0..21 {
            let (now, was) = (grid.get([i, j]), start(i, j));
            assert_eq!(now.solid, was.solid);
            let y = if (i, j) == (0, 0) { 7.0 } else { was.force.y };
            assert_eq!(now.force, vec2(-was.force.y, y + 1.0));
        }
    }
}

#[test]
fn members_of_any_record_and_bare_fields_agree() {
    agree::<Aos, Aos>();
    agree::<layout!(dense(ji).split), Soa>();
    agree::<layout!(Search: dense(ij).place([x, solid], [p, r], [split(force)])), Aos>();
}

#[test]
fn a_named_layout_pins_that_of_the_member() {
    let mut grid = filled::<Soa>();
    pinned(&mut grid.members_mut().p);
    assert_eq!(grid.get([3, 4]).p, 304.0);
    assert_eq!(grid.get([3, 4]).x, start(3, 4).x);
}

/// Disjoint members in kernels that run at the same time.
#[test]
fn members_of_one_record_are_apart_in_two_threads() {
    fn run<L: Layout<Ij>>() {
        let mut grid = filled::<L>();
        let (p, force) = (bare::<Aos>(|s| s.p), Field::<Vec2, Aos>::new(SHAPE).with_background(vec2(1.0, 2.0)));
        let members = grid.members_mut();
        let (mut x, mut r) = (members.x, members.r);
        std::thread::scope(|scope| {
            let first = scope.spawn(|| (0..50).for_each(|_| axpy(&mut x, 1.0, &p)));
            let second = scope.spawn(|| (0..50).for_each(|_| axpy(&mut r, 2.0, &p)));
            // The thread sanitizer sees a join, and not the end of a scope.
            first.join().expect("no panic");
            second.join().expect("no panic");
        });
        drop(force);
        for i in 0..13 {
            for j in 0..21 {
                let (now, was) = (grid.get([i, j]), start(i, j));
                assert_eq!((now.x, now.r), (was.x + 50.0 * was.p, was.r + 100.0 * was.p));
                assert_eq!((now.p, now.solid, now.force), (was.p, was.solid, was.force));
            }
        }
    }
    run::<Aos>();
    run::<AoSoA<4>>();
    run::<Soa>();
}

#[kernel]
fn fill_list(list: &mut Member<i64, _>, by: i64) {
    for n in list {
        list[n] += by + i64::from(n);
    }
}

#[test]
fn a_slice_and_a_field_stand_for_a_member_over_one_axis() {
    let mut values = [1i64; 100];
    let mut field = Field::<i64, AoSoA<8>>::new([100]).with_background(1);
    fill_list(&mut values[..], 5);
    fill_list(&mut field, 5);
    fill_list(&mut field.members_mut().0, 5);
    fill_list(&mut values[..], 5);
    assert_eq!(values.to_vec(), field.to_vec());
    assert_eq!(values[9], 1 + 2 * (5 + 9));
}

#[test]
#[should_panic(expected = "kernel `smooth`: index [13, 1] is out of range of field `from`")]
fn an_index_outside_names_the_parameter() {
    let (from, mut to) = (Field::<f32, Aos>::new([13, 21]), filled::<Soa>().relayout::<Aos>());
    let mut large = Field::<Search, Aos>::new([15, 21]);
    smooth(&from, &mut to.members_mut().r);
    smooth(&from, &mut large.members_mut().r);
}
