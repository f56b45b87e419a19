//! The composition of a picture with a title: all of the land, and above it or at its left a box of open sea for the
//! title.

use glam::Vec2;

use super::Picture;
use super::builder::AnnotationBuilder;
use crate::map::Map;
use crate::paint::Framing;
use crate::session::Session;

/// A rectangle: its upper left and its lower right corner.
type Corners = [Vec2; 2];

/// The part of the map that a picture shows, and its title's place.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Composition {
    /// Left, top and width of the part, and how deep the title covers it from the west, north, east and south, as
    /// [`Framing::of`] takes them; in widths of the map.
    framing: [f32; 7],
    /// The box of the title, in pixels.
    title: Corners,
}

/// The margin around everything, and the space between title and land, as shares of the picture's shorter side.
const MARGIN: f32 = 0.055;
const GAP: f32 = 0.04;
/// The height of a title above the land, and the sides of one beside it, as shares of the free part of the picture.
const ABOVE: f32 = 0.19;
const BESIDE: Vec2 = Vec2::new(0.42, 0.36);
/// The distance of names from the picture's sides, over its margin.
const FROM_SIDES: f32 = 0.4;

/// The width that chats and networks show such pictures with, in CSS pixels. Letters that could not be read there are left out.
const SEEN_WIDTH: f32 = 300.0;

impl Picture {
    /// Shows all of the land of a finished session with its title, whose map is given. The next `paint` shows it, until
    /// the session changes.
    #[doc(hidden)]
    pub fn head(&mut self, session: &Session, map: &Map) {
        let (width, height) = (self.pixmap().width(), self.pixmap().height());
        let Composition { framing, title } = Composition::of(map, (width, height));
        self.frame(session, Framing::of(&framing));
        let masks = AnnotationBuilder::headed(map, self.view(), width as f32 / SEEN_WIDTH, title);
        self.take_annotation(session, masks);
    }
}

impl Composition {
    /// Composes a picture of a map, with its width and height in pixels.
    fn of(map: &Map, (width, height): (u32, u32)) -> Self {
        let size = map.domain().size;
        let [least, most] = map.land().and_then(|land| land.bounds()).unwrap_or([Vec2::ZERO, size]);
        let land = [least, most.min(size)].map(|corner| corner / size.x);
        composed(Vec2::new(width as f32, height as f32), shown(land, size.x / size.y))
    }
}

/// Returns the part of a map that has to be shown: the rectangle around its land, or all of it if the land ends at its border,
/// which is seen then. In widths of the map.
fn shown(land: Corners, aspect: f32) -> Corners {
    /// Less than anybody sees.
    const HAIR: f32 = 1e-3;
    let map = [Vec2::ZERO, Vec2::new(1.0, 1.0 / aspect)];
    let touches = |side: usize| (land[side] - map[side]).abs().min_element() < HAIR;
    if touches(0) || touches(1) { map } else { land }
}

/// Composes a picture of this size in pixels, for a part of a map that has to be shown. Of the two places for the title it
/// takes the one that shows the land larger.
fn composed(size: Vec2, land: Corners) -> Composition {
    let shorter = size.min_element();
    let free = [Vec2::splat(MARGIN * shorter), size - MARGIN * shorter];
    let (above, beside) = (title_above(free, GAP * shorter, land), title_beside(free, GAP * shorter, land));
    let Place { title, corner, scale, covered } = if beside.scale > above.scale { beside } else { above };
    let start = land[0] - corner / scale;
    let [west, north, east, south] = covered.map(|depth| depth.max(FROM_SIDES * MARGIN * shorter) / scale);
    Composition { framing: [start.x, start.y, size.x / scale, west, north, east, south], title }
}

/// The places of title and land on a picture.
struct Place {
    title: Corners,
    /// The corner of the land on the picture.
    corner: Vec2,
    /// The pixels that the map is wide.
    scale: f32,
    /// The depth that the title covers from the west, north, east and south.
    covered: [f32; 4],
}

/// Puts the title above the land, and both in the middle.
fn title_above([least, most]: Corners, gap: f32, land: Corners) -> Place {
    let height = ABOVE * (most.y - least.y);
    let scale = scale_of(land, most - least - Vec2::new(0.0, height + gap));
    let size = (land[1] - land[0]) * scale;
    let top = (least.y + most.y - height - gap - size.y) / 2.0;
    let title = [Vec2::new(least.x, top), Vec2::new(most.x, top + height)];
    let corner = Vec2::new((least.x + most.x - size.x) / 2.0, title[1].y + gap);
    Place { title, corner, scale, covered: [0.0, title[1].y, 0.0, 0.0] }
}

/// Puts the title at the left of the land, which stands at the right.
fn title_beside([least, most]: Corners, gap: f32, land: Corners) -> Place {
    let sides = BESIDE * (most - least);
    let scale = scale_of(land, most - least - Vec2::new(sides.x + gap, 0.0));
    let size = (land[1] - land[0]) * scale;
    let room = most.x - least.x - sides.x - gap;
    let corner = Vec2::new(most.x - f32::midpoint(room, size.x), (least.y + most.y - size.y) / 2.0);
    let top = (least.y + most.y - sides.y) / 2.0;
    let title = [Vec2::new(least.x, top), Vec2::new(least.x + sides.x, top + sides.y)];
    Place { title, corner, scale, covered: [title[1].x, 0.0, 0.0, 0.0] }
}

/// Returns the greatest width of the map, in pixels, with which its land fits.
fn scale_of(land: Corners, room: Vec2) -> f32 {
    (room / (land[1] - land[0])).min_element()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A card, and a portrait, as the page makes them.
    const PICTURES: [Vec2; 2] = [Vec2::new(1200.0, 630.0), Vec2::new(1200.0, 1500.0)];
    /// Boxes around land: wide, square, tall, flat, small in a corner, and narrow.
    const LANDS: [[f32; 4]; 6] = [
        [0.05, 0.05, 0.95, 0.6],
        [0.0, 0.0, 1.0, 1.0],
        [0.1, 0.0, 0.9, 1.5],
        [0.0, 0.1, 1.0, 0.3],
        [0.7, 0.4, 0.95, 0.6],
        [0.2, 0.2, 0.21, 0.9],
    ];

    /// Calls with each picture and land, what is composed of them, the land in pixels, and the pixels that the map is wide.
    fn for_each(try_one: impl Fn(Vec2, Composition, Corners, f32)) {
        for (picture, [left, top, right, bottom]) in PICTURES.into_iter().flat_map(|one| LANDS.map(|land| (one, land)))
        {
            let land = [Vec2::new(left, top), Vec2::new(right, bottom)];
            let composition = composed(picture, land);
            let [left, top, across, ..] = composition.framing;
            let scale = picture.x / across;
            try_one(picture, composition, land.map(|corner| (corner - Vec2::new(left, top)) * scale), scale);
        }
    }

    #[test]
    fn land_and_title_are_inside_and_do_not_meet() {
        for_each(|picture, Composition { title, .. }, land, _| {
            for corner in land.into_iter().chain(title) {
                assert!((corner / picture).min_element() > 0.02, "{corner} of {picture}");
                assert!((corner / picture).max_element() < 0.98, "{corner} of {picture}");
            }
            assert!(land[0].x > title[1].x || land[0].y > title[1].y, "{land:?} of {picture}");
        });
    }

    #[test]
    fn a_title_has_room_for_letters_that_can_be_read_at_300_pixels() {
        for_each(|picture, Composition { title, .. }, land, _| {
            // Nine letters of half an em, and a line under them.
            let em = ((title[1] - title[0]) / Vec2::new(9.0 * 0.6, 1.4)).min_element();
            assert!(em * 0.66 * 300.0 / picture.x > 9.0, "{land:?} of {picture}");
        });
    }

    #[test]
    fn no_other_name_stands_beside_a_title_or_at_an_edge() {
        for_each(|picture, Composition { framing: [_, _, _, covered @ ..], title }, land, scale| {
            let [west, north, ..] = covered.map(|depth| depth * scale);
            assert!(west >= title[1].x - 0.01 || north >= title[1].y - 0.01, "{land:?} of {picture}");
            assert!(covered.iter().all(|depth| depth * scale > 0.02 * picture.min_element()), "{covered:?}");
        });
    }

    #[test]
    fn land_is_as_large_as_it_can_be() {
        let title = |picture, height| composed(picture, [Vec2::ZERO, Vec2::new(1.0, height)]).title[1];
        let [card, portrait] = PICTURES;
        assert!(title(card, 1.5).x < card.x / 2.0, "a tall land stands beside its title");
        assert!(title(card, 0.5).y < card.y / 3.0, "a wide one below it");
        assert!(title(portrait, 1.5).y < portrait.y / 3.0);
    }

    #[test]
    fn land_that_ends_at_the_border_is_shown_with_all_of_the_map() {
        let inner = [Vec2::new(0.1, 0.1), Vec2::new(0.9, 0.5)];
        assert_eq!(shown(inner, 1.6), inner);
        assert_eq!(shown([Vec2::new(0.0, 0.1), inner[1]], 1.6), [Vec2::ZERO, Vec2::new(1.0, 0.625)]);
        assert_eq!(shown([inner[0], Vec2::new(0.9, 0.625)], 1.6), [Vec2::ZERO, Vec2::new(1.0, 0.625)]);
    }
}
