//! Rasters: values of each cell of the relief, for programs that make landscapes from them.

use std::num::NonZero;
use std::ops::Range;
use std::sync::Arc;

use glam::Vec2;

use super::levels::Levels;
pub use super::levels::Scale;
use super::{ExportError, rivers};
use crate::analyse::statistics::Drained;
use crate::base::memory;
use crate::deltas::{Deltas, Distributary};
use crate::domain::Domain;
use crate::map::Map;
use crate::network::{NONE, Network, Place, Vertex};
use crate::recipe::link;
use crate::relief::{Flow, Grid, Relief, ReliefError, ReliefSettings};
use crate::scale::MapScale;

const BYTES_A_VERTEX: usize = 40;

/// The keyword of the text that holds the link, in every PNG.
pub const LINK_KEYWORD: &str = "riverseed";

/// The values of a map's cells, with their scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Rasters {
    /// The link of the recipe.
    pub link: String,
    /// Number of cells in a row. The last one of the map may reach beyond its border.
    pub columns: usize,
    /// Number of rows of cells.
    pub rows: usize,
    /// The side of a cell, in units.
    pub cell_size: f32,
    /// Width and height of the map, in units. The last cells may reach beyond it.
    pub size: Vec2,
    /// The scale of written heights.
    pub scale: Scale,
    /// The real sizes of what is on the map.
    pub map_scale: MapScale,
    /// The surface of the relief: the water where there is a lake.
    relief: Arc<Relief>,
    flow: Flow,
    /// The lake of each cell, [`NONE`] elsewhere; empty if there are none.
    lakes: Vec<u32>,
    /// The cells that lakes cover, each with the depth of the water over its bed, in units.
    depths: Vec<(u32, f32)>,
    /// The number of columns west of the map and of rows north of it.
    before: (usize, usize),
    /// The height of each cell in steps of the scale.
    steps: Vec<u16>,
    network: Arc<Network>,
    deltas: Arc<Deltas>,
    drained: Drained,
}

/// One of the rasters. Not `#[non_exhaustive]`: each is a form of file, for which the compiler is to ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// Heights, in steps of the scale.
    Heights,
    /// 255 on land, 0 at sea.
    Land,
    /// The width of rivers and their branches in thousandths of a unit, 0 elsewhere. Thousandths are fine enough, and large enough that
    /// the raster does not look all black.
    Rivers,
    /// Flow directions (D8).
    Flow,
    /// The numbers of basins.
    Basins,
    /// 255 where water stands, in the sea or in a lake; 0 on dry land and in rivers.
    Water,
    /// The depth of standing water, in steps of the scale of heights.
    Depth,
}

/// The values of a raster, row by row, from north to south.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Values {
    /// One byte per cell.
    Bytes(Vec<u8>),
    /// Two bytes per cell.
    Words(Vec<u16>),
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 7] =
        [Self::Heights, Self::Land, Self::Rivers, Self::Flow, Self::Basins, Self::Water, Self::Depth];

    /// Returns the subject of a layer's values, in English. [`Rasters::meaning`] begins with these words, and no two
    /// layers have the same.
    pub fn subject(self) -> &'static str {
        match self {
            Self::Heights => "16-bit heights",
            Self::Land => "255 is land",
            Self::Rivers => "16-bit width of the river",
            Self::Flow => "Where water runs",
            Self::Basins => "16-bit number of the river basin",
            Self::Water => "255 is standing water",
            Self::Depth => "16-bit depth of water",
        }
    }

    /// Returns the layer's name, as in `kauri.heights.png`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Heights => "heights",
            Self::Land => "land",
            Self::Rivers => "rivers",
            Self::Flow => "flow",
            Self::Basins => "basins",
            Self::Water => "water",
            Self::Depth => "depth",
        }
    }
}

impl Rasters {
    /// Makes the rasters of a map on its own grid, where a pixel is 2 x 2 units.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn new(map: &Map) -> Result<Self, ExportError> {
        let network = rivers(map, BYTES_A_VERTEX)?;
        Self::of(map, network, map.make_relief()?, &map.relief_settings())
    }

    /// Makes rasters with `size` pixels on the longer side, from those of the map's own grid (500 for a square map) to
    /// [`Grid::MOST`]. Rivers are as high as on that grid, except where they would stand on dams; hillsides are solved
    /// anew.
    ///
    /// # Errors
    /// Fails if rasters of this map cannot have that size, or if there is not enough memory: about 30 bytes per pixel.
    pub fn with_size(map: &Map, size: u32) -> Result<Self, ExportError> {
        Self::with_size_on(map, size, NonZero::<usize>::MIN)
    }

    /// Makes rasters like [`Rasters::with_size`] on a number of threads; the result does not depend on it.
    ///
    /// # Errors
    /// Fails like [`Rasters::with_size`].
    pub fn with_size_on(map: &Map, size: u32, threads: NonZero<usize>) -> Result<Self, ExportError> {
        let network = rivers(map, BYTES_A_VERTEX)?;
        let mut settings = map.relief_settings();
        let grid = Self::grid(&settings.domain, size)?;
        let own = map.make_relief()?;
        if grid == settings.grid {
            return Self::of(map, network, own, &settings);
        }
        (settings.grid, settings.threads) = (grid, threads);
        let finer = own.on_grid_of(network, settings.clone())?;
        Self::of(map, network, finer.into(), &settings)
    }

    /// Makes the grid of rasters with `size` pixels on the longer side.
    ///
    /// # Errors
    /// Fails if rasters of this map cannot have that size.
    pub fn grid(domain: &Domain, size: u32) -> Result<Grid, ExportError> {
        let sizes = Grid::sizes(domain);
        let refused = ExportError::RasterSize { size, least: *sizes.start(), most: *sizes.end() };
        Grid::with_longer_side(domain, size).ok_or(refused)
    }

    fn of(map: &Map, network: &Network, relief: Arc<Relief>, settings: &ReliefSettings) -> Result<Self, ExportError> {
        let flow = Flow::new(&relief, network, settings)?;
        let (grid, lakes) = (relief.grid(), map.lakes());
        let covered = lakes.on(&grid);
        let next = |cell: usize| flow.next(&grid, cell);
        let depths = lakes.depths(&relief, &covered);
        let relief = match lakes.is_empty() {
            true => relief,
            false => lakes.fill(Arc::unwrap_or_clone(relief), &covered, next).into(),
        };
        let map_scale = map.scale();
        let levels = Levels::new(relief.heights(), map_scale.metres_up.into(), next, &covered);
        let Levels { scale, steps } = levels.map_err(|_| out_of_memory(4 * relief.heights().len()))?;
        Ok(Self {
            link: link::write_for_file(map.recipe()),
            columns: relief.columns(),
            rows: relief.rows(),
            cell_size: relief.cell_size(),
            size: map.domain().size,
            scale,
            map_scale,
            steps,
            network: map.network().clone(),
            deltas: map.deltas().clone(),
            drained: Drained::of(map),
            relief,
            flow,
            lakes: covered,
            depths,
            before: (0, 0),
        })
    }

    /// Widens the rasters to squares, with the map in the middle and sea around it.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn into_squares(self) -> Result<Self, ExportError> {
        let side = self.columns.max(self.rows);
        // A raster is made, and copied by whoever writes it.
        let bytes = 2 * size_of::<u16>() * side * side;
        if !memory::can_allocate(bytes) {
            return Err(out_of_memory(bytes));
        }
        let before = ((side - self.columns) / 2, (side - self.rows) / 2);
        Ok(Self { columns: side, rows: side, before, ..self })
    }

    /// Returns the columns and rows of the map itself; `None` if it fills the rasters.
    pub fn part(&self) -> Option<[Range<usize>; 2]> {
        let (columns, rows) = (self.relief.columns(), self.relief.rows());
        let (west, north) = self.before;
        ((columns, rows) != (self.columns, self.rows)).then_some([west..west + columns, north..north + rows])
    }

    /// Makes the values of a layer's raster, row by row.
    pub fn values(&self, layer: Layer) -> Values {
        match (self.values_of_map(layer), layer) {
            (values, _) if self.part().is_none() => values,
            // The floor of the sea goes on, and land ends at the sea's surface.
            (Values::Words(steps), Layer::Heights) => {
                Values::Words(self.widened(&steps, |nearest| nearest.min(self.scale.sea_level)))
            }
            (Values::Bytes(bytes), Layer::Water) => Values::Bytes(self.widened(&bytes, |_| 255)),
            (Values::Words(depths), Layer::Depth) => {
                let depths: Vec<_> =
                    depths.into_iter().zip(self.steps.iter().map(|&step| self.depth_at_sea(step))).collect();
                let widened = self.widened(&depths, |(_, at_sea)| (at_sea, at_sea));
                Values::Words(widened.into_iter().map(|(depth, _)| depth).collect())
            }
            (Values::Words(words), _) => Values::Words(self.widened(&words, |_| 0)),
            (Values::Bytes(bytes), _) => Values::Bytes(self.widened(&bytes, |_| 0)),
        }
    }

    /// Puts values of the map into the raster; `beyond` makes a value outside of the map from the nearest one inside.
    fn widened<T: Copy>(&self, values: &[T], beyond: impl Fn(T) -> T) -> Vec<T> {
        let (west, north) = self.before;
        let (columns, rows) = (self.relief.columns(), self.relief.rows());
        let cells = (0..self.rows).flat_map(|row| (0..self.columns).map(move |column| (column, row)));
        let value = |(column, row): (usize, usize)| {
            let inside = (column.saturating_sub(west).min(columns - 1), row.saturating_sub(north).min(rows - 1));
            let nearest = values[inside.1 * columns + inside.0];
            if (column, row) == (inside.0 + west, inside.1 + north) { nearest } else { beyond(nearest) }
        };
        cells.map(value).collect()
    }

    fn values_of_map(&self, layer: Layer) -> Values {
        match layer {
            Layer::Heights => Values::Words(self.steps.clone()),
            Layer::Land => {
                let heights = self.relief.heights().iter();
                Values::Bytes(heights.map(|&height| if height > 0.0 { 255 } else { 0 }).collect())
            }
            Layer::Rivers => {
                let widths = widths(&self.relief, &self.flow, (&self.network, &self.deltas), Vertex::width);
                Values::Words(widths.into_iter().map(thousandths).collect())
            }
            Layer::Flow => Values::Bytes(self.flow.directions.clone()),
            Layer::Water => {
                let is_water = |(cell, &height): (usize, &f32)| {
                    height <= 0.0 || self.lakes.get(cell).is_some_and(|lake| *lake != NONE)
                };
                let heights = self.relief.heights().iter().enumerate();
                Values::Bytes(heights.map(|cell| if is_water(cell) { 255 } else { 0 }).collect())
            }
            Layer::Depth => {
                let step_units = self.scale.metres_a_step / f64::from(self.map_scale.metres_up);
                let depth = |(cell, &step): (usize, &u16)| match self.depth(cell) {
                    0.0 => self.depth_at_sea(step),
                    depth => (f64::from(depth) / step_units).round() as u16,
                };
                Values::Words(self.steps.iter().enumerate().map(depth).collect())
            }
            Layer::Basins => Values::Words(self.flow.basins.iter().map(|&basin| basin.min(65_535) as u16).collect()),
        }
    }

    /// Writes what the values of a layer's raster mean, in English.
    pub fn meaning(&self, layer: Layer) -> String {
        let Scale { sea_level, metres_a_step, .. } = self.scale;
        let more = match layer {
            Layer::Heights => format!(
                ": metres above the sea = (value - {sea_level}) * {}. \
                 0 is the deepest place, {sea_level} the sea's surface.",
                decimal(metres_a_step, 6)
            ),
            Layer::Depth => {
                format!(" in the sea and in lakes: metres = value * {}. 0 where there is none.", decimal(metres_a_step, 6))
            }
            Layer::Land => ", 0 is sea.".into(),
            Layer::Water => ", of the sea or of a lake; 0 is dry land and rivers.".into(),
            Layer::Rivers => format!(
                " as it is drawn, in thousandths of a unit (a pixel is {} wide), 0 where there is none.",
                shortest(f64::from(self.cell_size) * 1000.0, 3)
            ),
            Layer::Flow => " (D8, as ESRI writes it): 1 east, 2 south-east, 4 south, 8 south-west, 16 west, \
                            32 north-west, 64 north, 128 north-east, 0 at sea. At the map's border it may lead off the map."
                .into(),
            Layer::Basins => ", counted from 1; 0 at sea, and where water runs to the sea in no river.".into(),
        };
        format!("{}{more}", layer.subject())
    }

    /// Writes the texts for a layer's file, with their keywords, in ASCII.
    pub fn texts(&self, layer: Layer) -> Vec<(&'static str, String)> {
        let mut texts = vec![
            (LINK_KEYWORD, self.link.clone()),
            ("Description", self.meaning(layer)),
            ("units-a-pixel", shortest(self.cell_size.into(), 6)),
            ("metres-a-pixel", shortest(self.metres_a_pixel(), 4)),
            ("map-units", format!("{} x {}", decimal(self.size.x.into(), 4), decimal(self.size.y.into(), 4))),
        ];
        if let Some([columns, rows]) = self.part() {
            texts.push((
                "map-pixels",
                format!("{} x {} from {}, {}", columns.len(), rows.len(), columns.start, rows.start),
            ));
        }
        if matches!(layer, Layer::Heights | Layer::Depth) {
            texts.push(("metres-a-step", decimal(self.scale.metres_a_step, 6)));
        }
        if layer == Layer::Heights {
            texts.push(("sea-level", self.scale.sea_level.to_string()));
        }
        texts
    }

    /// Returns the side of a pixel, in metres.
    pub fn metres_a_pixel(&self) -> f64 {
        f64::from(self.cell_size) * self.map_scale.metres_a_unit
    }

    /// Returns the flow directions and basins of the map's cells.
    pub fn flow(&self) -> &Flow {
        &self.flow
    }

    /// Computes how wide a river of nature is that drains as much land, in metres, for each cell of the map that a river is drawn in; 0
    /// elsewhere.
    pub fn real_widths(&self) -> Vec<f32> {
        // Where it is drawn with no width, at its very source, it has none.
        let width = |vertex: &Vertex| match vertex.width() {
            0.0 => 0.0,
            _ => self.drained.river_width(vertex.discharge) as f32,
        };
        widths(&self.relief, &self.flow, (&self.network, &self.deltas), width)
    }

    /// Returns the index of the lake of each cell of the map, [`NONE`] elsewhere; empty if there are no lakes.
    pub fn lakes(&self) -> &[u32] {
        &self.lakes
    }

    /// Returns the depth of a lake over its bed in a cell of the map, in units; 0 where there is no lake.
    pub fn depth(&self, cell: usize) -> f32 {
        // A look at the lakes tells nearly all cells, a search only those under water.
        let covered = self.lakes.get(cell).filter(|lake| **lake != NONE);
        let place = covered.and_then(|_| self.depths.binary_search_by_key(&(cell as u32), |water| water.0).ok());
        place.map_or(0.0, |place| self.depths[place].1)
    }

    /// Returns the depth of the sea over ground of a height, both in steps of the scale; 0 on land.
    fn depth_at_sea(&self, step: u16) -> u16 {
        self.scale.sea_level.saturating_sub(step)
    }

    /// Computes the depth of standing water in each cell of the map, in metres; 0 on dry land and in rivers.
    pub fn metres_of_water(&self) -> Vec<f32> {
        let at_sea = self.relief.heights().iter().map(|&height| (-height).max(0.0));
        at_sea.enumerate().map(|(cell, sea)| self.depth(cell).max(sea) * self.map_scale.metres_up).collect()
    }

    /// Returns the relief that the rasters are made from, with lakes as high as their water.
    pub fn relief(&self) -> &Relief {
        &self.relief
    }
}

fn out_of_memory(bytes: usize) -> ExportError {
    ExportError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 }
}

/// Writes a number with this number of decimal places. The standard library's tables for printing any float would be a
/// fifth of a page's download.
pub(super) fn decimal(number: f64, places: u32) -> String {
    let parts = 10u64.pow(places);
    let rounded = (number.abs() * parts as f64).round() as u64;
    let sign = if number < 0.0 && rounded > 0 { "-" } else { "" };
    let whole = rounded / parts;
    match places {
        0 => format!("{sign}{whole}"),
        _ => format!("{sign}{whole}.{:0width$}", rounded % parts, width = places as usize),
    }
}

/// Writes a number like `decimal`, but without decimal places if it is whole.
pub(super) fn shortest(number: f64, places: u32) -> String {
    decimal(number, if number.fract() == 0.0 { 0 } else { places })
}

/// Returns a width in thousandths of a unit, rounded up so that it stays above 0.
fn thousandths(width: f32) -> u16 {
    (width * 1000.0).ceil().clamp(0.0, f32::from(u16::MAX)) as u16
}

/// Returns for each cell the greatest of the widths, as `of` has them, of rivers and their branches that pass it or have its middle
/// between their drawn banks; 0 where there is none.
fn widths(
    relief: &Relief,
    flow: &Flow,
    (network, deltas): (&Network, &Deltas),
    of: impl Fn(&Vertex) -> f32,
) -> Vec<f32> {
    let mut widths = vec![0.0f32; relief.heights().len()];
    let mut trace = |course: &[Vertex]| {
        for pair in course.windows(2) {
            let (from, to) = (&pair[0], &pair[1]);
            let count = (from.at.distance(to.at) / (0.5 * relief.cell_size())).ceil().max(1.0);
            for i in 0..=count as usize {
                let share = i as f32 / count;
                stamp(relief, &mut widths, from.at.lerp(to.at, share), (from.width(), of(from)));
            }
        }
    };
    network.rivers.iter().for_each(|river| trace(&network.course(river).copied().collect::<Vec<_>>()));
    deltas.distributaries.iter().for_each(|branch| trace(&vertices(network, branch)));
    for (width, &river) in widths.iter_mut().zip(&flow.rivers) {
        // The river's path may take a corner that its line misses.
        let least = network.rivers.get(river as usize).map_or(0.0, |river| of(&network.vertices[river.start as usize]));
        *width = width.max(least);
    }
    widths
}

/// Returns the vertices that a branch would have as a river of its share of the water.
fn vertices(network: &Network, branch: &Distributary) -> Vec<Vertex> {
    let trunk = network.discharge(&network.rivers[branch.river as usize]);
    let discharge = (trunk as f32 * branch.share).round() as u32;
    let vertex =
        |place: &Place| Vertex { at: place.at, left: place.half, right: place.half, discharge, ..Vertex::default() };
    branch.line.iter().map(vertex).collect()
}

/// Marks the cells of a river of this width at a point, with the width that is told.
fn stamp(relief: &Relief, widths: &mut [f32], at: Vec2, (width, told): (f32, f32)) {
    let last = Vec2::new(relief.columns() as f32 - 1.0, relief.rows() as f32 - 1.0);
    let cell = |point: Vec2| (point / relief.cell_size()).floor().clamp(Vec2::ZERO, last);
    let (first, end, own) = (cell(at - width * 0.5), cell(at + width * 0.5), cell(at));
    for row in first.y as usize..=end.y as usize {
        for column in first.x as usize..=end.x as usize {
            let here = Vec2::new(column as f32, row as f32);
            let index = row * relief.columns() + column;
            let is_between = ((here + 0.5) * relief.cell_size()).distance(at) <= width * 0.5;
            if (is_between || here == own) && relief.heights()[index] > 0.0 {
                widths[index] = widths[index].max(told);
            }
        }
    }
}

impl From<ReliefError> for ExportError {
    fn from(error: ReliefError) -> Self {
        match error {
            ReliefError::OutOfMemory { megabytes } => Self::OutOfMemory { megabytes },
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use crate::base::memory::testing::with_lists_up_to;
    use crate::session::Session;

    #[test]
    fn rasters_are_refused_where_there_is_no_memory_for_them() {
        let map = Session::new(link::read("attractors=300&style=atlas").unwrap()).unwrap().finish().unwrap();
        // This is enough for the rivers; the relief exists already.
        let refused = with_lists_up_to(3_000_000, || Rasters::new(&map)).unwrap_err();
        assert!(matches!(refused, ExportError::OutOfMemory { megabytes } if megabytes > 3), "{refused}");
        assert!(Rasters::new(&map).is_ok());
        // A finer relief than the existing one has to be made.
        let refused = with_lists_up_to(50_000_000, || Rasters::with_size(&map, 2048)).unwrap_err();
        assert!(matches!(refused, ExportError::OutOfMemory { megabytes } if megabytes > 50), "{refused}");
        let wide = Rasters::with_size(&map, 700).unwrap();
        let refused = with_lists_up_to(1_000_000, || wide.into_squares()).unwrap_err();
        assert!(matches!(refused, ExportError::OutOfMemory { .. }), "{refused}");
    }

    #[test]
    fn decimals_are_rounded_and_keep_their_zeros() {
        let written = [(0.077_964_4, 6), (-559.25, 1), (2.0, 0), (-0.04, 1), (1_264.911_06, 4), (0.999_96, 4)];
        let expected = ["0.077964", "-559.3", "2", "0.0", "1264.9111", "1.0000"];
        assert_eq!(written.map(|(number, places)| decimal(number, places)), expected);
    }
}
