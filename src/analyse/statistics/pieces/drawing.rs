//! Rivers drawn as lines of one pixel.

use glam::Vec2;

use super::SIDE;
use crate::base::{skeletonize, work};
use crate::network::Network;

/// The most pieces along each side of a drawing. A finer network is drawn around the map's middle only.
const MOST: usize = 15;

/// Draws a network at this number of pixels per unit, thins it, and cuts what is around the middle of the map into
/// pieces.
pub(super) fn pieces(network: &Network, size: Vec2, scale: f32) -> Vec<Vec<u8>> {
    let [columns, rows] = [size.x, size.y].map(|side| ((side * scale) as usize / SIDE).min(MOST));
    let shown = Vec2::new((columns * SIDE) as f32, (rows * SIDE) as f32);
    let corner = (size * scale - shown) / 2.0;
    let mut drawing = Drawing { pixels: vec![0; columns * rows * SIDE * SIDE], width: columns * SIDE };
    for river in &network.rivers {
        let mut places = network.course(river).map(|vertex| vertex.at * scale - corner);
        let Some(mut from) = places.next() else { continue };
        for to in places {
            drawing.draw(from, to);
            from = to;
        }
    }
    skeletonize::thin(&mut drawing.pixels, drawing.width.max(1));
    let piece = |column: usize, row: usize| {
        let line = |y: usize| &drawing.pixels[(row * SIDE + y) * drawing.width + column * SIDE..][..SIDE];
        (0..SIDE).flat_map(line).copied().collect()
    };
    (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (column, row)))
        .map(|(column, row)| piece(column, row))
        .collect()
}

struct Drawing {
    pixels: Vec<u8>,
    width: usize,
}

impl Drawing {
    /// Draws a straight line, with a pixel for each step along its longer side.
    fn draw(&mut self, from: Vec2, to: Vec2) {
        let way = to - from;
        let steps = way.abs().max_element() as usize + 1;
        work::count(steps);
        for step in 0..=steps {
            let at = from + way * (step as f32 / steps as f32);
            if at.min_element() >= 0.0
                && (at.x as usize) < self.width
                && let Some(pixel) = self.pixels.get_mut(at.y as usize * self.width + at.x as usize)
            {
                *pixel = 255;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{network, to_sea};
    use super::*;

    /// Cuts a river across a map of 60 by 25 units, 4 pixels to a unit, into two pieces, with 20 pixels left over on
    /// either side.
    #[test]
    fn what_is_around_the_middle_is_cut_into_pieces() {
        let pieces = pieces(&network(&[to_sea(&[(0.0, 12.6), (60.0, 12.6)])]), Vec2::new(60.0, 25.0), 4.0);
        let expected: Vec<u8> = (0..SIDE * SIDE).map(|i| if i / SIDE == 50 { 255 } else { 0 }).collect();
        assert_eq!(pieces, [expected.clone(), expected]);
    }

    #[test]
    fn a_small_map_has_no_pieces_and_a_fine_one_no_more_than_the_most() {
        let count = |scale: f32| pieces(&network(&[]), Vec2::new(60.0, 25.0), scale).len();
        assert_eq!((count(0.0), count(3.9), count(1000.0)), (0, 0, MOST * MOST));
    }
}
