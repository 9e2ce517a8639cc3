//! Helpers of launches: tasks of a rayon pool, which wait for the next launch for a moment before they go back to it.
//!
//! To wake a thread takes some ten microseconds, as long as a small loop. So a helper looks at its post for a while after each order, and a
//! launch whose jobs are all taken withdraws what no helper has come for.

use std::any::Any;
use std::hint::spin_loop;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::Work;
use crate::launch::post::Post;
use crate::schedule::{Schedule, inherit};

/// How long a helper waits for the next order: longer than what a caller does between loops of one step, too short to be noticed when idle.
const PATIENCE: Duration = Duration::from_micros(40);

/// How often a launch looks whether a helper is done before it sleeps.
const LOOKS: usize = 2_000;

/// Helpers of one launch at a time.
struct Team {
    pool: ThreadPool,
    /// Whether a launch has them.
    taken: AtomicBool,
    posts: Vec<Post>,
    /// Whether helpers may wait awake: not where there are more of them than the machine runs at once.
    patient: bool,
    /// What a launch sleeps on until helpers are done.
    asleep: Mutex<()>,
    bell: Condvar,
}

/// One team for each number of helpers, made when it is first used.
static TEAMS: [OnceLock<Team>; crate::MAX_THREADS] = [const { OnceLock::new() }; crate::MAX_THREADS];

impl Team {
    fn of(helpers: usize) -> &'static Self {
        TEAMS[helpers].get_or_init(|| {
            let pool = ThreadPoolBuilder::new()
                .num_threads(helpers)
                .thread_name(|n| format!("allotrope-{}", n + 1))
                .build()
                .unwrap_or_else(|error| panic!("cannot start {helpers} threads: {error}"));
            Self {
                pool,
                taken: AtomicBool::new(false),
                posts: (0..helpers).map(|_| Post::new()).collect(),
                patient: std::thread::available_parallelism().is_ok_and(|all| all.get() > helpers),
                asleep: Mutex::new(()),
                bell: Condvar::new(),
            }
        })
    }

    /// A helper's life: it takes orders as long as they come.
    fn serve(&self, post: &Post) {
        let patience = if self.patient { PATIENCE } else { Duration::ZERO };
        let mut since = Instant::now();
        loop {
            if let Some(order) = post.take() {
                // SAFETY: whoever has put the order keeps it until it is withdrawn, which it was not, or the post is no longer busy.
                unsafe { Order::carry_out(order) };
                post.finish();
                // Whoever sleeps has either seen this, or is told.
                drop(self.asleep.lock().unwrap_or_else(PoisonError::into_inner));
                self.bell.notify_all();
                since = Instant::now();
            } else if since.elapsed() >= patience && post.leave() {
                return;
            }
            spin_loop();
        }
    }

    /// Waits until the helper at a post is done.
    fn wait(&self, post: &Post) {
        for _ in 0..LOOKS {
            if !post.is_busy() {
                return;
            }
            spin_loop();
        }
        let mut asleep = self.asleep.lock().unwrap_or_else(PoisonError::into_inner);
        while post.is_busy() {
            asleep = self.bell.wait(asleep).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// What helpers are asked to do.
struct Order<'a> {
    work: &'a Work<'a>,
    schedule: Schedule,
    /// The first panic of a helper.
    panic: Mutex<Option<Box<dyn Any + Send>>>,
}

impl Order<'_> {
    fn address(&self) -> *mut () {
        core::ptr::from_ref(self).cast_mut().cast()
    }

    /// Takes jobs until there are none.
    ///
    /// # Safety
    /// The address is that of an order, which lives until this returns.
    unsafe fn carry_out(address: *mut ()) {
        // SAFETY: the caller's promise; it is shared alone.
        let order = unsafe { &*address.cast::<Order<'_>>() };
        let done = catch_unwind(AssertUnwindSafe(|| inherit(order.schedule, || order.work.run())));
        if let Err(panic) = done {
            order.panic.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(panic);
        }
    }
}

/// An order that helpers may have. When it goes, also by a panic, none has it any more, and the team is free.
struct Given<'a> {
    team: &'static Team,
    order: &'a Order<'a>,
}

impl Drop for Given<'_> {
    fn drop(&mut self) {
        for post in &self.team.posts {
            if !post.withdraw(self.order.address()) {
                self.team.wait(post);
            }
        }
        self.team.taken.store(false, Ordering::Release);
    }
}

/// Works with so many helpers, and returns when all have stopped. While another thread's launch has them, this one works alone.
pub(super) fn help(helpers: usize, work: &Work<'_>, schedule: Schedule) {
    let team = Team::of(helpers);
    if team.taken.swap(true, Ordering::Acquire) {
        work.run();
        return;
    }
    let order = Order { work, schedule, panic: Mutex::new(None) };
    let given = Given { team, order: &order };
    for post in &team.posts {
        if post.put(order.address()) {
            team.pool.spawn(|| team.serve(post));
        }
    }
    work.run();
    drop(given);
    if let Some(panic) = order.panic.into_inner().unwrap_or_else(PoisonError::into_inner) {
        resume_unwind(panic);
    }
}
