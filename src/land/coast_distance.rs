//! Coast distances: the distance of every point of the domain from the coast, a signed distance field.
//!
//! Distances are stored at the corners of a coarse lattice and interpolated bilinearly, which is accurate enough for
//! growth, which uses cells. Pictures show the coast without facets (`smoothed_distance.rs`). A field is made from a
//! coast, as line segments, and from the corners that are land.

use std::ops::Range;

use glam::Vec2;

use super::cell::Cell;
use super::regions::{Region, Run, regions};
use super::walk::walk;
use crate::base::geometry::{fast_max, fast_min};
use crate::base::sort;
use crate::base::work;
use crate::domain::Domain;

/// A straight piece of coast, from one end to the other.
pub(super) type Piece = [Vec2; 2];

/// The distance of a point from the coast if there is no coast, in units.
const FARTHEST: f32 = 1e4;

/// Distances from the coast at lattice corners, in units: positive on land, negative at sea.
#[derive(Clone, Debug, PartialEq)]
pub struct CoastDistance {
    heights: Vec<f32>,
    columns: usize,
    rows: usize,
    /// The distance between corners, in units.
    spacing: f32,
}

impl CoastDistance {
    /// The distance between lattice corners, in units, for all shapes that a recipe names: half the shortest wave of
    /// their coasts.
    pub const SPACING: f32 = 4.0;
    /// The distance between lattice corners for drawn lands, whose coasts have few points, for lines and for previews.
    pub const COARSE_SPACING: f32 = 8.0;
    /// The distance between lattice corners for lands from masks, whose coasts may have any shape: half of it is less
    /// than the width of a coast line. It divides the other spacings and is a multiple of a cell.
    pub const FINE_SPACING: f32 = 2.0;

    /// Makes the land where a height function is high, on a lattice with a spacing, without islets and ponds. The sea
    /// covers a share of the domain, where the function is lowest. Heights are those of the function until the land is
    /// [settled](Self::settled).
    pub(super) fn with_sea(domain: &Domain, spacing: f32, share: f32, height: &dyn Fn(Vec2) -> f32) -> Self {
        let mut this = Self::sampled(domain, spacing, share, height);
        this.remove_islets_and_ponds();
        this
    }

    /// Puts some corners, given by their indices, under water. The result has yet to be [settled](Self::settled).
    pub(super) fn flooded(mut self, corners: &[usize]) -> Self {
        let depth = self.spacing;
        for &corner in corners {
            self.heights[corner] = -depth;
            // The coast between a flooded corner and its neighbour lies midway, however high the neighbour is.
            let [column, row] = [corner % self.columns, corner / self.columns];
            for row in row.saturating_sub(1)..(row + 2).min(self.rows) {
                for column in column.saturating_sub(1)..(column + 2).min(self.columns) {
                    let beside = &mut self.heights[row * self.columns + column];
                    *beside = beside.min(depth);
                }
            }
        }
        self.remove_islets_and_ponds();
        self
    }

    /// Replaces heights by distances from the line of height 0.
    #[inline(never)] // one copy for all lands
    pub(super) fn settled(self) -> Self {
        let coast = self.contour();
        self.measured(&coast)
    }

    /// Makes the land where heights at the corners of the same lattice, row by row, are above 0. They stand for
    /// distances until the land is [settled](Self::settled).
    pub(crate) fn with_heights_of(&self, heights: &[f32]) -> Self {
        let &Self { columns, rows, spacing, .. } = self;
        Self { heights: heights.to_vec(), columns, rows, spacing }
    }

    /// Replaces the height of each corner by a function of it and of the corner's index.
    pub(super) fn replace(&mut self, height: impl Fn(f32, usize) -> f32) {
        self.heights.iter_mut().enumerate().for_each(|(corner, here)| *here = height(*here, corner));
    }

    /// Deepens the corners of water to at least a depth, in units, so that water is connected as its corners are, however narrow it is.
    pub(super) fn deepened(mut self, shallowest: f32) -> Self {
        self.heights.iter_mut().filter(|height| **height <= 0.0).for_each(|height| *height = height.min(-shallowest));
        self
    }

    /// Fills waters so narrow that no cell may be sea, as where drawn coasts all but meet: a river could end in one.
    pub(super) fn without_slivers(mut self) -> Self {
        /// The least depth of the deepest corner of a water, in units: half the width at which a cell of a relief lies in it.
        const DEEP: f32 = 2.0;
        for water in self.regions(Cell::Water) {
            let corners: Vec<usize> = self.corners_of(&water).collect();
            if corners.iter().all(|corner| self.heights[*corner] > -DEEP) {
                corners.into_iter().for_each(|corner| self.heights[corner] = self.heights[corner].abs().max(1.0));
            }
        }
        self
    }

    /// Counts the lattice squares around each corner whose middles lie in the domain: the weight of the corner in
    /// areas.
    #[inline(never)] // one copy for all lands
    pub(crate) fn squares_around(&self, domain: &Domain) -> Vec<u32> {
        let mut squares = vec![0; self.heights.len()];
        let is_inside = |&i: &usize| domain.contains(self.corner(i) + self.spacing / 2.0);
        for i in (0..self.heights.len()).filter(is_inside) {
            [i, i + 1, i + self.columns, i + self.columns + 1].into_iter().for_each(|corner| squares[corner] += 1);
        }
        squares
    }

    /// Lists the heights at the corners of each lattice square whose middle lies in the domain. A corner occurs once
    /// for each such square, so it counts for the area around it.
    fn heights_of_squares(&self, domain: &Domain) -> Vec<f32> {
        let mut of_squares = Vec::with_capacity(4 * self.heights.len());
        for (height, squares) in self.heights.iter().zip(self.squares_around(domain)) {
            (0..squares).for_each(|_| of_squares.push(*height));
        }
        of_squares
    }

    /// Makes the land within a coast, on a lattice with a spacing; `is_land` lists the corners row by row.
    pub(super) fn of_coast(domain: &Domain, spacing: f32, coast: &[Piece], is_land: &[bool]) -> Self {
        let (columns, rows) = Self::corners(domain, spacing);
        let heights = is_land.iter().map(|&is_land| if is_land { 1.0 } else { -1.0 }).collect();
        Self { heights, columns, rows, spacing }.measured(coast)
    }

    /// Measures the distances from some lines, with land on both sides.
    pub(crate) fn from_lines(domain: &Domain, lines: &[Piece]) -> Self {
        let (columns, rows) = Self::corners(domain, Self::COARSE_SPACING);
        Self::of_coast(domain, Self::COARSE_SPACING, lines, &vec![true; columns * rows])
    }

    /// Makes land everywhere except in a strait of a given width between two points.
    #[cfg(test)]
    pub(crate) fn of_strait(domain: &Domain, from: Vec2, to: Vec2, width: f32) -> Self {
        let across = (to - from).perp().normalize();
        let (columns, rows) = Self::corners(domain, Self::SPACING);
        let is_land = |i| ((corner(i, columns, Self::SPACING) - from).dot(across)).abs() > width / 2.0;
        let is_land: Vec<bool> = (0..columns * rows).map(is_land).collect();
        let coast = [0.5, -0.5].map(|side| [from + across * (width * side), to + across * (width * side)]);
        Self::of_coast(domain, Self::SPACING, &coast, &is_land)
    }

    /// Makes a lattice with these heights at its corners, row by row; `None` if their number does not fit a domain of
    /// this size.
    #[cfg(test)]
    pub(crate) fn of_heights(size: Vec2, spacing: f32, heights: Vec<f32>) -> Option<Self> {
        let [columns, rows] = size.to_array().map(|length| ((length / spacing) as usize).saturating_add(2));
        (columns.checked_mul(rows)? == heights.len()).then_some(Self { heights, columns, rows, spacing })
    }

    /// Returns the number of columns and rows of a lattice's corners: one more than needed to cover the domain.
    pub(super) fn corners(domain: &Domain, spacing: f32) -> (usize, usize) {
        let corners = |length: f32| (length / spacing) as usize + 2;
        (corners(domain.size.x), corners(domain.size.y))
    }

    /// Samples heights above the sea, whose level follows from the corners of a coarse lattice. Between these, from one
    /// lattice to that with half the spacing, the function is called only where the coast may pass; elsewhere only the
    /// sign of the height matters.
    fn sampled(domain: &Domain, spacing: f32, share: f32, height: &dyn Fn(Vec2) -> f32) -> Self {
        /// The distance between corners of the coarsest lattice, in units.
        const FAR: f32 = 16.0;
        let mut lattice = Self::with_heights(domain, FAR, &|at, _| height(at));
        let level = sort::quantile(&lattice.heights_of_squares(domain), share);
        lattice.heights.iter_mut().for_each(|height| *height -= level);
        while lattice.spacing > spacing {
            lattice = Self::with_heights(domain, lattice.spacing / 2.0, &|at, place| {
                lattice.certain(place).unwrap_or_else(|| height(at) - level)
            });
        }
        lattice
    }

    /// Makes a lattice whose heights are a function of the place and of its column and row.
    fn with_heights(domain: &Domain, spacing: f32, height: &dyn Fn(Vec2, [usize; 2]) -> f32) -> Self {
        let (columns, rows) = Self::corners(domain, spacing);
        let mut heights = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            let at = |column: usize| Vec2::new(column as f32, row as f32) * spacing;
            heights.extend((0..columns).map(|column| height(at(column), [column, row])));
        }
        Self { heights, columns, rows, spacing }
    }

    /// Returns the height at a corner of the lattice with half the spacing; `None` if the coast may pass near it and
    /// this lattice does not have it. Far from the coast only the sign is right.
    fn certain(&self, at: [usize; 2]) -> Option<f32> {
        /// The coast may pass where the height differs from the level by less than this, in spacings.
        const NEAR: f32 = 1.1;
        let [west, north] = at.map(|i| i / 2);
        let [east, south] = at.map(|i| i.div_ceil(2));
        let first = self.heights[north * self.columns + west];
        if [west, north] == [east, south] {
            return Some(first);
        }
        let is_alike = |column: usize, row: usize| {
            let height = self.heights[row * self.columns + column];
            height.abs() > NEAR * self.spacing && (height > 0.0) == (first > 0.0)
        };
        let is_far = is_alike(west, north) && is_alike(east, north) && is_alike(west, south) && is_alike(east, south);
        is_far.then_some(first)
    }

    /// Turns islets into sea and ponds into land. The map has no room for rivers on islets, and rivers of the land
    /// around a pond run through it. Ponds are waters of less than a hundredth of the domain, but the largest water
    /// always stays.
    fn remove_islets_and_ponds(&mut self) {
        const ISLET: f32 = 200.0;
        const LEVELLED: f32 = 1.0;
        let (islet, pond) = ((ISLET / (self.spacing * self.spacing)) as u32, self.heights.len() as u32 / 100);
        for (kind, least, level) in [(Cell::Land, islet, -LEVELLED), (Cell::Water, pond, LEVELLED)] {
            for region in self.regions(kind).iter().skip(1).filter(|region| region.cells < least) {
                for run in &region.runs {
                    self.heights[corners_of_run(run, self.columns)].fill(level);
                }
            }
        }
    }

    /// Finds the connected components of corners of land, or of water, the largest first.
    pub(super) fn regions(&self, kind: Cell) -> Vec<Region> {
        let cell = |&height: &f32| if height > 0.0 { Cell::Land } else { Cell::Water };
        regions(&self.heights.iter().map(cell).collect::<Vec<_>>(), kind, self.columns)
    }

    /// Iterates over the indices of a region's corners.
    pub(super) fn corners_of<'a>(&self, region: &'a Region) -> impl Iterator<Item = usize> + 'a {
        let columns = self.columns;
        region.runs.iter().flat_map(move |run| corners_of_run(run, columns))
    }

    /// Traces the line of height 0 through the squares of the lattice (marching squares).
    fn contour(&self) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for row in 0..self.rows - 1 {
            for column in 0..self.columns - 1 {
                let northwest = row * self.columns + column;
                // The corners in order around the square, so that consecutive crossings form pairs.
                let round = [northwest, northwest + 1, northwest + self.columns + 1, northwest + self.columns];
                let land = round.iter().filter(|&&corner| self.heights[corner] > 0.0).count();
                if land % 4 == 0 {
                    continue;
                }
                let mut from = None;
                for at in (0..4).filter_map(|side| self.crossing(round[side], round[(side + 1) % 4])) {
                    match from.take() {
                        None => from = Some(at),
                        Some(from) => pieces.push([from, at]),
                    }
                }
            }
        }
        pieces
    }

    /// Returns the point between two corners where the height is 0; `None` if there is none.
    fn crossing(&self, a: usize, b: usize) -> Option<Vec2> {
        let (from, to) = (self.heights[a], self.heights[b]);
        let crosses = (from > 0.0) != (to > 0.0);
        crosses.then(|| self.corner(a).lerp(self.corner(b), from / (from - to)))
    }

    /// Returns the position of a corner, in units.
    pub(crate) fn corner(&self, i: usize) -> Vec2 {
        corner(i, self.columns, self.spacing)
    }

    /// Replaces heights by distances from a coast and keeps their signs.
    #[inline(never)] // one copy for all lands
    fn measured(mut self, coast: &[Piece]) -> Self {
        let nearest = Nearest::of(coast, &self);
        for (height, squared) in self.heights.iter_mut().zip(nearest.squared) {
            *height = squared.sqrt() * if *height > 0.0 { 1.0 } else { -1.0 };
        }
        self
    }

    /// Returns the distance between corners, in units.
    pub(crate) fn spacing(&self) -> f32 {
        self.spacing
    }

    /// Returns the number of columns and rows of corners.
    pub(crate) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Returns the heights of the corners, row by row.
    pub(crate) fn heights(&self) -> &[f32] {
        &self.heights
    }

    /// Interpolates the heights at both ends of an interval, at a share of the way from a row of corners to the next one.
    #[inline]
    pub(super) fn ends(&self, row: usize, interval: usize, share: f32) -> [f32; 2] {
        let corner = |row: usize, column: usize| self.heights[row.min(self.rows - 1) * self.columns + column];
        [interval, interval + 1].map(|column| corner(row, column) * (1.0 - share) + corner(row + 1, column) * share)
    }

    /// Lists, of the first intervals between a row of corners and the next one, the very first, those that a coast may
    /// run through, and those after them.
    pub(super) fn coasts_between(&self, row: usize, intervals: usize) -> Vec<u32> {
        let corners = |row: usize| self.heights[row.min(self.rows - 1) * self.columns..][..=intervals].windows(2);
        let mut coasts = Vec::new();
        // 0 for water on all sides, 4 for land.
        let mut before = usize::MAX;
        for (interval, (upper, lower)) in (0..).zip(corners(row).zip(corners(row + 1))) {
            let land = [upper[0], upper[1], lower[0], lower[1]].map(|height| usize::from(height > 0.0));
            let land = land[0] + land[1] + land[2] + land[3];
            if land % 4 != 0 || land != before {
                coasts.push(interval);
            }
            before = land;
        }
        coasts
    }

    /// Returns the distance of a point from the coast, in units; negative at sea. Points outside the domain have the
    /// value of its border.
    #[inline]
    pub fn height(&self, point: Vec2) -> f32 {
        let at = point / self.spacing;
        let ((column, x), (row, y)) = (lattice(at.x, self.columns), lattice(at.y, self.rows));
        let along = |row: usize| {
            let corners = &self.heights[row * self.columns + column..][..2];
            corners[0] * (1.0 - x) + corners[1] * x
        };
        along(row) * (1.0 - y) + along(row + 1) * y
    }

    /// Returns the gradient of the height, which points inland.
    #[inline]
    pub fn slope(&self, point: Vec2) -> Vec2 {
        let step = self.spacing;
        let rise = |axis: Vec2| self.height(point + axis * step) - self.height(point - axis * step);
        Vec2::new(rise(Vec2::X), rise(Vec2::Y)) / (2.0 * step)
    }
}

/// Returns the indices of the corners of a run.
fn corners_of_run(run: &Run, columns: usize) -> Range<usize> {
    let start = run.row as usize * columns;
    start + run.start as usize..start + run.end as usize
}

fn corner(i: usize, columns: usize, spacing: f32) -> Vec2 {
    Vec2::new((i % columns) as f32, (i / columns) as f32) * spacing
}

/// Returns the index of the lattice interval that contains a coordinate, and the position in it, in intervals.
#[inline]
fn lattice(x: f32, corners: usize) -> (usize, f32) {
    let x = x.max(0.0).min((corners - 1) as f32);
    let index = (x as usize).min(corners - 2);
    (index, x - index as f32)
}

/// The nearest piece of coast of each corner, known beside the coast and passed on from corner to corner, as in a
/// distance transform (Danielsson 1980).
struct Nearest {
    coast: Vec<Side>,
    piece: Vec<u32>,
    squared: Vec<f32>,
    columns: usize,
    spacing: f32,
}

impl Nearest {
    fn of(coast: &[Piece], lattice: &CoastDistance) -> Self {
        let &CoastDistance { columns, rows, spacing, .. } = lattice;
        let squared = vec![FARTHEST * FARTHEST; columns * rows];
        let sides = coast.iter().map(|&[from, to]| Side::between(from, to)).collect();
        let mut this = Self { coast: sides, piece: vec![u32::MAX; columns * rows], squared, columns, spacing };
        for (piece, [from, to]) in (0..).zip(coast) {
            for (column, row) in walk(*from / spacing, *to / spacing) {
                for (column, row) in [(column, row), (column + 1, row), (column, row + 1), (column + 1, row + 1)] {
                    if (0..columns as i32).contains(&column) && (0..rows as i32).contains(&row) {
                        this.propose(column as usize, row as usize, piece);
                    }
                }
            }
        }
        for row in 0..rows {
            this.take_from_row(row, row.checked_sub(1));
        }
        for row in (0..rows).rev() {
            this.take_from_row(row, (row + 1 < rows).then_some(row + 1));
        }
        this
    }

    /// Lets each corner of a row take over a nearer piece from the neighbouring row and from its neighbours to the left
    /// and right.
    fn take_from_row(&mut self, row: usize, other: Option<usize>) {
        let (columns, spacing) = (self.columns, self.spacing);
        let other = other.map_or(Vec::new(), |other| self.piece[other * columns..][..columns].to_vec());
        let places = row * columns..(row + 1) * columns;
        let (coast, y) = (&self.coast[..], row as f32 * spacing);
        let (pieces, squares) = (&mut self.piece[places.clone()], &mut self.squared[places]);
        let mut measured = 0;
        let mut propose = |column: usize, here: &mut (u32, f32), piece: u32| {
            measured += propose(coast, Vec2::new(column as f32 * spacing, y), here, piece);
        };
        let mut west = u32::MAX;
        for (column, (piece, squared)) in pieces.iter_mut().zip(squares.iter_mut()).enumerate() {
            let mut here = (*piece, *squared);
            if let Some(&middle) = other.get(column) {
                let beside = [column.saturating_sub(1), (column + 1).min(columns - 1)].map(|beside| other[beside]);
                propose(column, &mut here, beside[0]);
                // Neighbours often have the same piece.
                if middle != beside[0] {
                    propose(column, &mut here, middle);
                }
                if beside[1] != middle {
                    propose(column, &mut here, beside[1]);
                }
            }
            propose(column, &mut here, west);
            (*piece, *squared) = here;
            west = here.0;
        }
        let mut east = u32::MAX;
        for (column, (piece, squared)) in pieces.iter_mut().zip(squares.iter_mut()).enumerate().rev() {
            let mut here = (*piece, *squared);
            propose(column, &mut here, east);
            (*piece, *squared) = here;
            east = here.0;
        }
        work::count(measured);
    }

    /// Lets a corner take over a piece of coast if that is nearer than its own.
    fn propose(&mut self, column: usize, row: usize, piece: u32) {
        let i = row * self.columns + column;
        let mut here = (self.piece[i], self.squared[i]);
        let corner = Vec2::new(column as f32, row as f32) * self.spacing;
        work::count(propose(&self.coast, corner, &mut here, piece));
        (self.piece[i], self.squared[i]) = here;
    }
}

/// Replaces the nearest piece of coast of a corner, with its squared distance, by another piece if that is nearer. Returns the
/// number of distances that were measured.
#[inline]
fn propose(coast: &[Side], corner: Vec2, here: &mut (u32, f32), piece: u32) -> usize {
    let Some(side) = coast.get(piece as usize).filter(|_| piece != here.0) else { return 0 };
    let squared = side.squared_distance(corner);
    if squared < here.1 {
        *here = (piece, squared);
    }
    1
}

/// A straight piece of coast, prepared for distances from it.
struct Side {
    from: Vec2,
    along: Vec2,
    /// One over the square of the length; 0 if that is 0.
    shortness: f32,
}

impl Side {
    fn between(from: Vec2, to: Vec2) -> Self {
        let along = to - from;
        let squared = along.length_squared();
        Self { from, along, shortness: if squared > 0.0 { 1.0 / squared } else { 0.0 } }
    }

    #[inline]
    fn squared_distance(&self, point: Vec2) -> f32 {
        let off = point - self.from;
        let t = fast_min(fast_max(off.dot(self.along) * self.shortness, 0.0), 1.0);
        (off - self.along * t).length_squared()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Seed;

    #[test]
    fn slivers_of_water_are_filled_and_ponds_stay() {
        let size = Vec2::splat(80.0);
        let heights = |depth: f32| (0..144).map(|i| if i == 78 { -depth } else { 6.0 }).collect();
        let filled = |depth: f32| CoastDistance::of_heights(size, 8.0, heights(depth)).unwrap().without_slivers();
        assert_eq!([0.2, 1.9, 2.1].map(|depth| filled(depth).regions(Cell::Water).len()), [0, 0, 1]);
    }

    #[test]
    fn height_is_the_distance_from_the_coast() {
        let domain = Domain::with_aspect(1.3);
        let centre = domain.size / 2.0;
        // A round island, defined by its height and by its coast.
        let cone = |point: Vec2| -(point - centre).length();
        let by_height = CoastDistance::with_sea(&domain, CoastDistance::SPACING, 0.6, &cone).settled();
        let radius = (0.4e6 / std::f32::consts::PI).sqrt();
        let at = |i: usize| {
            let angle = i as f32 / 200.0 * std::f32::consts::TAU;
            centre + Vec2::new(libm::cosf(angle), libm::sinf(angle)) * radius
        };
        let coast: Vec<Piece> = (0..200).map(|i| [at(i), at(i + 1)]).collect();
        let is_land: Vec<bool> =
            (0..by_height.heights.len()).map(|i| (by_height.corner(i) - centre).length() < radius).collect();
        let by_coast = CoastDistance::of_coast(&domain, CoastDistance::SPACING, &coast, &is_land);
        for i in 0..=1000 {
            let point = domain.size * Vec2::new(i as f32 / 1000.0, (i * 7 % 1000) as f32 / 1000.0);
            let exact = radius - (point - centre).length();
            if exact > radius - 2.0 * CoastDistance::SPACING {
                continue; // bilinear, the very peak is rounded
            }
            // The level of the sea is accurate to one corner's share of the domain.
            for (coast_distance, tolerance) in [(&by_height, 5.0), (&by_coast, 1.5)] {
                assert!(
                    (coast_distance.height(point) - exact).abs() < tolerance,
                    "{point}: {} is not {exact}",
                    coast_distance.height(point)
                );
            }
        }
    }

    #[test]
    fn handed_on_distances_are_those_of_a_search() {
        let mut chance = Seed::from_text("coast").stream(crate::base::random::Purpose::Land);
        let domain = Domain::with_aspect(1.0);
        let mut point = || Vec2::new(chance.unit(), chance.unit()) * domain.size;
        let mut piece = || {
            let (from, toward) = (point(), point());
            [from, from.lerp(toward, 0.05)]
        };
        let coast: Vec<Piece> = (0..40).map(|_| piece()).collect();
        let (columns, rows) = CoastDistance::corners(&domain, CoastDistance::SPACING);
        let coast_distance =
            CoastDistance::of_coast(&domain, CoastDistance::SPACING, &coast, &vec![true; columns * rows]);
        let mut far_off = 0;
        for (i, height) in coast_distance.heights.iter().enumerate() {
            let exact =
                coast.iter().map(|&[from, to]| Side::between(from, to).squared_distance(coast_distance.corner(i)));
            let exact = exact.fold(f32::INFINITY, f32::min).sqrt();
            assert!(height - exact > -0.01 && height - exact < 2.0, "{height} is not {exact}");
            far_off += u32::from(height - exact > 0.01);
        }
        assert!(far_off < 100, "{far_off} corners are not exact");
    }
}
