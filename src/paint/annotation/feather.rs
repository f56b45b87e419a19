//! A soft brush: full near the lines it is drawn along, and fading to nothing farther out, as the paper around letters of good maps is.

use glam::Vec2;

use super::super::coverage::Rect;
use crate::base::geometry::{fast_max, fast_min};

/// A mask that is drawn on with a soft brush.
pub(super) struct Feather {
    /// The coverage of each pixel, in 255ths, row by row.
    pub mask: Vec<u8>,
    pub width: u32,
    pub height: u32,
    /// The squared distance from which on lines that are drawn together give each pixel of some rectangle no more coverage than it has.
    reach: Vec<f32>,
}

impl Feather {
    /// Makes an empty mask.
    pub fn new(width: u32, height: u32) -> Self {
        Self { mask: vec![0; width as usize * height as usize], width, height, reach: Vec::new() }
    }

    /// Draws along straight lines: full as far as `full` pixels from each, and nothing beyond `end` pixels. A pixel has the coverage of the
    /// line that covers it most.
    pub fn strokes(&mut self, lines: &[[Vec2; 2]], full: f32, end: f32) {
        let rect =
            |[from, to]: [Vec2; 2]| Rect::between([from.min(to) - end, from.max(to) + end], self.width, self.height);
        let Some(all) = lines.iter().filter_map(|line| rect(*line)).reduce(Rect::union) else { return };
        let columns = (all.right - all.left) as usize;
        self.reach.clear();
        self.reach.resize(columns * (all.bottom - all.top) as usize, end * end);
        for &line in lines {
            let Some(Rect { left, top, right, bottom }) = rect(line) else { continue };
            for y in top..bottom {
                let (row, first) = ((y * self.width) as usize, (y - all.top) as usize * columns);
                let pixels = &mut self.mask[row + left as usize..row + right as usize];
                let reaches = &mut self.reach[first + (left - all.left) as usize..first + (right - all.left) as usize];
                stroke_row([left, y], line, [full, end], pixels.iter_mut().zip(reaches));
            }
        }
    }
}

/// Draws along a line on pixels of a row, the first of which has this column and row, with their reaches.
fn stroke_row<'a>(
    [left, y]: [u32; 2],
    [from, to]: [Vec2; 2],
    [full, end]: [f32; 2],
    pixels: impl Iterator<Item = (&'a mut u8, &'a mut f32)>,
) {
    /// Where a line is farther away than another by more than this factor, it covers no more, however either coverage is rounded.
    const ROUNDING: f32 = 1.0 + 1.0 / 65_536.0;
    let along = to - from;
    let squared = along.length_squared();
    let per_squared = if squared > 0.0 { 1.0 / squared } else { 0.0 };
    for (x, (pixel, reach)) in (left..).zip(pixels) {
        let off = Vec2::new(x as f32, y as f32) + 0.5 - from;
        let nearest = along * fast_max(fast_min(off.dot(along) * per_squared, 1.0), 0.0);
        let squared_distance = (off - nearest).length_squared();
        if squared_distance < *reach {
            *reach = fast_min(squared_distance * ROUNDING, *reach);
            let share = fast_min((end - squared_distance.sqrt()) / (end - full), 1.0);
            // Smooth at both ends (Hermite).
            let coverage = (share * share * (3.0 - 2.0 * share) * 255.0 + 0.5) as u8;
            *pixel = (*pixel).max(coverage);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_is_full_near_the_line_and_falls_to_nothing() {
        let mut feather = Feather::new(60, 40);
        feather.strokes(&[[Vec2::new(10.5, 20.5), Vec2::new(40.5, 20.5)]], 2.0, 8.0);
        let column: Vec<u8> = (20..36).map(|row| feather.mask[row * 60 + 25]).collect();
        assert!(
            column[..3].iter().all(|&coverage| coverage == 255) && column[8..].iter().all(|&coverage| coverage == 0)
        );
        assert!(column[2..9].is_sorted_by(|a, b| a > b), "{column:?}");
        // Round at its ends, and the same on both sides.
        assert_eq!(feather.mask[20 * 60 + 45], column[5]);
        assert!((1..8).all(|off| feather.mask[(20 - off) * 60 + 25] == column[off]));
    }

    #[test]
    fn strokes_outside_the_mask_are_cut_off() {
        let mut feather = Feather::new(3, 3);
        let beyond = [Vec2::new(-90.0, -90.0), Vec2::new(-80.0, -80.0)];
        feather.strokes(&[beyond, [Vec2::new(f32::NAN, 0.0), Vec2::ONE], [Vec2::new(1.5, 1.5); 2]], 1.0, 3.0);
        assert_eq!(feather.mask[4], 255);
    }

    #[test]
    fn lines_together_cover_as_the_one_does_that_covers_most() {
        let corner = |i: u32| Vec2::new(20.0 + (i * 7 % 23) as f32, 12.0 + (i * 5 % 17) as f32);
        let lines: Vec<[Vec2; 2]> = (0..12).map(|i| [corner(i), corner(i + 1)]).collect();
        let drawn = |lines: &[[Vec2; 2]]| {
            let mut feather = Feather::new(60, 40);
            feather.strokes(lines, 1.3, 6.1);
            feather.mask
        };
        let alone = lines.iter().map(|line| drawn(&[*line]));
        let most = |a: Vec<u8>, b: Vec<u8>| a.iter().zip(&b).map(|(a, b)| *a.max(b)).collect();
        assert_eq!(Some(drawn(&lines)), alone.reduce(most));
    }
}
