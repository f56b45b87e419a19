//! GeoTIFF (OGC 19-008r4): rasters and the picture at their place, in metres.

use std::io::{Cursor, Error, Result, Write};

use riverseed::Map;
use riverseed::domain::Domain;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::Vec2;
use riverseed::paint::View;
use riverseed::tiny_skia::Pixmap;
use tiff::TiffResult;
use tiff::encoder::colortype::{ColorType, Gray8, Gray16, Gray32, Gray32Float, RGB8};
use tiff::encoder::{Compression, DeflateLevel, Predictor, TiffEncoder, TiffValue};
use tiff::tags::Tag;

use super::crs::{self, Crs};
use super::heights;
use crate::memory::ask;
use crate::xml::escaped;

/// The tag of GDAL's own metadata.
pub(crate) const GDAL_METADATA: Tag = Tag::Unknown(42112);

/// The place of an image and its texts.
struct Frame {
    sides: [usize; 2],
    /// The north-western corner, in metres.
    corner: [f64; 2],
    /// The sides of a pixel, in metres.
    pixel: [f64; 2],
    link: String,
    description: String,
    /// The value of pixels that hold nothing.
    no_data: Option<&'static str>,
    crs: Crs,
}

/// Writes a raster of a map in a coordinate system: heights, and widths of rivers, in metres.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write_raster(out: impl Write, domain: &Domain, rasters: &Rasters, layer: Layer, crs: Crs) -> Result<()> {
    const BYTES_A_CELL: usize = 20;
    ask(rasters.columns * rasters.rows * BYTES_A_CELL)?;
    let frame = Frame { crs, ..Frame::of_raster(domain, rasters, layer) };
    let plain = Predictor::None;
    match (layer, rasters.values(layer)) {
        (Layer::Heights, _) => write::<Gray32Float>(out, &frame, plain, &heights::metres(rasters)),
        (Layer::Rivers, _) => write::<Gray32Float>(out, &frame, plain, &rasters.real_widths()),
        (Layer::Depth, _) => write::<Gray32Float>(out, &frame, plain, &rasters.metres_of_water()),
        // More than 65,535 basins do not fit into the words of a PNG.
        (Layer::Basins, _) => write::<Gray32>(out, &frame, Predictor::Horizontal, &rasters.flow().basins),
        (_, Values::Bytes(bytes)) => write::<Gray8>(out, &frame, plain, &bytes),
        (_, Values::Words(words)) => write::<Gray16>(out, &frame, plain, &words),
    }
}

/// Writes the picture of a map in a coordinate system.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write_picture(out: impl Write, map: &Map, picture: &Pixmap, link: &str, crs: Crs) -> Result<()> {
    ask(picture.data().len())?;
    let frame = Frame { crs, ..Frame::of_picture(map, picture, link)? };
    let pixels: Vec<u8> = picture.data().chunks_exact(4).flat_map(|rgba| rgba[..3].iter().copied()).collect();
    write::<RGB8>(out, &frame, Predictor::Horizontal, &pixels)
}

/// Returns the first words of the description of a raster, which no other file has.
pub fn subject(layer: Layer) -> &'static str {
    match layer {
        Layer::Heights => "Heights in metres",
        Layer::Rivers => "Width of the river in metres",
        Layer::Depth => "Depth of water in metres",
        Layer::Basins => "Number of the river basin",
        layer => layer.subject(),
    }
}

/// The first words of the description of a picture.
pub const PICTURE: &str = "The picture of a map";

impl Frame {
    fn of_raster(domain: &Domain, rasters: &Rasters, layer: Layer) -> Self {
        let more = match layer {
            Layer::Heights => " over the sea; less than 0 at sea, and every cell of land is higher than the one that its water runs to".into(),
            Layer::Rivers => " that drains as much land in nature, 0 where none is drawn".into(),
            Layer::Depth => " in the sea and in lakes, 0 where there is none".into(),
            Layer::Basins => ", counted from 1; 0 at sea, and where water runs to the sea in no river".into(),
            layer => rasters.meaning(layer).trim_start_matches(layer.subject()).to_owned(),
        };
        let no_data = match layer {
            Layer::Rivers | Layer::Flow | Layer::Basins => Some("0"),
            _ => None,
        };
        Self {
            sides: [rasters.columns, rasters.rows],
            corner: crs::place(domain, &rasters.map_scale, Vec2::ZERO),
            pixel: [rasters.metres_a_pixel(); 2],
            link: rasters.link.clone(),
            description: format!("{}{more}", subject(layer)),
            no_data,
            crs: Crs::Own,
        }
    }

    fn of_picture(map: &Map, picture: &Pixmap, link: &str) -> Result<Self> {
        let sides = [picture.width(), picture.height()];
        let [north_west, south_east] = View::new(&map.domain(), sides[0], sides[1])
            .map_err(Error::other)?
            .frame()
            .map(|corner| crs::place(&map.domain(), &map.scale(), corner));
        Ok(Self {
            sides: sides.map(|side| side as usize),
            corner: north_west,
            pixel: [
                (south_east[0] - north_west[0]) / f64::from(sides[0]),
                (north_west[1] - south_east[1]) / f64::from(sides[1]),
            ],
            link: link.into(),
            description: PICTURE.into(),
            no_data: None,
            crs: Crs::Own,
        })
    }
}

/// Lists the keys of a coordinate system, and the texts that they refer to: pixels are areas, and the system is a plane in metres
/// with a name, or a projected one. Where there is no system there are none, or GDAL makes up one of its own.
pub fn keys(crs: Crs) -> (Vec<u16>, String) {
    const MODEL: u16 = 1024;
    const PIXELS: u16 = 1025;
    const CITATION: u16 = 1026;
    const SYSTEM: u16 = 3072;
    const UNIT: u16 = 3076;
    const TEXTS: u16 = 34737;
    const OWN: u16 = 32_767;
    const PROJECTED: u16 = 1;
    const METRE: u16 = 9001;
    let name = format!("{}|", crs::NAME);
    let pixels = [PIXELS, 0, 1, 1];
    let keys = match crs {
        Crs::Own => {
            vec![[MODEL, 0, 1, OWN], pixels, [CITATION, TEXTS, name.len() as u16, 0], [UNIT, 0, 1, METRE]]
        }
        Crs::Unknown => return (Vec::new(), String::new()),
        Crs::Epsg(system) => vec![[MODEL, 0, 1, PROJECTED], pixels, [SYSTEM, 0, 1, system.number()]],
    };
    let head = [1, 1, 0, keys.len() as u16];
    ([head].into_iter().chain(keys).flatten().collect(), if crs == Crs::Own { name } else { String::new() })
}

/// Writes an image with its place.
fn write<C: ColorType>(mut out: impl Write, frame: &Frame, predictor: Predictor, values: &[C::Inner]) -> Result<()>
where
    [C::Inner]: TiffValue,
{
    /// The compressed file, in a list that grows by doubling, and a strip.
    const BYTES_A_VALUE: usize = 10;
    const BYTES: usize = 2_000_000;
    ask(values.len() * BYTES_A_VALUE + BYTES)?;
    let file = encoded::<C>(frame, predictor, values).map_err(Error::other)?;
    out.write_all(&file)
}

fn encoded<C: ColorType>(frame: &Frame, predictor: Predictor, values: &[C::Inner]) -> TiffResult<Vec<u8>>
where
    [C::Inner]: TiffValue,
{
    let mut file = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut file)?
        .with_compression(Compression::Deflate(DeflateLevel::Balanced))
        .with_predictor(predictor);
    let [width, height] = frame.sides.map(|side| side as u32);
    let mut image = encoder.new_image::<C>(width, height)?;
    let tags = image.encoder();
    let (keys, texts) = keys(frame.crs);
    let [east, north] = frame.corner;
    tags.write_tag(Tag::ModelPixelScaleTag, &[frame.pixel[0], frame.pixel[1], 0.0][..])?;
    tags.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, east, north, 0.0][..])?;
    if !keys.is_empty() {
        tags.write_tag(Tag::GeoKeyDirectoryTag, &keys[..])?;
    }
    if !texts.is_empty() {
        tags.write_tag(Tag::GeoAsciiParamsTag, texts.as_str())?;
    }
    tags.write_tag(Tag::ImageDescription, frame.description.as_str())?;
    tags.write_tag(GDAL_METADATA, metadata(&frame.link).as_str())?;
    if let Some(value) = frame.no_data {
        tags.write_tag(Tag::GdalNodata, value)?;
    }
    image.write_data(values)?;
    Ok(file.into_inner())
}

/// Writes GDAL's metadata with the link, which is escaped twice, as GDAL writes and reads it: what is escaped once it cuts off at the
/// first `&`.
pub(crate) fn metadata(link: &str) -> String {
    format!("<GDALMetadata>\n  <Item name=\"riverseed\">{}</Item>\n</GDALMetadata>\n", escaped(&escaped(link)))
}
