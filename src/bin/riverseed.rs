//! The command line: `riverseed render` draws a recipe or writes its network, `riverseed table` explains recipes.
//!
//! Exit codes: 0 done, 1 the work failed, 2 the call or the recipe is wrong.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::builder::NonEmptyStringValueParser;
use clap::{Arg, ArgMatches, Command, crate_version, value_parser};
use indicatif::{ProgressBar, ProgressStyle};
use riverseed::domain::Domain;
use riverseed::export;
use riverseed::paint::{LONGEST_SIDE, View};
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Key, Kind, Parameter, Recipe, RecipeError, json, link};
use riverseed::session::{Session, SessionError};
use thiserror::Error;

fn main() -> ExitCode {
    let done = match command().get_matches().subcommand() {
        Some(("render", matches)) => render(matches),
        Some(("table", _)) => print_table(),
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
    #[error("{}: the ending of the output is none of .png, .json", path.display())]
    Ending { path: PathBuf },
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: io::Error },
    #[error(transparent)]
    Output(#[from] io::Error),
}

impl Failure {
    fn exit_code(&self) -> ExitCode {
        match self {
            Self::Recipe(_) | Self::Ending { .. } => ExitCode::from(2),
            Self::Session(_) | Self::File { .. } | Self::Output(_) => ExitCode::FAILURE,
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
        .subcommand(
            Command::new("render")
                .about("Draws a recipe as PNG, or writes its network as JSON")
                .after_help("Link, file and options may be mixed; of values given twice the later wins.")
                .arg(Arg::new("link").help("Link text, such as \"seed=kauri&curl=0.6\""))
                .arg(
                    Arg::new("recipe")
                        .long("recipe")
                        .value_name("FILE")
                        .help("A JSON recipe, or a network written by this command")
                        .value_parser(value_parser!(PathBuf)),
                )
                .arg(
                    Arg::new("output")
                        .short('o')
                        .long("output")
                        .value_name("OUT")
                        .required(true)
                        .help("The file to write; its ending, .png or .json, says what")
                        .value_parser(value_parser!(PathBuf)),
                )
                .arg(
                    Arg::new("size")
                        .long("size")
                        .value_name("PIXELS")
                        .default_value("1200")
                        .help("The longer side of a PNG")
                        .value_parser(value_parser!(u32).range(1..=i64::from(LONGEST_SIDE))),
                )
                .arg(Arg::new("preset").long("preset").value_name("NAME").help("A named set of values, read first"))
                .args(TABLE.iter().map(option)),
        )
        .subcommand(Command::new("table").about("Prints the parameter table as Markdown"))
}

/// The option of a parameter. `--attractors` alone asks for the attractors in JSON; with a number it sets how many.
fn option(parameter: &'static Parameter) -> Arg {
    let option = Arg::new(parameter.name)
        .long(parameter.name)
        .help(parameter.help)
        .allow_hyphen_values(true)
        .help_heading("Parameters");
    match parameter.key {
        Key::Attractors => option
            .num_args(0..=1)
            .allow_hyphen_values(false)
            .value_name("N")
            .value_parser(NonEmptyStringValueParser::new())
            .help(format!("{} Without a number: write them to JSON.", parameter.help)),
        _ => option.value_name("VALUE"),
    }
}

fn render(matches: &ArgMatches) -> Result<(), Failure> {
    let Some(output) = matches.get_one::<PathBuf>("output") else { return Ok(()) };
    let ending = output.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let recipe = recipe(matches)?;
    let size = matches.get_one("size").copied().unwrap_or(LONGEST_SIDE);
    match ending.as_deref() {
        Some("png") => write_file(output, |out| {
            let mut session = grow(recipe, size)?;
            session.paint();
            export::png::write(out, session.pixmap(), &link::write(session.recipe())).map_err(io::Error::from)?;
            Ok(())
        }),
        Some("json") => write_file(output, |mut out| {
            let with_attractors =
                matches.contains_id("attractors") && matches.get_one::<String>("attractors").is_none();
            export::json::write(&mut out, &grow(recipe, 1)?, with_attractors).map_err(io::Error::from)?;
            writeln!(out)?;
            Ok(())
        }),
        _ => Err(Failure::Ending { path: output.clone() }),
    }
}

/// Writes a file under a passing name and puts it in its place when it is whole: a failure loses no older file.
fn write_file(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> Result<(), Failure> {
    let mut passing = path.as_os_str().to_owned();
    passing.push(".part");
    let passing = PathBuf::from(passing);
    let mut out = BufWriter::new(File::create(&passing).map_err(Failure::file(&passing))?);
    let written = write(&mut out)
        .and_then(|()| out.flush().map_err(Failure::file(&passing)))
        .and_then(|()| fs::rename(&passing, path).map_err(Failure::file(path)));
    if written.is_err() {
        // The first failure is the one to tell of.
        let _ = fs::remove_file(&passing);
    }
    written
}

/// Reads link, file and options in the order in which they were given.
fn recipe(matches: &ArgMatches) -> Result<Recipe, Failure> {
    let mut parts: Vec<(usize, Vec<(String, String)>)> = Vec::new();
    let mut part = |id: &str, pairs: Vec<(String, String)>| {
        parts.extend(matches.index_of(id).map(|index| (index, pairs)));
    };
    if let Some(text) = matches.get_one::<String>("link") {
        part("link", link::pairs(text)?);
    }
    if let Some(path) = matches.get_one::<PathBuf>("recipe") {
        let text = fs::read_to_string(path).map_err(Failure::file(path))?;
        part("recipe", json::pairs(&text)?);
    }
    for name in TABLE.iter().map(|parameter| parameter.name).chain([link::PRESET]) {
        if let Some(value) = matches.get_one::<String>(name) {
            part(name, vec![(name.into(), value.clone())]);
        }
    }
    // A preset is read first, wherever it stands.
    parts.sort_by_key(|(index, pairs)| (pairs.iter().all(|(name, _)| name != link::PRESET), *index));
    let recipe = parts.into_iter().try_fold(Recipe::default(), |recipe, (_, pairs)| link::apply(recipe, &pairs))?;
    Ok(recipe)
}

/// Grows a recipe to its end, with a bar on the terminal if that takes long.
fn grow(recipe: Recipe, size: u32) -> Result<Session, Failure> {
    const LONG_WORK: u32 = 200_000;
    let domain = Domain::with_aspect(recipe.number(Key::Aspect));
    let height = View::height_for(&domain, size);
    let (width, height) = if height <= size { (size, height) } else { (View::width_for(&domain, size), size) };
    let mut session = Session::new(recipe, width, height)?;
    let attractors = session.growth().parameters().attractors;
    let bar = if attractors < LONG_WORK { ProgressBar::hidden() } else { progress_bar(attractors) };
    while session.advance(16) {
        bar.set_position(u64::from(attractors - session.growth().unreached()));
    }
    bar.finish_and_clear();
    if session.summary().is_stalled() {
        let unreached = session.growth().unreached();
        eprintln!(
            "riverseed: growth died out, {unreached} of {attractors} attractors unreached; a longer reach or a shorter kill distance helps"
        );
    }
    Ok(session)
}

/// A bar on standard error; invisible where that is not a terminal.
fn progress_bar(attractors: u32) -> ProgressBar {
    let style =
        ProgressStyle::with_template("growing {wide_bar} {percent}%").unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(u64::from(attractors)).with_style(style)
}

fn print_table() -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    writeln!(out, "| key | values | default | what it does |\n| --- | --- | --- | --- |")?;
    for parameter in &TABLE {
        let default = parameter.text_of(&parameter.default_value());
        writeln!(out, "| `{}` | {} | {default} | {} |", parameter.name, values(parameter), parameter.help)?;
    }
    Ok(())
}

/// A parameter's range in words.
fn values(parameter: &Parameter) -> String {
    let unit = if parameter.unit.is_empty() { String::new() } else { format!(" {}", parameter.unit) };
    match parameter.kind {
        Kind::Text { longest, .. } => format!("text, at most {longest} characters"),
        Kind::Integer { min, max, .. } if min == max => min.to_string(),
        Kind::Integer { min, max, .. } => format!("{min} to {max}{unit}"),
        Kind::Number { min, max, .. } => format!("{min} to {max}{unit}"),
        Kind::Choice { choices } => choices.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(", "),
        Kind::Sides { .. } => "some of n, e, s, w".into(),
    }
}
