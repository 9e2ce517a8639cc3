//! Values of options, and lists of them.

use allotrope::MAX_THREADS;
use allotrope::probe::Cache;

/// A number above zero.
pub(super) fn count(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("it must be at least 1".into()),
        Ok(count) => Ok(count),
        Err(_) => Err("a whole number above zero is wanted".into()),
    }
}

/// A number of steps above zero.
pub(super) fn steps(text: &str) -> Result<u64, String> {
    match text.parse() {
        Ok(0) => Err("it must be at least 1".into()),
        Ok(steps) => Ok(steps),
        Err(_) => Err("a whole number above zero is wanted".into()),
    }
}

/// A number of threads.
pub(super) fn threads(text: &str) -> Result<usize, String> {
    match count(text)? {
        many if many > MAX_THREADS => Err(format!("{many} threads are more than the {MAX_THREADS} that are supported")),
        some => Ok(some),
    }
}

/// A number of degrees.
pub(super) fn finite(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(|| "a finite number is wanted".into())
}

/// A factor.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match finite(text)? {
        factor if factor > 0.0 => Ok(factor),
        _ => Err("it must be above zero".into()),
    }
}

/// A cache: its KiB, and the lines of a set.
pub(super) fn cache(text: &str) -> Result<Cache, String> {
    let (kib, ways) = text.split_once(',').ok_or("KiB and ways are wanted, with a comma between them: `32,8`")?;
    let bytes = count(kib.trim())?.checked_mul(1 << 10).ok_or("a cache of so many KiB cannot be")?;
    Ok(Cache { bytes, ways: count(ways.trim())? })
}

/// Extents, with commas between them: one to four.
pub(super) fn shape(text: &str) -> Result<std::sync::Arc<[usize]>, String> {
    let wanted = "one to four numbers with commas between them are wanted, `64,48` say";
    let extents: Result<Vec<usize>, _> = text.split(',').map(|extent| extent.trim().parse()).collect();
    extents.ok().filter(|extents| extents.len() <= 4).map(Into::into).ok_or_else(|| wanted.into())
}

/// The words between commas, each once.
pub(super) fn words(list: &str) -> Vec<&str> {
    let mut words: Vec<&str> = Vec::new();
    for word in list.split(',').map(str::trim).filter(|word| !word.is_empty()) {
        if !words.contains(&word) {
            words.push(word);
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_told_apart_and_kept_once() {
        assert_eq!(words("a, b,,a"), ["a", "b"]);
        assert!(words(" , ").is_empty());
    }

    #[test]
    fn numbers_are_checked() {
        assert_eq!(count("12"), Ok(12));
        assert_eq!(steps("18446744073709551615"), Ok(u64::MAX));
        assert_eq!(steps("0"), Err("it must be at least 1".into()));
        assert!(count("0").is_err() && count("-1").is_err() && threads("100000").is_err());
        assert_eq!(finite("-2.5"), Ok(-2.5));
        assert_eq!(cache("48,12"), Ok(Cache { bytes: 48 << 10, ways: 12 }));
        assert!(cache("48").is_err() && cache("0,8").is_err() && cache("32,x").is_err());
        assert_eq!(shape("64, 48").as_deref(), Ok(&[64, 48][..]));
        assert!(shape("").is_err() && shape("8,").is_err() && shape("1,2,3,4,5").is_err() && shape("-1").is_err());
        assert!(positive("0").is_err() && positive("1.5").is_ok());
        assert!(finite("inf").is_err() && finite("x").is_err());
    }
}
