//! `riverseed render`: a recipe as a picture, as data, or as all that a game needs.

use std::io;
use std::path::PathBuf;

use clap::ArgMatches;
use clap::parser::ValueSource;
use indicatif::ProgressBar;
use riverseed::domain::Domain;
use riverseed::export;
use riverseed::export::rasters::{Layer, Rasters};
use riverseed::paint::{LONGEST_SIDE, PaintError, View};
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::session::Session;

use super::Failure;
use super::form::Form;
use super::grow::{grow, progress};
use super::names::{say_what_has_no_letters, say_what_is_unused};
use super::order::Order;
use super::output::Output;

/// Writes the file that is asked for.
pub fn render(matches: &ArgMatches) -> Result<(), Failure> {
    let Some(output) = matches.get_one::<PathBuf>("output") else { return Ok(()) };
    let order = Order::of(matches)?;
    let size = matches.get_one("size").copied().unwrap_or(LONGEST_SIDE);
    let wants_attractors = matches
        .get_occurrences::<String>("attractors")
        .is_some_and(|mut occurrences| occurrences.any(|values| values.len() == 0));
    let wants_size = matches.value_source("size") == Some(ValueSource::CommandLine);
    let (form, ending) = Form::of(output).ok_or_else(|| Failure::Ending { path: output.clone() })?;
    if wants_attractors && form != Form::Json {
        return Err(Failure::Mismatch { option: "--attractors without a number", ending });
    }
    if wants_size && !matches!(form, Form::Png | Form::Pack) {
        return Err(Failure::Mismatch { option: "--size", ending });
    }
    let ratio = matches.get_one::<f32>("ratio").copied();
    if ratio.is_some() && !matches!(form, Form::Png | Form::Pack) {
        return Err(Failure::Mismatch { option: "--ratio", ending });
    }
    let is_text = matches.get_flag("svg-text");
    if is_text && form != Form::Svg {
        return Err(Failure::Mismatch { option: "--svg-text", ending });
    }
    let size = (size, ratio.unwrap_or(1.0));
    let raster_size = matches.get_one::<u32>("raster-size").copied();
    if raster_size.is_some() && !matches!(form, Form::Raster(_) | Form::Pack) {
        return Err(Failure::Mismatch { option: "--raster-size", ending });
    }
    if let Some(size) = raster_size {
        // Before anything grows.
        Rasters::grid(&Domain::of(&order.recipe), size).map_err(Failure::RasterSize)?;
    }
    order.say_what_is_idle(matches!(form, Form::Png | Form::Svg));
    if matches!(form, Form::Png | Form::Svg | Form::Pack) {
        say_what_has_no_letters(&order.recipe);
    }
    let output = Output::open(output)?;
    match form {
        Form::Png => write_picture(output, order, size),
        Form::Pack => write_pack(output, order, size, raster_size),
        Form::Raster(layer) => write_raster(output, order, layer, raster_size),
        Form::Svg => write_svg(output, order, is_text),
        _ => write_network(output, order, form, wants_attractors),
    }
}

fn write_picture(output: Output, order: Order, (size, ratio): (u32, f32)) -> Result<(), Failure> {
    let progress = progress(&order.recipe, size);
    let mut picture = picture(&order.recipe, size)?.with_ratio(ratio);
    let session = grow(order, &progress)?;
    progress.set_message("painting");
    picture.paint(&session);
    progress.set_message("writing");
    let link = link::write(session.recipe());
    output.write(|out| Ok(export::png::write(out, picture.pixmap(), &link).map_err(io::Error::from)?))?;
    progress.finish_and_clear();
    Ok(())
}

/// Writes the picture with all that games need.
fn write_pack(
    output: Output,
    order: Order,
    (size, ratio): (u32, f32),
    raster_size: Option<u32>,
) -> Result<(), Failure> {
    let progress = progress(&order.recipe, size.max(raster_size.unwrap_or(0)));
    let mut picture = picture(&order.recipe, size)?.with_ratio(ratio);
    let mut session = grow(order, &progress)?;
    // Once, for all files of the pack.
    while session.raise_relief()? {}
    let rasters = rasters(&session, raster_size, &progress)?;
    progress.set_message("painting");
    picture.paint(&session);
    progress.set_message("writing");
    output.write(|out| Ok(export::pack::write(out, &session, &rasters, picture.pixmap())?))?;
    progress.finish_and_clear();
    Ok(())
}

/// Room for a picture whose longer side is that long.
fn picture(recipe: &Recipe, size: u32) -> Result<Picture, PaintError> {
    let (width, height) = View::sides_for(&Domain::of(recipe), size);
    Picture::new(width, height)
}

fn write_raster(output: Output, order: Order, layer: Layer, size: Option<u32>) -> Result<(), Failure> {
    let progress = progress(&order.recipe, size.unwrap_or(0));
    let session = grow(order, &progress)?;
    let rasters = rasters(&session, size, &progress)?;
    progress.set_message("writing");
    output.write(|out| Ok(export::png::write_raster(out, &rasters, layer).map_err(io::Error::from)?))?;
    progress.finish_and_clear();
    Ok(())
}

fn rasters(session: &Session, size: Option<u32>, progress: &ProgressBar) -> Result<Rasters, Failure> {
    progress.set_message("raising land");
    let rasters = size.map_or_else(|| Rasters::new(session), |size| Rasters::with_size(session, size));
    Ok(rasters.map_err(io::Error::other)?)
}

fn write_svg(output: Output, order: Order, is_text: bool) -> Result<(), Failure> {
    let progress = progress(&order.recipe, 0);
    let session = grow(order, &progress)?;
    progress.set_message("writing");
    let svg = if is_text { export::svg::svg_with_text } else { export::svg::svg };
    output.write(|out| {
        out.write_all(svg(&session).map_err(io::Error::other)?.as_bytes())?;
        Ok(writeln!(out)?)
    })?;
    progress.finish_and_clear();
    Ok(())
}

fn write_network(output: Output, order: Order, form: Form, with_attractors: bool) -> Result<(), Failure> {
    let progress = progress(&order.recipe, 0);
    let session = grow(order, &progress)?;
    say_what_is_unused(&session);
    progress.set_message("writing");
    output.write(|out| {
        match form {
            Form::GeoJson => export::geojson::write(&mut *out, &session)?,
            _ => export::json::write(&mut *out, &session, with_attractors)?,
        }
        Ok(writeln!(out)?)
    })?;
    progress.finish_and_clear();
    Ok(())
}
