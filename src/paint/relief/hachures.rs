//! Hachures: rows of strokes down the slope. Each row begins at one height (Lehmann 1799), and steep land has denser
//! rows. As engravers shaded mountains, only the side away from the light has strokes.

use glam::Vec2;

use super::Sheet;
use super::field::Field;
use crate::paint::coverage::Coverage;
use crate::paint::ground::{draw, lay_mask, thinned};
use crate::paint::palette::Hachures;
use crate::paint::view::{Rows, View};
use crate::relief::Relief;

/// A stroke: three places with half its width at each, in units.
pub(crate) type Stroke = [(Vec2, f32); 3];

/// The number of rows between the sea and the highest land.
const ROWS: f32 = 14.0;

/// The number of times that heights are smoothed first.
const TIMES: u32 = 5;

/// The distance between strokes of a row, in units.
const APART: u32 = 3;

/// Finds the strokes of a relief. `highest` is the height of the highest land, in units.
pub(crate) fn strokes(relief: &Relief, highest: f32) -> Vec<Stroke> {
    let mut strokes = Strokes::new(relief, highest);
    while strokes.advance() {}
    strokes.drawn
}

/// The strokes of a relief, as far as its rows have been followed.
#[derive(Clone, Debug)]
pub(super) struct Strokes {
    /// The rows; `None` once all have been followed.
    rows: Option<HachureRows>,
    drawn: Vec<Stroke>,
}

impl Strokes {
    pub fn new(relief: &Relief, highest: f32) -> Self {
        let per_row = ROWS / highest;
        let field = Field::of(relief, |height| height * per_row).smoothed(TIMES);
        let rows = HachureRows { marks: vec![0; field.values.len()], field, cell: 0 };
        Self { rows: Some(rows), drawn: Vec::new() }
    }

    /// Follows some more rows, if any are left. Returns `true` if there are more.
    pub fn advance(&mut self) -> bool {
        /// The number of strokes in one part.
        const MANY: usize = 3000;
        let enough = self.drawn.len() + MANY;
        self.rows.take_if(|rows| {
            while self.drawn.len() < enough && rows.cell + 1 < rows.field.values.len() {
                rows.draw_from(rows.cell, &mut self.drawn);
                rows.cell += 1;
            }
            rows.cell + 1 >= rows.field.values.len()
        });
        self.rows.is_some()
    }
}

/// A mask with strokes, as far as they are drawn.
#[derive(Clone, Debug)]
pub(super) struct StrokeMask {
    mask: Coverage,
    drawn: usize,
}

impl StrokeMask {
    /// Makes a mask without strokes. `None` if it would have no pixels.
    pub fn new(view: &View) -> Option<Self> {
        Some(Self { mask: Coverage::new(view.width, view.height)?, drawn: 0 })
    }

    /// Draws some more strokes, if any are left. Returns `true` if there are more.
    pub fn advance(&mut self, strokes: &Strokes, view: &View) -> bool {
        const MANY: usize = 6000;
        let some = strokes.drawn[self.drawn..].iter().take(MANY);
        self.drawn += some.len();
        // In print, strokes are finer.
        let thinned = thinned(view.scale).sqrt();
        let pen = |stroke: &Stroke| stroke.map(|(at, half)| (at, half * thinned));
        some.map(pen).for_each(|[from, middle, to]| draw(&mut self.mask, view, &[[from, middle], [middle, to]]));
        self.drawn < strokes.drawn.len()
    }
}

/// Lays strokes over the land of some rows of a ground, broken where rivers run.
pub(super) fn lay(
    look: &Hachures,
    share: f32,
    strokes: &StrokeMask,
    sheet: &Sheet<'_>,
    rows: Rows,
    pixels: &mut [[u8; 4]],
) {
    let range = sheet.view.range(rows);
    let (land, rivers) = (&sheet.land[range.clone()], &sheet.rivers[range.clone()]);
    let open = |i: usize| f32::from(land[i]) * f32::from(255 - rivers[i]) * (look.strength * share / (255.0 * 255.0));
    lay_mask(&strokes.mask.mask().data()[range], look.colour, &open, pixels);
}

/// The rows of strokes. A field gives the number of the row at each height.
#[derive(Clone, Debug)]
struct HachureRows {
    field: Field,
    /// The rows that pass each cell, one bit for each row.
    marks: Vec<u32>,
    /// The next cell from which rows are drawn.
    cell: usize,
}

impl HachureRows {
    /// Draws the rows that pass between a cell and the next one, in both directions, unless they are already drawn.
    fn draw_from(&mut self, cell: usize, strokes: &mut Vec<Stroke>) {
        let (here, next) = (self.field.values[cell], self.field.values[cell + 1]);
        let is_last = (cell + 1).is_multiple_of(self.field.grid.columns);
        for row in (here.min(next).max(0.0) as u32 + 1..=here.max(next) as u32).filter(|_| !is_last) {
            if self.marks[cell] & (1 << (row % 32)) == 0 {
                let start = self.field.middle(cell) + Vec2::X * (0.5 * self.field.grid.cell_size);
                [1.0, -1.0].into_iter().for_each(|side| self.walk(start, row, side, strokes));
            }
        }
    }

    /// Follows a row until it closes or ends, and adds its strokes.
    fn walk(&mut self, start: Vec2, row: u32, side: f32, strokes: &mut Vec<Stroke>) {
        /// The greatest number of steps, one unit each.
        const MOST_STEPS: u32 = 5000;
        let (mut at, mut here) = (start, usize::MAX);
        for step in 0..MOST_STEPS {
            let (height, rise) = self.field.at(at);
            let squared = rise.length_squared();
            if squared < 1e-6 {
                return;
            }
            at -= rise * ((height - row as f32) / squared).clamp(-8.0, 8.0);
            let Some(cell) = self.field.cell(at) else { return };
            if cell != here {
                let (bit, is_first) = (1 << (row % 32), here == usize::MAX);
                if self.marks[cell] & bit != 0 && !is_first {
                    return;
                }
                (self.marks[cell], here) = (self.marks[cell] | bit, cell);
            }
            // The stroke at the start belongs to only one of the two directions.
            if step.is_multiple_of(APART) && (step > 0 || side > 0.0) {
                strokes.extend(stroke(&self.field, at, rise));
            }
            at += rise.perp() * (side / squared.sqrt());
        }
    }
}

/// Finds the stroke that begins at a place; `rise` is the number of rows per unit there. `None` where the land is
/// gentle or lit.
fn stroke(field: &Field, at: Vec2, rise: Vec2) -> Option<Stroke> {
    /// The lengths of strokes, in units, and the distance between rows beyond which land is too gentle for strokes.
    const SHORTEST: f32 = 4.0;
    const LONGEST: f32 = 10.0;
    const GENTLE: f32 = 16.0;
    const THICKEST: f32 = 0.62;
    let spacing = 1.0 / rise.length_squared().sqrt();
    let down = -rise * spacing;
    let dark = (down.dot(Vec2::splat(std::f32::consts::FRAC_1_SQRT_2)) * 0.8 + 0.2).max(0.0);
    let steep = ((GENTLE - spacing) / (GENTLE - SHORTEST)).min(1.0);
    if dark * steep < 0.08 {
        return None;
    }
    let half = THICKEST * (0.25 + 0.75 * dark * steep);
    let length = (spacing * 0.9).clamp(SHORTEST, LONGEST);
    let below = field.at(at + down * (length * 0.5)).1;
    // A stroke ends on a valley floor.
    let (length, bent) = if below.dot(rise) > 0.0 { (length, -below) } else { (length * 0.5, down) };
    let middle = at + down * (length * 0.5);
    let end = middle + bent * (length * 0.5 / bent.length_squared().max(1e-8).sqrt());
    Some([(at, half), (middle, half * 0.75), (end, half * 0.2)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::session::Session;

    #[test]
    fn strokes_run_down_on_the_side_away_from_the_light() {
        let text = "seed=kea&land=island&growth=drainage&attractors=2500&mouths=0&style=parchment";
        let mut session = Session::new(link::read(text).unwrap()).unwrap();
        session.finish().unwrap();
        let relief = session.relief().unwrap();
        let field = Field::of(relief, |height| height).smoothed(TIMES);
        let strokes = strokes(relief, crate::paint::relief::highest(relief));
        assert!(strokes.len() > 1000, "{}", strokes.len());
        for &[(from, half), (middle, _), (to, end)] in &strokes {
            let length = from.distance(to);
            assert!((1.99..=10.1).contains(&length) && half > end, "{from} to {to}");
            assert!((middle - from).dot(Vec2::ONE) > -0.4 * length, "{from} to {middle}");
        }
        // Where a valley is narrower than a stroke is long, some strokes end on its other side.
        let falls = |stroke: &&Stroke| field.at(stroke[0].0).0 > field.at(stroke[2].0).0;
        let falling = strokes.iter().filter(falls).count();
        assert!(falling * 50 > strokes.len() * 49, "{falling} of {}", strokes.len());
    }
}
