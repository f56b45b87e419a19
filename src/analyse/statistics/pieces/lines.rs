//! Lines of one pixel, traced from node to node.

use glam::Vec2;

use super::super::parallels::evenly;
use crate::base::geometry::{direction, lengths};
use crate::base::{sort, work};

/// The eight ways to a neighbour, clockwise.
const WAYS: [(isize, isize); 8] = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1)];

const NO_NODE: u32 = u32::MAX;

/// Number of pixels from a junction in which a line shows where it goes on.
const REACH: usize = 6;

/// The lines of a piece, with a pixel as the unit.
pub(super) struct Lines {
    /// The points of each line from node to node. Nodes are ends and junctions.
    pub chains: Vec<Vec<Vec2>>,
    /// The nodes at both ends of each line.
    ends: Vec<[u32; 2]>,
    /// The places of junctions: where three lines or more meet. Junction pixels that touch are one junction.
    pub junctions: Vec<Vec2>,
}

/// Pixels, row by row, and the node that each is part of.
struct Tracing<'a> {
    pixels: &'a [u8],
    width: usize,
    node: Vec<u32>,
    /// The places of the nodes.
    at: Vec<Vec2>,
    used: Vec<bool>,
}

impl Lines {
    /// Traces lines of one pixel.
    pub fn of(pixels: &[u8], width: usize) -> Self {
        let mut tracing = Tracing {
            pixels,
            width,
            node: vec![NO_NODE; pixels.len()],
            at: Vec::new(),
            used: vec![false; pixels.len()],
        };
        work::count(pixels.len());
        let junctions = tracing.find_nodes();
        let mut this = Self { chains: Vec::new(), ends: Vec::new(), junctions };
        for start in 0..pixels.len() {
            if tracing.node[start] == NO_NODE {
                continue;
            }
            for next in tracing.links(start) {
                if let Some((chain, end)) = tracing.follow(start, next) {
                    this.chains.push(chain);
                    this.ends.push([tracing.node[start], end]);
                }
            }
        }
        this
    }

    /// Makes smoothed lines of rivers, which go through junctions: at each, the two lines that are straightest are one.
    /// Points are a pixel apart.
    pub fn rivers(&self) -> Vec<Vec<Vec2>> {
        let mates = self.mates();
        let mut used = vec![false; self.chains.len()];
        let mut rivers = Vec::new();
        // Rivers from their ends first; what is left then are rings.
        for is_ring in [false, true] {
            for arm in 0..mates.len() {
                if is_ring || mates[arm] == usize::MAX {
                    rivers.extend(self.river(arm, &mates, &mut used));
                }
            }
        }
        rivers
    }

    /// Follows the river that begins with an arm, which is twice the number of a line, plus one to run it backward.
    /// `None` if its line was used.
    fn river(&self, mut arm: usize, mates: &[usize], used: &mut [bool]) -> Option<Vec<Vec2>> {
        let mut line: Vec<Vec2> = Vec::new();
        while arm != usize::MAX && !std::mem::replace(&mut used[arm / 2], true) {
            line.pop();
            line.extend(self.arm(arm));
            arm = mates[arm ^ 1];
        }
        (!line.is_empty()).then(|| smoothed(&line))
    }

    #[inline(never)] // it has two callers
    fn arm(&self, arm: usize) -> Vec<Vec2> {
        let mut line = self.chains[arm / 2].clone();
        if arm % 2 == 1 {
            line.reverse();
        }
        line
    }

    /// Pairs the arms at each node, the straightest two: the arm that each goes on to, or `usize::MAX`.
    fn mates(&self) -> Vec<usize> {
        let mut mates = vec![usize::MAX; 2 * self.chains.len()];
        let by_node = sort::argsort((0..mates.len()).map(|arm| self.ends[arm / 2][arm % 2]));
        let towards: Vec<Vec2> = (0..mates.len()).map(|arm| self.towards(arm)).collect();
        let node = |arm: usize| self.ends[arm / 2][arm % 2];
        let mut first = 0;
        while first < by_node.len() {
            let (mut after, mut straightest) = (first, f32::INFINITY);
            let mut pair = None;
            while after < by_node.len() && node(by_node[after]) == node(by_node[first]) {
                for &other in &by_node[first..after] {
                    let cosine = towards[by_node[after]].dot(towards[other]);
                    if cosine < straightest {
                        (straightest, pair) = (cosine, Some((by_node[after], other)));
                    }
                }
                after += 1;
            }
            if let Some((a, b)) = pair {
                (mates[a], mates[b]) = (b, a);
            }
            first = after;
        }
        mates
    }

    fn towards(&self, arm: usize) -> Vec2 {
        let line = self.arm(arm);
        direction(line[REACH.min(line.len() - 1)] - line[0])
    }
}

impl Tracing<'_> {
    /// Finds all nodes and returns the places of the junctions.
    fn find_nodes(&mut self) -> Vec<Vec2> {
        let mut junctions = Vec::new();
        for i in 0..self.pixels.len() {
            if self.pixels[i] == 0 || self.node[i] != NO_NODE || self.links(i).len() == 2 {
                continue;
            }
            let number = self.at.len() as u32;
            let is_junction = self.links(i).len() > 2;
            let mut members = vec![i];
            self.node[i] = number;
            let mut next = 0;
            while is_junction && next < members.len() {
                for other in self.links(members[next]) {
                    if self.node[other] == NO_NODE && self.links(other).len() > 2 {
                        self.node[other] = number;
                        members.push(other);
                    }
                }
                next += 1;
            }
            let centre = members.iter().map(|&i| self.place(i)).sum::<Vec2>() / members.len() as f32;
            self.at.push(centre);
            if is_junction {
                junctions.push(centre);
            }
        }
        junctions
    }

    /// Follows a line from a node to the next one. `None` if it was followed before.
    fn follow(&mut self, start: usize, next: usize) -> Option<(Vec<Vec2>, u32)> {
        let own = self.node[start];
        if self.node[next] == own || self.used[next] || (self.node[next] != NO_NODE && next < start) {
            return None;
        }
        let mut line = vec![self.at[own as usize]];
        let (mut before, mut here) = (start, next);
        while self.node[here] == NO_NODE {
            self.used[here] = true;
            line.push(self.place(here));
            let onward = self.links(here).into_iter().find(|&other| other != before)?;
            (before, here) = (here, onward);
        }
        line.push(self.at[self.node[here] as usize]);
        Some((line, self.node[here]))
    }

    /// Returns the pixels of the line next to one of its pixels. A diagonal neighbour is none if there is a way around
    /// the corner.
    #[inline(never)] // it has many callers
    fn links(&self, i: usize) -> Vec<usize> {
        let (x, y) = ((i % self.width) as isize, (i / self.width) as isize);
        let at = |dx: isize, dy: isize| {
            let is_inside = (0..self.width as isize).contains(&(x + dx)) && y + dy >= 0;
            let at = ((y + dy) * self.width as isize + x + dx) as usize;
            (is_inside && self.pixels.get(at).is_some_and(|&pixel| pixel != 0)).then_some(at)
        };
        let mut found = Vec::new();
        for (dx, dy) in WAYS {
            if dx * dy == 0 || (at(dx, 0).is_none() && at(0, dy).is_none()) {
                found.extend(at(dx, dy));
            }
        }
        found
    }

    fn place(&self, i: usize) -> Vec2 {
        Vec2::new((i % self.width) as f32, (i / self.width) as f32)
    }
}

/// Measures the length of a line after smoothing, in pixels.
pub(super) fn length(line: &[Vec2]) -> f64 {
    lengths(&smoothed_ends(line)).last().copied().unwrap_or_default().into()
}

/// Smooths a line so that it no longer shows pixels, and returns points a pixel apart, from its first point.
pub(super) fn smoothed(line: &[Vec2]) -> Vec<Vec2> {
    evenly(&smoothed_ends(line), 1.0)
}

/// Smooths a line by a bell curve with a standard deviation of two pixels. Its ends stay.
fn smoothed_ends(line: &[Vec2]) -> Vec<Vec2> {
    /// Each adds half a square pixel to the variance.
    const ROUNDS: usize = 8;
    let length = lengths(line).last().copied().unwrap_or_default();
    let steps = ((length + 0.5) as usize).max(1);
    let mut points = evenly(line, length / steps as f32);
    points.truncate(steps);
    points.extend(line.last());
    work::count(ROUNDS * points.len());
    for _ in 0..ROUNDS {
        let mut before = line[0];
        for i in 1..points.len() - 1 {
            let own = points[i];
            points[i] = (before + own * 2.0 + points[i + 1]) / 4.0;
            before = own;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn traced(picture: &[&str]) -> Lines {
        let pixels: Vec<u8> = picture.concat().bytes().map(|c| u8::from(c == b'#')).collect();
        Lines::of(&pixels, picture[0].len())
    }

    #[test]
    fn a_line_is_one_chain_even_around_corners() {
        let lines = traced(&["##.....", ".##....", "...##..", ".....##"]);
        assert_eq!((lines.chains.len(), lines.junctions.len()), (1, 0));
        assert_eq!(lines.chains[0].len(), 8, "no pixel is left out: {:?}", lines.chains);
    }

    #[test]
    fn a_line_that_ends_at_another_makes_a_junction_and_two_rivers() {
        let tee = ["..........", "##########", ".....#....", ".....#....", ".....#...."];
        let lines = traced(&tee);
        assert_eq!((lines.chains.len(), &lines.junctions[..]), (3, &[Vec2::new(5.0, 1.0)][..]));
        let rivers = lines.rivers();
        assert_eq!(rivers.len(), 2);
        let stem = rivers.iter().find(|river| river.len() > 5).unwrap();
        assert!((stem[0].x - stem[stem.len() - 1].x).abs() > 8.0 && stem.iter().all(|at| at.y == 1.0), "{stem:?}");
    }

    #[test]
    fn junction_pixels_that_touch_are_one_junction() {
        let lines = traced(&["#....#", ".#..#.", "..##..", ".#..#.", "#....#"]);
        assert_eq!((lines.chains.len(), &lines.junctions[..]), (4, &[Vec2::new(2.5, 2.0)][..]));
        // One goes through, two end there.
        assert_eq!(lines.rivers().len(), 3);
    }

    #[test]
    fn a_ring_is_followed_once_if_a_line_leads_to_it() {
        let ring = ["......", ".####.", ".#..#.", ".#..##", ".####."];
        let lines = traced(&ring);
        assert_eq!((lines.chains.len(), lines.junctions.len()), (2, 1));
        assert_eq!(traced(&["###", "#.#", "###"]).chains.len(), 0);
    }

    /// Smooths a line of which every second pixel is a step to the side.
    #[test]
    fn smoothing_takes_stairs_away_and_leaves_ends() {
        let stairs: Vec<Vec2> = (0..40).map(|i| Vec2::new(i as f32, (i / 2) as f32)).collect();
        let smooth = smoothed(&stairs);
        assert_eq!(smooth[0], Vec2::ZERO);
        let off = |at: &Vec2| (at.y - (at.x - 0.5) / 2.0).abs();
        assert!(smooth[5..smooth.len() - 5].iter().all(|at| off(at) < 0.05), "{smooth:?}");
        // A straight line keeps its length.
        assert!((length(&[Vec2::ZERO, Vec2::new(12.3, 0.0)]) - 12.3).abs() < 1e-4);
    }
}
