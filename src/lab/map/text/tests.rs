//! The interpreter of texts against fields whose layouts are types.

use allotrope::prelude::*;
use allotrope::{MemoryMap, Standing};

use super::TextMap;
use crate::lab::map::{Mapped, Span};

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
    flag: u8,
}
const NODE: &str = "v: Vec2, m: f32, flag: u8";

#[derive(Record, Clone, Copy, Default)]
struct Body {
    on: bool,
    node: Inner,
    spins: [i16; 3],
}
#[derive(Record, Clone, Copy, Default)]
struct Inner {
    x: DVec3,
    id: u16,
}
const BODY: &str = "on: bool, node: { x: DVec3, id: u16 }, spins: [i16; 3]";

/// Both maps tell the same of every element, member and component, as a whole and line by line.
fn agree(context: &str, text: &TextMap, field: &MemoryMap<'_>) {
    assert_eq!(text.shape(), field.shape(), "{context}");
    assert_eq!(text.is_sparse(), field.is_sparse(), "{context}");
    assert_eq!(text.pieces(), field.pieces(), "{context}");
    let facts = |map: &dyn Mapped| -> Vec<_> {
        let members = map.members().into_iter();
        members.map(|member| (member.name, member.scalar, member.scalar_bytes, member.components)).collect()
    };
    assert_eq!(facts(text), facts(field), "{context}");
    let mut told = 0;
    for (number, piece) in text.pieces().iter().enumerate() {
        assert_eq!(text.starts(number), Mapped::starts(field, number), "{context}");
        let spans = |map: &dyn Mapped| -> Vec<Span> {
            // A flat layout has blocks of one cell, which are of no interest.
            map.spans_in(number, 0..piece.bytes)
        };
        let (ours, theirs) = (spans(text), spans(field));
        assert_eq!(ours.len(), theirs.len(), "{context}");
        let wrong = ours.iter().zip(&theirs).find(|(ours, theirs)| ours != theirs);
        assert_eq!(wrong, None, "{context}");
        told += ours.iter().filter(|span| span.standing == Standing::Active).count();
        for line in (0..piece.bytes).step_by(192) {
            let part = line..line + 64;
            assert_eq!(text.spans_in(number, part.clone()), Mapped::spans_in(field, number, part), "{context}");
        }
    }
    assert!(told > 0, "{context}");
}

macro_rules! check {
    (of $record:ty, $text:expr; $($shape:expr => $($layout:literal = $type:ty),+;)*) => {$($(
        let field = Field::<$record, $type>::new($shape);
        let text = TextMap::new($text, $layout, Some(&$shape), None).unwrap_or_else(|error| panic!("{error}"));
        agree(&format!("{} over {:?}", $layout, $shape), &text, &field.memory_map());
    )+)*};
    (written of $record:ty, $text:expr; $($shape:expr => $(($($layout:tt)*)),+;)*) => {$($(
        let field = Field::<$record, layout!($($layout)*)>::new($shape);
        let layout = stringify!($($layout)*);
        let text = TextMap::new($text, layout, Some(&$shape), None).unwrap_or_else(|error| panic!("{error}"));
        agree(&format!("{layout} over {:?}", $shape), &text, &field.memory_map());
    )+)*};
}

#[test]
fn dense_layouts_are_what_the_librarys_are() {
    check! { written of Node, NODE;
        [37] => (dense(i).aos), (dense(i).soa), (dense(i, 7).split), (dense(i).dense(i, 5).soa), (dense(i).pad(64).aos);
        [5, 7] => (dense(ji).soa), (dense(ij).dense(ji, (4, 2)).split), (dense(ij, 6).dense(j, 2).aos),
            (morton(ij, 4).aos), (dense(ji).morton(ij, (2, 8)).soa), (dense(ij).morton(ij, 4).dense(ij, 3).soa),
            (dense(ij, 16).dense(ij, 4).aos), (dense(ij).dense(ij, 3).pad(32).split),
            (Node: dense(ij).pad(16).place([flag, v], [split(m)])), (Node: dense(ij).dense(j, 3).place([m, split(v), flag])),
            (Node: dense(ij).place([v]) + dense(ji).dense(i, 3).pad(256).place([flag], [m])),
            (Node: dense(ij, 3).pad(512).place([flag]) + dense(ij).place([v]) + morton(ij, 2).place([split(m)]));
    }
    check! { written of Body, BODY;
        [3, 4, 5] => (dense(kij).aos), (dense(ijk).dense(ikj, (3, 1, 2)).soa), (morton(ijk, 2).pad(128).split),
            (Body: dense(ijk).dense(k, 4).place([node.id, on], [split(spins), node.x])),
            (Body: dense(ijk).place([split(node)], [spins, on]));
        [2, 3, 4, 3] => (dense(lk).dense(ij, 3).dense(kl, (1, 2)).soa);
    }
    check! { written of f64, "f64"; [9] => (dense(i).dense(i, 4).aos), (dense(i).split); }
    check! { written of [Vec3; 2], "[Vec3; 2]"; [9] => (dense(i).aos), (dense(i).split); }
}

#[test]
fn layouts_with_names_are_what_the_librarys_are() {
    check! { of Node, NODE;
        [37] => "Aos" = Aos, "Soa" = Soa, "AoSoA<16>" = AoSoA<16>, "Blocked<5>" = Blocked<5>, "Morton<4>" = Morton<4>;
        [5, 7] => "Split" = Split, "AoSoA<6>" = AoSoA<6>, "Blocked<4>" = Blocked<4>, "Morton<4>" = Morton<4>;
        [3, 4, 5] => "Blocked<3>" = Blocked<3>, "AoSoA<4>" = AoSoA<4>;
    }
}

/// Indices of both kinds, as text and as the fields take them.
const ACTIVE: &str = "0,0; 0,1; 2,20..23; 36,49; 17,14; 18,14; 17,17";

fn activate<R: Record + Default, L: Layout<Ij>>(field: &mut Field<R, L, Ij>) {
    for at in [[0, 0], [0, 1], [2, 20], [2, 21], [2, 22], [36, 49], [17, 14], [18, 14], [17, 17]] {
        field.set(at, R::default());
    }
}

#[test]
fn sparse_layouts_are_what_the_librarys_are() {
    macro_rules! check {
        ($(($($layout:tt)*)),+ $(,)?) => {$(
            let mut field = Field::<Node, layout!($($layout)*)>::new([37, 50]);
            activate(&mut field);
            let layout = stringify!($($layout)*);
            let text = TextMap::new(NODE, layout, Some(&[37, 50]), Some(ACTIVE)).unwrap_or_else(|error| panic!("{error}"));
            agree(layout, &text, &field.memory_map());
        )+};
    }
    check! {
        (pointer(ij, 4).dense(ji, (4, 2)).soa), (pointer(ji).bitmasked(ij, 8).split),
        (pointer(ij).bitmasked(ij, 4).dense(ij, 2).soa), (dense(ij).pointer(ji, 2).morton(ij, 4).pad(128).aos),
        (bitmasked(ij, 8).aos), (bitmasked(ij).soa), (pointer(ij).aos), (dense(ji, 2).pointer(ij, 2).pointer(ij, 2).dense(ij, 4).aos),
        (dense(ij, 4).bitmasked(ij, 8).aos),
        (Node: dense(ij).place([v]) + pointer(ij).dense(ij, 4).place([flag], [m])),
        (Node: pointer(ij).dense(ij, 8).place([m]) + dense(ij).pad(128).place([v], [flag])),
        (Node: pointer(ij).dense(ij, 8).place([flag]) + pointer(ij).bitmasked(ij, 4).place([v, m])),
    }
    let mut field = Field::<Node, Sparse<4>>::new([37, 50]);
    activate(&mut field);
    let text = TextMap::new(NODE, "Sparse<4>", Some(&[37, 50]), Some(ACTIVE)).unwrap();
    agree("Sparse<4>", &text, &field.memory_map());
}

#[test]
fn unbounded_layouts_and_lists_are_what_the_librarys_are() {
    let places = [[-1_000_000, 7], [2_147_483_646, -2_147_483_648], [0, 0], [-1, -1]];
    let active = "-1000000,7; 2147483646,-2147483648; 0,0; -1,-1";
    macro_rules! check {
        ($($layout:literal = $type:ty;)*) => {$(
            let mut field = Field::<Node, $type, Ij>::unbounded();
            for at in places {
                field.set(at, Node::default());
            }
            let mut text = TextMap::new(NODE, $layout, Some(&[16, 16]), Some(active)).unwrap();
            // The shape is that of the pattern.
            text.shape = field.memory_map().shape().to_vec();
            agree($layout, &text, &field.memory_map());
        )*};
    }
    check! {
        "hash(ij).bitmasked(ij, 4).soa" = layout!(hash(ij).bitmasked(ij, 4).soa);
        "hash(ji).pointer(ij, 2).dense(ij, 4).aos" = layout!(hash(ji).pointer(ij, 2).dense(ij, 4).aos);
        "SparseHash<8>" = SparseHash<8>;
    }

    macro_rules! check_lists {
        ($(($($layout:tt)*)),+ $(,)?) => {$(
            let mut field = Field::<Node, layout!($($layout)*)>::new([5]);
            for list in [4, 1, 4, 4, 0, 4, 1, 4, 4, 4, 4, 4] {
                field.append(list, Node::default());
            }
            let layout = stringify!($($layout)*);
            let text = TextMap::new(NODE, layout, Some(&[5]), Some("0,0; 1,0..2; 4,8; 4,3")).unwrap_or_else(|error| panic!("{error}"));
            agree(layout, &text, &field.memory_map());
        )+};
    }
    check_lists! {
        (dense(i).dynamic(j, 100, chunk = 8).aos), (dense(i).dynamic(j, 9).soa), (pointer(i).dense(i, 2).dynamic(j, 10, chunk = 4).split),
        (pointer(i, 2).dynamic(j, 64, chunk = 5).pad(64).aos),
    }
}
