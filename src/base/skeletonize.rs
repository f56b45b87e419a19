//! Thinning by Zhang and Suen (1984): turns a pattern of pixels into lines one pixel wide, as in section 6.1 of the
//! paper.

/// The smallest coverage of a pixel that counts as set.
pub(crate) const IS_SET: u8 = 128;

/// Thins a mask of the given width in place. Pixels of the lines become 255, all others 0.
///
/// Only set pixels are visited, so the cost depends on the length of the rivers, not on the size of the picture.
pub(crate) fn thin(pixels: &mut [u8], width: usize) {
    let mut set: Vec<usize> = Vec::new();
    for (i, pixel) in pixels.iter_mut().enumerate() {
        *pixel = if *pixel >= IS_SET { 255 } else { 0 };
        if *pixel != 0 {
            set.push(i);
        }
    }
    let mut going: Vec<usize> = Vec::new();
    loop {
        let before = set.len();
        for is_first_pass in [true, false] {
            going.clear();
            going.extend(set.iter().filter(|&&i| goes(neighbours(pixels, width, i), is_first_pass)));
            going.iter().for_each(|&i| pixels[i] = 0);
            set.retain(|&i| pixels[i] != 0);
        }
        if set.len() == before {
            return;
        }
    }
}

/// Returns the eight neighbours of pixel `i` as bits, clockwise from the one above (the paper's P2 to P9). Pixels
/// outside the picture are not set.
fn neighbours(pixels: &[u8], width: usize, i: usize) -> u8 {
    const CLOCKWISE: [(isize, isize); 8] = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1)];
    let (x, y) = ((i % width) as isize, (i / width) as isize);
    let is_set = |x: isize, y: isize| {
        (0..width as isize).contains(&x)
            && y >= 0
            && pixels.get(y as usize * width + x as usize).is_some_and(|&p| p != 0)
    };
    CLOCKWISE.iter().enumerate().fold(0, |bits, (bit, (dx, dy))| bits | u8::from(is_set(x + dx, y + dy)) << bit)
}

/// Returns `true` if a pixel with these neighbours is removed in this pass.
fn goes(neighbours: u8, is_first_pass: bool) -> bool {
    const UP: u8 = 1;
    const RIGHT: u8 = 1 << 2;
    const DOWN: u8 = 1 << 4;
    const LEFT: u8 = 1 << 6;
    let all_set = |mask: u8| neighbours & mask == mask;
    // The number of steps from empty to set around the circle: a bit is not set and the next one is.
    let starts = (!neighbours & neighbours.rotate_right(1)).count_ones();
    let keeps_ends_and_insides = (2..=6).contains(&neighbours.count_ones()) && starts == 1;
    let on_the_pass_s_side = if is_first_pass {
        !all_set(UP | RIGHT | DOWN) && !all_set(RIGHT | DOWN | LEFT)
    } else {
        !all_set(UP | RIGHT | LEFT) && !all_set(UP | DOWN | LEFT)
    };
    keeps_ends_and_insides && on_the_pass_s_side
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thinned(picture: &str) -> String {
        let rows: Vec<&str> = picture.lines().map(str::trim).filter(|row| !row.is_empty()).collect();
        let width = rows[0].len();
        let mut pixels: Vec<u8> = rows.concat().bytes().map(|c| if c == b'#' { 255 } else { 0 }).collect();
        thin(&mut pixels, width);
        let text = |row: &[u8]| row.iter().map(|&p| if p == 0 { '.' } else { '#' }).collect::<String>();
        pixels.chunks(width).map(text).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn thick_bar_becomes_a_line() {
        let bar = "..........\n.########.\n.########.\n.########.\n..........";
        assert_eq!(thinned(bar), "..........\n..........\n..#####...\n..........\n..........");
    }

    #[test]
    fn thin_line_is_left_alone() {
        let line = "#.....\n.#....\n..###.\n.....#";
        assert_eq!(thinned(line), line);
    }

    #[test]
    fn picture_s_left_edge_is_not_its_right() {
        let line = "#....\n#....\n#....\n.....\n....#";
        assert_eq!(thinned(line), line);
    }
}
