//! Memory maps of sparse fields, against what lies in memory.

use std::collections::BTreeMap;

use allotrope::prelude::*;
use allotrope::{MemoryMap, Standing};

#[derive(Record, Clone, Copy, Default)]
struct Cell {
    id: u16,
    x: [f64; 2],
    n: u32,
}

/// A record of which every component tells the element.
fn sample(n: usize) -> Cell {
    Cell { id: n as u16, x: [n as f64 + 0.25, n as f64 + 0.5], n: n as u32 }
}

/// The bytes of member `m`'s components of such a record.
fn expected(n: usize, member: usize, components: std::ops::Range<usize>) -> Vec<u8> {
    let Cell { id, x, n } = sample(n);
    match member {
        0 => id.to_ne_bytes().to_vec(),
        1 => x[components].iter().flat_map(|x| x.to_ne_bytes()).collect(),
        _ => n.to_ne_bytes().to_vec(),
    }
}

/// Every active element stands in the map once, member by member, where memory holds what was put there.
fn check(map: &MemoryMap<'_>, origin: &[i32], elements: &BTreeMap<Vec<i32>, usize>) {
    let mut told: BTreeMap<Vec<i32>, usize> = BTreeMap::new();
    for span in map.spans() {
        let allocation = &map.allocations()[span.allocation];
        assert!(span.bytes.end <= allocation.bytes && span.bytes.end <= allocation.activity.start.max(span.bytes.end));
        let number = elements.get(span.index());
        match span.standing {
            Standing::Active => {
                let number = *number.unwrap_or_else(|| panic!("{:?} is not active", span.index()));
                let address = std::ptr::with_exposed_provenance::<u8>(allocation.address + span.bytes.start);
                // SAFETY: the field holds these bytes while its map borrows it, and they are initialised.
                let bytes = unsafe { std::slice::from_raw_parts(address, span.bytes.len()) };
                assert_eq!(bytes, expected(number, span.member, span.components.clone()), "{span:?}");
                *told.entry(span.index().to_vec()).or_default() += span.bytes.len();
            }
            Standing::Inactive => assert_eq!(number, None, "{span:?}"),
            Standing::Beyond => {
                let ends = origin.iter().zip(map.shape()).map(|(first, &extent)| first + extent as i32);
                assert!(span.index().iter().zip(ends).any(|(&n, end)| n >= end), "{span:?}");
            }
        }
    }
    assert!(told.len() == elements.len() && told.values().all(|&bytes| bytes == 2 + 16 + 4), "{told:?}");
}

macro_rules! check_grids {
    ($($layout:ty;)*) => {$({
        let mut field = Field::<Cell, $layout>::new([37, 50]).with_origin([-5, 3]);
        let mut elements = BTreeMap::new();
        check(&field.memory_map(), &[-5, 3], &elements);
        for (n, at) in [[-5, 3], [-5, 4], [0, 30], [31, 52], [12, 17], [13, 17], [12, 20]].into_iter().enumerate() {
            field.set(at, sample(n + 1));
            elements.insert(at.to_vec(), n + 1);
        }
        // What becomes active with its block holds zeros.
        for (at, _) in field.active_iter() {
            elements.entry(at.to_array().to_vec()).or_insert(0);
        }
        let zeros: Vec<_> = elements.iter().filter(|(_, n)| **n == 0).map(|(at, _)| at.clone()).collect();
        for at in zeros {
            field.set([at[0], at[1]], sample(0));
        }
        let map = field.memory_map();
        check(&map, &[-5, 3], &elements);
        assert_eq!(map.allocations().len(), field.blocks().len());
        let blocks: Vec<Vec<i32>> = field.blocks().map(|first| first.to_array().to_vec()).collect();
        let told: Vec<Vec<i32>> = map.allocations().iter().filter_map(|piece| piece.block.clone()).collect();
        assert_eq!(told, blocks);
        let held: usize = map.allocations().iter().map(|piece| piece.bytes).sum();
        assert_eq!(map.overhead() + held, field.bytes());
    })*};
}

#[test]
fn blocks_lie_where_their_map_says() {
    check_grids! {
        Sparse<4>;
        layout!(pointer(ij, 4).dense(ji, (4, 2)).soa);
        layout!(pointer(ij).bitmasked(ij, 8).split);
        layout!(pointer(ij).bitmasked(ij, 4).dense(ij, 2).soa);
        layout!(dense(ij).pointer(ij, 2).morton(ij, 4).pad(128).aos);
        layout!(bitmasked(ij, 8).aos);
        layout!(Cell: pointer(ij).dense(ij, 4).place([n, id], [split(x)]));
    }
}

#[test]
fn unbounded_fields_and_lists_have_maps() {
    let mut field = Field::<Cell, layout!(hash(ij).bitmasked(ij, 4).soa), Ij>::unbounded();
    let mut elements = BTreeMap::new();
    for (n, at) in [[-1_000_000, 7], [i32::MAX - 1, i32::MIN], [0, 0], [-1, -1]].into_iter().enumerate() {
        field.set(at, sample(n));
        elements.insert(at.to_vec(), n);
    }
    check(&field.memory_map(), &[0, 0], &elements);

    let mut lists = Field::<Cell, layout!(dense(i).dynamic(j, 100, chunk = 8).aos)>::new([5]);
    let mut elements = BTreeMap::new();
    for n in 0..40 {
        let list = (n * n % 7) as i32 % 5;
        let place = lists.append(list, sample(n));
        elements.insert(vec![list, place as i32], n);
    }
    check(&lists.memory_map(), &[0, 0], &elements);
}

#[test]
fn branches_may_be_dense_and_sparse() {
    type Mixed = layout!(Cell: dense(ij).place([x]) + pointer(ij).dense(ij, 4).place([id, n]));
    let mut field = Field::<Cell, Mixed>::new([6, 6]);
    field.set([5, 5], sample(7));
    let map = field.memory_map();
    assert_eq!(map.allocations().iter().map(|piece| piece.block.clone()).collect::<Vec<_>>(), [None, Some(vec![4, 4])]);
    let spans: Vec<_> = map.spans().filter(|span| span.index() == [5, 5]).collect();
    assert_eq!(spans.iter().map(|span| (span.allocation, span.member)).collect::<Vec<_>>(), [(0, 1), (1, 0), (1, 2)]);
    for span in spans {
        let address = map.allocations()[span.allocation].address + span.bytes.start;
        let address = std::ptr::with_exposed_provenance::<u8>(address);
        // SAFETY: as above.
        let bytes = unsafe { std::slice::from_raw_parts(address, span.bytes.len()) };
        assert_eq!(bytes, expected(7, span.member, span.components.clone()));
    }
    let beyond = map.spans().filter(|span| span.standing == Standing::Beyond).count();
    assert_eq!(beyond, 2 * (16 - 4));
}
