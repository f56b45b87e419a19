//! Writes rivers as GeoJSON, for QGIS and the like: `cargo run --features json --example geojson`.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use riverseed::{Recipe, Session, export};

/// Writes the GeoJSON into a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let recipe: Recipe = "seed=totara&growth=colonize&land=archipelago&mouths=12".parse()?;
    let mut session = Session::new(recipe)?;
    let map = session.finish()?;
    Ok(export::geojson::write(BufWriter::new(File::create(folder.join("totara.geojson"))?), &map)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    write(Path::new("."))
}
