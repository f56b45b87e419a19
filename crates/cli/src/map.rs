//! A finished map with its files. It is grown once for all forms that are requested.

use std::io::{self, Write};
use std::num::NonZero;

use clap::ArgMatches;
use clap::parser::ValueSource;
use indicatif::ProgressBar;
use riverseed::Map;
use riverseed::domain::Domain;
use riverseed::export;
use riverseed::export::rasters::Rasters;
use riverseed::glam::Vec2;
use riverseed::paint::{LONGEST_SIDE, PaintError, View};
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed_exchange::{self as exchange, Source};

use super::form::{Form, listed};
use super::grow::grow;
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::{Failure, Say, memory};

/// The options for files in a call, apart from the recipe.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The longer side of a picture, in pixels.
    pub size: u32,
    ratio: f32,
    /// The longer side of rasters, in pixels; `None` for a pixel per cell of the relief.
    pub raster_size: Option<u32>,
    has_svg_text: bool,
    pub has_attractors: bool,
    /// The number of threads for one map. Files do not depend on it.
    threads: NonZero<usize>,
}

impl Options {
    /// # Errors
    /// Fails if an option has no use for any of the forms, or does not fit the map.
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
            // Checked before anything grows.
            exchange::check_size(forms, &Domain::of(recipe), size).map_err(Failure::RasterSize)?;
        }
        let size = matches.get_one("size").copied().unwrap_or(LONGEST_SIDE);
        Ok(Self {
            size,
            ratio: ratio.unwrap_or(1.0),
            raster_size,
            has_svg_text,
            has_attractors,
            threads: NonZero::<usize>::MIN,
        })
    }

    /// The same options with a number of threads for one map.
    pub fn on_threads(self, threads: NonZero<usize>) -> Self {
        Self { threads, ..self }
    }

    /// The longest requested side of the contents of some forms, in pixels.
    pub fn longest(&self, forms: &[Form]) -> u32 {
        let picture = forms.iter().any(|form| form.has_pixels()).then_some(self.size);
        let rasters = self.raster_size.filter(|_| forms.iter().any(|form| form.has_rasters()));
        picture.max(rasters).unwrap_or(0)
    }
}

/// A finished map with everything that its files are made from.
pub struct Files {
    map: Map,
    /// The attractors that the tree grew to, if a file lists them.
    attractors: Option<Vec<Vec2>>,
    picture: Option<Picture>,
    rasters: Option<Rasters>,
    options: Options,
}

impl Files {
    /// Grows a map, for files in these forms.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
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
        // The picture is allocated before the work begins.
        let picture = is_wanted(Form::has_pixels).then(|| picture(&order.recipe, options));
        let mut picture = picture.transpose()?;
        let mut session = grow(order, progress, say)?;
        if is_wanted(Form::lists_names) {
            let map = session.finish()?;
            memory::ask_for_file(&map, Form::Json)?;
            say_what_is_unused(&map, say);
        }
        progress.set_message("raising land");
        // The relief is made once, for all files.
        while is_wanted(Form::has_relief) && session.raise_relief()? {}
        let map = session.finish()?;
        let attractors = options.has_attractors.then(|| session.growth().scattered());
        // An engine's are of a size of its own, and made when its pack is written; all others are the same.
        let with_rasters = forms.iter().find(|form| form.has_rasters() && !matches!(form, Form::Engine(_)));
        let rasters = with_rasters.map_or(Ok(None), |form| rasters_for(*form, &map, options))?;
        if let Some(rasters) = rasters.as_ref().filter(|_| forms.contains(&Form::RawHeights)) {
            say(&scale_of_raw_heights(rasters));
        }
        progress.set_message("painting");
        if let Some(picture) = &mut picture {
            memory::ask_for_picture(&map, picture)?;
            picture.refine(&map, options.threads).map_err(io::Error::other)?;
            picture.paint_map(&map);
        }
        progress.set_message("writing");
        Ok(Self { map, attractors, picture, rasters, options })
    }

    /// Writes a file in one of the forms that the map was made for; writes nothing in other forms.
    ///
    /// # Errors
    /// Fails if there is not enough memory, and with the writer's errors.
    pub fn write(&self, form: Form, out: &mut dyn Write) -> Result<(), Failure> {
        let Self { map, attractors, picture, rasters, options } = self;
        memory::ask_for_file(map, form)?;
        let written = match (form, picture, rasters) {
            (Form::Png, Some(picture), _) => {
                export::png::write(out, picture.pixmap(), &link::write_for_file(map.recipe())).map_err(io::Error::from)
            }
            (Form::Pack, Some(picture), Some(rasters)) => export::pack::write(out, map, rasters, picture.pixmap()),
            (Form::Raster(layer), _, Some(rasters)) => {
                export::png::write_raster(out, rasters, layer).map_err(io::Error::from)
            }
            (Form::Svg, ..) => {
                let svg = if options.has_svg_text { export::svg::svg_with_text } else { export::svg::svg };
                svg(map).map_err(io::Error::other).and_then(|text| writeln!(out, "{text}"))
            }
            (Form::GeoJson, ..) => export::geojson::write(&mut *out, map).and_then(|()| writeln!(out)),
            (Form::Json, ..) => export::json::write(&mut *out, map, attractors.as_deref()).and_then(|()| writeln!(out)),
            // Not made for this form.
            (Form::Png | Form::Pack | Form::Raster(_), ..) => Ok(()),
            (Form::Engine(_), picture, _) => {
                let rasters = rasters_for(form, map, *options)?;
                exchange::write(
                    form,
                    out,
                    &Source { map, rasters: rasters.as_ref(), picture: picture.as_ref().map(Picture::pixmap) },
                )
            }
            (form, picture, rasters) => exchange::write(
                form,
                out,
                &Source { map, rasters: rasters.as_ref(), picture: picture.as_ref().map(Picture::pixmap) },
            ),
        };
        Ok(written?)
    }
}

/// Allocates a picture of the requested size.
fn picture(recipe: &Recipe, options: Options) -> Result<Picture, PaintError> {
    let (width, height) = View::sides_for(&Domain::of(recipe), options.size);
    Ok(Picture::new(width, height)?.with_ratio(options.ratio))
}

/// Says what bare heights cannot say by themselves.
fn scale_of_raw_heights(rasters: &Rasters) -> String {
    let Rasters { columns, rows, scale, .. } = rasters;
    let (sea_level, step) = (scale.sea_level, scale.metres_a_step);
    format!(".r16 has {columns} x {rows} pixels; {sea_level} is the sea's surface, and a step is {step:.6} m")
}

/// Makes the rasters of a form, if it holds any.
fn rasters_for(form: Form, map: &Map, options: Options) -> io::Result<Option<Rasters>> {
    exchange::rasters(form, map, options.raster_size, options.threads).map_err(io::Error::other)
}
