//! Everything that one engine needs, in one archive.

use std::io::{Error, Read, Result, Seek, Write};

use flate2::read::DeflateDecoder;
use rawzip::{RECOMMENDED_BUFFER_SIZE, ZipArchive, ZipArchiveWriter};
use riverseed::Map;
use riverseed::export::pack::{README, add};
use riverseed::export::png;
use riverseed::export::rasters::{Layer, Rasters};
use riverseed::tiny_skia::Pixmap;

use super::beds::lowered;
use super::normals::{self, Green};
use super::splat::{self, GROUNDS};
use super::splines::{self, Axes};
use super::terrain::Terrain;
use super::{recipe, textures};
use crate::form::Engine;

/// Writes the archive of a map. A recipe always gives the same bytes, because files have a fixed time. With beds, the ground
/// is lowered under rivers, whose lines keep the height of the water.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(
    out: impl Write,
    map: &Map,
    engine: Engine,
    rasters: &Rasters,
    picture: &Pixmap,
    has_beds: bool,
) -> Result<()> {
    let (water, link) = (Terrain::of(rasters), rasters.link.as_str());
    let terrain = if has_beds { lowered(&water, map, rasters)? } else { water.clone() };
    let sides = [picture.width(), picture.height()];
    let head = recipe::head(engine, link, rasters.columns as u32, sides, has_beds);
    let mut archive = ZipArchiveWriter::new(out);
    // First, so that it can be read without the rest.
    add(&mut archive, README, |file| file.write_all((head + &recipe::body(engine, &terrain)).as_bytes()))?;
    add(&mut archive, "heights.r16", |file| terrain.write_raw(file))?;
    let shares = splat::shares(rasters, &terrain)?;
    if engine == Engine::Unreal {
        for (ground, (name, _)) in GROUNDS.iter().enumerate() {
            let name = format!("layers/{name}.png");
            add(&mut archive, &name, |file| splat::write_mask(file, &terrain, &shares, ground, link))?;
        }
    } else {
        add(&mut archive, "splat.png", |file| splat::write(file, &terrain, &shares, link))?;
    }
    drop(shares);
    let green = if engine == Engine::Unreal { Green::Down } else { Green::Up };
    add(&mut archive, "normals.png", |file| normals::write(file, &terrain, green, link))?;
    for layer in [Layer::Land, Layer::Rivers] {
        let name = format!("{}.png", layer.name());
        add(&mut archive, &name, |file| Ok(png::write_raster(file, rasters, layer)?))?;
    }
    add(&mut archive, "splines.json", |file| splines::write(file, map, &water, Axes::Of(engine)))?;
    let square = textures::square(picture)?;
    add(&mut archive, "map.png", |file| Ok(png::write(file, &square, link)?))?;
    archive.finish().map(drop).map_err(Error::other)
}

/// Returns `true` if an archive is complete and is the one that would be made for this.
///
/// # Errors
/// Fails with the reader's errors, also if it is no archive.
pub fn is_of(
    file: &std::fs::File,
    engine: Engine,
    link: &str,
    side: u32,
    picture: [u32; 2],
    has_beds: bool,
) -> Result<bool> {
    let mut file = file.try_clone()?;
    file.rewind()?;
    let mut buffer = vec![0; RECOMMENDED_BUFFER_SIZE];
    let archive = ZipArchive::from_file(file, &mut buffer).map_err(Error::other)?;
    let mut entries = archive.entries(&mut buffer);
    let Some(entry) = entries.next_entry().map_err(Error::other)? else { return Ok(false) };
    let head = recipe::head(engine, link, side, picture, has_beds);
    let content = archive.get_entry(entry.wayfinder()).map_err(Error::other)?;
    let mut start = Vec::new();
    DeflateDecoder::new(content.reader()).take(head.len() as u64).read_to_end(&mut start)?;
    Ok(start == head.as_bytes())
}
