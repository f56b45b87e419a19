//! Seas that stay whole, and lands that stay apart: a delta neither cuts water off from its sea nor joins two islands.

use crate::base::parts::Parts;

/// The depths below which waters are to stay connected, in units from the coast: any water, and water that is more than a
/// hair's breadth wide, since a narrower strait may close where coasts are traced.
const DEPTHS: [f32; 2] = [0.0, 2.0];

/// The least number of corners of an island; a delta may reach an islet.
const ISLAND: usize = 60;

/// The waters and lands of a map.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    /// The waters at each depth.
    waters: Vec<Parts>,
    lands: Vec<Parts>,
}

impl Pieces {
    /// Finds the pieces on a lattice of so many columns, from distances from the coast, negative at sea.
    pub fn of(heights: &[f32], columns: usize) -> Self {
        let waters = DEPTHS.map(|depth| waters(heights, columns, depth)).to_vec();
        Self { waters, lands: vec![lands(heights, columns)] }
    }

    /// Finds the pieces after land has grown; `None` if a water would be in two parts, or two lands in one.
    pub fn after(&self, heights: &[f32], columns: usize) -> Option<Self> {
        let mut after = Self::default();
        for (before, depth) in self.waters.iter().zip(DEPTHS) {
            let waters = waters(heights, columns, depth);
            is_whole(before, &waters).then(|| after.waters.push(waters))?;
        }
        for before in &self.lands {
            let lands = lands(heights, columns);
            are_apart(before, &lands).then(|| after.lands.push(lands))?;
        }
        Some(after)
    }
}

/// Numbers the waters of a lattice that are deeper than some distance from the coast.
fn waters(heights: &[f32], columns: usize, depth: f32) -> Parts {
    let is_deep: Vec<bool> = heights.iter().map(|height| *height <= -depth).collect();
    Parts::of(&is_deep, columns)
}

/// Numbers the lands of a lattice.
fn lands(heights: &[f32], columns: usize) -> Parts {
    let is_land: Vec<bool> = heights.iter().map(|height| *height > 0.0).collect();
    Parts::of(&is_land, columns)
}

/// Returns `true` if each water of before is one water, or none, after.
fn is_whole(before: &Parts, after: &Parts) -> bool {
    let mut part_of_sea = vec![0; before.count + 1];
    let mut pairs = before.number.iter().zip(&after.number).filter(|(_, after)| **after > 0);
    pairs.all(|(&before, &after)| {
        let known = std::mem::replace(&mut part_of_sea[before as usize], after);
        known == 0 || known == after
    })
}

/// Returns `true` if each land of after was one island, or none, before.
fn are_apart(before: &Parts, after: &Parts) -> bool {
    let mut size = vec![0; before.count + 1];
    before.number.iter().for_each(|&number| size[number as usize] += 1);
    let mut island_of_land = vec![0; after.count + 1];
    let pairs = before.number.iter().zip(&after.number);
    let mut islands = pairs.filter(|(before, _)| **before > 0 && size[**before as usize] >= ISLAND);
    islands.all(|(&before, &after)| {
        let known = std::mem::replace(&mut island_of_land[after as usize], before);
        known == 0 || known == before
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: usize = 7;

    /// Distances from the coast: two basins with a strait of some depth between them, in two rows.
    fn basins(strait: f32) -> Vec<f32> {
        let row = |strait: f32| [4.0, -9.0, -9.0, strait, -9.0, -9.0, 4.0];
        [row(strait), row(4.0)].concat()
    }

    #[test]
    fn a_sea_stays_whole_as_long_as_water_leads_through_it() {
        let pieces = Pieces::of(&basins(-6.0), COLUMNS);
        assert!(pieces.after(&basins(-3.0), COLUMNS).is_some());
        assert!(pieces.after(&basins(-1.0), COLUMNS).is_none(), "a hair's breadth of water is no strait");
        assert!(pieces.after(&basins(1.0), COLUMNS).is_none());
        let mut filled = basins(1.0);
        filled[4..].iter_mut().for_each(|height| *height = 4.0);
        assert!(pieces.after(&filled, COLUMNS).is_some(), "a basin that is filled is cut off from nothing");
    }

    #[test]
    fn a_strait_that_was_narrow_before_stays_open() {
        let pieces = Pieces::of(&basins(-1.0), COLUMNS);
        assert!(pieces.after(&basins(-0.5), COLUMNS).is_some());
        assert!(pieces.after(&basins(1.0), COLUMNS).is_none());
    }

    #[test]
    fn islands_stay_apart_and_islets_may_be_joined() {
        /// Six rows of two lands, the western one of so many columns, with four columns of water between.
        fn islands(west: usize) -> Vec<f32> {
            [vec![9.0; west], vec![-9.0; 4], vec![9.0; 20]].concat().repeat(6)
        }
        for (west, is_free) in [(10, false), (9, true)] {
            let columns = west + 24;
            let mut joined = islands(west);
            joined[west..west + 4].fill(1.0);
            let pieces = Pieces::of(&islands(west), columns);
            assert_eq!(pieces.after(&joined, columns).is_some(), is_free, "{west}");
        }
    }
}
