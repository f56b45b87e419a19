//! `riverseed outline`: the outline of a picture of a land.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use riverseed::import::png::{Image, ImportError};
use riverseed::land::trace::{Traced, trace};
use riverseed::recipe::{GridPoint, LineKind, Recipe, link};

use super::{Failure, say, stdout};

/// Traces a picture and prints its outline, or a link that shows it.
pub fn outline(matches: &ArgMatches) -> Result<(), Failure> {
    stdout::check()?;
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

pub fn read_picture(path: &Path) -> Result<Image, Failure> {
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
    say(&format!("kept {coasts} and {ridges}, {points} points"));
    say_what_is_odd(traced);
}

/// Reports what is probably not as a picture's maker wants it.
pub fn say_what_is_odd(traced: &Traced) {
    if traced.looks_like_heights {
        say(
            "this looks like a heightmap, but greys are no heights here: light is land and dark is water; give a picture \
             that is white where the heights are above the sea, and black elsewhere",
        );
    }
    if traced.is_longer {
        say("the image is more elongated than 4:1; land on its long edges is extended to the edge of the map");
    }
}
