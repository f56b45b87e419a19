//! A grid index that finds points by their place.

use glam::Vec2;

use crate::base::sort;
use crate::base::work;

/// An index of points.
#[derive(Debug)]
pub(crate) struct Index {
    corner: Vec2,
    side: f32,
    columns: usize,
    rows: usize,
    /// The position in `order` at which each cell begins.
    starts: Vec<usize>,
    /// The numbers of the points, cell by cell.
    order: Vec<usize>,
}

impl Index {
    /// Puts points into cells of about this side.
    pub fn new(points: &[Vec2], side: f32) -> Self {
        /// The most cells along each side.
        const MOST: f32 = 1000.0;
        let corner = points.iter().copied().reduce(Vec2::min).unwrap_or_default();
        let size = points.iter().copied().reduce(Vec2::max).unwrap_or_default() - corner;
        let side = side.max(size.max_element() / MOST).max(f32::MIN_POSITIVE);
        let [columns, rows] = [size.x, size.y].map(|length| (length / side) as usize + 1);
        let mut this = Self { corner, side, columns, rows, starts: vec![0; columns * rows + 1], order: Vec::new() };
        let cells: Vec<u32> = points.iter().map(|&point| this.cell(point) as u32).collect();
        cells.iter().for_each(|&cell| this.starts[cell as usize + 1] += 1);
        (1..this.starts.len()).for_each(|i| this.starts[i] += this.starts[i - 1]);
        this.order = sort::argsort(cells);
        this
    }

    /// Returns the numbers of all points within a radius of a place, and of some a little farther away.
    #[inline(never)] // each copy of the search weighs half a kilobyte
    pub fn around(&self, at: Vec2, radius: f32) -> std::vec::IntoIter<usize> {
        let ((left, top), (right, bottom)) = (self.place(at - radius), self.place(at + radius));
        let mut found = Vec::new();
        for row in (top..=bottom).map(|row| row * self.columns) {
            let run = self.starts[row + left]..self.starts[row + right + 1];
            work::count(1 + run.len());
            found.extend_from_slice(&self.order[run]);
        }
        found.into_iter()
    }

    fn cell(&self, at: Vec2) -> usize {
        let (column, row) = self.place(at);
        row * self.columns + column
    }

    fn place(&self, at: Vec2) -> (usize, usize) {
        let cell = (at - self.corner) / self.side;
        ((cell.x as usize).min(self.columns - 1), (cell.y as usize).min(self.rows - 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<Vec2>> {
        proptest::collection::vec((-50f32..50.0, -50f32..50.0).prop_map(Vec2::from), 1..80)
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn all_points_within_the_radius_are_found_and_each_once(points in points(), side in 0.0f32..60.0, radius in 0.0f32..60.0) {
            let index = Index::new(&points, side);
            for &at in &points {
                let mut found: Vec<usize> = index.around(at, radius).collect();
                found.sort_unstable();
                let is_near = |i: &usize| at.distance(points[*i]) <= radius;
                prop_assert!(found.windows(2).all(|pair| pair[0] < pair[1]));
                let near: Vec<usize> = (0..points.len()).filter(is_near).collect();
                prop_assert_eq!(found.into_iter().filter(is_near).collect::<Vec<_>>(), near);
            }
        }
    }
}
