//! The rules of layouts; every error is collected, none ends the check.

use syn::Ident;

use super::model::{
    AXES, Axis, AxisList, Branch, Group, Kind, LONGEST_NAME, Layout, MOST_BRANCHES, MOST_NODES, NAMED, Node, Pad,
    Place, PlaceKind, Size, Sizes, Step, WIDEST_PAD, WORDS,
};
use crate::diagnostics::{Code, Diagnostics};
use crate::nearest::nearest;

/// Indices are `i32`, so this many elements along an axis are too many.
const TOO_LARGE: u128 = 1 << 31;

/// Reports all that is wrong with a layout.
pub(super) fn check(layout: &Layout, errors: &mut Diagnostics) {
    check_branches(layout, errors);
    for branch in &layout.branches {
        check_words(branch, errors);
        check_order(branch, errors);
        check_axes_used(branch, errors);
        check_depth(branch, errors);
    }
    check_members(layout, errors);
}

/// Branches name their members, and go over the same axes.
fn check_branches(layout: &Layout, errors: &mut Diagnostics) {
    if let Some(plus) = layout.branches.get(MOST_BRANCHES).and_then(|branch| branch.plus) {
        let count = layout.branches.len();
        errors
            .error(
                Code::WrongBranch,
                &plus,
                format!("the layout has {count} branches, and can have {MOST_BRANCHES} at most"),
            )
            .help("put members that are used together in one branch, in groups of their own");
    }
    if layout.branches.len() < 2 {
        return;
    }
    for step in layout.branches.iter().flat_map(|branch| &branch.steps) {
        if let Step::Place(Place { name, kind: PlaceKind::Aos | PlaceKind::Soa | PlaceKind::Split, .. }) = step {
            errors
                .error(Code::WrongBranch, name, format!("`{name}` does not say which members this branch holds"))
                .note("each member of a record stands in one branch of a layout with `+`")
                .help("name them: `.place([v], [m])`, and their record before the first node");
        }
    }
    for step in layout.branches.iter().flat_map(|branch| &branch.steps) {
        if matches!(step, Step::Node(Node { kind: Kind::Hash, .. }) | Step::List(_)) {
            let name = step.name();
            errors
                .error(Code::WrongBranch, name, format!("`{name}` stands in a layout of several branches"))
                .note("all members of a field have the same indices, and a list's entries are whole records")
                .help("give these members a field of their own");
        }
    }
    let axes = |branch: &Branch| -> Option<Vec<Axis>> {
        let mut axes = Vec::new();
        for step in &branch.steps {
            match step.axes() {
                Some(list) if list.unknown.is_empty() => axes.extend(&list.axes),
                None if matches!(step, Step::Place(_) | Step::Pad(_)) => {}
                _ => return None,
            }
        }
        axes.sort_unstable();
        axes.dedup();
        Some(axes)
    };
    let letters = |axes: &[Axis]| axes.iter().map(|axis| axis.letter()).collect::<String>();
    let Some(first) = axes(&layout.branches[0]) else { return };
    for branch in &layout.branches[1..] {
        let (Some(axes), Some(root)) = (axes(branch), branch.steps.first()) else { continue };
        if axes != first {
            errors
                .error(
                    Code::WrongBranch,
                    root.name(),
                    format!("this branch goes over `{}`, and the first over `{}`", letters(&axes), letters(&first)),
                )
                .help("all members of a field have the same axes: name the same in every branch, in any order");
        }
    }
}

/// Nodes first, then one place.
fn check_order(branch: &Branch, errors: &mut Diagnostics) {
    let mut place: Option<&Ident> = None;
    for (number, step) in branch.steps.iter().enumerate() {
        let name = step.name();
        if let Some(place) = place {
            errors
                .error(
                    Code::AfterPlace,
                    name,
                    format!("`{name}` stands after the place `{place}`, and a place closes the layout"),
                )
                .help(format!("put `{name}` before `{place}`, or leave it out"));
        } else if number == 0 && matches!(step, Step::Place(_) | Step::Pad(_)) {
            errors
                .error(Code::NoNode, name, format!("the layout begins with `{name}`, so there are no cells to place"))
                .help(format!("begin with a node: `dense(ij).{name}`"));
        }
        if matches!(step, Step::Place(_)) {
            place = place.or(Some(name));
        }
    }
    if let (None, Some(last)) = (place, branch.steps.last())
        // Perhaps the unknown word was meant for the place.
        && !matches!(last, Step::Unknown(_))
    {
        errors
            .error(Code::NoPlace, last.name(), "the layout has no place, so it does not say how records lie in a block")
            .help("end it with `.aos`, `.soa`, `.split` or `.place([..])`");
    }
}

/// The order of memory is read off a list of constant length.
fn check_depth(branch: &Branch, errors: &mut Diagnostics) {
    let sized = branch.steps.iter().filter_map(|step| match step {
        Step::Node(node) if node.sizes.is_some() => Some(&node.name),
        _ => None,
    });
    if let Some(name) = sized.clone().nth(MOST_NODES) {
        errors
            .error(
                Code::TooManyNodes,
                name,
                format!("the layout has {} nodes with a size, and can have {MOST_NODES} at most", sized.count()),
            )
            .help("make one node of some that nest: `dense(i, 4).dense(i, 2)` lies as `dense(i, 8)` does");
    }
}

fn check_words(branch: &Branch, errors: &mut Diagnostics) {
    let mut along = [1u128; AXES.len()];
    for (number, step) in branch.steps.iter().enumerate() {
        match step {
            Step::Node(node) => {
                check_node(node, number == 0, errors);
                check_product(node, &mut along, errors);
            }
            Step::Place(place) => check_place(place, errors),
            Step::Pad(pad) => check_pad(pad, branch.steps.get(number + 1), errors),
            Step::List(list) => super::lists::check(list, branch, number, errors),
            Step::Unknown(name) => check_unknown(name, errors),
        }
    }
}

fn check_unknown(name: &Ident, errors: &mut Diagnostics) {
    let text = name.to_string();
    if let Some(named) = NAMED.iter().find(|named| named.split('<').next() == Some(&text)) {
        errors
            .error(Code::UnknownNode, name, format!("`{text}` is a named layout, and no node or place"))
            .help(format!("write `{named}` alone as the type, without `layout!`"));
        return;
    }
    let error = errors.error(Code::UnknownNode, name, format!("there is no node or place `{text}`"));
    match nearest(&text, WORDS) {
        Some(near) => error.help(format!("did you mean `{near}`?")),
        None => error.help(
            "the nodes are `dense`, `morton`, `pointer`, `bitmasked`, `hash` and `dynamic`; the places are `aos`, `soa`, `split` and `place`",
        ),
    };
}

fn check_node(node: &Node, outermost: bool, errors: &mut Diagnostics) {
    let name = &node.name;
    let Some(list) = &node.axes else {
        errors
            .error(Code::WrongArguments, name, format!("`{name}` does not say over which axes it goes"))
            .help(format!("write `{name}(ij)`, or `{name}(ij, 8)` for blocks of 8 by 8"));
        return;
    };
    check_axes(list, errors);
    if node.kind == Kind::Hash {
        check_hash(node, list, outermost, errors);
        return;
    }
    if let Some(surplus) = &node.surplus {
        errors
            .error(Code::WrongArguments, surplus, format!("`{name}` takes axes and a size, and no more"))
            .help(format!("sizes that differ are a tuple, one an axis: `{name}(ij, (4, 2))`"));
    }
    match &node.sizes {
        Some(sizes) => check_sizes(node, list, sizes, errors),
        None if outermost && node.kind != Kind::Morton => {}
        None if node.kind == Kind::Morton => {
            errors
                .error(
                    Code::NoSize,
                    name,
                    "`morton` needs a size, since its cells are a constant number of whole bits along each axis",
                )
                .help(format!(
                    "write `{name}({0}, 8)` for blocks of 8 cells an axis, as many as the shape needs",
                    list.name
                ));
        }
        None => {
            errors
                .error(
                    Code::NoSize,
                    name,
                    format!(
                        "an inner `{name}` needs a size, since only the outermost node takes it from the field's shape"
                    ),
                )
                .help(format!("write `{name}({}, 8)`", list.name));
        }
    }
}

/// `hash` is the root, and has as many cells as are needed.
fn check_hash(node: &Node, list: &AxisList, outermost: bool, errors: &mut Diagnostics) {
    let (name, axes) = (&node.name, &list.name);
    if !outermost {
        errors
            .error(
                Code::WrongHash,
                name,
                "`hash` stands below another node, and it finds the cells of the outermost one",
            )
            .note("it is what makes a field unbounded: below a node with a size there are as many cells as that says")
            .help(format!("begin the layout with `hash({axes})`, or write `pointer({axes}, 8)` here"));
    }
    if let Some(sizes) = &node.sizes {
        errors
            .error(Code::WrongHash, &sizes.at, "`hash` takes no size: it has as many cells as are needed")
            .help(format!("write `hash({axes}).dense({axes}, {})` for blocks of that size", sizes.at));
    } else if let Some(surplus) = &node.surplus {
        errors
            .error(Code::WrongArguments, surplus, "`hash` takes axes, and no more")
            .help(format!("write `hash({axes})`"));
    }
}

pub(super) fn check_axes(list: &AxisList, errors: &mut Diagnostics) {
    if !list.unknown.is_empty() {
        let letters: Vec<String> = list.unknown.iter().map(|letter| format!("`{letter}`")).collect();
        let message = match &letters[..] {
            [letter] => format!("there is no axis {letter}"),
            letters => format!("there are no axes {}", letters.join(", ")),
        };
        let meant: Option<String> = list.name.to_string().chars().map(meant).collect();
        errors.error(Code::UnknownAxis, &list.name, message).help(match meant {
            Some(word) => format!("axes are `i`, `j`, `k` and `l`: write `{word}`"),
            None => "axes are `i`, `j`, `k` and `l`".to_owned(),
        });
    }
    for (at, axis) in list.axes.iter().enumerate() {
        if list.axes[..at].contains(axis) {
            let letter = axis.letter();
            errors
                .error(Code::AxisTwice, &list.name, format!("axis `{letter}` stands twice in one node"))
                .help(format!("split an axis over nodes that nest: `dense({letter}).dense({letter}, 8)`"));
        }
    }
}

/// The axis that a letter means, perhaps under a name that coordinates have elsewhere.
fn meant(letter: char) -> Option<char> {
    match letter.to_ascii_lowercase() {
        'x' => Some('i'),
        'y' => Some('j'),
        'z' => Some('k'),
        'w' => Some('l'),
        letter => AXES.contains(&letter).then_some(letter),
    }
}

fn check_sizes(node: &Node, list: &AxisList, sizes: &Sizes, errors: &mut Diagnostics) {
    let name = &node.name;
    let letters = list.axes.len() + list.unknown.len();
    if sizes.each && sizes.list.len() != letters {
        let counted = |count, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
        let message = format!(
            "`{name}` has {} for {}",
            counted(sizes.list.len(), "size", "sizes"),
            counted(letters, "axis", "axes")
        );
        errors
            .error(Code::SizeCount, &sizes.at, message)
            .help(format!("give one size for all, `{name}({0}, 8)`, or one an axis, in the order of `{0}`", list.name));
    }
    for size in &sizes.list {
        match size {
            Size::Number(0, literal) => {
                errors
                    .error(Code::WrongSize, literal, "a block of size 0 has no cells")
                    .help("sizes are positive integers, or constants of type `usize`");
            }
            Size::Number(TOO_LARGE.., literal) => {
                errors
                    .error(Code::WrongSize, literal, "the block is too large, since indices are `i32`")
                    .help("only the outermost node is large, and it has no size: the shape decides");
            }
            Size::Number(number, literal) if node.kind == Kind::Morton && !number.is_power_of_two() => {
                let above = number.next_power_of_two();
                errors
                    .error(
                        Code::NotAPowerOfTwo,
                        literal,
                        format!("the size {number} of a `{name}` block is no power of two, so it has no whole bits to interleave"),
                    )
                    .help(format!("the sizes near are {} and {above}; `dense` takes any", above / 2));
            }
            Size::Number(..) | Size::Constant(_) => {}
            Size::Wrong(at, Some(axes)) => {
                errors
                    .error(Code::WrongSize, at, format!("`{axes}` stands where the size of the block is expected"))
                    .help(format!("the axes of a node are one word: `{name}({}{axes})`", list.name));
            }
            Size::Wrong(at, None) => {
                errors
                    .error(Code::WrongSize, at, "this is not the size of a block")
                    .help("sizes are positive integers, or constants of type `usize`");
            }
        }
    }
}

/// The blocks along an axis, all together, are within what an index reaches.
fn check_product(node: &Node, along: &mut [u128; AXES.len()], errors: &mut Diagnostics) {
    let (Some(list), Some(sizes)) = (&node.axes, &node.sizes) else { return };
    for (at, axis) in list.axes.iter().enumerate() {
        // A size that is wrong by itself is reported already.
        let Some(Size::Number(size @ 1..TOO_LARGE, literal)) = sizes.along(at) else { continue };
        let before = along[axis.0];
        along[axis.0] = before.saturating_mul(*size);
        if before < TOO_LARGE && along[axis.0] >= TOO_LARGE {
            let letter = axis.letter();
            errors
                .error(
                    Code::WrongSize,
                    literal,
                    format!("the blocks along axis `{letter}` are too large together, since indices are `i32`"),
                )
                .help("leave the size of the outermost node out: the shape decides it");
        }
    }
}

/// A field over `ij` needs both: the axes of a layout begin with `i` and leave none out.
fn check_axes_used(branch: &Branch, errors: &mut Diagnostics) {
    let mut used: Vec<(Axis, &AxisList)> = Vec::new();
    for step in &branch.steps {
        match step.axes() {
            Some(list) if list.unknown.is_empty() => used.extend(list.axes.iter().map(|axis| (*axis, list))),
            None if matches!(step, Step::Place(_) | Step::Pad(_)) => {}
            // Who knows which axes this was to have.
            _ => return,
        }
    }
    let Some(&(highest, list)) = used.iter().max_by_key(|(axis, _)| *axis) else { return };
    let missing = (0..highest.0).map(Axis).find(|axis| used.iter().all(|(used, _)| used != axis));
    if let Some(missing) = missing {
        let all: String = AXES[..=highest.0].iter().collect();
        let message = format!("the layout has axis `{}` but no axis `{}`", highest.letter(), missing.letter());
        errors
            .error(Code::MissingAxis, &list.name, message)
            .help(format!("the axes of a field begin with `i` and leave none out: name all of `{all}`"));
    }
}

fn check_pad(pad: &Pad, next: Option<&Step>, errors: &mut Diagnostics) {
    let name = &pad.name;
    let right = "write a power of two up to 4096, a cache line say: `.pad(64)`";
    match &pad.bytes {
        None => {
            errors
                .error(
                    Code::WrongArguments,
                    name,
                    format!("`{name}` does not say to how many bytes starts are aligned"),
                )
                .help(right);
        }
        Some(Size::Number(bytes, _)) if bytes.is_power_of_two() && *bytes <= WIDEST_PAD => {}
        Some(Size::Number(bytes, literal)) => {
            errors.error(Code::WrongPad, literal, format!("starts cannot be aligned to {bytes} bytes")).help(right);
        }
        Some(Size::Wrong(at, _)) => {
            errors.error(Code::WrongPad, at, "this is no number of bytes").help(right);
        }
        Some(Size::Constant(_)) => {}
    }
    if let Some(surplus) = &pad.surplus {
        errors
            .error(Code::WrongArguments, surplus, format!("`{name}` takes a number of bytes, and no more"))
            .help(right);
    }
    if let Some(next @ (Step::Node(_) | Step::Pad(_) | Step::List(_))) = next {
        errors
            .error(
                Code::WrongPad,
                name,
                format!(
                    "`{name}` stands before `{}`, and it says how the place lies in the innermost node",
                    next.name()
                ),
            )
            .help(format!("put `{name}` once, right before the place"));
    }
}

fn check_place(place: &Place, errors: &mut Diagnostics) {
    let name = &place.name;
    if let Some(surplus) = &place.surplus {
        errors
            .error(Code::WrongArguments, surplus, format!("the place `{name}` takes no arguments"))
            .help(format!("write `.{name}`, or `.place([v, m])` to name members"));
    }
    if let PlaceKind::Groups(groups) = &place.kind {
        if groups.is_empty() {
            errors
                .error(Code::WrongGroup, name, "`place` has no groups of members")
                .help("write `.place([v, m])`, or `.aos` for all members together");
        }
        for group in groups {
            check_group(group, errors);
        }
    }
}

fn check_group(group: &Group, errors: &mut Diagnostics) {
    for wrong in &group.wrong {
        errors
            .error(Code::WrongGroup, wrong, "this is no group of members")
            .help("a group is a list of members' names in brackets: `[v, split(c)]`");
    }
    if group.members.is_empty() && group.wrong.is_empty() {
        errors
            .error(Code::WrongGroup, &group.at, "a group without members has nothing to place")
            .help("name a member in it, or leave the group out");
    }
    for member in &group.members {
        let (text, name) = (member.text(), &member.name);
        let bytes = text.len();
        if bytes > LONGEST_NAME {
            errors
                .error(
                    Code::LongName,
                    name,
                    format!(
                        "the name `{text}` has {bytes} bytes, and a layout can carry names of {LONGEST_NAME} at most"
                    ),
                )
                .help("shorten the member's name");
        }
    }
}

/// Each member in one group, and a record that says whose members they are.
fn check_members(layout: &Layout, errors: &mut Diagnostics) {
    let mut seen: Vec<String> = Vec::new();
    let mut place = None;
    for step in layout.branches.iter().flat_map(|branch| &branch.steps) {
        let Step::Place(Place { name, kind: PlaceKind::Groups(groups), .. }) = step else { continue };
        place = place.or(Some(name));
        for member in groups.iter().flat_map(|group| &group.members) {
            let text = member.text();
            // A record is placed with all of its members.
            let below = |outer: &str, inner: &str| inner.strip_prefix(outer).is_some_and(|rest| rest.starts_with('.'));
            if seen.iter().any(|known| *known == text || below(known, &text) || below(&text, known)) {
                errors
                    .error(
                        Code::PlacedTwice,
                        &member.name,
                        format!("the member `{text}` is placed twice, and can lie in one place only"),
                    )
                    .help(format!("name `{text}` in one group"));
            }
            seen.push(text);
        }
    }
    if let (Some(place), None) = (place, &layout.record) {
        errors
            .error(Code::NoRecord, place, "the layout names members but does not say whose they are")
            .help("name the record first: `layout!(Node: dense(ij).place([v], [m]))`");
    }
}
