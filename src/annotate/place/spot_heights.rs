//! Spot heights: how high summits are, and saddles between them, in metres beside a triangle or a dot.

use glam::Vec2;

use super::background::{Background, LAKE, NONE, RIDGE};
use super::input::{Elevations, Heights, Input};
use super::letters::{Box, Kind, Label, Stroke, Text};
use crate::base::sort;

/// The length of the em, in units.
const EM: f32 = 9.5;
/// Nothing as far around as this is higher than a summit, or between the two heights of either side of a saddle, in units.
const AROUND: f32 = 8.0;
/// A summit over which nothing rises as far around as this has a triangle, in units.
const LANDMARK: f32 = 130.0;
/// Lower ones are not worth telling, in metres.
const LEAST_METRES: f32 = 10.0;

/// The size of a dot, that of a triangle, and half the width of its lines, in ems.
const DOT: f32 = 0.11;
const TRIANGLE: f32 = 0.32;
const HALF: f32 = 0.035;
/// The distance of type from the symbol, and the height of figures, in ems.
const BESIDE: f32 = 0.24;
const FIGURE: f32 = 0.65;
/// The least distances of symbol and figures from banks and coast, from other labels, and from the frame, in ems.
const FROM_BANKS: f32 = 0.18;
const FROM_LABELS: f32 = 0.3;
const FROM_FRAME: f32 = 0.4;

/// A place whose height may be told.
#[derive(Clone, Copy, Debug)]
struct Spot {
    at: Vec2,
    height: f32,
    /// `true` if it has a triangle.
    is_landmark: bool,
}

/// Places the spot heights of a map, off rivers, coasts and the labels that there are, each with the boxes around its symbol and its
/// figures: of summits, the highest first, then of saddles.
pub fn labels<G: Background>(
    input: &Input<'_>,
    background: &G,
    elevations: &Elevations<'_>,
    taken: &[(u32, Box)],
) -> Vec<(Label, [Box; 2])> {
    let em = EM.max(input.least_em) * input.label_size;
    let search = Search { input, background, em, metres: elevations.metres };
    let (mut taken, mut told, mut labels) = (taken.to_vec(), Vec::<Vec2>::new(), Vec::new());
    for spot in spots(elevations) {
        let is_near = |other: &Vec2| other.distance_squared(spot.at) < elevations.apart * elevations.apart;
        if told.iter().any(is_near) {
            continue;
        }
        if let Some((label, boxes)) = search.label(&spot, &taken) {
            told.push(spot.at);
            taken.extend(boxes.map(|around| (NONE, around)));
            labels.push((label, boxes));
        }
    }
    labels
}

/// Returns all summits, the highest first, then all saddles likewise.
fn spots(elevations: &Elevations<'_>) -> Vec<Spot> {
    let Elevations { heights, metres, .. } = elevations;
    let field = Field::new(heights);
    let least = LEAST_METRES / metres;
    let [mut summits, mut saddles] = [Vec::new(), Vec::new()];
    for (cell, &height) in heights.heights.iter().enumerate().filter(|(_, height)| **height >= least) {
        let at = field.at(cell);
        if field.is_summit(cell, AROUND) {
            summits.push(Spot { at, height, is_landmark: field.is_summit(cell, LANDMARK) });
        } else if field.is_saddle(cell) {
            saddles.push(Spot { at, height, is_landmark: false });
        }
    }
    let highest_first = |spot: &Spot| sort::key(-spot.height);
    let mut spots = sort::sorted_by(&summits, highest_first);
    spots.extend(sort::sorted_by(&saddles, highest_first));
    spots
}

/// Heights, cell by cell.
struct Field<'a> {
    heights: &'a [f32],
    columns: i32,
    rows: i32,
    size: f32,
}

impl<'a> Field<'a> {
    fn new(heights: &Heights<'a>) -> Self {
        let rows = heights.heights.len() / heights.columns.max(1);
        Self { heights: heights.heights, columns: heights.columns as i32, rows: rows as i32, size: heights.cell_size }
    }

    /// Returns the middle of a cell.
    fn at(&self, cell: usize) -> Vec2 {
        let (column, row) = (cell as i32 % self.columns, cell as i32 / self.columns);
        (Vec2::new(column as f32, row as f32) + 0.5) * self.size
    }

    /// Returns the height some columns and rows away; nothing is lower than what lies beyond the map.
    fn height(&self, cell: usize, [right, down]: [i32; 2]) -> f32 {
        let (column, row) = (cell as i32 % self.columns + right, cell as i32 / self.columns + down);
        let is_on_map = (0..self.columns).contains(&column) && (0..self.rows).contains(&row);
        if is_on_map { self.heights[(row * self.columns + column) as usize] } else { f32::MIN }
    }

    /// Returns `true` if a cell is on the map, and all cells within a distance are lower, or as high and later.
    fn is_summit(&self, cell: usize, around: f32) -> bool {
        let (own, reach) = (self.heights[cell], (around / self.size) as i32);
        let is_lower = |[right, down]: [i32; 2]| {
            let other = self.height(cell, [right, down]);
            other < own || (other == own && (down, right) >= (0, 0))
        };
        // Most cells have a higher neighbour.
        RING.into_iter().all(is_lower)
            && (-reach..=reach).all(|down| {
                let is_near = |right: &i32| right * right + down * down <= reach * reach;
                (-reach..=reach).filter(is_near).all(|right| is_lower([right, down]))
            })
    }

    /// Returns `true` if land rises from a cell in two directions and falls in the two between, at once and as far as summits are seen
    /// from.
    fn is_saddle(&self, cell: usize) -> bool {
        let own = self.heights[cell];
        let reach = (AROUND / self.size) as i32;
        let turns = |by: i32| {
            let is_higher = RING.map(|[right, down]| self.height(cell, [right * by, down * by]) > own);
            (0..RING.len()).filter(|&i| is_higher[i] != is_higher[(i + 1) % RING.len()]).count()
        };
        turns(1) == 4 && turns(reach / 2) == 4 && turns(reach) == 4
    }
}

/// The eight cells around one, in order.
const RING: [[i32; 2]; 8] = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];

struct Search<'a, G> {
    input: &'a Input<'a>,
    background: &'a G,
    em: f32,
    metres: f32,
}

impl<G: Background> Search<'_, G> {
    /// Sets the height of a place beside it: to the right if it can be, else left, above or below. Returns it with the boxes around figures
    /// and symbol.
    fn label(&self, spot: &Spot, taken: &[(u32, Box)]) -> Option<(Label, [Box; 2])> {
        let em = self.em;
        let symbol = if spot.is_landmark { TRIANGLE } else { DOT } * em;
        let dot = Box::level(spot.at - symbol, spot.at + symbol);
        if !self.is_clear(&dot, taken) {
            return None;
        }
        let says = ((spot.height * self.metres + 0.5) as u32).to_string();
        let text = Text::new(&says, Kind::SpotHeight);
        let half = Vec2::new(0.5 * text.length, 0.5 * FIGURE) * em;
        let off = Vec2::splat(symbol + BESIDE * em) + half;
        let sides =
            [[1.0, 0.0], [-1.0, 0.0], [0.0, -0.9], [0.0, 0.9], [0.9, -0.6], [0.9, 0.6], [-0.9, -0.6], [-0.9, 0.6]];
        let figures = sides.into_iter().find_map(|side| {
            let middle = spot.at + off * Vec2::from(side);
            let figures = Box::level(middle - half, middle + half);
            self.is_clear(&figures, taken).then_some(figures)
        })?;
        let start = figures.middle + Vec2::new(-half.x, half.y);
        let letters = text.level(start, em);
        let mut label = Label::new(Kind::SpotHeight, None, &says, em, letters);
        label.strokes =
            if spot.is_landmark { triangle(spot.at, em) } else { vec![Stroke { ends: [spot.at; 2], half: symbol }] };
        Some((label, [dot, figures]))
    }

    /// Returns `true` if a box is in the frame, and off rivers, lakes, ridges, coast and labels.
    fn is_clear(&self, around: &Box, taken: &[(u32, Box)]) -> bool {
        /// The distance between places that are asked, in units.
        const STEP: f32 = 2.0;
        let ([least, most], em) = (self.input.frame, self.em);
        let half = Vec2::new(around.along.x, around.down.y);
        let (first, last) = (around.middle - half, around.middle + half);
        let margin = FROM_FRAME * em;
        let is_in_frame = first.cmpge(least + margin).all() && last.cmple(most - margin).all();
        // No point of the box is farther than this from one that is asked.
        let clear = FROM_BANKS * em + STEP * core::f32::consts::FRAC_1_SQRT_2;
        let counts = (half * 2.0 / STEP).ceil().max(Vec2::ONE);
        let is_bare = |at: Vec2| {
            let ink = self.background.ink(at).river;
            self.input.map.coast().is_none_or(|coast| coast.height(at) >= clear)
                && ink != LAKE
                && ink != RIDGE
                && self.background.distances(at, NONE, 0.0, clear)[1] >= clear
        };
        let is_all_bare = || {
            let mut places = (0..=counts.y as u32)
                .flat_map(|row| (0..=counts.x as u32).map(move |column| Vec2::new(column as f32, row as f32) / counts));
            places.all(|share| is_bare(first + (last - first) * share))
        };
        is_in_frame && !taken.iter().any(|(_, other)| around.meets(other, FROM_LABELS * em)) && is_all_bare()
    }
}

/// Draws a triangle with a dot in it.
fn triangle(at: Vec2, em: f32) -> Vec<Stroke> {
    let corners = [[0.0, -1.0], [0.87, 0.5], [-0.87, 0.5]].map(|corner| at + Vec2::from(corner) * (TRIANGLE * em));
    let sides = [0, 1, 2].map(|i| Stroke { ends: [corners[i], corners[(i + 1) % 3]], half: HALF * em });
    sides.into_iter().chain([Stroke { ends: [at; 2], half: HALF * em }]).collect()
}
