//! The ridges in a picture, as lines along their middles.

use glam::Vec2;

use super::areas;
use super::ground::Ground;
use crate::base::skeletonize::thin;

/// The smallest number of blocks of a line. Shorter ones are specks, or hairs left by thinning.
const FEWEST: usize = 6;

/// Traces the ridges, in fractions of width and height: lines along the middle of narrow areas, and around wide ones.
pub(super) fn lines(ground: &Ground) -> Vec<Vec<Vec2>> {
    let mut mask: Vec<u8> = ground.ridges.iter().map(|&ridge| if ridge == 0 { 0 } else { 255 }).collect();
    let mut lines = areas::take_out(ground, &mut mask);
    thin(&mut mask, ground.columns);
    let mut walker = Walker { ground, is_left: mask.iter().map(|&pixel| pixel != 0).collect(), mask };
    let starts: Vec<usize> = (0..walker.mask.len()).filter(|&i| walker.mask[i] != 0).collect();
    let (ends, others): (Vec<usize>, Vec<usize>) = starts.into_iter().partition(|&i| walker.beside(i).count() == 1);
    // Loose ends come first, so that each line is walked as a whole, then rings and lines between forks.
    for start in ends.into_iter().chain(others) {
        let line = walker.walk(start);
        if line.len() >= FEWEST {
            lines.push(smoothed(line.into_iter().map(|i| walker.place(i)).collect()));
        }
    }
    lines
}

/// Smooths the steps of a line. Its ends stay.
fn smoothed(mut line: Vec<Vec2>) -> Vec<Vec2> {
    const ROUNDS: usize = 8;
    for _ in 0..ROUNDS {
        let middles: Vec<Vec2> = line.windows(3).map(|near| (near[0] + near[1] * 2.0 + near[2]) / 4.0).collect();
        let end = line.len() - 1;
        line[1..end].copy_from_slice(&middles);
    }
    line
}

/// Walks along lines one pixel wide, visiting each pixel once.
struct Walker<'a> {
    ground: &'a Ground,
    mask: Vec<u8>,
    is_left: Vec<bool>,
}

impl Walker<'_> {
    /// Returns the line that begins at a pixel; empty if that has been visited. It is connected to the lines that it
    /// meets.
    fn walk(&mut self, start: usize) -> Vec<usize> {
        if !self.is_left[start] {
            return Vec::new();
        }
        let mut line: Vec<usize> = self.beside(start).find(|&i| !self.is_left[i]).into_iter().collect();
        let mut at = start;
        loop {
            line.push(at);
            self.is_left[at] = false;
            match self.beside(at).find(|&i| self.is_left[i]) {
                Some(next) => at = next,
                None => break,
            }
        }
        let met = self.beside(at).find(|i| !line[line.len().saturating_sub(3)..].contains(i));
        line.extend(met);
        line
    }

    /// Iterates over the set neighbours of a pixel, first those that share a side, then those that share a corner.
    fn beside(&self, i: usize) -> impl Iterator<Item = usize> + use<'_> {
        const AROUND: [(i32, i32); 8] = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];
        let (columns, rows) = (self.ground.columns as i32, self.ground.rows as i32);
        let (x, y) = (i as i32 % columns, i as i32 / columns);
        let places = AROUND.into_iter().map(move |(east, south)| (x + east, y + south));
        let inside = places.filter(move |(x, y)| (0..columns).contains(x) && (0..rows).contains(y));
        inside.map(move |(x, y)| (y * columns + x) as usize).filter(|&i| self.mask[i] != 0)
    }

    fn place(&self, i: usize) -> Vec2 {
        let (column, row) = (i % self.ground.columns, i / self.ground.columns);
        Vec2::new(self.ground.across(column as i32), self.ground.down(row as i32))
    }
}
