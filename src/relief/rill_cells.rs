//! The cells that rills pass.

use glam::Vec2;

use super::cells::Cells;
use super::rills::{Rills, Segment};
use crate::base::geometry::distance;
use crate::base::memory::{Refused, lengthen};
use crate::base::work;

/// The cells that rills pass, while rills are walked.
#[derive(Clone, Debug, Default)]
pub(super) struct RillCells {
    /// The greatest share of the whole map that a rill drains in each cell; 0 where there is no rill.
    pub shares: Vec<f32>,
    /// The number of segments walked so far.
    walked: usize,
}

impl RillCells {
    /// Makes a number of cells that no rill passes yet.
    pub fn new(cells: usize) -> Result<Self, Refused> {
        let mut this = Self::default();
        lengthen(&mut this.shares, cells, 0.0)?;
        Ok(this)
    }

    /// Walks some more segments from cell to cell. Returns `true` if there are more.
    pub fn walk(&mut self, cells: &Cells, rills: &Rills) -> bool {
        /// The number of elementary steps after which a call ends.
        const STEPS: u64 = 500_000;
        let begun = work::steps();
        while let Some(segment) = rills.segments.get(self.walked) {
            if work::steps() - begun >= STEPS {
                return true;
            }
            self.mark(cells, segment);
            self.walked += 1;
        }
        false
    }

    /// Marks the cells of a segment. Each shares a side with the next, since the front moves from side to side.
    fn mark(&mut self, cells: &Cells, segment: &Segment) {
        let steps = (distance(segment.from, segment.to) / (0.5 * cells.size)).ceil().max(1.0);
        work::count(2 * steps as usize);
        let mut enter = |cell: usize| self.shares[cell] = self.shares[cell].max(segment.share);
        let mut last = None;
        for i in 0..=steps as usize {
            let cell = cells.of(segment.from.lerp(segment.to, i as f32 / steps).max(Vec2::ZERO));
            if let Some(corner) = last.and_then(|last| cells.between(last, cell)) {
                enter(corner);
            }
            enter(cell);
            last = Some(cell);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    fn finished(text: &str) -> Session {
        let mut session = Session::new(link::read(text).unwrap()).unwrap();
        session.finish().unwrap();
        session
    }

    /// Returns the cells of a map, its rills, and the cells that these pass.
    fn walked(session: &Session) -> (Cells, Arc<Rills>, RillCells) {
        let settings = session.map().unwrap().relief_settings();
        let cells = Cells::new(&settings).unwrap();
        let mut walked = RillCells::new(cells.inland.len()).unwrap();
        let rills = settings.rill_lines.unwrap();
        while walked.walk(&cells, &rills) {}
        (cells, rills, walked)
    }

    #[test]
    fn rills_lead_from_side_to_side_down_to_a_drawn_river_or_the_sea() {
        let session = finished("seed=kauri&attractors=6000&rills=0.6");
        let (cells, rills, walked) = walked(&session);
        assert!(rills.segments.len() > 2000);
        for segment in &rills.segments {
            let (start, end) = (cells.of(segment.from), cells.of(segment.to));
            // Within the piece's own box, through the sides of cells that drain as much or more.
            let (mut reached, mut next) = (vec![start], 0);
            while next < reached.len() && !reached.contains(&end) {
                for cell in cells.beside(reached[next]) {
                    let is_on = walked.shares[cell] >= segment.share && !reached.contains(&cell);
                    let at = cells.point(cell);
                    let is_near = distance(at, segment.from) + distance(at, segment.to)
                        < distance(segment.from, segment.to) + 4.0 * cells.size;
                    if is_on && is_near {
                        reached.push(cell);
                    }
                }
                next += 1;
            }
            assert!(reached.contains(&end), "a rill is cut off");
        }
    }

    #[test]
    fn rills_are_what_the_rivers_leave() {
        for text in ["growth=drainage", "growth=colonize&trim=40", "growth=colonize&trim=0&tributary-spacing=0"] {
            let session = finished(&format!("seed=kauri&attractors=1500&rills=1&{text}"));
            let (_, rills, _) = walked(&session);
            let drawn = session.pruned().tree;
            let removed = session.tree().len() - session.tree().mouths() - (drawn.len() - drawn.mouths());
            assert_eq!(rills.segments.len(), removed, "{text}");
            assert_eq!(removed == 0, text.ends_with("spacing=0"), "{text}");
        }
    }
}
