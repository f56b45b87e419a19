//! Wear of high ground: the higher it lies the gentler it is, so that the highest land is not far above all other, as where
//! ice grinds down what stands above the snow line (Brozović and others 1997).
//!
//! The cost of walking up becomes a height by one rising law: whatever was lower stays lower, and rivers fall as before.

/// The height that worn land approaches but never reaches, in units.
const CEILING: f32 = 280.0;

/// Returns the height of land by the cost of walking up to it, both in units.
pub(super) fn worn(cost: f32) -> f32 {
    CEILING * cost / (CEILING + cost)
}

/// Returns the cost of walking up to a height, both in units: the inverse of [`worn`].
pub(super) fn unworn(height: f32) -> f32 {
    // Heights above the ceiling, which a relief from elsewhere may have, give finite costs too.
    CEILING * height / (CEILING - height).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lowland_stays_and_high_ground_is_lowered_in_its_order() {
        assert_eq!((worn(0.0), unworn(0.0)), (0.0, 0.0));
        assert!(worn(1.0) > 0.99 && worn(CEILING) == 0.5 * CEILING && worn(1e4) < CEILING);
        let costs: Vec<f32> = (1..3000).map(|i| i as f32 * 0.3).collect();
        for pair in costs.windows(2) {
            let (low, high) = (worn(pair[0]), worn(pair[1]));
            assert!(low < high && high < pair[1], "{pair:?}: {low}, {high}");
            assert!((unworn(low) / pair[0] - 1.0).abs() < 1e-5, "{pair:?}: {low}");
        }
        assert!(unworn(CEILING).is_finite() && unworn(1e9).is_finite());
    }
}
