//! Labels of a finished map.

use riverseed::annotate::place::Places;
use riverseed::paint::{Framing, View};
use riverseed::picture::builder::AnnotationBuilder;
use riverseed::recipe::Recipe;
use riverseed::session::Session;

use super::{Repetition, SIDE};

/// Makes the labels of a part of a map, another one each time: with those of an earlier picture in their places, as in a
/// picture that is moved, or as if it were the first. Returns the number of labels.
pub fn of_parts(recipe: Recipe, are_kept: bool) -> Option<Repetition> {
    let map = Session::new(recipe).ok()?.finish().ok()?;
    let whole = View::new(&map.domain(), SIDE, SIDE).ok()?;
    let mut places = Places::default();
    let mut turn = 0;
    Some(Box::new(move || {
        turn = (turn + 1) % 10;
        let view = whole.framed(&map.domain(), Framing::of(&[0.02 * turn as f32, 0.2, 0.6]));
        if !are_kept {
            places = Places::default();
        }
        let mut builder = AnnotationBuilder::default();
        while builder.advance(&mut places, &map, &view, 1.0).is_none() {}
        builder.into_labels().len() as u32
    }))
}
