//! A seed that would like to be markup or a path is neither in any file, and a title that would is a text where texts are.

use riverseed::export::rasters::Rasters;
use riverseed_exchange::Form;

use crate::maps::{LINKS, file, map, picture};

#[test]
fn no_file_has_markup_or_a_path_of_a_seed() {
    let map = map(LINKS[6]);
    let (rasters, picture) = (Rasters::new(&map).unwrap(), picture(&map));
    let squares = rasters.clone().into_squares().unwrap();
    let is_core =
        |form| matches!(form, Form::Png | Form::Svg | Form::GeoJson | Form::Json | Form::Pack | Form::Raster(_));
    for form in Form::all().filter(|form| !is_core(*form)) {
        let rasters = if matches!(form, Form::Engine(_)) { &squares } else { &rasters };
        let bytes = file(form, &map, Some(rasters), Some(&picture));
        for part in ["<script>", "<b>\"'", "../../x"] {
            let is_there = bytes.windows(part.len()).any(|window| window == part.as_bytes());
            assert!(!is_there || is_text(form, part), ".{} has {part}", form.name());
        }
    }
}

/// Returns `true` where the title is the text of a column, of the main land's name: `geopackage.rs` looks at the rest.
fn is_text(form: Form, part: &str) -> bool {
    form == Form::GeoPackage && part == "<script>"
}
