//! Drafts of a relief with other mountains, for the moment while a slider moves, by a single look at each cell.
//!
//! Other mountains multiply the steepness of each hillside by a factor that changes slowly from place to place. So lower cells stay
//! lower: in the order of their former heights, each cell comes after those that it rises over, as in a marching front, without its
//! queue. The former heights tell how steep a cell was. Rivers stay as high as they were, except where the land is now lower.

use std::sync::Arc;

use super::cells::Cells;
use super::front::solved;
use super::steepness::slope;
use super::summits::{unworn, worn};
use super::{Relief, ReliefError, ReliefSettings};
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::sort::{argsort, key};
use crate::base::work;

/// A finished relief, prepared for drafts with other mountains.
#[derive(Debug)]
pub(crate) struct ReliefDrafts {
    relief: Arc<Relief>,
    /// The settings of the relief.
    settings: ReliefSettings,
    cells: Cells,
    /// The heights of all cells before wear, the rim included; infinite where there is no land.
    heights: Vec<f32>,
    /// All cells of land, the lowest first.
    order: Vec<usize>,
}

impl ReliefDrafts {
    /// Prepares drafts of a relief that was made with these settings.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(relief: &Arc<Relief>, settings: ReliefSettings) -> Result<Self, ReliefError> {
        const BYTES_A_CELL: usize = 24;
        let bytes = settings.grid.columns * settings.grid.rows * BYTES_A_CELL;
        let refused = |_| ReliefError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
        ask(bytes).map_err(refused)?;
        let cells = Cells::new(&settings).map_err(refused)?;
        let height = |cell| match cells.is_land(cell) {
            true => unworn(relief.heights[cells.without_rim(cell)]),
            false => f32::INFINITY,
        };
        let heights: Vec<f32> = (0..cells.inland.len()).map(height).collect();
        let mut order = argsort(heights.iter().map(|&height| key(height)));
        order.truncate(cells.land_count());
        work::count(4 * heights.len());
        Ok(Self { relief: relief.clone(), settings, cells, heights, order })
    }

    /// Returns an approximation of the relief with other mountains and plains.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn draft(&self, mountains: f32, plains: f32) -> Result<Relief, Refused> {
        let settings = ReliefSettings { mountains, plains, ..self.settings.clone() };
        let mut heights = Vec::new();
        lengthen(&mut heights, self.heights.len(), f32::INFINITY)?;
        ask(size_of_val(&self.relief.heights[..]))?;
        let mut relief = Relief::clone(&self.relief);
        work::count(5 * self.order.len());
        for &cell in &self.order {
            heights[cell] = self.height(cell, &settings, &heights);
            relief.heights[self.cells.without_rim(cell)] = worn(heights[cell]);
        }
        Ok(relief)
    }

    /// Computes the height of a cell from the new heights of the lower cells around it.
    fn height(&self, cell: usize, settings: &ReliefSettings, heights: &[f32]) -> f32 {
        let way = self.cells.way_inland(cell);
        let (was, now) = (self.heights[cell], slope(settings, way));
        let over = |one: usize, other: usize| (was - self.heights[one].min(self.heights[other])).max(0.0);
        let [west, east, north, south] = self.cells.beside(cell);
        let (across, down) = (over(west, east), over(north, south));
        let rise = (across * across + down * down).sqrt();
        let factor = now / slope(&self.settings, way);
        // A cell without lower neighbours rises from the sea.
        if rise > 0.0 {
            solved([west, east, north, south].map(|beside| heights[beside]), rise * factor)
        } else {
            was * factor
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::memory::testing::with_lists_up_to;
    use crate::lands::every_land;
    use crate::recipe::link;
    use crate::session::Session;

    /// Grows the rivers of a link, and prepares drafts of their relief.
    fn drafts_of(text: &str) -> (Session, ReliefDrafts) {
        let mut session = Session::new(link::read(text).unwrap()).unwrap();
        session.finish().unwrap();
        let relief = session.map().unwrap().make_relief().unwrap();
        let drafts = ReliefDrafts::new(&relief, session.map().unwrap().relief_settings()).unwrap();
        (session, drafts)
    }

    /// Returns the mean difference between the heights of land in two reliefs, as a share of the 99th percentile of the exact one.
    fn error(draft: &Relief, exact: &Relief) -> f32 {
        let land = || draft.heights().iter().zip(exact.heights()).filter(|(_, height)| **height > 0.0);
        let sum: f32 = land().map(|(one, other)| (one - other).abs()).sum();
        sum / land().count() as f32 / exact.quantile(0.99)
    }

    #[test]
    fn draft_of_the_same_mountains_is_the_relief_itself() {
        for land in every_land() {
            let (session, drafts) = drafts_of(&format!("seed=kauri&{land}&attractors=2000"));
            let settings = session.map().unwrap().relief_settings();
            let draft = drafts.draft(settings.mountains, settings.plains).unwrap();
            let exact = session.map().unwrap().make_relief().unwrap();
            let share = error(&draft, &exact);
            assert!(share < 2e-3, "{land}: {share}");
            let sea = |relief: &Relief| -> Vec<f32> {
                relief.heights().iter().copied().filter(|height| *height <= 0.0).collect()
            };
            assert_eq!(sea(&draft), sea(&exact), "{land}");
        }
    }

    #[test]
    fn draft_of_other_mountains_is_nearly_their_relief() {
        for land in every_land() {
            let text = format!("seed=kauri&{land}&attractors=2000");
            let (mut session, drafts) = drafts_of(&text);
            let before = session.map().unwrap().make_relief().unwrap();
            for (mountains, plains) in [(3.0, 200.0), (0.6, 200.0), (1.5, 20.0), (1.5, 400.0), (2.5, 100.0)] {
                let other = link::read(&format!("{text}&mountains={mountains}&plains={plains}")).unwrap();
                session.change(other).unwrap();
                session.finish().unwrap();
                let exact = session.map().unwrap().make_relief().unwrap();
                let (share, without) =
                    (error(&drafts.draft(mountains, plains).unwrap(), &exact), error(&before, &exact));
                assert!(share < 0.04 && share < 0.45 * without, "{land}, {mountains}, {plains}: {share}, {without}");
            }
        }
    }

    #[test]
    fn there_is_no_draft_without_memory() {
        let (session, drafts) = drafts_of("attractors=300");
        let relief = session.map().unwrap().make_relief().unwrap();
        let made = || ReliefDrafts::new(&relief, session.map().unwrap().relief_settings()).map(drop);
        let refused = with_lists_up_to(1000, || (made().is_err(), drafts.draft(2.0, 100.0).is_err()));
        assert_eq!(refused, (true, true));
    }
}
