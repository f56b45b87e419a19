//! Rills: the streams above the heads of drawn rivers, which carve the hillsides. Trimming removed them from the tree;
//! here they are strips of gentle ground, the gentler the more they drain, so that spurs stand between them.
//!
//! Only steepness changes. Coast and drawn rivers stay the only sources of the march, so there is no pit, and no river
//! moves.

use std::sync::Arc;

use glam::Vec2;

use super::cells::Cells;
use crate::base::geometry::distance;
use crate::base::memory::{Refused, lengthen};
use crate::base::work;
use crate::prune::{self, Trim};
use crate::tree::{Hydrology, Tree};

/// The part of a tree that trimming removed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Rills {
    segments: Vec<Segment>,
}

/// A segment of a rill, from one node to the next downstream.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Segment {
    from: Vec2,
    to: Vec2,
    /// The share of the whole map's discharge that it drains.
    share: f32,
}

impl Rills {
    /// Collects the segments from each node that trimming removes to the next downstream. `total_discharge` is that of
    /// a river that would drain the whole map.
    pub fn of(tree: &Tree, trim: Trim, total_discharge: u32) -> Arc<Self> {
        let Hydrology { discharge, .. } = Hydrology::of(tree);
        let stays = prune::stays(tree, &discharge, trim);
        let segment = |node: usize| {
            let parent = tree.parent_of(node).filter(|_| !stays[node])?;
            let share = discharge[node] as f32 / total_discharge.max(1) as f32;
            Some(Segment { from: tree.at[node], to: tree.at[parent], share })
        };
        work::count(2 * tree.len());
        Arc::new(Self { segments: (0..tree.len()).filter_map(segment).collect() })
    }
}

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

/// The catchment, in square units, up to which rills are equally steep.
pub(super) const LEAST_CATCHMENT: f32 = 60.0;

/// The law by which ground is gentler where rills run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gentleness {
    /// The strength of rills, from 0 to 1.
    rills: f32,
    /// The share of the whole map up to which rills are equally steep.
    least_share: f32,
}

impl Gentleness {
    /// Derives the law from the strength of rills, from 0 to 1, and the area of land, in square units.
    pub fn new(rills: f32, land: f32) -> Self {
        Self { rills, least_share: LEAST_CATCHMENT / land.max(LEAST_CATCHMENT) }
    }

    /// Returns the factor for the steepness of a cell whose greatest rill drains a share of the whole map, 0 if no rill
    /// passes. Slope falls with a power of the drained area (Flint 1974).
    pub fn factor(self, share: f32) -> f32 {
        const RIDGES: f32 = 0.25;
        const VALLEYS: f32 = 0.67;
        const CONCAVITY: f32 = 0.67;
        if share == 0.0 {
            return 1.0 + RIDGES * self.rills;
        }
        let times = (share / self.least_share).max(1.0);
        (1.0 - VALLEYS * self.rills) * libm::powf(times, -CONCAVITY * self.rills)
    }
}

#[cfg(test)]
mod tests {
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

    #[test]
    fn ground_is_the_gentler_the_more_a_rill_drains_and_steeper_without() {
        let law = Gentleness::new(0.6, 60_000.0);
        let factors = [0.0, 1e-5, 1e-3, 4e-3, 0.1].map(|share| law.factor(share));
        assert!(factors.is_sorted_by(|a, b| a >= b), "{factors:?}");
        assert!(factors[0] > 1.0 && factors[1] == factors[2] && factors[3] < factors[2], "{factors:?}");
        assert_eq!([0.0, 0.1].map(|share| Gentleness::new(0.0, 60_000.0).factor(share)), [1.0, 1.0]);
    }
}
