//! Pictures and rasters that are there: a PNG, alone or in a pack.

use std::fs::File;
use std::io::{Error, Read, Result};

use flate2::read::DeflateDecoder;
use rawzip::{RECOMMENDED_BUFFER_SIZE, ZipArchive};
use riverseed::export::pack::PICTURE;
use riverseed::export::rasters::{LINK_KEYWORD, Layer};

use super::Asked;
use super::text::{NEAR, contains, ends_with, start};

/// The known parts of a PNG that has not been made yet.
pub struct Png {
    sides: [u32; 2],
    /// The chunk with the link.
    chunk: Vec<u8>,
    /// The beginning of the chunk that explains a raster's values; `None` for a picture.
    meaning: Option<Vec<u8>>,
}

impl Png {
    /// The signature of every PNG, and the beginning of its first chunk, up to the sides.
    const HEAD: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR";
    /// The last chunk of every PNG.
    const END: &[u8] = b"\0\0\0\0IEND\xae\x42\x60\x82";

    /// Expects a picture.
    pub fn picture(asked: &Asked) -> Self {
        Self { sides: asked.picture, chunk: chunk(&asked.link), meaning: None }
    }

    /// Expects a raster or a texture, whose explanation begins with the subject.
    pub fn of_cells(asked: &Asked, subject: &str) -> Self {
        let meaning = [MEANING, subject.as_bytes()].concat();
        Self { sides: asked.rasters, chunk: chunk(&asked.link), meaning: Some(meaning) }
    }

    /// Returns `true` if a file is this PNG, and complete.
    pub fn is_in(&self, file: &mut File) -> Result<bool> {
        Ok(ends_with(file, Self::END)? && self.begins(&start(file, self.chunk.len() + NEAR)?))
    }

    fn begins(&self, start: &[u8]) -> bool {
        let [width, height] = self.sides.map(u32::to_be_bytes);
        let has_meaning = match &self.meaning {
            Some(meaning) => contains(start, meaning),
            None => !contains(start, MEANING),
        };
        start.starts_with(&[Self::HEAD, &width, &height].concat()) && contains(start, &self.chunk) && has_meaning
    }
}

/// The beginning of the chunk that explains a raster's values.
const MEANING: &[u8] = b"tEXtDescription\0";

/// Writes the length, kind and content of the chunk with a link.
fn chunk(link: &str) -> Vec<u8> {
    let content = format!("{LINK_KEYWORD}\0{link}");
    [&(content.len() as u32).to_be_bytes()[..], b"tEXt", content.as_bytes()].concat()
}

/// Returns `true` if a complete archive contains the picture and rasters of the asked size.
pub fn is_pack(file: &File, asked: &Asked) -> Result<bool> {
    let (picture, raster) = (Png::picture(asked), Png::of_cells(asked, Layer::Heights.subject()));
    let mut buffer = vec![0; RECOMMENDED_BUFFER_SIZE];
    let archive = ZipArchive::from_file(file.try_clone()?, &mut buffer).map_err(Error::other)?;
    let mut entries = archive.entries(&mut buffer);
    let mut found = 0;
    while let Some(entry) = entries.next_entry().map_err(Error::other)? {
        // A damaged entry fails here, whichever it is.
        let content = archive.get_entry(entry.wayfinder()).map_err(Error::other)?;
        let name = entry.file_path();
        let png = match name.as_ref() {
            name if name == PICTURE.as_bytes() => &picture,
            name if name == format!("{}.png", Layer::Heights.name()).as_bytes() => &raster,
            _ => continue,
        };
        let mut start = Vec::new();
        DeflateDecoder::new(content.reader()).take((png.chunk.len() + NEAR) as u64).read_to_end(&mut start)?;
        found += u32::from(png.begins(&start));
    }
    Ok(found == 2)
}
