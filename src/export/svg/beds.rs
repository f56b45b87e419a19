//! Great rivers and their former beds. Each kept round, and the rivers as they are, take two shapes: all beds with the
//! line beside them, and all beds without it.

use super::outline;
use super::path::Path;
use super::text::Text;
use crate::network::{Banks, Network, PastCourse, PastCourses, Place};
use crate::paint::beds::great_rivers;
use crate::paint::belts::Belts;
use crate::paint::palette::{Beds, Colour};
use crate::recipe::CourseShape;

/// Draws flood plains and old scars, then the former beds, a group for each round, the oldest first.
pub(super) fn draw_past(out: &mut Text, network: &Network, past: &PastCourses, look: &Beds, courses: CourseShape) {
    let belts = Belts::of(network, past);
    if !belts.plains.is_empty() {
        out.text("<g id=\"belts\">\n");
        let plains = [&belts.plains[..], &[]];
        lay(out, plains, &|place| place.half + Beds::BLUFF, look.bluff, courses);
        lay(out, plains, &|place| place.half, look.plain, courses);
        for (scars, colour) in belts.scars.iter().zip(look.old) {
            draw(out, [scars, &[]], [(Beds::LINE, look.line), (0.0, colour)], courses);
        }
        out.text("</g>\n");
    }
    for (band, round) in past.rounds().iter().enumerate() {
        out.text("<g id=\"round-").whole(round.round).text("\">\n");
        draw(out, round.beds(), [(Beds::LINE, look.line), (0.0, look.colour(band))], courses);
        out.text("</g>\n");
    }
}

/// Draws the great rivers as they are.
pub(super) fn draw_great(out: &mut Text, network: &Network, past: &PastCourses, look: &Beds, courses: CourseShape) {
    let great = great_rivers(network, past);
    draw(out, [&great, &[]], [(Beds::BANK, look.bank), (0.0, look.water)], courses);
}

fn draw(out: &mut Text, beds: [&[PastCourse]; 2], layers: [(f32, Colour); 2], courses: CourseShape) {
    for (margin, colour) in layers {
        lay(out, beds, &|place| Beds::half(place, margin), colour, courses);
    }
}

/// Draws bands along lines in one colour, given half their width at a place.
fn lay(out: &mut Text, beds: [&[PastCourse]; 2], half: &dyn Fn(&Place) -> f32, colour: Colour, courses: CourseShape) {
    let wide = |place: &Place| Place { half: half(place), ..*place };
    let mut path = Path::default();
    for bed in beds.into_iter().flatten() {
        outline(&mut path, &Banks::of_line(&bed.line.iter().map(wide).collect::<Vec<_>>(), courses), courses);
    }
    out.text("<path fill=\"").colour(colour).text("\" d=\"").path(&path).text("\"/>\n");
}
