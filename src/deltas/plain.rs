//! The land of a delta: strips along its branches, and the bays between them as far as waves and sediment close them.

use glam::Vec2;

use super::fan::{Link, depth};
use crate::base::geometry::{distance, fast_max, fast_min, nearest};
use crate::base::parts::Parts;
use crate::base::queue::Queue;
use crate::base::work;
use crate::land::CoastDistance;

/// Half the width of the land along a branch: in widths, and more in units.
const WIDTHS: f32 = 1.7;
const MORE: f32 = 2.5;

/// The width of the land at a tip, as a share.
const NARROW: f32 = 0.15;

/// The radius of the bays that close without waves, in units, and how much greater it is with the strongest.
const CALM: f32 = 4.0;
const ROUGH: f32 = 22.0;

/// The shares of the radius that are tried until sediment lasts and branches reach the sea.
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
    field: Vec<f32>,
    /// Distances into the strips along branches.
    strips: Vec<f32>,
}

/// The most that a delta takes: the volume of its sediment and its area, in units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Most {
    pub volume: f32,
    pub area: f32,
}

/// Lists the radii of bays that waves of a strength from 0 to 1 close in a delta whose branches have a usual length, in units, the
/// greatest first.
pub(super) fn radii(waves: f32, reach: f32) -> [f32; 6] {
    /// The most, in lengths of branches: without waves, and how much more with the strongest.
    const LENGTHS: (f32, f32) = (0.12, 0.6);
    RADII.map(|share| share * fast_min(CALM + ROUGH * waves, reach * (LENGTHS.0 + LENGTHS.1 * waves)))
}

impl Plain {
    /// Builds the land along some branches of a delta.
    pub fn along(coast: &CoastDistance, heights: &[f32], links: &[Link]) -> Self {
        let mut this = Self::around(coast, heights, links, CALM + ROUGH);
        this.strips = this.strips(links);
        this
    }

    /// Closes the bays between branches into which no disc of a radius fits. Returns `false` if that takes too much.
    pub fn close(&mut self, radius: f32, most: Most) -> bool {
        self.field = self.closed(&self.strips, radius);
        self.fill_ponds();
        let (area, volume) = self.size_of(&self.field);
        // The strips along branches are paid for.
        area <= most.area && (radius == 0.0 || volume <= most.volume)
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
        Self { first, columns: across, rows: down, spacing, field: before.clone(), before, strips: Vec::new() }
    }

    /// Returns the position of a corner of the window.
    fn at(&self, i: usize) -> Vec2 {
        let place = [self.first[0] + i % self.columns, self.first[1] + i / self.columns];
        Vec2::new(place[0] as f32, place[1] as f32) * self.spacing
    }

    /// Lists the corners of the window in a box around a segment.
    fn near(&self, from: Vec2, to: Vec2, far: f32) -> Vec<usize> {
        let mut near = Vec::new();
        self.each_near((from, to), far, &mut |i, _| near.push(i));
        near
    }

    /// Calls `found` with each corner of the window in a box around a segment, and with its position.
    #[inline(never)] // in a page, one copy is enough
    fn each_near(&self, (from, to): (Vec2, Vec2), far: f32, found: &mut dyn FnMut(usize, Vec2)) {
        let [left, top] = self.first;
        let corner = Vec2::new(left as f32, top as f32) * self.spacing;
        let index = |at: f32, count: usize| ((at / self.spacing).ceil().max(0.0) as usize).min(count);
        let (least, most) = (from.min(to) - far - corner, from.max(to) + far - corner + self.spacing);
        let across = index(least.x, self.columns)..index(most.x, self.columns);
        let down = index(least.y, self.rows)..index(most.y, self.rows);
        work::count(across.len() * down.len());
        for row in down {
            for column in across.clone() {
                let at = Vec2::new((left + column) as f32, (top + row) as f32) * self.spacing;
                found(row * self.columns + column, at);
            }
        }
    }

    /// Measures the distance into the strips of land along branches.
    fn strips(&self, links: &[Link]) -> Vec<f32> {
        const FAR: f32 = 40.0;
        let mut field = vec![-FAR; self.before.len()];
        for link in links {
            let half = WIDTHS * link.width + MORE;
            let whole = link.length();
            let mut way = 0.0;
            for pair in link.line.windows(2) {
                let step = distance(pair[0], pair[1]);
                self.each_near((pair[0], pair[1]), half + FAR, &mut |i, at| {
                    let (far, share) = nearest(at, (pair[0], pair[1]));
                    // A tip is narrow, so that it ends close to the sea.
                    let left = whole - way - share * step;
                    let half = match link.arms {
                        None => half * (NARROW + (1.0 - NARROW) * (left / half).clamp(0.0, 1.0).sqrt()),
                        Some(_) => half,
                    };
                    field[i] = fast_max(field[i], half - far);
                });
                way += step;
            }
        }
        field
    }

    /// Closes bays into which no disc of a radius fits (morphological closing), beside the strips.
    fn closed(&self, strips: &[f32], radius: f32) -> Vec<f32> {
        let land: Vec<f32> = self.before.iter().zip(strips).map(|(before, strip)| fast_max(*before, *strip)).collect();
        if radius <= 0.0 {
            return land;
        }
        // Only discs that are hardly larger matter at the edge of what they leave.
        let discs: Vec<bool> =
            land.iter().map(|&land| land <= -radius && land > -radius - 1.6 * self.spacing).collect();
        let close = |(i, &here): (usize, &f32)| {
            let beside = strips[i] + 1.3 * radius;
            if here > 0.0 || here <= -radius || beside <= here {
                return here;
            }
            let at = self.at(i);
            let reach = radius + 1.6 * self.spacing;
            let mut inside = reach;
            self.each_near((at, at), reach, &mut |other, place| {
                if discs[other] {
                    inside = fast_min(inside, distance(place, at) + land[other]);
                }
            });
            fast_max(here, fast_min(inside, beside))
        };
        land.iter().enumerate().map(close).collect()
    }

    /// Makes land of water that is cut off from the rest.
    fn fill_ponds(&mut self) {
        const LEVEL: f32 = 4.0;
        let is_water: Vec<bool> = self.field.iter().map(|field| *field <= 0.0).collect();
        let waters = Parts::of(&is_water, self.columns);
        let is_inner = waters.all(|i| !self.is_rim(i));
        for (field, number) in self.field.iter_mut().zip(waters.number).filter(|(_, number)| *number > 0) {
            if is_inner[number as usize] {
                *field = LEVEL;
            }
        }
    }

    /// Returns `true` if a corner is at the rim of the window.
    fn is_rim(&self, i: usize) -> bool {
        let (column, row) = (i % self.columns, i / self.columns);
        column == 0 || column + 1 == self.columns || row == 0 || row + 1 == self.rows
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
        self.height_in(&self.field, point)
    }

    /// Returns `true` if a point of the window lies farther inland than before.
    pub fn has_changed(&self, point: Vec2) -> bool {
        const LEAST: f32 = 0.1;
        self.height(point) > self.height_in(&self.before, point) + LEAST
    }

    /// Returns `true` if a mouth that was at the coast lies inland now.
    pub fn cuts_off(&self, mouth: Vec2) -> bool {
        // The field is no distance within strips that overlap, so it says no more than where there is land.
        const INLAND: f32 = 0.3;
        let is_at_sea = |field: &[f32], spacings: f32| {
            let far = spacings * self.spacing;
            self.near(mouth, mouth, far).into_iter().any(|i| field[i] <= 0.0 && distance(self.at(i), mouth) < far)
        };
        let has_no_sea = is_at_sea(&self.before, 1.5) && !is_at_sea(&self.field, 1.0) && self.is_new(mouth);
        has_no_sea || (self.height(mouth) > INLAND && self.has_changed(mouth))
    }

    /// Returns `true` if there is new land close to a point.
    fn is_new(&self, point: Vec2) -> bool {
        self.near(point, point, 1.5 * self.spacing).into_iter().any(|i| self.field[i] > 0.0 && self.before[i] <= 0.0)
    }

    fn height_in(&self, field: &[f32], point: Vec2) -> f32 {
        let at = point / self.spacing - Vec2::new(self.first[0] as f32, self.first[1] as f32);
        if at.min_element() < 0.0 || at.x >= (self.columns - 1) as f32 || at.y >= (self.rows - 1) as f32 {
            return f32::NEG_INFINITY;
        }
        let (column, row) = (at.x as usize, at.y as usize);
        let along = |row: usize| {
            let [west, east] = [0, 1].map(|beside| field[row * self.columns + column + beside]);
            west + (east - west) * (at.x - column as f32)
        };
        along(row) + (along(row + 1) - along(row)) * (at.y - row as f32)
    }

    /// Returns for each corner of the window `true` if a brook can run there: in new land clear of branches, and in water.
    pub fn passable(&self, links: &[Link]) -> Vec<bool> {
        let mut passable: Vec<bool> = self.before.iter().map(|before| *before <= 0.0).collect();
        for link in links {
            let clear = 0.5 * link.width + 0.75 * self.spacing + 1.0;
            for &at in &link.line {
                for i in self.near(at, at, clear).into_iter().filter(|&i| distance(self.at(i), at) < clear) {
                    passable[i] = false;
                }
            }
        }
        passable
    }

    /// Finds the way of a brook from a mouth that has come to lie in new land to the sea, and bars it for others. `None` if there is
    /// none.
    pub fn way_out(&self, mouth: Vec2, passable: &mut [bool]) -> Option<Vec<Vec2>> {
        let mut queue = Queue::default();
        let mut cost = vec![f32::INFINITY; passable.len()];
        let mut from = vec![usize::MAX; passable.len()];
        for i in self.near(mouth, mouth, 1.5 * self.spacing).into_iter().filter(|&i| passable[i]) {
            cost[i] = distance(self.at(i), mouth);
            queue.push(cost[i], i as u32);
        }
        while let Some(i) = queue.pop() {
            let i = i as usize;
            work::count(8);
            if self.field[i] <= 0.0 {
                return Some(self.way(mouth, i, &from, passable));
            }
            if self.is_rim(i) {
                continue;
            }
            for step in 0..9 {
                // The corner itself is among them; it is not farther than it is.
                let other = i + step % 3 + step / 3 * self.columns - 1 - self.columns;
                let reached = cost[i] + distance(self.at(i), self.at(other));
                if passable[other] && reached < cost[other] {
                    (cost[other], from[other]) = (reached, i);
                    queue.push(reached, other as u32);
                }
            }
        }
        None
    }

    /// Follows a way back from a corner at sea, smooths it, and bars it.
    fn way(&self, mouth: Vec2, sea: usize, from: &[usize], passable: &mut [bool]) -> Vec<Vec2> {
        const OUT: f32 = 2.0;
        const PASSES: usize = 3;
        let corners: Vec<usize> =
            std::iter::successors(Some(sea), |&i| Some(from[i]).filter(|&i| i != usize::MAX)).collect();
        let mut way: Vec<Vec2> = corners.iter().rev().map(|&i| self.at(i)).collect();
        way.insert(0, mouth);
        for _ in 0..PASSES {
            let before = way.clone();
            for (at, around) in way.iter_mut().skip(1).zip(before.windows(3)) {
                *at = (around[0] + 2.0 * around[1] + around[2]) * 0.25;
            }
        }
        if let [.., last, end] = &mut way[..] {
            // The last step ends where the sea begins.
            let (inside, outside) = (self.height(*last), self.height(*end));
            let share = if inside > outside { ((inside + OUT) / (inside - outside)).clamp(0.1, 1.0) } else { 1.0 };
            *end = last.lerp(*end, share);
        }
        for &i in &corners {
            for beside in self.near(self.at(i), self.at(i), 1.1 * self.spacing) {
                passable[beside] = false;
            }
        }
        way.remove(0);
        way
    }

    /// Iterates over the corners that have become land, as indices of the whole lattice of so many columns, each with its distance
    /// from the coast.
    pub fn changes(&self, columns: usize) -> impl Iterator<Item = (usize, f32)> + '_ {
        let corner = move |i: usize| (self.first[1] + i / self.columns) * columns + self.first[0] + i % self.columns;
        let changed = move |i: &usize| self.field[*i] != self.before[*i];
        (0..self.field.len()).filter(changed).map(move |i| (corner(i), self.field[i]))
    }
}
