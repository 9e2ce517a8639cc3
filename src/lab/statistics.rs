//! Order statistics of measured times.

/// The value at a fraction of the sorted values, by linear interpolation between neighbours; `NaN` if there are none.
pub fn quantile(values: &[f64], fraction: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = fraction.clamp(0.0, 1.0) * last as f64;
    let (low, high) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    low + (high - low) * place.fract()
}

/// The middle value.
pub fn median(values: &[f64]) -> f64 {
    quantile(values, 0.5)
}

/// The interquartile range over the median: how far runs differ, as a fraction.
pub fn spread(values: &[f64]) -> f64 {
    (quantile(values, 0.75) - quantile(values, 0.25)) / median(values)
}

/// The narrowest pair of values, equally far from both ends of the sorted ones, between which the median of what they are
/// drawn from lies with 95 % confidence, whatever its distribution; the least and the greatest where there are fewer than six
/// (David & Nagaraja 2003, "Order statistics", section 7.1). `NaN` if there are none.
pub fn median_interval(values: &[f64]) -> [f64; 2] {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len();
    // The chance that fewer than `rank` + 1 values of `count` lie below the median: a sum of binomials over two to the count.
    let (mut term, mut below, mut rank) = (0.5f64.powi(count as i32), 0.0, 0);
    while 2 * (rank + 1) < count && below + term <= 0.025 {
        below += term;
        term *= (count - rank) as f64 / (rank + 1) as f64;
        rank += 1;
    }
    // Of values below `rank` there is one too many.
    let rank = rank.saturating_sub(1);
    if count == 0 { [f64::NAN; 2] } else { [sorted[rank], sorted[count - 1 - rank]] }
}

/// Resamples of a bootstrap.
pub const RESAMPLES: usize = 1000;

/// Between which the ratio of two medians lies with 95 % confidence: from resampled pairs of values that were measured in turn (Efron &
/// Tibshirani 1993, "An introduction to the bootstrap", section 13.3). Single values that are far off do not matter. The same values give the same
/// interval. `NaN` if there are none.
///
/// # Panics
/// If there are not as many of both.
pub fn median_ratio_interval(values: &[f64], others: &[f64]) -> [f64; 2] {
    assert_eq!(values.len(), others.len(), "values and others are pairs");
    let mut state = 1u64;
    let mut drawn = || {
        // Knuth's MMIX generator, of which the high bits are good.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % values.len()
    };
    let ratio = |_| {
        let (drawn, paired): (Vec<f64>, Vec<f64>) =
            values.iter().map(|_| drawn()).map(|pair| (values[pair], others[pair])).unzip();
        median(&drawn) / median(&paired)
    };
    let ratios: Vec<f64> = (0..RESAMPLES).map(ratio).collect();
    [quantile(&ratios, 0.025), quantile(&ratios, 0.975)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate() {
        let values = [4.0, 1.0, 3.0, 2.0];
        assert_eq!(median(&values), 2.5);
        assert_eq!(quantile(&values, 0.0), 1.0);
        assert_eq!(quantile(&values, 0.25), 1.75);
        assert_eq!(quantile(&values, 1.0), 4.0);
        assert_eq!(median(&[7.0]), 7.0);
        assert!(median(&[]).is_nan());
    }

    #[test]
    fn the_interval_of_a_median_is_that_of_the_tables() {
        let ranks = |count: usize| {
            let values: Vec<f64> = (1..=count).rev().map(|n| n as f64).collect();
            median_interval(&values)
        };
        // The greatest rank below which at most 2.5 % of a binomial distribution of one half lie, by hand.
        let table = [
            (1, [1.0, 1.0]),
            (5, [1.0, 5.0]),
            (6, [1.0, 6.0]),
            (8, [1.0, 8.0]),
            (9, [2.0, 8.0]),
            (11, [2.0, 10.0]),
            (12, [3.0, 10.0]),
            (15, [4.0, 12.0]),
            (20, [6.0, 15.0]),
            (25, [8.0, 18.0]),
        ];
        for (count, wanted) in table {
            assert_eq!(ranks(count), wanted, "{count} values");
        }
        assert!(median_interval(&[])[0].is_nan());
    }

    #[test]
    fn the_interval_of_a_ratio_holds_it() {
        // Whatever slows both alike does not count.
        let noise = |n: usize| 1.0 + 0.5 * ((n * 7) % 11) as f64;
        let slow: Vec<f64> = (0..20).map(|n| 3.0 * noise(n)).collect();
        let fast: Vec<f64> = (0..20).map(|n| 2.0 * noise(n)).collect();
        let [low, high] = median_ratio_interval(&slow, &fast);
        assert!((low - 1.5).abs() < 1e-12 && (high - 1.5).abs() < 1e-12, "{low} {high}");
        // Independent values: the interval reaches as far as they do, and no farther.
        let other: Vec<f64> = (0..12).map(|n| 1.0 + 0.01 * f64::from(n)).collect();
        let [low, high] = median_ratio_interval(&other, &[1.0; 12]);
        assert!((1.0..1.04).contains(&low) && (1.07..1.11).contains(&high), "{low} {high}");
        // One that is far off does not matter.
        let mut slow: Vec<f64> = (0..11).map(|n| 2.0 + 0.01 * f64::from(n % 3)).collect();
        slow[4] = 90.0;
        let [low, high] = median_ratio_interval(&slow, &[1.0; 11]);
        assert!((2.0..=2.01).contains(&low) && (2.0..=2.02).contains(&high) && low <= high, "{low} {high}");
        assert!(median_ratio_interval(&[], &[])[0].is_nan());
    }

    #[test]
    fn spread_is_the_interquartile_range_over_the_median() {
        assert_eq!(spread(&[1.0, 2.0, 3.0, 4.0]), 0.6);
        assert_eq!(spread(&[5.0; 9]), 0.0);
        // One outlier does not matter.
        assert_eq!(spread(&[2.0, 2.0, 2.0, 2.0, 90.0]), 0.0);
    }
}
