//! Iterations that meet in one element: old values (`fetch_add` and its like), and `#[relaxed]` loops.

use super::*;

/// Members of several sizes; in interleaved records `big` lies at no multiple of its size.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Mixed {
    small: u8,
    flag: bool,
    count: u16,
    signed: i32,
    big: u64,
    v: IVec3,
}

fn threads(n: usize) -> Schedule {
    Schedule { threads: n, grain: 64, ..Schedule::default() }
}

/// Runs a test of fields with one axis in several layouts.
macro_rules! in_layouts {
    ($run:ident) => {
        $run::<Aos>();
        $run::<Soa>();
        $run::<Split>();
        $run::<layout!(dense(i).dense(i, 8).soa)>();
    };
}

#[kernel]
fn take_places(keys: &Field<u32, _>, next: &mut Field<u32, _>, places: &mut Field<u32, _>) {
    for p in keys {
        places[p] = next[keys[p]].fetch_add(1);
    }
}

#[test]
fn old_values_are_distinct() {
    fn run<L: Layout<I>>() {
        const KEYS: u32 = 7;
        let keys = (0..4000u32).map(|n| n * n % KEYS).collect::<Vec<_>>();
        for n in [1, 2, 3] {
            let (mut field, mut next) = (Field::<u32, L>::new([keys.len()]), Field::<u32, L>::new([KEYS as usize]));
            let mut places = Field::<u32, L>::new([keys.len()]);
            field.copy_from_slice(&keys);
            threads(n).run(|| take_places(&field, &mut next, &mut places));
            for key in 0..KEYS {
                let mut taken: Vec<u32> =
                    keys.iter().zip(places.iter()).filter(|(k, _)| **k == key).map(|(_, place)| place).collect();
                taken.sort_unstable();
                assert!(taken.iter().copied().eq(0..taken.len() as u32), "key {key}");
                assert_eq!(next.get(key), taken.len() as u32);
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn every_operation(u: &mut Field<Mixed, _>, old: &mut Field<[i64; 9], _>, at: &Field<i32, _>) {
    for p in at {
        let q = at[p];
        old[p] = [
            u.signed[q].fetch_add(5) as i64,
            u.signed[q].fetch_sub(7) as i64,
            u.signed[q].fetch_max(40) as i64,
            u.signed[q].fetch_min(30) as i64,
            u.small[q].fetch_or(0b1100) as i64,
            u.small[q].fetch_and(0b0110) as i64,
            u.small[q].fetch_xor(0b1111) as i64,
            u.count[q].swap(9) as i64,
            u.big[q].compare_exchange(3, 4).unwrap_or_else(|other| other + 100) as i64,
        ];
        let _ = u.flag[q].swap(true);
    }
}

#[kernel]
fn every_operation_serially(u: &mut Field<Mixed, _>, old: &mut Field<[i64; 9], _>, at: &Field<i32, _>) {
    #[serial]
    for p in at {
        let q = at[p];
        old[p] = [
            u.signed[q].fetch_add(5) as i64,
            u.signed[q].fetch_sub(7) as i64,
            u.signed[q].fetch_max(40) as i64,
            u.signed[q].fetch_min(30) as i64,
            u.small[q].fetch_or(0b1100) as i64,
            u.small[q].fetch_and(0b0110) as i64,
            u.small[q].fetch_xor(0b1111) as i64,
            u.count[q].swap(9) as i64,
            u.big[q].compare_exchange(3, 4).unwrap_or_else(|other| other + 100) as i64,
        ];
        let _ = u.flag[q].swap(true);
    }
}

#[test]
fn each_operation_returns_what_was_there() {
    fn run<L: Layout<I>>() {
        let start = |p: i32| Mixed {
            small: p as u8,
            flag: false,
            count: p as u16,
            signed: p * 3 - 50,
            big: (p % 4) as u64,
            v: IVec3::splat(p),
        };
        let expected_old = |u: Mixed| {
            let s = i64::from(u.signed);
            let small = i64::from(u.small);
            let big = if u.big == 3 { 3 } else { u.big as i64 + 100 };
            let (or, and) = (small | 0b1100, (small | 0b1100) & 0b0110);
            [s, s + 5, s - 2, (s - 2).max(40), small, or, and, i64::from(u.count), big]
        };
        let expected_new = |u: Mixed| Mixed {
            small: ((u.small | 0b1100) & 0b0110) ^ 0b1111,
            flag: true,
            count: 9,
            signed: 30,
            big: if u.big == 3 { 4 } else { u.big },
            v: u.v,
        };
        for (serially, n) in [(true, 1), (false, 1), (false, 2)] {
            let mut u = Field::<Mixed, L>::new([300]);
            let mut at = Field::<i32, Soa>::new([300]);
            (0..300).for_each(|p| u.set(p, start(p)));
            (0..300).for_each(|p| at.set(p, (p * 7) % 300));
            let mut old = Field::<[i64; 9], L>::new([300]);
            let kernel = if serially { every_operation_serially } else { every_operation };
            threads(n).run(|| kernel(&mut u, &mut old, &at));
            for p in 0..300 {
                let q = (p * 7) % 300;
                assert_eq!(old.get(p), expected_old(start(q)));
                assert_eq!(u.get(q), expected_new(start(q)));
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn first_comes(owner: &mut Field<u32, _>, at: &Field<u32, _>, won: &mut Field<bool, _>) {
    for p in at {
        won[p] = owner[at[p]].compare_exchange(0, p as u32 + 1).is_ok();
    }
}

#[test]
fn one_iteration_wins() {
    let (mut owner, mut at) = (Field::<u32, Soa>::new([40]), Field::<u32, Soa>::new([4000]));
    let mut won = Field::<bool, Soa>::new([4000]);
    (0..4000).for_each(|p| at.set(p, (p as u32 * 13) % 37));
    threads(2).run(|| first_comes(&mut owner, &at, &mut won));
    assert_eq!(won.iter().filter(|won| *won).count(), 37);
    for q in 0..40 {
        match owner.get(q) {
            0 => assert!(q >= 37),
            winner => assert!(won.get(winner - 1) && at.get(winner - 1) == q),
        }
    }
}

/// The component of each cell that has the smallest label: labels sink in any order, and end the same.
#[kernel]
fn sink_labels(labels: &mut Field<u32, _, Ij>, open: &Field<bool, _, Ij>) -> bool {
    let mut changed = false;
    #[relaxed]
    for (i, j) in labels {
        if open[(i, j)] {
            let mut least = labels[(i, j)];
            for (a, b) in unroll!(-1..2, -1..2) {
                if a * b == 0 && open.or((i + a, j + b), false) {
                    least = least.min(labels.clamped((i + a, j + b)));
                }
            }
            if least < labels[(i, j)] {
                labels[(i, j)] = least;
                changed |= true;
            }
        }
    }
    changed
}

#[test]
fn relaxed_loops_read_and_write_neighbours() {
    fn run<L: Layout<Ij>>() {
        let mut open = Field::<bool, Soa>::new([30, 20]);
        // Walls every third row, with one gap each, but for the middle one.
        for i in 0..30 {
            for j in 0..20 {
                open.set([i, j], i % 3 != 2 || (i != 14 && j == (i * 5) % 20));
            }
        }
        for n in [1, 2] {
            let mut labels = Field::<u32, L>::new([30, 20]);
            (0..30u32).for_each(|i| (0..20u32).for_each(|j| labels.set([i, j], i * 20 + j)));
            threads(n).run(|| while sink_labels(&mut labels, &open) {});
            for i in 0..30u32 {
                for j in 0..20u32 {
                    let expected = match (open.get([i, j]), i) {
                        (false, _) => i * 20 + j,
                        (true, 0..15) => 0,
                        _ => 15 * 20,
                    };
                    assert_eq!(labels.get([i, j]), expected, "({i}, {j})");
                }
            }
        }
    }
    run::<Aos>();
    run::<Blocked<4>>();
}

#[kernel]
fn parts_and_sums(u: &mut Field<Mixed, _>, at: &Field<u32, _>, whole: &mut Field<Mixed, _>) {
    #[relaxed]
    for p in at {
        let q = at[p];
        u.v[q].y = 5;
        u.v[q].x += 1;
        u.big[q] += 2;
        u.count[q].max_assign(p as u16);
        let seen = u[q];
        whole[seen.small as i32] = seen;
    }
}

#[test]
fn relaxed_updates_lose_nothing() {
    fn run<L: Layout<I>>() {
        for n in [1, 2] {
            let (mut u, mut whole) = (Field::<Mixed, L>::new([10]), Field::<Mixed, L>::new([10]));
            let mut at = Field::<u32, Soa>::new([5000]);
            (0..5000u32).for_each(|p| at.set(p, p * p % 10));
            (0..10).for_each(|q| u.set(q, Mixed { small: q as u8, v: IVec3::new(0, 1, 2), ..Mixed::default() }));
            threads(n).run(|| parts_and_sums(&mut u, &at, &mut whole));
            for q in 0..10u32 {
                let met: Vec<u32> = (0..5000u32).filter(|p| p * p % 10 == q).collect();
                let (record, seen) = (u.get(q), whole.get(q));
                let Some(last) = met.last() else {
                    assert_eq!((record.big, seen), (0, Mixed::default()));
                    continue;
                };
                assert_eq!(record.v, IVec3::new(met.len() as i32, 5, 2));
                assert_eq!((record.big, record.count), (2 * met.len() as u64, *last as u16));
                assert_eq!((seen.small, seen.v.y, seen.v.z), (q as u8, 5, 2));
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn scatter_any(to: &mut Field<f64, _>, sum: &mut Field<f32, _>, at: &Field<u32, _>) {
    #[relaxed]
    for p in at {
        to[at[p]] = p as f64;
        sum[at[p]] += 1.0;
    }
}

#[test]
fn one_of_the_values_stays() {
    let (mut to, mut sum) = (Field::<f64, Soa>::new([6]), Field::<f32, Soa>::new([6]));
    let mut at = Field::<u32, Soa>::new([3000]);
    (0..3000u32).for_each(|p| at.set(p, p % 5));
    threads(2).run(|| scatter_any(&mut to, &mut sum, &at));
    (0..5).for_each(|q| assert_eq!(to.get(q) as i32 % 5, q));
    assert_eq!((to.get(5), sum.get(5), sum.get(0)), (0.0, 0.0, 600.0));
}

/// What a panic says.
fn message(run: impl FnOnce()) -> String {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).expect_err("it panics");
    panic.downcast_ref::<String>().cloned().unwrap_or_default()
}

#[test]
fn no_fixed_order_is_no_deterministic_result() {
    let (mut to, mut sum) = (Field::<f64, Soa>::new([6]), Field::<f32, Soa>::new([6]));
    let (at, mut next, mut places) =
        (Field::<u32, Soa>::new([8]), Field::<u32, Soa>::new([8]), Field::<u32, Soa>::new([8]));
    let fixed = Schedule { deterministic: true, ..Schedule::default() };
    for text in [
        message(|| fixed.run(|| scatter_any(&mut to, &mut sum, &at))),
        message(|| fixed.run(|| take_places(&at, &mut next, &mut places))),
    ] {
        assert!(text.starts_with("kernel `") && text.contains("which `deterministic` forbids"), "{text}");
    }
}

#[test]
fn indices_are_checked() {
    let mut at = Field::<u32, Soa>::new([8]);
    at.fill(6);
    let (mut to, mut sum) = (Field::<f64, Soa>::new([6]), Field::<f32, Soa>::new([6]));
    let text = message(|| scatter_any(&mut to, &mut sum, &at));
    assert_eq!(text, "kernel `scatter_any`: index [6] is out of range of field `to`, whose shape is [6]");
    let (mut next, mut places) = (Field::<u32, Soa>::new([6]), Field::<u32, Soa>::new([8]));
    let text = message(|| take_places(&at, &mut next, &mut places));
    assert_eq!(text, "kernel `take_places`: index [6] is out of range of field `next`, whose shape is [6]");
}
