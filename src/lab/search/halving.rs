//! Which candidates stay.

use crate::lab::statistics::mean_ratio_interval;

/// The numbers of the better half, and of those that cannot be told from its last one: of all candidates' times in the same pieces.
pub(super) fn survivors(pieces: &[&[f64]]) -> Vec<usize> {
    let sum = |n: &usize| pieces[*n].iter().sum::<f64>();
    let mut ranked: Vec<usize> = (0..pieces.len()).collect();
    ranked.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
    let half = pieces.len().div_ceil(2);
    let Some(&last) = ranked.get(half.wrapping_sub(1)) else { return Vec::new() };
    let (better, worse) = ranked.split_at(half);
    let level = |n: &usize| mean_ratio_interval(pieces[*n], pieces[last])[0] <= 1.0;
    better.iter().chain(worse.iter().filter(|n| level(n))).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slower_half_is_dropped() {
        let times: Vec<Vec<f64>> = [3.0, 1.0, 4.0, 2.0, 5.0]
            .iter()
            .map(|time| (0..8).map(|n| time + 0.01 * f64::from(n % 3)).collect())
            .collect();
        let pieces: Vec<&[f64]> = times.iter().map(|times| &times[..]).collect();
        assert_eq!(survivors(&pieces), [1, 3, 0]);
        assert_eq!(survivors(&pieces[..1]), [0]);
        assert_eq!(survivors(&[]), Vec::<usize>::new());
    }

    #[test]
    fn what_cannot_be_told_apart_stays() {
        // The third is a little slower on the whole, by one piece in which all of the difference lies.
        let (a, b, mut c) = (vec![1.0; 8], vec![1.1; 8], vec![1.0; 8]);
        c[3] = 2.0;
        assert_eq!(survivors(&[&a, &b, &c, &[9.0; 8]]), [0, 1, 2]);
        // Where it is slower in each piece, it goes.
        assert_eq!(survivors(&[&a, &b, &[1.2; 8], &[9.0; 8]]), [0, 1]);
    }
}
