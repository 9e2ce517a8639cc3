//! The parts of a page: a file each, and a line in the list.

mod counts;
mod hardware;
mod kernels;
mod maps;
mod method;
mod ranking;
mod scene;
mod sizes;
mod verdict;

use super::{Findings, Html};
use crate::lab::errors::LabError;

pub(super) use self::verdict::verdict;

/// A part of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::lab) struct Section {
    /// Its name in links: small letters.
    pub(in crate::lab) id: &'static str,
    /// Its headline.
    pub(in crate::lab) title: &'static str,
    /// What stands below.
    pub(in crate::lab) body: Html,
}

/// Makes a part of what was found, if there is something to tell.
type Make = fn(&Findings) -> Result<Option<Section>, LabError>;

/// All parts, in their order.
const ALL: &[Make] = &[
    verdict::section,
    scene::section,
    ranking::section,
    kernels::section,
    sizes::section,
    maps::section,
    counts::section,
    hardware::section,
    method::section,
];

/// The parts of a page.
pub(super) fn sections(findings: &Findings) -> Result<Vec<Section>, LabError> {
    ALL.iter().filter_map(|make| make(findings).transpose()).collect()
}

/// `a, b and c`.
fn listed(words: &[String]) -> String {
    joined(words, "and")
}

/// `a, b or c`.
fn either(words: &[String]) -> String {
    joined(words, "or")
}

fn joined(words: &[String], by: &str) -> String {
    match words {
        [] => String::new(),
        [word] => word.clone(),
        [first @ .., last] => format!("{} {by} {last}", first.join(", ")),
    }
}

/// Names as code.
fn code<'a>(names: impl IntoIterator<Item = &'a String>) -> Vec<String> {
    names.into_iter().map(|name| format!("`{name}`")).collect()
}

#[cfg(test)]
mod tests {
    use super::{either, listed};

    #[test]
    fn lists_end_with_and() {
        let words = ["a", "b", "c"].map(String::from);
        assert_eq!([0, 1, 2, 3].map(|n| listed(&words[..n])), ["", "a", "a and b", "a, b and c"]);
        assert_eq!(either(&words), "a, b or c");
    }
}
