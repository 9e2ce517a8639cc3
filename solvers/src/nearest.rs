//! The name that was probably meant.

/// The known name nearest to `name`, if one is near enough to be a slip of the finger (Damerau-Levenshtein distance of
/// at most a third of the longer name, at least one), or if one begins with the other.
///
/// ```
/// use allotrope_solvers::nearest;
/// assert_eq!(nearest("mmp88", ["mpm88", "bunny"]), Some("mpm88"));
/// assert_eq!(nearest("teapot", ["mpm88", "bunny"]), None);
/// ```
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let near = |candidate: &str| {
        let distance = strsim::damerau_levenshtein(&name, candidate);
        let longer = name.chars().count().max(candidate.chars().count());
        let prefix = name.len() >= 2 && (candidate.starts_with(&name) || name.starts_with(candidate));
        (prefix || distance <= (longer / 3).max(1)).then_some(distance)
    };
    known.into_iter().filter_map(|candidate| Some((near(candidate)?, candidate))).min().map(|(_, candidate)| candidate)
}

/// `; did you mean ..` where a name is near, else `; known: ..` with all of them.
pub(crate) fn hint<'a>(name: &str, known: impl IntoIterator<Item = &'a str> + Clone) -> String {
    match nearest(name, known.clone()) {
        Some(candidate) => format!("; did you mean `{candidate}`?"),
        None => {
            let names: Vec<_> = known.into_iter().map(|name| format!("`{name}`")).collect();
            format!("; known are {}", names.join(", "))
        }
    }
}
