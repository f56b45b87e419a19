//! PNG pictures and rasters, which carry the link they were drawn from.

use std::io::Write;

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use tiny_skia::Pixmap;

use super::rasters::{Layer, Rasters, Values};

pub use super::rasters::LINK_KEYWORD;

/// Writes an opaque picture, with the link of its recipe in a text chunk.
///
/// # Errors
/// Those of the writer.
pub fn write(out: impl Write, pixmap: &Pixmap, link: &str) -> Result<(), EncodingError> {
    let mut encoder = Encoder::new(out, pixmap.width(), pixmap.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.add_text_chunk(LINK_KEYWORD.into(), link.into())?;
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|rgba| rgba[..3].iter().copied()).collect();
    encoder.write_header()?.write_image_data(&rgb)
}

/// Writes a raster in shades of grey, of 8 bits or 16, with the link of its recipe and what its values mean in text chunks.
///
/// # Errors
/// Those of the writer.
pub fn write_raster(out: impl Write, rasters: &Rasters, layer: Layer) -> Result<(), EncodingError> {
    let mut encoder = Encoder::new(out, rasters.columns as u32, rasters.rows as u32);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_compression(Compression::Balanced);
    for (keyword, text) in rasters.texts(layer) {
        encoder.add_text_chunk(keyword.into(), text)?;
    }
    match rasters.values(layer) {
        Values::Bytes(bytes) => {
            encoder.set_depth(BitDepth::Eight);
            encoder.write_header()?.write_image_data(&bytes)
        }
        Values::Words(words) => {
            encoder.set_depth(BitDepth::Sixteen);
            let bytes: Vec<u8> = words.into_iter().flat_map(u16::to_be_bytes).collect();
            encoder.write_header()?.write_image_data(&bytes)
        }
    }
}
