//! Coast distances for pictures: without facets, and smoother far from any coast.
//!
//! The heights of the corners are the control points of a surface of parabolas (a biquadratic B-spline). Such a surface
//! smooths its input. Near a coast heights are therefore sharpened first, because the coast must stay where rivers end.
//! Far from any coast they are blurred, because a distance has a crease wherever two coasts are equally near.

use glam::Vec2;

use super::CoastDistance;
use crate::base::geometry::fast_min;

/// Control points of the heights, in units: positive on land, negative at sea.
#[derive(Clone, Debug)]
pub struct SmoothedDistance {
    heights: Vec<f32>,
    columns: usize,
    rows: usize,
    /// The distance between control points, in units.
    spacing: f32,
    /// The number of columns, and of rows, before those of the domain.
    margin: usize,
}

/// The greatest stride of a smoothing pass, in units.
const FARTHEST_STRIDE: f32 = 32.0;

impl SmoothedDistance {
    /// Smooths coast distances, for pictures.
    pub fn of(coast_distance: &CoastDistance) -> Self {
        let (columns, rows) = coast_distance.size();
        let spacing = coast_distance.spacing();
        let mut this = Self { heights: coast_distance.heights().to_vec(), columns, rows, spacing, margin: 0 };
        let most = (FARTHEST_STRIDE / spacing) as usize;
        std::iter::successors(Some(1), |stride| Some(2 * stride))
            .take_while(|stride| *stride <= most)
            .for_each(|stride| this.soften(stride));
        this
    }

    /// Extends the field beyond the domain by a number of units. Beyond the sea, distances grow with the distance from
    /// the border; land stays as it is.
    #[must_use]
    pub(crate) fn widened(&self, units: f32) -> Self {
        let margin = (units / self.spacing) as usize;
        let (columns, rows) = (self.columns + 2 * margin, self.rows + 2 * margin);
        let height = |i: usize| {
            let (at, last) = ([i % columns, i / columns], [self.columns - 1, self.rows - 1]);
            let inside = [0, 1].map(|axis| at[axis].saturating_sub(margin).min(last[axis]));
            let beyond = [0, 1].map(|axis| at[axis].abs_diff(inside[axis] + margin) as f32 * self.spacing);
            let height = self.heights[inside[1] * self.columns + inside[0]];
            if height < 0.0 { height - Vec2::from(beyond).length() } else { height }
        };
        Self { heights: (0..columns * rows).map(height).collect(), columns, rows, margin, spacing: self.spacing }
    }

    /// Moves each corner towards the mean of those a stride to the west, east, north and south: halfway if the coast is
    /// far away compared with the stride, not at all if it is near. Next to the coast, moves it away from the mean.
    fn soften(&mut self, stride: usize) {
        /// The share of a move away from the mean that undoes nearly all the smoothing of the surface.
        const SHARPEN: f32 = -0.25;
        let least = if stride == 1 { SHARPEN } else { 0.0 };
        let per_far = 1.0 / (4.0 * self.spacing * stride as f32);
        let soft = |height: f32, one: f32, other: f32| {
            let mean = (one + other) * 0.5;
            height + (mean - height) * (height.abs() * per_far + SHARPEN).clamp(least, 0.5)
        };
        let (columns, rows) = (self.columns, self.rows);
        // At the border the stride is as long as there is room for on both sides.
        let reach = |place: usize, length: usize| stride.min(place).min(length - 1 - place);
        let before = self.heights.clone();
        for (heights, before) in self.heights.chunks_mut(columns).zip(before.chunks(columns)) {
            for (column, height) in heights.iter_mut().enumerate() {
                let reach = reach(column, columns);
                *height = soft(before[column], before[column - reach], before[column + reach]);
            }
        }
        let before = self.heights.clone();
        for (row, heights) in self.heights.chunks_mut(columns).enumerate() {
            let reach = reach(row, rows);
            let [north, here, south] = [row - reach, row, row + reach].map(|row| &before[row * columns..][..columns]);
            for (((height, here), north), south) in heights.iter_mut().zip(here).zip(north).zip(south) {
                *height = soft(*here, *north, *south);
            }
        }
    }

    /// Returns the same field with every place as low as the lowest that water reaches from it within a way in units, along
    /// rows and columns. Land is as low as the water beside it.
    #[must_use]
    pub(crate) fn lowered(&self, units: f32) -> Self {
        let (columns, rows) = ((1, self.columns), (self.columns, self.rows));
        let mut lowered = self.clone();
        // What may hand on how low it is.
        let is_water: Vec<bool> = self.heights.iter().map(|height| *height < 0.0).collect();
        for _ in 0..(units / self.spacing) as usize {
            for ((step, length), (aside, lines)) in [(columns, rows), (rows, columns)] {
                for line in 0..lines {
                    // The height of the place before, as it was, if it may hand it on.
                    let mut before = f32::MAX;
                    for i in (0..length).map(|place| line * aside + place * step) {
                        let here = lowered.heights[i];
                        let handed = |i: usize| is_water.get(i).is_some_and(|is_water| *is_water);
                        let after = if i + step < line * aside + length * step && handed(i + step) {
                            lowered.heights[i + step]
                        } else {
                            f32::MAX
                        };
                        lowered.heights[i] = fast_min(here, fast_min(before, after));
                        before = if is_water[i] { here } else { f32::MAX };
                    }
                }
            }
        }
        lowered
    }

    /// Returns the distance between control points, in units.
    pub(crate) fn spacing(&self) -> f32 {
        self.spacing
    }

    /// Returns the number of columns and rows of control points.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Returns the control point at a column and row.
    pub(super) fn control(&self, column: usize, row: usize) -> f32 {
        self.heights[row * self.columns + column]
    }

    /// Iterates over the three by three control points around a row and a column.
    pub(crate) fn around(&self, row: usize, column: usize) -> impl Iterator<Item = f32> + Clone {
        let columns = beside(column, self.columns);
        beside(row, self.rows)
            .into_iter()
            .flat_map(move |row| columns.map(|column| self.heights[row * self.columns + column]))
    }

    /// Returns the distance of a point from the coast, in units, and its gradient, which points inland.
    pub(crate) fn at(&self, point: Vec2) -> (f32, Vec2) {
        let ((column, along), (row, down)) =
            (self.column(point.x), nearest(point.y / self.spacing + self.margin as f32, self.rows));
        let columns = beside(column, self.columns);
        let rows = beside(row, self.rows)
            .map(|row| Parabola::of(columns.map(|column| self.heights[row * self.columns + column])));
        let heights = Parabola::of(rows.map(|row| row.at(along)));
        let east = Parabola::of(rows.map(|row| row.rise(along))).at(down);
        (heights.at(down), Vec2::new(east, heights.rise(down)) / self.spacing)
    }

    /// Evaluates the distances along one y.
    pub(crate) fn across(&self, y: f32) -> Across<'_> {
        let (row, t) = nearest(y / self.spacing + self.margin as f32, self.rows);
        let rows = beside(row, self.rows).map(|row| &self.heights[row * self.columns..][..self.columns]);
        let controls = rows[0].iter().zip(rows[1]).zip(rows[2]);
        let heights = controls.map(|((&north, &here), &south)| Parabola::of([north, here, south]).at(t)).collect();
        Across { row, t, rows, heights }
    }

    /// Returns the x, in units, of a place at a distance beyond a column, in intervals.
    pub(crate) fn x_of(&self, column: usize, beyond: f32) -> f32 {
        (column as f32 - self.margin as f32 + beyond) * self.spacing
    }

    /// Returns the nearest column to an x, and the distance beyond it in intervals, from -0.5 to 0.5.
    pub(crate) fn column(&self, x: f32) -> (usize, f32) {
        nearest(x / self.spacing + self.margin as f32, self.columns)
    }
}

/// The distances from the coast along one y.
pub(crate) struct Across<'a> {
    /// The nearest row of corners.
    pub row: usize,
    t: f32,
    rows: [&'a [f32]; 3],
    /// The control points of the heights.
    heights: Vec<f32>,
}

impl Across<'_> {
    /// Returns the control points of the heights around a column, in units.
    pub fn around(&self, column: usize) -> [f32; 3] {
        beside(column, self.heights.len()).map(|column| self.heights[column])
    }

    /// Returns the rise of the heights over an interval to the south, around a column.
    pub fn rise(&self, column: usize) -> Parabola {
        let rise = |column: usize| Parabola::of(self.rows.map(|row| row[column])).rise(self.t);
        Parabola::of(beside(column, self.heights.len()).map(rise))
    }
}

/// A piece of a B-spline around the middle of three control points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parabola([f32; 3]);

impl Parabola {
    #[inline]
    pub fn of([before, here, after]: [f32; 3]) -> Self {
        let mean = (before + after) * 0.5;
        Self([here + (mean - here) * 0.25, (after - before) * 0.5, mean - here])
    }

    /// Returns the value at a distance from the middle, in intervals.
    #[inline]
    pub fn at(self, t: f32) -> f32 {
        self.0[0] + t * (self.0[1] + t * self.0[2])
    }

    /// Returns the value at a place, its difference to the value a step farther, and the growth of that difference with
    /// each step.
    #[inline]
    pub fn steps(self, t: f32, step: f32) -> [f32; 3] {
        let bend = self.0[2] * step * step;
        [self.at(t), self.rise(t) * step + bend, bend * 2.0]
    }

    /// Returns the slope per interval at a distance from the middle, in intervals.
    #[inline]
    pub fn rise(self, t: f32) -> f32 {
        self.0[1] + 2.0 * t * self.0[2]
    }
}

/// Returns the index of the corner nearest to a coordinate, and the distance beyond it, both in intervals.
pub(crate) fn nearest(x: f32, corners: usize) -> (usize, f32) {
    // A conversion turns negative numbers into 0.
    let index = ((x + 0.5) as usize).min(corners - 1);
    (index, (x - index as f32).clamp(-0.5, 0.5))
}

/// Returns a corner with its two neighbours. At the border, the corner itself replaces the missing one.
pub(crate) fn beside(i: usize, corners: usize) -> [usize; 3] {
    [i.saturating_sub(1), i, (i + 1).min(corners - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::land::Land;
    use crate::lands::lands_with_a_coast;
    use crate::recipe::link;
    use glam::Vec2;
    use std::sync::Arc;

    fn lands() -> impl Iterator<Item = Arc<Land>> {
        let links = lands_with_a_coast().into_iter().flat_map(|land| {
            [0.0, 0.5, 1.0]
                .map(|roughness| format!("aspect=1.5&{land}&sea=0.5&roughness={roughness}&seed=k{roughness}"))
        });
        links.map(|link| Land::of(&link::read(&link).unwrap()).unwrap())
    }

    /// Returns the height of a point and its rise per unit to the east and to the south.
    fn at(shown: &SmoothedDistance, point: Vec2) -> (f32, Vec2) {
        let ((column, x), across) = (shown.column(point.x), shown.across(point.y));
        let heights = Parabola::of(across.around(column));
        (heights.at(x), Vec2::new(heights.rise(x), across.rise(column).at(x)) / shown.spacing())
    }

    #[test]
    fn coast_is_shown_where_growth_sees_it() {
        for land in lands() {
            let shown = SmoothedDistance::of(land.coast_distance());
            let (mut near, mut off) = (0, 0);
            for (column, row) in (0..land.columns()).flat_map(|c| (0..land.rows()).map(move |r| (c, r))) {
                let point = Vec2::new(column as f32 + 0.5, row as f32 + 0.5);
                let height = land.coast_distance().height(point);
                if height.abs() < 8.0 {
                    let is_off = (height > 0.0) != (at(&shown, point).0 > 0.0);
                    assert!(!is_off || height.abs() < 1.5, "{point}: {height} is shown as {}", at(&shown, point).0);
                    (near, off) = (near + 1, off + u32::from(is_off));
                }
            }
            // In a band of 16 units, less than half a unit on average.
            assert!(off * 40 < near, "{off} of {near}");
        }
    }

    #[test]
    fn water_is_as_low_as_the_lowest_that_it_reaches_and_land_hands_nothing_on() {
        // Two waters beside each other, with land between, and a deep place in one of them.
        let row = [-1.0, -1.0, -9.0, -1.0, -1.0, 2.0, -3.0];
        let field = SmoothedDistance { heights: row.repeat(2), columns: 7, rows: 2, spacing: 2.0, margin: 0 };
        let lowered = |units: f32| field.lowered(units).heights[..7].to_vec();
        assert_eq!(lowered(1.9), row);
        assert_eq!(lowered(2.0), [-1.0, -9.0, -9.0, -9.0, -1.0, -3.0, -3.0]);
        assert_eq!(lowered(40.0), [-9.0, -9.0, -9.0, -9.0, -9.0, -9.0, -3.0]);
    }

    #[test]
    fn surface_has_neither_steps_nor_facets() {
        for land in lands() {
            let shown = SmoothedDistance::of(land.coast_distance());
            for i in 0..4000 {
                // Across a border between two pieces, at an angle.
                let border = Vec2::new((i % 97) as f32 + 0.5, (i % 61) as f32 + 0.5) * shown.spacing();
                let ((one, rise), (other, rise_there)) = (at(&shown, border - 0.01), at(&shown, border + 0.01));
                assert!((one - other).abs() < 0.1, "{border}: {one}, {other}");
                assert!(rise.distance(rise_there) < 0.02, "{border}: {rise}, {rise_there}");
            }
        }
    }

    #[test]
    fn far_from_coasts_creases_are_gone() {
        let sharpest = |land: &Land, height: &dyn Fn(Vec2) -> f32| {
            let inside = (4..90).flat_map(|column| (4..90).map(move |row| Vec2::new(column as f32, row as f32)));
            let far = inside
                .map(|at| at * CoastDistance::SPACING)
                .filter(|at| land.coast_distance().height(*at).abs() > 60.0);
            let bend = |at: Vec2| height(at - Vec2::X * 8.0) - 2.0 * height(at) + height(at + Vec2::X * 8.0);
            far.map(|at| bend(at).abs()).fold(0.0, f32::max)
        };
        for land in lands() {
            let shown = SmoothedDistance::of(land.coast_distance());
            let before = sharpest(&land, &|point| land.coast_distance().height(point));
            let after = sharpest(&land, &|point| at(&shown, point).0);
            assert!(after < 0.4 * before.max(5.0), "{after} of {before}");
        }
    }
}
