//! A map's files for a game, in one archive: rasters, rivers, the picture, and a text with the scale.

#[cfg(feature = "pack")]
mod archive;

use std::ops::Range;

use super::rasters::{Layer, Rasters, decimal, shortest};
#[cfg(feature = "pack")]
pub use archive::{add, write};

/// The file name of the text.
pub const README: &str = "README.txt";
/// The file name of the picture.
pub const PICTURE: &str = "map.png";
/// The file name of the rivers and of the land around them.
pub const FEATURES: &str = "map.geojson";

/// Makes the text of the README: the contents of each file, and the scale.
pub fn readme(rasters: &Rasters) -> String {
    let scale = rasters.scale;
    let mut text = format!(
        "A map by Riverseed. This draws it again:\n  {link}\n\n\
         SCALE\n\
         A raster has {columns} x {rows} pixels, north at the top. A pixel is {pixel} m wide ({units} units of the map).\n{part}\
         Heights: 0 is {deepest} m, {sea} is the sea's surface, 65535 is {highest} m.\n\
         One step is {step} m: metres = (value - {sea}) * {step}\n\n\
         FILES\n",
        link = rasters.link,
        columns = rasters.columns,
        rows = rasters.rows,
        pixel = shortest(rasters.metres_a_pixel(), 2),
        units = shortest(rasters.cell_size.into(), 6),
        part = rasters.part().map(|part| words_of(&part)).unwrap_or_default(),
        deepest = decimal(scale.metres(0), 1),
        highest = decimal(scale.metres(u16::MAX), 1),
        sea = scale.sea_level,
        step = decimal(scale.metres_a_step, 6),
    );
    for layer in Layer::ALL {
        text += &format!("{}.png\n  {}\n", layer.name(), rasters.meaning(layer));
    }
    text += &format!("{FEATURES}\n  Land, basins, rivers, lakes and ridges (RFC 7946); heights of rivers in metres.\n");
    text += &format!("{PICTURE}\n  The picture in the style of the recipe.\n");
    text += "\nEvery river falls all along its way, no land is a pit, and flow directions lead from all land to the sea or off the map.\n";
    text
}

/// Says where the map lies in rasters that it does not fill.
fn words_of([columns, rows]: &[Range<usize>; 2]) -> String {
    format!(
        "The map takes {} x {} of them, from column {} and row {}, counted from 0; around it is sea.\n",
        columns.len(),
        rows.len(),
        columns.start,
        rows.start
    )
}
