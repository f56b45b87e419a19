//! The labels of a map, and the input of their placement.

use std::borrow::Cow;
use std::rc::Rc;
use std::sync::Arc;

use glam::Vec2;

use crate::annotate::glyph::initials;
use crate::annotate::names::{self, Names};
use crate::annotate::place::{
    Cartouche, Elevations, Frame, Heights, Input, Known, Label, Legend, MapInput, Marks, NorthPoint, Own, Places,
    Plate, Raster, RiverClass, SHEET_MARGIN, Seal, SheetGrid,
};
use crate::annotate::plates;
use crate::base::memory;
use crate::base::random::Seed;
use crate::domain::{AREA, Domain};
use crate::land::{CoastDistance, Land, Region, margin_of};
use crate::map::Map;
use crate::network::{Network, Oxbow, Place};
use crate::recipe::Shown;
use crate::recipe::{self, Labels, Mark, NumberKey, Recipe, Style};
use crate::relief::Relief;

/// The em of the smallest letters that can be read, in pixels.
pub(crate) const LEAST_EM: f32 = 11.0;
/// The least share of a map that letters are made for: they have no size in a view of none of it.
const LEAST_SHOWN: f32 = 1e-4;

/// Returns a picture's pixels to a CSS pixel as letters take them: in quarters, from 0.5 to 4.
pub(crate) fn quartered(ratio: f32) -> f32 {
    ((ratio * 4.0).round() / 4.0).clamp(0.5, 4.0)
}

/// Places the labels of a picture that shows a part of the map, given by its north-western and south-eastern corner, with `scale` pixels to
/// a unit: the greatest rivers first. Returns none if the recipe wants none, or if there is not enough memory.
pub(crate) fn labels(map: &Map, frame: [Vec2; 2], scale: f32) -> Vec<Label> {
    labels_in(&mut Places::default(), map, frame, scale)
}

/// Places the labels of a picture like [`labels`], where other pictures of the same map have them already.
pub(crate) fn labels_in(places: &mut Places, map: &Map, frame: [Vec2; 2], scale: f32) -> Vec<Label> {
    let input = input_with(&mut places.known, map, frame, scale);
    input.map_or_else(Vec::new, |input| places.place(&input, &Raster::new(&input)))
}

/// Finds out what all pictures of a map have to know about it, names above all, unless that is known. Returns `true` if it was not.
pub(crate) fn find_out(places: &mut Places, map: &Map) -> bool {
    let is_new = places.known.is_none() && (share_of_land(map.recipe().get()) > 0.0 || map.recipe().has_title());
    if is_new {
        places.known = Some(found_out(map));
    }
    is_new
}

/// Gathers the input of the placement of labels; `None` if the recipe wants no labels, or if there is not enough memory.
pub fn input(map: &Map, frame: [Vec2; 2], scale: f32) -> Option<Input<'_>> {
    input_with(&mut None, map, frame, scale)
}

/// Gathers the input of the placement of labels with what is known about the map; what is not is found out.
fn input_with<'a>(known: &mut Option<Known>, map: &'a Map, frame: [Vec2; 2], scale: f32) -> Option<Input<'a>> {
    /// The memory of a vertex: its place in a course, its piece with a box, and its share of a stretch of pieces and of a name.
    const BYTES_A_VERTEX: usize = 140;
    let (recipe, network, land) = (map.recipe(), map.network(), map.land());
    let share = share_of_land(recipe.get());
    if share == 0.0 && !recipe.has_title() {
        return None;
    }
    if !memory::can_allocate(Raster::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
        return None;
    }
    let known = known.get_or_insert_with(|| found_out(map)).clone();
    let least_em = LEAST_EM / scale;
    let marks = if share > 0.0 { marks(map, &known.names, frame, least_em) } else { Marks::default() };
    let margin = marks.grid.map_or(0.0, |grid| SheetGrid::MARGIN * grid.em);
    let within = on_map(map).map(|corner| corner.clamp(Vec2::ZERO, map.domain().size));
    let cut = cut_to_shape(&map.domain(), frame);
    // Places are chosen for the whole map: with the margin of a whole map's picture, if it has one.
    let whole = if marks.has_grid { SheetGrid::MARGIN * SheetGrid::EM } else { 0.0 };
    let land_area = land.map_or(AREA, |land| area(land));
    let shown = share_shown(&map.domain(), frame);
    // Of a part, letters are larger than on the whole map, but not as much as all else: there is room for more of them.
    let side = shown.max(LEAST_SHOWN).sqrt();
    let shrink = side.sqrt() * side.sqrt().sqrt();
    Some(Input {
        map: Rc::new(map_input(map, frame, known, marks)),
        frame: [within[0].max(cut[0] + whole), within[1].min(cut[1] - whole)],
        view: [frame[0] + margin, frame[1] - margin],
        least_em: least_em / shrink,
        label_size: recipe.number(NumberKey::LabelSize) * shrink,
        whole_size: recipe.number(NumberKey::LabelSize),
        shrink,
        is_one_each: recipe.get::<Labels>() == Labels::Few,
        most_area: [land_area, AREA - land_area].map(|area| share * area),
        most_landmarks: match recipe.get() {
            Labels::None => 0,
            Labels::Few => 2,
            Labels::Some => 4,
            Labels::Many => 8,
        },
    })
}

/// Names what is on a map, with the regions of places; the country only by words that the type has, unless a person has given its name.
pub(crate) fn on_map_with_regions(map: &Map) -> (Names, Vec<Region>) {
    let (mut names, regions) = Names::with_regions(map);
    let own = map.recipe().own_names();
    if own.get(Mark::Title).or(own.get(Mark::Island(0))).is_none() {
        names.title = names::on_map(&names.title);
        let land = names.places.iter_mut().filter(|place| place.is_of_main_land());
        land.for_each(|land| land.name = names::on_map(&land.name));
    }
    (names, regions)
}

/// Finds out about a map what is the same whatever part of it a picture shows.
fn found_out(map: &Map) -> Known {
    let (names, regions) = on_map_with_regions(map);
    let shoreline = shoreline_with_lakes(map).map(Arc::new);
    Known { names: Arc::new(names), regions: regions.into(), shoreline }
}

/// Gathers the input that is the same for pictures of all sizes.
fn map_input<'a>(
    map: &'a Map,
    sheet: [Vec2; 2],
    Known { names, regions, shoreline }: Known,
    marks: Marks<'a>,
) -> MapInput<'a> {
    let (network, land) = (map.network(), map.land());
    MapInput {
        scale: map.scale(),
        courses: network.rivers.iter().map(|river| network.middle(river)).collect(),
        discharges: network.rivers.iter().map(|river| network.discharge(river)).collect(),
        total_discharge: network.total_discharge(),
        cartouche: map.recipe().has_title().then(|| cartouche(map, &names, sheet)),
        own: own(map.recipe(), network, &names),
        names,
        regions,
        lakes: network.oxbows.iter().map(Oxbow::middle).collect(),
        ridges: land.map_or_else(Vec::new, |land| ridges(land)),
        shoreline,
        sea: land.map(|land| land.coast_distance()),
        marks,
    }
}

/// Lists what a recipe gives a name of its own: rivers, the greatest first, then reaches and places. Nothing if there are to be no names.
fn own(recipe: &Recipe, network: &Network, names: &Names) -> Vec<Own> {
    if recipe.get::<Labels>() == Labels::None {
        return Vec::new();
    }
    let own = recipe.own_names();
    let is_own = |mark: &Mark| own.get(*mark).is_some_and(|name| !name.is_empty());
    let river = |identity: u32| names.rivers.iter().position(|river| river.identity == identity);
    let thing = |mark: Mark| match mark {
        Mark::River(identity) => river(identity).map(Own::River),
        Mark::Reach(identity) => river(identity).map(Own::Reach),
        _ => names.places.iter().find(|place| place.mark() == mark).map(|place| Own::Place(place.kind, place.number)),
    };
    names.marked(network).into_iter().map(|(mark, _)| mark).filter(is_own).filter_map(thing).collect()
}

/// Describes the cartouche: the title, and what stands with it.
fn cartouche(map: &Map, names: &Names, sheet: [Vec2; 2]) -> Cartouche {
    let recipe = map.recipe();
    let style: Style = recipe.get();
    Cartouche {
        plate: match recipe.get() {
            recipe::Cartouche::Lengths => Some(Plate::Lengths(plates::longest(map.network(), names, &map.scale()))),
            recipe::Cartouche::Profile => plates::profile(map, names).map(Plate::Profile),
            _ => None,
        },
        title: names.title.clone(),
        seed: names.subtitle.clone(),
        is_framed: recipe.is_sheet(),
        frame: if style.shows(Shown::CompassRose) { Frame::Scrolls } else { Frame::Rules },
        // A legend has one of its own.
        has_scale: !(style.shows(Shown::Legend) && recipe.get::<Labels>() != Labels::None),
        north: match style {
            _ if style.shows(Shown::NorthArrow) => Some(NorthPoint::Arrow),
            _ => style.shows(Shown::CompassRose).then_some(NorthPoint::Rose),
        },
        // Pictures of other maps have a neat line.
        sheet: (recipe.is_sheet() && painted_margin(map) == 0.0 && !style.shows(Shown::SpotHeights)).then_some(sheet),
    }
}

/// Returns the width of the margin around a map's neatline, in units; 0 if it has none.
fn painted_margin(map: &Map) -> f32 {
    margin_of(map.recipe().get(), map.domain().size, map.land().map(Arc::as_ref))
}

/// Returns the two corners of the part of the plane that labels may stand in: within the neatline if the map has one, else anywhere.
pub(super) fn on_map(map: &Map) -> [Vec2; 2] {
    let (size, painted) = (map.domain().size, painted_margin(map));
    let margin = if map.recipe().is_sheet() { painted.max(SHEET_MARGIN) } else { painted };
    if margin > 0.0 { [Vec2::splat(margin), size - margin] } else { [Vec2::MIN, Vec2::MAX] }
}

/// Returns the two corners of the part of a map that pictures of this shape show. That is all of it, unless the map fills a picture of
/// another shape, which cuts off equal parts on two opposite sides.
fn cut_to_shape(domain: &Domain, [least, most]: [Vec2; 2]) -> [Vec2; 2] {
    /// The error of frames, which are computed from pixels, in units.
    const ROUNDING: f32 = 1.0;
    let is_in_middle = (least + most - domain.size).abs().max_element() < ROUNDING;
    let is_filled =
        (most - least).cmpge(domain.size - ROUNDING).any() && (most - least).cmple(domain.size + ROUNDING).all();
    if is_in_middle && is_filled { [least.max(Vec2::ZERO), most.min(domain.size)] } else { [Vec2::ZERO, domain.size] }
}

/// Returns the share of a map that is seen in a frame.
fn share_shown(domain: &Domain, [least, most]: [Vec2; 2]) -> f32 {
    let seen = (most.min(domain.size) - least.max(Vec2::ZERO)).max(Vec2::ZERO);
    (seen.x * seen.y / AREA).min(1.0)
}

/// Describes the marks that the style has besides names.
fn marks<'a>(map: &'a Map, names: &Names, sheet: [Vec2; 2], least_em: f32) -> Marks<'a> {
    let recipe = map.recipe();
    let style: Style = recipe.get();
    let has_heights = style.shows(Shown::SpotHeights);
    let relief = map.shown_relief().filter(|_| has_heights);
    Marks {
        elevations: relief.map(|relief| elevations(relief, map.scale().metres_up, recipe.get())),
        has_grid: has_heights,
        grid: sheet_grid(recipe, sheet, least_em).filter(|_| has_heights),
        legend: style.shows(Shown::Legend).then(|| legend(recipe, map.network(), names)),
        seal: style.shows(Shown::Seal).then(|| seal(recipe.seed(), &names.title)),
    }
}

fn elevations(relief: &Relief, metres: f32, labels: Labels) -> Elevations<'_> {
    let apart = match labels {
        Labels::None | Labels::Few => 150.0,
        Labels::Some => 105.0,
        Labels::Many => 75.0,
    };
    Elevations { heights: heights(relief), metres, apart }
}

/// Returns the grid whose columns and rows have letters and numbers; `None` in pictures without room for these.
fn sheet_grid(recipe: &Recipe, sheet: [Vec2; 2], least_em: f32) -> Option<SheetGrid> {
    /// The distance between two lines of the grid, in units.
    const EVERY: f32 = 120.0;
    let em = SheetGrid::EM.max(least_em) * recipe.number(NumberKey::LabelSize);
    (em <= SheetGrid::MOST_EM).then_some(SheetGrid { sheet, every: EVERY, em })
}

fn legend(recipe: &Recipe, network: &Network, names: &Names) -> Legend {
    let has_heading = !recipe.has_title();
    let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
    let class = |order: u8| {
        let ends = || {
            network
                .rivers
                .iter()
                .filter(|river| river.order == order)
                .filter_map(|river| network.middle(river).last().copied())
        };
        let count = ends().count();
        RiverClass { order, count: count as u32, half: ends().map(|end| end.half).sum::<f32>() / count.max(1) as f32 }
    };
    Legend {
        heading: has_heading.then(|| [names.title.clone(), names.subtitle.clone()]),
        classes: (1..=highest).rev().map(class).filter(|class| class.count > 0).collect(),
    }
}

/// Makes the seal of a seed, with the initials of the map's name if the type lacks letters of the seed.
fn seal(seed: &str, title: &str) -> Seal {
    let of_seed = initials(seed);
    let name = title.strip_prefix("The Rivers of ").unwrap_or(title);
    let of_name = || initials(name).chars().next().unwrap_or('R').into();
    Seal { letters: if of_seed.is_empty() { of_name() } else { of_seed }, seed: Seed::from_text(seed) }
}

/// Returns the share of the land that labels may cover; 0 if there are to be none.
fn share_of_land(labels: Labels) -> f32 {
    match labels {
        Labels::None => 0.0,
        Labels::Few => 0.02,
        Labels::Some => 0.05,
        Labels::Many => 0.1,
    }
}

/// Returns the area of a land, in square units.
fn area(land: &Land) -> f32 {
    land.regions().iter().map(Region::area).sum()
}

pub(crate) fn heights(relief: &Relief) -> Heights<'_> {
    /// The share of all land that lies below the height that counts as the highest: peaks alone would make all else low.
    const HIGHEST: f32 = 0.995;
    Heights {
        heights: relief.heights(),
        columns: relief.columns(),
        cell_size: relief.cell_size(),
        highest: relief.quantile(HIGHEST),
    }
}

/// Returns the distance of each place of a map from the nearest shore, of the sea or of a lake; `None` if there is neither.
pub(crate) fn shoreline(map: &Map) -> Option<Cow<'_, CoastDistance>> {
    let coast = map.land().map(|land| land.coast_distance());
    shoreline_with_lakes(map).map(Cow::Owned).or(coast.map(Cow::Borrowed))
}

/// Returns the distance of each place of a map from the nearest shore; `None` if there are no lakes.
fn shoreline_with_lakes(map: &Map) -> Option<CoastDistance> {
    map.lakes().shoreline(map.land().map(|land| land.coast_distance()), &map.domain())
}

pub(crate) fn ridges(land: &Land) -> Vec<Vec<Place>> {
    /// Half the width of a ridge's strokes, in units.
    const HALF: f32 = 3.0;
    land.ridges().iter().map(|ridge| ridge.iter().map(|&at| Place { at, half: HALF }).collect()).collect()
}
