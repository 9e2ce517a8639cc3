//! Records as texts: `x: Vec2, v: Vec2, m: f32`, with records and arrays in them, or a bare element.

use allotrope::MAX_MEMBERS;

use super::scan::{Kind, Text, Token, Tokens, nearest};
use crate::lab::errors::LabError;
use crate::lab::map::Member;

/// Element types that have a name: it, the type of a component, its bytes, and how many there are.
const ELEMENTS: &[(&str, &str, usize, usize)] = &[
    ("f32", "f32", 4, 1),
    ("f64", "f64", 8, 1),
    ("i8", "i8", 1, 1),
    ("i16", "i16", 2, 1),
    ("i32", "i32", 4, 1),
    ("i64", "i64", 8, 1),
    ("u8", "u8", 1, 1),
    ("u16", "u16", 2, 1),
    ("u32", "u32", 4, 1),
    ("u64", "u64", 8, 1),
    ("bool", "bool", 1, 1),
    ("Vec2", "f32", 4, 2),
    ("Vec3", "f32", 4, 3),
    ("Vec3A", "f32", 4, 3),
    ("Vec4", "f32", 4, 4),
    ("Mat2", "f32", 4, 4),
    ("Mat3", "f32", 4, 9),
    ("Mat4", "f32", 4, 16),
    ("Quat", "f32", 4, 4),
    ("DVec2", "f64", 8, 2),
    ("DVec3", "f64", 8, 3),
    ("DVec4", "f64", 8, 4),
    ("DMat2", "f64", 8, 4),
    ("DMat3", "f64", 8, 9),
    ("DMat4", "f64", 8, 16),
    ("DQuat", "f64", 8, 4),
    ("IVec2", "i32", 4, 2),
    ("IVec3", "i32", 4, 3),
    ("IVec4", "i32", 4, 4),
    ("UVec2", "u32", 4, 2),
    ("UVec3", "u32", 4, 3),
    ("UVec4", "u32", 4, 4),
];

/// The most bytes of a record that is drawn.
const MOST_BYTES: usize = 1 << 20;

/// Reads a record: its members, those of the records in it with paths as names.
pub(super) fn parse(text: &str) -> Result<Vec<Member>, LabError> {
    let mut tokens = Text { what: "record", text }.tokens()?;
    let mut members = Vec::new();
    // `Node { .. }`, as in a program.
    if tokens.peek(0).kind == Kind::Word && tokens.peek(1).kind == Kind::Sign('{') {
        tokens.take();
    }
    if tokens.sign('{') {
        list(&mut tokens, "", &mut members)?;
        tokens.wants('}', "close the record with `}`")?;
    } else if tokens.peek(0).kind == Kind::Word && tokens.peek(1).kind == Kind::Sign(':') {
        list(&mut tokens, "", &mut members)?;
    } else {
        let member = element(&mut tokens)?;
        members.push(Member { name: String::new(), ..member });
    }
    if tokens.peek(0).kind != Kind::End {
        let message = match members[..] {
            [Member { ref name, .. }] if name.is_empty() => {
                "members have names, and commas between them: `x: Vec2, m: f32`"
            }
            _ => "a comma and another member, or nothing, is wanted here",
        };
        return Err(tokens.error(message));
    }
    let bytes: usize = members.iter().map(Member::bytes).sum();
    if bytes > MOST_BYTES {
        let message = format!("it has {bytes} bytes, and at most {MOST_BYTES} can be drawn; write shorter arrays");
        return Err(tokens.text.error(&(0..text.len()), message));
    }
    if bytes == 0 {
        return Err(tokens.text.error(&(0..text.len()), "it has no bytes, so that there is nothing to draw"));
    }
    Ok(members)
}

/// Members with commas between them.
fn list(tokens: &mut Tokens<'_>, path: &str, members: &mut Vec<Member>) -> Result<(), LabError> {
    loop {
        let name = tokens.peek(0).clone();
        if name.kind != Kind::Word {
            return Err(tokens.error("the name of a member is wanted: `m: f32`"));
        }
        tokens.take();
        let full = format!("{path}{}", tokens.read(&name));
        tokens.wants(':', "`:` and a type are wanted behind a member's name: `m: f32`")?;
        check_name(tokens, &name, &full, members)?;
        if tokens.sign('{') {
            list(tokens, &format!("{full}."), members)?;
            tokens.wants('}', "close the inner record with `}`")?;
        } else {
            let member = element(tokens)?;
            members.push(Member { name: full, ..member });
        }
        if members.len() > MAX_MEMBERS {
            let message =
                format!("a record holds up to {MAX_MEMBERS} members, and this is one more; make arrays of some");
            return Err(tokens.text.error(&name.at, message));
        }
        if !tokens.sign(',') || matches!(tokens.peek(0).kind, Kind::End | Kind::Sign('}')) {
            return Ok(());
        }
    }
}

fn check_name(tokens: &Tokens<'_>, name: &Token, full: &str, members: &[Member]) -> Result<(), LabError> {
    let below = format!("{full}.");
    if members.iter().any(|member| member.name == full || member.name.starts_with(&below)) {
        let message = format!("there are two members `{full}`; give one of them another name");
        return Err(tokens.text.error(&name.at, message));
    }
    Ok(())
}

/// An element type: a name, or an array of elements.
fn element(tokens: &mut Tokens<'_>) -> Result<Member, LabError> {
    let start = tokens.peek(0).at.start;
    if tokens.sign('[') {
        if tokens.peek(0).kind == Kind::Sign('{') {
            return Err(tokens.error("arrays hold elements, not records; write a member for each: `a: {..}, b: {..}`"));
        }
        let inner = element(tokens)?;
        tokens.wants(';', "an array's length is wanted: `[f32; 3]`")?;
        let (count, at) = tokens.number("an array's length, a number, is wanted: `[f32; 3]`")?;
        tokens.wants(']', "close the array with `]`")?;
        let count = usize::try_from(count).ok().and_then(|count| count.checked_mul(inner.components));
        let components = count.filter(|&count| count <= MOST_BYTES).ok_or_else(|| {
            tokens
                .text
                .error(&at, format!("the array is too long; a record of at most {MOST_BYTES} bytes can be drawn"))
        })?;
        let end = tokens.text.text[..tokens.peek(0).at.start].trim_end().len();
        let kind = tokens.text.text[start..end].to_string();
        return Ok(Member { kind, components, ..inner });
    }
    if tokens.peek(0).kind != Kind::Word {
        return Err(tokens.error("a type is wanted: `f32`, `Vec2`, `[f32; 3]`, or a record in braces"));
    }
    let token = tokens.take();
    let name = tokens.read(&token);
    named(name).ok_or_else(|| tokens.text.error(&token.at, unknown(name)))
}

fn named(name: &str) -> Option<Member> {
    let &(_, scalar, scalar_bytes, components) = ELEMENTS.iter().find(|(known, ..)| *known == name)?;
    Some(Member { name: String::new(), kind: name.into(), scalar: scalar.into(), scalar_bytes, components })
}

fn unknown(name: &str) -> String {
    let meant = match name {
        "float" | "single" => Some("f32"),
        "double" => Some("f64"),
        "int" | "isize" => Some("i32"),
        "usize" | "uint" => Some("u32"),
        "byte" | "char" => Some("u8"),
        _ => nearest(name, ELEMENTS.iter().map(|(known, ..)| *known)),
    };
    let known = "`f32`, `f64`, `i8` to `i64`, `u8` to `u64`, `bool`, glam's vectors, matrices and quaternions, and arrays of these";
    match meant {
        Some(meant) => format!("there is no element type `{name}`; did you mean `{meant}`?"),
        None => format!("there is no element type `{name}`; there are {known}; an enum is its integer, `u8` say"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn members(text: &str) -> Vec<(String, usize, usize)> {
        let members = parse(text).unwrap_or_else(|error| panic!("{error}"));
        members.into_iter().map(|member| (member.name, member.components, member.scalar_bytes)).collect()
    }

    #[test]
    fn records_are_read() {
        assert_eq!(members("f64"), [(String::new(), 1, 8)]);
        assert_eq!(members("[[u8; 2]; 3]"), [(String::new(), 6, 1)]);
        let wanted = [("x".to_string(), 2, 4), ("node.v".into(), 3, 8), ("node.on".into(), 1, 1), ("m".into(), 1, 4)];
        assert_eq!(members("x: Vec2, node: { v: DVec3, on: bool }, m: f32,"), wanted);
        assert_eq!(members("Cell{x:Vec2,node:{v:DVec3,on:bool,},m:f32}"), wanted);
        assert_eq!(parse("a: [ Vec2 ; 3 ]").unwrap()[0].kind, "[ Vec2 ; 3 ]");
    }

    /// The sizes of the element types are those of the library.
    #[test]
    fn element_types_are_the_librarys() {
        use allotrope::Element;
        use allotrope::prelude::*;
        let mut checked = 0;
        macro_rules! check {
            ($($element:ty)*) => {$(
                let (name, scalar) = (stringify!($element), std::any::type_name::<<$element as Element>::Scalar>());
                let wanted = (name, scalar, size_of::<<$element as Element>::Scalar>(), <$element as Element>::COMPONENTS);
                assert!(ELEMENTS.contains(&wanted), "{wanted:?}");
                checked += 1;
            )*};
        }
        check!(f32 f64 i8 i16 i32 i64 u8 u16 u32 u64 bool);
        check!(Vec2 Vec3 Vec3A Vec4 Mat2 Mat3 Mat4 Quat DVec2 DVec3 DVec4 DMat2 DMat3 DMat4 DQuat);
        check!(IVec2 IVec3 IVec4 UVec2 UVec3 UVec4);
        assert_eq!(checked, ELEMENTS.len());
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (text, message) in [
            ("x: Vec2, v: Vce2", "column 13, `Vce2`: there is no element type `Vce2`; did you mean `Vec2`?"),
            ("x: double", "column 4, `double`: there is no element type `double`; did you mean `f64`?"),
            ("x Vec2", "column 1, `x`: there is no element type `x`; there are `f32`"),
            ("f32, f32", "column 4, `,`: members have names, and commas between them: `x: Vec2, m: f32`"),
            ("x: f32 y: f32", "column 8, `y`: a comma and another member, or nothing, is wanted here"),
            ("x: f32, x: f64", "column 9, `x`: there are two members `x`; give one of them another name"),
            ("x: {a: f32", "column 11: the record ends here; close the inner record with `}`"),
            (
                "x:",
                "column 3: the record ends here; a type is wanted: `f32`, `Vec2`, `[f32; 3]`, or a record in braces",
            ),
            ("x: [f32, 3]", "column 8, `,`: an array's length is wanted: `[f32; 3]`"),
            ("x: [{a: f32}; 3]", "column 5, `{`: arrays hold elements, not records; write a member for each"),
            (
                "x: [f64; 99999999999]",
                "column 10, `99999999999`: the array is too long; a record of at most 1048576 bytes",
            ),
            (
                "x: [f64; 1000000]",
                "column 1, `x: [f64; 1000000]`: it has 8000000 bytes, and at most 1048576 can be drawn",
            ),
            ("x: [f32; 0]", "column 1, `x: [f32; 0]`: it has no bytes, so that there is nothing to draw"),
            ("x: f32 & y", "column 8, `&`: no record has such a sign; leave it out"),
            ("", "column 1: the record ends here; a type is wanted"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.to_string().starts_with(&format!("record `{text}`: {message}")), "{error}");
            assert_eq!(error.status(), 2);
        }
        let many: Vec<String> = (0..25).map(|n| format!("a{n}: u8")).collect();
        let error = parse(&many.join(", ")).unwrap_err().to_string();
        assert!(error.contains("`a24`: a record holds up to 24 members, and this is one more"), "{error}");
    }
}
