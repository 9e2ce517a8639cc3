//! Launches that are reached from inside of launches, through a function that calls a kernel.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::thread::{ThreadId, current};

use allotrope::prelude::*;

/// What the inner kernels are given as any other value: a field to read, and notes of who ran them under which schedule.
struct World<L> {
    table: Field<f32, L>,
    notes: Mutex<Vec<(ThreadId, Schedule)>>,
}

/// The inner kernel: a field of its own, accumulation, a reduction.
#[kernel]
fn inner<L: Layout<I>>(
    table: &Field<f32, L>,
    bins: &mut Field<f32, L>,
    shift: i32,
    notes: &Mutex<Vec<ThreadId>>,
) -> f32 {
    let mut total = 0.0;
    for i in table {
        bins[(i + shift).rem_euclid(7)] += table[i];
        total += table[i] * 0.1;
        if i % 64 == 0 {
            notes.lock().unwrap().push(current().id());
        }
    }
    for b in bins {
        total += bins[b];
        assert!(bins[b] < 1e6, "bin {b} of the inner kernel is too full");
    }
    total
}

/// An ordinary function, of which the outer kernel cannot know that it calls a kernel.
fn helper<L: Layout<I>>(world: &World<L>, p: i32) -> f32 {
    let threads = Mutex::new(Vec::new());
    let mut bins = Field::<f32, L>::new([7]);
    let total = inner(&world.table, &mut bins, p, &threads);
    let threads = threads.into_inner().unwrap();
    assert!(threads.iter().all(|thread| *thread == current().id()), "an inner launch left its thread");
    world.notes.lock().unwrap().push((current().id(), Schedule::current()));
    total + bins.get(3)
}

#[kernel]
fn outer<L: Layout<I>>(out: &mut Field<f32, L>, world: &World<L>) -> f32 {
    let mut sum = 0.0;
    for p in out {
        out[p] = helper(world, p);
        sum += out[p];
    }
    sum
}

fn world<L: Layout<I>>(largest: f32) -> World<L> {
    let mut table = Field::<f32, L>::new([1000]);
    table.copy_from_slice(&(0..1000).map(|n| n as f32 % 13.0).collect::<Vec<_>>());
    table.set(500, largest);
    World { table, notes: Mutex::new(Vec::new()) }
}

#[test]
fn an_inner_launch_runs_on_its_thread_and_inherits_the_schedule() {
    fn run<L: Layout<I>>() {
        let plain: Vec<f32> = {
            let world = world::<L>(1.0);
            (0..100).map(|p| Schedule { threads: 1, ..Schedule::default() }.run(|| helper(&world, p))).collect()
        };
        for scatter in [Scatter::Auto, Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
            for threads in 1..=3 {
                let schedule = Schedule { threads, scatter, grain: 8, ..Schedule::default() };
                let (world, mut out) = (world::<L>(1.0), Field::<f32, L>::new([100]));
                let sum = schedule.run(|| outer(&mut out, &world));
                assert!(out.to_vec().iter().zip(&plain).all(|(a, b)| (a - b).abs() < 1e-2 * b.abs()), "{schedule:?}");
                assert!((sum - plain.iter().sum::<f32>()).abs() < 1e-3 * sum, "{schedule:?}");
                let notes = world.notes.into_inner().unwrap();
                assert!(notes.len() == 100 && notes.iter().all(|(_, inside)| *inside == schedule), "{schedule:?}");
                assert!(threads > 1 || notes.iter().all(|(thread, _)| *thread == current().id()));
            }
        }
    }
    run::<Aos>();
    run::<Soa>();
    run::<AoSoA<8>>();
}

#[test]
fn deterministic_results_are_the_same_bits_inside_of_a_launch() {
    let bits = |threads| {
        let schedule = Schedule { threads, grain: 8, deterministic: true, ..Schedule::default() };
        let (world, mut out) = (world::<Soa>(0.3), Field::<f32, Soa>::new([50]));
        let sum = schedule.run(|| outer(&mut out, &world));
        // At the top level the inner kernel may use all threads.
        let alone = schedule.run(|| {
            let mut bins = Field::<f32, Soa>::new([7]);
            inner(&world.table, &mut bins, 7, &Mutex::new(Vec::new())) + bins.get(3)
        });
        assert_eq!(alone.to_bits(), out.get(7).to_bits());
        (sum.to_bits(), out.to_vec().into_iter().map(f32::to_bits).collect::<Vec<_>>())
    };
    assert!(bits(1) == bits(2) && bits(2) == bits(3));
}

/// A schedule that is asked for inside gives an inner launch no more threads, and is forgotten after.
#[test]
fn a_schedule_inside_of_a_launch_has_no_threads_to_give() {
    #[kernel]
    fn outer_with(out: &mut Field<f32, Soa>, world: &World<Soa>, within: &Schedule) {
        for p in out {
            let before = Schedule::current();
            out[p] = within.run(|| helper(world, p));
            assert_eq!(before, Schedule::current());
        }
    }
    let (world, mut out) = (world::<Soa>(1.0), Field::<f32, Soa>::new([40]));
    let within = Schedule { threads: 3, scatter: Scatter::Private, grain: 16, ..Schedule::default() };
    Schedule { threads: 2, grain: 4, ..Schedule::default() }.run(|| outer_with(&mut out, &world, &within));
    assert!(world.notes.into_inner().unwrap().iter().all(|(_, inside)| *inside == within));
    assert!(out.get(39) > 0.0);
}

#[test]
fn a_panic_in_an_inner_launch_ends_the_outer_one() {
    for threads in 1..=3 {
        let schedule = Schedule { threads, grain: 4, ..Schedule::default() };
        let (broken, mut out) = (world::<Aos>(1e7), Field::<f32, Aos>::new([60]));
        let panic = catch_unwind(AssertUnwindSafe(|| schedule.run(|| outer(&mut out, &broken))));
        let message = panic.expect_err("the inner kernel panics");
        let message = message.downcast_ref::<String>().expect("a message with a number in it");
        assert!(message.starts_with("bin ") && message.ends_with(" of the inner kernel is too full"), "{message}");
        // The thread is outside of launches again, and has its schedule back.
        assert_eq!(Schedule::current(), Schedule::default());
        let world = world::<Aos>(1.0);
        let threads_used = Mutex::new(Vec::new());
        let mut bins = Field::<f32, Aos>::new([7]);
        schedule.run(|| inner(&world.table, &mut bins, 0, &threads_used));
        assert_eq!(bins.to_vec().iter().sum::<f32>(), world.table.to_vec().iter().sum::<f32>());
        schedule.run(|| outer(&mut out, &world));
        assert!(out.get(59) > 0.0);
    }
}

/// Three launches deep, with the host's parallel algorithms in between.
#[test]
fn launches_nest_to_any_depth() {
    #[kernel]
    fn leaf(u: &mut Field<i64, Soa>) {
        for i in u {
            u[i] += i64::from(i);
        }
    }
    fn middle(p: i32) -> i64 {
        #[kernel]
        fn scan(u: &mut Field<i64, Soa>, p: i32) {
            for i in u {
                let mut small = Field::<i64, Soa>::new([10]).with_background(i64::from(p));
                leaf(&mut small);
                u[i] = small.map_reduce(|x| x, 0, |a, b| a + b);
            }
        }
        let mut u = Field::<i64, Soa>::new([5]);
        scan(&mut u, p);
        u.reduce(0, |a, b| a + b)
    }
    #[kernel]
    fn root(u: &mut Field<i64, Soa>) {
        for i in u {
            u[i] = middle(i);
        }
    }
    for threads in 1..=3 {
        let mut u = Field::<i64, Soa>::new([30]);
        Schedule { threads, grain: 1, ..Schedule::default() }.run(|| root(&mut u));
        assert!((0..30).all(|i| u.get(i) == 5 * (10 * i64::from(i) + 45)));
    }
}
