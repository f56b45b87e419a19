//! Letters, placed and written for those who carry them.

use std::collections::BTreeSet;

use super::read::checksum;
use super::rows::Row;
use super::{Carried, VERSION, hash_of, key_of, steps};
use crate::annotate::glyph::{Face, Typeface, write_subset};
use crate::base::numbers::{Reader, Writer};
use crate::map::Map;
use crate::recipe::{Key, Recipe, Style, link};

impl Carried {
    /// Writes the letters of a map for recipes of it, which differ in nothing but their style: a page's in the light and in the dark. The
    /// first decides, and others are left out for which letters would be others. `None` if there are none to carry: the map has no
    /// labels, or woods or hills, which stand where letters leave them room; or it would take more than is read.
    pub fn write(map: &Map, recipes: &[&Recipe]) -> Option<String> {
        let mut rows: Option<Vec<Vec<Row>>> = None;
        let mut keys = Vec::new();
        for recipe in recipes {
            let of_recipe = in_style(map, recipe).map(|map| steps::all_rows(&map))?;
            if *rows.get_or_insert_with(|| of_recipe.clone()) == of_recipe {
                keys.push(key_of(recipe));
            }
        }
        let rows = rows.filter(|rows| map.recipe().scenery() == [0.0; 2] && !rows.iter().all(Vec::is_empty))?;
        keys.dedup();
        Some(written(hash_of(map.network()), &keys, &rows)).filter(|text| text.len() <= Self::LONGEST)
    }
}

/// Returns the map that a recipe makes; `None` if it is no other style of the same map, or needs a relief that has not been made.
fn in_style(map: &Map, recipe: &Recipe) -> Option<Map> {
    let style =
        |recipe: &Recipe| link::write_if(recipe, |parameter, is_default| parameter.key != Key::Style && !is_default);
    let has_relief = !recipe.get::<Style>().has_relief() || map.shown_relief().is_some();
    (style(recipe) == style(map.recipe()) && has_relief).then(|| Map { recipe: (*recipe).clone(), ..map.clone() })
}

fn written(rivers: u32, keys: &[u32], steps: &[Vec<Row>]) -> String {
    let mut writer = Writer::default();
    writer.whole(VERSION);
    writer.whole(rivers);
    writer.list(keys, |writer, key| writer.whole(*key));
    let faces = [Face::Italic, Face::Roman].map(|face| {
        let rows = steps.iter().flatten().filter(|row| row.kind.face() == face);
        let codes: BTreeSet<u32> = rows.flat_map(|row| row.letters.iter().map(|letter| letter.code)).collect();
        let start = writer.0.len();
        write_subset(&mut writer, face, &codes);
        Reader::of_text(&writer.0[start..]).map_or_else(Typeface::default, |mut table| Typeface::unspaced(&mut table))
    });
    let mut before: &[Row] = &[];
    for rows in steps {
        writer.list(rows, |writer, row| row.write(writer, before, &faces));
        before = rows;
    }
    sealed(&writer.0)
}

/// Puts the sum of a text before it, by which damage is seen.
#[doc(hidden)]
pub fn sealed(text: &str) -> String {
    let mut sum = Writer::default();
    sum.whole(checksum(text.as_bytes()));
    sum.0 + text
}
