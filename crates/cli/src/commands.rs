//! The commands and their arguments.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, crate_version, value_parser};
use riverseed::paint::LONGEST_SIDE;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Key, Kind, Parameter, is_decided};
use riverseed_exchange::gis::crs::Crs;
use riverseed_exchange::{SIZE, Sheet, is_ratio};

use super::batch::Shard;
use super::form;
use super::table;

/// Lists all commands.
pub fn command() -> Command {
    Command::new("riverseed")
        .version(crate_version!())
        .about("A river network that grows from a word")
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(render_command())
        .subcommand(page_command())
        .subcommand(embed_command())
        .subcommand(outline_command())
        .subcommand(measure_command())
        .subcommand(check_command())
        .subcommand(names_command())
        .subcommand(table_command())
        .subcommand(verify_command())
}

fn table_command() -> Command {
    let json = Arg::new("json").long("json").action(ArgAction::SetTrue);
    Command::new("table")
        .about("Prints a page of all parameters, as Markdown")
        .arg(json.help("Prints parameters, presets and countries as JSON, with ranges, choices and defaults"))
}

fn render_command() -> Command {
    Command::new("render")
        .about("Draws a recipe as PNG or SVG, or writes its rivers and its relief")
        .after_help(MIXED)
        .args(recipe_arguments())
        .args(file_arguments())
        .args(batch_arguments())
        .args(TABLE.iter().map(render_option))
}

/// Lists the options for files and what they hold.
fn file_arguments() -> [Arg; 11] {
    let argument = |name: &'static str| Arg::new(name).long(name);
    let number = |name: &'static str| argument(name).value_name("PIXELS");
    [
        argument("output")
            .short('o')
            .value_name("OUT")
            .required(true)
            .action(ArgAction::Append)
            .help(form::help())
            .value_parser(value_parser!(PathBuf)),
        number("size")
            .help(format!("The longer side of the picture [default: {SIZE}]"))
            .value_parser(value_parser!(u32).range(1..=i64::from(LONGEST_SIDE))),
        number("raster-size")
            .help("The longer side of rasters, alone or in a ZIP, up to 4097. In packs for engines it is 505, 1009, 2017 [default] or 4033 for Unreal, and 513, 1025, 2049 [default] or 4097 for Unity and Godot. For all other rasters the minimum and the default are one pixel for 2 units of the map: 500 on a square map")
            .value_parser(value_parser!(u32)),
        argument("ratio")
            .value_name("RATIO")
            .help("Device pixels per CSS pixel, from 0.5 to 4 in quarters. Letters in a PNG are never smaller than 11 CSS pixels [default: 1]")
            .value_parser(ratio),
        argument("svg-text")
            .action(ArgAction::SetTrue)
            .help("Write labels in SVG as text on paths instead of outlines, for readers that have EB Garamond"),
        argument("geojson-segments")
            .action(ArgAction::SetTrue)
            .help("Add the rivers to GeoJSON once more, cut at their confluences: a graph"),
        argument("geojson-flat")
            .action(ArgAction::SetTrue)
            .help("Write GeoJSON without heights, for readers that want all positions in two dimensions"),
        argument("crs")
            .value_name("EPSG:N|none")
            .help("The coordinate system that .tif and .gpkg say they have, with the map's centre as its origin: a UTM zone of WGS 84, EPSG:3395, EPSG:3857, EPSG:6933, or none [default: a plane in metres that lies nowhere on Earth]")
            .value_parser(str::parse::<Crs>),
        argument("sheet")
            .value_name("SHEET")
            .help(format!("The sheet of paper of .plot.svg, which lies or stands as the map does: {} [default: {}]", sheets(), Sheet::default().name()))
            .value_parser(sheet),
        argument("beds")
            .action(ArgAction::SetTrue)
            .overrides_with("no-beds")
            .help("Lower the ground under rivers by their depth in the heights of packs for engines and of .r16 [default for Unity and Godot]"),
        argument("no-beds")
            .action(ArgAction::SetTrue)
            .overrides_with("beds")
            .help("Leave the ground under rivers as high as their water [default for Unreal, which digs beds by itself, and for .r16]"),
    ]
}

fn page_command() -> Command {
    Command::new("page")
        .about("Writes a page for one map, as a folder for any static host: the page, pictures, a card for link previews, an embed page and the element")
        .after_help(MIXED)
        .args(recipe_arguments())
        .args(page_arguments())
        .args(TABLE.iter().map(option))
}

fn embed_command() -> Command {
    let json = Arg::new("json").long("json").action(ArgAction::SetTrue);
    Command::new("embed")
        .about("Prints the element <river-seed> for a map, to be put into a page")
        .arg(link_argument().required(true))
        .arg(json.help("Print what a program needs to embed the map and its picture, as JSON"))
}

fn page_arguments() -> [Arg; 9] {
    let argument = |name: &'static str, value: &'static str| Arg::new(name).long(name).value_name(value);
    [
        argument("output", "FOLDER")
            .short('o')
            .required(true)
            .help("The folder to write, which is created if necessary. {seed} in its name stands for the seed")
            .value_parser(value_parser!(PathBuf)),
        argument("address", "URL")
            .help("The address that the folder will have. The card and oEmbed need it; without it the page has neither"),
        argument("element", "FOLDER|URL")
            .help("The folder with the files of <river-seed>, which are copied, or the address of such a folder on another host [default: $RIVERSEED_ELEMENT]")
            .value_parser(value_parser!(OsString)),
        Arg::new("no-element")
            .long("no-element")
            .action(ArgAction::SetTrue)
            .conflicts_with("element")
            .help("Show the picture only"),
        argument("maker", "URL").help("The address of a page of Riverseed, where readers can change the map"),
        argument("title", "TEXT").help("The heading [default: the map's name]"),
        argument("description", "TEXT").help("The sentence under the heading [default: one about the rivers]"),
        argument("size", "PIXELS")
            .default_value("1600")
            .help("The longer side of the picture")
            .value_parser(value_parser!(u32).range(256..=i64::from(LONGEST_SIDE))),
        Arg::new("replace")
            .long("replace")
            .action(ArgAction::SetTrue)
            .help("Replace files in the way that this command did not write, or that were changed since"),
    ]
}

/// Lists the options for many maps in one call.
fn batch_arguments() -> [Arg; 4] {
    let argument = |name: &'static str| Arg::new(name).long(name).help_heading("Many maps");
    let further = |name: &'static str| argument(name).requires("seeds");
    [
        argument("seeds")
            .value_name("FILE|FROM..TO")
            .conflicts_with(Key::Seed.parameter().name)
            .help("Render one map per seed: from the lines of a file, from standard input (-), or from an inclusive range. {seed} in each OUT stands for the seed. Complete files are skipped")
            .value_parser(value_parser!(OsString)),
        further("shard")
            .value_name("I/N")
            .help("Render only the I-th of N shares of the maps, as one of N machines")
            .value_parser(str::parse::<Shard>),
        further("threads")
            .value_name("N")
            .help("Number of maps rendered at a time [default: one per core]")
            .value_parser(threads),
        further("again").action(ArgAction::SetTrue).help("Render files again even if they are complete"),
    ]
}

fn threads(text: &str) -> Result<usize, String> {
    let threads = text.parse().ok().filter(|threads| (1..=1024).contains(threads));
    threads.ok_or_else(|| "must be from 1 to 1024".into())
}

fn sheet(text: &str) -> Result<Sheet, String> {
    Sheet::named(text).ok_or_else(|| format!("must be one of {}", sheets()))
}

fn sheets() -> String {
    Sheet::ALL.map(Sheet::name).join(", ")
}

fn ratio(text: &str) -> Result<f32, String> {
    let ratio = text.parse().ok().filter(|ratio| is_ratio(*ratio));
    ratio.ok_or_else(|| "must be from 0.5 to 4, in quarters".into())
}

fn measure_command() -> Command {
    Command::new("measure")
        .about("Prints measures of a recipe's rivers, beside those of natural rivers")
        .after_help(MIXED)
        .args(recipe_arguments())
        .arg(Arg::new("json").long("json").action(ArgAction::SetTrue).help("Print JSON"))
        .args(TABLE.iter().map(option))
}

fn check_command() -> Command {
    Command::new("check")
        .about("Checks that a map keeps the promises of all maps, and says which of nature's ranges it keeps")
        .after_help(format!("{MIXED}\n{CHECKED}"))
        .args(recipe_arguments())
        .arg(
            Arg::new("json")
                .long("json")
                .action(ArgAction::SetTrue)
                .help("Print JSON, with all places of what is wrong"),
        )
        .args(TABLE.iter().map(option))
}

fn names_command() -> Command {
    Command::new("names")
        .about("Prints the names of a recipe's rivers, greatest first, with the marks for 'names'")
        .after_help(MIXED)
        .args(recipe_arguments())
        .args(TABLE.iter().map(option))
}

/// The rule for a recipe that is given in several ways.
const MIXED: &str = "Link, file and options may be mixed. If a value is given twice, the later one counts.";

/// What the exit code of a check says.
const CHECKED: &str =
    "The exit code is 0 if all promises are kept, and 3 if one is broken. A value outside nature's range breaks none.";

fn recipe_arguments() -> [Arg; 3] {
    [
        link_argument(),
        Arg::new("recipe")
            .long("recipe")
            .value_name("FILE")
            .help("A JSON recipe, or a network written by `riverseed render`")
            .value_parser(value_parser!(PathBuf)),
        Arg::new("preset").long("preset").value_name("NAME").help("A named set of values, read first"),
    ]
}

fn link_argument() -> Arg {
    Arg::new("link").help("Link text, such as \"seed=kauri&curl=0.6\", a whole address, or a word")
}

fn outline_command() -> Command {
    Command::new("outline")
        .about("Traces a PNG of a land, white on black, and prints its outline for a recipe")
        .after_help("White is land, black or transparent is water, a third colour is a ridge.")
        .arg(
            Arg::new("image")
                .value_name("IMAGE")
                .required(true)
                .help("A PNG, up to 4096 pixels a side")
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
        .about("Checks that this machine gives the same rivers and pixels as every other one")
        .after_help("If it does not, prints the links that differ and exits with code 1.")
        .arg(
            Arg::new("digests")
                .long("digests")
                .value_name("FILE")
                .help("Digests to compare with instead of those of this version: lines of a digest and a link")
                .value_parser(value_parser!(PathBuf)),
        )
}

/// Makes the option of a parameter. `--land` also takes a picture.
fn option(parameter: &'static Parameter) -> Arg {
    let help = match parameter.key {
        Key::Land => format!("{} Or a PNG of the land: white is land, black is water.", parameter.help),
        _ => parameter.help.into(),
    } + &taken(parameter);
    Arg::new(parameter.name)
        .long(parameter.name)
        .value_name("VALUE")
        .help(help)
        .allow_hyphen_values(true)
        .help_heading("Parameters")
}

/// Writes which values a parameter takes, in brackets; nothing for one that is text of a kind.
fn taken(parameter: &Parameter) -> String {
    let or_auto = if is_decided(parameter.key) { ", or auto" } else { "" };
    match parameter.kind {
        Kind::Integer { .. } | Kind::Number { .. } | Kind::Choice { .. } => {
            format!(" [{}{or_auto}]", table::values(parameter))
        }
        Kind::Text { .. } | Kind::Sides { .. } | Kind::Outline => String::new(),
    }
}

/// Makes the option of a parameter for `riverseed render`. `--attractors` without a number asks for the attractors in JSON;
/// with a number it sets how many there are. Both may be given.
fn render_option(parameter: &'static Parameter) -> Arg {
    match parameter.key {
        Key::Attractors => option(parameter)
            .num_args(0..=1)
            .action(ArgAction::Append)
            .allow_hyphen_values(false)
            .value_name("N")
            .help(format!("{} Without a number: write them to JSON.{}", parameter.help, taken(parameter))),
        _ => option(parameter),
    }
}
