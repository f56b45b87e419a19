//! Steps: the sizes of pictures for which letters are placed once.

use glam::Vec2;

use super::rows::Row;
use crate::annotate::glyph::Typeface;
use crate::annotate::labels::{LEAST_EM, labels_in, quartered};
use crate::annotate::place::{Label, Places, STEPS, least_em_of, step_for};
use crate::map::Map;
use crate::paint::View;

/// Returns the step of a picture with `ratio` pixels to a CSS pixel; `None` if it shows less than the whole map, or more, or if it is
/// smaller than all steps.
pub(super) fn step_of(view: &View, ratio: f32) -> Option<usize> {
    /// The most that the map may reach over a side, in pixels: what rounding to whole pixels takes.
    const ROUNDING: f32 = 1.5;
    let corners = view.frame().map(|corner| view.pixel(corner));
    let ends = [Vec2::ZERO, view.domain()].map(|corner| view.pixel(corner));
    let is_whole = (corners[0] - ends[0]).abs().max((corners[1] - ends[1]).abs()).max_element() <= ROUNDING;
    step_for(LEAST_EM * quartered(ratio) / view.scale).filter(|_| is_whole && !view.is_framed())
}

/// Returns the labels of a picture, placed and rounded as carried ones are; `None` if it has no step, or if the map has woods or
/// hills, which stand where letters leave them room.
pub fn stepped(map: &Map, view: &View, ratio: f32) -> Option<Vec<Label>> {
    let step = step_of(view, ratio).filter(|_| map.recipe().scenery() == [0.0; 2])?;
    let faces = Typeface::all();
    Some(rows(&mut Places::default(), map, step).iter().map(|row| row.label(faces)).collect())
}

/// Returns the labels of all steps.
pub(super) fn all_rows(map: &Map) -> Vec<Vec<Row>> {
    let mut places = Places::default();
    (0..STEPS).map(|step| rows(&mut places, map, step)).collect()
}

fn rows(places: &mut Places, map: &Map, step: usize) -> Vec<Row> {
    let labels = labels_in(places, map, [Vec2::ZERO, map.domain().size], LEAST_EM / least_em_of(step));
    labels.iter().map(Row::of).collect()
}
