//! *One algorithm, many layouts.* A kernel is written once, against named members and indices; how they lie in memory is a type,
//! chosen elsewhere, and changed without touching the kernel. Its outermost loops run on all cores, and a kernel that
//! could race does not compile.
//!
//! | word | what it is | written as |
//! | --- | --- | --- |
//! | record | what one element holds | [`#[derive(Record)]`](macro@Record) on a plain struct of [elements](Element), or a bare element such as `f32` |
//! | layout | how a space of records lies in memory | a type: [`layout!`](crate::layout!)`(dense(ij).dense(ij, 8).soa)`, or a named one such as [`Soa`](layout::Soa) |
//! | field | storage: records `R` in the layout `L` over the axes `X` | [`Field<R, L, X>`](Field) |
//! | kernel | a function over fields, whose outermost loops run in parallel | [`#[kernel]`](macro@kernel)` fn` |
//!
//! ```
//! use allotrope::prelude::*;
//!
//! /// What one place of a pond holds.
//! #[derive(Record, Clone, Copy, Default)]
//! struct Water {
//!     height: f32,
//!     speed: f32,
//! }
//!
//! /// A time step of the wave equation; returns the energy of motion.
//! #[kernel]
//! fn step(old: &Field<Water, _, Ij>, new: &mut Field<Water, _, Ij>, dt: f32) -> f32 {
//!     let mut energy = 0.0;
//!     for (i, j) in new.interior(1) {
//!         let around = old.height[(i - 1, j)] + old.height[(i + 1, j)] + old.height[(i, j - 1)] + old.height[(i, j + 1)];
//!         let speed = old.speed[(i, j)] + dt * (around - 4.0 * old.height[(i, j)]);
//!         new.speed[(i, j)] = speed;
//!         new.height[(i, j)] = old.height[(i, j)] + dt * speed;
//!         energy += 0.5 * speed * speed;
//!     }
//!     energy
//! }
//!
//! fn run<L: Layout<Ij>>() -> f32 {
//!     let mut old = Field::<Water, L>::new([64, 48]);
//!     old.set([20, 20], Water { height: 1.0, speed: 0.0 });
//!     let mut new = old.clone();
//!     let mut energy = 0.0;
//!     for _ in 0..10 {
//!         energy = step(&old, &mut new, 0.1);
//!         std::mem::swap(&mut old, &mut new);
//!     }
//!     energy
//! }
//!
//! let energy = run::<Aos>();
//! assert!(energy > 0.0);
//! assert!((run::<Soa>() - energy).abs() < 1e-6 * energy);
//! assert!((run::<layout!(dense(ji).dense(ij, (4, 8)).soa)>() - energy).abs() < 1e-6 * energy);
//! ```
//!
//! # Records
//!
//! A record is a struct with named members, 24 at most, whose types are [elements](Element): `f32 f64 i8..i64 u8..u64 bool`, glam's
//! vectors, matrices and quaternions, enums without fields that have [`#[derive(Element)]`](macro@Element), and arrays `[T; N]` of elements. A bare element is a record of one unnamed member:
//! `Field<f32, L, Ij>` is indexed as `u[(i, j)]`, a member of a struct as `grid.v[(i, j)]`, a whole record as `grid[(i, j)]`.
//!
//! # Layouts
//!
//! A layout is a chain of nodes from the root down, closed by how the records of the innermost one are placed. It says nothing of the
//! record (unless it names members, and then it says whose), so that the same layout serves any. Axes are `i j k l`, and their order is the
//! order in memory, the last fastest.
//!
//! | part | meaning |
//! | --- | --- |
//! | `dense(ij)`, `dense(ji)` | a full block over the named axes, row-major, column-major |
//! | `dense(ij, 8)`, `dense(ij, (4, 2))` | of constant size; any size, powers of two or not. The outermost node takes as many as the shape needs |
//! | `morton(ij, 8)`, `morton(ij, (4, 16))` | a full block in Z-order, whose sizes are powers of two: cells that are near along any axis are near in memory |
//! | `pointer(ij)`, `pointer(ij, 16)` | a block whose cells are allocated when they are first written |
//! | `bitmasked(ij, 8)`, `bitmasked(ij)` | a full block with one activity bit a cell |
//! | `hash(ijk)` | the outermost node of an unbounded field, whose cells are found by hashing |
//! | `dynamic(j, 64)`, `dynamic(j, 1024, chunk = 32)` | the innermost node: a list, up to that many entries, in one block or in blocks of 32 |
//! | `.pad(64)` before the place | each record (`.aos`) or run of values (the others) begins at a multiple of so many bytes, a power of two up to 4096 |
//! | `.aos` | record after record |
//! | `.soa` | for each member, all values of the node |
//! | `.split` | for each scalar component of each member, all values of the node |
//! | `.place([v, m], [split(c)])` | groups: each is interleaved, groups follow one another; `split` takes a member apart. Written with its record: `layout!(Node: dense(ij).place(..))`, and its parameters if it has some: [`layout!(Node<X>: ..)`](layout::PlaceGroups) |
//! | `chain + chain` | branches: members under different nodes, `layout!(Node: dense(ij).place([v]) + dense(ji).dense(j, 8).place([m]))`. Every member stands in one of them, all go over the same axes, and there are four at most. A loop then names the branch by a member: `for ij in grid.m` |
//!
//! Named ones, for any axes: [`Aos`](layout::Aos), [`Soa`](layout::Soa), [`Split`](layout::Split), [`AoSoA<N>`](layout::AoSoA) (blocks of `N` along the last
//! axis, each member by member), [`Blocked<N>`](layout::Blocked) (blocks of `N` along every axis), [`Morton<N>`](layout::Morton) (the same in
//! Z-order), [`Sparse<N>`](layout::Sparse) (pointers to such blocks) and [`SparseHash<N>`](layout::SparseHash). A layout has six nodes with a size at most.
//!
//! # Sparse fields and lists
//!
//! Where a layout has `pointer`, `bitmasked`, `hash` or `dynamic` nodes, memory follows what is active. Activity is that of the innermost of them: the
//! cells of a `dense` block below a `pointer` are active together, those of a `bitmasked` block each by itself.
//!
//! - A new sparse field is empty. Reads of an inactive cell read the background and never make it active. Every write and accumulation that is executed does, of zero
//!   too, and so do `activate` and `append`, with the whole path to the cell. A cell that becomes active anew holds the background.
//! - Loops run over the active elements, each exactly once, in memory order. Which these are is fixed when the loop starts; `deactivate` and `remove` take
//!   effect when it ends.
//! - Blocks that are given back (`deactivate`, `clear`, [`prune`](Field::prune)) are reused. What the field holds, [`bytes`](Field::bytes), does not grow over steps.
//! - `dynamic` lists count their entries along the last axis, which `new` leaves out: `Field::<u32, layout!(dense(i).dynamic(j, 64).aos)>::new([n])` is over [`Ij`]. Fields under
//!   `hash` are made by [`unbounded`](Field::unbounded), and take any signed index.
//!
//! | on the host | in a parallel loop | |
//! | --- | --- | --- |
//! | [`is_active`](Field::is_active), [`activate`](Field::activate), [`deactivate`](Field::deactivate) | the same; `grid.m.activate(ij)` for the branch of a member | cells |
//! | [`append`](Field::append), [`try_append`](Field::try_append), [`remove`](Field::remove) | the same; an `append` to a full list is an error that names field, list and kernel | entries of lists |
//! | [`row`](Field::row), [`row_len`](Field::row_len) | `for q in near.row(p)`, an inner loop, whose `q` is a whole index; `near.len(p)` | a list |
//! | [`truncate`](Field::truncate), [`retain`](Field::retain), [`clear`](Field::clear), [`prune`](Field::prune) | | all |
//! | [`active_len`](Field::active_len), [`active_iter`](Field::active_iter), [`blocks`](Field::blocks), [`background`](Field::background) | | what there is |
//!
//! ```
//! use allotrope::prelude::*;
//!
//! /// The numbers of the particles in each cell of an unbounded plane.
//! type Cells = layout!(hash(ij).dynamic(k, 64).aos);
//!
//! #[kernel]
//! fn bin(x: &Field<Vec2, _>, cells: &mut Field<u32, Cells, Ijk>, width: f32) {
//!     cells.clear();
//!     for p in x {
//!         cells.append((x[p] / width).floor().as_ivec2(), p as u32);
//!     }
//! }
//!
//! #[kernel]
//! fn density(x: &Field<Vec2, _>, cells: &Field<u32, Cells, Ijk>, density: &mut Field<f32, _>, width: f32) {
//!     for p in x {
//!         let cell = (x[p] / width).floor().as_ivec2();
//!         let mut sum = 0.0;
//!         for (a, b) in unroll!(-1..2, -1..2) {
//!             for q in cells.row(cell + ivec2(a, b)) {
//!                 sum += (1.0 - (x[p] - x[cells[q]]).length() / width).max(0.0);
//!             }
//!         }
//!         density[p] = sum;
//!     }
//! }
//!
//! let mut x = Field::<Vec2, Soa>::new([3]);
//! x.copy_from_slice(&[vec2(-7.0, 2.0), vec2(-7.5, 2.0), vec2(1e6, 0.0)]);
//! let mut cells = Field::<u32, Cells, Ijk>::unbounded();
//! let mut sums = Field::<f32, Soa>::new([3]);
//! bin(&x, &mut cells, 1.0);
//! density(&x, &cells, &mut sums, 1.0);
//! assert_eq!(sums.to_vec(), [1.5, 1.5, 1.0]);
//! ```
//!
//! # Fields
//!
//! [`Field::new`] makes a field of zeros, [`with_background`](Field::with_background) one of something else, and [`with_origin`](Field::with_origin) one whose indices begin elsewhere than at zero; the axes ([`I`], [`Ij`], [`Ijk`], [`Ijkl`], and [`O`] for a single
//! record, made by `new([])` and indexed by `[()]`) follow from the extents. Values come and go in
//! logical row-major order, whatever the layout. An index out of range panics, or is an error where the name begins with `try_`.
//!
//! | outside of kernels | |
//! | --- | --- |
//! | `get`, `set`, `fill`, `iter`, [`par_iter`](Field::par_iter) | whole records |
//! | [`members`](Field::members), [`members_mut`](Field::members_mut) | one member at a time: `grid.members().mass.to_vec()` |
//! | [`relayout`](Field::relayout), [`copy_from`](Field::copy_from) | copies from layout to layout |
//! | [`find_nonfinite`](Field::find_nonfinite) | the first number that is NaN or infinite, and where |
//! | [`reduce`](Field::reduce), [`map_reduce`](Field::map_reduce) | all records combined into one |
//! | [`exclusive_scan`](Field::exclusive_scan) | every number replaced by the sum of those before it |
//! | [`reorder_by_key`](Field::reorder_by_key) | a stable sort of whole records, which returns the [`Permutation`] |
//! | [`scatter`](Field::scatter) | another field's records put where a permutation says |
//! | [`save`](Field::save), [`load`](Field::load) | the field as an `.npz` file, which NumPy opens |
//! | [`memory_map`](Field::memory_map) | where in memory each member of each element lies |
//!
//! From `relayout` to `scatter` they run on the threads of the [`Schedule`], and give the same bits for any number of them; `par_iter` is rayon's.
//!
//! # Kernels
//!
//! | parameter | what it is |
//! | --- | --- |
//! | `&Field<R, _, X>`, `&mut Field<R, _, X>` | a field: `_` stands for any layout, a named layout pins it, a type parameter `L` relates several |
//! | `&Member<T, _, X>`, `&mut Member<T, _, X>` | values `T` of any record: called with `&grid.members().mass`, `&mut grid.members_mut().mass`, or a bare field (see [`AnyMember`]). Members of one record may be handed in together |
//! | `&[T]`, `&mut [T]` | a slice, which is a field over one axis where a loop runs over it, writes it, or indexes it by the variables of a field's loop, and an ordinary value elsewhere |
//! | `#[field] grid: &mut Grid` | a field whose type has another name |
//! | anything else | an ordinary Rust value |
//!
//! Each outermost `for` of the body is one parallel launch, run to its end before the next statement; all else at the top level
//! is ordinary serial Rust. A kernel is a plain function: it may be a method, be generic and return a value.
//! With `T: Real` (see [`Real`]) one kernel serves `f32` and `f64`; records, elements, axes, layouts and constants may be type parameters too, and
//! `_` leaves the turbofish to them.
//! [`spatial`] does the same for plane and space.
//!
//! Any Rust function may be called on values. One that is marked [`#[func]`](macro@func) may also read members: it takes them as `Read<T, _, X>` and
//! indexes them, and in a loop that does not change them they are handed on as they are, `bilinear(grid.density, x)`, or `bilinear(u, x)` for a bare field
//! (see [`Readable`]).
//!
//! | loop head | runs over |
//! | --- | --- |
//! | `for p in points`, `for ij in grid`, `for (i, j) in grid` | the field's elements, each thread in the order in which they lie in memory. The index is `i32`, `IVec2`, `IVec3` or `IVec4`, or a tuple of `i32` |
//! | `for ij in grid.m` | the same in the order of the branch in which `m` stands (see [`Both`](layout::Both)); parts of it likewise: `grid.m.interior(1)` |
//! | `for (i, j) in grid.interior(1)`, `grid.border(1)` | all but a border of that width; the border alone |
//! | `for (i, j) in grid.checkerboard(0)` | the elements whose coordinates' sum has that parity, 0 or 1 |
//! | `for (i, j) in grid.colored(2, c)` | those whose coordinates modulo 2 spell `c`, the first axis most significant |
//! | `for (i, j) in grid.interior(1).checkerboard(c)` | heads combine: a colour of an interior or of a border |
//! | `for i in 0..n`, `for (i, j) in ndrange!(0..n, 0..m)` | a range, without a field |
//! | `for q in near.row(p)` | inner loops only: a list's entries, as whole indices |
//! | `for (a, b) in unroll!(0..3, 0..3)` | inner loops only: constants, unrolled at compile time |
//! | `for offset in unroll!(X, 0..3)` | the same over all axes of the type parameter `X`, see [`spatial`] |
//! | `#[serial] for ..` | any iterator, on one thread, with any access |
//! | `#[ordered] for t in 0..n` | any iterator, turn after turn; its body is top level: the loops in it are launches |
//!
//! Inner loops, `if`, `match`, `while`, closures and calls of functions on values are plain Rust. `continue` skips an element.
//!
//! `u[(i, j)]` reads an element, and an index outside of the field is a panic. These read by a boundary rule instead:
//!
//! | read | at an index outside |
//! | --- | --- |
//! | `u.clamped((i - 1, j))`, `grid.v.clamped(..)` | the nearest element |
//! | `u.wrapped((i - 1, j))` | the element at the index modulo the extents: the field is periodic |
//! | `u.or((i - 1, j), value)` | `value` |
//!
//! A variable of the top level that a parallel loop only accumulates into is a reduction: a number, vector, matrix or array, also
//! by components and entries, `centre.x += x`, `bins[k] += 1`. Each entry of a tuple is a reduction of its own, so that `range.0.min_assign(x)`
//! stands beside `range.1.max_assign(x)`. Reductions have a fixed order, and so they give the same bits for any number of
//! threads and any instruction set.
//!
//! [`random::<f32>(seed, key)`](random) is a function of its arguments alone, so that it gives the same numbers for any number of threads.
//!
//! # What a loop may do to a field
//!
//! For each member the kernel finds how a loop uses it, and the loop gets a view of the member that can do this and no more. The first row that
//! fits holds.
//!
//! | the loop | at | view |
//! | --- | --- | --- |
//! | only reads it | any index | read |
//! | reads, writes, accumulates | its own index | own |
//! | also reads it, under `checkerboard` | its own index plus constants with an odd sum: the other colour | beside |
//! | only accumulates, with one group of operators: {`+=`, `-=`}, {`*=`}, {`min_assign`}, {`max_assign`}, {`&=`}, {`\|=`}, {`^=`} | any index | accumulate |
//! | only `fetch_add`, `fetch_sub`, `fetch_min`, `fetch_max`, `fetch_or`, `fetch_and`, `fetch_xor`, `swap`, `compare_exchange`, which return the old value of an integer (the last five of a `bool` too) | any index | together |
//! | anything else | | a compile error, which names the other access that it clashes with, and the cure |
//!
//! Activity is of a field, or of the branch of a member. A loop that makes elements of a field active at foreign indices asks for it (`is_active`, `row`, `len`) at its own index alone
//! ([A0227](errors::A0227)), and beside `append` it accesses what is its own: the elements that it runs over, and the entries of its own list ([A0226](errors::A0226)).
//!
//! An index is a loop's own when each loop variable stands alone in a place of it: `p`, `ij`, `(j, i)`, `(i, 0)`, and `(i, k)` with any `k`. These are refused, among others:
//!
//! | refused | why | write instead |
//! | --- | --- | --- |
//! | `u[i] = u[i - 1]` | whether the neighbour is old or new depends on the threads | read one field and write another ([A0201](errors::A0201)) |
//! | `b[perm[i]] = a[i]` | several iterations may write one element | a gather, or `+=` ([A0202](errors::A0202)) |
//! | `m[q] += m[0]` | the value read is a part of a sum | two loops ([A0203](errors::A0203)) |
//! | `let old = (m[q] += 1)` | a sum may be put off until the loop ends | `m[q].fetch_add(1)` ([A0210](errors::A0210)) |
//! | `total += 1.0; if total > 9.0 { .. }` | a thread knows only its part of the sum | read it after the loop ([A0217](errors::A0217)) |
//! | `break`, `return`, `?` | other iterations are on their way | `continue` ([A0116](errors::A0116)) |
//!
//! Each error has a code with a page in [`errors`]. Indices are checked: constant offsets once a launch, the
//! unrolled stencil around a computed index once, others each time. An index out of range panics with kernel, field, index, shape and
//! source line, after the other threads have stopped.
//!
//! The ways out are written where they are taken: `#[serial]` before a loop; `#[relaxed]` before a loop in which any order will do: where
//! iterations meet in an element, each component is read, written or accumulated into in one step, which is defined behaviour, and
//! `+=` loses nothing, but what is seen depends on the threads, and vectors and records may be seen half changed; `unsafe { u.get_unchecked(i) }` and `unsafe { u.set_unchecked(i, value) }`,
//! which neither check the index nor ask who else touches the element; and `#[kernel(unchecked)]`, which makes the kernel an `unsafe fn` whose
//! callers promise that all indices in its parallel loops lie within their fields. With debug assertions they are checked all the same.
//!
//! ```
//! use allotrope::prelude::*;
//!
//! /// Takes every value from where `order` says.
//! ///
//! /// # Safety
//! /// `order` holds indices of `from`, and is as long as `to`.
//! #[kernel(unchecked)]
//! fn gather(from: &Field<f32, _>, order: &Field<u32, _>, to: &mut Field<f32, _>) {
//!     for p in to {
//!         to[p] = from[order[p]];
//!     }
//! }
//!
//! let from = Field::<f32, Soa>::new([8]).with_background(2.0);
//! let order = Field::<u32, Soa>::new([100]).with_background(7);
//! let mut to = Field::<f32, Soa>::new([100]);
//! // SAFETY: `from` has an element 7, and `order` is as long as `to`.
//! unsafe { gather(&from, &order, &mut to) };
//! assert_eq!(to.get(99), 2.0);
//! ```
//!
//! # Rounding
//!
//! Every operation rounds as Rust's does, so that results are the same bits under each instruction set. `#[kernel(contract)]` lets a product that
//! is added to something be rounded once with it: `a * b + c`, `c - a * b`, `sum += a * b`, of floats, their vectors and their matrices, written
//! in a loop's own body, where the processor has an instruction for it. Results then differ in the last bits between instruction sets, and an operand of a type that is
//! not `Copy` is refused. It changes nothing where a kernel is generic over its numbers.
//!
//! ```
//! use allotrope::prelude::*;
//!
//! #[kernel(contract)]
//! fn horner(x: &Field<f32, _>, y: &mut Field<f32, _>) {
//!     for i in y {
//!         y[i] = (0.5 * x[i] + 0.25) * x[i] + 1.0;
//!     }
//! }
//!
//! let x = Field::<f32, Aos>::new([8]);
//! let mut y = Field::<f32, Aos>::new([8]);
//! horner(&x, &mut y);
//! assert_eq!(y.get(3), 1.0);
//! ```
//!
//! # Lanes
//!
//! The compiler makes vectors of a loop whose body computes and stores. Where the body has loops of its own it does not: there `#[kernel(lanes = 16)]`
//! runs 16 neighbouring elements of a row at a time. The body is cut at its `for` and `while` loops, each stretch runs for all lanes before the next, and lanes
//! that have left a loop, or do not enter a branch around one, wait. Each element does what it would do alone, in the same order, so that results are the same
//! bits, and the body stays what it is: any type and function may be used. A direct sum over all pairs of bodies ran 8 times as fast, an
//! escape-time fractal 6 times (AVX-512).
//!
//! ```
//! use allotrope::prelude::*;
//!
//! #[kernel(lanes = 16)]
//! fn rounds(x: &Field<f32, _>, y: &mut Field<u32, _>) {
//!     for i in y {
//!         let (mut value, mut rounds) = (x[i], 0);
//!         while value > 1.0 {
//!             value *= 0.5;
//!             rounds += 1;
//!         }
//!         y[i] = rounds;
//!     }
//! }
//!
//! let x = Field::<f32, Soa>::new([100]).with_background(5.0);
//! let mut y = Field::<u32, Soa>::new([100]);
//! rounds(&x, &mut y);
//! assert_eq!(y.get(3), 3);
//! ```
//!
//! Numbers of lanes are 4, 8, 16, 32 and 64; 16 is a good start. Rows shorter than that, and the rest of longer ones, go one by one. Loops over what is the same for all
//! elements gain most; a range of each element's own (`0..count[i]`) lasts as long as its longest lane, and loops over anything else, or with `break` and
//! `continue`, run lane after lane. Variables that are kept from one stretch to the next are elements (or `usize`). A loop in lanes
//! [accumulates into no field](crate::errors::A0125).
//!
//! # Schedules
//!
//! A [`Schedule`] says how launches run; results but for rounding do not depend on it. It holds for calls in a closure,
//! `schedule.run(|| ..)`. An attribute sets the strategy of one loop: `#[scatter(Private)] for p in points { .. }`.
//!
//! | [`Scatter`] | how elements that many iterations accumulate into are updated |
//! | --- | --- |
//! | `Serial` | on one thread, plainly |
//! | `Private` | each job into a copy of its own; the copies are combined in a fixed order |
//! | `Colored` | elements are sorted by the tile of the field that they update; tiles that cannot meet run at the same time, with plain updates |
//! | `Atomic` | by compare-and-swap on each component |
//! | `Auto` | the default: one of these, chosen from threads, extents, work, and the order of what is updated |
//!
//! `Colored` needs a key, which tells where an element updates before it does. Kernels find it where an index is built from `let`s at the top of
//! the loop's body that call nothing but what is known to compute alone, or anything under `#[scatter(Colored)]`: they run twice then. Or it is given, `#[scatter(Colored, key = cell(points.x[p]), reach = 2)]`. The
//! key may be wrong: what lies beyond the reach is kept and updated in the end. A loop without a key is `Private` instead.
//!
//! With `deterministic` these results too are the same bits for any number of threads; `Atomic`, `#[relaxed]` and what returns old values are refused then.
//!
//! A schedule has no switch that flushes denormal numbers to zero: Rust takes the processor's floating-point mode to be the default one, so that
//! changing it around Rust code is undefined behaviour even where it is put back. [`Real::flushed`] does it where it is called.
//!
//! | environment variable | sets |
//! | --- | --- |
//! | `ALLOTROPE_THREADS` | the number of threads, where the schedule does not; else all that the machine has |
//! | `ALLOTROPE_CPU` | the instruction set: `baseline`, `avx2` or `avx512`, where the schedule does not; else the best that the machine has |

// Expansions name this crate from outside; inside (tests, examples in docs) it is the same name.
extern crate self as allotrope;

mod axes;
#[cfg(doctest)]
pub mod book;
mod capture;
mod contract;
mod element;
mod enumeration;
pub mod errors;
mod exchange;
mod field;
mod index;
mod launch;
pub mod layout;
mod number;
pub mod probe;
mod random;
mod real;
mod record;
mod scatter;
mod schedule;
mod serial;
pub mod spatial;
mod store;
mod unchecked;
mod view;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
pub mod prelude;

pub use allotrope_macros::{Element, Record, func, kernel, layout};
pub use axes::{Axes, I, Ij, Ijk, Ijkl, O, Shape};
pub use element::{Element, Scalar};
pub use enumeration::{Enumeration, Representation};
pub use field::{
    Allocation, AnyMember, AnyMemberMut, Entries, Field, FileError, FileFault, ListFull, MapMember, Member, MemberMut,
    MemoryMap, NonFinite, OutOfRange, ParallelRecords, Permutation, PermutationError, Records, ScanOverflow,
    ShapeError, ShapeMismatch, Source, SourceMut, Span, Standing,
};
pub use index::{Integer, IntoIndex};
pub use launch::cpu::Cpu;
pub use layout::Layout;
pub use random::{Random, RandomKey, random};
pub use real::Real;
pub use record::{MAX_MEMBERS, Record};
pub use schedule::{MAX_THREADS, Scatter, Schedule};
pub use view::Readable;

/// The examples of the README, compiled and run as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
