//! The field of cells.

use glam::Vec2;

use super::Relief;
use super::kinds::{LandKind, Shape};
use super::outline::Drawing;
use crate::domain::Domain;
use crate::random::Seed;
use crate::recipe::{Key, Outline, Recipe};

/// What a cell is to rivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Land.
    Available,
    /// Water: rivers end here.
    Unavailable,
    /// A ridge: no river crosses it.
    Illegal,
}

/// The side of a cell, in units: a third to a half of a river's step at the default number of attractors.
const SIDE: f32 = 2.0;

/// The least share of the domain that a drawn land fills: with less, attractors would not find it.
pub(super) const LEAST_DRAWN: f32 = 0.01;

/// Which cells are land, on the whole domain.
#[derive(Clone, Debug, PartialEq)]
pub struct Land {
    relief: Relief,
    cells: Vec<Cell>,
    columns: i32,
    rows: i32,
    available: u32,
    ridges: Vec<Vec<Vec2>>,
    size: Vec2,
}

/// A place where a river may reach the sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shore {
    /// The middle of a cell of land beside water.
    pub at: Vec2,
    /// The unit vector away from the water.
    pub inland: Vec2,
}

impl Land {
    /// The land of a recipe; `None` for the plain rectangle, which is all land, and for a drawn land of which nothing is
    /// drawn, or no water, or next to no land.
    pub fn of(recipe: &Recipe) -> Option<Self> {
        let shape = Shape {
            kind: LandKind::ALL.get(recipe.choice(Key::Land)).copied().unwrap_or(LandKind::Rectangle),
            domain: Domain::with_aspect(recipe.number(Key::Aspect)),
            sides: recipe.sides(Key::Sides),
            seed: Seed::from_text(recipe.seed()),
            sea: recipe.number(Key::Sea),
            rough: recipe.number(Key::Rough),
        };
        if shape.kind == LandKind::Drawn {
            return Self::drawn(&shape, recipe.outline()?);
        }
        let relief = shape.relief()?;
        let mut this = Self::from_relief(&shape.domain, relief);
        shape.ridges().into_iter().for_each(|ridge| this.raise(ridge));
        Some(this)
    }

    fn drawn(shape: &Shape, outline: &Outline) -> Option<Self> {
        let drawing = Drawing::of(outline, shape);
        let mut this = Self::from_relief(&shape.domain, drawing.relief(&shape.domain));
        let share = this.available as f32 / this.cells.len() as f32;
        let has_coast = (LEAST_DRAWN..1.0).contains(&share);
        drawing.ridges.into_iter().for_each(|ridge| this.raise(ridge));
        has_coast.then_some(this)
    }

    fn from_relief(domain: &Domain, relief: Relief) -> Self {
        let count = |length: f32| (length / SIDE).ceil() as i32;
        let (columns, rows) = (count(domain.size.x), count(domain.size.y));
        let cell = |i: i32| match relief.height(middle(i % columns, i / columns)) {
            height if height > 0.0 => Cell::Available,
            _ => Cell::Unavailable,
        };
        let cells: Vec<Cell> = (0..columns * rows).map(cell).collect();
        let available = cells.iter().filter(|&&cell| cell == Cell::Available).count() as u32;
        Self { relief, cells, columns, rows, available, ridges: Vec::new(), size: domain.size }
    }

    /// Makes the land along a polyline illegal.
    fn raise(&mut self, ridge: Vec<Vec2>) {
        for pair in ridge.windows(2) {
            for (column, row) in walk(pair[0], pair[1]) {
                if let Some(i) = self.index(column, row)
                    && self.cells[i] == Cell::Available
                {
                    self.cells[i] = Cell::Illegal;
                    self.available -= 1;
                }
            }
        }
        self.ridges.push(ridge);
    }

    /// The height of every point.
    pub fn relief(&self) -> &Relief {
        &self.relief
    }

    /// The area of available land, in square units.
    pub fn area(&self) -> f32 {
        self.available as f32 * SIDE * SIDE
    }

    /// The ridges that no river crosses, as polylines.
    pub fn ridges(&self) -> &[Vec<Vec2>] {
        &self.ridges
    }

    /// The cell of a point; water outside the domain.
    pub fn at(&self, point: Vec2) -> Cell {
        self.cell((point.x / SIDE).floor() as i32, (point.y / SIDE).floor() as i32)
    }

    /// Whether a river can run straight from one point to another: over land all the way, the ends included.
    pub fn allows(&self, from: Vec2, to: Vec2) -> bool {
        walk(from, to).all(|(column, row)| self.cell(column, row) == Cell::Available)
    }

    /// Whether no ridge lies between two points.
    pub fn sees(&self, from: Vec2, to: Vec2) -> bool {
        walk(from, to).all(|(column, row)| self.cell(column, row) != Cell::Illegal)
    }

    /// All cells of land beside water, row by row.
    pub fn coast(&self) -> Vec<Shore> {
        let mut shores = Vec::new();
        for (i, _) in (0..).zip(&self.cells).filter(|(_, cell)| **cell == Cell::Available) {
            let (column, row) = (i % self.columns, i / self.columns);
            let beside_water = [(1, 0), (0, 1), (-1, 0), (0, -1)]
                .into_iter()
                .any(|(x, y)| self.index(column + x, row + y).is_some_and(|i| self.cells[i] == Cell::Unavailable));
            if beside_water {
                // The last cells reach over the border.
                let at = middle(column, row).min(self.size);
                shores.push(Shore { at, inland: self.relief.slope(at).normalize_or(Vec2::NEG_Y) });
            }
        }
        shores
    }

    fn cell(&self, column: i32, row: i32) -> Cell {
        self.index(column, row).map_or(Cell::Unavailable, |i| self.cells[i])
    }

    fn index(&self, column: i32, row: i32) -> Option<usize> {
        let inside = (0..self.columns).contains(&column) && (0..self.rows).contains(&row);
        inside.then(|| (row * self.columns + column) as usize)
    }
}

fn middle(column: i32, row: i32) -> Vec2 {
    (Vec2::new(column as f32, row as f32) + 0.5) * SIDE
}

/// The cells that a straight line touches, each a neighbour by a side of the one before: nothing slips through
/// between two cells that touch at a corner (Amanatides and Woo 1987).
fn walk(from: Vec2, to: Vec2) -> impl Iterator<Item = (i32, i32)> {
    let (from, to) = (from / SIDE, to / SIDE);
    let cell = |at: Vec2| (at.x.floor() as i32, at.y.floor() as i32);
    let (start, end) = (cell(from), cell(to));
    let along = to - from;
    let axis = |from: f32, along: f32, start: i32| {
        let step = if along < 0.0 { -1 } else { 1 };
        let border = start as f32 + if along < 0.0 { 0.0 } else { 1.0 };
        let (next, every) =
            if along == 0.0 { (f32::INFINITY, 0.0) } else { ((border - from) / along, (1.0 / along).abs()) };
        (step, next, every)
    };
    let (step_x, mut next_x, every_x) = axis(from.x, along.x, start.0);
    let (step_y, mut next_y, every_y) = axis(from.y, along.y, start.1);
    let (mut column, mut row) = start;
    let cells = start.0.abs_diff(end.0) + start.1.abs_diff(end.1);
    let mut first = true;
    (0..=cells).map(move |_| {
        if !std::mem::take(&mut first) {
            // Whichever border comes first, but never past the last column or row.
            if row == end.1 || (column != end.0 && next_x < next_y) {
                column += step_x;
                next_x += every_x;
            } else {
                row += step_y;
                next_y += every_y;
            }
        }
        (column, row)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use proptest::prelude::*;

    fn land(text: &str) -> Land {
        Land::of(&link::read(text).unwrap()).unwrap()
    }

    #[test]
    fn sea_has_the_share_asked_for() {
        for kind in ["island", "continent", "archipelago", "valley", "basin"] {
            for sea in [0.1f32, 0.4, 0.8] {
                let share = 1.0 - land(&format!("land={kind}&sea={sea}")).area() / 1_000_000.0;
                assert!((share - sea).abs() < 0.03, "{kind}: {share} is not {sea}");
            }
        }
    }

    #[test]
    fn islands_are_not_cut_by_the_frame() {
        for kind in ["island", "archipelago"] {
            for seed in 0..8 {
                let land = land(&format!("land={kind}&seed={seed}&rough=1"));
                let rim = (0..land.columns).flat_map(|c| [(c, 0), (c, land.rows - 1)]);
                assert!(rim.into_iter().all(|(c, r)| land.cell(c, r) == Cell::Unavailable), "{kind}, seed {seed}");
            }
        }
    }

    #[test]
    fn no_line_slips_through_a_diagonal_ridge() {
        let mut land = land("land=continent&sea=0.1&rough=0");
        land.raise(vec![Vec2::new(300.0, 100.0), Vec2::new(601.0, 401.0)]);
        assert!(!land.sees(Vec2::new(500.0, 200.0), Vec2::new(400.0, 300.0)));
        assert!(land.sees(Vec2::new(500.0, 200.0), Vec2::new(600.0, 100.0)));
    }

    proptest! {
        #[test]
        fn walk_goes_from_end_to_end_by_neighbours(ax in 0f32..200.0, ay in 0f32..200.0, bx in 0f32..200.0, by in 0f32..200.0) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let cells: Vec<_> = walk(a, b).collect();
            let of = |p: Vec2| ((p.x / SIDE).floor() as i32, (p.y / SIDE).floor() as i32);
            prop_assert_eq!((cells[0], cells[cells.len() - 1]), (of(a), of(b)));
            prop_assert!(cells.windows(2).all(|w| w[0].0.abs_diff(w[1].0) + w[0].1.abs_diff(w[1].1) == 1));
            // Every point of the line lies in one of the cells, or within rounding of it.
            for i in 0..=50 {
                let point = a.lerp(b, i as f32 / 50.0);
                let near = |&(c, r): &(i32, i32)| (point - middle(c, r)).abs().max_element() <= SIDE / 2.0 + 1e-3;
                prop_assert!(cells.iter().any(near), "{}", point);
            }
        }
    }
}
