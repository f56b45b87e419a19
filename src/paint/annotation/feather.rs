//! A soft brush: full near the lines it is drawn along, and fading to nothing farther out, as the paper around letters of good maps is.

use glam::Vec2;

use super::super::coverage::Rect;

/// A mask that is drawn on with a soft brush.
pub(super) struct Feather {
    /// The coverage of each pixel, in 255ths, row by row.
    pub mask: Vec<u8>,
    pub width: u32,
    pub height: u32,
}

impl Feather {
    /// Draws along a straight line: full as far as `full` pixels from it, and nothing beyond `end` pixels. A pixel has the coverage of the
    /// stroke that covers it most.
    pub fn stroke(&mut self, [from, to]: [Vec2; 2], full: f32, end: f32) {
        let corners = [from.min(to) - end, from.max(to) + end];
        let Some(Rect { left, top, right, bottom }) = Rect::between(corners, self.width, self.height) else { return };
        let along = to - from;
        let squared = along.length_squared();
        let per_squared = if squared > 0.0 { 1.0 / squared } else { 0.0 };
        for y in top..bottom {
            let start = (y * self.width) as usize;
            for (x, pixel) in (left..right).zip(&mut self.mask[start + left as usize..start + right as usize]) {
                let off = Vec2::new(x as f32, y as f32) + 0.5 - from;
                let nearest = along * (off.dot(along) * per_squared).clamp(0.0, 1.0);
                let squared_distance = (off - nearest).length_squared();
                if squared_distance < end * end {
                    let share = ((end - squared_distance.sqrt()) / (end - full)).min(1.0);
                    // Smooth at both ends (Hermite).
                    let coverage = (share * share * (3.0 - 2.0 * share) * 255.0 + 0.5) as u8;
                    *pixel = (*pixel).max(coverage);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_is_full_near_the_line_and_falls_to_nothing() {
        let mut feather = Feather { mask: vec![0; 60 * 40], width: 60, height: 40 };
        feather.stroke([Vec2::new(10.5, 20.5), Vec2::new(40.5, 20.5)], 2.0, 8.0);
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
        let mut feather = Feather { mask: vec![0; 9], width: 3, height: 3 };
        feather.stroke([Vec2::new(-90.0, -90.0), Vec2::new(-80.0, -80.0)], 1.0, 3.0);
        feather.stroke([Vec2::new(f32::NAN, 0.0), Vec2::new(1.0, 1.0)], 1.0, 3.0);
        feather.stroke([Vec2::new(1.5, 1.5); 2], 1.0, 3.0);
        assert_eq!(feather.mask[4], 255);
    }
}
