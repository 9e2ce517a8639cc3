//! The description of a field that stands in its file as JSON, for readers other than this library: the arrays tell it
//! all that it must know. Of the description it reads the beginning alone, which is always the same and says which
//! version of the format it is.

use std::io::Read;

use super::{FileFault, array_name, npy};
use crate::axes::Axes;
use crate::layout::Layout;
use crate::record::{ElementList, Record};

/// Its name in the archive.
pub(super) const NAME: &str = "allotrope.json";

/// With what every description of this version begins.
const BEGINNING: &str = "{\n  \"format\": \"allotrope field\",\n  \"version\": 1,\n";

/// The longest description that is read: members have names of their programs' sources.
const LONGEST: u64 = 1 << 20;

/// The description of a field of these extents.
pub(super) fn write<R: Record, L: Layout<X>, X: Axes>(shape: &[u64]) -> String {
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
    format!("{BEGINNING}  \"shape\": {shape:?},\n  \"layout\": {layout},\n  \"members\": [\n{members}\n  ]\n}}\n")
}

/// A name between quotes. Names of Rust have no characters that JSON wants told in another way but, at most, these two.
fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Whether the description is of the version that is written.
pub(super) fn check(input: impl Read) -> Result<(), FileFault> {
    let fault = |why: String| FileFault::Entry { entry: NAME.into(), why };
    let mut text = Vec::new();
    input.take(LONGEST + 1).read_to_end(&mut text).map_err(|error| fault(format!("is cut off or damaged: {error}")))?;
    if text.len() as u64 > LONGEST {
        return Err(fault(format!("has more than {LONGEST} bytes")));
    }
    if text.starts_with(BEGINNING.as_bytes()) {
        return Ok(());
    }
    text.truncate(BEGINNING.len());
    Err(FileFault::Format { entry: NAME.into(), found: String::from_utf8_lossy(&text).into_owned() })
}
