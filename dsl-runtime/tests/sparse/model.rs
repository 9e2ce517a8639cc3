//! Random operations on fields in many layouts, each beside a map from indices to records that does the same.

use std::collections::{BTreeMap, BTreeSet};

use allotrope::layout::Layout;
use allotrope::prelude::*;
use allotrope::{Axes, IntoIndex};

use super::Numbers;

/// Operations on each layout: a million in all; fewer where each is watched.
const OPERATIONS: usize = if cfg!(allotrope_sanitized) { 1_500 } else { 30_000 };

#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Cell {
    count: i32,
    place: Vec2,
    kind: u8,
}

const BACKGROUND: Cell = Cell { count: -3, place: Vec2::new(0.5, 2.0), kind: 7 };

#[kernel]
fn bump<X: Axes>(field: &mut Field<Cell, _, X>, by: i32) -> i64 {
    let mut visited = 0i64;
    for q in field {
        field.count[q] += by;
        field.place[q].y = 1.0;
        visited += 1;
    }
    visited
}

#[kernel]
fn scatter<X: Axes>(targets: &[u32], field: &mut Field<Cell, _, X>, places: &[X::Index]) {
    for t in targets {
        let q = places[targets[t] as usize];
        field.count[q] += 2;
    }
}

#[kernel]
fn topology<X: Axes>(targets: &[u32], field: &mut Field<Cell, _, X>, places: &[X::Index]) -> i64 {
    let mut active = 0i64;
    for t in targets {
        if field.is_active(places[targets[t] as usize]) {
            active += 1;
        }
    }
    for t in targets {
        let q = places[targets[t] as usize];
        if targets[t].is_multiple_of(2) { field.activate(q) } else { field.deactivate(q) }
    }
    active
}

#[kernel]
fn thin<X: Axes>(field: &mut Field<Cell, _, X>) {
    for q in field.interior(1) {
        if field.count[q] % 5 == 0 {
            field.deactivate(q);
        }
    }
}

/// What a field should be: which groups of cells are active, and what cells of them hold that is not the background.
struct Model {
    active: BTreeSet<[i64; 4]>,
    cells: BTreeMap<[i64; 4], Cell>,
    /// Cells that are active together, along each axis.
    group: [i64; 4],
    origin: [i64; 4],
    shape: [i64; 4],
    rank: usize,
}

impl Model {
    fn group(&self, at: [i64; 4]) -> [i64; 4] {
        std::array::from_fn(|a| (at[a] - self.origin[a]).div_euclid(self.group[a]))
    }
    fn get(&self, at: [i64; 4]) -> Cell {
        self.cells.get(&at).copied().unwrap_or(BACKGROUND)
    }
    fn set(&mut self, at: [i64; 4], cell: Cell) {
        self.active.insert(self.group(at));
        self.cells.insert(at, cell);
    }
    fn is_active(&self, at: [i64; 4]) -> bool {
        self.active.contains(&self.group(at))
    }
    fn deactivate(&mut self, group: [i64; 4]) {
        self.active.remove(&group);
        let cells = std::mem::take(&mut self.cells);
        self.cells = cells.into_iter().filter(|(at, _)| self.group(*at) != group).collect();
    }
    /// The active cells within the shape, in row-major order.
    fn all(&self) -> Vec<[i64; 4]> {
        let mut all = Vec::new();
        for group in &self.active {
            let along = |a: usize| {
                let first = self.origin[a] + group[a] * self.group[a];
                first..(first + self.group[a]).min(self.origin[a] + self.shape[a])
            };
            for i in along(0) {
                for j in along(1) {
                    for k in along(2) {
                        all.extend(along(3).map(|l| [i, j, k, l]));
                    }
                }
            }
        }
        all.sort_unstable();
        all
    }
}

fn index<X: Axes>(at: [i64; 4]) -> X::Index {
    use std::any::Any;
    let [i, j, k, l] = at.map(|c| c as i32);
    let all: [Box<dyn Any>; 5] =
        [Box::new(()), Box::new(i), Box::new(ivec2(i, j)), Box::new(ivec3(i, j, k)), Box::new(IVec4::new(i, j, k, l))];
    *all.into_iter().nth(X::RANK).expect("four axes").downcast::<X::Index>().expect("the axes' index")
}

fn check<L: Layout<X>, X: Axes>(field: &Field<Cell, L, X>, model: &Model, places: &[[i64; 4]]) {
    let expected = model.all();
    let found: Vec<([i64; 4], Cell)> =
        field.active_iter().map(|(q, cell)| (IntoIndex::<X>::coordinates(q), cell)).collect();
    assert_eq!(found.iter().map(|(at, _)| *at).collect::<Vec<_>>(), expected, "the active elements");
    assert_eq!(field.active_len(), expected.len());
    for (at, cell) in found {
        assert_eq!(cell, model.get(at), "at {at:?}");
    }
    for &at in places {
        assert_eq!(field.get(index::<X>(at)), model.get(at), "at {at:?}");
        assert_eq!(field.is_active(index::<X>(at)), model.is_active(at), "at {at:?}");
    }
}

/// Runs random operations; `group` are the cells that are active together.
fn run<L: Layout<X>, X: Axes>(name: &str, field: Field<Cell, L, X>, group: [i64; 4], spread: i64) {
    let seed = name.bytes().fold(17u64, |seed, byte| seed.wrapping_mul(31).wrapping_add(byte.into()));
    println!("{name}: seed {seed}");
    let mut numbers = Numbers(seed);
    let mut field = field.with_background(BACKGROUND);
    let rank = X::RANK;
    let origin = IntoIndex::<X>::coordinates(field.origin());
    let shape = std::array::from_fn(|a| field.shape().as_ref().get(a).map_or(1, |&n| n as i64));
    let mut model = Model { active: BTreeSet::new(), cells: BTreeMap::new(), group, origin, shape, rank };
    // Places that operations choose from: in a bounded field all over it, else around zero.
    let unbounded = shape[0] > 1 << 30;
    let places: Vec<[i64; 4]> = (0..60)
        .map(|_| {
            std::array::from_fn(|a| match a {
                _ if a >= model.rank => 0,
                _ if unbounded => numbers.below(2 * spread as usize) as i64 - spread,
                _ => origin[a] + numbers.below(shape[a] as usize) as i64,
            })
        })
        .collect();
    let indices: Vec<X::Index> = places.iter().map(|&at| index::<X>(at)).collect();
    for operation in 0..OPERATIONS {
        let at = places[numbers.below(places.len())];
        let targets: Vec<u32> = (0..numbers.below(40)).map(|_| numbers.below(places.len()) as u32).collect();
        match numbers.below(1000) {
            0..400 => {
                let cell = Cell { count: numbers.below(100) as i32, place: vec2(operation as f32, 0.0), kind: 1 };
                field.set(index::<X>(at), cell);
                model.set(at, cell);
            }
            400..650 => assert_eq!(field.get(index::<X>(at)), model.get(at)),
            650..750 => assert_eq!(field.is_active(index::<X>(at)), model.is_active(at)),
            750..800 => {
                field.activate(index::<X>(at));
                model.active.insert(model.group(at));
            }
            800..950 => {
                field.deactivate(index::<X>(at));
                model.deactivate(model.group(at));
            }
            950..960 => {
                let by = numbers.below(7) as i32;
                assert_eq!(bump(&mut field, by), model.all().len() as i64);
                for at in model.all() {
                    let cell = model.get(at);
                    model.set(at, Cell { count: cell.count + by, place: vec2(cell.place.x, 1.0), ..cell });
                }
            }
            960..975 => {
                scatter(&targets, &mut field, &indices);
                for &t in &targets {
                    let (at, cell) = (places[t as usize], model.get(places[t as usize]));
                    model.set(at, Cell { count: cell.count + 2, ..cell });
                }
            }
            975..985 => {
                // Activation comes at once, deactivation at the end.
                let active = targets.iter().filter(|&&t| model.is_active(places[t as usize])).count();
                assert_eq!(topology(&targets, &mut field, &indices), active as i64);
                for &t in targets.iter().filter(|&&t| t % 2 == 0) {
                    model.active.insert(model.group(places[t as usize]));
                }
                for &t in targets.iter().filter(|&&t| t % 2 == 1) {
                    model.deactivate(model.group(places[t as usize]));
                }
            }
            985..988 => {
                thin(&mut field);
                let inside = |at: &[i64; 4]| (0..rank).all(|a| at[a] > origin[a] && at[a] + 1 < origin[a] + shape[a]);
                for at in model
                    .all()
                    .into_iter()
                    .filter(inside)
                    .filter(|at| model.get(*at).count % 5 == 0)
                    .collect::<Vec<_>>()
                {
                    model.deactivate(model.group(at));
                }
            }
            988..990 => {
                field.clear();
                (model.active, model.cells) = Default::default();
            }
            990..992 => {
                field.prune();
                // What is held still reads the same; what is given back held the background.
                for at in &model.all() {
                    assert!(field.is_active(index::<X>(*at)) || model.get(*at) == BACKGROUND);
                }
                let kept: BTreeSet<_> = model
                    .active
                    .iter()
                    .copied()
                    .filter(|group| {
                        let first: [i64; 4] = std::array::from_fn(|a| origin[a] + group[a] * model.group[a]);
                        field.is_active(index::<X>(first))
                    })
                    .collect();
                model.active = kept;
                let active = &model.active;
                let group = |at: &[i64; 4]| {
                    std::array::from_fn::<i64, 4, _>(|a| (at[a] - origin[a]).div_euclid(model.group[a]))
                };
                model.cells.retain(|at, _| active.contains(&group(at)));
            }
            992..994 => field = field.clone(),
            994..996 => {
                field.fill(Cell { count: 1, ..Cell::default() });
                for at in model.all() {
                    model.set(at, Cell { count: 1, ..Cell::default() });
                }
            }
            996..998 => {
                let sum = field.map_reduce(|cell| i64::from(cell.count), 0, |a, b| a + b);
                assert_eq!(sum, model.all().into_iter().map(|at| i64::from(model.get(at).count)).sum::<i64>());
            }
            _ => check(&field, &model, &places),
        }
    }
    check(&field, &model, &places);
}

/// Each layout, on one thread and on three, in every schedule that takes turns.
macro_rules! layouts {
    ($($name:ident: $axes:ty, $shape:expr, $group:expr, $layout:expr;)*) => {$(
        #[test]
        fn $name() {
            let threads = 1 + 2 * (stringify!($name).len() % 2);
            let scatter = [Scatter::Auto, Scatter::Private, Scatter::Serial, Scatter::Atomic][stringify!($name).len() % 4];
            Schedule { threads, scatter, grain: 4, ..Schedule::default() }.run(|| {
                run(stringify!($name), $shape, $group, 60);
            });
        }
    )*};
}

macro_rules! bounded {
    ($($name:ident: $shape:expr, $group:expr, [$($layout:tt)*];)*) => {
        layouts! { $($name: (), Field::<Cell, layout!($($layout)*)>::new($shape), $group, ();)* }
    };
}
macro_rules! unbounded {
    ($($name:ident: $axes:ty, $group:expr, [$($layout:tt)*];)*) => {
        layouts! { $($name: (), Field::<Cell, layout!($($layout)*), $axes>::unbounded(), $group, ();)* }
    };
}

// Under the sanitizers, which compile slowly, the first of each.
bounded! {
    bitmasked: [37, 90], [1, 1, 1, 1], [bitmasked(ij).aos];
    pointer_bitmasked: [64, 64], [1, 1, 1, 1], [pointer(ij, 4).bitmasked(ij, 8).soa];
    four_axes: [9, 8, 7, 6], [2, 2, 2, 2], [pointer(ijkl, 2).dense(ijkl, 2).aos];
}
#[cfg(not(allotrope_sanitized))]
bounded! {
    pointer_dense: [50, 41], [8, 8, 1, 1], [pointer(ij).dense(ij, 8).aos];
    pointer_pointer_dense: [70, 50], [2, 2, 1, 1], [pointer(ij, 4).pointer(ij, 4).dense(ij, 2).aos];
    pointer: [37, 20], [1, 1, 1, 1], [pointer(ij).aos];
    pointer_sized: [100], [1, 1, 1, 1], [pointer(i, 7).soa];
    bitmasked_sized: [30, 17, 5], [1, 1, 1, 1], [bitmasked(ijk, (4, 8, 2)).split];
    pointer_dense_odd: [50, 41], [5, 7, 1, 1], [pointer(ij, 3).dense(ij, (5, 7)).soa];
    pointer_pointer: [50, 41], [1, 1, 1, 1], [pointer(ij, 4).pointer(ij, 3).aos];
    pointer_morton: [40, 40], [4, 4, 1, 1], [pointer(ij, 2).morton(ij, 4).aos];
    dense_pointer: [30, 30], [1, 1, 1, 1], [dense(ij, 4).pointer(ji, 2).split];
    dense_bitmasked: [30, 30], [1, 1, 1, 1], [dense(ij).bitmasked(ij, 4).aos];
    morton_pointer: [30, 30], [1, 1, 1, 1], [morton(ij, 4).pointer(ij, 2).aos];
    morton_bitmasked: [30, 30], [1, 1, 1, 1], [morton(ij, 4).bitmasked(ij, 2).aos];
    bitmasked_dense: [30, 30], [2, 3, 1, 1], [bitmasked(ij).dense(ij, (2, 3)).aos];
    bitmasked_pointer: [30, 30], [1, 1, 1, 1], [bitmasked(ij, 4).pointer(ij, 2).aos];
    bitmasked_bitmasked: [30, 30], [1, 1, 1, 1], [bitmasked(ij, 4).bitmasked(ij, 2).aos];
    bitmasked_morton: [30, 30], [4, 4, 1, 1], [bitmasked(ij, 4).morton(ij, 4).soa];
    pointer_bitmasked_dense: [70, 50], [2, 2, 1, 1], [pointer(ij, 4).bitmasked(ij, 4).dense(ij, 2).aos];
    pointer_dense_bitmasked: [40, 40], [1, 1, 1, 1], [pointer(ij, 4).dense(ij, 2).bitmasked(ij, 4).soa];
    pointer_dense_pointer: [40, 40], [1, 1, 1, 1], [pointer(ij, 4).dense(ij, 2).pointer(ij, 4).aos];
    dense_pointer_dense: [40, 40], [3, 2, 1, 1], [dense(ij, 2).pointer(ij, 3).dense(ij, (3, 2)).aos];
    bitmasked_pointer_bitmasked: [40, 40], [1, 1, 1, 1], [bitmasked(ij, 3).pointer(ij, 3).bitmasked(ij, 3).aos];
    four_axes_bits: [9, 8, 7, 6], [1, 1, 1, 1], [pointer(ijkl, 2).bitmasked(klij, (3, 2, 2, 4)).aos];
    groups: [40, 40], [4, 4, 1, 1], [Cell: pointer(ij, 4).dense(ij, 4).place([count, kind], [split(place)])];
}
unbounded! {
    hash_dense: Ij, [8, 8, 1, 1], [hash(ij).dense(ij, 8).aos];
}
#[cfg(not(allotrope_sanitized))]
unbounded! {
    hash_bitmasked: Ijk, [1, 1, 1, 1], [hash(ijk).bitmasked(ijk, 4).soa];
    hash: Ij, [1, 1, 1, 1], [hash(ij).aos];
    hash_pointer: Ij, [1, 1, 1, 1], [hash(ji).pointer(ij, 4).split];
    hash_morton: I, [4, 1, 1, 1], [hash(i).morton(i, 4).aos];
    hash_pointer_dense: Ij, [3, 5, 1, 1], [hash(ij).pointer(ij, 4).dense(ij, (3, 5)).aos];
    hash_dense_bitmasked: Ij, [1, 1, 1, 1], [hash(ij).dense(ij, 2).bitmasked(ij, 4).aos];
}

#[test]
fn below_zero() {
    let field = Field::<Cell, layout!(pointer(ij, 4).bitmasked(ij, 8).aos)>::new([90, 70]).with_origin([-40, -64]);
    run("below_zero", field, [1, 1, 1, 1], 0);
    let field = Field::<Cell, Sparse<8>>::new([90, 70]).with_origin([-41, 100]);
    run("from_an_odd_origin", field, [8, 8, 1, 1], 0);
}
