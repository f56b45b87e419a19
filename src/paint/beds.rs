//! Great rivers over their former beds, a band each, the oldest undermost, as Fisk drew those of the Mississippi (1944).

use super::coverage::Coverage;
use super::ground::lay_mask;
use super::palette::{Beds, Colour};
use super::rivers::{Rivers, draw_line};
use super::view::View;
use crate::network::{Network, PastCourses, Place};
use crate::recipe::CourseShape;

/// Lays great rivers and their former beds over a ground. Where the rivers are as they are now, no others show.
pub(super) fn lay(look: &Beds, view: &View, rivers: &Rivers<'_>, ground: &mut [[u8; 4]]) {
    let Some(mask) = Coverage::new(view.width, view.height) else { return };
    let shows = ground.iter().map(|pixel| pixel[3]).collect();
    let mut sheet = Sheet { view, courses: rivers.courses, mask, shows, pixels: ground };
    for (lines, colour) in look.bands(rivers.past) {
        sheet.draw(&lines, Beds::LINE, look.line);
        sheet.draw(&lines, 0.0, colour);
    }
    let now: Vec<_> = great_rivers(rivers.network, rivers.past);
    let now: Vec<&[Place]> = now.iter().map(Vec::as_slice).collect();
    sheet.draw(&now, Beds::BANK, look.bank);
    sheet.hide();
    sheet.draw(&now, 0.0, look.water);
}

impl Beds {
    /// How wide the line beside a former bed is, and beside a river, in units.
    pub const LINE: f32 = 0.8;
    pub const BANK: f32 = 1.3;

    /// Half the width of a bed at a place of its river, with a line beside it, in units; beside a brook the line is thinner.
    pub fn half(place: &Place, line: f32) -> f32 {
        // Wider than the river: fewer, but whole bands are to be seen.
        const WIDER: f32 = 1.25;
        const WIDE: f32 = 3.0;
        place.half * WIDER + line * (place.half / WIDE).min(1.0)
    }

    /// The former beds of each round with their colour, the oldest first.
    pub fn bands<'a>(&self, past: &'a PastCourses) -> impl Iterator<Item = (Vec<&'a [Place]>, Colour)> {
        past.rounds().iter().zip(self.colours).map(|(round, &colour)| {
            (round.courses.iter().chain(&round.loops).map(|course| &course.line[..]).collect(), colour)
        })
    }
}

/// The rivers that stand out: the great ones, or where none meanders those of the highest order.
pub(crate) fn great_rivers(network: &Network, past: &PastCourses) -> Vec<Vec<Place>> {
    let highest = network.rivers.iter().map(|river| river.order).max();
    let is_great = |id: u32, order: u8| match past.great_rivers() {
        [] => Some(order) == highest,
        great => great.contains(&id),
    };
    let great = (0..).zip(&network.rivers).filter(|(id, river)| is_great(*id, river.order));
    great.map(|(_, river)| network.middle(river)).collect()
}

struct Sheet<'a> {
    view: &'a View,
    courses: CourseShape,
    mask: Coverage,
    /// How far rivers show in each pixel of the ground, in 255ths.
    shows: Vec<u8>,
    pixels: &'a mut [[u8; 4]],
}

impl Sheet<'_> {
    /// Lays beds in one colour, each with a margin, in units.
    fn draw(&mut self, lines: &[&[Place]], margin: f32, colour: Colour) {
        self.mask.clear();
        let in_pixels = |place: &Place| (self.view.pixel(place.at), Beds::half(place, margin) * self.view.scale);
        for line in lines {
            draw_line(&mut self.mask, &line.iter().map(in_pixels).collect::<Vec<_>>(), self.courses);
        }
        let open = |i: usize| f32::from(self.shows[i]) / 255.0;
        lay_mask(self.view, &mut self.mask, colour, &open, self.pixels);
    }

    /// Lets no river show where something has just been laid.
    fn hide(&mut self) {
        for (pixel, &covered) in self.pixels.iter_mut().zip(self.mask.mask().data()) {
            pixel[3] = (u32::from(pixel[3]) * u32::from(255 - covered) / 255) as u8;
        }
    }
}
