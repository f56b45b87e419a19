//! Hachures: rows of strokes down the slope, each row begun on one height (Lehmann 1799), the steeper the denser; on the side away from
//! the light alone, as engravers shaded mountains.

use glam::Vec2;

use super::Sheet;
use super::field::Field;
use crate::paint::coverage::Coverage;
use crate::paint::ground::{draw, lay_mask};
use crate::paint::palette::Hachures;
use crate::paint::view::{Rows, View};
use crate::relief::Relief;

/// A stroke: its places with half of its width there, in units.
pub(crate) type Stroke = [(Vec2, f32); 3];

/// How many rows lie between the sea and the highest land.
const ROWS: f32 = 14.0;

/// How often heights are smoothed before.
const TIMES: u32 = 5;

/// How far apart strokes of a row are, in units.
const APART: u32 = 3;

/// The strokes of a relief. `highest` is what has the colour of the highest land, in units of height.
#[cfg(feature = "files")]
pub(crate) fn strokes(relief: &Relief, highest: f32) -> Vec<Stroke> {
    let mut strokes = Strokes::new(relief, highest);
    while strokes.advance() {}
    strokes.drawn
}

/// The strokes of a relief, as far as its rows have been walked along.
#[derive(Clone, Debug)]
pub(super) struct Strokes {
    /// Until all are.
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

    /// Walks on, if any rows are left. Returns whether there are more.
    pub fn advance(&mut self) -> bool {
        /// So many make a part.
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
    /// Without any yet. `None` if it would have no pixels.
    pub fn new(view: &View) -> Option<Self> {
        Some(Self { mask: Coverage::new(view.width, view.height)?, drawn: 0 })
    }

    /// Draws some more of these, if any are left. Returns whether there are more.
    pub fn advance(&mut self, strokes: &Strokes, view: &View) -> bool {
        const MANY: usize = 6000;
        let some = strokes.drawn[self.drawn..].iter().take(MANY);
        self.drawn += some.len();
        some.for_each(|[from, middle, to]| draw(&mut self.mask, view, &[[*from, *middle], [*middle, *to]]));
        self.drawn < strokes.drawn.len()
    }
}

/// Lays strokes over the land of some rows of a ground, broken where rivers run.
pub(super) fn lay(look: &Hachures, strokes: &StrokeMask, sheet: &Sheet<'_>, rows: Rows, pixels: &mut [[u8; 4]]) {
    let range = sheet.view.range(rows);
    let (land, rivers) = (&sheet.land[range.clone()], &sheet.rivers[range.clone()]);
    let open = |i: usize| f32::from(land[i]) * f32::from(255 - rivers[i]) * (look.strength / (255.0 * 255.0));
    lay_mask(&strokes.mask.mask().data()[range], look.colour, &open, pixels);
}

/// The rows of a field whose unit is a row.
#[derive(Clone, Debug)]
struct HachureRows {
    field: Field,
    /// Of each cell, the rows that pass it, a bit each.
    marks: Vec<u32>,
    /// The cell from which rows are drawn next.
    cell: usize,
}

impl HachureRows {
    /// Draws the rows that pass between a cell and the next, both ways, unless they are there.
    fn draw_from(&mut self, cell: usize, strokes: &mut Vec<Stroke>) {
        let (here, next) = (self.field.values[cell], self.field.values[cell + 1]);
        let is_last = (cell + 1).is_multiple_of(self.field.columns);
        for row in (here.min(next).max(0.0) as u32 + 1..=here.max(next) as u32).filter(|_| !is_last) {
            if self.marks[cell] & (1 << (row % 32)) == 0 {
                let start = self.field.middle(cell) + Vec2::X;
                [1.0, -1.0].into_iter().for_each(|side| self.walk(start, row, side, strokes));
            }
        }
    }

    /// Walks along a row until it closes or ends, and leaves strokes.
    fn walk(&mut self, start: Vec2, row: u32, side: f32, strokes: &mut Vec<Stroke>) {
        /// Of a unit each.
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
            // The start belongs to one side.
            if step.is_multiple_of(APART) && (step > 0 || side > 0.0) {
                strokes.extend(stroke(&self.field, at, rise));
            }
            at += rise.perp() * (side / squared.sqrt());
        }
    }
}

/// The stroke that begins at a place; `rise` is by how many rows it rises there by the unit. None where the land is gentle or lit.
fn stroke(field: &Field, at: Vec2, rise: Vec2) -> Option<Stroke> {
    /// Of strokes, and of land too gentle for any: how far apart rows are there. In units.
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
    // A valley floor ends it.
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
            assert!((2.0..=10.1).contains(&length) && half > end, "{from} to {to}");
            assert!((middle - from).dot(Vec2::ONE) > -0.4 * length, "{from} to {middle}");
        }
        // Where valleys are narrower than a stroke is long, some end on the other side.
        let falls = |stroke: &&Stroke| field.at(stroke[0].0).0 > field.at(stroke[2].0).0;
        let falling = strokes.iter().filter(falls).count();
        assert!(falling * 50 > strokes.len() * 49, "{falling} of {}", strokes.len());
    }
}
