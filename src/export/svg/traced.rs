//! Areas of a picture's masks as paths. What a mask hides in pixels is a hole in a path here, so that it is absent, not
//! black: readers that take a mask of SVG by its brightness and those that take it by its opacity then see the same.

use glam::Vec2;

use super::path::Path;
use crate::base::memory;
use crate::base::simplify::significance;
use crate::domain::Domain;
use crate::land::trace::rings;
use crate::paint::{SparseMask, View};

/// The pixels per unit of the masks that are traced. The rings run between pixels by their coverage, so they are more exact.
const SCALE: f32 = 1.0;

/// Makes the view of masks that are traced; `None` if there is not enough memory for the tracing.
pub(super) fn view(domain: &Domain) -> Option<View> {
    /// The coverage of a pixel, and the crossings on two of its sides.
    const BYTES_A_PIXEL: usize = 12;
    let [width, height] = [domain.size.x, domain.size.y].map(|side| (side * SCALE).round() as u32);
    let view = View::new(domain, width, height).ok()?;
    memory::can_allocate(BYTES_A_PIXEL * width as usize * height as usize).then_some(view)
}

/// Makes a path of the rings around all that a mask covers by more than a share. Filled by the rule of even and odd, it is what they
/// enclose.
pub(super) fn area(view: &View, mask: &SparseMask, share: f32) -> Path {
    let mut path = Path::default();
    add(&mut path, view, mask, share);
    path
}

/// Makes a path of a map without what a mask covers by more than a share, by the same rule.
pub(super) fn rest(view: &View, mask: &SparseMask, share: f32) -> Path {
    let mut path = Path::default();
    let Vec2 { x, y } = view.domain();
    path.line(&[Vec2::ZERO, Vec2::new(x, 0.0), Vec2::new(x, y), Vec2::new(0.0, y)]);
    path.close();
    add(&mut path, view, mask, share);
    path
}

fn add(path: &mut Path, view: &View, mask: &SparseMask, share: f32) {
    /// The area of a corner that is cut off, in square units.
    const FINE: f32 = 0.12;
    let size = Vec2::new(view.width as f32, view.height as f32);
    // Rings are traced where a share is a half.
    let mut shares = vec![0.5 - share; view.width as usize * view.height as usize];
    mask.pixels().for_each(|(pixel, covered)| shares[pixel] += f32::from(covered) / 255.0);
    for ring in rings(view.width as usize, shares, 0.0) {
        let points: Vec<Vec2> = ring.into_iter().map(|at| view.point(at * size)).collect();
        let corners = points.iter().zip(significance(&points, true)).filter(|(_, area)| *area >= FINE);
        path.line(&corners.map(|(at, _)| *at).collect::<Vec<_>>());
        path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a mask of a map of 1000 pixels a side, with some of them covered.
    fn mask(covered: impl Fn(usize, usize) -> u8) -> (View, SparseMask) {
        let view = view(&Domain::with_aspect(1.0)).unwrap();
        let pixels: Vec<u8> = (0..1_000_000).map(|i| covered(i % 1000, i / 1000)).collect();
        (view, SparseMask::of(&pixels))
    }

    #[test]
    fn a_square_of_pixels_is_a_ring_around_it_and_a_hole_in_the_rest() {
        let (view, mask) = mask(|x, y| if (10..20).contains(&x) && (30..40).contains(&y) { 255 } else { 0 });
        // Corners are cut off, by half a pixel at most.
        let ring = "M10.5 30l-0.5 0.5 0 9 0.5 0.5 9 0 0.5-0.5 0-9-0.5-0.5z";
        assert_eq!(area(&view, &mask, 0.5).data(), ring);
        assert_eq!(rest(&view, &mask, 0.5).data(), format!("M0 0l1000 0 0 1000-1000 0z{ring}"));
    }

    #[test]
    fn what_fades_has_wider_rings_for_lower_shares() {
        // A slope over 100 pixels, to either side of a line.
        let (view, mask) = mask(|x, _| 255 - (x.abs_diff(500).min(100) * 255 / 100) as u8);
        for (share, half) in [(0.25, 75.0), (0.5, 50.0), (0.75, 25.0)] {
            let data = area(&view, &mask, share);
            let start: Vec<f32> =
                data.data()[1..data.data().find('l').unwrap()].split(' ').map(|x| x.parse().unwrap()).collect();
            assert!(((start[0] - 500.5).abs() - half).abs() < 0.6, "{share}: {start:?}");
        }
    }

    #[test]
    fn what_covers_nothing_leaves_the_whole_map() {
        let (view, mask) = mask(|_, _| 0);
        assert_eq!(
            (area(&view, &mask, 0.5).data(), rest(&view, &mask, 0.5).data()),
            ("", "M0 0l1000 0 0 1000-1000 0z")
        );
    }
}
