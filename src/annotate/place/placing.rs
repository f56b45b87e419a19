//! Labels on pictures of one size, one after the other: the greatest river first. Later ones only take room away, and those that smaller pictures
//! have stay in their places.

use glam::Vec2;

use super::background::{Background, NONE};
use super::baseline::{Course, Line};
use super::blocks::blocks;
use super::chosen::{Chosen, Shrinks};
use super::input::{Input, MapInput, Own, Reach};
use super::letters::{Box, Kind, Text};
use super::levels::Level;
use super::search::{MOST_COST, MOST_COST_SMALL, Search};
use super::{areas, inlets, islands, regions, tarns};
use crate::annotate::names::{PlaceKind, PlaceName, forms};
use crate::base::geometry::{distance, lengths};
use crate::base::sort;
use crate::land::Region;
use crate::network::Place;

/// The usual lengths of the em, in units, by the least share of all water of a river that has it.
const SIZES: [(f32, f32); 5] = [(0.10, 18.5), (0.045, 16.0), (0.018, 14.0), (0.007, 12.5), (0.0, 11.0)];

/// The size of smaller letters, which are tried for reaches, and for rivers with this share of all water, if there is no room for those of
/// the usual size.
pub(super) const SMALLER: f32 = 0.85;
const GREAT: f32 = 0.018;

/// The least length of a river that has a label, and the length beyond which a river is no more important for being longer, in units.
const SHORTEST: f32 = 60.0;
const LONG: f32 = 400.0;
/// The length of course, in units and in lengths of its label, for each of which a river has a further label; and the least distance
/// between its labels, in their lengths.
const LONG_ENOUGH_FOR_TWO: f32 = 420.0;
const LABELS_FOR_TWO: f32 = 7.0;
const APART: f32 = 2.2;
/// The greatest distance by which a label that becomes smaller leaves its place, in ems: its line draws nearer to the river.
const NEAR: f32 = 0.6;

/// The greatest number of rivers that are tried.
const MOST_RIVERS: usize = 400;

/// Returns the rivers that are long enough, in the order in which they are labelled.
fn by_importance(map: &MapInput<'_>, shrink: f32) -> Vec<usize> {
    let lengths: Vec<f32> = map.courses.iter().map(|course| length(course)).collect();
    let importance = |i: usize| (map.discharges[i] as f32).sqrt() * lengths[i].min(LONG);
    let order = sort::argsort((0..lengths.len()).map(|i| sort::key(-importance(i))));
    order.into_iter().filter(|&i| lengths[i] >= SHORTEST * shrink).take(MOST_RIVERS).collect()
}

/// Returns the length of a river's course, in units.
fn length(course: &[Place]) -> f32 {
    course.windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum()
}

/// A river or a reach that a label is wanted for.
#[derive(Clone, Copy)]
struct Subject<'a> {
    kind: Kind,
    river: u32,
    name: [&'a str; 2],
    /// The usual length of its em, in units.
    usual: f32,
}

/// The limits of a label's place.
#[derive(Clone, Copy, Default)]
struct Within<'a> {
    away: &'a [(Vec2, f32)],
    near: Option<(Vec2, f32)>,
    is_lenient: bool,
}

/// A map with the labels that it has so far, on pictures of one size.
pub struct Map<'a, G> {
    pub(super) input: &'a Input<'a>,
    pub(super) background: &'a G,
    pub(super) level: Level,
    pub(super) chosen: Vec<Chosen>,
    pub(super) boxes: Vec<(u32, Box)>,
    /// The box that the names of seas keep off, besides those that all labels do.
    beside: Option<Box>,
}

impl<'a, G: Background> Map<'a, G> {
    /// Makes a map with the labels of smaller pictures, and with places that are kept for other labels.
    #[inline(never)] // one copy
    pub fn new(
        input: &'a Input<'a>,
        background: &'a G,
        level: Level,
        before: &[Chosen],
        reserved: &[(u32, Box)],
    ) -> Self {
        let chosen: Vec<Chosen> = before.iter().map(|chosen| chosen.resized(input, background)).collect();
        let mut boxes = reserved.to_vec();
        let (_, beside) = blocks(input, background, &mut boxes);
        boxes.extend(chosen.iter().flat_map(Chosen::boxes));
        let mut this = Self { input, background, level, chosen, boxes, beside };
        for (number, before) in before.iter().enumerate() {
            if before.em(input) < before.label.em {
                this.draw_near(number, before.em(input));
            }
        }
        this
    }

    /// Chooses all labels that there is room for, those of smaller pictures included, and first of all some that have their places.
    pub fn choose(mut self, own: &[Chosen]) -> Vec<Chosen> {
        own.iter().for_each(|chosen| self.take(chosen.clone()));
        self.label_rivers();
        self.label_areas();
        self.chosen
    }

    /// Returns `true` if something waits for pictures on which its own name has room.
    fn waits(&self, own: Own) -> bool {
        self.input.map.own.contains(&own)
    }

    /// Lets a label that has become smaller stand as near to its river as such letters do, and in full, if nothing is in the way.
    fn draw_near(&mut self, number: usize, em: f32) {
        let Chosen { label, usual, shrinks: Shrinks::Along { anchor, .. }, .. } = &self.chosen[number] else { return };
        let (Kind::River, Some(river)) = (label.kind, label.river) else { return };
        let map = &self.input.map;
        let (usual, anchor, name) = (*usual, *anchor, map.names.rivers[river as usize].forms());
        let Some(course) = Course::new(&map.courses[river as usize], em) else { return };
        let before = std::mem::take(&mut self.boxes);
        let own: Vec<Box> = self.chosen[number].boxes().map(|(_, around)| around).collect();
        let is_other = |(_, around): &&(u32, Box)| own.iter().all(|own| own.middle != around.middle);
        self.boxes = before.iter().filter(is_other).copied().collect();
        let subject = Subject { kind: Kind::River, river, name, usual };
        let within = Within { near: Some((anchor, NEAR * em)), ..Within::default() };
        match self.attempt(subject, &course, &course.lines(em), em, within) {
            Some(chosen) => {
                self.boxes.extend(chosen.boxes());
                self.chosen[number] = chosen;
            }
            None => self.boxes = before,
        }
    }

    /// Returns the area that the labels of some kinds cover, in square units.
    fn area(&self, is_one: impl Fn(Kind) -> bool) -> f32 {
        self.chosen.iter().filter(|chosen| is_one(chosen.label.kind)).map(Chosen::area).sum()
    }

    /// Labels rivers, the greatest first, until they cover as much land as they may.
    fn label_rivers(&mut self) {
        let Input { map, most_area: [most, _], is_one_each, .. } = self.input;
        if *most <= 0.0 {
            return;
        }
        let order = by_importance(map, self.input.shrink);
        let reaches = map.reaches();
        // It has its name even if stretches of others would use up all that labels may cover.
        let greatest = order.iter().copied().min_by_key(|&number| u32::MAX - map.discharges[number]);
        greatest.into_iter().for_each(|number| self.label_greatest(number, reach_of(&reaches, number)));
        let reaches = if *is_one_each { &[][..] } else { &reaches[..] };
        let winding = reaches.iter().map(|(name, _)| name.river as usize);
        let mut is_done = vec![false; map.courses.len()];
        for number in greatest.into_iter().chain(winding).chain(order.iter().copied()) {
            if self.area(|kind| matches!(kind, Kind::River | Kind::Reach)) >= *most {
                break;
            }
            if !std::mem::replace(&mut is_done[number], true) {
                let reach = reach_of(reaches, number);
                self.label(number, reach);
                if !self.waits(Own::Reach(number)) {
                    reach.into_iter().for_each(|reach| self.label_reach(reach));
                }
            }
        }
    }

    /// Labels a stretch on which a river winds, in smaller letters if there is no room for large ones; but only if the river has its name.
    #[inline(never)] // one copy
    pub(super) fn label_reach(&mut self, (name, course): Reach<'_>) {
        let of_river = |kind| self.labels_of(name.river).any(|chosen| chosen.label.kind == kind);
        let is_own = self.waits(Own::Reach(name.river as usize));
        if of_river(Kind::Reach) || !(of_river(Kind::River) || is_own) {
            return;
        }
        for size in [1.0, SMALLER] {
            let usual = self.usual(name.river as usize) * size;
            let em = self.em(usual);
            let Some(course) = Course::new(course, em) else { return };
            let subject = Subject { kind: Kind::Reach, river: name.river, name: forms(&name.name), usual };
            let chosen = self.attempt(subject, &course, &course.lines_of_reach(em), em, Within::default());
            if let Some(chosen) = chosen {
                return self.take(chosen);
            }
        }
    }

    fn labels_of(&self, river: u32) -> impl Iterator<Item = &Chosen> {
        self.chosen.iter().filter(move |chosen| chosen.label.river == Some(river))
    }

    /// Returns the share of all water that a river has.
    fn share(&self, number: usize) -> f32 {
        self.input.map.discharges[number] as f32 / self.input.map.total_discharge.max(1) as f32
    }

    /// Returns the usual size of a river's letters.
    pub(super) fn usual(&self, number: usize) -> f32 {
        let share = self.share(number);
        SIZES.iter().find(|(least, _)| share >= *least).map_or(0.0, |(_, size)| *size)
    }

    /// Returns the em of letters whose usual em is `usual`, in units.
    pub(super) fn em(&self, usual: f32) -> f32 {
        self.input.em(usual, 1.0)
    }

    /// Labels a river, in short if there is no room for all of its name, and a great one in smaller letters if there is none for that; off the
    /// stretch that has a name of its own if it can be; and once more if it is long.
    fn label(&mut self, number: usize, reach: Option<Reach<'_>>) {
        let Input { map, shrink, is_one_each, .. } = self.input;
        let own: Vec<(Vec2, f32)> = self
            .labels_of(number as u32)
            .filter(|chosen| chosen.label.kind == Kind::River)
            .map(|chosen| (chosen.middle(), APART * chosen.text.length * chosen.label.em))
            .collect();
        if let Some((_, apart)) = own.first() {
            let each = (LONG_ENOUGH_FOR_TWO * shrink).max(LABELS_FOR_TWO * apart / APART);
            if !is_one_each && length(&map.courses[number]) >= each * own.len() as f32 {
                self.label_in_size(number, self.usual(number), &own, false);
            }
            return;
        }
        if self.waits(Own::River(number)) {
            return;
        }
        let usual = self.usual(number);
        let belt = reach.map(|(_, course)| belt_of(course));
        let sizes = if self.share(number) >= GREAT { &[1.0, SMALLER][..] } else { &[1.0] };
        let is_labelled = sizes.iter().any(|size| {
            belt.is_some_and(|belt| self.label_in_size(number, usual * size, &[belt], false))
                || self.label_in_size(number, usual * size, &[], false)
        });
        if is_labelled {
            self.label(number, None);
        }
    }

    /// Labels the greatest river wherever that can be read, on all pictures but the smallest.
    fn label_greatest(&mut self, number: usize, reach: Option<Reach<'_>>) {
        if self.labels_of(number as u32).next().is_none() {
            self.label(number, reach);
        }
        let waits = self.waits(Own::River(number));
        if !waits && self.labels_of(number as u32).next().is_none() && self.level.is_readable() {
            let usual = self.usual(number);
            let _ = [1.0, SMALLER, 0.6].into_iter().any(|size| self.label_in_size(number, usual * size, &[], true));
        }
    }

    /// Labels a river in letters of a size. Returns whether there was room.
    #[inline(never)] // one copy
    pub(super) fn label_in_size(&mut self, number: usize, usual: f32, away: &[(Vec2, f32)], is_lenient: bool) -> bool {
        let (map, em) = (&self.input.map, self.em(usual));
        let subject =
            Subject { kind: Kind::River, river: number as u32, name: map.names.rivers[number].forms(), usual };
        let Some(course) = Course::new(&map.courses[number], em) else { return false };
        let mut lines = course.lines(em);
        if is_lenient {
            lines.extend(course.lines_beside_belt(em));
        }
        let chosen = self.attempt(subject, &course, &lines, em, Within { away, is_lenient, ..Within::default() });
        let is_found = chosen.is_some();
        chosen.into_iter().for_each(|chosen| self.take(chosen));
        is_found
    }

    #[inline(never)] // one copy
    fn attempt(
        &self,
        subject: Subject<'_>,
        course: &Course,
        lines: &[Line],
        em: f32,
        Within { away, near, is_lenient }: Within<'_>,
    ) -> Option<Chosen> {
        let Subject { kind, river, name: [long, short], usual } = subject;
        let forms = if long == short { &[long][..] } else { &[long, short] };
        // In short, forks of two rivers may be called the same.
        let is_another_s =
            |form: &str| self.chosen.iter().any(|other| other.label.text == form && other.label.river != Some(river));
        let is_kept = self.level.is_small() && near.is_none();
        let most_cost = match (is_lenient, is_kept) {
            (true, _) => f32::MAX,
            (_, true) => MOST_COST_SMALL,
            _ => MOST_COST,
        };
        forms.iter().filter(|form| !form.is_empty() && !is_another_s(form)).find_map(|form| {
            let text = Text::new(form, kind);
            let (input, background, taken) = (self.input, self.background, &self.boxes[..]);
            let (thick, text_of) = (course.thick(), text.clone());
            let search = Search {
                input,
                background,
                taken,
                river,
                kind,
                thick,
                lines,
                text,
                em,
                away,
                near,
                most_cost,
                is_lenient,
            };
            let (label, line, width) = search.label(form)?;
            let anchor = near.map_or(line.middle(), |(anchor, _)| anchor);
            let shrinks = Shrinks::Along { line, width, anchor };
            Some(Chosen { label, text: text_of, usual, over_least: 1.0, shrinks })
        })
    }

    #[inline(never)] // one copy
    pub(super) fn take(&mut self, chosen: Chosen) {
        self.boxes.extend(chosen.boxes());
        self.chosen.push(chosen);
    }

    /// Labels regions, lakes and islands, the largest first, until they cover as much water as they may; seas; then what lies along the coast.
    fn label_areas(&mut self) {
        let Input { map, most_landmarks, most_area: [most_land, most], .. } = self.input;
        if *most_land <= 0.0 {
            return;
        }
        let (mut waters, mut seas, mut coastal) = (Vec::new(), Vec::new(), [(); 3].map(|()| Vec::new()));
        let is_no_own = |(place, _): &(&PlaceName, &Region)| !self.waits(Own::Place(place.kind, place.number));
        let places: Vec<_> = map.names.places.iter().zip(map.regions.iter()).filter(is_no_own).collect();
        for (place, region) in places {
            match place.kind {
                PlaceKind::Sea => seas.push((place, region)),
                PlaceKind::Strait => coastal[0].push((place, region)),
                PlaceKind::Gulf | PlaceKind::Bay => coastal[1].push((place, region)),
                PlaceKind::Cape => coastal[2].push((place, region)),
                _ if is_region(place) => self.label_place(place, region),
                PlaceKind::Lake | PlaceKind::Island | PlaceKind::Range => waters.push((place, region)),
            }
        }
        let waters = sort::sorted_by(&waters, |(_, region)| sort::key(-region.area()));
        let is_of_water = |kind| matches!(kind, Kind::Island | Kind::Offshore | Kind::Inlet | Kind::Cape | Kind::Tarn);
        for (place, region) in waters {
            if self.area(is_of_water) < *most {
                self.label_place(place, region);
            }
        }
        for (place, region) in seas {
            self.label_place(place, region);
        }
        for (place, region) in coastal.iter().flat_map(|places| places.iter().take(*most_landmarks)) {
            if self.area(is_of_water) < *most {
                self.label_place(place, region);
            }
        }
    }

    /// Labels a place, unless a label of something that is no river says the same.
    #[inline(never)] // one copy
    pub(super) fn label_place(&mut self, place: &PlaceName, region: &Region) {
        let forms = forms(&place.name);
        let says_it = |chosen: &Chosen| chosen.label.river.is_none() && forms.contains(&chosen.label.text.as_str());
        if self.chosen.iter().any(says_it) {
            return;
        }
        let (input, background, taken) = (self.input, self.background, &self.boxes);
        let chosen = match place.kind {
            _ if is_region(place) => regions::region(input, background, place, taken),
            PlaceKind::Island => islands::island(input, background, (place, region), taken),
            PlaceKind::Lake => {
                // Beside one at the level of the sea is its coast.
                let is_inland = input.map.sea.is_none_or(|sea| sea.height(place.at) > 0.0);
                let beside = || tarns::beside(input, background, (place, region), taken);
                areas::water(input, place, region, taken).or_else(|| beside().filter(|_| is_inland))
            }
            PlaceKind::Sea => {
                let taken: Vec<(u32, Box)> =
                    taken.iter().copied().chain(self.beside.map(|beside| (NONE, beside))).collect();
                areas::water(input, place, region, &taken)
            }
            _ => inlets::inlet(input, place, taken),
        };
        chosen.into_iter().for_each(|chosen| self.take(chosen));
    }
}

/// Returns `true` if the name of a place runs across it in capitals.
fn is_region(place: &PlaceName) -> bool {
    place.is_of_main_land() || place.kind == PlaceKind::Range
}

/// Returns the reach of a river; `None` if it has none.
pub(super) fn reach_of<'a>(reaches: &[Reach<'a>], river: usize) -> Option<Reach<'a>> {
    reaches.iter().copied().find(|(name, _)| name.river as usize == river)
}

/// Returns the middle of a reach, and the distance from there to the farther of its ends.
pub(super) fn belt_of(course: &[Place]) -> (Vec2, f32) {
    let line: Vec<Vec2> = course.iter().map(|place| place.at).collect();
    let along = lengths(&line);
    let half = along.last().copied().unwrap_or(0.0) * 0.5;
    let middle = line.get(along.partition_point(|&along| along < half)).copied().unwrap_or_default();
    let ends = [line.first(), line.last()].map(|end| end.map_or(0.0, |end| distance(*end, middle)));
    (middle, ends[0].max(ends[1]))
}
