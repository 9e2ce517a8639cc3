//! Which candidates stay.

use crate::lab::statistics::{median, median_ratio_interval};

/// The numbers of the better half, and of those that cannot be told from its last one: of all candidates' times in the same pieces.
pub(super) fn survivors(pieces: &[Vec<f64>]) -> Vec<usize> {
    let medians: Vec<f64> = pieces.iter().map(|times| median(times)).collect();
    let mut ranked: Vec<usize> = (0..pieces.len()).collect();
    ranked.sort_by(|&a, &b| medians[a].total_cmp(&medians[b]));
    let half = pieces.len().div_ceil(2);
    let Some(&last) = ranked.get(half.wrapping_sub(1)) else { return Vec::new() };
    let (better, worse) = ranked.split_at(half);
    let level = |n: &usize| median_ratio_interval(&pieces[*n], &pieces[last])[0] <= 1.0;
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
        assert_eq!(survivors(&times), [1, 3, 0]);
        assert_eq!(survivors(&times[..1]), [0]);
        assert_eq!(survivors(&[]), Vec::<usize>::new());
    }

    #[test]
    fn what_cannot_be_told_apart_stays() {
        let alternating = |low: f64, high: f64| (0..8).map(|n| if n % 2 == 0 { low } else { high }).collect::<Vec<_>>();
        let (a, b, c, d) = (vec![1.0; 8], alternating(1.0, 1.2), alternating(1.2, 1.05), vec![9.0; 8]);
        // The third is a little slower on the whole than the second, and faster in half of the pieces.
        assert_eq!(survivors(&[a.clone(), b.clone(), c, d.clone()]), [0, 1, 2]);
        // Where it is slower in each piece, it goes.
        assert_eq!(survivors(&[a.clone(), b.clone(), vec![1.3; 8], d.clone()]), [0, 1]);
        // One piece in which something else ran does not count.
        let mut disturbed = vec![1.05; 8];
        disturbed[3] = 20.0;
        assert_eq!(survivors(&[vec![1.1; 8], a, disturbed, d]), [1, 2]);
    }
}
