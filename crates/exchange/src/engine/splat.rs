//! Splat maps: the shares of four kinds of ground in each pixel, which always add up to 255.

use std::io::{Result, Write};

use png::ColorType;
use riverseed::export::rasters::{Layer, Rasters, Values};

use super::terrain::Terrain;
use super::textures;
use crate::memory::ask;

/// The first words of the description of a splat map.
pub const SUBJECT: &str = "The shares of four kinds of ground";

/// The kinds of ground in the order of the channels: the names of their masks and their descriptions.
pub const GROUNDS: [(&str, &str); 4] = [
    ("low", "low ground, such as grass"),
    ("steep", "steep ground, such as rock"),
    ("shore", "shores, the beds of rivers and the floor of the sea, such as sand"),
    ("high", "high ground, such as scree or snow"),
];

/// Slopes between which ground becomes steep, in units of height on a unit: whatever the scale, the same ground is steep.
const STEEP: [f64; 2] = [1.5, 2.1];
/// Shares of the highest land's height between which ground becomes high.
const HIGH: [f64; 2] = [0.5, 0.7];
/// Heights over the sea between which a shore ends, in units.
const SHORE: [f64; 2] = [0.24, 0.8];

/// Computes the shares of all pixels of a landscape, four bytes each.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn shares(rasters: &Rasters, terrain: &Terrain) -> Result<Vec<u8>> {
    ask(terrain.columns * terrain.rows * 6)?;
    let widths = match rasters.values(Layer::Rivers) {
        Values::Words(widths) => widths,
        Values::Bytes(_) => Vec::new(),
    };
    let (highest, metres_up) = (terrain.highest(), f64::from(terrain.scale.metres_up));
    let cells = (0..terrain.rows).flat_map(|row| (0..terrain.columns).map(move |column| (column, row)));
    let texel = |((column, row), width): ((usize, usize), &u16)| {
        let height = terrain.height(column as isize, row as isize);
        let slope = terrain.slope(column, row).length() * terrain.scale.metres_a_unit / metres_up;
        grounds(height / metres_up, height / highest, slope, *width > 0)
    };
    Ok(cells.zip(&widths).flat_map(texel).collect())
}

/// Divides a pixel: water takes its share first, then what is steep, then what is high; the rest is low.
fn grounds(height: f64, share_of_highest: f64, slope: f64, is_river: bool) -> [u8; 4] {
    let shore = if is_river || height <= 0.0 { 1.0 } else { 1.0 - smooth(height, SHORE) };
    let steep = (1.0 - shore) * smooth(slope, STEEP);
    let high = (1.0 - shore - steep) * smooth(share_of_highest, HIGH);
    let [shore, steep, high] = [shore, steep, high].map(|share| (share * 255.0) as u8);
    [255 - shore - steep - high, steep, shore, high]
}

/// Rises from 0 at the first edge to 1 at the second one, without a kink.
fn smooth(x: f64, [from, to]: [f64; 2]) -> f64 {
    let share = ((x - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Writes the splat map of a landscape: red, green, blue and alpha are the four kinds of ground.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(out: impl Write, terrain: &Terrain, shares: &[u8], link: &str) -> Result<()> {
    let [low, steep, shore, high] = GROUNDS.map(|(_, what)| what);
    let meaning =
        format!("{SUBJECT}, which add up to 255: red is {low}; green is {steep}; blue is {shore}; alpha is {high}.");
    textures::write(out, [terrain.columns, terrain.rows], ColorType::Rgba, shares, link, &meaning)
}

/// Writes the mask of one ground of a landscape, in grey.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write_mask(out: impl Write, terrain: &Terrain, shares: &[u8], ground: usize, link: &str) -> Result<()> {
    let mask: Vec<u8> = shares.iter().skip(ground).step_by(GROUNDS.len()).copied().collect();
    let meaning = format!("The share of {}, from 0 to 255.", GROUNDS[ground].1);
    textures::write(out, [terrain.columns, terrain.rows], ColorType::Grayscale, &mask, link, &meaning)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grounds_share_a_pixel_whole() {
        for height in [-8.0, 0.0, 0.01, 0.3, 0.5, 12.0, 40.0] {
            for slope in [0.0, 1.6, 1.8, 6.0] {
                for share in [0.0, 0.55, 0.65, 1.0] {
                    for is_river in [false, true] {
                        let shares = grounds(height, share, slope, is_river);
                        assert_eq!(shares.iter().map(|share| u32::from(*share)).sum::<u32>(), 255);
                    }
                }
            }
        }
    }

    #[test]
    fn each_ground_has_pixels_of_its_own() {
        assert_eq!(grounds(4.0, 0.1, 0.2, false), [255, 0, 0, 0]);
        assert_eq!(grounds(4.0, 0.1, 4.0, false), [0, 255, 0, 0]);
        assert_eq!(grounds(4.0, 0.1, 4.0, true), [0, 0, 255, 0]);
        assert_eq!(grounds(-1.0, -0.1, 0.0, false), [0, 0, 255, 0]);
        assert_eq!(grounds(36.0, 0.9, 0.2, false), [0, 0, 0, 255]);
    }
}
