//! Heads, bodies and places of parallel loops.

use allotrope::prelude::*;

use crate::Node;

#[kernel]
fn saxpy(y: &mut Field<f32, _>, x: &Field<f32, _>, a: f32) {
    for p in y {
        y[p] += a * x[p];
    }
}

fn line<L: Layout<I>>(n: usize, value: impl Fn(usize) -> f32) -> Field<f32, L> {
    let mut field = Field::<f32, L>::new([n]);
    for i in 0..n {
        field.set(i, value(i));
    }
    field
}

#[test]
fn saxpy_in_any_layout() {
    fn run<L: Layout<I>, M: Layout<I>>() {
        let (mut y, x) = (line::<L>(1000, |i| i as f32), line::<M>(1000, |i| 2.0 * i as f32));
        saxpy(&mut y, &x, 0.5);
        assert!((0..1000).all(|i| y.get(i) == 2.0 * i as f32));
    }
    run::<Aos, Aos>();
    run::<Soa, AoSoA<16>>();
    run::<layout!(dense(i).dense(i, 12).soa), Split>();
}

#[kernel]
fn fill_range(u: &mut Field<i32, _>, first: usize, end: usize) {
    for i in first..end {
        u[i] = i as i32;
    }
}

#[test]
fn ranges_visit_what_they_name() {
    let mut u = Field::<i32, Soa>::new([10]);
    fill_range(&mut u, 3, 7);
    assert_eq!(u.iter().collect::<Vec<_>>(), [0, 0, 0, 3, 4, 5, 6, 0, 0, 0]);
}

#[kernel]
fn outer_product(u: &mut Field<i32, _, Ij>, n: i64, m: u8) {
    for (i, j) in ndrange!(1..n, 0..m) {
        u[(i, j)] = i as i32 * 10 + j as i32;
    }
}

#[test]
fn ndrange_visits_a_box() {
    let mut u = Field::<i32, Blocked<4>>::new([5, 6]);
    outer_product(&mut u, 5, 6);
    for (i, j) in (0..5).flat_map(|i| (0..6).map(move |j| (i, j))) {
        assert_eq!(u.get((i, j)), if i == 0 { 0 } else { i * 10 + j });
    }
}

#[kernel]
fn transpose(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>) {
    for (i, j) in u {
        v[(j, i)] = u[(i, j)];
        v[(j, i)] += 1;
    }
}

#[test]
fn own_index_in_other_places() {
    let (mut u, mut v) = (Field::<i32, Aos>::new([3, 5]), Field::<i32, Blocked<2>>::new([5, 3]));
    outer_product(&mut u, 3, 5);
    transpose(&u, &mut v);
    for (i, j) in (0..3).flat_map(|i| (0..5).map(move |j| (i, j))) {
        assert_eq!(v.get((j, i)), if i == 0 { 1 } else { i * 10 + j + 1 });
    }
}

#[kernel]
fn prefix_rows(u: &mut Field<i32, _, Ij>, rows: i32, columns: i32) {
    for i in 0..rows {
        for j in 1..columns {
            u[(i, j)] = u[(i, j)] + u[(i, j - 1)];
        }
    }
}

#[test]
fn an_iteration_owns_its_row() {
    let mut u = Field::<i32, Aos>::new([4, 5]);
    u.fill(1);
    prefix_rows(&mut u, 4, 5);
    assert!((0..4).all(|i| (0..5).all(|j| u.get((i, j)) == j + 1)));
}

#[kernel]
fn steps(u: &mut Field<i32, _>, mut count: i32, twice: bool) -> i32 {
    let mut done = 0;
    while count > 0 {
        for p in u {
            u[p] += 1;
        }
        if twice {
            for p in u {
                if p % 2 == 0 {
                    continue;
                }
                u[p] += 1;
            }
        }
        count -= 1;
        done += 1;
    }
    match (twice, count) {
        (true, 0) => {
            for p in 0..1 {
                u[p] = -1;
            }
        }
        (true, _) => u[0] = -2,
        (false, _) => {}
    }
    u[1] * 100 + done
}

#[test]
fn launches_inside_other_statements() {
    let mut u = Field::<i32, Aos>::new([4]);
    assert_eq!(steps(&mut u, 3, true), 603);
    assert_eq!(u.iter().collect::<Vec<_>>(), [-1, 6, 3, 6]);
}

#[kernel]
fn fibonacci(u: &mut Field<i64, _>) {
    u[0] = 1;
    u[1] = 1;
    #[serial]
    for p in u {
        if p >= 2 {
            u[p] = u[p - 1] + u[p - 2];
        }
    }
    #[serial]
    for p in (0..10).rev().step_by(3) {
        u[p] *= -1;
    }
}

#[test]
fn serial_loops_take_any_access_and_iterator() {
    let mut u = Field::<i64, AoSoA<4>>::new([10]);
    fibonacci(&mut u);
    assert_eq!(u.iter().collect::<Vec<_>>(), [-1, 1, 2, -3, 5, 8, -13, 21, 34, -55]);
}

#[kernel]
fn serial_heads(u: &mut Field<i32, _, Ij>) -> i32 {
    let mut order = 0;
    #[serial]
    for (i, j) in u.interior(1) {
        u[(i, j)] = order;
        order += 1;
    }
    #[serial]
    for ij in u {
        u[ij] += 1;
    }
    #[serial]
    for (i, j) in ndrange!(0..2, 0..3) {
        u[(i, j)] += 100;
    }
    order
}

#[test]
fn serial_loops_over_fields() {
    let mut u = Field::<i32, Aos>::new([4, 4]);
    assert_eq!(serial_heads(&mut u), 4);
    let rows: Vec<_> = u.iter().collect();
    assert_eq!(rows, [101, 101, 101, 1, 101, 101, 102, 1, 1, 3, 4, 1, 1, 1, 1, 1]);
}

#[kernel]
fn pairs(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for p in v {
        let mut near = 0.0;
        for q in u {
            near += (u[p] - u[q]).abs();
        }
        v[p] = near;
    }
}

#[test]
fn inner_loops_over_fields() {
    let (u, mut v) = (line::<Soa>(5, |i| i as f32), Field::<f32, Aos>::new([5]));
    pairs(&u, &mut v);
    assert_eq!(v.iter().collect::<Vec<_>>(), [10.0, 7.0, 6.0, 7.0, 10.0]);
}

#[kernel]
fn whole_records(a: &mut Field<Node, _>, b: &Field<Node, _>) {
    for p in a {
        let node = b[p];
        a[p] = Node { m: node.m * 2.0, ..node };
        a.v[p].y = 7.0;
        a[p].m += 0.5;
        a.v[p].x -= 1.0;
    }
}

#[test]
fn records_members_and_components() {
    let (mut a, mut b) = (Field::<Node, Soa>::new([3]), Field::<Node, Aos>::new([3]));
    b.fill(Node { v: vec2(3.0, 4.0), m: 5.0 });
    whole_records(&mut a, &b);
    assert!(a.iter().all(|node| node == Node { v: vec2(2.0, 7.0), m: 10.5 }));
    host_components(&mut a);
    assert_eq!(a.get(1), Node { v: vec2(2.0, 12.0), m: 3.0 });
}

#[kernel]
fn host_components(a: &mut Field<Node, _>) {
    a.v[1].y += 5.0;
    a.m[1].min_assign(3.0);
    a.v[1] = a.v[1] + a.v[0] * 0.0;
}

struct Scaled {
    by: f32,
}

impl Scaled {
    #[kernel]
    fn scale(&self, u: &mut Field<f32, _>) -> f32 {
        for p in u {
            u[p] *= self.by;
        }
        u[0]
    }
}

#[test]
fn kernels_may_be_methods() {
    let mut u = line::<Aos>(3, |i| i as f32 + 1.0);
    assert_eq!(Scaled { by: 3.0 }.scale(&mut u), 3.0);
    assert_eq!(u.get(2), 9.0);
}

#[kernel]
fn advance<T, X: Axes, L: Layout<X>>(u: &mut Field<T, L, X>, v: &Field<T, L, X>, by: T)
where
    T: allotrope::Element + std::ops::AddAssign + std::ops::Mul<Output = T>,
{
    for p in u {
        u[p] += v[p] * by;
    }
}

#[test]
fn kernels_may_be_generic() {
    let (mut u, mut v) = (Field::<f64, Blocked<4>>::new([5, 7]), Field::<f64, Blocked<4>>::new([5, 7]));
    v.fill(3.0);
    advance(&mut u, &v, 0.5);
    assert!(u.iter().all(|x| x == 1.5));
    let (mut u, mut v) = (Field::<i32, Soa>::new([9]), Field::<i32, Soa>::new([9]));
    v.fill(3);
    advance::<i32, I, Soa>(&mut u, &v, 2);
    assert!(u.iter().all(|x| x == 6));
}

#[kernel]
fn outer(u: &mut Field<i32, _>, v: &mut Field<i32, _>) {
    add_one(u);
    for p in v {
        let mut own = Field::<i32, Aos>::new([2]);
        add_one(&mut own);
        v[p] = own.get(1);
    }
}

#[kernel]
fn add_one(u: &mut Field<i32, _>) {
    for p in u {
        u[p] += 1;
    }
}

#[test]
fn kernels_call_kernels() {
    let (mut u, mut v) = (Field::<i32, Aos>::new([5]), Field::<i32, Aos>::new([40_000]));
    outer(&mut u, &mut v);
    assert!(u.iter().chain(v.iter()).all(|x| x == 1));
}

#[kernel]
fn plain_rust(u: &mut Field<i32, _>, names: &[&str], offset: Option<i32>) {
    let table = vec![1, 2, 3];
    for p in u {
        assert!(u[p] == 0, "{p} {}", names.len());
        let offset = match offset {
            Some(offset) if matches!(table[0], 1 | 7) => offset,
            _ => 0,
        };
        let add = |x: i32| x + offset;
        let mut k = 0;
        let found = 'search: loop {
            if k == 3 {
                break -1;
            }
            while k < 3 {
                if table[k] == 2 {
                    break 'search k as i32;
                }
                k += 1;
            }
        };
        debug_assert_eq!(names[0].len(), 5, "{table:?}");
        u[p] = add(found) + u.len() as i32;
    }
}

#[test]
fn bodies_are_plain_rust() {
    let mut u = Field::<i32, Soa>::new([6]);
    plain_rust(&mut u, &["first"], Some(10));
    assert!(u.iter().all(|x| x == 17));
}

#[kernel]
fn configured(u: &mut Field<i32, _>) {
    for p in u {
        #[cfg(any())]
        u[p] = "never compiled";
        #[cfg(not(any()))]
        u[p] += 1;
    }
    #[allow(clippy::identity_op)]
    for p in u {
        u[p] += 0;
    }
}

#[test]
fn attributes_hold() {
    let mut u = Field::<i32, Aos>::new([3]);
    configured(&mut u);
    assert!(u.iter().all(|x| x == 1));
}

#[kernel]
fn heads_read_fields(u: &mut Field<i32, _>, width: &Field<u32, _>) {
    u[0] = 3;
    for p in 1..u[0] {
        u[p] = 7;
    }
    for p in u.interior(width[0]) {
        u[p] += 1;
    }
    for p in 0..u.len() {
        u[p] *= 2;
    }
}

#[test]
fn heads_are_evaluated_before_the_loop_takes_its_fields() {
    let (mut u, mut width) = (Field::<i32, Soa>::new([6]), Field::<u32, Aos>::new([1]));
    width.set(0, 2);
    heads_read_fields(&mut u, &width);
    assert_eq!(u.iter().collect::<Vec<_>>(), [6, 14, 16, 2, 0, 0]);
}

/// Steps that build on each other, each a launch over all elements; stops where the sum is large enough.
#[kernel]
fn growth(u: &mut Field<u64, _>, v: &mut Field<u64, _>, n: u32, most: u64) -> u32 {
    let mut taken = 0;
    #[ordered]
    for step in 0..n {
        let mut sum = 0;
        for p in v {
            v[p] = u[p] + u.wrapped(p + 1) + u64::from(step);
        }
        for p in u {
            u[p] = v[p];
            sum += v[p];
        }
        taken += 1;
        if sum > most {
            break;
        }
        v[0] = 0;
    }
    taken
}

#[test]
fn ordered_loops_launch_turn_after_turn() {
    for (n, most) in [(0, u64::MAX), (5, u64::MAX), (20, 100_000)] {
        let (mut plain, mut taken) = (vec![1u64; 700], 0);
        for step in 0..u64::from(n) {
            plain = (0..700).map(|p| plain[p] + plain[(p + 1) % 700] + step).collect();
            taken += 1;
            if plain.iter().sum::<u64>() > most {
                break;
            }
        }
        for threads in [1, 3] {
            let (mut u, mut v) = (Field::<u64, Aos>::new([700]), Field::<u64, AoSoA<16>>::new([700]));
            u.fill(1);
            let schedule = Schedule { threads, grain: 16, ..Schedule::default() };
            assert_eq!(schedule.run(|| growth(&mut u, &mut v, n, most)), taken);
            assert_eq!(u.iter().collect::<Vec<_>>(), plain);
        }
    }
}
