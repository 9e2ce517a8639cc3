//! Fields of lists: random operations beside vectors, order, overflow, files.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use allotrope::layout::ListLayout;
use allotrope::prelude::*;
use allotrope::{Axes, IntoIndex};

use super::Numbers;

const OPERATIONS: usize = if cfg!(allotrope_sanitized) { 1_000 } else { 5_000 };

#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Entry {
    id: u32,
    place: Vec2,
}

/// Appends one entry for each of some lists.
#[kernel]
fn spread<X: Axes<Outer = Y>, Y: Axes>(targets: &[u32], lists: &mut Field<Entry, _, X>, places: &[Y::Index]) {
    for t in targets {
        lists.append(places[targets[t] as usize], Entry { id: t as u32, place: Vec2::ZERO });
    }
}

/// Adds to every entry, takes out those of even numbers and counts what is there.
#[kernel]
fn sift<X: Axes>(lists: &mut Field<Entry, _, X>, by: u32) -> u64 {
    let mut visited = 0u64;
    for e in lists {
        lists.id[e] += by;
        visited += 1;
        if lists.id[e].is_multiple_of(2) {
            lists.remove(e);
        }
    }
    visited
}

fn index<X: Axes>(at: [i64; 4]) -> X::Index {
    use std::any::Any;
    let [i, j, k, l] = at.map(|c| c as i32);
    let all: [Box<dyn Any>; 5] =
        [Box::new(()), Box::new(i), Box::new(ivec2(i, j)), Box::new(ivec3(i, j, k)), Box::new(IVec4::new(i, j, k, l))];
    *all.into_iter().nth(X::RANK).expect("four axes").downcast::<X::Index>().expect("the axes' index")
}

/// The index of an entry.
fn entry<X: Axes>(mut list: [i64; 4], n: usize) -> X::Index {
    list[X::RANK - 1] = n as i64;
    index::<X>(list)
}

fn run<L: ListLayout<X>, X: Axes<Outer = Y>, Y: Axes>(
    name: &str,
    mut lists: Field<Entry, L, X>,
    spread_over: &[i64],
    most: usize,
) {
    let seed = name.bytes().fold(91u64, |seed, byte| seed.wrapping_mul(31).wrapping_add(byte.into()));
    println!("{name}: seed {seed}");
    let mut numbers = Numbers(seed);
    let places: Vec<[i64; 4]> = (0..if X::RANK == 1 { 1 } else { 12 })
        .map(|_| {
            std::array::from_fn(|a| if a + 1 < X::RANK { numbers.below(spread_over[a] as usize) as i64 } else { 0 })
        })
        .collect();
    let indices: Vec<Y::Index> = places.iter().map(|&at| index::<Y>(at)).collect();
    let mut model: BTreeMap<[i64; 4], Vec<Entry>> = BTreeMap::new();
    for operation in 0..OPERATIONS {
        let place = numbers.below(places.len());
        let (at, outer) = (places[place], indices[place]);
        let list = model.entry(at).or_default();
        let new = Entry { id: operation as u32, place: vec2(1.0, operation as f32) };
        match numbers.below(100) {
            0..35 => match lists.try_append(outer, new) {
                Ok(position) => {
                    assert_eq!(position, list.len());
                    list.push(new);
                }
                Err(full) => assert_eq!((list.len(), full.most), (most, most)),
            },
            35..45 => assert_eq!(lists.row_len(outer), list.len()),
            45..60 => {
                let rows: Vec<Entry> = lists.row(outer).map(|e| lists.get(e)).collect();
                assert_eq!(rows, *list);
            }
            60..70 if !list.is_empty() => {
                let n = numbers.below(list.len());
                lists.remove(entry::<X>(at, n));
                list.remove(n);
            }
            70..75 => {
                // A write behind the end makes what is before it active, too.
                let n = numbers.below(most);
                lists.set(entry::<X>(at, n), new);
                if list.len() <= n {
                    list.resize(n + 1, Entry::default());
                }
                list[n] = new;
            }
            75..80 => {
                let n = numbers.below(most);
                assert_eq!(lists.get(entry::<X>(at, n)), list.get(n).copied().unwrap_or_default());
                assert_eq!(lists.is_active(entry::<X>(at, n)), n < list.len());
            }
            80..85 => {
                let targets: Vec<u32> = (0..numbers.below(20)).map(|_| numbers.below(places.len()) as u32).collect();
                let count = |at: [i64; 4]| targets.iter().filter(|&&t| places[t as usize] == at).count();
                let fits = places.iter().all(|&at| model.get(&at).map_or(0, Vec::len) + count(at) <= most);
                if fits {
                    let deterministic = Schedule { deterministic: true, threads: 3, grain: 2, ..Schedule::default() };
                    deterministic.run(|| spread(&targets, &mut lists, &indices));
                    for (n, &t) in targets.iter().enumerate() {
                        let entry = Entry { id: n as u32, place: Vec2::ZERO };
                        model.entry(places[t as usize]).or_default().push(entry);
                    }
                }
            }
            85..88 => {
                let by = numbers.below(3) as u32;
                assert_eq!(sift(&mut lists, by), model.values().map(Vec::len).sum::<usize>() as u64);
                for list in model.values_mut() {
                    list.iter_mut().for_each(|entry| entry.id += by);
                    list.retain(|entry| entry.id % 2 == 1);
                }
            }
            88..90 => {
                lists.truncate(most / 2);
                model.values_mut().for_each(|list| list.truncate(most / 2));
            }
            90..92 => {
                lists.retain(|entry| entry.id % 3 != 0);
                model.values_mut().for_each(|list| list.retain(|entry| entry.id % 3 != 0));
            }
            92..93 => {
                lists.clear();
                model.clear();
            }
            93..95 => lists.prune(),
            95..96 => lists = lists.clone(),
            _ => {
                assert_eq!(lists.active_len(), model.values().map(Vec::len).sum::<usize>());
                let mut expected = Vec::new();
                for (&at, list) in &model {
                    expected.extend(list.iter().enumerate().map(|(n, &record)| (entry::<X>(at, n), record)));
                }
                expected.sort_by_key(|(at, _)| IntoIndex::<X>::coordinates(*at));
                assert!(lists.active_iter().eq(expected));
            }
        }
    }
}

macro_rules! lists {
    ($($name:ident: $field:expr, $spread:expr, $most:expr;)*) => {$(
        #[test]
        fn $name() {
            run(stringify!($name), $field, &$spread, $most);
        }
    )*};
}
lists! {
    dynamic: Field::<Entry, layout!(dynamic(i, 50).aos)>::new([]), [], 50;
    dynamic_in_chunks: Field::<Entry, layout!(dynamic(i, 50, chunk = 8).soa)>::new([]), [], 50;
    dense_dynamic: Field::<Entry, layout!(dense(i).dynamic(j, 9).aos)>::new([30]), [30], 9;
    blocks_of_dynamic: Field::<Entry, layout!(dense(ij).dense(ij, 4).dynamic(k, 9, chunk = 4).split)>::new([9, 9]), [9, 9], 9;
    pointer_dynamic: Field::<Entry, layout!(pointer(ij).dynamic(k, 7).aos)>::new([9, 9]), [9, 9], 7;
    pointer_dense_dynamic: Field::<Entry, layout!(pointer(ij, 4).dense(ij, 2).dynamic(k, 20, chunk = 3).aos)>::new([9, 9]), [9, 9], 20;
    morton_dynamic: Field::<Entry, layout!(morton(ij, 4).dynamic(k, 7).aos)>::new([9, 9]), [9, 9], 7;
    bitmasked_dynamic: Field::<Entry, layout!(bitmasked(ij, 4).dynamic(k, 7).soa)>::new([9, 9]), [9, 9], 7;
    hash_dynamic: Field::<Entry, layout!(hash(ij).dynamic(k, 7).aos), Ijk>::unbounded(), [1000, 1000], 7;
    hash_pointer_dynamic: Field::<Entry, layout!(hash(i).pointer(i, 4).dynamic(j, 30, chunk = 8).aos), Ij>::unbounded(), [1000], 30;
}

#[test]
fn parallel_appends_take_each_place_once() {
    let targets: Vec<u32> = (0..40_000).map(|n| n % 7).collect();
    let places: Vec<i32> = (0..7).collect();
    for threads in [1, 2, 5] {
        let mut lists = Field::<Entry, layout!(dense(i).dynamic(j, 10_000, chunk = 64).aos)>::new([7]);
        Schedule { threads, grain: 100, ..Schedule::default() }.run(|| spread(&targets, &mut lists, &places));
        for list in 0..7 {
            let mut ids: Vec<u32> = lists.row(list).map(|e| lists.get(e).id).collect();
            ids.sort_unstable();
            let expected: Vec<u32> = (0..40_000).filter(|n| n % 7 == list as u32).collect();
            assert_eq!(ids, expected);
        }
    }
}

#[test]
fn a_full_list_is_an_error_that_names_it() {
    let mut lists = Field::<Entry, layout!(dense(i).dynamic(j, 3).aos)>::new([7]);
    let append = || spread(&[4, 4, 4, 4], &mut lists, &[0, 1, 2, 3, 4]);
    let error = catch_unwind(AssertUnwindSafe(append)).expect_err("the list is full");
    let text = error.downcast_ref::<String>().expect("a text");
    assert!(
        text.contains(
            "kernel `spread`: `append` to the field `lists`: the list at [4] holds 3 entries, which is the maximum"
        ),
        "{text}"
    );
    assert_eq!(lists.row_len(4), 3, "the entries so far stay");
}

#[test]
fn extents_and_origins_of_lists() {
    type Bins = layout!(dense(i).dynamic(j, 3).aos);
    let bins = Field::<u8, Bins>::new([7]).with_origin([-3, 0]);
    assert_eq!(bins.shape(), [7, 3]);
    assert_eq!(bins.row_len(-3), 0);
    let error = Field::<u8, Bins>::new([7]).try_with_origin([0, 1]).expect_err("entries are counted from zero");
    assert_eq!(error.to_string(), "the entries of lists, along axis `j`, are counted from zero");
    let error = Field::<u8, Bins>::try_new([7, 3]).expect_err("one extent too many");
    assert_eq!(
        error.to_string(),
        "axis `j` is that of lists, whose maximum the layout gives: leave it out of the extents"
    );
}

#[test]
fn lists_are_sorted_saved_and_loaded() {
    let mut queue = Field::<Entry, layout!(dynamic(i, 1000, chunk = 16).soa)>::new([]);
    for n in [5, 3, 9, 1, 7, 0] {
        queue.append((), Entry { id: n, place: vec2(n as f32, 0.0) });
    }
    let order = queue.reorder_by_key(|entry| entry.id);
    assert_eq!(order.old_places(), [5, 3, 1, 0, 4, 2]);
    assert!(queue.active_iter().map(|(_, entry)| entry.id).eq([0, 1, 3, 5, 7, 9]));
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("queue.npz");
    queue.save(&path).expect("saved");
    let mut again = Field::<Entry, layout!(dynamic(i, 1000).aos)>::new([]);
    again.append((), Entry::default());
    again.load(&path).expect("loaded");
    assert!(again.active_iter().eq(queue.active_iter()));
    let mut dense = Field::<Entry, Aos>::new([1000]);
    dense.load(&path).expect("loaded");
    assert_eq!((dense.get(4).id, dense.get(500).id), (7, 0));
}
