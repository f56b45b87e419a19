//! Gaps between lines.

use super::SIDE;
use crate::base::work;

/// The distances of places from the nearest line.
pub(super) struct Gaps {
    /// Standard deviation over mean. Evenly spread parallel lines have 0.58, and it rises as land is covered unevenly.
    pub variation: f64,
    /// The radius of the largest empty disc inside the piece, in pixels.
    pub largest_disc: f32,
}

impl Gaps {
    /// Looks at every second corner of pixels in every second row. A corner is never on a line of one pixel.
    pub fn of(pixels: &[u8]) -> Self {
        let columns = above_or_below(pixels);
        let (mut sum, mut squares, mut count, mut largest_disc) = (0.0, 0.0, 0.0, 0.0f32);
        for y in (1..SIDE).step_by(2) {
            // All distances are in halves of a pixel: pixels are at odd places, corners at even ones.
            let down = |x: usize| 2 * columns[(y - 1) * SIDE + x].min(columns[y * SIDE + x]) + 1;
            let down: Vec<usize> = (0..SIDE).map(|x| down(x).pow(2)).collect();
            for x in (1..SIDE).step_by(2) {
                work::count(SIDE);
                let squared = (0..SIDE).map(|other| (2 * x).abs_diff(2 * other + 1).pow(2) + down[other]).min();
                let far = (squared.unwrap_or(0) as f32).sqrt() / 2.0;
                sum += f64::from(far);
                squares += f64::from(far) * f64::from(far);
                count += 1.0;
                let edge = x.min(y).min(SIDE - x).min(SIDE - y);
                largest_disc = largest_disc.max(far.min(edge as f32));
            }
        }
        let mean = sum / count;
        Self { variation: (squares / count - mean * mean).max(0.0).sqrt() / mean, largest_disc }
    }
}

/// Returns the distance of each pixel from the nearest line in its column; twice a side where there is none.
fn above_or_below(pixels: &[u8]) -> Vec<usize> {
    let mut distances: Vec<usize> = pixels.iter().map(|&pixel| if pixel == 0 { 2 * SIDE } else { 0 }).collect();
    for i in SIDE..pixels.len() {
        distances[i] = distances[i].min(distances[i - SIDE] + 1);
    }
    for i in (0..pixels.len() - SIDE).rev() {
        distances[i] = distances[i].min(distances[i + SIDE] + 1);
    }
    distances
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(cases(32))]

        #[test]
        fn distances_are_those_from_the_nearest_of_all_pixels(set in proptest::collection::vec(0..SIDE * SIDE, 1..40)) {
            let mut pixels = vec![0; SIDE * SIDE];
            set.iter().for_each(|&i| pixels[i] = 1);
            let centre = |i: usize| ((i % SIDE) as f64 + 0.5, (i / SIDE) as f64 + 0.5);
            let far = |x: f64, y: f64| {
                let to = |&i: &usize| libm::hypot(centre(i).0 - x, centre(i).1 - y);
                set.iter().map(to).fold(f64::MAX, f64::min)
            };
            let odd = || (1..SIDE).step_by(2).map(|i| i as f64);
            let all: Vec<f64> = odd().flat_map(|y| odd().map(move |x| far(x, y))).collect();
            let mean = all.iter().sum::<f64>() / all.len() as f64;
            let variance = all.iter().map(|far| (far - mean) * (far - mean)).sum::<f64>() / all.len() as f64;
            let gaps = Gaps::of(&pixels);
            prop_assert!((gaps.variation - variance.sqrt() / mean).abs() < 1e-5);
            let edge = |x: f64, y: f64| x.min(y).min(100.0 - x).min(100.0 - y);
            let disc = odd().flat_map(|y| odd().map(move |x| far(x, y).min(edge(x, y)))).fold(0.0, f64::max);
            prop_assert!((f64::from(gaps.largest_disc) - disc).abs() < 1e-4);
        }
    }

    /// Parallel lines 20 pixels apart: distances are 0 to 10 evenly, but for the half gap on the right.
    #[test]
    fn parallel_lines_have_even_gaps() {
        let pixels: Vec<u8> = (0..SIDE * SIDE).map(|i| u8::from((i % SIDE).is_multiple_of(20))).collect();
        let gaps = Gaps::of(&pixels);
        assert!((gaps.variation - 1.0 / 3f64.sqrt()).abs() < 0.1, "{}", gaps.variation);
        assert!((gaps.largest_disc - 9.5).abs() < 0.02, "{}", gaps.largest_disc);
    }
}
