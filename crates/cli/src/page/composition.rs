//! The composition of a card: all of the land, and above it or at its left a box of open sea for the title. The same
//! as on the page (www/src/files/composition.ts).

use riverseed::glam::Vec2;

/// A rectangle: its upper left and its lower right corner.
pub type Corners = [Vec2; 2];

/// The part of the map that a card shows, and its title's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Composition {
    /// Left, top and width of the part, and how deep the title covers it from the west, north, east and south; in widths
    /// of the map.
    pub framing: [f32; 7],
    /// The box of the title, in pixels.
    pub title: Corners,
}

/// The margin around everything, and the space between title and land, as shares of the card's shorter side.
const MARGIN: f32 = 0.055;
const GAP: f32 = 0.04;
/// The height of a title above the land, and the sides of one beside it, as shares of the free part of the card.
const ABOVE: f32 = 0.19;
const BESIDE: Vec2 = Vec2::new(0.42, 0.36);
/// The distance of names from the card's sides, over its margin.
const FROM_SIDES: f32 = 0.4;

/// Returns the part of a map that has to be shown: the rectangle around its land, or all of it if the land ends at its border,
/// which is seen then. In widths of the map.
pub fn shown(land: Corners, aspect: f32) -> Corners {
    /// Less than anybody sees.
    const HAIR: f32 = 1e-3;
    let map = [Vec2::ZERO, Vec2::new(1.0, 1.0 / aspect)];
    let touches = |side: usize| (land[side] - map[side]).abs().min_element() < HAIR;
    if touches(0) || touches(1) { map } else { land }
}

/// Composes a card of this size in pixels, for a part of a map that has to be shown. Of the two places for the title it
/// takes the one that shows the land larger.
pub fn composed(size: Vec2, land: Corners) -> Composition {
    let shorter = size.min_element();
    let free = [Vec2::splat(MARGIN * shorter), size - MARGIN * shorter];
    let (above, beside) = (title_above(free, GAP * shorter, land), title_beside(free, GAP * shorter, land));
    let Place { title, corner, scale, covered } = if beside.scale > above.scale { beside } else { above };
    let start = land[0] - corner / scale;
    let [west, north, east, south] = covered.map(|depth| depth.max(FROM_SIDES * MARGIN * shorter) / scale);
    Composition { framing: [start.x, start.y, size.x / scale, west, north, east, south], title }
}

/// The places of title and land.
struct Place {
    title: Corners,
    /// The corner of the land on the card.
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

    const CARD: Vec2 = Vec2::new(1200.0, 630.0);

    #[test]
    fn land_and_title_are_inside_and_do_not_meet() {
        for land in [[0.1, 0.1, 0.9, 0.5], [0.4, 0.05, 0.6, 0.6], [0.0, 0.0, 1.0, 0.25], [0.2, 0.2, 0.21, 0.9]] {
            let land = [Vec2::new(land[0], land[1]), Vec2::new(land[2], land[3])];
            let Composition { framing, title } = composed(CARD, land);
            let scale = CARD.x / framing[2];
            let pixels = land.map(|corner| (corner - Vec2::new(framing[0], framing[1])) * scale);
            for corner in pixels.into_iter().chain(title) {
                assert!(corner.min_element() >= 30.0 && (CARD - corner).min_element() >= 30.0, "{corner}");
            }
            assert!(pixels[0].x > title[1].x || pixels[0].y > title[1].y, "{land:?}");
        }
    }

    #[test]
    fn land_that_ends_at_the_border_is_shown_with_all_of_the_map() {
        let inner = [Vec2::new(0.1, 0.1), Vec2::new(0.9, 0.5)];
        assert_eq!(shown(inner, 1.6), inner);
        assert_eq!(shown([Vec2::new(0.0, 0.1), inner[1]], 1.6), [Vec2::ZERO, Vec2::new(1.0, 0.625)]);
        assert_eq!(shown([inner[0], Vec2::new(0.9, 0.625)], 1.6), [Vec2::ZERO, Vec2::new(1.0, 0.625)]);
    }
}
