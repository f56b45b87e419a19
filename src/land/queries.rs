//! Land as growth and painting use it: coast distances, the grid of cells, regions and ridges.

use std::sync::Arc;

use glam::Vec2;

use super::cell::{CELL_SIZE, Cell};
use super::coast_distance::CoastDistance;
use super::grid::Grid;
use super::kinds::Shape;
use super::obstacles::Obstacles;
use super::outline::Drawing;
use super::ragged::Ragged;
use super::regions::{Region, around, between, regions, regions_of};
use super::walk::walk;
use crate::base::geometry::length;
use crate::base::work;
use crate::domain::Domain;
use crate::recipe::{LandKind, Recipe};

/// The smallest share of the domain that a drawn land must fill: attractors would miss smaller lands.
pub(super) const LEAST_DRAWN: f32 = 0.01;

/// The land of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Land {
    coast_distance: CoastDistance,
    grid: Grid,
    regions: Vec<Region>,
    ridges: Vec<Vec<Vec2>>,
    rivers: Vec<Vec<Vec2>>,
    /// The borders of land, which no river crosses.
    borders: Obstacles,
    hides: Hides,
    /// The way in which straight coasts are ragged that a sea leaves when it rises over this land.
    ragged: Option<Ragged>,
}

/// The obstacles through which attractors do not pull nodes.
#[derive(Clone, Debug, PartialEq)]
enum Hides {
    /// No obstacles, on connected land without ridges.
    Nothing,
    /// Ridges alone.
    Ridges(Obstacles),
    /// Everything but land, where there are several regions, so that growth in one does not affect the others.
    Borders,
}

impl Land {
    /// Makes the land of a recipe. `None` for the plain rectangle, which is all land, and for a drawn land without a
    /// drawing, without water or with hardly any land.
    pub fn of(recipe: &Recipe) -> Option<Arc<Self>> {
        let shape = Shape::of(recipe);
        if shape.kind == LandKind::Drawn {
            let (grid, coast_distance, Drawing { ridges, rivers, .. }) = drawn(&shape, recipe)?;
            return Some(Arc::new(Self { rivers, ..Self::on(grid, coast_distance, ridges) }));
        }
        Some(Arc::new(Self::new(&shape.domain, shape.coast_distance(CoastDistance::SPACING)?, shape.ridges())))
    }

    /// Makes a coarse preview of [`Land::of`], three times as fast. Drawn lands are exact. `None` as in [`Land::of`].
    pub(crate) fn draft_of(recipe: &Recipe) -> Option<Arc<Self>> {
        let shape = Shape::of(recipe);
        if shape.kind == LandKind::Drawn {
            return Self::of(recipe);
        }
        let coast_distance = shape.coast_distance(CoastDistance::COARSE_SPACING)?;
        Some(Arc::new(Self::new(&shape.domain, coast_distance, shape.ridges())))
    }

    /// Tells which kind of land a recipe gives: the one that it names, or the plain rectangle if it names a drawn land and
    /// [`Land::of`] finds none. Makes no land to find out, unless a drawn one fills hardly any or nearly all of the map.
    pub fn kind_of(recipe: &Recipe) -> LandKind {
        match recipe.get() {
            LandKind::Drawn if !is_drawn(recipe) => LandKind::Rectangle,
            kind => kind,
        }
    }

    /// Makes land of everything above the sea, with ridges.
    pub(crate) fn new(domain: &Domain, coast_distance: CoastDistance, ridges: Vec<Vec<Vec2>>) -> Self {
        Self::on(Grid::above_water(domain, &coast_distance), coast_distance, ridges)
    }

    pub(super) fn on(mut grid: Grid, coast_distance: CoastDistance, ridges: Vec<Vec<Vec2>>) -> Self {
        work::count(grid.cells.len());
        let raised = grid.raise(&ridges);
        let mut regions = regions_of(&grid.runs);
        regions.iter_mut().for_each(|region| region.shores = grid.shores(region, &coast_distance));
        let borders = grid.borders();
        let hides = match (regions.len(), raised.len()) {
            (0..=1, 0) => Hides::Nothing,
            (0..=1, _) => Hides::Ridges(grid.obstacles(&raised)),
            _ => Hides::Borders,
        };
        Self { coast_distance, grid, regions, ridges, rivers: Vec::new(), borders, hides, ragged: None }
    }

    /// Sets the way in which straight coasts are ragged that a sea leaves when it rises over this land.
    pub(super) fn with_ragged(self, ragged: Ragged) -> Self {
        Self { ragged: Some(ragged), ..self }
    }

    /// Makes straight coasts ragged that a sea has left that rose over this land.
    pub(super) fn with_ragged_coasts(&self, risen: CoastDistance) -> CoastDistance {
        match self.ragged {
            Some(ragged) => ragged.applied(risen),
            None => risen,
        }
    }

    /// Takes over the drawn rivers of another land.
    pub(super) fn with_rivers_of(self, other: &Self) -> Self {
        Self { rivers: other.rivers.clone(), ..self }
    }

    /// Returns the share of the domain that is sea, by cells.
    pub(crate) fn share_of_sea(&self) -> f32 {
        1.0 - self.grid.share_of_land()
    }

    /// Returns the distances of all points from the coast.
    pub fn coast_distance(&self) -> &CoastDistance {
        &self.coast_distance
    }

    /// Returns the width and height of the domain, in units.
    pub fn size(&self) -> Vec2 {
        self.grid.size
    }

    /// Returns the connected components of land, the largest first.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// Returns the north-western and the south-eastern corner of the box around all land, in units; `None` if there is
    /// no land. The last cells may reach beyond the map.
    pub fn bounds(&self) -> Option<[Vec2; 2]> {
        around(self.regions.iter().filter_map(Region::corners))
    }

    /// Finds the connected components of water, the largest first.
    pub(crate) fn waters(&self) -> Vec<Region> {
        if self.has_ridges() {
            return regions(&self.grid.cells, Cell::Water, self.grid.columns as usize);
        }
        regions_of(&between(&self.grid.runs, self.grid.columns as u32, self.grid.rows as u32))
    }

    /// Returns `true` if any cell may be a ridge. Otherwise every cell that is not water belongs to a region.
    fn has_ridges(&self) -> bool {
        !self.ridges.is_empty()
    }

    /// Finds the connected components of all cells but water, ridges included, the largest first.
    pub(crate) fn islands(&self) -> Vec<Region> {
        if !self.has_ridges() {
            return regions_of(&self.grid.runs);
        }
        let is_land = |cell: &Cell| if *cell == Cell::Water { Cell::Water } else { Cell::Land };
        regions(&self.grid.cells.iter().map(is_land).collect::<Vec<_>>(), Cell::Land, self.grid.columns as usize)
    }

    /// Returns the amount of land around a place on the coast: 0 on a straight coast, towards 1 in a bay, towards -1 on a cape.
    pub fn shelter(&self, at: Vec2) -> f32 {
        const FAR: f32 = 30.0;
        const AROUND: [(f32, f32); 8] =
            [(1.0, 0.0), (0.7, 0.7), (0.0, 1.0), (-0.7, 0.7), (-1.0, 0.0), (-0.7, -0.7), (0.0, -1.0), (0.7, -0.7)];
        let land = |way: (f32, f32)| (self.coast_distance.height(at + Vec2::from(way) * FAR) / FAR).clamp(-1.0, 1.0);
        AROUND.into_iter().map(land).sum::<f32>() / AROUND.len() as f32
    }

    /// Returns the ridges that no river crosses, as polylines.
    pub fn ridges(&self) -> &[Vec<Vec2>] {
        &self.ridges
    }

    /// Returns the drawn courses of rivers, as polylines from their mouths.
    pub(crate) fn rivers(&self) -> &[Vec<Vec2>] {
        &self.rivers
    }

    /// Returns the cell at a point; water outside the domain.
    pub fn at(&self, point: Vec2) -> Cell {
        self.cell((point.x / CELL_SIZE).floor() as i32, (point.y / CELL_SIZE).floor() as i32)
    }

    /// Returns `true` if a river can run straight between two points of the domain, over land all the way, both ends
    /// included.
    #[inline]
    pub fn allows(&self, from: Vec2, to: Vec2) -> bool {
        let (from, to) = (from / CELL_SIZE, to / CELL_SIZE);
        let room = self.borders.room(from);
        (to - from).length_squared() <= room * room || self.borders.let_pass(from, to)
    }

    /// Returns the last point on land on the straight way from a point on land towards another. `None` if the way
    /// reaches a ridge or the border of the domain before water, or no water at all.
    pub(crate) fn coast_toward(&self, from: Vec2, to: Vec2) -> Option<Vec2> {
        /// The distance by which the way is shortened, in cells, so that rounding leaves the point on land.
        const SHORT_OF: f32 = 0.02;
        let (from, to) = (from / CELL_SIZE, to / CELL_SIZE);
        let (column, row) = walk(from, to).find(|&(column, row)| self.cell(column, row) != Cell::Land)?;
        let is_inside = (0..self.columns()).contains(&column) && (0..self.rows()).contains(&row);
        if !is_inside || self.cell(column, row) != Cell::Water {
            return None;
        }
        let way = to - from;
        let entered = |from: f32, way: f32, cell: i32| {
            let border = cell as f32 + if way < 0.0 { 1.0 } else { 0.0 };
            if way == 0.0 { 0.0 } else { (border - from) / way }
        };
        let share = entered(from.x, way.x, column).max(entered(from.y, way.y, row)) - SHORT_OF / length(way);
        let coast = (from + way * share.clamp(0.0, 1.0)) * CELL_SIZE;
        // The last cells may extend beyond the border of the domain.
        coast.cmple(self.grid.size).all().then_some(coast)
    }

    /// Returns `true` if everything within a distance of a point to the north, south, east and west is land.
    #[inline]
    pub fn is_all_land(&self, at: Vec2, distance: f32) -> bool {
        self.borders.has_room(at / CELL_SIZE, distance / CELL_SIZE)
    }

    /// Returns `true` if a point of the domain certainly [sees](Self::sees) all land within a distance.
    #[inline]
    pub fn sees_all(&self, at: Vec2, distance: f32) -> bool {
        self.hiding().is_none_or(|hiding| hiding.has_room(at / CELL_SIZE, distance / CELL_SIZE))
    }

    /// Returns `true` if no ridge lies between two points and, where there are several regions, no water. Growth in one
    /// region does not affect the others.
    pub fn sees(&self, from: Vec2, to: Vec2) -> bool {
        self.hiding().is_none_or(|hiding| hiding.let_pass(from / CELL_SIZE, to / CELL_SIZE))
    }

    #[inline]
    fn hiding(&self) -> Option<&Obstacles> {
        match &self.hides {
            Hides::Nothing => None,
            Hides::Ridges(ridges) => Some(ridges),
            Hides::Borders => Some(&self.borders),
        }
    }

    /// Returns a point of a cell: `within` runs from 0 to 1 in both directions. Points beyond the border of the domain
    /// are moved to it.
    pub fn point(&self, column: u32, row: u32, within: Vec2) -> Vec2 {
        ((Vec2::new(column as f32, row as f32) + within) * CELL_SIZE).min(self.grid.size)
    }

    /// Returns the number of columns of cells. The last one may extend beyond the border of the domain.
    pub fn columns(&self) -> i32 {
        self.grid.columns
    }

    /// Returns the number of rows of cells. The last one may extend beyond the border of the domain.
    pub fn rows(&self) -> i32 {
        self.grid.rows
    }

    /// Returns the cell at a column and row; water outside the grid.
    #[inline]
    pub fn cell(&self, column: i32, row: i32) -> Cell {
        self.grid.cell(column, row)
    }
}

/// Makes the cells and coast distances of a recipe's outline, with its lines; `None` if there is no outline, or it leaves
/// no water or hardly any land: the drawing then counts as the plain rectangle. This is the only place that decides it.
fn drawn(shape: &Shape, recipe: &Recipe) -> Option<(Grid, CoastDistance, Drawing)> {
    let drawing = Drawing::of(recipe.outline()?, shape);
    let (grid, coast_distance) = measured(shape, &drawing)?;
    Some((grid, coast_distance, drawing))
}

fn measured(shape: &Shape, drawing: &Drawing) -> Option<(Grid, CoastDistance)> {
    let coast_distance = drawing.coast_distance(&shape.domain, CoastDistance::COARSE_SPACING).without_slivers();
    let grid = Grid::above_water(&shape.domain, &coast_distance);
    (LEAST_DRAWN..1.0).contains(&grid.share_of_land()).then_some((grid, coast_distance))
}

/// Returns `true` if [`drawn`] finds a land, which mostly shows without measuring one.
fn is_drawn(recipe: &Recipe) -> bool {
    let shape = Shape::of(recipe);
    recipe.outline().is_some_and(|outline| {
        let drawing = Drawing::of(outline, &shape);
        let [land, water] = drawing.certain_cells(&shape.domain, CoastDistance::COARSE_SPACING);
        let all = Grid::cells_on(&shape.domain);
        let is_certain = land as f32 / all as f32 >= LEAST_DRAWN && water > 0;
        is_certain || measured(&shape, &drawing).is_some()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lands::lands_with_a_share_of_sea;
    use crate::recipe::{GridPoint, Outline, link};

    fn land(text: &str) -> Arc<Land> {
        Land::of(&link::read(&format!("aspect=1.5&{text}")).unwrap()).unwrap()
    }

    #[test]
    fn sea_has_the_share_asked_for() {
        for kind in lands_with_a_share_of_sea() {
            for sea in [0.1f32, 0.4, 0.8] {
                let land = land(&format!("{kind}&sea={sea}&roughness=0.5"));
                let with_ponds = Grid::above_water(&Domain::with_aspect(1.5), &land.coast_distance).cells;
                let water = with_ponds.iter().filter(|&&cell| cell == Cell::Water).count();
                let share = water as f32 / land.grid.cells.len() as f32;
                // Ponds have been filled.
                assert!((share - sea).abs() < 0.06, "{kind}: {share} is not {sea}");
            }
        }
    }

    #[test]
    fn no_land_lies_outside_its_bounds_and_some_on_each_side() {
        let land = land("seed=ra&land=island");
        let [least, most] = land.bounds().unwrap();
        assert!(least.min_element() > 0.0 && most.cmplt(Domain::with_aspect(1.5).size).all());
        let columns = land.grid.columns as usize;
        let dry = (0..land.grid.cells.len()).filter(|&cell| land.grid.cells[cell] == Cell::Land);
        let corner = |cell: usize| Vec2::new((cell % columns) as f32, (cell / columns) as f32) * CELL_SIZE;
        let around = |[a, b]: [Vec2; 2], at: Vec2| [a.min(at), b.max(at + CELL_SIZE)];
        assert_eq!(dry.map(corner).fold([Vec2::MAX, Vec2::MIN], around), [least, most]);
    }

    #[test]
    fn draft_is_the_land_but_for_details_of_its_coasts() {
        for kind in lands_with_a_share_of_sea() {
            for more in ["sea=0.3", "sea=0.7&roughness=0.4"] {
                let recipe = link::read(&format!("aspect=1.5&{kind}&{more}")).unwrap();
                let (land, draft) = (Land::of(&recipe).unwrap(), Land::draft_of(&recipe).unwrap());
                assert_eq!(land.ridges, draft.ridges);
                let cells = || land.grid.cells.iter().zip(&draft.grid.cells);
                let off = cells().filter(|(one, other)| one != other).count() as f32 / land.grid.cells.len() as f32;
                assert!(off > 0.0 && off < 0.02, "{kind}&{more}: {off}");
            }
        }
        assert!(Land::draft_of(&link::read("land=rectangle").unwrap()).is_none());
        let drawn = link::read("land=drawn&outline=.MzMzzMMzzMzMMzzM").unwrap();
        assert!(Land::of(&drawn).is_some() && Land::draft_of(&drawn) == Land::of(&drawn));
    }

    #[test]
    fn kind_of_a_drawn_land_is_that_of_its_land_and_needs_no_measuring_of_an_ordinary_one() {
        let square = |from: f32, to: f32| vec![[from, from], [to, from], [to, to], [from, to]];
        // Land that coasts pass through along every line of the lattice counts for less than it looks.
        let slits: Vec<[f32; 2]> =
            (0..40).flat_map(|i| [[i as f32 / 125.0, 0.9], [i as f32 / 125.0, 0.1], [i as f32 / 125.0, 0.9]]).collect();
        let mut rings = vec![(square(0.2, 0.8), true), (square(0.0, 1.0), false), (slits, false)];
        // Specks with nearly the least share that counts, and waters of next to no cells.
        rings.extend((0..40).map(|i| (square(0.5, 0.59 + 0.0005 * i as f32), false)));
        rings.extend((1..20).map(|i| (square(0.0, 1.0 - 0.0005 * i as f32), false)));
        let mut kinds = [0, 0];
        for (ring, is_ordinary) in rings {
            let ring = ring.into_iter().map(|at| GridPoint::nearest(at.into())).collect();
            let outline = Outline::new(vec![ring], vec![], vec![]).unwrap();
            for roughness in ["0", "0.8"] {
                let text = format!("land=drawn&aspect=1&roughness={roughness}&outline={outline}");
                let recipe = link::read(&text).unwrap();
                let before = work::steps();
                let kind = Land::kind_of(&recipe);
                assert!(!is_ordinary || work::steps() == before, "{text}");
                let is_land = Land::of(&recipe).is_some();
                assert_eq!(kind == LandKind::Drawn, is_land, "{text}");
                kinds[usize::from(is_land)] += 1;
            }
        }
        assert!(kinds[0] > 10 && kinds[1] > 10, "{kinds:?}");
    }

    #[test]
    fn islands_and_waters_are_the_connected_components_of_cells() {
        const RIDGE: &str = ".MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1..M4M4zHM4zHzHM4zHM4M4";
        let mut links = crate::lands::lands_with_a_coast();
        links.push(format!("land=drawn&outline={RIDGE}"));
        for link in links {
            let land = land(&format!("{link}&seed=kea"));
            let (cells, columns) = (&land.grid.cells, land.grid.columns as usize);
            let dry = |cell: &Cell| if *cell == Cell::Water { Cell::Water } else { Cell::Land };
            let dry: Vec<Cell> = cells.iter().map(dry).collect();
            assert!(land.waters() == regions(cells, Cell::Water, columns), "{link}");
            assert!(land.islands() == regions(&dry, Cell::Land, columns), "{link}");
        }
    }

    #[test]
    fn frame_cuts_neither_islands_nor_lakes() {
        let surrounded = ["island", "archipelago", "crescent", "twins", "long", "arms"].map(|kind| (kind, Cell::Water));
        let kinds = surrounded.into_iter().chain([("basin", Cell::Land)]);
        for ((kind, around), seed) in kinds.flat_map(|kind| (0..12).map(move |seed| (kind, seed))) {
            for sea in [0.3, 0.5, 0.7] {
                let land = land(&format!("land={kind}&seed={seed}&roughness=1&sea={sea}"));
                let across = (0..land.columns()).flat_map(|c| [(c, 0), (c, land.rows() - 1)]);
                let mut rim = across.chain((0..land.rows()).flat_map(|r| [(0, r), (land.columns() - 1, r)]));
                assert!(rim.all(|(c, r)| land.cell(c, r) == around), "{kind}, seed {seed}, sea {sea}");
            }
        }
    }

    /// Returns the middle of all water, or of all land, and the direction in which it is longest, as the angle from the
    /// east in radians.
    fn lie(land: &Land, kind: Cell) -> (Vec2, f32) {
        let cells = (0..land.columns()).flat_map(|c| (0..land.rows()).map(move |r| (c, r)));
        let at: Vec<Vec2> =
            cells.filter(|&(c, r)| land.cell(c, r) == kind).map(|(c, r)| Vec2::new(c as f32, r as f32)).collect();
        let middle = at.iter().sum::<Vec2>() / at.len() as f32;
        let off = at.iter().map(|at| *at - middle);
        let (across, along) =
            off.fold((0.0, 0.0), |(a, b), off| (a + off.x * off.y, b + off.x * off.x - off.y * off.y));
        (middle, 0.5 * libm::atan2f(2.0 * across, along))
    }

    #[test]
    fn islands_and_lakes_lie_aslant_and_off_the_centre() {
        for (kind, cell) in [("island", Cell::Land), ("basin", Cell::Water)] {
            let sea = if cell == Cell::Land { 0.7 } else { 0.3 };
            let lies = (0..8).map(|seed| lie(&land(&format!("land={kind}&roughness=0&sea={sea}&seed={seed}")), cell));
            let lies: Vec<(Vec2, f32)> = lies.collect();
            let centre = Domain::with_aspect(1.5).size / 2.0;
            let count = |is_so: &dyn Fn(&(Vec2, f32)) -> bool| lies.iter().filter(|lie| is_so(lie)).count();
            assert!(count(&|(middle, _)| middle.distance(centre) > 30.0) >= 6, "{kind}: {lies:?}");
            assert!(count(&|(_, tilt)| tilt.abs() > 0.1) >= 6, "{kind}: {lies:?}");
            assert!((2..=6).contains(&count(&|(_, tilt)| *tilt > 0.0)), "{kind}: {lies:?}");
        }
    }

    #[test]
    fn a_coast_is_as_rough_in_detail_as_asked_for() {
        // The number of squares of a size that the coast runs through.
        let squares = |land: &Land, side: f32| {
            let is_land =
                |column: i32, row: i32| land.coast_distance().height(Vec2::new(column as f32, row as f32) * side) > 0.0;
            let (columns, rows) = (land.columns() / side as i32, land.rows() / side as i32);
            let is_mixed = |&(c, r): &(i32, i32)| {
                let corners = [is_land(c, r), is_land(c + 1, r), is_land(c, r + 1), is_land(c + 1, r + 1)];
                corners.contains(&true) && corners.contains(&false)
            };
            (0..columns).flat_map(|c| (0..rows).map(move |r| (c, r))).filter(is_mixed).count() as f32
        };
        for kind in lands_with_a_share_of_sea() {
            // The ratio of the coast's length measured by 3 units to that measured by 12, the median of nine seeds.
            let longer = |roughness: f32| {
                let mut longer: Vec<f32> = (0..9)
                    .map(|seed| land(&format!("{kind}&sea=0.6&roughness={roughness}&seed={seed}")))
                    .map(|land| squares(&land, 3.0) * 3.0 / (squares(&land, 12.0) * 12.0))
                    .collect();
                longer.sort_by(f32::total_cmp);
                longer[4]
            };
            let (smooth, rough) = (longer(0.0), longer(1.0));
            assert!(smooth < 1.03 && rough > 1.08, "{kind}: {smooth}, {rough}");
        }
    }

    #[test]
    fn ridges_of_a_valley_differ_by_seed_and_are_never_ruled() {
        let ridges = |seed: u32| land(&format!("land=valley&sea=0.5&roughness=0&seed={seed}")).ridges().to_vec();
        let starts: Vec<f32> = (0..8).map(|seed| ridges(seed)[0][0].x).collect();
        assert!(starts.windows(2).all(|pair| (pair[0] - pair[1]).abs() > 1.0), "{starts:?}");
        for ridge in (0..8).flat_map(ridges) {
            let (from, to) = (ridge[0], ridge[ridge.len() - 1]);
            let off = |at: &Vec2| (to - from).normalize().perp_dot(*at - from).abs();
            assert!(ridge.iter().map(off).fold(0.0, f32::max) > 3.0, "straight from {from} to {to}");
        }
    }

    #[test]
    fn no_line_slips_through_a_diagonal_ridge() {
        let domain = Domain::with_aspect(1.0);
        let (columns, rows) = CoastDistance::corners(&domain, CoastDistance::SPACING);
        let coast_distance = CoastDistance::of_coast(&domain, CoastDistance::SPACING, &[], &vec![true; columns * rows]);
        let land = Land::new(&domain, coast_distance, vec![vec![Vec2::new(300.0, 100.0), Vec2::new(601.0, 401.0)]]);
        assert!(!land.sees(Vec2::new(500.0, 200.0), Vec2::new(400.0, 300.0)));
        assert!(land.sees(Vec2::new(500.0, 200.0), Vec2::new(600.0, 100.0)));
    }
}
