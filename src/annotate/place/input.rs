//! The input of the placement of labels and scenery.

use std::borrow::Cow;
use std::rc::Rc;
use std::sync::Arc;

use glam::Vec2;

use super::letters::Box;
use crate::annotate::names::{Names, PlaceKind, ReachName};
use crate::base::geometry::distance;
use crate::base::random::Seed;
use crate::land::{CoastDistance, Region};
use crate::network::{Network, Place};
use crate::scale::MapScale;

/// The title of a map, and what stands with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cartouche {
    /// The name of the map.
    pub title: String,
    /// The line under the title, such as the word that the map has grown from.
    pub seed: String,
    /// `true` if the title has a frame.
    pub is_framed: bool,
    /// The look of a frame.
    pub frame: Frame,
    /// `true` if there is a scale bar.
    pub has_scale: bool,
    /// The sign that tells where north is.
    pub north: Option<NorthPoint>,
    /// The plate under the title, which stands alone if there is no room for it.
    pub plate: Option<Plate>,
    /// The sheet that a neat line is drawn around, its north-western and its south-eastern corner; `None` if the picture has one already,
    /// or is to have none.
    pub sheet: Option<[Vec2; 2]>,
}

/// A frame around a title.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    /// A double line with notched corners.
    #[default]
    Rules,
    /// Lines that roll up at the corners.
    Scrolls,
}

/// A sign that tells where north is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NorthPoint {
    /// A needle beside the scale bar.
    Arrow,
    /// A star of eight points.
    Rose,
}

/// The content of a plate.
#[derive(Clone, Debug, PartialEq)]
pub enum Plate {
    /// The longest rivers, straightened, side by side, the longest first.
    Lengths(Vec<StraightRiver>),
    /// The height of the greatest river along its course.
    Profile(LongProfile),
}

/// A river, straightened.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightRiver {
    /// Its number.
    pub river: u32,
    /// Its name.
    pub name: String,
    /// The length of its course, in kilometres.
    pub kilometres: f32,
    /// Points at even distances from its end to its source: the distance by which it winds to one side there, and half its width, in units.
    pub points: Vec<[f32; 2]>,
}

/// Heights along a river.
#[derive(Clone, Debug, PartialEq)]
pub struct LongProfile {
    /// Its number.
    pub river: u32,
    /// Its name.
    pub name: String,
    /// The length of its course, in kilometres.
    pub kilometres: f32,
    /// Heights over the sea at even distances from its end to its source, in metres; none is lower than the one before.
    pub heights: Vec<f32>,
    /// Its tributaries, the greatest first.
    pub tributaries: Vec<Tributary>,
}

/// A river that joins another.
#[derive(Clone, Debug, PartialEq)]
pub struct Tributary {
    /// Its number.
    pub river: u32,
    /// Its name; empty if it has none.
    pub name: String,
    /// The place where it joins the other: the share of that one's length from its end on.
    pub share: f32,
}

/// The relief, and the scale of its heights.
#[derive(Clone, Copy, Debug)]
pub struct Elevations<'a> {
    /// The relief.
    pub heights: Heights<'a>,
    /// The metres of a unit of height.
    pub metres: f32,
    /// The least distance between places whose heights are told, in units.
    pub apart: f32,
}

/// The grid whose columns have letters along the map's edge, and its rows numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetGrid {
    /// The part of the domain that is seen, the labels' frame and the margin around it: its north-western and its south-eastern corner.
    pub sheet: [Vec2; 2],
    /// The distance between lines, in units; the first are the domain's western and northern side.
    pub every: f32,
    /// The length of its letters' em.
    pub em: f32,
}

impl SheetGrid {
    /// The width of its margin, which all else keeps off, in ems.
    pub const MARGIN: f32 = 1.6;
    /// The length of its em on large pictures, in units.
    pub const EM: f32 = 11.0;
    /// The most with which there is a grid, in units.
    pub const MOST_EM: f32 = 30.0;
}

/// Rivers of one order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiverClass {
    /// Strahler's order.
    pub order: u8,
    /// The number of such rivers.
    pub count: u32,
    /// Half of their width at their ends, on average, in units.
    pub half: f32,
}

/// A box with facts about a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// The name of the map, and the line under it; `None` where the cartouche has both.
    pub heading: Option<[String; 2]>,
    /// Its rivers, those of the highest order first.
    pub classes: Vec<RiverClass>,
}

/// A painter's seal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Seal {
    /// One letter or two.
    pub letters: String,
    /// The seed of the chances by which its edge is uneven.
    pub seed: Seed,
}

/// The marks that a style has on its maps besides names.
#[derive(Clone, Debug, Default)]
pub struct Marks<'a> {
    /// The relief; `None` if no heights are told.
    pub elevations: Option<Elevations<'a>>,
    /// `true` if large pictures of the whole map have a grid with letters.
    pub has_grid: bool,
    /// The grid; `None` if this picture has none, or has no room for its letters.
    pub grid: Option<SheetGrid>,
    /// The legend.
    pub legend: Option<Legend>,
    /// The seal.
    pub seal: Option<Seal>,
}

/// A thing that a person has named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Own {
    /// The river of a number.
    River(usize),
    /// The reach of the river of a number.
    Reach(usize),
    /// A place, by the number in its mark.
    Place(PlaceKind, u32),
}

/// What it takes a while to find out about a map, and is the same whatever part of it a picture shows.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    /// The names of rivers, reaches and places.
    pub names: Arc<Names>,
    /// The region of each place; empty for those that are no sea, lake or island.
    pub regions: Arc<[Region]>,
    /// The distance of each point from the nearest shore, of the sea or of a lake; `None` if there are no lakes.
    pub shoreline: Option<Arc<CoastDistance>>,
}

/// The part of the input that is the same for pictures of all sizes: a map with its names. Lengths are units.
#[derive(Debug)]
pub struct MapInput<'a> {
    /// The real sizes of what is on the map.
    pub scale: MapScale,
    /// The centerline of each river, from the source, with its banks.
    pub courses: Vec<Vec<Place>>,
    /// The discharge of each river at its end.
    pub discharges: Vec<u32>,
    /// The discharge of all rivers together.
    pub total_discharge: u32,
    /// The names of rivers, reaches and places.
    pub names: Arc<Names>,
    /// What has an own name: rivers, the greatest first, then reaches and places.
    pub own: Vec<Own>,
    /// The region of each place; empty for those that are no sea, lake or island.
    pub regions: Arc<[Region]>,
    /// Lakes that rivers have left, which only letters of reaches may touch.
    pub lakes: Vec<Vec<Place>>,
    /// Ridges, which no letter may touch.
    pub ridges: Vec<Vec<Place>>,
    /// The distance of each point from the nearest shore, of the sea or of a lake; `None` if there are no lakes.
    pub shoreline: Option<Arc<CoastDistance>>,
    /// The distance of each point from the coast of the sea; `None` if there is none.
    pub sea: Option<&'a CoastDistance>,
    /// The title; `None` if it is to have none.
    pub cartouche: Option<Cartouche>,
    /// The marks besides names.
    pub marks: Marks<'a>,
}

/// A reach: its name, and its part of its river's course.
pub type Reach<'a> = (&'a ReachName, &'a [Place]);

impl MapInput<'_> {
    /// Returns the distance of each point from the nearest shore; `None` if there is none.
    pub fn coast(&self) -> Option<&CoastDistance> {
        self.shoreline.as_deref().or(self.sea)
    }

    /// Returns the reaches that have a course, the one with the most water first.
    pub fn reaches(&self) -> Vec<Reach<'_>> {
        let mut reaches = Vec::new();
        for reach in &self.names.reaches {
            let [Some(first), Some(last)] = [reach.course.first(), reach.course.last()] else { continue };
            let Some(course) = self.courses.get(reach.river as usize) else { continue };
            let [Some(first), Some(last)] = [first, last].map(|end| nearest(course, *end)) else { continue };
            reaches.extend(course.get(first..=last).map(|course| (reach, course)));
        }
        reaches
    }
}

/// Returns the number of the place of a course that is nearest to a point; `None` if the course has no places.
fn nearest(course: &[Place], point: Vec2) -> Option<usize> {
    (0..course.len()).min_by(|&a, &b| distance(course[a].at, point).total_cmp(&distance(course[b].at, point)))
}

/// A map that labels are wanted for, on a picture of one size. Lengths are units.
#[derive(Clone, Debug)]
pub struct Input<'a> {
    /// The map, with all that does not depend on the picture's size.
    pub map: Rc<MapInput<'a>>,
    /// The part of the domain that labels may stand in: its north-western and its south-eastern corner.
    pub frame: [Vec2; 2],
    /// The part of the frame that the picture shows, its two corners: what reaches beyond that is left out.
    pub view: [Vec2; 2],
    /// The em of the smallest letters that can be read, before it is multiplied by the factor of their size.
    pub least_em: f32,
    /// The factor of the sizes of letters.
    pub label_size: f32,
    /// The factor of the sizes of letters on the whole map. It is not computed from `label_size` and `shrink`: rounding would make other
    /// choices of places.
    pub whole_size: f32,
    /// The share of `label_size` that is due to the view being a part of the map; 1 for the whole map.
    pub shrink: f32,
    /// `true` if no river has more than one label.
    pub is_one_each: bool,
    /// The greatest area that the labels of rivers cover on land, in square units, and the greatest that those of lakes and islands cover
    /// on the water. Where labels may cover no land there are none.
    pub most_area: [f32; 2],
    /// The greatest number of labels of bays, of capes and of straits each.
    pub most_landmarks: usize,
}

impl Input<'_> {
    /// Returns the em of letters whose usual em is `usual`, in units: at least `over_least` times that of the smallest letters that can be
    /// read.
    pub fn em(&self, usual: f32, over_least: f32) -> f32 {
        usual.max(over_least * self.least_em) * self.label_size
    }

    /// Returns the usual sizes without those that make letters as large as the one before.
    pub fn sizes(&self, usual: &[f32], over_least: f32) -> Vec<f32> {
        let mut sizes = usual.to_vec();
        sizes.dedup_by_key(|usual| self.em(*usual, over_least));
        sizes
    }

    /// Returns the frame in pictures of this size: the letters of a grid take more of small ones.
    pub fn inner_frame(&self) -> [Vec2; 2] {
        let em = self.em(SheetGrid::EM, 1.0);
        let has_grid = self.map.marks.has_grid && em <= SheetGrid::MOST_EM;
        let margin = if has_grid { (SheetGrid::MARGIN * (em - SheetGrid::EM)).max(0.0) } else { 0.0 };
        let [least, most] = self.frame;
        [least + margin, most - margin]
    }

    /// Returns `true` if a place is in that frame, so far from its sides, in units.
    pub fn is_in_frame(&self, at: Vec2, margin: f32) -> bool {
        let [least, most] = self.inner_frame();
        at.cmpge(least + margin).all() && at.cmple(most - margin).all()
    }

    /// Returns the em of the smallest letters that can be read, in units.
    pub fn least(&self) -> f32 {
        self.least_em * self.shrink
    }

    /// Returns the part of the domain that is seen: its north-western and its south-eastern corner.
    pub fn sheet(&self) -> [Vec2; 2] {
        self.map.marks.grid.map_or(self.view, |grid| grid.sheet)
    }
}

/// The heights of the land, cell by cell, row by row from the map's north-western corner on.
#[derive(Clone, Copy, Debug)]
pub struct Heights<'a> {
    /// Heights over the sea, in units.
    pub heights: &'a [f32],
    /// The number of cells of a row.
    pub columns: usize,
    /// The side of a cell, in units.
    pub cell_size: f32,
    /// The height that counts as the highest.
    pub highest: f32,
}

/// The climate that plants grow in.
#[derive(Clone, Debug)]
pub struct Weather {
    /// The warmth and the rain of the whole map, from 0 to 1.
    pub warmth: f32,
    pub rain: f32,
    /// How much more rain falls in each cell of a grid, or less; empty if rain falls evenly.
    pub deviations: Vec<f32>,
    /// The number of cells of a row, and the side of a cell in units.
    pub columns: usize,
    pub cell_size: f32,
}

impl Weather {
    /// Makes a climate whose rain falls evenly.
    pub fn even(warmth: f32, rain: f32) -> Self {
        Self { warmth, rain, deviations: Vec::new(), columns: 0, cell_size: 1.0 }
    }

    /// Returns how much more rain falls at a place than on the whole map, or less.
    pub fn more_rain(&self, at: Vec2) -> f32 {
        if self.deviations.is_empty() {
            return 0.0;
        }
        let [column, row] = [at.x, at.y].map(|along| (along / self.cell_size) as usize);
        self.deviations.get(row * self.columns + column).copied().unwrap_or(0.0)
    }
}

/// A map that woods and hills are wanted for. Lengths are units.
#[derive(Clone, Debug)]
pub struct SceneryInput<'a> {
    /// Width and height of the domain.
    pub size: Vec2,
    /// The seed of all chances.
    pub seed: Seed,
    /// The share of the land that is wooded, from 0 to 1.
    pub woods: f32,
    /// The density of hills, from 0 to 1.
    pub hills: f32,
    /// The climate.
    pub weather: Weather,
    /// The rivers.
    pub network: &'a Network,
    /// Lakes that rivers have left.
    pub lakes: Vec<Vec<Place>>,
    /// Ridges, which are drawn in strokes of their own.
    pub ridges: Vec<Vec<Place>>,
    /// The distance of each point from the nearest shore, of the sea or of a lake; `None` if there is neither.
    pub coast: Option<Cow<'a, CoastDistance>>,
    /// The relief; `None` if it is not known.
    pub heights: Option<Heights<'a>>,
    /// The boxes of all letters on the map, and of what stands with them.
    pub letters: Vec<Box>,
}

impl SceneryInput<'_> {
    /// Returns the distance of each point from the nearest shore; `None` if there is none.
    pub fn coast(&self) -> Option<&CoastDistance> {
        self.coast.as_deref()
    }
}
