//! PNG pictures, which carry the link they were drawn from.

use std::io::Write;

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use tiny_skia::Pixmap;

/// The keyword of the text chunk that holds the link.
pub const LINK_KEYWORD: &str = "riverseed";

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
