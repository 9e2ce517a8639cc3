//! Parallel loops: a space is cut into blocks, jobs take blocks, and the body runs in the version for the processor.

mod bricks;
pub(crate) mod cpu;
mod lanes;
mod pool;
#[cfg(not(allotrope_joined_threads))]
mod post;
mod queue;
pub(crate) mod reduction;
mod run;
mod sieve;
mod space;
mod still;

/// What queue and posts are made of: their tests model it.
mod sync {
    #[cfg(not(allotrope_joined_threads))]
    pub(super) use core::sync::atomic::AtomicPtr;
    pub(super) use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
}

use core::marker::PhantomData;
use core::ops::Range;
use std::sync::{Mutex, PoisonError};

pub(crate) use bricks::prefetch;
pub use lanes::{Batch, InLanes, Lane, Lanes, Mask, Part, Width, ends};
pub use reduction::{Partial, Reduction, Strip, reduction};
pub use run::{Cell, Run};
pub(crate) use run::{apart, copies_rows, stay_scalar};
pub use sieve::{Border, Checkerboard, Colored, Sieve, Sifted, TwoColours, sift, sifted};
pub use space::{Space, interior, of_branch, over, range};
pub(crate) use space::{any_in_blocks, is_in_blocks};
pub(crate) use still::Still;
pub use still::still;
use still::{All, Memory};

use crate::scatter::{self, Bounds, Key, PackedPiece, Place, Scattered, Share, Sink, Tiled};
use crate::schedule::{Inside, Scatter, Schedule};
use cpu::Cpu;

/// What a launch is told besides its space and body.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// The kernel's name.
    pub kernel: &'static str,
    /// The loop's number among the kernel's parallel loops.
    pub number: usize,
    /// Whether the box checks of rows hold.
    pub fits: bool,
    /// Whether an element takes much work: fewer are then worth a thread.
    pub heavy: bool,
    /// The strategy that the loop itself asks for.
    pub scatter: Option<Scatter>,
    /// The fields that the loop accumulates into, by slot.
    pub targets: &'a [&'a dyn Scattered],
    /// The memory of fields that the loop only reads, where it is known.
    pub still: All<'a>,
    /// If iterations read and change elements of each other: whether every component there can be reached atomically.
    pub together: Option<bool>,
    /// Whether the loop takes places in lists, whose order is that of the loop under `deterministic`.
    pub ordered: bool,
}

impl core::fmt::Debug for Options<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Options of `{}`", self.kernel)
    }
}

/// A part of a space that one job runs through, and where it accumulates.
#[doc(hidden)]
#[derive(Debug)]
pub struct Task<'t, S> {
    space: &'t S,
    units: Range<usize>,
    fits: bool,
    atomic: bool,
    alone: bool,
    /// Whether the body's version has instructions that add a product in one rounding.
    fused: bool,
    /// Elements that are visited beside those of the units.
    pieces: &'t [PackedPiece],
    shares: &'t [Share<'t>],
    still: All<'t>,
    owner: PhantomData<*mut ()>,
}

/// How many pieces ahead elements are fetched: by then they have come from memory, and are not yet pushed out of the caches.
const AHEAD: usize = 12;

/// A [`Task`] of whatever space.
struct Portion<'t> {
    units: Range<usize>,
    atomic: bool,
    alone: bool,
    pieces: &'t [PackedPiece],
    shares: &'t [Share<'t>],
}

impl<'t, S: Space> Task<'t, S> {
    #[inline(always)]
    fn new(space: &'t S, fits: bool, still: All<'t>, portion: Portion<'t>) -> Self {
        let Portion { units, atomic, alone, pieces, shares } = portion;
        Self { space, units, fits, atomic, alone, fused: FUSED, pieces, shares, still, owner: PhantomData }
    }

    /// Visits the task's runs in memory order. Whole runs of blocks are written out: for small bodies.
    #[inline(always)]
    pub fn rows(&self, mut body: impl FnMut(Run<'_, S>)) {
        self.visit::<true>(&mut body);
    }

    /// Visits the task's runs in memory order, with one copy of the body: for large bodies.
    #[inline(always)]
    pub fn runs(&self, mut body: impl FnMut(Run<'_, S>)) {
        self.visit::<false>(&mut body);
    }

    #[inline(always)]
    fn visit<const LIGHT: bool>(&self, body: &mut impl FnMut(Run<'_, S>)) {
        // One place where the body stands, as it may be large: the units come first, of which a task with pieces has none.
        let (mut space, mut units, mut rest) = (*self.space, self.units.clone(), self.pieces);
        loop {
            space.visit::<LIGHT>(
                units,
                self.fits,
                #[inline(always)]
                |run| once(body, run),
            );
            let Some((piece, others)) = rest.split_first() else { return };
            rest = others;
            if let Some(ahead) = others.get(AHEAD) {
                self.space.prefetch(ahead.get());
            }
            space = self.space.part(piece.get());
            units = 0..space.units();
        }
    }

    /// What this job accumulates into for the field of a slot.
    #[inline(always)]
    pub(crate) fn share(&self, slot: usize) -> Share<'t> {
        self.shares[slot]
    }

    /// Where the memory at a place of [`Options::still`] begins.
    #[inline(always)]
    pub(crate) fn still(&self, place: usize) -> *mut u8 {
        self.still[place].as_ptr().cast_mut().cast()
    }

    #[inline(always)]
    pub(crate) fn atomic(&self) -> bool {
        self.atomic
    }

    /// Whether products that are added to something may be rounded with it.
    #[inline(always)]
    pub fn fused(&self) -> bool {
        self.fused
    }

    /// Whether one thread runs the whole loop.
    #[inline(always)]
    pub(crate) fn alone(&self) -> bool {
        self.alone
    }
}

/// Calls a body. With debug assertions it has one copy for all places that call it: without optimisation, the frame of a function with
/// dozens of them takes more than a thread's stack.
#[cfg_attr(debug_assertions, inline(never))]
#[cfg_attr(not(debug_assertions), inline(always))]
fn once<T>(body: &mut impl FnMut(T), at: T) {
    body(at);
}

/// Whether every processor of the architecture adds a product in one rounding.
const FUSED: bool = cfg!(target_feature = "fma") || cfg!(target_arch = "aarch64");

/// Body versions. In the plain ones `fits` holds and updates are plain, as constants; the careful one asks at run time. Builds with debug
/// assertions, whose bodies are no part of the loops around them, have that one alone. So has a loop that accumulates on an x86-64 without AVX2:
/// a plain version for it would be a quarter of the time that such loops take to build.
mod versions {
    use super::{All, FUSED, Memory, Space, Task};

    #[inline(always)]
    fn plain<'t, const TILED: bool, const FUSED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
        body: &F,
        task: Task<'t, S>,
        still: All<'t>,
    ) -> Out {
        let pieces = if TILED { task.pieces } else { &[] };
        body(Task { pieces, fits: true, atomic: false, fused: FUSED, still, ..task })
    }

    pub(super) fn baseline<'t, const TILED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
        body: &F,
        task: Task<'t, S>,
        a: Memory<'t>,
        b: Memory<'t>,
        c: Memory<'t>,
        d: Memory<'t>,
    ) -> Out {
        plain::<TILED, FUSED, S, Out, F>(body, task, [a, b, c, d])
    }

    #[cfg(all(target_arch = "x86_64", not(debug_assertions)))]
    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    pub(super) fn avx2<'t, const TILED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
        body: &F,
        task: Task<'t, S>,
        a: Memory<'t>,
        b: Memory<'t>,
        c: Memory<'t>,
        d: Memory<'t>,
    ) -> Out {
        plain::<TILED, true, S, Out, F>(body, task, [a, b, c, d])
    }

    #[cfg(all(target_arch = "x86_64", not(debug_assertions)))]
    #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    pub(super) fn avx512<'t, const TILED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
        body: &F,
        task: Task<'t, S>,
        a: Memory<'t>,
        b: Memory<'t>,
        c: Memory<'t>,
        d: Memory<'t>,
    ) -> Out {
        plain::<TILED, true, S, Out, F>(body, task, [a, b, c, d])
    }

    pub(super) fn careful<const FITS: bool, const TILED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
        body: &F,
        task: Task<'_, S>,
    ) -> Out {
        let atomic = task.atomic;
        let pieces = if const { TILED } { task.pieces } else { &[] };
        body(Task { pieces, fits: FITS || task.fits, atomic, fused: FUSED, ..task })
    }
}

#[inline]
fn dispatch<const OWN: bool, const FITS: bool, const TILED: bool, S: Space, Out, F: Fn(Task<'_, S>) -> Out>(
    cpu: Cpu,
    body: &F,
    task: Task<'_, S>,
) -> Out {
    let asks = |cpu| !task.fits || task.atomic || cfg!(target_arch = "x86_64") && cpu == Cpu::Baseline;
    if const { cfg!(debug_assertions) } || const { !OWN } && asks(cpu) {
        return versions::careful::<FITS, TILED, S, Out, F>(body, task);
    }
    // One by one: of arguments alone the optimiser knows what a reference is.
    let [a, b, c, d] = task.still;
    match cpu {
        // SAFETY: `Cpu::chosen` and `Schedule::run` admit only instruction sets that the processor has.
        #[cfg(all(target_arch = "x86_64", not(debug_assertions)))]
        Cpu::Avx512 => unsafe { versions::avx512::<TILED, S, Out, F>(body, task, a, b, c, d) },
        // SAFETY: as above.
        #[cfg(all(target_arch = "x86_64", not(debug_assertions)))]
        Cpu::Avx2 => unsafe { versions::avx2::<TILED, S, Out, F>(body, task, a, b, c, d) },
        _ if const { OWN || !cfg!(target_arch = "x86_64") } => {
            versions::baseline::<TILED, S, Out, F>(body, task, a, b, c, d)
        }
        _ => unreachable!("loops that accumulate have no plain version of the baseline"),
    }
}

/// The tasks of a launch and their results, whatever they run through and do: what surrounds them is compiled once.
trait Tasks: Sync {
    /// Makes room for the results of so many.
    fn expect(&mut self, count: usize);
    /// Runs one, and keeps its result.
    fn run(&self, n: usize, cpu: Cpu, portion: Portion<'_>);
    /// Finds the keys of one's elements, where there are some.
    fn keys(&self, portion: Portion<'_>, sink: &mut Sink);
}

/// Tasks that run a body in its version for the processor. `OWN`: it touches its own elements alone; `FITS`: its rows always fit; `TILED`: its
/// elements may come in pieces.
struct Bodies<'a, const OWN: bool, const FITS: bool, const TILED: bool, S, Out, F> {
    space: &'a S,
    fits: bool,
    still: All<'a>,
    key: Option<&'a Key<'a, S>>,
    body: F,
    outs: Slots<Out>,
}

impl<const OWN: bool, const FITS: bool, const TILED: bool, S, Out, F> Bodies<'_, OWN, FITS, TILED, S, Out, F> {
    /// Whether results take memory.
    const KEEPS: bool = size_of::<Out>() > 0;
}

impl<const OWN: bool, const FITS: bool, const TILED: bool, S, Out, F> Tasks for Bodies<'_, OWN, FITS, TILED, S, Out, F>
where
    S: Space,
    Out: Send,
    F: Fn(Task<'_, S>) -> Out + Sync,
{
    fn expect(&mut self, count: usize) {
        if const { Self::KEEPS } {
            self.outs = Slots::new(count);
        }
    }

    fn run(&self, n: usize, cpu: Cpu, portion: Portion<'_>) {
        let task = Task::new(self.space, self.fits, self.still, portion);
        let out = dispatch::<OWN, FITS, TILED, S, Out, F>(cpu, &self.body, task);
        if const { Self::KEEPS } {
            self.outs.put(n, out);
        }
    }

    fn keys(&self, portion: Portion<'_>, sink: &mut Sink) {
        if const { TILED }
            && let Some(key) = self.key
        {
            (key.keys)(Task::new(self.space, self.fits, self.still, portion), sink);
        }
    }
}

/// Runs a body over a space.
fn all<const OWN: bool, const FITS: bool, const TILED: bool, S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    key: Option<&Key<'_, S>>,
    body: F,
) -> Outs<Out> {
    assert!(!(OWN || FITS) || options.fits, "rows that might not fit have a version that asks");
    assert!(!OWN || options.targets.is_empty(), "a loop that accumulates has a version that does so atomically");
    let place = key.map(|key| key.place);
    let mut tasks = Bodies::<OWN, FITS, TILED, S, Out, F> {
        space,
        fits: options.fits,
        still: options.still,
        key,
        body,
        outs: Slots::new(0),
    };
    start(extent_of(space), options, place, &mut tasks);
    tasks.outs.take()
}

/// What of a space is asked before it is run through.
struct Extent {
    units: usize,
    bounds: Bounds,
    divisible: bool,
}

#[inline(never)]
fn extent_of<S: Space>(space: &S) -> Extent {
    Extent { units: space.units(), bounds: Bounds::of(space), divisible: S::DIVISIBLE }
}

/// The most blocks that a space is cut into: enough for load balance on many threads.
const MOST_BLOCKS: usize = 256;

/// Elements that are worth a block of their own.
fn grain(schedule: &Schedule, heavy: bool) -> usize {
    match schedule.grain {
        0 if heavy => 1 << 9,
        0 => 1 << 14,
        grain => grain,
    }
}

/// Results of blocks, in order. One needs no memory.
#[doc(hidden)]
#[derive(Debug)]
pub struct Outs<Out>(Results<Out>);

#[derive(Debug)]
enum Results<Out> {
    One(Option<Out>),
    Many(std::vec::IntoIter<Out>),
}

impl<Out> Iterator for Outs<Out> {
    type Item = Out;
    #[inline]
    fn next(&mut self) -> Option<Out> {
        match &mut self.0 {
            Results::One(out) => out.take(),
            Results::Many(outs) => outs.next(),
        }
    }
}

/// Runs a loop that accumulates, or whose rows may reach outside of their fields.
#[doc(hidden)]
pub fn launch<S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    body: F,
) -> Outs<Out> {
    all::<false, false, false, S, Out, F>(space, options, None, body)
}

/// The same where it is known before it accumulates where.
#[doc(hidden)]
pub fn launch_keyed<S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    key: Key<'_, S>,
    body: F,
) -> Outs<Out> {
    all::<false, false, true, S, Out, F>(space, options, Some(&key), body)
}

/// Runs a loop that accumulates, and whose rows never reach outside.
#[doc(hidden)]
pub fn launch_inside<S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    body: F,
) -> Outs<Out> {
    all::<false, true, false, S, Out, F>(space, options, None, body)
}

/// The same where it is known before it accumulates where.
#[doc(hidden)]
pub fn launch_inside_keyed<S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    key: Key<'_, S>,
    body: F,
) -> Outs<Out> {
    all::<false, true, true, S, Out, F>(space, options, Some(&key), body)
}

/// Runs a loop that touches its own elements alone.
#[doc(hidden)]
pub fn launch_own<S: Space, Out: Send, F: Fn(Task<'_, S>) -> Out + Sync>(
    space: &S,
    options: Options<'_>,
    body: F,
) -> Outs<Out> {
    all::<true, true, false, S, Out, F>(space, options, None, body)
}

fn start(extent: Extent, options: Options<'_>, place: Option<Place>, tasks: &mut dyn Tasks) {
    let Extent { units, bounds, divisible } = extent;
    let elements = bounds.elements;
    if units == 0 || elements == 0 {
        return;
    }
    let schedule = Schedule::current();
    let cpu = schedule.instruction_set();
    assert!(
        options.together.is_none() || !schedule.deterministic,
        "kernel `{}`: iterations that meet in one element, in a `#[relaxed]` loop or by `fetch_add` and its like, come in no fixed order, which `deterministic` forbids",
        options.kernel
    );
    let recording = crate::probe::is_recording();
    let _launch = recording.then(|| crate::probe::launch(options.kernel, options.number));
    let alone =
        recording || Inside::now() || options.together == Some(false) || (options.ordered && schedule.deterministic);
    let threads = if alone { 1 } else { schedule.thread_count() };
    let alone = threads == 1;
    let grain = grain(&schedule, options.heavy);
    // Blocks, and with them the order of reductions, follow from the work alone, never from the threads.
    let blocks = (elements / grain).clamp(1, MOST_BLOCKS).min(units);
    let block = |b: usize| units * b / blocks..units * (b + 1) / blocks;
    let portion = |units| Portion { units, atomic: false, alone, pieces: &[], shares: &[] };
    let possible = place.filter(|place| divisible && place.is_possible(&bounds, options.targets));
    let (plan, bins) = {
        let keys = |b: usize, sink: &mut Sink| tasks.keys(portion(block(b)), sink);
        let scattered = || possible.and_then(|place| place.scattered_over(&bounds, options.targets, blocks, &keys));
        let tiled = possible.map(|place| Tiled { certain: place.certain, scattered: &scattered });
        let plan = scatter::plan(&options, &schedule, threads, elements, blocks, tiled);
        let sorted = possible.filter(|_| plan.colored);
        (plan, sorted.map(|place| place.sort(&bounds, options.targets, plan.threads, blocks, &keys)))
    };
    tasks.expect(bins.as_ref().map_or(blocks, |bins| bins.jobs()));
    let tasks = &*tasks;
    if let Some(bins) = bins {
        let tile = |tile: usize, shares: &[Share<'_>]| {
            if recording {
                crate::probe::block(tile, bins.jobs());
            }
            tasks.run(tile, cpu, Portion { pieces: bins.pieces(tile), shares, ..portion(0..0) });
        };
        return bins.execute(plan.threads, options.targets, &tile);
    }
    let run = |b: usize, shares: &[Share<'_>]| {
        if recording {
            crate::probe::block(b, blocks);
        }
        tasks.run(b, cpu, Portion { atomic: plan.atomic, shares, ..portion(block(b)) });
    };
    scatter::execute(&plan, options.targets, blocks, &run);
}

/// One result a block, put by whichever thread runs it.
struct Slots<Out> {
    first: Mutex<Option<Out>>,
    others: Vec<Mutex<Option<Out>>>,
}

impl<Out> Slots<Out> {
    fn new(blocks: usize) -> Self {
        Self { first: Mutex::new(None), others: (1..blocks).map(|_| Mutex::new(None)).collect() }
    }
    fn put(&self, b: usize, out: Out) {
        let slot = if b == 0 { &self.first } else { &self.others[b - 1] };
        *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(out);
    }
    fn take(self) -> Outs<Out> {
        let result = |slot: Mutex<Option<Out>>| slot.into_inner().unwrap_or_else(PoisonError::into_inner);
        let first = result(self.first);
        if self.others.is_empty() {
            return Outs(Results::One(first));
        }
        let all: Option<Vec<Out>> = core::iter::once(first).chain(self.others.into_iter().map(result)).collect();
        Outs(Results::Many(all.expect("every block ran").into_iter()))
    }
}

/// Runs jobs on threads: see [`pool::run`].
pub(crate) fn run_jobs(threads: usize, jobs: usize, job: &(dyn Fn(usize) + Sync)) {
    pool::run(threads, jobs, job);
}

/// Runs jobs on threads, and returns their results in order.
///
/// The job is a `dyn` one: what surrounds it is compiled once for all jobs of a result.
pub(crate) fn results_of_jobs<T: Send>(threads: usize, jobs: usize, job: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    let results: Vec<Mutex<Option<T>>> = (0..jobs).map(|_| Mutex::new(None)).collect();
    run_jobs(threads, jobs, &|n| {
        let result = job(n);
        *results[n].lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
    });
    let result = |slot: Mutex<Option<T>>| slot.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.into_iter().map(|slot| result(slot).expect("every job ran")).collect()
}
