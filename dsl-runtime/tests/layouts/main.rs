//! Where layouts put things: addresses against an interpreter of their texts, and values through every way in and out.

mod oracle;
mod records;

use std::collections::HashMap;

use allotrope::__private::byte_offset;
use allotrope::prelude::*;
use allotrope::{Axes, MemoryMap, Shape, Span, Standing};
use records::{Body, Node, Outer, Sample};

/// All elements of a shape in row-major order.
fn elements(shape: &[usize]) -> Vec<Vec<usize>> {
    shape.iter().fold(vec![Vec::new()], |elements, &extent| {
        elements
            .into_iter()
            .flat_map(|element| (0..extent).map(move |n| element.iter().copied().chain([n]).collect()))
            .collect()
    })
}

fn index<X: Axes>(element: &[usize]) -> X::Index {
    X::index(std::array::from_fn(|axis| element.get(axis).map_or(0, |&n| n as i32)))
}

/// What a field shows of itself. Only making it depends on the layout's type, which keeps the test quick to compile; changes of
/// layout, which are much code, are made where `MOVES`.
struct Seen<R: Sample> {
    shape: Vec<usize>,
    bytes: usize,
    /// Of each component of each member of each element.
    offsets: Vec<usize>,
    /// The same from the field's memory map: the element, the member, the component, and where it lies.
    mapped: Vec<(Vec<usize>, usize, usize, usize)>,
    /// The records after `set`, through `get`, `iter`, and the changes of layout there and back.
    records: Vec<Vec<R>>,
}

fn observe<const MOVES: bool, R: Sample, L: Layout<S::X>, S: Shape>(shape: S) -> Seen<R> {
    let mut field = Field::<R, L>::new(shape);
    let elements: Vec<_> = elements(field.shape().as_ref()).iter().map(|element| index::<S::X>(element)).collect();
    for (n, &element) in elements.iter().enumerate() {
        field.set(element, R::sample(n));
    }
    let mut offsets = Vec::new();
    for &element in &elements {
        offsets.extend(R::components().map(|(m, component)| byte_offset(&field, element, m, component)));
    }
    let mapped = mapped(&field.memory_map());
    let got = elements.iter().map(|&element| field.get(element)).collect();
    let mut records = vec![got, field.iter().collect()];
    if const { MOVES } {
        let blocks = field.relayout::<Blocked<3>>();
        records.extend([blocks.iter().collect(), blocks.relayout::<L>().iter().collect()]);
    }
    Seen { shape: field.shape().as_ref().to_vec(), bytes: field.bytes(), offsets, mapped, records }
}

/// What a memory map of a dense field tells, all at once and line by line.
fn mapped(map: &MemoryMap<'_>) -> Vec<(Vec<usize>, usize, usize, usize)> {
    assert_eq!((map.allocations().len(), map.overhead()), (1, 0));
    let spans: Vec<Span> = map.spans().collect();
    let lines = (0..map.bytes()).step_by(64).flat_map(|line| map.spans_in(0, line..line + 64));
    let mut by_lines: Vec<Span> = lines.collect();
    by_lines.dedup();
    assert!(spans == by_lines, "spans of lines");
    let ends = spans.iter().zip(spans.iter().skip(1));
    assert!({ ends }.all(|(a, b)| a.bytes.end <= b.bytes.start), "spans lie one after another");
    let elements = spans.iter().filter(|span| span.standing != Standing::Beyond);
    let components = elements.flat_map(|span| {
        let element: Vec<usize> = span.index().iter().map(|&n| n as usize).collect();
        let bytes = span.bytes.clone().step_by(map.members()[span.member].scalar_bytes);
        let components = span.components.clone().zip(bytes);
        components.map(move |(component, byte)| (element.clone(), span.member, component, byte))
    });
    components.collect()
}

/// One layout, record and shape: addresses as the oracle says, values as they were put, in logical row-major order.
fn check<R: Sample>(text: &str, seen: &Seen<R>) {
    let context = format!("{text} over {:?} of {}", seen.shape, std::any::type_name::<R>());
    let elements = elements(&seen.shape);
    let map = oracle::map(text, &seen.shape, R::MEMBERS);
    assert_eq!(seen.bytes, map.bytes, "bytes of {context}");
    let mut taken = vec![false; seen.bytes];
    let mut offsets = seen.offsets.iter();
    for element in &elements {
        for (m, component) in R::components() {
            let name = R::MEMBERS[m].name;
            let offset = *offsets.next().expect("an offset for each component");
            let expected = map.offsets[&(element.clone(), m, component)];
            assert_eq!(offset, expected, "{name}[{element:?}].{component} in {context}");
            for byte in &mut taken[offset..offset + R::MEMBERS[m].bytes] {
                assert!(!*byte, "{name}[{element:?}].{component} overlaps in {context}");
                *byte = true;
            }
        }
    }
    let told = seen.mapped.iter().map(|(element, m, component, byte)| ((element.clone(), *m, *component), *byte));
    assert!(
        told.clone().count() == map.offsets.len() && told.collect::<HashMap<_, _>>() == map.offsets,
        "map of {context}"
    );
    let samples: Vec<R> = (0..elements.len()).map(R::sample).collect();
    for (records, way) in seen.records.iter().zip(["get", "iter", "relayout to blocks", "relayout from blocks"]) {
        let wrong = records.iter().zip(&samples).position(|(record, sample)| record != sample);
        assert_eq!((records.len(), wrong), (samples.len(), None), "{way} in {context}");
    }
}

/// Checks each layout over each shape, for one record or for both; the first with changes of layout. Under the sanitizers, which compile
/// slowly, that one alone.
macro_rules! check {
    (of $record:ident: $shapes:expr; $first:tt; $($rest:tt;)*) => {
        check!(each true $record: $shapes; $first;);
        #[cfg(not(allotrope_sanitized))]
        {
            check!(each false $record: $shapes; $($rest;)*);
        }
    };
    (each $moves:literal $record:ident: $shapes:expr; $(($($layout:tt)*);)*) => {$(
        for shape in $shapes {
            check(stringify!($($layout)*), &observe::<$moves, $record, layout!($($layout)*), _>(shape));
        }
    )*};
    ($shapes:expr; $(($($layout:tt)*);)*) => {
        check!(of Node: $shapes; $(($($layout)*);)*);
        check!(of Body: $shapes; $(($($layout)*);)*);
    };
}

#[test]
fn one_axis() {
    let shapes = [[1], [37], [64]];
    check!(shapes;
        (dense(i).aos);
        (dense(i).soa);
        (dense(i).split);
        (dense(i, 7).aos);
        (dense(i).dense(i, 5).soa);
        (dense(i).dense(i, 16).soa);
        (dense(i).dense(i, 4).split);
        (dense(i).dense(i, 3).dense(i, 4).soa);
        (dense(i, 2).dense(i, 3).dense(i, 5).split);
    );
}

#[test]
fn two_axes() {
    let shapes = [[5, 7], [16, 16], [1, 13]];
    check!(shapes;
        (dense(ij).aos);
        (dense(ji).soa);
        (dense(ij).split);
        (dense(ij).dense(ij, 4).aos);
        (dense(ij).dense(ij, 3).soa);
        (dense(ji).dense(ij, (4, 2)).split);
        (dense(ij).dense(ji, (5, 3)).aos);
        (dense(ij).dense(i, 4).soa);
        (dense(ij, 6).dense(j, 2).aos);
        (dense(ij).dense(ij, 2).dense(ji, (3, 2)).soa);
        (dense(ji).dense(j, 3).dense(i, 2).dense(ij, 2).split);
    );
}

#[test]
fn three_axes() {
    let shapes = [[3, 4, 5], [7, 2, 6], [8, 8, 8]];
    check!(shapes;
        (dense(ijk).aos);
        (dense(kji).soa);
        (dense(jki).split);
        (dense(ijk).dense(ijk, 2).soa);
        (dense(ijk).dense(ijk, (2, 3, 4)).aos);
        (dense(kij).dense(kj, (3, 2)).split);
        (dense(ijk).dense(k, 4).soa);
        (dense(ijk).dense(ij, 3).dense(k, 5).soa);
        (dense(ijk, 2).dense(ikj, (3, 1, 2)).aos);
    );
}

#[test]
fn blocks_in_z_order() {
    check!([[1], [37]];
        (morton(i, 8).soa);
        (dense(i, 3).morton(i, 4).dense(i, 2).aos);
    );
    check!([[5, 7], [16, 16], [1, 13]];
        (morton(ij, 4).aos);
        (morton(ij, 8).soa);
        (morton(ji, 4).split);
        (dense(ji).morton(ij, (2, 8)).soa);
        (dense(ij).morton(ij, (8, 2)).aos);
        (dense(ij).morton(ij, 4).dense(ij, 3).soa);
        (dense(ij).dense(ij, 3).morton(ji, (4, 2)).split);
        (morton(ij, 2).morton(ij, 4).aos);
        (dense(j).morton(i, 16).morton(j, 2).soa);
        (morton(ij, 1).aos);
    );
    check!([[3, 4, 5], [7, 2, 6], [8, 8, 8]];
        (morton(ijk, 4).aos);
        (dense(kji).morton(jki, (2, 8, 4)).soa);
        (dense(ijk).morton(ik, 4).dense(ijk, (1, 3, 2)).split);
        (dense(ijk).dense(k, 3).morton(ijk, 2).aos);
    );
    check!(of Node: [[5, 7], [16, 16]];
        (Node: morton(ij, 4).place([flags, v], [split(m)]));
    );
}

#[test]
fn four_axes() {
    check!([[2, 3, 4, 3], [1, 2, 5, 2]];
        (dense(ijkl).aos);
        (dense(ljki).soa);
        (dense(ijkl).dense(ijkl, 2).split);
        (dense(lk).dense(ij, 3).dense(kl, (1, 2)).soa);
        (morton(ijkl, 2).aos);
        (dense(ijkl).morton(jlik, (2, 4, 1, 2)).pad(16).split);
    );
}

#[test]
fn padding() {
    check!([[1], [37]];
        (dense(i).pad(64).aos);
        (dense(i).pad(2).aos);
        (dense(i).pad(256).soa);
        (dense(i).dense(i, 5).pad(32).aos);
        (dense(i, 7).pad(128).split);
    );
    check!([[5, 7], [1, 13]];
        (dense(ji).pad(4096).soa);
        (dense(ij).pad(16).split);
        (dense(ij).dense(ij, 3).pad(64).soa);
        (dense(ij).dense(ji, (4, 2)).pad(1).aos);
        (morton(ij, 4).pad(128).aos);
        (dense(ij).morton(ij, 2).dense(j, 3).pad(32).split);
    );
    check!(of Node: [[5, 7], [16, 16]];
        (Node: dense(ij).pad(512).place([v], [m, flags]));
        (Node: dense(ij).dense(ij, 3).pad(64).place([flags, v], [split(m)]));
        (Node: morton(ij, 4).pad(16).place([m, split(v), flags]));
    );
}

#[test]
fn padding_may_be_a_constant() {
    const PAGE: usize = 4096;
    fn bytes<L: Layout<I>>() -> usize {
        Field::<Even, L>::new([5]).bytes()
    }
    assert_eq!(bytes::<layout!(dense(i).pad(PAGE).aos)>(), 5 * PAGE);
    assert_eq!(bytes::<layout!(dense(i).pad(PAGE).soa)>(), 2 * PAGE);
    assert_eq!(bytes::<layout!(dense(i).dense(i, 2).pad(32).split)>(), 3 * 4 * 32);
}

#[test]
fn an_axis_below_the_root_alone() {
    check!([[9, 4], [3, 2]];
        (dense(i).dense(j, 4).aos);
        (dense(i).dense(ij, (2, 4)).soa);
        (dense(i).dense(j, 2).dense(j, 2).split);
    );
    check!([[2, 3, 7]];
        (dense(k).dense(ij, (2, 3)).soa);
    );
}

#[test]
fn groups_of_members() {
    check!(of Node: [[5, 7], [16, 16]];
        (Node: dense(ij).place([v, m], [flags]));
        (Node: dense(ij).place([flags], [m, v]));
        (Node: dense(ij).dense(ij, 3).place([flags, v], [split(m)]));
        (Node: dense(ji).dense(ij, 4).place([m, split(v), flags]));
        (records::Node: dense(ij).dense(j, 5).place([split(flags), split(v), m]));
    );
    check!(of Body: [[37], [64]];
        (Body: dense(i).place([x, id], [fixed, split(frame)], [spins]));
        (Body: dense(i).dense(i, 6).place([split(spins)], [frame, fixed, id, x]));
        (Body: dense(i, 2).dense(i, 3).place([id], [x, split(spins), fixed], [split(frame)]));
    );
}

#[test]
fn records_in_records() {
    check!(of Outer: [[5, 7], [16, 16]];
        (dense(ij).aos);
        (dense(ji).soa);
        (dense(ij).dense(ij, 3).split);
        (morton(ij, 4).pad(32).aos);
        (Outer: dense(ij).place([node.v, id], [split(node.m), side, node.flags]));
        (Outer: dense(ij).dense(ij, 4).place([node.m, side]) + dense(ji).place([id], [node.flags, split(node.v)]));
    );
    check_columns::<Outer, layout!(Outer: dense(ij).dense(ji, 3).place([split(node), id], [side])), _>([5, 7]);
}

#[test]
fn members_in_branches() {
    check!(of Node: [[5, 7], [16, 16]];
        (Node: dense(ij).place([v]) + dense(ji).place([m, flags]));
        (Node: dense(ij).dense(ij, 4).place([flags, v]) + dense(ij).place([split(m)]));
        (Node: dense(ji).place([m]) + dense(ij).dense(j, 3).place([split(v)]) + morton(ij, 4).place([flags]));
        (Node: dense(ij, 3).pad(256).place([flags], [m]) + dense(ij).pad(16).place([v]));
    );
    check!(of Body: [[37], [64]];
        (Body: dense(i).place([x, id], [split(frame)]) + dense(i).dense(i, 6).place([spins], [fixed]));
        (Body: dense(i, 5).place([id]) + dense(i).place([x]) + dense(i).pad(128).place([fixed]) + dense(i).place([split(spins), frame]));
    );
    check_columns::<Node, layout!(Node: dense(ij).place([v]) + dense(ji).dense(i, 3).place([flags], [m])), _>([5, 7]);
}

#[test]
fn named_layouts_mean_what_their_pages_say() {
    macro_rules! check_named {
        ($shapes:expr; $($text:literal = $layout:ty;)*) => {$(
            for shape in $shapes {
                check($text, &observe::<true, Node, $layout, _>(shape));
            }
        )*};
    }
    check_named!([[37], [64]];
        "dense(i).aos" = Aos;
        "dense(i).dense(i, 16).soa" = AoSoA<16>;
        "dense(i).dense(i, 5).aos" = Blocked<5>;
        "dense(i).dense(i, 4).aos" = Morton<4>;
    );
    check_named!([[5, 7], [16, 16]];
        "dense(ij).aos" = Aos;
        "dense(ij).soa" = Soa;
        "dense(ij).split" = Split;
        "dense(ij).dense(j, 6).soa" = AoSoA<6>;
        "dense(ij).dense(ij, 4).aos" = Blocked<4>;
        "dense(ij).morton(ij, 4).aos" = Morton<4>;
    );
    check_named!([[3, 4, 5], [7, 2, 6]];
        "dense(ijk).split" = Split;
        "dense(ijk).dense(k, 4).soa" = AoSoA<4>;
        "dense(ijk).dense(ijk, 3).aos" = Blocked<3>;
        "morton(ijk, 2).aos" = Morton<2>;
    );
    check_named!([[2, 3, 4, 3]];
        "dense(ijkl).split" = Split;
        "dense(ijkl).dense(l, 2).soa" = AoSoA<2>;
        "dense(ijkl).dense(ijkl, 2).aos" = Blocked<2>;
    );
    // One record, whatever a block's size.
    check_named!([[]];
        "dense().aos" = Aos;
        "dense().soa" = Soa;
        "dense().split" = Split;
        "dense().dense().soa" = AoSoA<6>;
        "dense().dense().aos" = Blocked<4>;
        "dense().morton().aos" = Morton<8>;
    );
}

/// Each member alone, in logical row-major order.
fn check_columns<R: Sample, L: Layout<S::X>, S: Shape>(shape: S) {
    let mut field = Field::<R, L>::new(shape);
    let elements = elements(field.shape().as_ref());
    let samples: Vec<R> = (0..elements.len()).map(R::sample).collect();
    for (element, &record) in elements.iter().zip(&samples) {
        field.set(index::<S::X>(element), record);
    }
    assert!(R::columns(&field) == R::columns_of(&samples), "{} of {elements:?}", std::any::type_name::<L>());
}

#[test]
fn members_come_in_row_major_order() {
    check_columns::<Node, layout!(dense(i).dense(i, 3).dense(i, 4).soa), _>([37]);
    check_columns::<Node, layout!(dense(ji).soa), _>([5, 7]);
    check_columns::<Node, layout!(dense(ij, 3).dense(ji, (2, 4)).split), _>([5, 7]);
    check_columns::<Node, layout!(Node: dense(ij).dense(ji, 3).place([split(m), flags], [v])), _>([5, 7]);
    check_columns::<Body, layout!(dense(ji).dense(ij, (5, 3)).aos), _>([16, 16]);
    check_columns::<Body, layout!(dense(kij).dense(kj, (3, 2)).split), _>([3, 4, 5]);
}

#[test]
fn sizes_may_be_constants() {
    const WIDTH: usize = 6;
    fn of<const N: usize>() -> usize {
        Field::<Node, layout!(dense(ij).dense(ij, (N, WIDTH)).soa)>::new([9, 9]).bytes()
    }
    let bytes = |text| oracle::map(text, &[9, 9], Node::MEMBERS).bytes;
    assert_eq!(of::<4>(), bytes("dense(ij).dense(ij, (4, 6)).soa"));
    assert_eq!(of::<5>(), bytes("dense(ij).dense(ij, (5, 6)).soa"));
}

/// Elements of 16 bytes, so that nothing is rounded up but runs.
#[derive(Record, Clone, Copy, Default)]
struct Even {
    v: Vec3,
    m: f32,
}

#[test]
fn large_fields_take_their_elements_bytes_and_no_more() {
    fn overhead<L: Layout<Ij>>() -> f64 {
        let field = Field::<Even, L>::try_new([400, 240]).expect("a field");
        field.bytes() as f64 / (field.len() * 16) as f64
    }
    for (text, overhead) in [
        ("aos", overhead::<Aos>()),
        ("soa", overhead::<Soa>()),
        ("split", overhead::<Split>()),
        ("aosoa", overhead::<AoSoA<16>>()),
        ("blocked", overhead::<Blocked<8>>()),
        ("columns", overhead::<layout!(dense(ji).dense(ij, (5, 3)).split)>()),
    ] {
        assert!((1.0..1.01).contains(&overhead), "{text}: {overhead}");
    }
}
