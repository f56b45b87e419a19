//! Fits of power laws: straight lines of least squares through logarithms.

/// Returns the slope of the least-squares line, y over x; `None` for fewer than two different x.
pub(super) fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
    let common: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    (spread > 0.0).then(|| common / spread)
}

/// Returns the ratio of the geometric series nearest to the values; `None` for fewer than two, or if one is not positive.
pub(super) fn ratio(values: &[f64]) -> Option<f64> {
    if values.iter().any(|&value| value <= 0.0) {
        return None;
    }
    let logs: Vec<(f64, f64)> = values.iter().enumerate().map(|(i, &value)| (i as f64, log(value))).collect();
    slope(&logs).map(|slope| libm::expf(slope as f32).into())
}

/// Returns the natural logarithm, with the precision of a 32-bit float: a 64-bit one would add a kilobyte to the page.
pub(super) fn log(value: f64) -> f64 {
    libm::logf(value as f32).into()
}

/// Returns the median, which is the mean of the middle two for an even number of values; `None` for an empty list.
pub(super) fn median(values: &[f32]) -> Option<f32> {
    let sorted = crate::base::sort::sorted(values);
    let upper = *sorted.get(sorted.len() / 2)?;
    Some((sorted[(sorted.len() - 1) / 2] + upper) / 2.0)
}

/// Returns the median of numbers, with the precision of 32-bit floats.
#[inline(never)] // it has several callers
pub(super) fn median_of(values: &[f64]) -> Option<f64> {
    median(&values.iter().map(|&value| value as f32).collect::<Vec<_>>()).map(f64::from)
}

/// Returns the mean of values; `None` for an empty list.
#[inline(never)] // it has several callers
pub(super) fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_found_among_points_beside_it() {
        // The line is y = 2x + 1, but the second point is one higher and the third one lower: 2 − 1 / 5.
        let found = slope(&[(0.0, 1.0), (1.0, 4.0), (2.0, 4.0), (3.0, 7.0)]).unwrap();
        assert!((found - 1.8).abs() < 1e-12, "{found}");
        assert_eq!(slope(&[(1.0, 1.0), (1.0, 2.0)]), None);
        assert_eq!(slope(&[]), None);
    }

    #[test]
    fn ratio_is_that_of_a_geometric_series() {
        assert!((ratio(&[3.0, 6.0, 12.0]).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(ratio(&[3.0]), None);
        assert_eq!(ratio(&[3.0, 0.0]), None);
    }

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[3.0, 1.0, 2.0, 9.0]), Some(2.5));
        assert_eq!(median(&[]), None);
    }
}
