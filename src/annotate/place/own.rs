//! Names that people give: they get their places before any made-up name, and one way or the other.
//!
//! ```text
//! a line along the river ─► in smaller letters ─► wherever that can be read ─► level, in two lines ─► level, with a hairline
//! ```
//!
//! On which pictures each has room is found beforehand, without any other name; its place is then kept free on smaller ones. Where a larger
//! picture has room for it in a better way, it moves there once: small pictures would do without it otherwise.

use super::background::Background;
use super::beside::Beside;
use super::chosen::Chosen;
use super::input::{Input, Own};
use super::letters::Box;
use super::levels::Level;
use super::placing::{Map, SMALLER, belt_of, reach_of};

/// The sizes of letters that are tried, over the usual one.
const SIZES: [f32; 3] = [1.0, SMALLER, 0.7];

/// The labels of own names, on the level on which each first has room, and again where larger pictures have room for it in a better way.
#[derive(Clone, Debug, Default)]
pub struct OwnPlaces {
    levels: Vec<Vec<Chosen>>,
    /// What has its place by now, with the last label, and the number of the way in which it stands.
    placed: Vec<(Own, Chosen, usize)>,
}

impl OwnPlaces {
    /// Finds places on so many levels, off boxes that are kept for others.
    pub fn extend<G: Background>(
        &mut self,
        input: &Input<'_>,
        background: &G,
        levels: &[Level],
        reserved: &[(u32, Box)],
    ) {
        let mut at_level = input.clone();
        for &level in levels.iter().skip(self.levels.len()) {
            level.set(&mut at_level);
            let mut map = Map::new(&at_level, background, level, &[], reserved);
            let free = map.boxes.clone();
            for &own in &input.map.own {
                let other = |(other, ..): &&(Own, Chosen, usize)| *other != own;
                let others = self.placed.iter().filter(other).flat_map(|(_, chosen, _)| chosen.boxes());
                map.boxes = free.iter().copied().chain(others).collect();
                let before = self.placed.iter().position(|(other, ..)| *other == own);
                let better_than = before.map_or(WAYS, |before| self.placed[before].2);
                let Some(way) = map.place(own, better_than) else { continue };
                before.into_iter().for_each(|before| drop(self.placed.remove(before)));
                self.placed.extend(map.chosen.last().map(|chosen| (own, chosen.clone(), way)));
            }
            self.levels.push(map.chosen);
        }
    }

    /// Returns the labels that first have room on a level, or better room than before.
    pub fn on(&self, level: usize) -> &[Chosen] {
        self.levels.get(level).map_or(&[], |chosen| chosen)
    }

    /// Returns the boxes of labels that stand on larger pictures than those of a level alone.
    pub fn after(&self, level: usize) -> impl Iterator<Item = (u32, Box)> + '_ {
        self.levels.iter().skip(level + 1).flatten().flat_map(Chosen::boxes)
    }
}

/// The number of ways in which a river's name can stand.
const WAYS: usize = 4;

impl<G: Background> Map<'_, G> {
    /// Labels something that has an own name, in one of the ways before `better_than`. Returns the number of the way; `None` if there is no
    /// room.
    fn place(&mut self, own: Own, better_than: usize) -> Option<usize> {
        let (before, input) = (self.chosen.len(), self.input);
        match own {
            Own::River(number) => return (0..better_than).find(|&way| self.place_river(number, way)),
            _ if better_than == 0 => {}
            Own::Reach(number) => {
                let reaches = input.map.reaches();
                reach_of(&reaches, number).into_iter().for_each(|reach| self.label_reach(reach));
            }
            Own::Place(kind, number) => {
                let mut places = input.map.names.places.iter().zip(input.map.regions.iter());
                let place = places.find(|(place, _)| (place.kind, place.number) == (kind, number));
                place.into_iter().for_each(|(place, region)| self.label_place(place, region));
            }
        }
        (self.chosen.len() > before).then_some(0)
    }

    /// Labels a river in a way: along it, off the stretch that has a name of its own if it can be; along it wherever that can be read; in two
    /// lines beside it; or with a hairline. On the smallest pictures only the first is tried. Returns whether there was room.
    fn place_river(&mut self, number: usize, way: usize) -> bool {
        let (input, usual) = (self.input, self.usual(number));
        if way > 0 && !self.level.has_any_way() {
            return false;
        }
        let sizes = input.sizes(&SIZES.map(|size| usual * size), 1.0);
        let any_size = |label: &mut dyn FnMut(f32) -> bool| sizes.iter().any(|usual| label(*usual));
        match way {
            0 => {
                let reaches = input.map.reaches();
                let belt = reach_of(&reaches, number).map(|(_, course)| belt_of(course));
                belt.is_some_and(|belt| any_size(&mut |usual| self.label_in_size(number, usual, &[belt], false)))
                    || any_size(&mut |usual| self.label_in_size(number, usual, &[], false))
            }
            1 => any_size(&mut |usual| self.label_in_size(number, usual, &[], true)),
            _ => any_size(&mut |usual| self.label_level(number, usual, way > 2)),
        }
    }

    /// Labels a river level beside it, in two lines or with a hairline. Returns whether there was room.
    fn label_level(&mut self, number: usize, usual: f32, is_bridged: bool) -> bool {
        let Self { input, background, boxes, .. } = self;
        let beside =
            Beside { input, background: *background, taken: boxes, river: number as u32, em: input.em(usual, 1.0) };
        let found = beside.label(&input.map.names.rivers[number].name, is_bridged);
        let chosen = found.map(|(label, text, shrinks)| Chosen { label, text, usual, over_least: 1.0, shrinks });
        let is_found = chosen.is_some();
        chosen.into_iter().for_each(|chosen| self.take(chosen));
        is_found
    }
}
