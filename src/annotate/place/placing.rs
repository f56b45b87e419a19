//! Labels, one after the other: the greatest river first. Later ones only take room away, so nothing is placed twice.

use glam::Vec2;

use super::background::{Background, NONE};
use super::baseline::{Course, Line};
use super::input::{Area, AreaKind, Input, Marks, Reach, River};
use super::letters::{Box, Kind, Label, Text};
use super::search::Search;
use super::{areas, cartouche, grid_letters, islands, legend, seal, spot_heights};
use crate::base::geometry::distance;
use crate::base::sort;

/// Sizes of letters, the length of their em in units, by the share of all water that a river has.
const SIZES: [(f32, f32); 5] = [(0.10, 18.5), (0.045, 16.0), (0.018, 14.0), (0.007, 12.5), (0.0, 11.0)];

/// How much smaller letters are tried for reaches, and for rivers with this share of all water, if there is no room for those.
const SMALLER: f32 = 0.85;
const GREAT: f32 = 0.018;

/// Shorter rivers have no label, and beyond this length a river is no more important for being longer. In units.
const SHORTEST: f32 = 60.0;
const LONG: f32 = 400.0;
/// A river as long as this in units, and in labels, has two, which lie so many of their lengths apart.
const LONG_ENOUGH_FOR_TWO: f32 = 420.0;
const LABELS_FOR_TWO: f32 = 7.0;
const APART: f32 = 2.2;

/// How many rivers are tried, however many there are.
const MOST_RIVERS: usize = 400;

/// The labels of a map, the most important first: of the greatest river, of stretches where rivers wind, of all other rivers, of lakes and
/// islands, of seas; the title; and what the style has besides names.
pub fn place<G: Background>(input: &Input<'_>, background: &G) -> Vec<Label> {
    let cartouche = input.cartouche.as_ref().and_then(|cartouche| cartouche::set(input, background, cartouche));
    let cartouche::Set { labels: cartouche, around, beside } = cartouche.unwrap_or_default();
    // Everything else keeps off its places.
    let boxes = around.into_iter().map(|around| (NONE, around)).collect();
    let mut map = Map { input, background, labels: Vec::new(), boxes, beside, area: 0.0 };
    let corners = map.corner_marks();
    map.label_rivers();
    map.label_areas();
    map.labels.extend(cartouche.into_iter().chain(corners));
    map.survey_marks();
    map.labels
}

/// The rivers that are long enough, in the order in which they are labelled.
fn by_importance(rivers: &[River]) -> Vec<usize> {
    let length = |river: &River| river.course.windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum::<f32>();
    let lengths: Vec<f32> = rivers.iter().map(length).collect();
    let importance = |i: usize| (rivers[i].discharge as f32).sqrt() * lengths[i].min(LONG);
    let order = sort::argsort((0..rivers.len()).map(|i| sort::key(-importance(i))));
    order.into_iter().filter(|&i| lengths[i] >= SHORTEST).collect()
}

/// What a label is wanted for.
struct Subject<'a> {
    kind: Kind,
    river: u32,
    name: &'a [String; 2],
}

/// A map with the labels that it has so far.
struct Map<'a, G> {
    input: &'a Input<'a>,
    background: &'a G,
    labels: Vec<Label>,
    boxes: Vec<(u32, Box)>,
    /// What names of seas keep off besides.
    beside: Option<Box>,
    /// What they cover, in square units.
    area: f32,
}

impl<G: Background> Map<'_, G> {
    /// The legend and the seal, whichever there is to be, in corners that all else keeps off.
    fn corner_marks(&mut self) -> Vec<Label> {
        let Marks { legend, seal, .. } = &self.input.marks;
        let legend = legend.as_ref().and_then(|legend| legend::set(self.input, self.background, legend, &self.boxes));
        let (mut labels, around) = legend.map_or((Vec::new(), None), |set| (set.labels, Some((NONE, set.around))));
        self.boxes.extend(around);
        let seal = seal.as_ref().and_then(|seal| seal::set(self.input, self.background, seal, &self.boxes));
        if let Some((seal, around)) = seal {
            self.boxes.push((NONE, around));
            labels.push(seal);
        }
        labels
    }

    /// Heights where there is room for them, and the grid around it all.
    fn survey_marks(&mut self) {
        let Marks { elevations, grid, .. } = &self.input.marks;
        if let Some(elevations) = elevations {
            for (label, boxes) in spot_heights::labels(self.input, self.background, elevations, &self.boxes) {
                self.boxes.extend(boxes.map(|around| (NONE, around)));
                self.labels.push(label);
            }
        }
        if let Some(grid) = grid {
            self.labels.push(grid_letters::lines(self.input, self.background, grid, &self.boxes));
            self.labels.extend(grid_letters::letters(self.input, grid));
        }
    }

    /// Labels rivers, the greatest first, until they cover as much land as they may.
    fn label_rivers(&mut self) {
        let Input { reaches, rivers, most_area: [most, _], .. } = self.input;
        let mut order = by_importance(rivers);
        order.truncate(MOST_RIVERS);
        let reach_of = |number: usize| reaches.iter().find(|reach| reach.river as usize == number);
        // It has its name even if stretches of others would use up all that labels may cover.
        let greatest = order.iter().copied().min_by_key(|&number| u32::MAX - rivers[number].discharge);
        let firsts = greatest.into_iter().chain(reaches.iter().map(|reach| reach.river as usize));
        let mut is_done = vec![false; rivers.len()];
        for number in firsts.chain(order.iter().copied()) {
            if self.area >= *most {
                break;
            }
            if !std::mem::replace(&mut is_done[number], true) {
                match reach_of(number) {
                    Some(reach) => self.label_with_reach(reach),
                    None => self.label(number),
                }
            }
        }
    }

    /// Labels lakes and islands, the largest first, until they cover as much water as they may, and seas.
    fn label_areas(&mut self) {
        let Input { areas, most_area: [most_land, most], .. } = self.input;
        if *most_land <= 0.0 {
            return;
        }
        let (seas, mut others): (Vec<&Area>, Vec<&Area>) = areas.iter().partition(|area| area.kind == AreaKind::Sea);
        others.sort_by(|a, b| b.size().total_cmp(&a.size()));
        self.area = 0.0;
        for area in others {
            if self.area >= *most {
                break;
            }
            let label = match area.kind {
                AreaKind::Island => islands::island(self.input, self.background, area, &self.boxes),
                AreaKind::Lake | AreaKind::Sea => areas::water(self.input, area, &self.boxes),
            };
            label.into_iter().for_each(|label| self.take(NONE, label));
        }
        for sea in seas {
            let taken: Vec<_> = self.boxes.iter().copied().chain(self.beside.map(|beside| (NONE, beside))).collect();
            let label = areas::water(self.input, sea, &taken);
            label.into_iter().for_each(|label| self.take(NONE, label));
        }
    }

    /// Labels a stretch on which a river winds, and the river; the river first, if that leaves it no room.
    fn label_with_reach(&mut self, reach: &Reach) {
        let before = (self.labels.len(), self.boxes.len(), self.area);
        self.label_reach(reach);
        let with_reach = self.labels.len();
        self.label(reach.river as usize);
        if self.labels.len() == with_reach {
            self.labels.truncate(before.0);
            self.boxes.truncate(before.1);
            self.area = before.2;
            self.label(reach.river as usize);
            self.label_reach(reach);
        }
    }

    /// Labels a stretch on which a river winds, in smaller letters if there is no room for large ones.
    fn label_reach(&mut self, reach: &Reach) {
        for size in [1.0, SMALLER] {
            let em = self.em(reach.river as usize) * size;
            let Some(course) = Course::new(&reach.course, em) else { return };
            let subject = Subject { kind: Kind::Reach, river: reach.river, name: &reach.name };
            if let Some(label) = self.attempt(&subject, &course, &course.lines_of_reach(em), em, None) {
                return self.take(reach.river, label);
            }
        }
    }

    /// The share of all water that a river has.
    fn share(&self, number: usize) -> f32 {
        self.input.rivers[number].discharge as f32 / self.input.total_discharge.max(1) as f32
    }

    /// The size of a river's letters.
    fn em(&self, number: usize) -> f32 {
        let share = self.share(number);
        let size = SIZES.iter().find(|(least, _)| share >= *least).map_or(0.0, |(_, size)| *size);
        size.max(self.input.least_em) * self.input.label_size
    }

    /// Labels a river, in short if there is no room for all of its name, and a great one in smaller letters if there is none for that; twice
    /// if it is long.
    fn label(&mut self, number: usize) {
        let em = self.em(number);
        let smaller = (SMALLER * em).max(self.input.least_em * self.input.label_size);
        if !self.label_in_size(number, em) && self.share(number) >= GREAT && smaller < em {
            self.label_in_size(number, smaller);
        }
    }

    /// Labels a river in letters of a size, twice if it is long. Returns whether there was room.
    fn label_in_size(&mut self, number: usize, em: f32) -> bool {
        let river = &self.input.rivers[number];
        let subject = Subject { kind: Kind::River, river: number as u32, name: &river.name };
        let Some(course) = Course::new(&river.course, em) else { return false };
        let lines = course.lines(em);
        let Some(first) = self.attempt(&subject, &course, &lines, em, None) else { return false };
        let (middle, length) = (middle(&first), first.letters.len() as f32 * 0.5 * em);
        self.take(number as u32, first);
        let along: f32 = river.course.windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum();
        if along >= LONG_ENOUGH_FOR_TWO.max(LABELS_FOR_TWO * length) {
            let second = self.attempt(&subject, &course, &lines, em, Some((middle, APART * length)));
            second.into_iter().for_each(|second| self.take(number as u32, second));
        }
        true
    }

    fn attempt(
        &self,
        subject: &Subject<'_>,
        course: &Course,
        lines: &[Line],
        em: f32,
        away: Option<(Vec2, f32)>,
    ) -> Option<Label> {
        let Subject { kind, river, name: [long, short] } = subject;
        let forms = if long == short { &[long][..] } else { &[long, short] };
        // In short, forks of two rivers may be called the same.
        let is_another_s =
            |form: &str| self.labels.iter().any(|label| label.text == form && label.river != Some(*river));
        forms.iter().filter(|form| !form.is_empty() && !is_another_s(form)).find_map(|form| {
            let search = Search {
                input: self.input,
                background: self.background,
                taken: &self.boxes,
                river: *river,
                kind: *kind,
                thick: course.thick(),
                lines,
                text: Text::new(form, *kind),
                em,
                away,
            };
            search.label(form)
        })
    }

    fn take(&mut self, river: u32, label: Label) {
        self.area += Text::new(&label.text, label.kind).length * label.em * label.em;
        self.boxes.extend(label.letters.iter().map(|letter| (river, letter.around(label.em))));
        self.labels.push(label);
    }
}

/// The middle between a label's first letter and its last.
fn middle(label: &Label) -> Vec2 {
    let ends =
        [label.letters.first(), label.letters.last()].map(|letter| letter.map_or(Vec2::ZERO, |letter| letter.at));
    (ends[0] + ends[1]) * 0.5
}
