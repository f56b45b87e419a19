//! The coast in a picture, by marching squares (after Lorensen and Cline 1987). Each point is placed between two blocks
//! according to their shares of land.

use glam::Vec2;

use super::ground::Ground;
use crate::base::rings::area;

/// The share of land above which a block is land.
const LEVEL: f32 = 0.5;
const NONE: u32 = u32::MAX;

/// Traces the closed lines between land and water, in fractions of width and height. Land at the border of the picture
/// is closed along it, at exactly 0 or 1.
pub(super) fn rings(ground: &Ground) -> Vec<Vec<Vec2>> {
    let squares = Squares { ground, columns: ground.columns as i32 + 2, rows: ground.rows as i32 + 2 };
    let mut next = squares.segments();
    let mut rings = Vec::new();
    for start in 0..next.len() {
        let mut ring = Vec::new();
        let mut crossing = start;
        while next[crossing] != NONE {
            ring.push(squares.place(crossing));
            crossing = std::mem::replace(&mut next[crossing], NONE) as usize;
        }
        if !ring.is_empty() && area(&ring).abs() >= ground.speck {
            rings.push(with_corners(&ring));
        }
    }
    rings
}

/// Adds the corner of the picture where a ring goes from one side to the next.
fn with_corners(ring: &[Vec2]) -> Vec<Vec2> {
    let is_border = |x: f32| x == 0.0 || x == 1.0;
    let mut whole = Vec::with_capacity(ring.len() + 4);
    for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        whole.push(a);
        if is_border(a.x) && is_border(b.y) && a.x != b.x && a.y != b.y {
            whole.push(Vec2::new(a.x, b.y));
        } else if is_border(a.y) && is_border(b.x) && a.x != b.x && a.y != b.y {
            whole.push(Vec2::new(b.x, a.y));
        }
    }
    whole
}

/// The squares between the middles of blocks, with one more block all around the picture. A crossing is a side between
/// two corners of which one is land. Its number is twice that of its western or northern corner, plus one if the side
/// runs south.
struct Squares<'a> {
    ground: &'a Ground,
    columns: i32,
    rows: i32,
}

/// The sides by which a coast enters and leaves a square, by the land at its corners (north-west 1, north-east 2,
/// south-east 4, south-west 8). Land lies to the coast's left. Land that meets only at a corner is separate. Sides: 0
/// north, 1 east, 2 south, 3 west.
const WAYS: [&[(usize, usize)]; 16] = [
    &[],
    &[(3, 0)],
    &[(0, 1)],
    &[(3, 1)],
    &[(1, 2)],
    &[(3, 0), (1, 2)],
    &[(0, 2)],
    &[(3, 2)],
    &[(2, 3)],
    &[(2, 0)],
    &[(0, 1), (2, 3)],
    &[(2, 1)],
    &[(1, 3)],
    &[(1, 0)],
    &[(0, 3)],
    &[],
];

impl Squares<'_> {
    /// Returns the next crossing along the coast for each crossing, or `NONE` where the coast does not cross.
    fn segments(&self) -> Vec<u32> {
        let mut next = vec![NONE; (self.columns * self.rows * 2) as usize];
        for row in 0..self.rows - 1 {
            for column in 0..self.columns - 1 {
                let corner = row * self.columns + column;
                let sides = [corner * 2, corner * 2 + 3, (corner + self.columns) * 2, corner * 2 + 1];
                for &(from, to) in WAYS[self.land_around(column, row)] {
                    next[sides[from] as usize] = sides[to] as u32;
                }
            }
        }
        next
    }

    fn land_around(&self, column: i32, row: i32) -> usize {
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let is_land = |&(x, y): &(i32, i32)| self.land(column + x, row + y) > LEVEL;
        corners.iter().enumerate().map(|(bit, corner)| usize::from(is_land(corner)) << bit).sum()
    }

    /// Returns the share of land at a corner. Beyond the border it is the opposite of land within, so that the coast
    /// runs halfway between, along the border.
    fn land(&self, column: i32, row: i32) -> f32 {
        let (x, y) = (column - 1, row - 1);
        let (columns, rows) = (self.ground.columns as i32, self.ground.rows as i32);
        let nearest = (y.clamp(0, rows - 1) * columns + x.clamp(0, columns - 1)) as usize;
        let land = self.ground.land[nearest];
        let is_inside = (0..columns).contains(&x) && (0..rows).contains(&y);
        if is_inside { land } else { (1.0 - land).min(LEVEL) }
    }

    /// Returns the point at which the coast crosses, in fractions of the picture.
    fn place(&self, crossing: usize) -> Vec2 {
        let corner = crossing as i32 / 2;
        let (column, row) = (corner % self.columns, corner / self.columns);
        let (east, south) = if crossing.is_multiple_of(2) { (1, 0) } else { (0, 1) };
        let (from, to) = (self.land(column, row), self.land(column + east, row + south));
        let share = (LEVEL - from) / (to - from);
        let at = |column: i32, row: i32| Vec2::new(self.ground.across(column - 1), self.ground.down(row - 1));
        let place = at(column, row).lerp(at(column + east, row + south), share);
        // Rounding must not leave a thin strip of water along the border.
        let snap = |x: f32| match x {
            x if x < 1e-5 => 0.0,
            x if x > 1.0 - 1e-5 => 1.0,
            x => x,
        };
        Vec2::new(snap(place.x), snap(place.y))
    }
}
