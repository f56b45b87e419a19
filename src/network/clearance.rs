//! The guard of clearances: it measures how near the lines of a network come to each other.
//!
//! Two segments that have no end in common, at a distance d, cannot come to cross if each moves by less than d/2. So it is
//! enough to know, for each segment, the distance to the nearest other one, as far as it can matter; and this
//! keeps all rivers apart at every round, whatever moves them.
//!
//! Segments are entered in a grid by their middles, each row of cells being one run in memory, and looked for around each
//! segment that can move or is wide. A pair is reported once, by the segment with the larger search radius.

use glam::Vec2;

use super::{Network, Vertex};
use crate::base::geometry::{distance, fast_max, fast_min, gap, meet};
use crate::base::work;
use crate::domain::Domain;

/// The greatest rounding error of a distance between two segments, in units.
const ROUNDING: f32 = 1e-3;

/// Two segments, each known by its upper vertex, and their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearbyPair {
    /// The segment with the smaller index.
    pub first: u32,
    /// The segment with the greater index.
    pub second: u32,
    /// The distance between both, in units.
    pub distance: f32,
}

/// A grid of segments, used again from round to round.
#[derive(Clone, Debug, Default)]
pub struct ClearanceGrid {
    spacing: f32,
    side: f32,
    columns: usize,
    rows: usize,
    /// The index in `entries` at which each cell begins.
    starts: Vec<u32>,
    entries: Vec<Entry>,
    /// Half the length of the longest segment whose search radius is at most that of each [class](Self::class).
    longest_halves: [f32; CLASSES],
}

/// The number of classes of search radii, each as wide as a spacing: a wide river looks farther, and its segments are longer.
const CLASSES: usize = 32;

/// A segment in a cell.
#[derive(Clone, Copy, Debug, Default)]
struct Entry {
    middle: Vec2,
    /// Half the segment's length and a little more, so that rounding leaves out no segment.
    half: f32,
    reach: f32,
    segment: u32,
}

/// The network that is measured, with the vertex downstream of each.
#[derive(Clone, Copy)]
struct Survey<'a> {
    network: &'a Network,
    downstream: &'a [u32],
}

impl ClearanceGrid {
    /// Makes an empty grid for segments about as long as a spacing, or longer where rivers are wide.
    pub fn new(domain: &Domain, spacing: f32) -> Self {
        let side = spacing * 4.0;
        let cells = (domain.size / side).floor() + 1.0;
        Self { spacing, side, columns: cells.x as usize, rows: cells.y as usize, ..Self::default() }
    }

    /// Measures the clearance of each segment, known by its upper vertex: the distance to the nearest other one with no
    /// end in common, at most its cap. `reach` is the search radius of each segment, at least its cap; 0 for one that
    /// can neither move nor matter to others beyond their caps. `tell` is called for each pair nearer than the larger
    /// of its two search radii, unless both are near each other along one river.
    pub fn measure(
        &mut self,
        network: &Network,
        downstream: &[u32],
        reach: &[f32],
        caps: Vec<f32>,
        tell: &mut dyn FnMut(NearbyPair),
    ) -> Vec<f32> {
        self.enter(network, downstream, reach);
        let mut clearance = caps;
        let survey = Survey { network, downstream };
        for &own in self.entries.iter().filter(|entry| entry.reach > 0.0) {
            self.look_around(own, survey, &mut clearance, tell);
        }
        clearance
    }

    fn look_around(&self, own: Entry, survey: Survey<'_>, clearance: &mut [f32], tell: &mut dyn FnMut(NearbyPair)) {
        // One that looks farther finds this one itself.
        let radius = own.reach + own.half + self.longest_halves[self.class(own.reach)];
        let i = own.segment as usize;
        for row in self.runs(own.middle, radius) {
            for other in &self.entries[row] {
                let (off, halves) = (other.middle - own.middle, own.half + other.half);
                let far = own.reach + halves;
                if off.dot(off) >= far * far
                    || other.reach > own.reach
                    || (other.reach == own.reach && other.segment <= own.segment)
                {
                    continue;
                }
                let j = other.segment as usize;
                let are_neighbours = i.abs_diff(j) <= NEIGHBOURS;
                // Of neighbours only the clearance matters.
                let far = fast_max(clearance[i], clearance[j]) + halves;
                if !are_neighbours || off.dot(off) < far * far {
                    survey.measure(own, *other, are_neighbours, clearance, tell);
                }
            }
        }
    }

    /// Returns the class of a search radius.
    fn class(&self, reach: f32) -> usize {
        ((reach / self.spacing) as usize).min(CLASSES - 1)
    }

    /// Returns half the length of the longest segment.
    fn longest_half(&self) -> f32 {
        self.longest_halves[CLASSES - 1]
    }

    /// Returns `true` if a line from one vertex to another, across a neck, meets no segment of the last measurement but
    /// those that end in either.
    pub fn is_free(&self, network: &Network, downstream: &[u32], (a, b): (u32, u32)) -> bool {
        let line = (network.vertices[a as usize].at, network.vertices[b as usize].at);
        let radius = distance(line.0, line.1) * 0.5 + self.longest_half();
        self.runs((line.0 + line.1) * 0.5, radius).all(|row| {
            self.entries[row].iter().all(|other| {
                let (j, below) = (other.segment, downstream[other.segment as usize]);
                let is_end = [a, b].contains(&j) || [a, b].contains(&below);
                is_end || !meet(line, (network.vertices[j as usize].at, network.vertices[below as usize].at))
            })
        })
    }

    /// Returns `true` if a segment of the last measurement comes nearer to a point than its margin, which depends on
    /// its upper vertex and is at most `largest`.
    pub fn is_near(
        &self,
        network: &Network,
        downstream: &[u32],
        at: Vec2,
        largest: f32,
        margin: impl Fn(&Vertex) -> f32,
    ) -> bool {
        let vertices = &network.vertices;
        self.runs(at, largest + self.longest_half()).any(|row| {
            self.entries[row].iter().any(|entry| {
                let upper = &vertices[entry.segment as usize];
                let lower = &vertices[downstream[entry.segment as usize] as usize];
                gap((at, at), (upper.at, lower.at)) < margin(upper)
            })
        })
    }

    /// Returns `true` if a condition holds for all segments of the last measurement whose bounding circles come nearer to a circle
    /// than its reach, which depends on the segment and is at most `longest`; the condition is asked with that reach. All lengths
    /// are in units.
    pub fn all_near(
        &self,
        (at, radius): (Vec2, f32),
        longest: f32,
        reach: impl Fn(u32) -> f32,
        mut holds: impl FnMut(u32, f32) -> bool,
    ) -> bool {
        for row in self.runs(at, radius + longest + self.longest_half()) {
            for entry in &self.entries[row] {
                let (off, own) = (entry.middle.distance_squared(at), radius + entry.half);
                // Most lie beyond the longest reach.
                if off >= (own + longest) * (own + longest) {
                    continue;
                }
                let reach = reach(entry.segment);
                if off < (own + reach) * (own + reach) && !holds(entry.segment, reach) {
                    return false;
                }
            }
        }
        true
    }

    /// Sorts the segments into their cells, each with its search radius.
    pub fn enter(&mut self, network: &Network, downstream: &[u32], reach: &[f32]) {
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        self.longest_halves = [0.0; CLASSES];
        let mut placed: Vec<(u32, Entry)> = Vec::with_capacity(downstream.len());
        for (segment, ((vertex, &below), &reach)) in (0..).zip(network.vertices.iter().zip(downstream).zip(reach)) {
            let Some(next) = network.vertices.get(below as usize) else { continue };
            let half = distance(vertex.at, next.at) * 0.5 + ROUNDING;
            let longest = &mut self.longest_halves[self.class(reach)];
            *longest = fast_max(*longest, half);
            let middle = (vertex.at + next.at) * 0.5;
            let cell = self.cell(middle);
            self.starts[cell as usize] += 1;
            placed.push((cell, Entry { middle, half, reach, segment }));
        }
        for class in 1..CLASSES {
            self.longest_halves[class] = fast_max(self.longest_halves[class], self.longest_halves[class - 1]);
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.entries.clear();
        self.entries.resize(end as usize, Entry::default());
        for &(cell, entry) in placed.iter().rev() {
            let start = &mut self.starts[cell as usize];
            *start -= 1;
            self.entries[*start as usize] = entry;
        }
    }

    fn cell(&self, at: Vec2) -> u32 {
        (self.place(at.y, self.rows) * self.columns + self.place(at.x, self.columns)) as u32
    }

    fn place(&self, x: f32, end: usize) -> usize {
        ((x / self.side) as usize).min(end - 1)
    }

    /// Iterates over the ranges of the entries in the cells within a radius of a point, row by row: all of a square, since a cell
    /// holds so few segments that to leave out those in its corners takes longer.
    fn runs(&self, at: Vec2, radius: f32) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let (left, right) = (self.place(at.x - radius, self.columns), self.place(at.x + radius, self.columns));
        (self.place(at.y - radius, self.rows)..=self.place(at.y + radius, self.rows)).map(move |row| {
            let row = row * self.columns;
            let run = self.starts[row + left] as usize..self.starts[row + right + 1] as usize;
            work::count(1 + run.len());
            run
        })
    }
}

impl Survey<'_> {
    fn measure(
        self,
        own: Entry,
        other: Entry,
        are_neighbours: bool,
        clearance: &mut [f32],
        tell: &mut dyn FnMut(NearbyPair),
    ) {
        let (i, j) = (own.segment as usize, other.segment as usize);
        let (below_i, below_j) = (self.downstream[i], self.downstream[j]);
        if below_i == other.segment || below_j == own.segment || below_i == below_j {
            return;
        }
        let at = |i: usize| self.network.vertices[i].at;
        let distance = gap((at(i), at(below_i as usize)), (at(j), at(below_j as usize)));
        clearance[i] = fast_min(clearance[i], distance);
        clearance[j] = fast_min(clearance[j], distance);
        if !are_neighbours && distance < own.reach {
            tell(NearbyPair {
                first: own.segment.min(other.segment),
                second: own.segment.max(other.segment),
                distance,
            });
        }
    }
}

/// Segments no farther apart along a river than this are near each other by nature.
const NEIGHBOURS: usize = 3;
