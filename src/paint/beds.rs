//! Great rivers and their former beds, one band for each round with the oldest at the bottom, as Fisk drew those of the
//! Mississippi (1944).

use super::belts::Belts;
use super::coverage::Coverage;
use super::ground::{lay_mask, river_share, without_rivers};
use super::palette::{Beds, Colour};
use super::rivers::{Rivers, VISIBLE_PX, draw_line};
use super::view::View;
use crate::network::{Network, PastCourse, PastCourses, Place};
use crate::recipe::CourseShape;

/// The ground with great rivers and their former beds. It is kept from round to round, because most bands do not change
/// any more.
#[derive(Clone, Debug, Default)]
pub(super) struct GroundWithBeds {
    /// The ground with the bands that will not change, and their number. First come the plains and the old scars.
    settled: Vec<[u8; 4]>,
    bands: usize,
    /// The ground with all bands and the current great rivers. It shows no other rivers.
    pub pixels: Vec<[u8; 4]>,
}

/// The number of bands under those of the rounds.
const UNDER: usize = 1 + Belts::SCARS;

impl GroundWithBeds {
    /// Lays one more band; after the last one, brings the rest up to date with the rivers. Returns `true` if there is
    /// more to lay. Between two calls, only rounds of meandering may have changed the rivers.
    pub fn advance(&mut self, look: &Beds, view: &View, rivers: &Rivers<'_>, ground: &[[u8; 4]]) -> bool {
        let Some(mask) = Coverage::new(view.width, view.height) else { return false };
        let mut drawing = Drawing { view, courses: rivers.settings.courses, mask, ground };
        if self.settled.is_empty() {
            self.settled = ground.to_vec();
        }
        // The last band stays open: loops that are cut off later still belong to it.
        let rounds = rivers.past.rounds().len();
        if rounds > 0 && self.bands < UNDER + rounds - 1 {
            match self.bands.checked_sub(UNDER) {
                None => drawing.belt(look, &Belts::of(rivers.network, rivers.past), self.bands, &mut self.settled),
                Some(band) => drawing.band(look, rivers.past, band, &mut self.settled),
            }
            self.bands += 1;
            return true;
        }
        self.pixels.clone_from(&self.settled);
        drawing.band(look, rivers.past, self.bands.saturating_sub(UNDER), &mut self.pixels);
        let now = [&great_rivers(rivers.network, rivers.past)[..], &[]];
        drawing.draw(now, Beds::BANK, look.bank, 1.0, &mut self.pixels);
        drawing.hide(&mut self.pixels);
        drawing.draw(now, 0.0, look.water, 1.0, &mut self.pixels);
        false
    }
}

impl Beds {
    /// The widths of the lines beside a former bed and beside a river, in units.
    pub const LINE: f32 = 0.5;
    pub const BANK: f32 = 1.1;

    /// The width of the line around a flood plain, in units.
    pub const BLUFF: f32 = 0.7;

    /// Returns half the width of a bed at a place of its river, including a line beside it, in units. Beside a brook
    /// the line is thinner.
    pub fn half(place: &Place, line: f32) -> f32 {
        const WIDE: f32 = 5.0;
        place.half + line * (place.half / WIDE).min(1.0)
    }

    /// Returns the colour of a band.
    pub fn colour(&self, band: usize) -> Colour {
        self.colours[band % self.colours.len()]
    }
}

/// Returns the rivers that stand out: the great ones or, if none meanders, those of the highest order.
pub(crate) fn great_rivers(network: &Network, past: &PastCourses) -> Vec<PastCourse> {
    let is_great = is_great(network, past);
    let great = (0..).zip(&network.rivers).filter(|(id, river)| is_great(*id, river.order));
    great.map(|(id, river)| PastCourse { river: id, line: network.middle(river) }).collect()
}

/// Tells the rivers that stand out, by their number and order.
pub(crate) fn is_great<'a>(network: &Network, past: &'a PastCourses) -> impl Fn(u32, u8) -> bool + 'a {
    let highest = network.rivers.iter().map(|river| river.order).max();
    move |id, order| match past.great_rivers() {
        [] => Some(order) == highest,
        great => great.contains(&id),
    }
}

struct Drawing<'a> {
    view: &'a View,
    courses: CourseShape,
    mask: Coverage,
    /// The ground; its fourth channel says where rivers are seen.
    ground: &'a [[u8; 4]],
}

impl Drawing<'_> {
    /// Lays the beds of a round that is kept.
    fn band(&mut self, look: &Beds, past: &PastCourses, band: usize, pixels: &mut [[u8; 4]]) {
        let Some(round) = past.rounds().get(band) else { return };
        self.draw(round.beds(), Beds::LINE, look.line, self.crisp(), pixels);
        self.draw(round.beds(), 0.0, look.colour(band), 1.0, pixels);
    }

    /// Returns the strength of lines beside beds. In a small picture they would lie side by side and hide the bands, so
    /// they are fainter.
    fn crisp(&self) -> f32 {
        (1.4 * Beds::LINE * self.view.scale).min(1.0)
    }

    /// Lays the plains, and in further steps the old scars.
    fn belt(&mut self, look: &Beds, belts: &Belts, step: usize, pixels: &mut [[u8; 4]]) {
        match step.checked_sub(1) {
            None => {
                let plains = [&belts.plains[..], &[]];
                self.lay(plains, &|place| place.half + Beds::BLUFF, look.bluff, 1.0, pixels);
                self.lay(plains, &|place| place.half, look.plain, 1.0, pixels);
            }
            Some(scar) => {
                let scars = belts.scars.get(scar).map_or(&[][..], Vec::as_slice);
                self.draw([scars, &[]], Beds::LINE, look.line, self.crisp() * 0.8, pixels);
                self.draw([scars, &[]], 0.0, look.old[scar], 1.0, pixels);
            }
        }
    }

    /// Lays beds in one colour, wider by a margin in units.
    fn draw(&mut self, beds: [&[PastCourse]; 2], margin: f32, colour: Colour, strength: f32, pixels: &mut [[u8; 4]]) {
        self.lay(beds, &|place| Beds::half(place, margin), colour, strength, pixels);
    }

    /// Lays bands along lines in one colour, given half their width at a place, in units.
    fn lay(
        &mut self,
        beds: [&[PastCourse]; 2],
        half: &dyn Fn(&Place) -> f32,
        colour: Colour,
        strength: f32,
        pixels: &mut [[u8; 4]],
    ) {
        self.mask.clear();
        let in_pixels = |place: &Place| (self.view.pixel(place.at), half(place) * self.view.scale + VISIBLE_PX);
        for bed in beds.into_iter().flatten() {
            draw_line(&mut self.mask, &bed.line.iter().map(in_pixels).collect::<Vec<_>>(), self.courses);
        }
        let open = |i: usize| f32::from(river_share(self.ground[i][3])) * strength / 255.0;
        lay_mask(self.mask.mask().data(), colour, &open, pixels);
    }

    /// Hides rivers where something has just been laid.
    fn hide(&self, pixels: &mut [[u8; 4]]) {
        for (pixel, &covered) in pixels.iter_mut().zip(self.mask.mask().data()) {
            pixel[3] = without_rivers(pixel[3], covered);
        }
    }
}
