//! Shapes, and how many bytes a layout takes over them.

use super::branch::Branch;
use super::layout::Layout;
use super::levels::Level;
use super::nodes::AXES;
use crate::lab::errors::LabError;

/// Extents along all axes, a list's with them.
pub(super) fn of(text: &str, layout: &Layout, given: Option<&[usize]>) -> Result<Vec<usize>, LabError> {
    let list = layout.branches.iter().find_map(|chain| chain.list);
    let wanted = layout.rank - usize::from(list.is_some());
    let small: &[usize] = match wanted {
        0 => &[],
        1 if list.is_some() => &[16],
        1 => &[64],
        2 => &[16, 16],
        3 => &[8, 8, 8],
        _ => &[4, 4, 4, 4],
    };
    let mut shape = given.unwrap_or(small).to_vec();
    let written = join(&shape);
    if shape.len() != wanted {
        let letters: String = AXES[..layout.rank].iter().collect();
        let own =
            list.map_or(String::new(), |list| format!(" (`{}` is the lists' own, and is left out)", AXES[list.axis]));
        let (has, right) = (shape.len(), join(small));
        return Err(LabError::usage(format!(
            "shape `{written}`: it has {has} extents, and the layout `{text}` goes over `{letters}`{own}; write `{right}`, say"
        )));
    }
    for (axis, &extent) in shape.iter().enumerate() {
        if extent == 0 || i32::try_from(extent).is_err() {
            let letter = AXES[axis];
            return Err(LabError::usage(format!(
                "shape `{written}`: axis `{letter}` cannot have {extent} elements; write from 1 to {}",
                i32::MAX
            )));
        }
    }
    if let Some(list) = list {
        shape.push(list.most);
    }
    for chain in &layout.branches {
        let branch = Branch::new(chain, Vec::new(), &[]);
        let extent = branch.root_extent();
        let short = (0..shape.len()).find(|axis| !branch.root.contains(axis) && shape[*axis] as i64 > extent[*axis]);
        if let Some(axis) = short {
            let (letter, most, elements) = (AXES[axis], extent[axis], shape[axis]);
            return Err(LabError::usage(format!(
                "shape `{written}`: axis `{letter}` has {elements} elements, and the layout `{text}` holds {most} at most, since its outermost \
                 node does not name it; write `{letter}` there, too"
            )));
        }
    }
    Ok(shape)
}

fn join(shape: &[usize]) -> String {
    shape.iter().map(usize::to_string).collect::<Vec<_>>().join(",")
}

/// The root of a dense branch, and where in memory the branch begins.
pub(super) type Rooted = (Level, usize);

/// The roots of the dense branches with where each begins, and the bytes of them all.
pub(super) fn lay(branches: &[Branch], shape: &[usize]) -> Result<(Vec<Option<Rooted>>, usize), LabError> {
    let too_many = || {
        let written = join(shape);
        LabError::usage(format!(
            "shape `{written}`: so many elements have more bytes than a machine can address; write a smaller shape"
        ))
    };
    let (mut roots, mut end) = (Vec::new(), 0usize);
    for (number, branch) in branches.iter().enumerate() {
        // A branch begins where it or one behind it asks for.
        let line = branches[number.saturating_sub(1)..].iter().map(Branch::line).max().unwrap_or(1);
        let start = if number == 0 { 0 } else { end.checked_next_multiple_of(line).ok_or_else(too_many)? };
        if branch.sparse.is_some() {
            // In its stead the memory holds an address, on a line of its own.
            branch.block().ok_or_else(too_many)?;
            let line = branches[number..].iter().map(Branch::line).max().unwrap_or(1);
            roots.push(None);
            end = start + line;
            continue;
        }
        let root = branch.root_over(shape).ok_or_else(too_many)?;
        let cells = root.cells().checked_mul(branch.levels.cells()).ok_or_else(too_many)?;
        let bytes = branch.bytes(cells).and_then(|bytes| bytes.checked_add(start));
        end = bytes.filter(|bytes| isize::try_from(*bytes).is_ok()).ok_or_else(too_many)?;
        roots.push(Some((root, start)));
    }
    Ok((roots, end))
}
