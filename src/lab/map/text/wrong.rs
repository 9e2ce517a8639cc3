//! What is wrong with texts, and what is said of it.

use super::TextMap;
use crate::lab::map::Mapped;

const NODE: &str = "v: Vec2, m: f32, flag: u8";

/// What is wrong with a layout or what goes with it, and the whole of what is said.
#[test]
fn what_is_wrong_is_told_with_its_place_and_its_cure() {
    let cases: &[(&str, &str)] = &[
        ("dens(ij).aos", "column 1, `dens`: there is no node or place `dens`; did you mean `dense`?"),
        ("dense(ij).aoz", "column 11, `aoz`: there is no node or place `aoz`; did you mean `aos`?"),
        (
            "dense(ij).frob(ij).aos",
            "column 11, `frob`: there is no node or place `frob`; the nodes are `dense`, `morton`",
        ),
        ("AOS", "column 1, `AOS`: there is no layout `AOS`; did you mean `Aos`?"),
        ("Blocks<4>", "column 1, `Blocks`: there is no layout `Blocks`; did you mean `Blocked`?"),
        (
            "Teapot",
            "column 1, `Teapot`: there is no layout `Teapot`; those with a name are `Aos`, `Soa`, `Split`, `AoSoA<8>`",
        ),
        ("Blocked", "column 1, `Blocked`: `Blocked` needs the size of its blocks; write `Blocked<8>`"),
        ("Aos<4>", "column 5, `4`: `Aos` has no size; write `Aos`"),
        ("Morton<6>", "column 8, `6`: a block of `Morton` has no such size; write a power of two: `Morton<8>`"),
        ("Aos.soa", "column 1, `Aos`: `Aos` is a layout of its own, with nothing before or behind it"),
        (
            "dense(ij)",
            "column 1, `dense`: the layout has no place; end it with `.aos`, `.soa`, `.split` or `.place([..])`",
        ),
        ("aos", "column 1, `aos`: there are no cells to place; begin with a node: `dense(ij).aos`"),
        ("dense(ij).aos.dense(ij, 8)", "column 15, `dense`: `dense` stands behind the place, which closes the layout"),
        ("dense(ix).aos", "column 7, `ix`: there is no axis `x`; axes are `i`, `j`, `k` and `l`, as in `dense(ij, 8)`"),
        (
            "dense(ii).aos",
            "column 7, `ii`: axis `i` stands twice in one node; split it over two: `dense(i).dense(i, 8)`",
        ),
        ("dense.aos", "column 1, `dense`: `dense` does not say over which axes it goes; write `dense(ij, 8)`"),
        ("dense(8).aos", "column 7, `8`: the axes of `dense` come first; write `dense(ij, 8)`"),
        (
            "dense(jk).aos",
            "column 1, `dense`: axis `i` is named nowhere here; axes begin with `i` and leave none out: name all of `ijk`",
        ),
        ("dense(i, j).aos", "column 10, `j`: the axes of a node are one word; write `dense(ij)`"),
        (
            "dense(ij, (4, 2, 1)).aos",
            "column 11, `(4, 2, 1)`: there are 3 sizes for 2 axes; write one for all, `dense(ij, 8)`",
        ),
        (
            "dense(ij, 4, 2).aos",
            "column 14, `2`: `dense` takes axes and a size; sizes that differ are a tuple: `dense(ij, (4, 2))`",
        ),
        ("dense(ij, N).aos", "column 11, `N`: the size of a block is a number; write `dense(ij, 8)`"),
        ("dense(ij, 0).aos", "column 11, `0`: a block of size 0 has no cells; write a size from 1 on"),
        ("dense(ij, 9999999999).aos", "column 11, `9999999999`: the block is too large, since indices are `i32`"),
        (
            "dense(i).dense(i, 65536).dense(i, 65536).aos",
            "column 1, `dense`: the blocks along axis `i` are too large together",
        ),
        ("dense(ij).dense(ij).aos", "column 11, `dense`: `dense` needs a size here; write `dense(ij, 8)`"),
        (
            "dense(ijk).dense(ijk, 2000000000).aos",
            "column 1, `dense`: the blocks have more cells than a machine can address",
        ),
        (
            "dense(((((((((((((((((8)))))))))))))))))",
            "column 22, `(`: more than 16 brackets in one another; write fewer",
        ),
        ("morton(ij).aos", "column 1, `morton`: `morton` needs a size here; write `morton(ij, 8)`"),
        ("morton(ij, 6).aos", "column 12, `6`: the sizes of `morton` are powers of two; write 4 or 8, or `dense`"),
        ("hash(ij, 4).aos", "column 10, `4`: `hash` takes no size; write `hash(ij).dense(ij, 8)`"),
        (
            "dense(ij).hash(ij).aos",
            "column 11, `hash`: `hash` stands below another node, and it is the outermost one; write `pointer(ij, 8)` here",
        ),
        (
            "dense(i).dynamic(j).aos",
            "column 10, `dynamic`: `dynamic` does not say how many entries a list has at most; write `dynamic(j, 1024)`",
        ),
        ("dense(i).dynamic(i, 8).aos", "column 18, `i`: axis `i` is the list's own, and another node names it, too"),
        (
            "dense(j).dynamic(i, 8).aos",
            "column 1, `dense`: axis `i` of `dynamic` is not the last one; name the list's axis `j`",
        ),
        (
            "dense(i).dynamic(j, 8).dense(i, 2).aos",
            "column 24, `dense`: `dense` stands behind `dynamic`, which comes right before the place",
        ),
        (
            "dense(i).dynamic(j, 8, chunk = 9).aos",
            "column 24, `chunk = 9`: chunks of 9 entries are larger than the list, which has 8 at most",
        ),
        (
            "dense(i).dynamic(j, 8, 4).aos",
            "column 24, `4`: `dynamic` takes an axis, a maximum and perhaps `chunk = ..`; write",
        ),
        ("dense(i).pad(24).aos", "column 14, `24`: starts cannot be aligned to this; write a power of two up to 4096"),
        (
            "dense(i).pad(64).dense(i, 2).aos",
            "column 18, `dense`: `dense` stands behind `pad`, which comes right before the place",
        ),
        (
            "dense(i).aos(v)",
            "column 10, `aos`: the place `aos` takes no arguments; write `.aos`, or `.place([v], [m])`",
        ),
        (
            "dense(i).place(v)",
            "column 16, `v`: this is no group; a group is a list of members in brackets: `[v, split(c)]`",
        ),
        ("dense(i).place([v, m])", "column 1, `dense`: `.place(..)` leaves out the member `flag`; add it to a group"),
        ("dense(i).place([v, mm], [flag])", "column 20, `mm`: the record has no member `mm`; did you mean `m`?"),
        ("dense(i).place([v, m], [flag, v])", "column 31, `v`: the member `v` is placed twice; name it in one group"),
        (
            "dense(i).place([v]) + dense(i).aos",
            "column 23, `dense`: this branch does not say which members it holds; end it with",
        ),
        (
            "dense(i).place([v, m]) + hash(i).place([flag])",
            "column 26, `hash`: `hash` and `dynamic` stand in layouts of one branch",
        ),
        ("dense(ij.aos", "column 13: the layout ends here; a comma or `)` is wanted here"),
        ("dense(ij).aos)", "column 14, `)`: a `.` and another word, or nothing, is wanted here"),
        ("", "column 1: the layout ends here; the name of a node or a place is wanted, as in `dense(ij).aos`"),
        ("dense(ij).", "column 11: the layout ends here; the name of a node or a place is wanted"),
        ("dense(ij)*aos", "column 10, `*`: no layout has such a sign; leave it out"),
        ("layout!(dense(i).aos", "column 21: the layout ends here; close `layout!(` with `)`"),
    ];
    for (layout, message) in cases {
        let error = TextMap::new(NODE, layout, None, None).unwrap_err();
        assert!(error.to_string().starts_with(&format!("layout `{layout}`: {message}")), "{error}");
        assert_eq!((error.status(), error.to_string().lines().count()), (2, 1));
    }
    assert!(TextMap::new(NODE, "layout!(Node: dense(ij).place([v], [m, flag]))", None, None).is_ok());
    assert!(TextMap::new(NODE, "records::Node<Ij>: dense(ij).aos", None, None).is_ok());
}

#[test]
fn shapes_and_activity_are_checked() {
    let cases: &[(&str, &[usize], Option<&str>, &str)] = &[
        (
            "dense(ij).aos",
            &[8],
            None,
            "shape `8`: it has 1 extents, and the layout `dense(ij).aos` goes over `ij`; write `16,16`, say",
        ),
        (
            "dense(i).dynamic(j, 8).aos",
            &[8, 8],
            None,
            "shape `8,8`: it has 2 extents, and the layout `dense(i).dynamic(j, 8).aos` goes over `ij` (`j` is the lists' own, and is left out)",
        ),
        ("Aos", &[0], None, "shape `0`: axis `i` cannot have 0 elements; write from 1 to 2147483647"),
        ("Aos", &[4, 3_000_000_000], None, "shape `4,3000000000`: axis `j` cannot have 3000000000 elements"),
        (
            "dense(i).dense(j, 4).aos",
            &[9, 5],
            None,
            "shape `9,5`: axis `j` has 5 elements, and the layout `dense(i).dense(j, 4).aos` holds 4 at most",
        ),
        (
            "Aos",
            &[2_000_000_000, 2_000_000_000],
            None,
            "shape `2000000000,2000000000`: so many elements have more bytes than a machine can address; write a smaller shape",
        ),
        (
            "Aos",
            &[8],
            Some("disc"),
            "the layout `Aos` has no sparse nodes, so that all its elements are active; leave the activity out",
        ),
        (
            "Sparse<4>",
            &[8, 8],
            Some("9,1"),
            "activity `9,1`: column 1, `9,1`: 9..10 along axis `i` is outside of the shape",
        ),
    ];
    for (layout, shape, active, message) in cases {
        let error = TextMap::new(NODE, layout, Some(shape), *active).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
    // A very large layout costs nothing.
    let large = TextMap::new(NODE, "Split", Some(&[1 << 30, 1 << 20]), None).unwrap();
    assert_eq!(large.spans_in(0, 1 << 40..(1 << 40) + 64).len(), 16);
}

/// Texts with mistakes of all kinds: signs left out, put in and swapped. Whatever comes of them, it is no panic.
#[test]
fn no_text_is_the_end_of_the_program() {
    let records =
        ["v: Vec2, m: f32, flag: u8", "on: bool, node: { x: DVec3, id: u16 }, spins: [i16; 3]", "f32", "[[u8; 2]; 3]"];
    let layouts = [
        "dense(ij).dense(ij, (4, 2)).place([flag, v], [split(m)])",
        "Node: pointer(ij).bitmasked(ij, 4).place([v]) + dense(ij).pad(64).place([m, flag])",
        "hash(ij).morton(ij, 8).soa",
        "dense(i).dynamic(j, 100, chunk = 8).aos",
        "AoSoA<16>",
        "layout!(dense(ij, 4).aos)",
    ];
    let actives = ["0,0; 0,1; 2,20..23", "-3..4,8", "random:10", "disc"];
    let mut seed = 1u64;
    let mut below = |n: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % n
    };
    let signs: Vec<char> = "()[]{}<>,:;.+=!-019 ijvaé\u{2028}".chars().collect();
    let mut read = 0;
    for _ in 0..20_000 {
        let mut texts =
            [records[below(4)], layouts[below(6)], actives[below(4)]].map(|text| text.chars().collect::<Vec<_>>());
        for _ in 0..below(4) {
            let text = &mut texts[below(3)];
            let at = below(text.len().max(1));
            match below(3) {
                0 if !text.is_empty() => drop(text.remove(at)),
                1 if !text.is_empty() => text[at] = signs[below(signs.len())],
                _ => text.insert(at, signs[below(signs.len())]),
            }
        }
        let [record, layout, active] = texts.map(|text| text.into_iter().collect::<String>());
        let active = (below(2) == 0).then_some(active.as_str());
        match TextMap::new(&record, &layout, None, active) {
            Ok(map) => {
                let pieces = map.pieces();
                let lines =
                    pieces.iter().enumerate().take(2).map(|(n, piece)| map.spans_in(n, 0..piece.bytes.min(192)).len());
                read += usize::from(lines.sum::<usize>() > 0);
            }
            Err(error) => assert!(error.status() == 2 && !error.to_string().is_empty()),
        }
    }
    assert!(read > 1000, "{read}");
}
