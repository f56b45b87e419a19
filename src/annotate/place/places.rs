//! The labels of pictures of all sizes: chosen size by size, then with what a picture has in its corners and margin, as far as it shows them.

use glam::Vec2;

use super::background::{Background, NONE};
use super::blocks::blocks;
use super::chosen::Chosen;
use super::input::{Input, Known, Marks};
use super::letters::{Box, Kind, Label, Placed, Stroke};
use super::levels::{Level, STEPS};
use super::own::OwnPlaces;
use super::placing::Map;
use super::{grid_letters, spot_heights};

/// Places the labels of a picture, the most important first: of the greatest river, of stretches where rivers wind, of all other rivers, of
/// regions, lakes and islands, of seas; the title; and the marks that the style has besides names.
pub fn place<G: Background>(input: &Input<'_>, background: &G) -> Vec<Label> {
    Places::default().place(input, background)
}

/// The labels of one map in the places that have been chosen so far, for pictures and views of any size.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// What is known about the map by now.
    pub(crate) known: Option<Known>,
    /// The frame that they are chosen in.
    frame: [Vec2; 2],
    /// The labels of each level, from the smallest pictures on.
    levels: Vec<Vec<Chosen>>,
    /// Those of own names, which come before all others.
    own: OwnPlaces,
}

impl Places {
    /// Does the same as [`place`], and keeps what it has chosen for other pictures of the same map.
    pub fn place<G: Background>(&mut self, input: &Input<'_>, background: &G) -> Vec<Label> {
        if self.frame != input.frame {
            *self = Self { known: self.known.take(), frame: input.frame, ..Self::default() };
        }
        let mut at_level = input.clone();
        let levels: Vec<Level> = Level::up_to(input).collect();
        if self.levels.len() < levels.len() {
            // Titles and legends are larger on larger pictures, whose labels have their places by then.
            let mut reserved = Vec::new();
            Level::USUAL.set(&mut at_level);
            blocks(&at_level, background, &mut reserved);
            if !input.map.own.is_empty() {
                // Pictures of the whole map of all sizes keep the same places free.
                let levels: Vec<Level> = Level::all().take(levels.len().max(STEPS)).collect();
                self.own.extend(input, background, &levels, &reserved);
            }
            for (number, &level) in levels.iter().enumerate().skip(self.levels.len()) {
                level.set(&mut at_level);
                let own = self.own.on(number);
                let stays = |before: &&Chosen| !own.iter().any(|own| own.is_of_same(before));
                let before: Vec<Chosen> = self.levels.last().into_iter().flatten().filter(stays).cloned().collect();
                let kept: Vec<(u32, Box)> = reserved.iter().copied().chain(self.own.after(number)).collect();
                self.levels.push(Map::new(&at_level, background, level, &before, &kept).choose(own));
            }
        }
        let chosen = self.levels[..levels.len()].last().map_or(&[][..], |chosen| chosen);
        finish(input, background, chosen.iter().map(|chosen| chosen.resized(input, background)).collect())
    }
}

#[cfg(test)]
impl Places {
    /// Takes all chosen labels away, but not the levels that they were chosen for: a test sees then whether any is chosen anew.
    pub fn empty(&mut self) {
        self.levels.iter_mut().for_each(Vec::clear);
    }
}

/// Returns the labels that a picture shows whole, with those in its corners and margin.
fn finish<G: Background>(input: &Input<'_>, background: &G, chosen: Vec<Chosen>) -> Vec<Label> {
    let mut in_corners = Vec::new();
    let (mut corners, _) = blocks(input, background, &mut in_corners);
    let own: Vec<(u32, Box)> = chosen.iter().flat_map(Chosen::boxes).collect();
    let (mut boxes, mut left_out) = (Vec::new(), Vec::new());
    for (river, around) in in_corners {
        // On a part of the map something may have room that has none on the whole, where a name has its place: the name stays.
        let is_in_the_way = own.iter().any(|(_, own)| own.meets(&around, 0.0));
        // A title without its second line, or a number without its bar, says nothing: what is not shown whole is not shown.
        let is_cut = || corners.iter().any(|label| stands_in(label, &around) && !is_shown(input, label));
        if is_in_the_way || is_cut() { left_out.push(around) } else { boxes.push((river, around)) }
    }
    corners.retain(|label| !left_out.iter().any(|around| stands_in(label, around)));
    boxes.extend(own);
    // Rivers first, in the order of their importance.
    let (mut labels, mut others) = (Vec::new(), Vec::new());
    for label in chosen.into_iter().map(|chosen| chosen.label).chain(corners) {
        if label.kind == Kind::Grid || is_shown(input, &label) {
            if label.river.is_some() { labels.push(label) } else { others.push(label) }
        }
    }
    labels.extend(others);
    let Marks { elevations, grid, .. } = &input.map.marks;
    if let Some(elevations) = elevations {
        for (label, around) in spot_heights::labels(input, background, elevations, &boxes) {
            boxes.extend(around.map(|around| (NONE, around)));
            labels.extend(is_shown(input, &label).then_some(label));
        }
    }
    if let Some(grid) = grid {
        labels.push(grid_letters::lines(input, background, grid, &boxes));
        labels.extend(grid_letters::letters(input, grid));
    }
    labels
}

/// Returns `true` if a label begins in a level box.
fn stands_in(label: &Label, around: &Box) -> bool {
    let off = |letter: &Placed| (letter.around(label.em).middle - around.middle).abs();
    label.letters.first().map(off).is_some_and(|off| off.cmple(around.along + around.down).all())
}

/// Returns `true` if the picture shows all of a label.
fn is_shown(input: &Input<'_>, label: &Label) -> bool {
    let [least, most] = input.view;
    let boxes = label.letters.iter().map(|letter| letter.around(label.em));
    let strokes = label.strokes.iter().map(Stroke::around);
    boxes.chain(strokes).flat_map(|around| around.corners()).all(|at| at.cmpge(least).all() && at.cmple(most).all())
}
