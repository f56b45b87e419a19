//! Grows a recipe step by step and keeps four pictures on the way: `cargo run --features png --example stepping`.

use std::error::Error;
use std::fs::File;
use std::path::Path;

use riverseed::{Phase, Picture, Recipe, Session, export};

/// The progress of growth in each picture but the last, which shows the finished rivers.
const SHARES: [f32; 3] = [0.1, 0.4, 0.9];

/// Writes the pictures into a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let recipe: Recipe = "seed=kea&growth=drainage&land=basin&sea=0.3&style=dark".parse()?;
    let link = recipe.to_string();
    let mut session = Session::new(recipe)?;
    let mut picture = Picture::new(800, 500)?;
    for number in 0..=SHARES.len() {
        // A step is a tick of growth, a part of the work that turns the tree into rivers, or a round of meandering.
        let is_due = |session: &Session| match SHARES.get(number) {
            Some(share) => session.phase() != Phase::Growing || session.progress() >= *share,
            None => session.is_finished(),
        };
        while !is_due(&session) {
            session.advance(1)?;
        }
        // Only what is new is painted.
        picture.paint(&session);
        let file = File::create(folder.join(format!("kea-{number}.png")))?;
        export::png::write(file, picture.pixmap(), &link)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    write(Path::new("."))
}
