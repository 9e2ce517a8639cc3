//! Threads that help launches: they take part, from wherever a kernel is called, and sleep when there is nothing to do.

use std::collections::HashSet;
use std::sync::Mutex;
use std::thread::{self, ThreadId};
use std::time::Duration;

use allotrope::prelude::*;

#[kernel]
fn count(x: &mut Field<u32, _>) {
    for i in x {
        x[i] += 1;
    }
}

/// Notes the threads that run a loop whose iterations take a while.
#[kernel]
fn slow(x: &mut Field<u32, _>, seen: &Mutex<HashSet<ThreadId>>) {
    for i in x {
        seen.lock().unwrap().insert(thread::current().id());
        thread::sleep(Duration::from_millis(2));
        x[i] += 1;
    }
}

fn schedule(threads: usize) -> Schedule {
    Schedule { threads, grain: 1, ..Schedule::default() }
}

/// Ticks of processor time that the helpers have taken, of which there are usually a hundred a second.
#[cfg(target_os = "linux")]
fn ticks() -> u64 {
    let tasks = std::fs::read_dir("/proc/self/task").unwrap();
    let ticks = |task: std::fs::DirEntry| {
        let stat = std::fs::read_to_string(task.path().join("stat")).ok()?;
        let (name, rest) = stat.rsplit_once(')')?;
        let numbers: Vec<u64> = rest.split_whitespace().skip(11).take(2).filter_map(|text| text.parse().ok()).collect();
        name.contains("(allotrope-").then(|| numbers.iter().sum::<u64>())
    };
    tasks.filter_map(|task| ticks(task.unwrap())).sum()
}

#[test]
fn helpers_take_part_and_sleep_afterwards() {
    // With as many threads as there are processors, or fewer, helpers wait awake for a moment; with more they do not.
    for threads in [2, 3] {
        let seen = Mutex::default();
        schedule(threads).run(|| slow(&mut Field::<u32, Aos>::new([30]), &seen));
        assert!(seen.lock().unwrap().len() > 1, "long iterations are shared by {threads}");

        // Launches one after another, from several threads at once, and from the tasks of another pool.
        let sums = |launches: u32| {
            let mut x = Field::<u32, Aos>::new([1000]);
            schedule(threads).run(|| (0..launches).for_each(|_| count(&mut x)));
            assert!(x.iter().all(|x| x == launches), "every element once a launch");
        };
        sums(2000);
        thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| sums(500));
            }
        });
        rayon::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|_| sums(200));
            }
        });
    }

    #[cfg(target_os = "linux")]
    {
        thread::sleep(Duration::from_millis(50));
        let before = ticks();
        thread::sleep(Duration::from_millis(500));
        let spent = ticks() - before;
        assert!(spent <= 5, "{spent} ticks of half a second without a launch");
    }
}
