//! The guard: how near the lines of a network come to each other.
//!
//! Two segments that have no end in common, at a distance d, cannot come to cross if each moves by less than d/2. So it is
//! enough to know, for each segment, the distance to the nearest other one, as far as it can matter; and what is told of here
//! keeps all rivers apart at every round, whatever moves them.
//!
//! Segments are entered in a grid by their middles, each row of cells being one run in memory, and looked for around each
//! segment that can move or is wide. A pair is told once, by the one that looks farther.

use glam::Vec2;

use super::plane::{distance, meet, most};
use super::{NONE, Network};
use crate::domain::Domain;

/// Two segments, each known by its upper vertex, and their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// The one that comes first.
    pub first: u32,
    /// The other.
    pub second: u32,
    /// In units.
    pub distance: f32,
}

/// A grid of segments, used again from round to round.
#[derive(Clone, Debug, Default)]
pub struct Guard {
    side: f32,
    columns: usize,
    rows: usize,
    /// Where each cell begins in `entries`.
    starts: Vec<u32>,
    entries: Vec<Entry>,
    /// Half the length of the longest segment.
    longest_half: f32,
}

/// A segment in a cell.
#[derive(Clone, Copy, Debug, Default)]
struct Entry {
    middle: Vec2,
    reach: f32,
    segment: u32,
}

impl Guard {
    /// An empty grid for segments about as long as a spacing.
    pub fn new(domain: &Domain, spacing: f32) -> Self {
        let side = spacing * 2.5;
        let cells = (domain.size / side).floor() + 1.0;
        Self { side, columns: cells.x as usize, rows: cells.y as usize, ..Self::default() }
    }

    /// Measures the distance of each segment from the nearest other one with no end in common, if it is below `cap`, else
    /// `cap`; by its upper vertex. Mouths, which have no segment, have `cap`. `reach` is how far each segment looks around;
    /// one that can neither move nor matter beyond `cap` looks nowhere, 0. Of each pair nearer than the farther of two
    /// reaches `tell` is told, unless they are near each other along one river.
    pub fn survey(
        &mut self,
        network: &Network,
        downstream: &[u32],
        reach: &[f32],
        cap: f32,
        tell: &mut dyn FnMut(Near),
    ) -> Vec<f32> {
        self.enter(network, downstream, reach);
        let mut clearance = vec![cap; downstream.len()];
        for run in self.starts.windows(2) {
            for place in run[0] as usize..run[1] as usize {
                if self.entries[place].reach > 0.0 {
                    self.look_around(self.entries[place], network, downstream, &mut clearance, tell);
                }
            }
        }
        clearance
    }

    fn look_around(
        &self,
        own: Entry,
        network: &Network,
        downstream: &[u32],
        clearance: &mut [f32],
        tell: &mut dyn FnMut(Near),
    ) {
        let radius = own.reach + 2.0 * self.longest_half;
        let i = own.segment as usize;
        let segment = |i: usize| (network.vertices[i].at, network.vertices[downstream[i] as usize].at);
        for row in self.runs(own.middle, radius) {
            for other in &self.entries[row] {
                let off = other.middle - own.middle;
                if off.dot(off) > radius * radius
                    || other.reach > own.reach
                    || (other.reach == own.reach && other.segment <= own.segment)
                {
                    continue;
                }
                let j = other.segment as usize;
                let (below_i, below_j) = (downstream[i], downstream[j]);
                if below_i == other.segment || below_j == own.segment || below_i == below_j {
                    continue;
                }
                let distance = distance(segment(i), segment(j));
                if distance < own.reach {
                    if distance < clearance[i] {
                        clearance[i] = distance;
                    }
                    if distance < clearance[j] {
                        clearance[j] = distance;
                    }
                    if i.abs_diff(j) > NEIGHBOURS {
                        let (first, second) = (own.segment.min(other.segment), own.segment.max(other.segment));
                        tell(Near { first, second, distance });
                    }
                }
            }
        }
    }

    /// Whether a line from one vertex to another, across a neck, meets no segment of the last survey but those that end
    /// in either.
    pub fn is_free(&self, network: &Network, downstream: &[u32], (a, b): (u32, u32)) -> bool {
        let line = (network.vertices[a as usize].at, network.vertices[b as usize].at);
        let radius = line.0.distance(line.1) * 0.5 + self.longest_half;
        self.runs((line.0 + line.1) * 0.5, radius).all(|row| {
            self.entries[row].iter().all(|other| {
                let (j, below) = (other.segment, downstream[other.segment as usize]);
                let is_end = [a, b].contains(&j) || [a, b].contains(&below);
                is_end || !meet(line, (network.vertices[j as usize].at, network.vertices[below as usize].at))
            })
        })
    }

    /// Takes away of oxbow lakes what rivers of the last survey run over, or so near that no land is left between.
    pub fn erode(&self, network: &mut Network, downstream: &[u32], buffer: f32) {
        let widest = network.vertices.iter().map(|vertex| vertex.width()).fold(0.0, most);
        let vertices = &network.vertices;
        for lake in network.oxbows.iter_mut().flat_map(|oxbow| &mut oxbow.vertices).filter(|lake| lake.width() > 0.0) {
            let radius = (lake.width() + widest) * 0.5 + buffer + self.longest_half;
            let is_run_over = self.runs(lake.at, radius).any(|row| {
                self.entries[row].iter().any(|entry| {
                    let upper = &vertices[entry.segment as usize];
                    let lower = &vertices[downstream[entry.segment as usize] as usize];
                    let apart = distance((lake.at, lake.at), (upper.at, lower.at));
                    apart < (lake.width() + upper.width()) * 0.5 + buffer
                })
            });
            if is_run_over {
                (lake.left, lake.right) = (0.0, 0.0);
            }
        }
    }

    /// Sorts the segments into their cells.
    fn enter(&mut self, network: &Network, downstream: &[u32], reach: &[f32]) {
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        self.longest_half = 0.0;
        let mut middles = Vec::with_capacity(downstream.len());
        for (vertex, &below) in network.vertices.iter().zip(downstream) {
            let middle = match network.vertices.get(below as usize) {
                None => (Vec2::NAN, NONE),
                Some(next) => {
                    self.longest_half = most(self.longest_half, vertex.at.distance_squared(next.at));
                    let middle = (vertex.at + next.at) * 0.5;
                    (middle, self.cell(middle))
                }
            };
            if middle.1 != NONE {
                self.starts[middle.1 as usize] += 1;
            }
            middles.push(middle);
        }
        self.longest_half = self.longest_half.sqrt() * 0.5;
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.entries.clear();
        self.entries.resize(end as usize, Entry::default());
        for (i, &(middle, cell)) in middles.iter().enumerate().rev().filter(|(_, middle)| middle.1 != NONE) {
            let start = &mut self.starts[cell as usize];
            *start -= 1;
            self.entries[*start as usize] = Entry { middle, reach: reach[i], segment: i as u32 };
        }
    }

    fn cell(&self, at: Vec2) -> u32 {
        (self.place(at.y, self.rows) * self.columns + self.place(at.x, self.columns)) as u32
    }

    fn place(&self, x: f32, end: usize) -> usize {
        ((x / self.side) as usize).min(end - 1)
    }

    /// The entries in the cells around a point, row by row.
    fn runs(&self, at: Vec2, radius: f32) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let (left, right) = (self.place(at.x - radius, self.columns), self.place(at.x + radius, self.columns));
        (self.place(at.y - radius, self.rows)..=self.place(at.y + radius, self.rows)).map(move |row| {
            let row = row * self.columns;
            self.starts[row + left] as usize..self.starts[row + right + 1] as usize
        })
    }
}

/// Segments no farther apart along a river than this are near each other by nature.
const NEIGHBOURS: usize = 3;
