//! Textures as PNG, with the link of their recipe.

use std::io::{Error, Result, Write};

use png::{BitDepth, ColorType, DeflateCompression, Encoder, Filter};
use riverseed::export::rasters::LINK_KEYWORD;
use riverseed::tiny_skia::Pixmap;

use crate::memory::ask;

/// Asks for the memory that a texture with this many values takes, with its filtered and its compressed bytes.
fn ask_for(values: usize) -> Result<()> {
    const BYTES_A_VALUE: usize = 4;
    const BYTES: usize = 2_000_000;
    ask(values * BYTES_A_VALUE + BYTES)
}

/// Writes a texture of bytes.
pub fn write(
    out: impl Write,
    sides: [usize; 2],
    color: ColorType,
    bytes: &[u8],
    link: &str,
    meaning: &str,
) -> Result<()> {
    /// As in the core's pictures: higher levels double the time and hardly make files smaller.
    const LEVEL: u8 = 3;
    ask_for(bytes.len())?;
    let mut encoder = Encoder::new(out, sides[0] as u32, sides[1] as u32);
    encoder.add_text_chunk(LINK_KEYWORD.into(), link.into()).map_err(Error::from)?;
    encoder.add_text_chunk("Description".into(), meaning.into()).map_err(Error::from)?;
    encoder.set_color(color);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_deflate_compression(DeflateCompression::Level(LEVEL));
    encoder.set_filter(Filter::Adaptive);
    Ok(encoder.write_header()?.write_image_data(bytes)?)
}

/// Widens a picture to a square, with the map in the middle: around it is the mean colour of its corners.
pub fn square(picture: &Pixmap) -> Result<Pixmap> {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let side = width.max(height);
    ask(side * side * 4)?;
    let mut square = Pixmap::new(side as u32, side as u32).ok_or_else(|| Error::other("the picture has no pixels"))?;
    let around = border(picture);
    square.data_mut().chunks_exact_mut(4).for_each(|pixel| pixel.copy_from_slice(&around));
    let (west, north) = ((side - width) / 2, (side - height) / 2);
    for (row, pixels) in picture.data().chunks_exact(width * 4).enumerate() {
        let start = ((north + row) * side + west) * 4;
        square.data_mut()[start..start + width * 4].copy_from_slice(pixels);
    }
    Ok(square)
}

/// Returns the mean colour of the corners of a picture, which are sea on maps that have one around them.
fn border(picture: &Pixmap) -> [u8; 4] {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let corners =
        [0, width - 1, (height - 1) * width, height * width - 1].map(|pixel| &picture.data()[pixel * 4..][..4]);
    std::array::from_fn(|channel| (corners.iter().map(|pixel| u32::from(pixel[channel])).sum::<u32>() / 4) as u8)
}
