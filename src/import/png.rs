//! PNG pictures of any kind, decoded to eight bits a channel.

use std::io::{BufRead, Seek};

use png::{ColorType, Decoder, DecodingError, Limits, Transformations};
use thiserror::Error;

use crate::land::trace::LONGEST_SIDE;

/// The greatest memory that decoding may take, in bytes: enough for the largest picture at sixteen bits a channel.
const MEMORY: usize = (LONGEST_SIDE as usize).pow(2) * 8 + (1 << 20);

/// A decoded picture.
#[derive(Clone, Debug)]
pub struct Image {
    /// Width, in pixels.
    pub width: u32,
    /// Height, in pixels.
    pub height: u32,
    /// Four bytes a pixel, row by row, not premultiplied.
    pub rgba: Vec<u8>,
}

/// A file that cannot be read as a picture.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The file is not a PNG, or is damaged.
    #[error("this is not a readable PNG: {0}")]
    Png(#[from] DecodingError),
    /// A side is longer than the limit.
    #[error("the picture is too large: {width} x {height} pixels, at most {LONGEST_SIDE} x {LONGEST_SIDE} are read")]
    TooLarge {
        /// Width, in pixels.
        width: u32,
        /// Height, in pixels.
        height: u32,
    },
}

/// Reads a picture. Its size is checked before its pixels are decoded.
///
/// # Errors
/// Fails if the file is not a PNG, or if a side is longer than [`LONGEST_SIDE`].
pub fn read(from: impl BufRead + Seek) -> Result<Image, ImportError> {
    let mut decoder = Decoder::new_with_limits(from, Limits { bytes: MEMORY });
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    let (width, height) = decoder.read_header_info().map(|header| (header.width, header.height))?;
    if width.max(height) > LONGEST_SIDE {
        return Err(ImportError::TooLarge { width, height });
    }
    let mut reader = decoder.read_info()?;
    let mut bytes = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let frame = reader.next_frame(&mut bytes)?;
    bytes.truncate(frame.buffer_size());
    let rgba = match frame.color_type {
        ColorType::GrayscaleAlpha => {
            bytes.chunks_exact(2).flat_map(|grey| [grey[0], grey[0], grey[0], grey[1]]).collect()
        }
        _ => bytes,
    };
    Ok(Image { width, height, rgba })
}
