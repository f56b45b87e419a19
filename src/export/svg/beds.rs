//! Great rivers and their former beds. Each kept round, and the rivers as they are, take two shapes: all beds with the
//! line beside them, and all beds without it.

use super::outline;
use super::path::Path;
use super::text::Text;
use crate::network::Banks;
use crate::network::{Network, PastCourse, PastCourses, Place};
use crate::paint::beds::great_rivers;
use crate::paint::palette::{Beds, Colour};
use crate::recipe::CourseShape;

/// Draws the former beds, a group for each round, the oldest first.
pub(super) fn draw_past(out: &mut Text, past: &PastCourses, look: &Beds, courses: CourseShape) {
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
        let wide = |place: &Place| Place { half: Beds::half(place, margin), ..*place };
        let mut path = Path::default();
        for bed in beds.into_iter().flatten() {
            outline(&mut path, &Banks::of_line(bed.line.iter().map(wide).collect(), courses), courses);
        }
        out.text("<path fill=\"").colour(colour).text("\" d=\"").path(&path).text("\"/>\n");
    }
}
