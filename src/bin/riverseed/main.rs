//! The command line: `riverseed render` draws a recipe or writes its network, `riverseed outline` traces a picture of a
//! land, `riverseed measure` compares a recipe's rivers with nature's, `riverseed table` explains recipes, `riverseed verify` tells whether this machine draws as all others do.
//!
//! Exit codes: 0 done, 1 the work failed, 2 the call or the recipe is wrong.

mod mask;
mod measure;
mod output;
mod table;
mod verify;

use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, crate_version, value_parser};
use indicatif::{ProgressBar, ProgressStyle};
use riverseed::digest::DigestError;
use riverseed::domain::Domain;
use riverseed::export::rasters::{Layer, Rasters};
use riverseed::export::{self, ExportError};
use riverseed::import::png::{Image, ImportError};
use riverseed::land::Land;
use riverseed::land::trace::{Traced, trace};
use riverseed::paint::{LONGEST_SIDE, PaintError, View};
use riverseed::picture::Picture;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{GridPoint, Key, LandKind, LineKind, Parameter, Recipe, RecipeError, json, link};
use riverseed::session::{Session, SessionError, Shortfall};
use thiserror::Error;

use output::Output;

fn main() -> ExitCode {
    let done = match command().get_matches().subcommand() {
        Some(("render", matches)) => render(matches),
        Some(("outline", matches)) => outline(matches),
        Some(("measure", matches)) => measure::measure(matches),
        Some(("table", _)) => table::print().map_err(Failure::from),
        Some(("verify", matches)) => verify::verify(matches.get_one::<PathBuf>("digests").map(PathBuf::as_path)),
        _ => Ok(()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("riverseed: {failure}");
            failure.exit_code()
        }
    }
}

/// What can go wrong after the call has been understood.
#[derive(Debug, Error)]
enum Failure {
    #[error(transparent)]
    Recipe(#[from] RecipeError),
    #[error(transparent)]
    Session(#[from] SessionError),
    #[error(transparent)]
    Paint(#[from] PaintError),
    #[error(transparent)]
    Digest(#[from] DigestError),
    #[error("{}: the ending of the output is none of .png, .svg, .geojson, .json, .zip", path.display())]
    Ending { path: PathBuf },
    #[error("{option} does not go with {ending}")]
    Mismatch { option: &'static str, ending: &'static str },
    #[error("--raster-size: {0}")]
    RasterSize(ExportError),
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: io::Error },
    #[error("--land {}: {reason}", path.display())]
    Land { path: PathBuf, reason: String },
    #[error("{}: {reason}", path.display())]
    Picture { path: PathBuf, reason: String },
    #[error("{differing} of {all} recipes give other rivers, pixels or files here")]
    Differs { differing: usize, all: usize },
    #[error(transparent)]
    Output(#[from] io::Error),
}

impl Failure {
    fn exit_code(&self) -> ExitCode {
        match self {
            Self::Recipe(_) | Self::Ending { .. } | Self::Mismatch { .. } | Self::RasterSize(_) | Self::Land { .. } => {
                ExitCode::from(2)
            }
            Self::Session(_)
            | Self::Paint(_)
            | Self::Digest(_)
            | Self::File { .. }
            | Self::Picture { .. }
            | Self::Differs { .. }
            | Self::Output(_) => ExitCode::FAILURE,
        }
    }

    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self + '_ {
        |error| Self::File { path: path.into(), error }
    }
}

fn command() -> Command {
    Command::new("riverseed")
        .version(crate_version!())
        .about("A river network that grows from a word")
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(render_command())
        .subcommand(outline_command())
        .subcommand(measure_command())
        .subcommand(Command::new("table").about("Prints a page of all parameters, as Markdown"))
        .subcommand(verify_command())
}

fn render_command() -> Command {
    Command::new("render")
        .about("Draws a recipe as PNG or SVG, or writes its rivers and its relief")
        .after_help(MIXED)
        .args(recipe_arguments())
        .arg(
            Arg::new("output")
                .short('o')
                .long("output")
                .value_name("OUT")
                .required(true)
                .help("The file to write; its ending says what: .png, .svg, .geojson, .json, .zip for all that games need, or one raster of that: .heights.png, .land.png, .rivers.png, .flow.png, .basins.png")
                .value_parser(value_parser!(PathBuf)),
        )
        .arg(
            Arg::new("size")
                .long("size")
                .value_name("PIXELS")
                .default_value("1200")
                .help("The longer side of the picture")
                .value_parser(value_parser!(u32).range(1..=i64::from(LONGEST_SIDE))),
        )
        .arg(
            Arg::new("raster-size")
                .long("raster-size")
                .value_name("PIXELS")
                .help("The longer side of rasters, alone or in a ZIP: at most 4096; at least, and by default, a pixel for 2 units of the map, which is 500 on a square map")
                .value_parser(value_parser!(u32)),
        )
        .args(TABLE.iter().map(render_option))
}

fn measure_command() -> Command {
    Command::new("measure")
        .about("Prints what is measured of a recipe's rivers, and what nature has")
        .after_help(MIXED)
        .args(recipe_arguments())
        .arg(Arg::new("json").long("json").action(ArgAction::SetTrue).help("Print JSON"))
        .args(TABLE.iter().map(option))
}

/// How a recipe is given.
const MIXED: &str = "Link, file and options may be mixed; of values given twice the later wins.";

fn recipe_arguments() -> [Arg; 3] {
    [
        Arg::new("link").help("Link text, such as \"seed=kauri&curl=0.6\""),
        Arg::new("recipe")
            .long("recipe")
            .value_name("FILE")
            .help("A JSON recipe, or a network that `riverseed render` wrote")
            .value_parser(value_parser!(PathBuf)),
        Arg::new("preset").long("preset").value_name("NAME").help("A named set of values, read first"),
    ]
}

fn outline_command() -> Command {
    Command::new("outline")
        .about("Traces a PNG of a land, white on black, and prints the outline to give to a recipe")
        .after_help("White is land, black or transparent is water, a third colour makes ridges.")
        .arg(
            Arg::new("image")
                .value_name("IMAGE")
                .required(true)
                .help("A PNG, at most 4096 pixels a side")
                .value_parser(value_parser!(PathBuf)),
        )
        .arg(
            Arg::new("link")
                .long("link")
                .action(ArgAction::SetTrue)
                .help("Print a whole link, with the picture's aspect"),
        )
        .arg(Arg::new("seed").long("seed").value_name("TEXT").requires("link").help("The seed of that link"))
}

fn verify_command() -> Command {
    Command::new("verify")
        .about("Checks that this machine gives the same rivers and pixels as all others")
        .after_help("Exit code 1, and the links that differ, if it does not.")
        .arg(
            Arg::new("digests")
                .long("digests")
                .value_name("FILE")
                .help("Digests to compare with, other than those of this version: lines of a digest and a link")
                .value_parser(value_parser!(PathBuf)),
        )
}

/// The option of a parameter. That of the land takes a picture, too.
fn option(parameter: &'static Parameter) -> Arg {
    let help = match parameter.key {
        Key::Land => format!("{} Or a PNG that is the land itself: white is land, black water.", parameter.help),
        _ => parameter.help.into(),
    };
    Arg::new(parameter.name)
        .long(parameter.name)
        .value_name("VALUE")
        .help(help)
        .allow_hyphen_values(true)
        .help_heading("Parameters")
}

/// The same of `riverseed render`: `--attractors` alone asks for the attractors in JSON; with a number it sets how many. Both may be
/// given.
fn render_option(parameter: &'static Parameter) -> Arg {
    match parameter.key {
        Key::Attractors => option(parameter)
            .num_args(0..=1)
            .action(ArgAction::Append)
            .allow_hyphen_values(false)
            .value_name("N")
            .help(format!("{} Without a number: write them to JSON.", parameter.help)),
        _ => option(parameter),
    }
}

/// The forms of a file, by its ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Png,
    Svg,
    GeoJson,
    Json,
    Pack,
    Raster(Layer),
}

impl Form {
    const ALL: [(Self, &'static str); 10] = [
        (Self::Raster(Layer::Heights), ".heights.png"),
        (Self::Raster(Layer::Land), ".land.png"),
        (Self::Raster(Layer::Rivers), ".rivers.png"),
        (Self::Raster(Layer::Flow), ".flow.png"),
        (Self::Raster(Layer::Basins), ".basins.png"),
        (Self::Png, ".png"),
        (Self::Svg, ".svg"),
        (Self::GeoJson, ".geojson"),
        (Self::Json, ".json"),
        (Self::Pack, ".zip"),
    ];

    fn of(path: &Path) -> Option<(Self, &'static str)> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        // Whose name is nothing but an ending is a hidden file.
        Self::ALL.into_iter().find(|(_, ending)| name.len() > ending.len() && name.ends_with(ending))
    }
}

fn render(matches: &ArgMatches) -> Result<(), Failure> {
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
    let raster_size = matches.get_one::<u32>("raster-size").copied();
    if raster_size.is_some() && !matches!(form, Form::Raster(_) | Form::Pack) {
        return Err(Failure::Mismatch { option: "--raster-size", ending });
    }
    if let Some(size) = raster_size {
        // Before anything grows.
        Rasters::grid(&Domain::of(&order.recipe), size).map_err(Failure::RasterSize)?;
    }
    order.say_what_is_idle(matches!(form, Form::Png | Form::Svg));
    let output = Output::open(output)?;
    match form {
        Form::Png => write_picture(output, order, size),
        Form::Pack => write_pack(output, order, size, raster_size),
        Form::Raster(layer) => write_raster(output, order, layer, raster_size),
        _ => write_network(output, order, form, wants_attractors),
    }
}

fn write_picture(output: Output, order: Order, size: u32) -> Result<(), Failure> {
    let progress = progress(&order.recipe, size);
    let mut picture = picture(&order.recipe, size)?;
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
fn write_pack(output: Output, order: Order, size: u32, raster_size: Option<u32>) -> Result<(), Failure> {
    let progress = progress(&order.recipe, size.max(raster_size.unwrap_or(0)));
    let mut picture = picture(&order.recipe, size)?;
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
    let domain = Domain::of(recipe);
    let height = View::height_for(&domain, size);
    let (width, height) = if height <= size { (size, height) } else { (View::width_for(&domain, size), size) };
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

fn write_network(output: Output, order: Order, form: Form, with_attractors: bool) -> Result<(), Failure> {
    let progress = progress(&order.recipe, 0);
    let session = grow(order, &progress)?;
    progress.set_message("writing");
    output.write(|out| {
        match form {
            Form::Svg => out.write_all(export::svg::svg(&session).map_err(io::Error::other)?.as_bytes())?,
            Form::GeoJson => export::geojson::write(&mut *out, &session)?,
            _ => export::json::write(&mut *out, &session, with_attractors)?,
        }
        Ok(writeln!(out)?)
    })?;
    progress.finish_and_clear();
    Ok(())
}

/// What a call asks for: a recipe, and the land itself if that is given as a picture.
struct Order {
    recipe: Recipe,
    /// The names that were given on purpose.
    given: Vec<String>,
    land: Option<Arc<Land>>,
}

impl Order {
    fn of(matches: &ArgMatches) -> Result<Self, Failure> {
        let (recipe, given) = recipe(matches)?;
        match mask::path(matches) {
            Some(path) => mask::order(path, recipe, given),
            None => Ok(Self { recipe, given, land: None }),
        }
    }

    /// Warns of values that were given and have no effect.
    fn say_what_is_idle(&self, is_picture: bool) {
        let kind = if self.land.is_some() { LandKind::Drawn } else { Land::kind_of(&self.recipe) };
        let reason = |key| match (key, &self.land) {
            (Key::Roughness, Some(_)) => Some("the picture determines the coast"),
            _ if is_picture => self.recipe.inactive_reason(key, kind),
            _ => self.recipe.inactive_reason_in_data(key, kind),
        };
        for name in &self.given {
            if let Some(reason) = Key::from_name(name).and_then(reason) {
                eprintln!("riverseed: '{name}' has no effect: {reason}");
            }
        }
    }
}

/// Reads link, file and options in the order in which they were given. Returns the names that were given on purpose, too: a
/// network's file states every parameter, so of a file only those count that it states differently from the default. A picture of a land
/// is no part of a recipe.
fn recipe(matches: &ArgMatches) -> Result<(Recipe, Vec<String>), Failure> {
    let mut parts: Vec<(usize, Vec<(String, String)>)> = Vec::new();
    let mut part = |id: &str, pairs: Vec<(String, String)>| {
        parts.extend(matches.index_of(id).map(|index| (index, pairs)));
    };
    if let Some(text) = matches.get_one::<String>("link") {
        part("link", link::pairs(text)?);
    }
    if let Some(path) = matches.get_one::<PathBuf>("recipe") {
        part("recipe", json::pairs(&read_recipe(path)?)?);
    }
    for name in TABLE.iter().map(|parameter| parameter.name).chain([link::PRESET]) {
        let values: Vec<&String> = matches.get_many(name).into_iter().flatten().collect();
        if values.len() > 1 {
            return Err(RecipeError::Duplicate { key: name.into() }.into());
        }
        if let [value] = values[..]
            && !(name == Key::Land.parameter().name && mask::is_picture(value))
        {
            part(name, vec![(name.into(), value.clone())]);
        }
    }
    // A preset is read first, wherever it stands.
    parts.sort_by_key(|(index, pairs)| (pairs.iter().all(|(name, _)| name != link::PRESET), *index));
    let mut given: Vec<String> = Vec::new();
    let mut recipe = Recipe::default();
    let file = matches.index_of("recipe");
    for (index, pairs) in parts {
        recipe = link::apply(recipe, &pairs)?;
        let names = pairs.into_iter().map(|(name, _)| name);
        let names = names.filter(|name| Some(index) != file || is_set(&recipe, name));
        given.extend(names.filter(|name| !given.contains(name)).collect::<Vec<_>>());
    }
    Ok((recipe, given))
}

/// Whether a recipe's value of a parameter is not the default.
fn is_set(recipe: &Recipe, name: &str) -> bool {
    Key::from_name(name).is_some_and(|key| *recipe.value(key) != key.parameter().default_value())
}

/// Reads a recipe's file, but not without end.
fn read_recipe(path: &Path) -> Result<String, Failure> {
    let mut text = String::new();
    let file = File::open(path).map_err(Failure::file(path))?;
    file.take(json::LONGEST as u64 + 1).read_to_string(&mut text).map_err(Failure::file(path))?;
    Ok(text)
}

/// Grows a recipe to its end.
fn grow(order: Order, progress: &ProgressBar) -> Result<Session, Failure> {
    let mut session = match order.land {
        Some(land) => Session::on_land(order.recipe, land)?,
        None => Session::new(order.recipe)?,
    };
    if is_undrawn(&session) {
        eprintln!("riverseed: land is 'drawn' but no outline shows both land and water; all of the map is land");
    }
    progress.set_length(u64::from(session.growth().total_discharge()));
    progress.set_message("growing");
    while session.advance(16)? {
        progress.set_position(u64::from(session.growth().drained()));
    }
    match session.summary().shortfall() {
        Some(Shortfall::NoRiver) => eprintln!("riverseed: no river grew: no land lies open to the sea"),
        Some(Shortfall::Unreached) => {
            let (attractors, unreached) = (session.growth().attractors(), session.growth().unreached());
            let advice = "a shorter 'step', a longer 'kill' or 'reach', or less 'mouth-spacing' helps";
            eprintln!("riverseed: rivers leave {unreached} of {attractors} attractors unreached; {advice}");
        }
        Some(Shortfall::CutOff) => {
            let (parcels, unreached) = (session.growth().attractors(), session.growth().unreached());
            let advice = "a gap in the ridges that cut them off, or more 'mouths' (0 for all), helps";
            eprintln!("riverseed: {unreached} of {parcels} parcels have no way to a river mouth; {advice}");
        }
        None => {}
    }
    Ok(session)
}

/// Whether a drawn land is asked for and nothing that could be land is drawn.
fn is_undrawn(session: &Session) -> bool {
    let recipe = session.recipe();
    recipe.get::<LandKind>() == LandKind::Drawn && session.land().is_none() && recipe.rivers().is_empty()
}

/// A bar on standard error for long work; invisible where that is not a terminal.
fn progress(recipe: &Recipe, size: u32) -> ProgressBar {
    const LONG_GROWTH: u32 = 200_000;
    const LONG_PAINTING: u32 = 4096;
    let attractors = recipe.integer(Key::Attractors);
    if attractors < LONG_GROWTH && size < LONG_PAINTING {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {wide_bar} {percent}%");
    ProgressBar::new(u64::from(attractors)).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Traces a picture and prints its outline, or a link that shows it.
fn outline(matches: &ArgMatches) -> Result<(), Failure> {
    let Some(path) = matches.get_one::<PathBuf>("image") else { return Ok(()) };
    let picture = |reason: String| Failure::Picture { path: path.clone(), reason };
    let image = read_picture(path)?;
    let traced = trace(image.width, image.height, &image.rgba).map_err(|error| picture(error.to_string()))?;
    say_what_is_kept(&traced);
    let mut text = traced.outline.to_string();
    if matches.get_flag("link") {
        let aspect = format!("{:.2}", traced.aspect);
        let seed = matches.get_one::<String>("seed").map(|seed| ("seed", seed.as_str()));
        let pairs = [("land", "drawn"), ("aspect", &aspect), ("outline", &text)].into_iter().chain(seed);
        let pairs: Vec<_> = pairs.map(|(key, value)| (key.to_owned(), value.to_owned())).collect();
        text = link::write(&link::apply(Recipe::default(), &pairs)?);
    }
    writeln!(io::stdout(), "{text}")?;
    Ok(())
}

fn read_picture(path: &Path) -> Result<Image, Failure> {
    let file = File::open(path).map_err(Failure::file(path))?;
    let picture = |error: ImportError| Failure::Picture { path: path.into(), reason: error.to_string() };
    riverseed::import::png::read(BufReader::new(file)).map_err(picture)
}

/// Reports how much of a picture its outline has room for.
fn say_what_is_kept(traced: &Traced) {
    let of = |kept: &[Vec<GridPoint>], all: usize, kind: LineKind| match all {
        1 => format!("{} of 1 {kind}", kept.len()),
        _ => format!("{} of {all} {kind}s", kept.len()),
    };
    let (coasts, ridges) = (traced.outline.coasts(), traced.outline.ridges());
    let points = coasts.iter().chain(ridges).map(Vec::len).sum::<usize>();
    let coasts = of(coasts, traced.coasts, LineKind::Coast);
    let ridges = of(ridges, traced.ridges, LineKind::Ridge);
    eprintln!("riverseed: kept {coasts} and {ridges}, {points} points");
    say_if_longer(traced);
}

fn say_if_longer(traced: &Traced) {
    if traced.is_longer {
        eprintln!(
            "riverseed: the image is more elongated than 4:1; land on its long edges is extended to the edge of the map"
        );
    }
}
