//! Valleys on the corners of a lattice: the area that drains through each corner.

use glam::Vec2;

use super::fjords::Trough;
use super::silt::GreatRivers;
use crate::base::memory::{Refused, lengthen};
use crate::base::work;
use crate::land::{CoastDistance, walk};
use crate::tree::Tree;

/// The area that drains through each corner of a lattice, in square units; 0 where no water runs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Valleys {
    areas: Vec<f32>,
    /// The trough of the great valley nearest to each corner.
    troughs: Vec<Trough>,
    columns: usize,
    /// The rivers that silt up the inlets where they meet.
    pub(super) rivers: GreatRivers,
}

/// The drained area from which on slopes fall with more of it, in square units.
const AREA: f32 = 16.0;

/// The steepness of a valley with that area, and of ground without a valley, as shares of a hillside's.
const VALLEY: f32 = 0.4;
const FLANK: f32 = 1.15;

impl Valleys {
    /// Returns the steepness of a corner as a share of a hillside's, by its hardness: Flint's law (1974) with the usual
    /// concavity of a half, except in troughs.
    pub fn steepness(&self, corner: usize, hardness: f32) -> f32 {
        let usual = match self.areas.get(corner) {
            Some(&area) if area > 0.0 => VALLEY * (AREA / area.max(AREA)).sqrt(),
            _ => FLANK,
        };
        self.troughs.get(corner).map_or(usual, |trough| trough.steepness(usual, FLANK, hardness))
    }

    /// Returns the valleys with a middling area wherever `land` is sea: what drains there is unknown, and ground that
    /// only a lower sea uncovers is the first to drown.
    pub fn with_unknown(&self, land: &CoastDistance) -> Self {
        /// The area that is taken to drain through unknown ground, in square units.
        const UNKNOWN: f32 = 160.0;
        let known = self.areas.iter().zip(land.heights());
        Self {
            areas: known.map(|(&area, &height)| if height > 0.0 { area } else { UNKNOWN }).collect(),
            troughs: self.troughs.clone(),
            columns: self.columns,
            rivers: self.rivers.clone(),
        }
    }
}

/// The marking of a tree's edges on a lattice.
#[derive(Clone, Debug)]
pub(super) struct Marking {
    valleys: Valleys,
    /// The discharge of each node, in parcels.
    discharge: Vec<u32>,
    /// The area of a parcel, in square units.
    parcel: f32,
    rows: usize,
    spacing: f32,
    /// The node to go on with.
    next: usize,
}

impl Marking {
    /// Begins with the discharge of each node of a tree; `parcel_spacing` is the distance between parcels, in units.
    pub fn new(tree: &Tree, lattice: &CoastDistance, parcel_spacing: f32) -> Result<Self, Refused> {
        let (columns, rows) = lattice.size();
        let (mut areas, mut troughs, mut discharge) = (Vec::new(), Vec::new(), Vec::new());
        lengthen(&mut areas, columns * rows, 0.0)?;
        lengthen(&mut troughs, columns * rows, Trough::NONE)?;
        lengthen(&mut discharge, tree.len(), 0)?;
        discharge.copy_from_slice(&tree.drained);
        work::count(tree.len());
        for node in (0..tree.len()).rev() {
            if let Some(parent) = tree.parent_of(node) {
                discharge[parent] += discharge[node];
            }
        }
        let parcel = parcel_spacing * parcel_spacing;
        let rivers = GreatRivers::of(tree, &discharge, parcel);
        let valleys = Valleys { areas, troughs, columns, rivers };
        Ok(Self { valleys, discharge, parcel, rows, spacing: lattice.spacing(), next: 0 })
    }

    /// Marks some more edges. Returns `true` if there are more.
    pub fn advance(&mut self, tree: &Tree) -> bool {
        const WORK_A_STEP: u64 = 500_000;
        let begun = work::steps();
        while self.next < tree.len() {
            if work::steps() - begun >= WORK_A_STEP {
                return true;
            }
            let node = self.next;
            self.next += 1;
            if let Some(parent) = tree.parent_of(node) {
                let area = self.discharge[node] as f32 * self.parcel;
                self.mark(tree.at[node], tree.at[parent], area);
                if Trough::is_great(area) {
                    self.hollow(tree.at[node], tree.at[parent], area);
                }
            }
        }
        false
    }

    /// Marks the corners nearest to a segment with the area that drains there; of several rivers at a corner, the greatest counts.
    fn mark(&mut self, from: Vec2, to: Vec2, area: f32) {
        let [from, to] = [from, to].map(|at| at / self.spacing + 0.5);
        for (column, row) in walk(from, to) {
            work::count(1);
            let (column, row) = (column as usize, row as usize);
            if column < self.valleys.columns && row < self.rows {
                let marked = &mut self.valleys.areas[row * self.valleys.columns + column];
                *marked = marked.max(area);
            }
        }
    }

    /// Marks the corners around a segment with the trough along it.
    fn hollow(&mut self, from: Vec2, to: Vec2, area: f32) {
        let index = |at: f32, count: usize| ((at / self.spacing).max(0.0) as usize).min(count);
        let (first, last) = (from.min(to) - Trough::REACH, from.max(to) + Trough::REACH);
        let columns = index(first.x, self.valleys.columns)..index(last.x + self.spacing, self.valleys.columns);
        for row in index(first.y, self.rows)..index(last.y + self.spacing, self.rows) {
            work::count(columns.len());
            for column in columns.clone() {
                let at = Vec2::new(column as f32, row as f32) * self.spacing;
                let nearest = &mut self.valleys.troughs[row * self.valleys.columns + column];
                *nearest = Trough::of(area, from, to, at).map_or(*nearest, |trough| nearest.or(trough));
            }
        }
    }

    pub fn into_valleys(self) -> Valleys {
        self.valleys
    }
}
