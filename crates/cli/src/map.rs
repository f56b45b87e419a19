//! A finished map, and its files in the forms that are asked for: it is grown once for all of them.

use std::io::{self, Write};

use clap::ArgMatches;
use clap::parser::ValueSource;
use indicatif::ProgressBar;
use riverseed::domain::Domain;
use riverseed::export;
use riverseed::export::rasters::Rasters;
use riverseed::paint::{LONGEST_SIDE, PaintError, View};
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::session::Session;

use super::form::{Form, listed};
use super::grow::grow;
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::{Failure, Say};

/// What a call says of files besides the recipe.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The longer side of a picture, in pixels.
    pub size: u32,
    ratio: f32,
    /// That of rasters; `None` for a pixel to each cell of the relief.
    pub raster_size: Option<u32>,
    has_svg_text: bool,
    pub has_attractors: bool,
}

impl Options {
    /// # Errors
    /// An option that none of the forms has a use for, or that does not go with the map.
    pub fn of(matches: &ArgMatches, forms: &[Form], recipe: &Recipe) -> Result<Self, Failure> {
        let goes_with = |option: &'static str, is_given: bool, takes: fn(Form) -> bool| {
            let fails = is_given && !forms.iter().any(|form| takes(*form));
            if fails { Err(Failure::Mismatch { option, endings: listed(forms) }) } else { Ok(is_given) }
        };
        let has_attractors = matches
            .get_occurrences::<String>("attractors")
            .is_some_and(|mut occurrences| occurrences.any(|values| values.len() == 0));
        let is_sized = matches.value_source("size") == Some(ValueSource::CommandLine);
        let ratio = matches.get_one::<f32>("ratio").copied();
        let raster_size = matches.get_one::<u32>("raster-size").copied();
        goes_with("--attractors without a number", has_attractors, |form| form == Form::Json)?;
        goes_with("--size", is_sized, Form::has_pixels)?;
        goes_with("--ratio", ratio.is_some(), Form::has_pixels)?;
        let has_svg_text = goes_with("--svg-text", matches.get_flag("svg-text"), |form| form == Form::Svg)?;
        goes_with("--raster-size", raster_size.is_some(), Form::has_rasters)?;
        if let Some(size) = raster_size {
            // Before anything grows.
            Rasters::grid(&Domain::of(recipe), size).map_err(Failure::RasterSize)?;
        }
        let size = matches.get_one("size").copied().unwrap_or(LONGEST_SIDE);
        Ok(Self { size, ratio: ratio.unwrap_or(1.0), raster_size, has_svg_text, has_attractors })
    }

    /// The longest side of what some forms hold, in pixels, as far as it was asked for.
    pub fn longest(&self, forms: &[Form]) -> u32 {
        let picture = forms.iter().any(|form| form.has_pixels()).then_some(self.size);
        let rasters = self.raster_size.filter(|_| forms.iter().any(|form| form.has_rasters()));
        picture.max(rasters).unwrap_or(0)
    }
}

/// A finished map with all that its files are made of.
pub struct Map {
    session: Session,
    picture: Option<Picture>,
    rasters: Option<Rasters>,
    options: Options,
}

impl Map {
    /// Grows a map, for files of these forms.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn make(
        order: Order,
        forms: &[Form],
        options: Options,
        progress: &ProgressBar,
        say: Say<'_>,
    ) -> Result<Self, Failure> {
        let is_wanted = |part: fn(Form) -> bool| forms.iter().any(|form| part(*form));
        if is_wanted(Form::has_letters) {
            say_what_has_no_letters(&order.recipe, say);
        }
        // Room for the picture before the work begins.
        let picture = is_wanted(Form::has_pixels).then(|| picture(&order.recipe, options));
        let mut picture = picture.transpose()?;
        let mut session = grow(order, progress, say)?;
        if is_wanted(Form::lists_names) {
            say_what_is_unused(&session, say);
        }
        progress.set_message("raising land");
        // Once, for all files.
        while is_wanted(Form::has_relief) && session.raise_relief()? {}
        let rasters = is_wanted(Form::has_rasters).then(|| rasters(&session, options.raster_size));
        let rasters = rasters.transpose()?;
        progress.set_message("painting");
        if let Some(picture) = &mut picture {
            picture.paint(&session);
        }
        progress.set_message("writing");
        Ok(Self { session, picture, rasters, options })
    }

    /// Writes a file of one of the forms that the map was made for; of another, nothing.
    ///
    /// # Errors
    /// If there is not enough memory; and those of the writer.
    pub fn write(&self, form: Form, out: &mut dyn Write) -> Result<(), Failure> {
        let Self { session, picture, rasters, options } = self;
        let written = match (form, picture, rasters) {
            (Form::Png, Some(picture), _) => {
                export::png::write(out, picture.pixmap(), &link::write(session.recipe())).map_err(io::Error::from)
            }
            (Form::Pack, Some(picture), Some(rasters)) => export::pack::write(out, session, rasters, picture.pixmap()),
            (Form::Raster(layer), _, Some(rasters)) => {
                export::png::write_raster(out, rasters, layer).map_err(io::Error::from)
            }
            (Form::Svg, ..) => {
                let svg = if options.has_svg_text { export::svg::svg_with_text } else { export::svg::svg };
                svg(session).map_err(io::Error::other).and_then(|text| writeln!(out, "{text}"))
            }
            (Form::GeoJson, ..) => export::geojson::write(&mut *out, session).and_then(|()| writeln!(out)),
            (Form::Json, ..) => {
                export::json::write(&mut *out, session, options.has_attractors).and_then(|()| writeln!(out))
            }
            _ => Ok(()),
        };
        Ok(written?)
    }
}

/// Room for a picture of the size that is asked for.
fn picture(recipe: &Recipe, options: Options) -> Result<Picture, PaintError> {
    let (width, height) = View::sides_for(&Domain::of(recipe), options.size);
    Ok(Picture::new(width, height)?.with_ratio(options.ratio))
}

fn rasters(session: &Session, size: Option<u32>) -> io::Result<Rasters> {
    let rasters = size.map_or_else(|| Rasters::new(session), |size| Rasters::with_size(session, size));
    rasters.map_err(io::Error::other)
}
