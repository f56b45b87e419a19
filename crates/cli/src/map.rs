//! A finished map with its files. It is grown once for all forms that are requested.

use std::num::NonZero;

use clap::ArgMatches;
use indicatif::ProgressBar;
use riverseed::domain::Domain;
use riverseed::recipe::Recipe;
use riverseed_exchange::{Files, Form, Options, Setting, check_size, memory};

use super::form::listed;
use super::grow::grow;
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::{Failure, Say};

/// Reads the options for files in a call.
///
/// # Errors
/// Fails if an option has no use for any of the forms, or does not fit the map.
pub fn options(matches: &ArgMatches, forms: &[Form], recipe: &Recipe) -> Result<Options, Failure> {
    let has_attractors = matches
        .get_occurrences::<String>("attractors")
        .is_some_and(|mut occurrences| occurrences.any(|values| values.len() == 0));
    let options = Options {
        size: matches.get_one("size").copied(),
        ratio: matches.get_one("ratio").copied(),
        raster_size: matches.get_one("raster-size").copied(),
        has_svg_text: matches.get_flag("svg-text"),
        sheet: matches.get_one("sheet").copied(),
        beds: beds(matches),
        has_attractors,
        has_segments: matches.get_flag("geojson-segments"),
        is_flat: matches.get_flag("geojson-flat"),
        crs: matches.get_one("crs").copied().unwrap_or_default(),
        threads: None,
    };
    if let Some(setting) = options.misplaced(forms) {
        return Err(Failure::Mismatch { option: name(setting), endings: listed(forms) });
    }
    if let Some(size) = options.raster_size {
        // Checked before anything grows.
        check_size(forms, &Domain::of(recipe), size).map_err(Failure::RasterSize)?;
    }
    Ok(options)
}

/// Returns whether heights are to be lowered under rivers; `None` if the call does not say.
fn beds(matches: &ArgMatches) -> Option<bool> {
    let is_given = |name| matches.get_flag(name);
    (is_given("beds") || is_given("no-beds")).then(|| is_given("beds"))
}

fn name(setting: Setting) -> &'static str {
    match setting {
        Setting::Size => "--size",
        Setting::Ratio => "--ratio",
        Setting::RasterSize => "--raster-size",
        Setting::SvgText => "--svg-text",
        Setting::Sheet => "--sheet",
        Setting::Beds => "--beds or --no-beds",
        Setting::Attractors => "--attractors without a number",
        Setting::Segments => "--geojson-segments",
        Setting::Flat => "--geojson-flat",
        Setting::Crs => "--crs",
    }
}

/// Grows a map and makes what files in these forms hold.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn make(
    order: Order,
    forms: &[Form],
    options: Options,
    progress: &ProgressBar,
    say: Say<'_>,
) -> Result<Files, Failure> {
    let is_wanted = |part: fn(Form) -> bool| forms.iter().any(|form| part(*form));
    if is_wanted(Form::has_letters) {
        say_what_has_no_letters(&order.recipe, say);
    }
    // The picture is allocated before the work begins.
    let picture = options.picture(forms, &Domain::of(&order.recipe))?;
    let mut session = grow(order, progress, say)?;
    if is_wanted(Form::lists_names) {
        let map = session.finish()?;
        memory::ask_for_features(&map)?;
        say_what_is_unused(&map, say);
    }
    progress.set_message("raising land");
    // The relief is made once, for all files.
    while is_wanted(Form::has_relief) && session.raise_relief()? {}
    let map = session.finish()?;
    let attractors = options.has_attractors.then(|| session.growth().scattered());
    progress.set_message("painting");
    let mut files = Files::make(map, forms, options, picture)?.with_attractors(attractors);
    if let Some(note) = files.note(forms) {
        say(&note);
    }
    while files.paint_part() {}
    progress.set_message("writing");
    Ok(files)
}

/// Returns all threads of this machine.
pub fn all_threads() -> NonZero<usize> {
    std::thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN)
}
