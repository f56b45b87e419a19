//! What calls there are, and what each may be given.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, crate_version, value_parser};
use riverseed::paint::LONGEST_SIDE;
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Key, Parameter};

use super::batch::Shard;

/// All commands.
pub fn command() -> Command {
    Command::new("riverseed")
        .version(crate_version!())
        .about("A river network that grows from a word")
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(render_command())
        .subcommand(outline_command())
        .subcommand(measure_command())
        .subcommand(names_command())
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
                .action(ArgAction::Append)
                .help("A file to write; its ending says what: .png, .svg, .geojson, .json, .zip for all that games need, or one raster of that: .heights.png, .land.png, .rivers.png, .flow.png, .basins.png; or - for JSON, a line a map, on standard output. May be given again: a map is grown once for all of its files")
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
        .arg(
            Arg::new("ratio")
                .long("ratio")
                .value_name("RATIO")
                .help("Pixels of the screen to a CSS pixel, from 0.5 to 4 in quarters: letters in a PNG are at least 11 CSS pixels large [default: 1]")
                .value_parser(ratio),
        )
        .arg(
            Arg::new("svg-text")
                .long("svg-text")
                .action(ArgAction::SetTrue)
                .help("Write labels in SVG as text on paths, for readers that have EB Garamond, and not as outlines"),
        )
        .args(batch_arguments())
        .args(TABLE.iter().map(render_option))
}

/// The options of many maps in one call.
fn batch_arguments() -> [Arg; 4] {
    let argument = |name: &'static str| Arg::new(name).long(name).help_heading("Many maps");
    let further = |name: &'static str| argument(name).requires("seeds");
    [
        argument("seeds")
            .value_name("FILE|FROM..TO")
            .conflicts_with(Key::Seed.parameter().name)
            .help("Make a map of each seed: of each line of a file, of standard input (-), or of each number of a range, TO too. {seed} in the name of each OUT stands for the seed. Files that are there and whole are not made again")
            .value_parser(value_parser!(OsString)),
        further("shard")
            .value_name("I/N")
            .help("Make the I-th of N shares of the maps only, as one of N machines")
            .value_parser(str::parse::<Shard>),
        further("threads")
            .value_name("N")
            .help("How many maps are made at once [default: one for each core]")
            .value_parser(threads),
        further("again").action(ArgAction::SetTrue).help("Make files again that are there"),
    ]
}

fn threads(text: &str) -> Result<usize, String> {
    let threads = text.parse().ok().filter(|threads| (1..=1024).contains(threads));
    threads.ok_or_else(|| "it has to be from 1 to 1024".into())
}

fn ratio(text: &str) -> Result<f32, String> {
    let ratio = text.parse::<f32>().ok().filter(|ratio| (0.5..=4.0).contains(ratio) && (ratio * 4.0).fract() == 0.0);
    ratio.ok_or_else(|| "it has to be from 0.5 to 4, in quarters".into())
}

fn measure_command() -> Command {
    Command::new("measure")
        .about("Prints what is measured of a recipe's rivers, and what nature has")
        .after_help(MIXED)
        .args(recipe_arguments())
        .arg(Arg::new("json").long("json").action(ArgAction::SetTrue).help("Print JSON"))
        .args(TABLE.iter().map(option))
}

fn names_command() -> Command {
    Command::new("names")
        .about("Prints the names of a recipe's rivers, greatest first, and the marks by which 'names' gives others")
        .after_help(MIXED)
        .args(recipe_arguments())
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
