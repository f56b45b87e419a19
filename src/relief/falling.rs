//! Heights that fall along given ways of water.

/// Raises land that is not higher than the cell that its water runs to by the least step there is. `next` is that cell; what `is_level`
/// and the sea, at heights of 0 and less, stay as high as they are.
#[doc(hidden)] // for the crate that writes files
pub fn let_fall(heights: &mut [f32], next: impl Fn(usize) -> Option<usize>, is_level: impl Fn(usize) -> bool) {
    let mut is_done: Vec<bool> = (0..heights.len()).map(|cell| heights[cell] <= 0.0 || is_level(cell)).collect();
    let mut upstream = Vec::new();
    for start in 0..heights.len() {
        let mut cell = Some(start);
        while let Some(open) = cell.filter(|cell| !is_done[*cell]) {
            is_done[open] = true;
            upstream.push(open);
            cell = next(open);
        }
        let mut below = cell.map_or(f32::NEG_INFINITY, |cell| heights[cell]);
        while let Some(cell) = upstream.pop() {
            heights[cell] = heights[cell].max(below.next_up());
            below = heights[cell];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn land_falls_the_sea_and_lakes_stay() {
        let mut heights = [-4.0, 2.0, 1.0, 1.0, 1.0, 0.5];
        let_fall(&mut heights, |cell| cell.checked_sub(1), |cell| (2..4).contains(&cell));
        assert_eq!(heights, [-4.0, 2.0, 1.0, 1.0, 1.0f32.next_up(), 1.0f32.next_up().next_up()]);
    }

    #[test]
    fn land_that_falls_already_keeps_its_heights() {
        let mut heights = [3.0, 2.0, 1.0];
        let_fall(&mut heights, |cell| Some(cell + 1).filter(|next| *next < 3), |_| false);
        assert_eq!(heights, [3.0, 2.0, 1.0]);
    }
}
