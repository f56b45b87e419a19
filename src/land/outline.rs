//! The land of a drawn outline: its lines in units, roughened, and their coast distances.

use glam::Vec2;

use super::cell::CELL_SIZE;
use super::coast_distance::{CoastDistance, Piece};
use super::grid::Grid;
use super::kinds::Shape;
use crate::base::geometry::distance;
use crate::domain::Domain;
use crate::recipe::{GridPoint, Outline};

/// The distance by which a coast along the border is moved beyond the domain, in units: the land continues there, and
/// that coast is not visible.
const BEYOND: f32 = 150.0;
/// The greatest distance that a coast strays from its drawn line, as a share of a bump's length: so little that the
/// plane never folds, and lines that do not touch still do not.
const WILDEST: f32 = 0.07;
/// The number of bumps of a rough coast across the domain: large enough to be small beside drawn shapes, which keep
/// their form.
const BUMPS: f32 = 5.0;
/// The length of the pieces of a bent line, in units. Pieces are longer where there would be more than [`MOST_PIECES`].
const PIECE: f32 = 7.0;
const MOST_PIECES: f32 = 2000.0;

/// Drawn lines, in units.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    /// Closed lines between land and water.
    pub coasts: Vec<Vec<Vec2>>,
    pub ridges: Vec<Vec<Vec2>>,
    /// The courses of rivers, from their mouths.
    pub rivers: Vec<Vec<Vec2>>,
}

impl Drawing {
    /// Places an outline on a domain. All lines are moved by the same noise, so lines that do not touch still do not,
    /// small islands stay, and ridges and rivers keep their place on the land.
    pub fn of(outline: &Outline, shape: &Shape) -> Self {
        let domain = &shape.domain;
        let [coasts, ridges, rivers] =
            [outline.coasts(), outline.ridges(), outline.rivers()].map(|lines| in_units(lines, domain));
        let coasts = coasts.iter().map(|ring| past_border(ring, domain.size)).collect();
        let mut this = Self { coasts, ridges, rivers };
        if shape.roughness > 0.0 {
            this.roughen(shape);
        }
        this
    }

    /// Places lines, in fractions of the domain's width and height, on the domain.
    pub fn on(domain: &Domain, coasts: Vec<Vec<Vec2>>, ridges: Vec<Vec<Vec2>>) -> Self {
        let size = domain.size;
        let on_domain = |line: Vec<Vec2>| line.into_iter().map(|at| at * size).collect::<Vec<_>>();
        Self {
            coasts: coasts.into_iter().map(|ring| past_border(&on_domain(ring), size)).collect(),
            ridges: ridges.into_iter().map(on_domain).collect(),
            rivers: Vec::new(),
        }
    }

    fn roughen(&mut self, shape: &Shape) {
        let piece = (self.length() / MOST_PIECES).max(PIECE);
        let bend = bend(shape);
        for (lines, is_closed) in [(&mut self.coasts, true), (&mut self.ridges, false), (&mut self.rivers, false)] {
            for line in lines {
                let mut points: Vec<Vec2> = divided(line, piece, is_closed).collect();
                points.iter_mut().for_each(|at| *at = bend(*at));
                *line = points;
            }
        }
    }

    fn length(&self) -> f32 {
        self.edges().into_iter().map(|[a, b]| distance(a, b)).sum()
    }

    /// Lists the edges of all coasts.
    fn edges(&self) -> Vec<Piece> {
        let mut edges = Vec::new();
        for ring in &self.coasts {
            edges.extend(ring.windows(2).map(|pair| [pair[0], pair[1]]));
            edges.extend(ring.last().map(|&last| [last, ring[0]]));
        }
        edges
    }

    /// Measures the distances from the coasts, on a lattice with a spacing. Land is everything within an odd number of
    /// coasts.
    pub fn coast_distance(&self, domain: &Domain, spacing: f32) -> CoastDistance {
        CoastDistance::of_coast(
            domain,
            spacing,
            &self.edges(),
            &self.crossings(domain, spacing, Vec2::ZERO).into_land(),
        )
    }

    /// Counts the cells that are certainly land and those that are certainly water, without measuring a distance: squares of the
    /// lattice whose four corners are alike. Such a square of land is water only if coasts pass through all four of its corners, and a
    /// coast passes through few: one for each spacing of its length, and two more for each edge. As many squares are subtracted.
    pub fn certain_cells(&self, domain: &Domain, spacing: f32) -> [usize; 2] {
        let crossings = self.crossings(domain, spacing, Vec2::ZERO);
        let columns = crossings.columns;
        let is_land = crossings.into_land();
        let (mut land, mut water) = (0_usize, 0_usize);
        // The last row and column of corners lie at the border of the domain or beyond it.
        let rows = || is_land.chunks(columns);
        for (upper, lower) in rows().zip(rows().skip(1)).take(rows().len().saturating_sub(2)) {
            for column in 0..columns.saturating_sub(2) {
                match [upper[column], upper[column + 1], lower[column], lower[column + 1]] {
                    [true, true, true, true] => land += 1,
                    [false, false, false, false] => water += 1,
                    _ => {}
                }
            }
        }
        let edges = self.edges();
        let passed: usize = edges.iter().map(|[a, b]| (distance(*a, *b) / spacing) as usize + 2).sum();
        let cells = (spacing * spacing / (CELL_SIZE * CELL_SIZE)) as usize;
        [land.saturating_sub(passed) * cells, water * cells]
    }

    /// Makes the grid of cells, land where their middles lie within an odd number of coasts. Unlike a coarse lattice, this loses no detail.
    pub fn grid(&self, domain: &Domain) -> Grid {
        let crossings = self.crossings(domain, CELL_SIZE, Vec2::splat(CELL_SIZE / 2.0));
        let columns = crossings.columns;
        Grid::of_cells(domain, &crossings.into_land(), columns)
    }

    /// Finds the crossings of the coasts with a lattice that begins at a corner.
    fn crossings(&self, domain: &Domain, spacing: f32, corner: Vec2) -> Crossings {
        let mut crossings = Crossings::over(domain, spacing);
        self.edges().into_iter().for_each(|[a, b]| crossings.add(a - corner, b - corner));
        crossings
    }
}

impl CoastDistance {
    /// Measures the distances from some rings, on a lattice with a spacing: positive within an odd number of them.
    pub(crate) fn within(domain: &Domain, spacing: f32, rings: Vec<Vec<Vec2>>) -> Self {
        Drawing { coasts: rings, ridges: Vec::new(), rivers: Vec::new() }.coast_distance(domain, spacing)
    }
}

/// Converts the lines of an outline to units.
pub(crate) fn in_units(lines: &[Vec<GridPoint>], domain: &Domain) -> Vec<Vec<Vec2>> {
    lines.iter().map(|line| line.iter().map(|point| point.fraction() * domain.size).collect()).collect()
}

/// Returns the function that displaces each point of the plane on a rough land.
fn bend(shape: &Shape) -> impl Fn(Vec2) -> Vec2 {
    let [east, south] = [4, 5].map(|index| shape.noise(index, BUMPS, 2));
    let most = shape.roughness * WILDEST * shape.domain.size.min_element() / BUMPS;
    move |Vec2 { x, y }| Vec2::new(x, y) + Vec2::new(east.get_noise_2d(x, y), south.get_noise_2d(x, y)) * most
}

/// Moves the parts of a ring that run along the border of the domain beyond it.
fn past_border(ring: &[Vec2], size: Vec2) -> Vec<Vec2> {
    let is_along =
        |a: Vec2, b: Vec2| (side(a.x, size.x) * side(b.x, size.x)).max(side(a.y, size.y) * side(b.y, size.y)) > 0.0;
    let mut taken = Vec::with_capacity(ring.len() + 8);
    for (i, &point) in ring.iter().enumerate() {
        let (before, after) = (ring[(i + ring.len() - 1) % ring.len()], ring[(i + 1) % ring.len()]);
        let beyond = point + Vec2::new(side(point.x, size.x), side(point.y, size.y)) * BEYOND;
        match (is_along(before, point), is_along(point, after)) {
            (false, false) => taken.push(point),
            (false, true) => taken.extend([point, beyond]),
            (true, false) => taken.extend([beyond, point]),
            (true, true) => taken.push(beyond),
        }
    }
    taken
}

/// Returns the border on which a coordinate lies: -1 for the near one, 1 for the far one, 0 for none.
fn side(x: f32, length: f32) -> f32 {
    if x <= 0.0 {
        -1.0
    } else if x >= length {
        1.0
    } else {
        0.0
    }
}

/// Iterates over the points of a line with more points between, so that no gap is longer than a piece.
pub(crate) fn divided(line: &[Vec2], piece: f32, is_closed: bool) -> Box<dyn Iterator<Item = Vec2> + '_> {
    let edges = if is_closed { line.len() } else { line.len().saturating_sub(1) };
    let edge = move |i: usize| {
        let (a, b) = (line[i], line[(i + 1) % line.len()]);
        let pieces = (distance(a, b) / piece).ceil().max(1.0) as u32;
        (0..pieces).map(move |k| a.lerp(b, k as f32 / pieces as f32))
    };
    let end = line.last().copied().filter(|_| !is_closed);
    // A box, because each further copy of the iterator would weigh a kilobyte.
    Box::new((0..edges).flat_map(edge).chain(end))
}

/// The crossings of coast edges with the rows of the lattice.
struct Crossings {
    /// `true` if an odd number of edges lie between this corner and the next one to the west.
    flips: Vec<bool>,
    columns: usize,
    rows: usize,
    /// The distance between the corners of the lattice, in units.
    spacing: f32,
}

impl Crossings {
    fn over(domain: &Domain, spacing: f32) -> Self {
        let (columns, rows) = CoastDistance::corners(domain, spacing);
        Self { flips: vec![false; columns * rows], columns, rows, spacing }
    }

    /// Records where an edge crosses the rows of the lattice. Only the upper end of an edge counts, so two edges that
    /// meet on a row cross it once.
    fn add(&mut self, a: Vec2, b: Vec2) {
        let (upper, lower) = if a.y <= b.y { (a, b) } else { (b, a) };
        for row in self.first(upper.y, self.rows)..self.first(lower.y, self.rows) {
            let share = (row as f32 * self.spacing - upper.y) / (lower.y - upper.y);
            let column = self.first(upper.x + (lower.x - upper.x) * share, self.columns);
            if column < self.columns {
                self.flips[row * self.columns + column] ^= true;
            }
        }
    }

    /// Returns the index of the first lattice line at or beyond a coordinate, or `lines` if there is none.
    fn first(&self, x: f32, lines: usize) -> usize {
        ((x / self.spacing).ceil().max(0.0) as usize).min(lines)
    }

    /// Returns, for each corner, row by row, `true` if an odd number of edges lie to the west of it.
    fn into_land(self) -> Vec<bool> {
        let mut is_land = false;
        let corner = |(i, flips): (usize, bool)| {
            is_land = (is_land && i % self.columns != 0) ^ flips;
            is_land
        };
        self.flips.into_iter().enumerate().map(corner).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Seed;
    use crate::land::{Cell, Land};
    use crate::property::cases;
    use crate::recipe::LandKind;
    use crate::recipe::{Key, Recipe, Sides, link};
    use proptest::prelude::*;

    /// Makes a recipe with a smooth drawn land, whose points are given in fractions.
    fn recipe(coasts: &[&[(f32, f32)]], ridges: &[&[(f32, f32)]]) -> Recipe {
        let lines = |lines: &[&[(f32, f32)]]| {
            lines.iter().map(|line| line.iter().map(|&at| GridPoint::nearest(at.into())).collect()).collect()
        };
        let outline = Outline::new(lines(coasts), lines(ridges), vec![]).unwrap();
        link::read(&format!("land=drawn&roughness=0&aspect=1&outline={outline}")).unwrap()
    }

    const SQUARE: &[(f32, f32)] = &[(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8)];

    #[test]
    fn height_is_the_distance_from_the_drawn_coast() {
        let land = Land::of(&recipe(&[SQUARE], &[])).unwrap();
        assert!((land.regions()[0].cells as f32 / 360_000.0 - 1.0).abs() < 0.01, "{}", land.regions()[0].cells);
        for (at, height) in
            [((450.0, 500.0), 250.0), ((500.0, 230.0), 30.0), ((500.0, 180.0), -20.0), ((170.0, 160.0), -50.0)]
        {
            assert!((land.coast_distance().height(at.into()) - height).abs() < 1.0, "{at:?}: {height}");
        }
    }

    #[test]
    fn coast_within_a_coast_is_a_lake() {
        let lake: &[(f32, f32)] = &[(0.4, 0.4), (0.6, 0.4), (0.5, 0.6)];
        let land = Land::of(&recipe(&[SQUARE, lake], &[])).unwrap();
        assert_eq!(land.at(Vec2::new(500.0, 450.0)), Cell::Water);
        assert_eq!(land.at(Vec2::new(300.0, 450.0)), Cell::Land);
    }

    #[test]
    fn land_goes_on_beyond_the_border_that_its_coast_runs_along() {
        let half: &[(f32, f32)] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)];
        let land = Land::of(&recipe(&[half], &[])).unwrap();
        assert!(land.regions()[0].shores.iter().all(|shore| (shore.at.y - 500.0).abs() < 4.0));
        for at in [(0.0, 0.0), (0.0, 300.0), (999.0, 0.0)] {
            assert!(land.coast_distance().height(at.into()) > 150.0, "{at:?}");
        }
    }

    #[test]
    fn ridges_are_illegal_land() {
        let land = Land::of(&recipe(&[SQUARE], &[&[(0.1, 0.5), (0.9, 0.5)]])).unwrap();
        assert_eq!(land.at(Vec2::new(500.0, 500.0)), Cell::Ridge);
        assert_eq!(land.at(Vec2::new(150.0, 500.0)), Cell::Water);
        assert!(!land.allows(Vec2::new(500.0, 450.0), Vec2::new(510.0, 550.0)));
    }

    #[test]
    fn what_has_no_coast_to_speak_of_is_the_whole_rectangle() {
        let all: &[(f32, f32)] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let speck: &[(f32, f32)] = &[(0.5, 0.5), (0.51, 0.5), (0.5, 0.51)];
        for coast in [all, speck] {
            assert!(Land::of(&recipe(&[coast], &[])).is_none());
        }
        assert!(Land::of(&link::read("land=drawn").unwrap()).is_none());
    }

    #[test]
    fn rough_coasts_keep_the_drawn_shape() {
        for seed in ["kauri", "rimu", "kea"] {
            let mut recipe = recipe(&[SQUARE], &[]);
            recipe.set(Key::Seed, seed).unwrap();
            let smooth = Land::of(&recipe).unwrap();
            recipe.set(Key::Roughness, "0.5").unwrap();
            let rough = Land::of(&recipe).unwrap();
            let places = || (0..10_000).map(|i| Vec2::new((i % 100) as f32, (i / 100) as f32) * 10.0);
            let differing = places().filter(|&at| smooth.at(at) != rough.at(at)).count();
            assert!((50..600).contains(&differing), "{seed}: {differing} of 10000");
        }
    }

    #[test]
    fn the_wildest_bend_never_folds_the_plane() {
        for (seed, aspect) in ["kauri", "rimu", "kea", "totara"].into_iter().zip([0.25, 1.0, 1.5, 4.0]) {
            let domain = Domain::with_aspect(aspect);
            let seed = Seed::from_text(seed);
            let shape = Shape {
                kind: LandKind::Drawn,
                domain,
                sides: Sides::SOUTH,
                seed,
                sea: 0.5,
                roughness: 1.0,
                center: Vec2::ZERO,
            };
            let bend = bend(&shape);
            for i in 0..40_000 {
                let at = domain.size * Vec2::new((i % 200) as f32, (i / 200) as f32) / 200.0;
                let (along_x, along_y) = (bend(at + Vec2::X) - bend(at), bend(at + Vec2::Y) - bend(at));
                assert!(along_x.perp_dot(along_y) > 0.0, "aspect {aspect}: folds at {at}");
            }
        }
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn relief_is_positive_just_within_an_odd_number_of_coasts(
            ring in proptest::collection::vec((0.01f32..0.99, 0.01f32..0.99), 3..12),
            at in (0f32..1000.0, 0f32..1000.0),
        ) {
            let ring: Vec<Vec2> = ring.into_iter().map(|point| Vec2::from(point) * 1000.0).collect();
            let drawing = Drawing { coasts: vec![ring], ridges: vec![], rivers: vec![] };
            // The distance is exact at the corners of the lattice.
            let at = (Vec2::from(at) / CoastDistance::SPACING).floor() * CoastDistance::SPACING;
            let nearest = |[a, b]: Piece| {
                let along = b - a;
                let share = ((at - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
                at.distance(a + along * share)
            };
            let distance = drawing.edges().into_iter().map(nearest).fold(f32::INFINITY, f32::min);
            let crossings = drawing.edges().into_iter().filter(|[a, b]| {
                (a.y > at.y) != (b.y > at.y) && at.x > a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)
            });
            let is_land = crossings.count() % 2 == 1;
            let height = drawing.coast_distance(&Domain::with_aspect(1.0), CoastDistance::SPACING).height(at);
            // A distance that is passed on from corner to corner may be slightly too long.
            prop_assert!((-0.01..2.0).contains(&(height.abs() - distance)), "{} is not {}", height, distance);
            prop_assert!(distance < 0.01 || is_land == (height > 0.0));
        }
    }
}
