//! Tracing of pictures of lands: black is water, white is land, and a third colour is a ridge.

mod areas;
mod contour;
mod frame;
mod ground;
mod heightmap;
mod mask;
mod ridges;

use glam::Vec2;
use thiserror::Error;

use self::frame::Frame;
pub(super) use self::ground::SPECK;
use self::ground::{Detail, Ground};
use self::heightmap::looks_like_heights;
use super::queries::LEAST_DRAWN;
use super::strokes::DrawError;
use crate::base::memory;
use crate::recipe::Outline;

/// The longest side of a picture that is traced, in pixels.
pub const LONGEST_SIDE: u32 = 4096;
/// The shortest side of a picture that is traced, in pixels.
pub const SHORTEST_SIDE: u32 = 16;

/// The reason why a picture is not a land.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TraceError {
    /// A side is longer than the limit.
    #[error("the picture is too large: {width} x {height} pixels, at most {LONGEST_SIDE} x {LONGEST_SIDE} are traced")]
    TooLarge {
        /// Width, in pixels.
        width: u32,
        /// Height, in pixels.
        height: u32,
    },
    /// A side is shorter than the limit.
    #[error(
        "the picture is too small: {width} x {height} pixels, at least {SHORTEST_SIDE} x {SHORTEST_SIDE} are needed"
    )]
    TooSmall {
        /// Width, in pixels.
        width: u32,
        /// Height, in pixels.
        height: u32,
    },
    /// The data does not have four bytes a pixel.
    #[error("the picture has {bytes} bytes in place of four for each of {width} x {height} pixels")]
    Bytes {
        /// The number of bytes.
        bytes: usize,
        /// Width, in pixels.
        width: u32,
        /// Height, in pixels.
        height: u32,
    },
    /// The mask does not have one value a pixel.
    #[error("the mask has {pixels} values in place of one for each of {width} x {height} pixels")]
    Pixels {
        /// The number of values.
        pixels: usize,
        /// Width, in pixels.
        width: u32,
        /// Height, in pixels.
        height: u32,
    },
    /// There was not enough memory.
    #[error("the picture needs about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// Approximate memory that is needed.
        megabytes: u32,
    },
    /// The picture is transparent everywhere.
    #[error("the picture is empty: all of it is transparent")]
    Empty,
    /// No land.
    #[error("the picture is all water: land is white, water black")]
    AllWater,
    /// No water.
    #[error("the picture is all land: land is white, water black")]
    AllLand,
    /// Both colours occur, but one only in lines that are lost between areas of the other.
    #[error("the {what} is too thin to trace: draw it {pixels} pixels wide or wider, or choose a smaller picture")]
    TooThin {
        /// The colour that is lost, `land` or `water`.
        what: &'static str,
        /// The width that would suffice, in pixels.
        pixels: u32,
    },
    /// The picture holds nothing but specks.
    #[error("nothing of the picture is large enough to keep: {0}")]
    Nothing(DrawError),
}

/// The result of tracing a picture.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Traced {
    /// The outline, with as much of the picture as there is room for.
    pub outline: Outline,
    /// The number of coasts in the picture, without specks. The outline may have fewer.
    pub coasts: usize,
    /// The number of ridges in the picture.
    pub ridges: usize,
    /// The aspect of the map for the outline: the nearest to the picture's that a recipe can have.
    pub aspect: f32,
    /// `true` if the picture is longer than that. It then lies in the middle of the map, and whatever touches its long
    /// sides continues beyond.
    pub is_longer: bool,
    /// `true` if the picture looks like a heightmap, which is not what is traced: over 16 greys cover over a tenth of it.
    pub looks_like_heights: bool,
}

/// The share of a picture's pixels below which a colour is dust.
const DUST: f32 = 1e-4;

/// Traces a picture, given as RGBA bytes row by row, not premultiplied.
///
/// Dark and transparent pixels are water, light ones are land. Shades between count by their lightness, so that soft
/// edges are traced between pixels. Ridges are strong colours (channels that differ by 96 or more) and greys of 96 to
/// 160, except soft edges between something darker and something lighter. Ridges become lines along their middles or,
/// if they are too wide for a line, around them: no river grows within. Specks are left out, and the rest is simplified
/// until it fits an outline's text.
///
/// # Errors
/// Fails if the picture's size is out of range, or if it shows no coast.
pub fn trace(width: u32, height: u32, rgba: &[u8]) -> Result<Traced, TraceError> {
    check_is_picture(width, height, rgba)?;
    let ground = Ground::of(width as usize, height as usize, rgba, &Detail::OUTLINE);
    let frame = Frame::of(&ground);
    let (coasts, ridges) = lines(&ground, |at| frame.place(at))?;
    let (all_coasts, all_ridges) = (coasts.len(), ridges.len());
    let outline = Outline::from_polylines(coasts, ridges, Vec::new()).map_err(|error| match error {
        DrawError::NoWater => too_thin(&ground, "water"),
        DrawError::TooSmall if ground.light > 2.0 * LEAST_DRAWN => too_thin(&ground, "land"),
        error => TraceError::Nothing(error),
    })?;
    Ok(Traced {
        outline,
        coasts: all_coasts,
        ridges: all_ridges,
        aspect: frame.aspect,
        is_longer: frame.aspect != ground.aspect(),
        looks_like_heights: looks_like_heights(rgba),
    })
}

/// Traces the coasts and ridges of a picture, placed on its map.
fn lines(ground: &Ground, place: impl Fn(Vec2) -> Vec2) -> Result<(Lines, Lines), TraceError> {
    let (mut coasts, mut ridges) = (contour::rings(ground), ridges::lines(ground));
    // A ring with all points on the border is that border.
    if !coasts.iter().flatten().any(|point| point.min_element() > 0.0 && point.max_element() < 1.0) {
        return Err(match ground.light {
            light if light < DUST => TraceError::AllWater,
            light if light > 1.0 - DUST => TraceError::AllLand,
            light => too_thin(ground, if light < 0.5 { "land" } else { "water" }),
        });
    }
    coasts.iter_mut().chain(&mut ridges).flatten().for_each(|point| *point = place(*point));
    Ok((coasts, ridges))
}

/// Lines as points, in fractions of a width and a height.
type Lines = Vec<Vec<Vec2>>;

fn too_thin(ground: &Ground, what: &'static str) -> TraceError {
    TraceError::TooThin { what, pixels: 2 * ground.block as u32 }
}

/// Traces the closed lines around blocks that are more land than water, without specks, in fractions of the width and
/// height of all blocks.
pub(crate) fn rings(columns: usize, land: Vec<f32>, speck: f32) -> Lines {
    contour::rings(&Ground::of_blocks(columns, land, speck))
}

fn check_is_picture(width: u32, height: u32, rgba: &[u8]) -> Result<(), TraceError> {
    check_size(width, height, rgba.len())?;
    let is_empty = rgba.chunks_exact(4).all(|pixel| pixel[3] == 0);
    if is_empty { Err(TraceError::Empty) } else { Ok(()) }
}

fn check_size(width: u32, height: u32, bytes: usize) -> Result<(), TraceError> {
    if width.max(height) > LONGEST_SIDE {
        return Err(TraceError::TooLarge { width, height });
    }
    if width.min(height) < SHORTEST_SIDE {
        return Err(TraceError::TooSmall { width, height });
    }
    if bytes != width as usize * height as usize * 4 {
        return Err(TraceError::Bytes { bytes, width, height });
    }
    ask(width as usize * height as usize)
}

/// Asks for the memory that a picture with a number of pixels takes until it is land.
fn ask(pixels: usize) -> Result<(), TraceError> {
    /// The colours of a mask.
    const BYTES_A_PIXEL: usize = 4;
    /// Sums and shares, and the lines around land.
    const BYTES_A_BLOCK: usize = 32;
    /// Distances from the coast, the grid of land, and short lists.
    const BYTES: usize = 16_000_000;
    let bytes = pixels * BYTES_A_PIXEL + pixels.min(Detail::MOST_BLOCKS) * BYTES_A_BLOCK + BYTES;
    memory::ask(bytes).map_err(|_| TraceError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    const BLACK: [u8; 4] = [0, 0, 0, 255];
    const WHITE: [u8; 4] = [255; 4];
    const RED: [u8; 4] = [220, 30, 30, 255];
    const GREY: [u8; 4] = [128, 128, 128, 255];

    fn picture(width: u32, height: u32, colour: impl Fn(Vec2) -> [u8; 4]) -> Vec<u8> {
        let at = |i: u32| Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        (0..width * height).flat_map(|i| colour(at(i))).collect()
    }

    fn disc(width: u32, height: u32, centre: Vec2, radius: f32) -> Vec<u8> {
        picture(width, height, |at| if at.distance(centre) < radius { WHITE } else { BLACK })
    }

    #[test]
    fn a_ring_for_each_block_without_a_bound_on_specks() {
        let land = [[0.0; 5], [0.0, 1.0, 0.0, 1.0, 0.0], [0.0; 5]].concat();
        let lengths: Vec<usize> = rings(5, land, 0.0).iter().map(Vec::len).collect();
        assert_eq!(lengths, [4, 4], "sides that no ring crosses are no rings");
    }

    fn is_land(outline: &Outline, at: Vec2) -> bool {
        let mut is_land = false;
        for ring in outline.coasts() {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let (a, b) = (a.fraction(), b.fraction());
                is_land ^= (a.y > at.y) != (b.y > at.y) && at.x > a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y);
            }
        }
        is_land
    }

    /// Returns the share of pixels on which the outline agrees with the picture.
    fn agreement(width: u32, height: u32, rgba: &[u8], outline: &Outline) -> f32 {
        let size = Vec2::new(width as f32, height as f32);
        let at = |i: u32| Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5) / size;
        let same = (0..width * height).filter(|&i| (rgba[i as usize * 4] > 127) == is_land(outline, at(i)));
        same.count() as f32 / (width * height) as f32
    }

    #[test]
    fn a_disc_keeps_its_area_at_any_resolution() {
        for (width, height) in [(60, 60), (300, 200), (900, 700), (2000, 1500)] {
            let radius = height as f32 * 0.35;
            let rgba = disc(width, height, Vec2::new(width as f32, height as f32) / 2.0, radius);
            let outline = trace(width, height, &rgba).unwrap().outline;
            let points: Vec<Vec2> = outline.coasts()[0].iter().map(|point| point.fraction()).collect();
            let area: f32 = points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b) / 2.0).sum();
            let expected = std::f32::consts::PI * radius * radius / (width * height) as f32;
            assert!((area.abs() / expected - 1.0).abs() < 0.01, "{width} x {height}: {area} is not {expected}");
            assert_eq!(outline.coasts().len(), 1);
        }
    }

    #[test]
    fn land_that_runs_off_the_picture_does_so_in_the_outline() {
        let rgba = picture(200, 100, |at| if at.y < 50.0 + 20.0 * libm::sinf(at.x / 15.0) { WHITE } else { BLACK });
        let outline = trace(200, 100, &rgba).unwrap().outline;
        for at in [Vec2::new(1e-4, 1e-4), Vec2::new(0.9999, 1e-4), Vec2::new(0.5, 1e-4), Vec2::new(1e-4, 0.3)] {
            assert!(is_land(&outline, at), "{at}");
        }
        assert!(agreement(200, 100, &rgba, &outline) > 0.98);
    }

    #[test]
    fn lakes_and_islands_in_them_are_kept_and_specks_are_not() {
        let rgba = picture(300, 300, |at| match at.distance(Vec2::splat(150.0)) {
            d if d < 30.0 => WHITE,
            d if d < 60.0 => BLACK,
            d if d < 120.0 => WHITE,
            _ if at.distance(Vec2::splat(10.0)) < 1.5 => WHITE,
            _ => BLACK,
        });
        let outline = trace(300, 300, &rgba).unwrap().outline;
        assert_eq!(outline.coasts().len(), 3);
        assert!(agreement(300, 300, &rgba, &outline) > 0.98);
    }

    #[test]
    fn a_third_colour_becomes_a_line_along_its_middle() {
        for third in [RED, GREY] {
            let rgba = picture(300, 300, |at| match at.distance(Vec2::splat(150.0)) {
                _ if (at.y - 150.0).abs() < 4.0 && (at.x - 150.0).abs() < 80.0 => third,
                d if d < 120.0 => WHITE,
                _ => BLACK,
            });
            let outline = trace(300, 300, &rgba).unwrap().outline;
            assert_eq!((outline.coasts().len(), outline.ridges().len()), (1, 1), "{third:?}");
            let ends: Vec<Vec2> = outline.ridges()[0].iter().map(|point| point.fraction()).collect();
            assert!(ends.iter().all(|end| (end.y - 0.5).abs() < 0.01), "{ends:?}");
            assert!(ends[0].distance(ends[ends.len() - 1]) > 0.48, "{ends:?}");
        }
    }

    #[test]
    fn soft_edges_are_no_ridges() {
        let rgba = picture(300, 300, |at| {
            // The columns between are grey from top to bottom.
            let light = ((at.x - 149.0) / 3.0).clamp(0.0, 1.0) * 255.0;
            [light as u8, light as u8, light as u8, 255]
        });
        assert_eq!(trace(300, 300, &rgba).unwrap().ridges, 0);
    }

    #[test]
    fn pictures_without_a_coast_are_refused_by_name() {
        let all = |colour| trace(40, 40, &picture(40, 40, |_| colour)).unwrap_err();
        assert_eq!(all(BLACK), TraceError::AllWater);
        assert_eq!(all(WHITE), TraceError::AllLand);
        assert_eq!(all(RED), TraceError::AllLand);
        assert_eq!(all([0; 4]), TraceError::Empty);
        assert_eq!(trace(5000, 10, &[]), Err(TraceError::TooLarge { width: 5000, height: 10 }));
        assert_eq!(trace(0, 0, &[]), Err(TraceError::TooSmall { width: 0, height: 0 }));
        assert_eq!(trace(20, 20, &[0; 7]), Err(TraceError::Bytes { bytes: 7, width: 20, height: 20 }));
        let speck = disc(400, 400, Vec2::splat(200.0), 9.0);
        assert_eq!(trace(400, 400, &speck), Err(TraceError::Nothing(DrawError::TooSmall)));
    }

    #[test]
    fn what_is_too_thin_is_called_so_and_as_wide_as_asked_for_it_is_traced() {
        for (size, ground, line, name) in
            [(300, BLACK, WHITE, "land"), (1400, BLACK, WHITE, "land"), (1400, WHITE, BLACK, "water")]
        {
            // At several positions relative to the blocks.
            let lines = |width: f32| {
                let is_line = |at: Vec2| ((at.x + at.y) % (size as f32 / 4.7) - 50.0).abs() < width / 2.0;
                picture(size, size, |at| if is_line(at) { line } else { ground })
            };
            let Err(TraceError::TooThin { what, pixels }) = trace(size, size, &lines(1.0)) else {
                panic!("{size}: {name} of one pixel is traced");
            };
            assert_eq!(what, name);
            let traced = trace(size, size, &lines(pixels as f32 * 1.5));
            assert!(traced.as_ref().is_ok_and(|traced| traced.coasts >= 5), "{size}: {pixels}: {traced:?}");
        }
    }

    #[test]
    fn a_wide_area_of_the_third_colour_is_traced_around() {
        for (width, height) in [(90, 60), (800, 600), (1500, 1400)] {
            let size = Vec2::new(width as f32, height as f32);
            let rgba = picture(width, height, |at| {
                let from_middle = ((at - size / 2.0) / size).abs();
                match from_middle {
                    d if d.x < 0.2 && d.y < 0.12 => RED,
                    d if d.length() < 0.4 => WHITE,
                    _ => BLACK,
                }
            });
            let traced = trace(width, height, &rgba).unwrap();
            assert_eq!((traced.coasts, traced.ridges), (1, 1), "{width} x {height}");
            let ring: Vec<Vec2> = traced.outline.ridges()[0].iter().map(|point| point.fraction()).collect();
            assert_eq!(ring.first(), ring.last());
            let area: f32 = ring.windows(2).map(|pair| pair[0].perp_dot(pair[1]) / 2.0).sum();
            assert!((area.abs() / (0.4 * 0.24) - 1.0).abs() < 0.05, "{width} x {height}: {area}");
        }
    }

    #[test]
    fn an_area_may_have_a_hole_and_lines_of_its_colour_apart_from_it_stay_lines() {
        let rgba = picture(400, 400, |at| match at.distance(Vec2::new(150.0, 200.0)) {
            d if (40.0..75.0).contains(&d) => RED,
            _ if (at.x - 290.0).abs() < 3.0 && (at.y - 200.0).abs() < 80.0 => RED,
            _ if at.distance(Vec2::splat(200.0)) < 180.0 => WHITE,
            _ => BLACK,
        });
        let traced = trace(400, 400, &rgba).unwrap();
        let is_closed = |line: &&Vec<crate::recipe::GridPoint>| line.first() == line.last();
        let (closed, open): (Vec<_>, Vec<_>) = traced.outline.ridges().iter().partition(is_closed);
        assert_eq!((traced.ridges, closed.len(), open.len()), (3, 2, 1));
        assert!(open[0].iter().all(|point| (point.fraction().x - 0.725).abs() < 0.01), "{open:?}");
    }

    #[test]
    fn what_is_found_is_counted_and_what_is_kept_may_be_less() {
        let at = |i: usize| Vec2::new((i % 10) as f32, (i / 10) as f32) * 60.0 + 30.0;
        let rgba = picture(600, 600, |here| {
            if (0..100).any(|i| here.distance(at(i)) < 15.0 + i as f32 / 10.0) { WHITE } else { BLACK }
        });
        let traced = trace(600, 600, &rgba).unwrap();
        assert_eq!((traced.coasts, traced.ridges), (100, 0));
        assert!((30..80).contains(&traced.outline.coasts().len()), "{}", traced.outline.coasts().len());
    }

    #[test]
    fn a_picture_longer_than_any_map_is_not_squeezed_and_what_leaves_it_goes_on() {
        for is_tall in [false, true] {
            let (width, height) = if is_tall { (100, 800) } else { (800, 100) };
            let turned = |at: Vec2| if is_tall { Vec2::new(at.y, at.x) } else { at };
            // A disc, and land that runs off both long sides.
            let rgba = picture(width, height, |at| match turned(at) {
                at if at.distance(Vec2::new(200.0, 50.0)) < 40.0 => WHITE,
                at if (at.x - 600.0).abs() < 100.0 => WHITE,
                _ => BLACK,
            });
            let traced = trace(width, height, &rgba).unwrap();
            assert_eq!((traced.aspect, traced.coasts), (if is_tall { 0.25 } else { 4.0 }, 2));
            assert!(traced.is_longer);
            let spans = traced.outline.coasts().iter().map(|ring| {
                let points: Vec<Vec2> = ring.iter().map(|point| turned(point.fraction())).collect();
                let [low, high] = [Vec2::min, Vec2::max].map(|end| points.iter().copied().reduce(end).unwrap());
                high - low
            });
            let mut spans: Vec<Vec2> = spans.collect();
            spans.sort_by(|a, b| a.x.total_cmp(&b.x));
            // The map is 4 to 1, so in its fractions the disc is four times as high as wide.
            assert!((spans[0].y / spans[0].x - 4.0).abs() < 0.1, "{spans:?}");
            assert!((spans[0].x - 0.1).abs() < 0.005, "{spans:?}");
            assert!((spans[1].x - 0.25).abs() < 0.01 && spans[1].y == 1.0, "{spans:?}");
        }
    }

    proptest! {
        #![proptest_config(cases(32))]

        #[test]
        fn traced_land_is_the_pictures_land(
            blobs in proptest::collection::vec((0.1f32..0.9, 0.1f32..0.9, 0.2f32..0.4), 1..5),
            width in 150u32..500,
            height in 150u32..500,
        ) {
            let span = width.min(height) as f32;
            let size = Vec2::new(width as f32, height as f32);
            let rgba = picture(width, height, |at| {
                let is_in = |&(x, y, r): &(f32, f32, f32)| at.distance(Vec2::new(x, y) * size) < r * span;
                if blobs.iter().any(is_in) { WHITE } else { BLACK }
            });
            let outline = trace(width, height, &rgba).unwrap().outline;
            let agreement = agreement(width, height, &rgba, &outline);
            prop_assert!(agreement >= 0.98, "{}", agreement);
        }

        #[test]
        fn any_picture_is_traced_or_refused(
            width in 0u32..70,
            height in 0u32..70,
            palette in proptest::collection::vec(any::<[u8; 4]>(), 1..5),
            choices in proptest::collection::vec(any::<u8>(), 4900),
        ) {
            let count = (width * height) as usize;
            let rgba: Vec<u8> =
                choices[..count].iter().flat_map(|&choice| palette[usize::from(choice) % palette.len()]).collect();
            if let Ok(Traced { outline, .. }) = trace(width, height, &rgba) {
                prop_assert!(outline.to_string().len() <= crate::recipe::LONGEST_OUTLINE);
                prop_assert_eq!(Outline::parse(&outline.to_string()), Ok(outline));
            }
        }
    }
}
