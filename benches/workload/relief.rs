//! The relief of finished rivers, and changes of style afterwards.

use std::num::NonZero;

use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::relief::{Grid, Relief};
use riverseed::{Map, Session};

use super::{Repetition, SIDE};

/// A default map with the rivers of its finished network, except for the keys in `link`.
fn map(link: &str) -> Option<Map> {
    Session::new(link::read(link).ok()?).ok()?.finish().ok()
}

/// Solves the relief of a default map's finished rivers. Returns the height of one cell, in bits.
pub fn relief() -> Option<Repetition> {
    let map = map("style=ink")?;
    Some(Box::new(move || {
        // Not `Map::make_relief`: a map with lakes has its relief already.
        let Ok(relief) = Relief::of(map.network(), map.relief_settings()) else { return 0 };
        relief.heights()[relief.heights().len() / 2].to_bits()
    }))
}

/// Solves the relief of a rectangle on a grid with a number of cells on its longer side, on a number of threads. Returns
/// the height of one cell, in bits.
pub fn grid(cells: u32, threads: NonZero<usize>) -> Option<Repetition> {
    let map = map("land=rectangle&aspect=1.6&style=atlas")?;
    let own = map.make_relief().ok()?;
    Some(Box::new(move || {
        let mut settings = map.relief_settings();
        let Some(grid) = Grid::with_longer_side(&settings.domain, cells) else { return 0 };
        (settings.grid, settings.threads) = (grid, threads);
        let Ok(finer) = own.on_grid_of(map.network(), settings) else { return 0 };
        finer.heights()[finer.heights().len() / 2].to_bits()
    }))
}

/// A style, after another one.
pub fn restyled(style: &str) -> [String; 2] {
    [if style == "atlas" { "night" } else { "atlas" }, style].map(|style| format!("style={style}"))
}

/// Paints a map in another way, in which it has been painted before. Returns one of its pixels. It is painted into a
/// copy of the picture, so that every run is the same; without painting, only the copy is made.
pub fn repaint(land: &str, looks: &[String; 2], paints: bool) -> Option<Repetition> {
    let [Some(before), Some(after)] =
        looks.each_ref().map(|look| link::read(&format!("land={land}&labels=none&{look}")).ok())
    else {
        return None;
    };
    let mut session = Session::new(before.clone()).ok()?;
    session.advance(u32::MAX).ok()?;
    let mut shown = Picture::new(SIDE, SIDE).ok()?;
    for recipe in [&after, &before] {
        session.change(recipe.clone()).ok()?;
        shown.paint(&session);
    }
    Some(Box::new(move || {
        let mut picture = shown.clone();
        if [&before, &after].into_iter().any(|recipe| session.change(recipe.clone()).is_err()) {
            return 0;
        }
        if paints {
            picture.paint(&session);
        }
        picture.pixmap().data().chunks(4096).map(|row| u32::from(row[0])).sum()
    }))
}
