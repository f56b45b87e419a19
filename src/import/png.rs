//! PNG pictures of any kind, decoded to eight bits a channel.

use std::io::{BufRead, Seek};

use png::{ColorType, Decoder, DecodingError, Limits, Transformations};
use thiserror::Error;

use crate::base::memory;
use crate::land::trace::LONGEST_SIDE;

/// Checks that there is enough memory to decode a picture with this number of pixels.
fn ask(pixels: usize) -> Result<(), ImportError> {
    /// Grey with alpha takes two bytes a pixel and becomes four; at 16 bits a channel, rows take twice as much before.
    const BYTES_A_PIXEL: usize = 8;
    /// The decoder's own memory.
    const BYTES: usize = 2_000_000;
    let bytes = pixels * BYTES_A_PIXEL + BYTES;
    memory::ask(bytes).map_err(|_| ImportError::OutOfMemory { megabytes: (bytes / 1_000_000) as u32 + 1 })
}

/// Limit on the decoder's memory, in bytes: enough for the largest picture at 16 bits a channel.
const MEMORY: usize = (LONGEST_SIDE as usize).pow(2) * 8 + (1 << 20);

/// A decoded picture.
#[derive(Clone, Debug)]
#[non_exhaustive]
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
    /// There was not enough memory.
    #[error("the picture needs about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// About how much is needed.
        megabytes: u32,
    },
}

/// Reads a picture. Its size is checked before its pixels are decoded.
///
/// # Errors
/// Fails if the file is not a PNG, if a side is longer than [`LONGEST_SIDE`], or if there is not enough memory.
pub fn read(from: impl BufRead + Seek) -> Result<Image, ImportError> {
    let mut decoder = Decoder::new_with_limits(from, Limits { bytes: MEMORY });
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    let (width, height) = decoder.read_header_info().map(|header| (header.width, header.height))?;
    if width.max(height) > LONGEST_SIDE {
        return Err(ImportError::TooLarge { width, height });
    }
    ask(width as usize * height as usize)?;
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use std::io::Cursor;

    use super::*;
    use crate::base::memory::testing::with_lists_up_to;

    #[test]
    fn picture_is_refused_where_there_is_no_memory_for_its_pixels() {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 1000, 500);
        encoder.set_color(ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[255; 500_000]).unwrap();
        let read_within = |bytes| with_lists_up_to(bytes, || read(Cursor::new(&file)));
        assert!(matches!(read_within(3_000_000), Err(ImportError::OutOfMemory { megabytes: 7 })));
        assert_eq!(read_within(6_000_000).unwrap().rgba.len(), 2_000_000);
    }
}
