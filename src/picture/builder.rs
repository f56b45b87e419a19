//! Makes the annotation of a map part by part: labels, woods and hills, and the masks that lay them over a picture.

use glam::Vec2;

use crate::annotate::labels::{LEAST_EM, find_out, labels_in, on_map_with_regions, quartered};
use crate::annotate::place::{Label, Places, Scenery, heading};
use crate::annotate::scenery;
use crate::map::Map;
use crate::paint::{AnnotationMasks, SceneryPainter, Scheme, View, letters, scenery_look};

/// An annotation that is being made.
#[derive(Clone, Debug, Default)]
pub struct AnnotationBuilder {
    /// Once they are placed.
    labels: Option<Vec<Label>>,
    scenery: Scenery,
    /// `true` if all of the scenery is placed.
    is_placed: bool,
    /// While that is drawn.
    painter: Option<SceneryPainter>,
}

impl AnnotationBuilder {
    /// Makes all of an annotation at once, for a picture with `ratio` pixels to a CSS pixel, rounded to quarters from 0.5
    /// to 4.
    pub fn whole(map: &Map, view: &View, ratio: f32) -> AnnotationMasks {
        Self::default().rest(map, view, ratio)
    }

    /// Makes an annotation with the map's title as a heading in a box of the picture: its upper left and its lower right
    /// corner, in pixels. There is no cartouche and no legend then.
    pub(super) fn headed(map: &Map, view: &View, ratio: f32, within: [Vec2; 2]) -> AnnotationMasks {
        let (names, _) = on_map_with_regions(map);
        let mut labels = labels_of(&mut Places::default(), map, view, ratio);
        // Without blocks in corners, and without the country's name on its land, which would say the same again.
        labels.retain(|label| !label.kind.is_block() && label.text != names.title);
        let within = within.map(|corner| view.point(corner));
        labels.extend(heading(&names.title, &names.subtitle, within, LEAST_EM * ratio / view.scale));
        Self { labels: Some(labels), ..Self::default() }.rest(map, view, ratio)
    }

    /// Makes the rest of an annotation at once.
    // Once in a module, for all that call it.
    #[inline(never)]
    fn rest(mut self, map: &Map, view: &View, ratio: f32) -> AnnotationMasks {
        let mut places = Places::default();
        loop {
            if let Some(masks) = self.advance(&mut places, map, view, ratio) {
                return masks;
            }
        }
    }

    /// Does a part of an annotation, which takes some milliseconds. Map and picture must be the same each time. Labels
    /// get the places that have been chosen for other pictures of the map. Returns the annotation after the last part.
    pub fn advance(&mut self, places: &mut Places, map: &Map, view: &View, ratio: f32) -> Option<AnnotationMasks> {
        let Some(labels) = &self.labels else {
            if !find_out(places, map) {
                self.labels = Some(labels_of(places, map, view, ratio));
            }
            return None;
        };
        if !self.is_placed {
            self.is_placed = !scenery::input(map, labels).is_some_and(|input| self.scenery.advance(&input));
            return None;
        }
        let Some(look) = scenery_look(Scheme::of(map.recipe())).filter(|_| !self.scenery.placed().is_empty()) else {
            return Some(letters::masks(view, labels));
        };
        if self.painter.is_none() {
            self.painter = SceneryPainter::new(view, look);
        }
        let has_more = |painter: &mut SceneryPainter| painter.advance(view, self.scenery.placed(), look);
        if self.painter.as_mut().is_some_and(has_more) {
            return None;
        }
        let [bodies, strokes] = self.painter.take().map(SceneryPainter::into_masks).unwrap_or_default();
        Some(AnnotationMasks { bodies, strokes, ..letters::masks(view, labels) })
    }

    /// Returns the labels that were placed.
    pub fn into_labels(self) -> Vec<Label> {
        self.labels.unwrap_or_default()
    }
}

// Once in a module, for all that call it.
#[inline(never)]
fn labels_of(places: &mut Places, map: &Map, view: &View, ratio: f32) -> Vec<Label> {
    labels_in(places, map, view.uncovered(), view.scale / quartered(ratio))
}
