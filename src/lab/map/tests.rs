//! Pictures of maps.

use allotrope::prelude::*;

use super::paper::{MARGIN, SIGN, WIDTH};
use super::row::BYTE;
use super::{Drawing, TextMap};

/// The numbers of an attribute in each element that begins so.
fn numbers(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
    let key = format!(" {attribute}=\"");
    let elements = svg.lines().filter(|line| line.starts_with(element));
    elements.filter_map(|line| line.split_once(&key)?.1.split('"').next()?.parse().ok()).collect()
}

fn svg(record: &str, layout: &str, shape: &[usize], active: Option<&str>, lines: usize) -> String {
    let map = TextMap::new(record, layout, Some(shape), active).unwrap();
    Drawing { title: record.into(), subtitle: layout.into(), lines }.svg(&map)
}

/// Texts with where they begin and end and their base lines.
fn texts(svg: &str) -> Vec<([f64; 4], String)> {
    let texts = svg.lines().filter(|line| line.starts_with("<text "));
    let number = |line: &str, key: &str| -> f64 {
        line.split_once(&format!(" {key}=\"")).unwrap().1.split('"').next().unwrap().parse().unwrap()
    };
    let text = |line: &str| {
        let content = line.split_once('>').unwrap().1.strip_suffix("</text>").unwrap().to_string();
        let shown = content.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").replace("&quot;", "\"");
        let (x, y, size) = (number(line, "x"), number(line, "y"), number(line, "font-size"));
        let width = shown.chars().count() as f64 * size * SIGN;
        let left = if line.contains("middle") {
            x - width / 2.0
        } else if line.contains("\"end\"") {
            x - width
        } else {
            x
        };
        ([left, left + width, y - 0.76 * size, y + 0.24 * size], content)
    };
    texts.map(text).collect()
}

/// A record, a layout, a shape, what is active, and how many lines are drawn.
type Case = (&'static str, &'static str, &'static [usize], Option<&'static str>, usize);

const CASES: &[Case] = &[
    ("v: Vec2, m: f32, flag: u8", "dense(ij).dense(ij, 4).soa", &[10, 12], None, 30),
    ("v: Vec2, m: f32, flag: u8", "Aos", &[1000, 1000], None, 24),
    ("a: u8, b: u8", "Split", &[300], None, 24),
    (
        "a_member_with_a_rather_long_name_that_goes_on_and_on: Mat4, node: { x: Vec3, y: bool }",
        "AoSoA<4>",
        &[5, 5, 5],
        None,
        24,
    ),
    ("v: Vec2, m: f32", "pointer(ij).bitmasked(ij, 8).aos", &[64, 64], Some("disc"), 24),
    ("id: u16", "hash(ij).morton(ij, 8).aos", &[8, 8], Some("-2000000000,1999999999; 0,0"), 24),
    ("f64", "dense(ij).dynamic(k, 64, chunk = 8).pad(32).aos", &[4, 4], Some("0,0,0..20; 3,1,0..5"), 24),
    ("[f32; 5]", "Split", &[1 << 30], None, 12),
];

#[test]
fn nothing_overlaps_or_lies_outside() {
    for &(record, layout, shape, active, lines) in CASES {
        let svg = svg(record, layout, shape, active, lines);
        let height = svg.split_once("viewBox=\"0 0 512 ").unwrap().1.split('"').next().unwrap().parse::<f64>().unwrap();
        let texts = texts(&svg);
        for (n, (a, text)) in texts.iter().enumerate() {
            assert!(a[0] >= 0.0 && a[1] <= WIDTH && a[2] >= 0.0 && a[3] <= height, "{layout}: `{text}` lies outside");
            for (b, other) in &texts[..n] {
                let apart = a[0] >= b[1] || b[0] >= a[1] || a[2] >= b[3] || b[2] >= a[3];
                assert!(apart, "{layout}: `{text}` over `{other}`");
            }
        }
        let (xs, widths) = (numbers(&svg, "<rect x", "x"), numbers(&svg, "<rect x", "width"));
        assert!(xs.iter().zip(&widths).all(|(x, width)| *x >= 0.0 && x + width <= WIDTH - MARGIN + 0.01), "{layout}");
        let (ys, heights) = (numbers(&svg, "<rect x", "y"), numbers(&svg, "<rect x", "height"));
        assert!(ys.iter().zip(&heights).all(|(y, box_height)| y + box_height <= height), "{layout}");
    }
}

/// Boxes of rows tell the same as the map: their widths are bytes, and together they fill the lines.
#[test]
fn boxes_are_as_wide_as_their_bytes() {
    let svg = svg("x: f64, m: f32", "dense(i).aos", &[9], None, 24);
    let in_rows: Vec<&str> = svg.lines().filter(|line| line.contains(" height=\"18\"")).collect();
    let width_of = |fill: &str| {
        let lines: String = in_rows.iter().filter(|line| line.contains(fill)).flat_map(|line| [line, "\n"]).collect();
        numbers(&lines, "<rect", "width").iter().sum::<f64>() / BYTE
    };
    let widths = ["#56b4e9", "#e69f00", "url(#padding)"].map(|fill| width_of(fill).round());
    // Behind the last record the line is padded.
    assert_eq!(widths, [9.0 * 8.0, 9.0 * 4.0, 9.0 * 4.0 + 48.0]);
    assert!(svg.contains(">x: f64, 8 bytes<") && svg.contains(">m: f32, 4 bytes<"), "{svg}");
    assert!(svg.contains(">3 lines, 192 bytes, of which 56.2 % hold elements."), "{svg}");
}

#[test]
fn what_is_left_out_is_told() {
    let long = svg("v: Vec2, m: f32", "Soa", &[1 << 20], None, 12);
    assert!(long.contains("196,608 lines, 12,582,912 bytes"), "{long}");
    assert!(
        long.contains("131,062 lines not shown, 8,387,968 bytes") && long.contains("65,534 lines not shown"),
        "{long}"
    );
    // Where `m` begins is shown.
    assert!(long.contains(">8388608<"), "{long}");
    let sparse = svg("m: f32", "Sparse<8>", &[64, 64], Some("all"), 8);
    assert!(
        sparse.contains("Allocated are 64 of 64 blocks of 8 x 8") && sparse.contains("62 blocks not shown"),
        "{sparse}"
    );
}

#[test]
fn activity_padding_and_partial_blocks_are_told_apart() {
    let svg = svg("v: Vec3, f: u8", "pointer(ij).bitmasked(ij, 4).aos", &[6, 6], Some("5,5"), 24);
    for sign in [
        "url(#padding)",
        "url(#beyond)",
        "url(#bits)",
        "fill-opacity=\"0.22\"",
        "cells beyond the shape",
        "activity bits",
    ] {
        assert!(svg.contains(sign), "{sign}");
    }
    assert!(!self::svg("m: f32", "Aos", &[16], None, 24).contains("padding<"));
}

/// The same picture is drawn of a field as of the texts of its record and layout, but for the names of types.
#[test]
fn fields_and_texts_are_drawn_alike() {
    let mut field = Field::<f32, Sparse<4>>::new([20, 20]);
    field.set([5, 9], 1.0);
    let drawing = Drawing { title: "f32".into(), subtitle: "Sparse<4>".into(), lines: 24 };
    let text = TextMap::new("f32", "Sparse<4>", Some(&[20, 20]), Some("5,9")).unwrap();
    assert_eq!(drawing.svg(&field.memory_map()), drawing.svg(&text));
}
