//! PNG pictures and rasters. They contain the link of their recipe.

use std::io::{Error, Write};

use png::{BitDepth, ColorType, DeflateCompression, Encoder, EncodingError, Filter};
use tiny_skia::Pixmap;

use super::ExportError;
use super::rasters::{Layer, Rasters, Values};
use crate::base::memory;

pub use super::rasters::LINK_KEYWORD;

/// Writes an opaque picture, with the link of its recipe in a text chunk.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(out: impl Write, pixmap: &Pixmap, link: &str) -> Result<(), EncodingError> {
    ask(pixmap.data().len() / 4)?;
    let mut encoder = Encoder::new(out, pixmap.width(), pixmap.height());
    encoder.add_text_chunk(LINK_KEYWORD.into(), link.into())?;
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|rgba| rgba[..3].iter().copied()).collect();
    write_pixels(encoder, (ColorType::Rgb, BitDepth::Eight), &rgb)
}

/// Writes a raster in 8 or 16 bits of grey, with the link of its recipe and the meaning of its values in text chunks.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write_raster(out: impl Write, rasters: &Rasters, layer: Layer) -> Result<(), EncodingError> {
    ask(rasters.columns * rasters.rows)?;
    let mut encoder = Encoder::new(out, rasters.columns as u32, rasters.rows as u32);
    for (keyword, text) in rasters.texts(layer) {
        encoder.add_text_chunk(keyword.into(), text)?;
    }
    match rasters.values(layer) {
        Values::Bytes(bytes) => write_pixels(encoder, (ColorType::Grayscale, BitDepth::Eight), &bytes),
        Values::Words(words) => {
            let bytes: Vec<u8> = words.into_iter().flat_map(u16::to_be_bytes).collect();
            write_pixels(encoder, (ColorType::Grayscale, BitDepth::Sixteen), &bytes)
        }
    }
}

/// Checks that there is enough memory to write this number of pixels.
fn ask(pixels: usize) -> Result<(), EncodingError> {
    /// The pixels without alpha, filtered and compressed, in lists that grow by doubling.
    const BYTES_A_PIXEL: usize = 16;
    /// The compressor's own memory.
    const BYTES: usize = 2_000_000;
    let bytes = pixels * BYTES_A_PIXEL + BYTES;
    let refused = |_| ExportError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 };
    Ok(memory::ask(bytes).map_err(refused).map_err(Error::other)?)
}

/// Writes the pixels. Compression takes a third to a half of the time of the crate's balanced setting. With the right
/// filter, files of flat pictures become a quarter smaller, and those of shaded ones up to a fifteenth larger.
fn write_pixels(
    mut encoder: Encoder<'_, impl Write>,
    (color, depth): (ColorType, BitDepth),
    bytes: &[u8],
) -> Result<(), EncodingError> {
    /// Higher levels double the time and hardly make files smaller.
    const LEVEL: u8 = 3;
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.set_deflate_compression(DeflateCompression::Level(LEVEL));
    let bytes_a_pixel = color.samples() * if depth == BitDepth::Sixteen { 2 } else { 1 };
    encoder.set_filter(if is_flat(bytes, bytes_a_pixel) { Filter::NoFilter } else { Filter::Adaptive });
    encoder.write_header()?.write_image_data(bytes)
}

/// Returns `true` if at least three fifths of all pixels equal the one before, as in areas of one colour. Runs and
/// patterns then compress better than the differences that filters make.
fn is_flat(bytes: &[u8], bytes_a_pixel: usize) -> bool {
    let pairs = bytes.chunks_exact(bytes_a_pixel).zip(bytes.chunks_exact(bytes_a_pixel).skip(1));
    pairs.filter(|(before, pixel)| before == pixel).count() * 5 >= bytes.len() / bytes_a_pixel * 3
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;
    use tiny_skia::PremultipliedColorU8;

    const SIDE: usize = 40;

    /// Makes a picture whose colour changes after every `run` pixels.
    fn striped(run: usize) -> Option<Pixmap> {
        let mut pixmap = Pixmap::new(SIDE as u32, SIDE as u32)?;
        for (i, pixel) in pixmap.pixels_mut().iter_mut().enumerate() {
            let shade = (i / run * 7 % 256) as u8;
            *pixel = PremultipliedColorU8::from_rgba(shade, 255 - shade, shade / 2, 255)?;
        }
        Some(pixmap)
    }

    #[test]
    fn flat_and_shaded_pictures_are_read_as_they_were_written() {
        for (run, flat) in [(1, false), (2, false), (3, true), (SIDE, true)] {
            let pixmap = striped(run).unwrap();
            let rgb: Vec<u8> =
                pixmap.pixels().iter().flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect();
            assert_eq!(is_flat(&rgb, 3), flat, "runs of {run}");
            let mut file = Vec::new();
            write(&mut file, &pixmap, "seed=kauri").unwrap();
            let mut reader = png::Decoder::new(Cursor::new(file)).read_info().unwrap();
            let mut pixels = vec![0; rgb.len()];
            reader.next_frame(&mut pixels).unwrap();
            assert!(pixels == rgb, "runs of {run}");
        }
    }

    #[test]
    fn a_picture_without_two_pixels_is_written() {
        assert!(!is_flat(&[1, 2, 3], 3));
    }
}
