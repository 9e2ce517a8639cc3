//! The description of a field that stands in its file as JSON, for readers other than this library: the arrays tell it
//! all that it must know but the origin. Of the description it reads the beginning alone, which is always the same and says
//! which version of the format it is, and the origin behind it.

use std::io::Read;

use super::{FileFault, array_name, npy};
use crate::axes::{Axes, MAX_AXES};
use crate::layout::{Geometry, Layout};
use crate::record::{ElementList, Record};

/// Its name in the archive.
pub(super) const NAME: &str = "allotrope.json";

/// With what every description of this version begins.
const BEGINNING: &str = "{\n  \"format\": \"allotrope field\",\n  \"version\": 1,\n";

/// The longest description that is read: members have names of their programs' sources.
const LONGEST: u64 = 1 << 20;

/// What stands before the first index along each axis.
const ORIGIN: &str = "  \"origin\": [";

/// The description of a field of these extents and first indices.
pub(super) fn write<R: Record, L: Layout<X>, X: Axes>(shape: &[u64], origin: &[i32]) -> String {
    let members: Vec<String> = R::Elements::MEMBERS
        .iter()
        .enumerate()
        .map(|(m, spec)| {
            let (name, scalar) = (quoted(array_name::<R>(m)), quoted(npy::descr(spec.kind)));
            format!("    {{ \"name\": {name}, \"scalar\": {scalar}, \"components\": {} }}", spec.components)
        })
        .collect();
    let layout = quoted(core::any::type_name::<L>());
    let members = members.join(",\n");
    let origin = origin.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    format!(
        "{BEGINNING}{ORIGIN}{origin}],\n  \"shape\": {shape:?},\n  \"layout\": {layout},\n  \"members\": [\n{members}\n  ]\n}}\n"
    )
}

/// A name between quotes. Names of Rust have no characters that JSON wants told in another way but, at most, these two.
fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\""))
}

/// The first index along each axis as a description of the version that is written says it, if it does.
pub(super) fn read(input: impl Read) -> Result<Option<String>, FileFault> {
    let fault = |why: String| FileFault::Entry { entry: NAME.into(), why };
    let mut text = Vec::new();
    input.take(LONGEST + 1).read_to_end(&mut text).map_err(|error| fault(format!("is cut off or damaged: {error}")))?;
    if text.len() as u64 > LONGEST {
        return Err(fault(format!("has more than {LONGEST} bytes")));
    }
    let Some(rest) = text.strip_prefix(BEGINNING.as_bytes()) else {
        text.truncate(BEGINNING.len());
        return Err(FileFault::Format { entry: NAME.into(), found: String::from_utf8_lossy(&text).into_owned() });
    };
    let Some(rest) = rest.strip_prefix(ORIGIN.as_bytes()) else { return Ok(None) };
    let list = rest.split(|&byte| byte == b']').next().unwrap_or_default();
    Ok(Some(String::from_utf8_lossy(list).into_owned()))
}

/// A geometry with the first indices that a description says.
pub(super) fn moved<X: Axes>(geometry: Geometry, origin: &Option<String>) -> Result<Geometry, FileFault> {
    let fault = |why: String| FileFault::Entry { entry: NAME.into(), why };
    let Some(list) = origin else { return Ok(geometry) };
    let numbers: Option<Vec<i64>> = match list.as_str() {
        "" => Some(Vec::new()),
        list => list.split(',').map(|number| number.trim().parse().ok()).collect(),
    };
    let numbers = numbers.filter(|numbers| numbers.len() == X::RANK).ok_or_else(|| {
        fault(format!("has `\"origin\": [{list}]`, which is not one integer for each of {} axes", X::RANK))
    })?;
    let mut origin = [0; MAX_AXES];
    origin[..X::RANK].copy_from_slice(&numbers);
    geometry.with_origin::<X>(origin).map_err(|error| fault(format!("has an `\"origin\"` that does not fit: {error}")))
}
