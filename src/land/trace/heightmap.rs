//! Pictures of heights, which are easily taken for pictures of land.

/// Returns `true` if a picture, given as RGBA bytes, looks like heights: greys of many levels cover much of it. Soft edges of
/// land have as many, but cover little.
pub(super) fn looks_like_heights(rgba: &[u8]) -> bool {
    /// Greys that are neither nearly black nor nearly white, as scanned paper and ink are.
    const GREYS: std::ops::RangeInclusive<u8> = 16..=239;
    const LEVELS: usize = 16;
    const SHARE: f32 = 0.1;
    let mut counts = [0usize; 256];
    for &[red, green, blue, opacity] in rgba.as_chunks::<4>().0 {
        let is_grey = red == green && green == blue && opacity == u8::MAX;
        if is_grey && GREYS.contains(&red) {
            counts[usize::from(red)] += 1;
        }
    }
    let levels = counts.iter().filter(|count| **count > 0).count();
    levels > LEVELS && counts.iter().sum::<usize>() as f32 > SHARE * (rgba.len() / 4) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a picture of 100 by 100 greys.
    fn greys(grey: impl Fn(usize, usize) -> u8) -> Vec<u8> {
        (0..100 * 100).flat_map(|i| [grey(i % 100, i / 100); 3].into_iter().chain([u8::MAX])).collect()
    }

    #[test]
    fn slopes_look_like_heights() {
        assert!(looks_like_heights(&greys(|x, _| (2 * x) as u8)));
        // An eighth of the picture.
        assert!(looks_like_heights(&greys(|x, y| if y < 13 { (2 * x) as u8 } else { 0 })));
    }

    #[test]
    fn land_with_ridges_and_soft_edges_does_not() {
        let off_middle = |x: usize, y: usize| x.abs_diff(50).max(y.abs_diff(50));
        let softly = |x: usize, y: usize| (255.0 * (31.5 - off_middle(x, y) as f32).clamp(0.0, 1.0)) as u8;
        assert!(!looks_like_heights(&greys(softly)));
        assert!(!looks_like_heights(&greys(|x, y| if x == y { 128 } else { softly(x, y) })));
        // Few greys on all of it, and paper and ink with noise.
        assert!(!looks_like_heights(&greys(|x, _| 100 + (x % 16) as u8)));
        assert!(!looks_like_heights(&greys(|x, y| if x < 50 { (y % 16) as u8 } else { 255 - (y % 16) as u8 })));
        // Colours.
        let mut coloured = greys(|x, _| (2 * x) as u8);
        coloured.chunks_exact_mut(4).for_each(|pixel| pixel[0] = 255);
        assert!(!looks_like_heights(&coloured));
    }
}
