//! The ageing of oxbow lakes: rivers run over them, and silt fills them from their ends until they are gone. So there
//! are never many, and no lake overlaps another or a river.

use super::super::clearance::ClearanceGrid;
use super::super::settings::NetworkSettings;
use super::super::smooth::SHARE_OF_CLEARANCE;
use super::super::{Network, Oxbow, Vertex};
use super::{CAP, ROUNDS_A_SURVEY, respace};
use crate::base::geometry::fast_max;

/// The age at which silt begins to fill a lake, and at which it has filled it, in rounds at the default life.
const YOUNG: f32 = 24.0;
const OLD: f32 = 160.0;

/// Fills lakes with silt by their age, in rounds, over their life, a multiple of the default; and removes those that are gone.
pub(super) fn age(oxbows: &mut Vec<Oxbow>, round: u32, life: f32) {
    if life == 0.0 {
        oxbows.clear();
    }
    for oxbow in &mut *oxbows {
        let age = (round - oxbow.born) as f32 / life;
        oxbow.silt = ((age - YOUNG) / (OLD - YOUNG)).clamp(0.0, 1.0);
    }
    oxbows.retain(|oxbow| !oxbow.lake().is_empty());
}

/// Removes the parts of lakes that rivers of the last survey run over, or come so near to that moves could leave no land between.
pub(super) fn erode(network: &mut Network, downstream: &[u32], guard: &ClearanceGrid, settings: &NetworkSettings) {
    /// The greatest distance that a line moves between two surveys, in steps.
    const MOST_MOVE: f32 = CAP * (ROUNDS_A_SURVEY as f32 * SHARE_OF_CLEARANCE + respace::SHARE_OF_CLEARANCE);
    let margin = |lake: f32, river: &Vertex| {
        let apart = fast_max(settings.min_clearance, MOST_MOVE * settings.step(river.width()));
        lake + bank(river) + apart
    };
    let widest = network.vertices.iter().copied().max_by(|a, b| bank(a).total_cmp(&bank(b))).unwrap_or_default();
    let mut oxbows = std::mem::take(&mut network.oxbows);
    for lake in oxbows.iter_mut().flat_map(|oxbow| &mut oxbow.vertices).filter(|lake| lake.width() > 0.0) {
        let own = bank(lake);
        let largest = margin(own, &widest);
        if guard.is_near(network, downstream, lake.at, largest, |river| margin(own, river)) {
            (lake.left, lake.right) = (0.0, 0.0);
        }
    }
    network.oxbows = oxbows;
}

/// Returns the distance of the farther bank, in units.
fn bank(vertex: &Vertex) -> f32 {
    fast_max(vertex.left, vertex.right)
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{river, straight};
    use super::*;

    /// Makes a lake 60 units long and two wide, left in round 10.
    fn lake() -> Oxbow {
        let vertices = river(&straight((0.0, 0.0), (60.0, 0.0), 60), 2.0).vertices;
        Oxbow { river: 0, born: 10, silt: 0.0, vertices }
    }

    #[test]
    fn silt_narrows_and_shortens_a_lake_until_it_is_gone() {
        let mut oxbows = vec![lake()];
        let mut sizes = Vec::new();
        for round in 10..10 + OLD as u32 {
            age(&mut oxbows, round, 1.0);
            let lake = oxbows[0].lake();
            sizes.push((lake.len(), lake.iter().map(|(vertex, share)| vertex.width() * share).fold(0.0, f32::max)));
        }
        assert!(sizes[..=YOUNG as usize].iter().all(|&size| size == (61, 2.0)), "{sizes:?}");
        assert!(sizes.windows(2).all(|pair| pair[1].0 <= pair[0].0 && pair[1].1 <= pair[0].1), "{sizes:?}");
        let last = sizes[sizes.len() - 1];
        assert!(last.0 < 25 && last.1 < 1.1, "{last:?}");
        age(&mut oxbows, 10 + OLD as u32, 1.0);
        assert!(oxbows.is_empty());
    }

    #[test]
    fn lakes_last_as_long_as_is_asked() {
        let left = |life: f32, round: u32| {
            let mut oxbows = vec![lake()];
            age(&mut oxbows, round, life);
            oxbows.first().map(|oxbow| oxbow.silt)
        };
        assert_eq!([10, 11, 400].map(|round| left(0.0, round)), [None; 3], "none at all");
        assert_eq!([10, 200, 400].map(|round| left(f32::INFINITY, round)), [Some(0.0); 3], "no silt");
        assert!(left(2.0, 10 + OLD as u32).is_some_and(|silt| silt > 0.0) && left(0.5, 10 + OLD as u32 / 2).is_none());
    }

    #[test]
    fn a_lake_that_is_run_over_is_forgotten() {
        let mut oxbows = vec![lake()];
        oxbows[0].vertices.iter_mut().step_by(5).for_each(|vertex| (vertex.left, vertex.right) = (0.0, 0.0));
        age(&mut oxbows, 11, 1.0);
        assert!(oxbows.is_empty());
    }
}
