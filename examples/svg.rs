//! Writes a recipe's rivers as SVG: `cargo run --example svg`, and open `kauri.svg`.

use std::error::Error;
use std::path::Path;

use riverseed::{Recipe, Session, export};

/// Writes the SVG into a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let recipe: Recipe = "seed=kauri&growth=drainage&land=continent&sides=w&style=ink".parse()?;
    let mut session = Session::new(recipe)?;
    let map = session.finish()?;
    Ok(std::fs::write(folder.join("kauri.svg"), export::svg::svg(&map)?)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    write(Path::new("."))
}
