//! The filling of contours: the share of each pixel that lies within them, by signed area.
//!
//! Each straight piece is cut at the sides of pixels. The area to its right in its own pixel is added to that pixel, and the area in all
//! pixels further right to the next one; sums along a row are then areas. It takes the four operations of arithmetic alone, so the bits are
//! the same everywhere.

use glam::Vec2;

use super::table::{Curve, Glyph};

/// Contours to be filled, in a rectangle of pixels.
#[derive(Clone, Debug, Default)]
pub struct Fill {
    /// The first column and the first row of the rectangle.
    corner: [i32; 2],
    width: usize,
    /// Areas, row by row. A row has one more than it has pixels, for what lies right of all.
    areas: Vec<f32>,
}

/// The greatest distance of straight pieces from the curve that they stand for, in pixels.
const TOLERANCE: f32 = 0.04;
const MOST_PIECES: u32 = 12;

impl Fill {
    /// Begins with nothing in a rectangle: its first column and row, how many columns and rows; one at least.
    pub fn clear(&mut self, corner: [i32; 2], width: usize, height: usize) {
        let width = width.max(1);
        (self.corner, self.width) = (corner, width);
        self.areas.clear();
        self.areas.resize((width + 1) * height, 0.0);
    }

    /// Adds a letter whose points are where `place` puts them, in pixels.
    pub fn add(&mut self, glyph: &Glyph, place: impl Fn(Vec2) -> Vec2) {
        let corner = Vec2::new(self.corner[0] as f32, self.corner[1] as f32);
        let place = |at: Vec2| place(at) - corner;
        for (start, curves) in &glyph.contours {
            flatten(place(*start), curves, place, TOLERANCE, |from, to| self.piece(from, to));
        }
    }

    /// Adds what lies between a line of curves whose points are in pixels and the straight way from its end to its start.
    pub fn add_line(&mut self, start: Vec2, curves: &[Curve], place: impl Fn(Vec2) -> Vec2) {
        let corner = Vec2::new(self.corner[0] as f32, self.corner[1] as f32);
        let place = |at: Vec2| place(at) - corner;
        let mut end = place(start);
        flatten(end, curves, place, TOLERANCE, |from, to| {
            self.piece(from, to);
            end = to;
        });
        self.piece(end, place(start));
    }

    /// Returns the rows of the rectangle: for each pixel the share of it that is filled, from 0 to 1.
    pub fn rows(&self) -> impl Iterator<Item = impl Iterator<Item = f32>> {
        let sum = |sum: &mut f32, area: &f32| {
            *sum += area;
            let filled = if *sum < 0.0 { -*sum } else { *sum };
            Some(if filled > 1.0 { 1.0 } else { filled })
        };
        self.areas.chunks_exact(self.width + 1).map(move |areas| areas[..self.width].iter().scan(0.0, sum))
    }

    /// Adds a straight piece, cut at the borders of rows.
    fn piece(&mut self, from: Vec2, to: Vec2) {
        let (top, bottom, sign) = if from.y < to.y { (from, to, 1.0) } else { (to, from, -1.0) };
        let height = bottom.y - top.y;
        let rows = self.areas.len() / (self.width + 1);
        if height <= 0.0 || bottom.y <= 0.0 || top.y >= rows as f32 {
            return;
        }
        let x_at = |y: f32| top.x + (bottom.x - top.x) * ((y - top.y) / height);
        // A conversion makes 0 of what is below.
        let last = ((bottom.y as usize) + 1).min(rows);
        for row in (top.y as usize)..last {
            let (above, below) = (larger(top.y, row as f32), smaller(bottom.y, (row + 1) as f32));
            if above < below {
                self.in_row(row, x_at(above), x_at(below), sign * (below - above));
            }
        }
    }

    /// Adds a piece within one row, from one x to another, which goes down by `down`.
    fn in_row(&mut self, row: usize, a: f32, b: f32, down: f32) {
        let width = self.width as f32;
        let row = &mut self.areas[row * (self.width + 1)..][..self.width + 1];
        let (left, right) = (smaller(a, b), larger(a, b));
        if right <= 0.0 {
            row[0] += down;
            return;
        }
        if left >= width {
            return;
        }
        if right - left < 1e-4 {
            return in_column(row, larger(left, 0.0), smaller(right, width), down);
        }
        let per_x = down / (right - left);
        if left < 0.0 {
            row[0] += per_x * -left;
        }
        let (left, right) = (larger(left, 0.0), smaller(right, width));
        for column in left as usize..(right as usize + 1).min(self.width) {
            let (from, to) = (larger(left, column as f32), smaller(right, (column + 1) as f32));
            if from < to {
                in_column(row, from, to, per_x * (to - from));
            }
        }
    }
}

/// Adds a piece within one pixel of a row, with ends at these x.
fn in_column(row: &mut [f32], from: f32, to: f32, down: f32) {
    let column = (from as usize).min(row.len() - 2);
    let from_left = (from + to) * 0.5 - column as f32;
    row[column] += down * (1.0 - from_left);
    row[column + 1] += down * from_left;
}

/// Hands out the straight pieces of curves whose points are where `place` puts them: as many as keep them within a tolerance.
fn flatten(
    start: Vec2,
    curves: &[Curve],
    place: impl Fn(Vec2) -> Vec2,
    tolerance: f32,
    mut piece: impl FnMut(Vec2, Vec2),
) {
    let mut from = start;
    for curve in curves {
        let [control, end] = curve.map(&place);
        // A parabola and n equal chords lie at most |second difference| / 4n² apart.
        let second_difference = from - control * 2.0 + end;
        let sagitta = second_difference.length_squared().sqrt() * 0.25;
        let pieces = ((sagitta / tolerance).sqrt() as u32 + 1).min(MOST_PIECES);
        let begin = from;
        for i in 1..=pieces {
            let t = i as f32 / pieces as f32;
            let to = if i == pieces {
                end
            } else {
                begin * ((1.0 - t) * (1.0 - t)) + control * (2.0 * t * (1.0 - t)) + end * (t * t)
            };
            piece(from, to);
            from = to;
        }
    }
}

/// Hands out the straight pieces of a line of curves, likewise.
pub fn pieces_of(
    start: Vec2,
    curves: &[Curve],
    place: impl Fn(Vec2) -> Vec2,
    tolerance: f32,
    piece: impl FnMut(Vec2, Vec2),
) {
    flatten(place(start), curves, place, tolerance, piece);
}

impl Glyph {
    /// Hands out its outline as straight pieces, whose points are where `place` puts them: as many as keep within a tolerance.
    pub fn outline(&self, place: impl Fn(Vec2) -> Vec2, tolerance: f32, mut piece: impl FnMut(Vec2, Vec2)) {
        for (start, curves) in &self.contours {
            flatten(place(*start), curves, &place, tolerance, &mut piece);
        }
    }
}

fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::glyph::{Face, Typeface};
    use crate::property::cases;
    use proptest::prelude::*;

    /// Makes a glyph of straight contours.
    fn polygons(contours: &[Vec<Vec2>]) -> Glyph {
        let closed = |points: &Vec<Vec2>| {
            let ends = points.iter().zip(points.iter().cycle().skip(1));
            (points[0], ends.map(|(a, b)| [(*a + *b) * 0.5, *b]).collect())
        };
        let contours = contours.iter().map(closed).collect();
        Glyph { code: 0, base: 0, advance: 0.0, contours, least: Vec2::ZERO, most: Vec2::ZERO }
    }

    fn filled(glyph: &Glyph, width: usize, height: usize, place: impl Fn(Vec2) -> Vec2) -> Vec<Vec<f32>> {
        let mut fill = Fill::default();
        fill.clear([0, 0], width, height);
        fill.add(glyph, place);
        fill.rows().map(Iterator::collect).collect()
    }

    fn square(left: f32, top: f32, side: f32) -> Vec<Vec2> {
        [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|at| Vec2::from(at) + Vec2::new(left, top)).to_vec()
    }

    #[test]
    fn a_square_fills_what_it_covers_exactly() {
        let rows = filled(&polygons(&[square(1.5, 1.25, 2.0)]), 5, 5, |at| at);
        let across = [0.0, 0.5, 1.0, 0.5, 0.0];
        let down = [0.0, 0.75, 1.0, 0.25, 0.0];
        for (row, down) in rows.iter().zip(down) {
            assert_eq!(*row, across.map(|across| across * down));
        }
    }

    #[test]
    fn a_hole_is_left_bare_and_nothing_fills_nothing() {
        let hole: Vec<Vec2> = square(2.0, 2.0, 2.0).into_iter().rev().collect();
        let rows = filled(&polygons(&[square(0.0, 0.0, 6.0), hole]), 6, 6, |at| at);
        let total: f32 = rows.iter().flatten().sum();
        assert_eq!((rows[3][3], rows[0][0], total), (0.0, 1.0, 32.0));
        assert!(filled(&polygons(&[]), 6, 6, |at| at).iter().flatten().all(|&share| share == 0.0));
        let space = Typeface::of(Face::Italic).glyph(' '.into()).unwrap();
        assert!(filled(space, 6, 6, |at| at * 6.0).iter().flatten().all(|&share| share == 0.0));
    }

    /// Returns the share of a pixel's samples that a line winds round, by asking each sample about each side.
    fn sampled(contours: &[Vec<Vec2>], x: usize, y: usize) -> f32 {
        const SAMPLES: usize = 16;
        let is_inside = |at: Vec2| {
            let mut winding = 0;
            for contour in contours {
                for (a, b) in contour.iter().zip(contour.iter().cycle().skip(1)) {
                    let side = (*b - *a).perp_dot(at - *a);
                    winding += i32::from(a.y <= at.y && b.y > at.y && side > 0.0);
                    winding -= i32::from(b.y <= at.y && a.y > at.y && side < 0.0);
                }
            }
            winding != 0
        };
        let part = |i: usize| (i as f32 + 0.5) / SAMPLES as f32;
        let samples =
            (0..SAMPLES * SAMPLES).map(|i| Vec2::new(x as f32 + part(i % SAMPLES), y as f32 + part(i / SAMPLES)));
        samples.filter(|at| is_inside(*at)).count() as f32 / (SAMPLES * SAMPLES) as f32
    }

    fn assert_like_sampled(rows: &[Vec<f32>], contours: &[Vec<Vec2>]) {
        for (y, row) in rows.iter().enumerate() {
            for (x, share) in row.iter().enumerate() {
                let sampled = sampled(contours, x, y);
                assert!((share - sampled).abs() < 0.1, "{share} and not {sampled} of ({x}, {y})");
            }
        }
    }

    proptest! {
        #![proptest_config(cases(24))]

        #[test]
        fn a_triangle_fills_what_its_twin_counts(points in prop::array::uniform3((-4.0f32..14.0, -4.0f32..14.0))) {
            let contours = [points.map(Vec2::from).to_vec()];
            assert_like_sampled(&filled(&polygons(&contours), 10, 9, |at| at), &contours);
        }

        #[test]
        fn a_letter_fills_what_its_twin_counts(letter in prop::sample::select(vec!['g', 'R', 'o', 'é', 'W', '8']), turn in 0usize..8) {
            // Turned by any of eight rotations, without rounding.
            let (x, y) = [(1.0, 0.0), (0.6, 0.8), (0.0, 1.0), (-0.8, 0.6), (-1.0, 0.0), (-0.6, -0.8), (0.0, -1.0), (0.8, -0.6)][turn];
            let along = Vec2::new(x, y) * 12.0;
            let place = |at: Vec2| along * (at.x - 0.3) + along.perp() * (at.y + 0.2) + Vec2::splat(9.0);
            let glyph = Typeface::of(Face::Italic).glyph(letter.into()).unwrap();
            let mut contours: Vec<Vec<Vec2>> = Vec::new();
            for (start, curves) in &glyph.contours {
                contours.push(vec![]);
                let last = contours.len() - 1;
                flatten(place(*start), curves, place, 1e-4, |_, to| contours[last].push(to));
            }
            assert_like_sampled(&filled(glyph, 18, 18, place), &contours);
        }
    }
}
