//! The land of a delta: strips along its branches, and the bays between them as far as waves and sediment close them.

use glam::Vec2;

use super::fan::{Link, depth};
use crate::base::geometry::{distance, fast_max, fast_min, nearest};
use crate::base::work;
use crate::land::CoastDistance;

/// Half the width of the land along a branch: in widths, and more in units.
const WIDTHS: f32 = 1.7;
const MORE: f32 = 2.5;

/// The radius of the bays that close without waves, in units, and how much greater it is with the strongest.
const CALM: f32 = 4.0;
const ROUGH: f32 = 22.0;

/// The shares of the radius that are tried until sediment lasts.
const RADII: [f32; 6] = [1.0, 0.75, 0.55, 0.4, 0.25, 0.0];

/// The height of a plain that counts for its cost, in units.
const HEIGHT: f32 = 0.4;

/// Distances from the coast, in units, negative at sea, in a window of a lattice.
#[derive(Clone, Debug)]
pub(super) struct Plain {
    /// The first column and row of the window.
    first: [usize; 2],
    columns: usize,
    rows: usize,
    spacing: f32,
    /// Distances from the coast as it was, and as it is.
    before: Vec<f32>,
    pub field: Vec<f32>,
}

/// What closes the bays of a delta.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closing {
    /// The strength of waves, from 0 to 1.
    pub waves: f32,
    /// The volume of sediment, and the greatest area, in units.
    pub volume: f32,
    pub area: f32,
}

impl Plain {
    /// Builds the land along some branches of a delta, and closes bays. Water lanes stay open. `None` if they cannot, or the area
    /// is too large.
    pub fn build(
        coast: &CoastDistance,
        heights: &[f32],
        links: &[Link],
        lanes: &[Vec<Vec2>],
        closing: Closing,
    ) -> Option<Self> {
        let radius = CALM + ROUGH * closing.waves;
        let mut this = Self::around(coast, heights, links, radius);
        let lanes = this.lanes(lanes);
        let strips = this.strips(links, &lanes.0);
        for share in RADII {
            let mut closed = this.closed(&strips, &lanes.0, share * radius);
            let is_open = this.fill_ponds(&mut closed, &lanes.1);
            let (area, volume) = this.size_of(&closed);
            // What lies along the branches is paid for.
            if is_open && area <= closing.area && (share == 0.0 || volume <= closing.volume) {
                this.field = closed;
                return Some(this);
            }
        }
        None
    }

    /// Takes the window around some branches.
    fn around(coast: &CoastDistance, heights: &[f32], links: &[Link], radius: f32) -> Self {
        let ((columns, rows), spacing) = (coast.size(), coast.spacing());
        let places = || links.iter().flat_map(|link| link.line.iter().copied());
        let widest = links.iter().map(|link| link.width).fold(0.0, fast_max);
        let margin = 2.0 * radius + WIDTHS * widest + MORE + 4.0 * spacing;
        let least = places().fold(Vec2::MAX, Vec2::min) - margin;
        let most = places().fold(Vec2::MIN, Vec2::max) + margin;
        let index = |at: f32, count: usize| ((at / spacing).max(0.0) as usize).min(count - 1);
        let first = [index(least.x, columns), index(least.y, rows)];
        let last = [index(most.x, columns), index(most.y, rows)];
        let [across, down] = [0, 1].map(|axis| last[axis] + 1 - first[axis]);
        let row = |row: usize| &heights[(first[1] + row) * columns + first[0]..][..across];
        let before: Vec<f32> = (0..down).flat_map(|i| row(i).iter().copied()).collect();
        work::count(before.len());
        Self { first, columns: across, rows: down, spacing, field: before.clone(), before }
    }

    /// Returns the position of a corner of the window.
    fn at(&self, i: usize) -> Vec2 {
        let place = [self.first[0] + i % self.columns, self.first[1] + i / self.columns];
        Vec2::new(place[0] as f32, place[1] as f32) * self.spacing
    }

    /// Lists the corners of the window within a distance of a segment.
    fn near(&self, from: Vec2, to: Vec2, far: f32) -> impl Iterator<Item = usize> + use<> {
        let corner = Vec2::new(self.first[0] as f32, self.first[1] as f32) * self.spacing;
        let index = |at: f32, count: usize| ((at / self.spacing).ceil().max(0.0) as usize).min(count);
        let (least, most) = (from.min(to) - far - corner, from.max(to) + far - corner + self.spacing);
        let across = index(least.x, self.columns)..index(most.x, self.columns);
        let down = index(least.y, self.rows)..index(most.y, self.rows);
        work::count(across.len() * down.len());
        let columns = self.columns;
        down.flat_map(move |row| across.clone().map(move |column| row * columns + column))
    }

    /// Measures the distance of each corner from water lanes that stay open, negative in them. Returns the corners of their ends,
    /// too.
    fn lanes(&self, lanes: &[Vec<Vec2>]) -> (Vec<f32>, Vec<usize>) {
        /// Half the width of a lane where it begins, in units, and its growth.
        const HALF: f32 = 3.5;
        const GROWTH: f32 = 0.25;
        const FAR: f32 = 40.0;
        let mut off = vec![FAR; self.before.len()];
        let mut ends = Vec::new();
        for lane in lanes {
            let mut way = 0.0;
            for pair in lane.windows(2) {
                let step = distance(pair[0], pair[1]);
                for i in self.near(pair[0], pair[1], FAR) {
                    let (far, share) = nearest(self.at(i), (pair[0], pair[1]));
                    off[i] = fast_min(off[i], far - HALF - GROWTH * (way + share * step));
                }
                way += step;
            }
            let middle = lane.get(lane.len() / 2).copied();
            ends.extend(middle.and_then(|at| self.near(at, at, self.spacing).next()));
        }
        (off, ends)
    }

    /// Measures the distance into the strips of land along branches.
    fn strips(&self, links: &[Link], lanes: &[f32]) -> Vec<f32> {
        const FAR: f32 = 30.0;
        let mut field = vec![-FAR; self.before.len()];
        for link in links {
            let half = WIDTHS * link.width + MORE;
            let whole = link.length();
            let mut way = 0.0;
            for pair in link.line.windows(2) {
                let step = distance(pair[0], pair[1]);
                for i in self.near(pair[0], pair[1], half + FAR) {
                    let (far, share) = nearest(self.at(i), (pair[0], pair[1]));
                    // A tip is narrow, so that it ends close to the sea.
                    let left = whole - way - share * step;
                    let half = match link.arms {
                        None => half * (0.35 + 0.65 * fast_min(left / half, 1.0).sqrt()),
                        Some(_) => half,
                    };
                    field[i] = fast_max(field[i], half - far);
                }
                way += step;
            }
        }
        field.iter_mut().zip(lanes).for_each(|(field, lane)| *field = fast_min(*field, *lane));
        field
    }

    /// Closes bays into which no disc of a radius fits (morphological closing), beside the strips.
    fn closed(&self, strips: &[f32], lanes: &[f32], radius: f32) -> Vec<f32> {
        let land: Vec<f32> = self.before.iter().zip(strips).map(|(before, strip)| fast_max(*before, *strip)).collect();
        if radius <= 0.0 {
            return land;
        }
        // Only discs that are hardly larger matter at the edge of what they leave.
        let discs: Vec<bool> =
            land.iter().map(|&land| land <= -radius && land > -radius - 1.6 * self.spacing).collect();
        let close = |(i, &here): (usize, &f32)| {
            let beside = fast_min(strips[i] + 1.3 * radius, lanes[i]);
            if here > 0.0 || here <= -radius || beside <= here {
                return here;
            }
            let at = self.at(i);
            let reach = radius + 1.6 * self.spacing;
            let open = self.near(at, at, reach).filter(|&other| discs[other]);
            let inside = open.map(|other| distance(self.at(other), at) + land[other]).fold(reach, fast_min);
            fast_max(here, fast_min(inside, beside))
        };
        land.iter().enumerate().map(close).collect()
    }

    /// Makes land of water that is cut off from the rest. Returns `false` if that would be the water of a lane.
    fn fill_ponds(&self, field: &mut [f32], ends: &[usize]) -> bool {
        const LEVEL: f32 = 1.0;
        let (columns, rows) = (self.columns, self.rows);
        let is_rim = |i: &usize| i % columns == 0 || (i + 1) % columns == 0 || i / columns == 0 || i / columns + 1 == rows;
        let mut is_sea = vec![false; field.len()];
        let mut left: Vec<usize> = (0..field.len()).filter(is_rim).collect();
        work::count(4 * field.len());
        while let Some(i) = left.pop() {
            if field[i] > 0.0 || std::mem::replace(&mut is_sea[i], true) {
                continue;
            }
            let (column, row) = (i % columns, i / columns);
            left.extend((column > 0).then(|| i - 1));
            left.extend((column + 1 < columns).then(|| i + 1));
            left.extend((row > 0).then(|| i - columns));
            left.extend((row + 1 < rows).then(|| i + columns));
        }
        for (i, field) in field.iter_mut().enumerate() {
            if *field <= 0.0 && !is_sea[i] {
                *field = LEVEL;
            }
        }
        ends.iter().all(|&end| is_sea[end] || self.before[end] > 0.0)
    }

    /// Returns the area and the volume of new land.
    fn size_of(&self, field: &[f32]) -> (f32, f32) {
        let cell = self.spacing * self.spacing;
        let new = field.iter().zip(&self.before).filter(|(now, before)| **now > 0.0 && **before <= 0.0);
        new.fold((0.0, 0.0), |(area, volume), (_, before)| (area + cell, volume + cell * (HEIGHT + depth(*before))))
    }

    /// Returns the area of the new land, in square units.
    pub fn area(&self) -> f32 {
        self.size_of(&self.field).0
    }

    /// Returns the distance of a point of the window from the coast; far off outside.
    pub fn height(&self, point: Vec2) -> f32 {
        let at = point / self.spacing - Vec2::new(self.first[0] as f32, self.first[1] as f32);
        if at.min_element() < 0.0 || at.x >= (self.columns - 1) as f32 || at.y >= (self.rows - 1) as f32 {
            return f32::NEG_INFINITY;
        }
        let (column, row) = (at.x as usize, at.y as usize);
        let along = |row: usize| {
            let [west, east] = [0, 1].map(|beside| self.field[row * self.columns + column + beside]);
            west + (east - west) * (at.x - column as f32)
        };
        along(row) + (along(row + 1) - along(row)) * (at.y - row as f32)
    }

    /// Iterates over the corners that have become land, as indices of the whole lattice of so many columns, each with its distance
    /// from the coast.
    pub fn changes(&self, columns: usize) -> impl Iterator<Item = (usize, f32)> + '_ {
        let corner = move |i: usize| (self.first[1] + i / self.columns) * columns + self.first[0] + i % self.columns;
        let changed = move |i: &usize| self.field[*i] != self.before[*i];
        (0..self.field.len()).filter(changed).map(move |i| (corner(i), self.field[i]))
    }
}
