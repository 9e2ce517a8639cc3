//! The known name that a mistyped one is nearest to.

/// The known name nearest to `name`, if one is near: as many edits as a third of its letters, one at least. Capitals count for nothing.
pub(crate) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let reach = (name.chars().count() / 3).max(1);
    known
        .into_iter()
        .map(|known| (strsim::damerau_levenshtein(&name, &known.to_lowercase()), known))
        .filter(|(distance, _)| *distance <= reach)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, known)| known)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let known = ["dense", "pointer", "aos", "soa"];
        assert_eq!(nearest("dens", known), Some("dense"));
        assert_eq!(nearest("Dense", known), Some("dense"));
        assert_eq!(nearest("pionter", known), Some("pointer"));
        assert_eq!(nearest("sao", known), Some("soa"));
        assert_eq!(nearest("blocked", known), None);
    }
}
