//! Mouths: the sea reaches into the rivers that are wide enough, and fades there, unless their water is the sea's already.

use super::bank;
use super::ground::{level, water};
use super::path::Path;
use super::text::Text;
use crate::deltas::Distributary;
use crate::land::{Land, SmoothedDistance};
use crate::network::{Banks, Network};
use crate::paint::ground::COAST_WIDTH;
use crate::paint::mouths::{Drawn, Tongue};
use crate::paint::palette::Colour;
use crate::recipe::CourseShape;

/// Draws the tongues of the sea in the mouths of rivers, as far as the line of the coast reaches. The halo of letters masks
/// them.
pub(super) fn draw(
    out: &mut Text,
    drawn: &Drawn<'_>,
    (network, distributaries): (&Network, &[Distributary]),
    land: &Land,
    is_masked: bool,
    courses: CourseShape,
) {
    /// The distance that tongues reach beyond the line of the coast, so that nothing of its edge shines through, in units.
    const BEYOND: f32 = 0.2;
    let (shown, sea) = (SmoothedDistance::of(land.coast_distance()), water(drawn.palette));
    let tongues = drawn.tongues(network, distributaries, &shown);
    if tongues.is_empty() {
        return;
    }
    out.text("<clipPath id=\"").own("coastal").text("\"><path d=\"").path(&level(
        &shown,
        -COAST_WIDTH * 0.5 - BEYOND,
        1,
    ));
    out.text("\"/></clipPath>\n<g id=\"mouths\" clip-path=\"").url("coastal");
    if is_masked {
        out.text("\" mask=\"").url("halo");
    }
    if drawn.opening.is_some() {
        out.text("\" fill=\"").colour(sea).text("\">\n");
        for tongue in &tongues {
            out.text("<path d=\"").path(&outline(tongue, courses)).text("\"/>\n");
        }
    } else {
        out.text("\">\n");
        fading(out, &tongues, sea, courses);
    }
    out.text("</g>\n");
}

/// Draws tongues that fade upstream.
fn fading(out: &mut Text, tongues: &[Tongue], sea: Colour, courses: CourseShape) {
    /// The number of steps in which the sea fades, each a ramp.
    const STOPS: u32 = 8;
    out.text("<radialGradient id=\"").own("fading").text("\">");
    for away in (0..=STOPS).map(|stop| stop as f32 / STOPS as f32) {
        out.text("<stop offset=\"").units(away).text("\" stop-color=\"").colour(sea);
        out.text("\" stop-opacity=\"").units(Tongue::share(away)).text("\"/>");
    }
    out.text("</radialGradient>\n");
    for (number, tongue) in (0..).zip(tongues) {
        out.text("<radialGradient id=\"").own("mouth").text("-").whole(number);
        out.text("\" href=\"#").own("fading").text("\" gradientUnits=\"userSpaceOnUse\" cx=\"").units(tongue.at().x);
        out.text("\" cy=\"").units(tongue.at().y).text("\" r=\"").units(tongue.reach).text("\"/>\n<path fill=\"url(#");
        out.own("mouth").text("-").whole(number).text(")\" d=\"").path(&outline(tongue, courses)).text("\"/>\n");
    }
}

/// Makes the outline of a tongue, from bank to bank with straight ends.
fn outline(tongue: &Tongue, courses: CourseShape) -> Path {
    let mut path = Path::default();
    let Banks { left, mut right, .. } = Banks::of_reach(tongue.whole_line(), courses);
    right.reverse();
    if let (Some(&source), Some(&end)) = (left.first(), right.first()) {
        path.start(source);
        bank(&mut path, &left, courses);
        path.straight(&[source, end]);
        bank(&mut path, &right, courses);
        path.close();
    }
    path
}
