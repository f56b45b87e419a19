//! The areas that drain to places: how fast places become rarer the more land drains to them.

use super::fit;
use crate::base::sort;
use crate::tree::Tree;

/// The least area of the fit, in parcels, below which single parcels show, and the share of the basin up to which it
/// reaches: of larger areas there are too few, and the shape of the basin decides.
const LEAST: f64 = 8.0;
const GREATEST: f64 = 0.05;

/// The fewest areas of the fit.
const LEAST_AREAS: usize = 4;

/// Returns the exponent β in N(A ≥ a) ∝ a^−β, where N is the number of nodes of the greatest basin to which at least an area a
/// drains (Rodriguez-Iturbe and others 1992). Small basins would only add small areas. It is fitted by least squares to the
/// logarithms, for areas that double from one to the next. `None` for fewer than four areas.
pub fn area_exponent(tree: &Tree, area: &[u32]) -> Option<f64> {
    let areas = sort::sorted(&of_greatest_basin(tree, area));
    let greatest = GREATEST * f64::from(*areas.last()?);
    let bounds = std::iter::successors(Some(LEAST), |area| Some(area * 2.0)).take_while(|&area| area <= greatest);
    let points: Vec<(f64, f64)> = bounds
        .map(|bound| (bound, areas.len() - areas.partition_point(|&area| f64::from(area) < bound)))
        .map(|(bound, count)| (fit::log(bound), fit::log(count as f64)))
        .collect();
    if points.len() < LEAST_AREAS { None } else { fit::slope(&points).map(|slope| -slope) }
}

/// Lists the areas of the nodes that drain to the mouth of the greatest area.
fn of_greatest_basin(tree: &Tree, area: &[u32]) -> Vec<f32> {
    let mut mouth: Vec<u32> = (0..tree.len() as u32).collect();
    for node in 0..tree.len() {
        if let Some(parent) = tree.parent_of(node) {
            mouth[node] = mouth[parent];
        }
    }
    let greatest = (0..tree.len()).filter(|&node| mouth[node] as usize == node).max_by_key(|&node| area[node]);
    let own = (0..tree.len()).filter(|&node| greatest.is_some_and(|greatest| mouth[node] as usize == greatest));
    own.map(|node| area[node] as f32).collect()
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::tree::NO_PARENT;

    /// Makes a basin whose first node is its mouth, and into which all others run.
    fn basin(nodes: usize) -> Tree {
        let parent = (0..nodes).map(|node| if node == 0 { NO_PARENT } else { 0 }).collect();
        Tree { at: vec![Vec2::ZERO; nodes], parent, drained: vec![1; nodes], ..Tree::default() }
    }

    fn exponent(area: &[u32]) -> Option<f64> {
        area_exponent(&basin(area.len()), area)
    }

    /// Areas at the quantiles of a power law, the greatest first.
    fn areas(exponent: f64) -> Vec<u32> {
        const COUNT: u32 = 100_000;
        let area = |i: u32| libm::pow(f64::from(COUNT) / f64::from(i), 1.0 / exponent).min(1e9) as u32;
        (1..=COUNT).map(area).collect()
    }

    #[test]
    fn exponent_is_that_of_a_power_law() {
        for wanted in [0.3, 0.43, 0.6] {
            let found = exponent(&areas(wanted)).unwrap();
            assert!((found - wanted).abs() < 0.01, "{found}, not {wanted}");
        }
    }

    #[test]
    fn only_the_greatest_basin_counts() {
        let area = areas(0.43);
        let mut tree = basin(area.len());
        // A basin as great in number, whose areas are small.
        tree.parent.extend((0..area.len()).map(|node| if node == 0 { NO_PARENT } else { area.len() as u32 }));
        tree.at.resize(2 * area.len(), Vec2::ZERO);
        let of_both: Vec<u32> = area.iter().copied().chain(vec![9; area.len()]).collect();
        assert_eq!(area_exponent(&tree, &of_both), exponent(&area));
    }

    #[test]
    fn few_areas_say_nothing() {
        assert_eq!(exponent(&[]), None);
        assert_eq!(exponent(&[1; 100]), None);
        assert_eq!(exponent(&[1270, 64, 32, 16, 8]), None);
        assert!(exponent(&[1280, 64, 32, 16, 8]).is_some());
    }
}
