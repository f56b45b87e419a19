//! The reader of the `tiff` crate finds in a GeoTIFF what the map's rasters hold, at their place.

use std::io::Cursor;

use riverseed::Map;
use riverseed::analyse::statistics::Drained;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed_exchange::gis::crs::Crs;
use riverseed_exchange::gis::geotiff;
use riverseed_exchange::{Form, Options};
use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;

use crate::maps::{LINKS, file, file_with, map, picture};

fn decoder(bytes: &[u8]) -> Decoder<Cursor<&[u8]>> {
    Decoder::new(Cursor::new(bytes)).unwrap()
}

fn read(bytes: &[u8]) -> DecodingResult {
    decoder(bytes).read_image().unwrap()
}

fn rasters_of(map: &Map) -> Rasters {
    Rasters::new(map).unwrap()
}

#[test]
fn rasters_are_read_as_they_are() {
    for link in LINKS {
        let map = map(link);
        let rasters = rasters_of(&map);
        let of = |layer| file(Form::RasterTiff(layer), &map, Some(&rasters), None);
        let DecodingResult::F32(heights) = read(&of(Layer::Heights)) else { panic!() };
        for (metres, height) in heights.iter().zip(rasters.relief().heights()) {
            assert!((metres - height * map.scale().metres_up).abs() <= 1e-3, "{link}: {metres} {height}");
        }
        let DecodingResult::F32(widths) = read(&of(Layer::Rivers)) else { panic!() };
        let Values::Words(thousandths) = rasters.values(Layer::Rivers) else { panic!() };
        // A river has a width where it is drawn; the greatest is that of what drains the most, if a little less in a bend.
        let apart = widths.iter().zip(&thousandths).filter(|(metres, drawn)| (**metres > 0.0) != (**drawn > 0)).count();
        assert_eq!(apart, 0, "{link}");
        let (network, drained) = (map.network(), Drained::of(&map));
        let most = network.rivers.iter().map(|river| network.discharge(river)).max().unwrap();
        let widest = widths.iter().copied().fold(0.0, f32::max);
        assert!((0.9..=1.0001).contains(&(f64::from(widest) / drained.river_width(most))), "{link}: {widest}");
        for layer in [Layer::Land, Layer::Flow] {
            let (DecodingResult::U8(bytes), Values::Bytes(expected)) = (read(&of(layer)), rasters.values(layer)) else {
                panic!()
            };
            assert!(bytes == expected, "{link}: {layer:?}");
        }
        let DecodingResult::F32(depths) = read(&of(Layer::Depth)) else { panic!() };
        let Values::Words(steps) = rasters.values(Layer::Depth) else { panic!() };
        for (metres, steps) in depths.iter().zip(steps) {
            let step = rasters.scale.metres_a_step;
            assert!((f64::from(*metres) - f64::from(steps) * step).abs() <= step, "{link}: {metres} {steps}");
        }
        let DecodingResult::U32(basins) = read(&of(Layer::Basins)) else { panic!() };
        assert!(basins == rasters.flow().basins, "{link}");
        assert_eq!([heights.len(), widths.len(), basins.len()], [rasters.columns * rasters.rows; 3]);
    }
}

#[test]
fn land_drains_in_metres_too() {
    for link in LINKS {
        let map = map(link);
        let rasters = rasters_of(&map);
        let file = file(Form::RasterTiff(Layer::Heights), &map, Some(&rasters), None);
        let DecodingResult::F32(heights) = read(&file) else { panic!() };
        let (flow, grid) = (rasters.flow(), rasters.relief().grid());
        let mut falls = 0;
        for cell in (0..heights.len()).filter(|&cell| heights[cell] > 0.0) {
            if let Some(next) = flow.next(&grid, cell) {
                assert!(heights[next] < heights[cell], "{link}: {cell}");
                falls += 1;
            }
        }
        assert!(falls > 1000, "{link}");
    }
}

/// Reads the numbers of the place: the north-western corner and the sides of a pixel, in metres.
fn place(bytes: &[u8]) -> ([f64; 2], [f64; 2]) {
    let mut decoder = decoder(bytes);
    let tie = decoder.get_tag_f64_vec(Tag::ModelTiepointTag).unwrap();
    let pixel = decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).unwrap();
    assert_eq!((&tie[..3], tie[5], pixel[2]), (&[0.0; 3][..], 0.0, 0.0));
    ([tie[3], tie[4]], [pixel[0], pixel[1]])
}

#[test]
fn rasters_and_pictures_lie_where_the_map_lies() {
    for link in LINKS {
        let map = map(link);
        let half = map.domain().size.as_dvec2() * 0.5 * map.scale().metres_a_unit;
        let rasters = Rasters::with_size(&map, 1100).unwrap();
        let (corner, pixel) = place(&file(Form::RasterTiff(Layer::Land), &map, Some(&rasters), None));
        assert_eq!(corner, [-half.x, half.y]);
        assert_eq!(pixel, [f64::from(rasters.cell_size) * map.scale().metres_a_unit; 2]);
        let picture = picture(&map);
        let (corner, pixel) = place(&file(Form::GeoTiff, &map, None, Some(&picture)));
        // The map covers the picture: along one axis it ends where the picture does, and nowhere before.
        let reach = [-corner[0], corner[1]];
        let near = |a: f64, b: f64| (a - b).abs() < 1.0;
        assert!(near(reach[0], half.x) || near(reach[1], half.y), "{link}: {reach:?}");
        assert!(reach[0] < half.x + 1.0 && reach[1] < half.y + 1.0, "{link}: {reach:?}");
        let middle = [corner[0] + pixel[0] * 60.0, corner[1] - pixel[1] * 40.0];
        assert!(near(middle[0], 0.0) && near(middle[1], 0.0), "{link}: {middle:?}");
    }
}

#[test]
fn texts_tell_files_apart_and_the_same_map_gives_the_same_bytes() {
    let map = map(LINKS[6]);
    let (rasters, picture) = (rasters_of(&map), picture(&map));
    let mut files: Vec<_> = Layer::ALL.map(|layer| (Form::RasterTiff(layer), geotiff::subject(layer))).into();
    files.push((Form::GeoTiff, geotiff::PICTURE));
    for (form, subject) in &files {
        let bytes = file(*form, &map, Some(&rasters), Some(&picture));
        assert!(bytes == file(*form, &map, Some(&rasters), Some(&picture)));
        let mut decoder = decoder(&bytes);
        let description = decoder.get_tag_ascii_string(Tag::ImageDescription).unwrap();
        assert!(description.starts_with(subject), "{description}");
        assert_eq!(files.iter().filter(|(_, other)| description.starts_with(other)).count(), 1);
        let metadata = decoder.get_tag_ascii_string(Tag::Unknown(42112)).unwrap();
        let document = roxmltree::Document::parse(&metadata).unwrap();
        let link = document.descendants().find(|node| node.has_tag_name("Item")).and_then(|node| node.text()).unwrap();
        assert_eq!(link.replace("&amp;", "&"), rasters.link);
    }
}

#[test]
fn picture_is_read_as_it_is() {
    let map = map(LINKS[0]);
    let picture = picture(&map);
    let DecodingResult::U8(pixels) = read(&file(Form::GeoTiff, &map, None, Some(&picture))) else { panic!() };
    assert!(pixels.chunks(3).eq(picture.data().chunks(4).map(|rgba| &rgba[..3])));
}

#[test]
fn keys_are_those_of_the_system_that_was_asked_for() {
    let map = map(LINKS[0]);
    let (rasters, picture) = (rasters_of(&map), picture(&map));
    let keys = |form, crs| {
        let options = Options { crs, ..Options::default() };
        let bytes = file_with(form, &map, Some(&rasters), Some(&picture), &options);
        let mut decoder = decoder(&bytes);
        let texts = decoder.find_tag(Tag::GeoAsciiParamsTag).unwrap().is_some();
        let keys = decoder.find_tag(Tag::GeoKeyDirectoryTag).unwrap();
        (keys.map(|keys| keys.into_u16_vec().unwrap()).unwrap_or_default(), texts)
    };
    for form in [Form::GeoTiff, Form::RasterTiff(Layer::Heights)] {
        // By GeoTIFF 1.1: pixels are areas; a projected system with its number.
        let (utm, _) = keys(form, "EPSG:32733".parse().unwrap());
        assert_eq!(utm, [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32733]);
        assert_eq!(keys(form, Crs::Unknown), (vec![], false));
        let (own, has_name) = keys(form, Crs::Own);
        assert!(has_name && own.starts_with(&[1, 1, 0, 4, 1024, 0, 1, 32767]));
    }
}
