//! Strokes of pens, put together by their widths: those that are as wide and as dark as each other are one path.

use super::hidden::Parabola;
use super::path::Path;
use super::text::Text;

/// The paths of strokes with each width.
#[derive(Debug, Default)]
pub(super) struct Pens {
    /// For each width, counted in steps, the path of full strokes and that of faint ones.
    paths: Vec<[Path; 2]>,
}

/// The steps of widths, in hundredths of a unit: more than are told apart.
const STEP: f32 = 5.0;

impl Pens {
    /// Returns `true` if nothing has been drawn.
    pub fn is_empty(&self) -> bool {
        self.paths.is_empty()
    }

    /// Draws a curve with half of its width. If it begins where the last curve of its path ended, the two are one line.
    pub fn draw(&mut self, [from, control, to]: Parabola, half: f32, is_faint: bool) {
        let width = (200.0 * half / STEP + 0.5) as usize;
        if width >= self.paths.len() {
            self.paths.resize_with(width + 1, Default::default);
        }
        let path = &mut self.paths[width][usize::from(is_faint)];
        path.go_on(from);
        path.curve([control, to]);
    }

    /// Writes all paths, the full strokes over the faint ones, which have this strength.
    pub fn write(&self, out: &mut Text, strength: f32) {
        for (is_faint, strength) in [(true, strength), (false, 1.0)] {
            let paths = self.paths.iter().map(|paths| &paths[usize::from(is_faint)]);
            let mut paths = (0..).zip(paths).filter(|(_, path)| !path.is_empty()).peekable();
            if paths.peek().is_none() {
                continue;
            }
            out.text("<g stroke-opacity=\"").units(strength).text("\">");
            for (width, path) in paths {
                out.text("<path stroke-width=\"")
                    .hundredths(width * STEP as i32)
                    .text("\" d=\"")
                    .path(path)
                    .text("\"/>");
            }
            out.text("</g>\n");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    #[test]
    fn strokes_of_a_width_are_a_path_and_faint_ones_come_first() {
        let curve = |x: f32| [(x, 0.0), (x, 1.0), (x + 1.0, 0.0)].map(Vec2::from);
        let mut pens = Pens::default();
        assert!(pens.is_empty());
        pens.draw(curve(0.0), 0.25, false);
        pens.draw(curve(9.0), 0.25, true);
        pens.draw(curve(1.0), 0.26, false);
        pens.draw(curve(2.0), 0.4, false);
        let mut out = Text::default();
        pens.write(&mut out, 0.7);
        let expected = [
            "<g stroke-opacity=\"0.7\"><path stroke-width=\"0.5\" d=\"M9 0q0 1 1 0\"/></g>",
            "<g stroke-opacity=\"1\"><path stroke-width=\"0.5\" d=\"M0 0q0 1 1 0q0 1 1 0\"/><path stroke-width=\"0.8\" d=\"M2 0q0 1 1 0\"/></g>",
        ];
        assert_eq!(out.as_str().lines().collect::<Vec<_>>(), expected);
    }
}
