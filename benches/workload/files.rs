//! Whole maps: from a recipe to its files.

use std::io::{self, Write};

use png::{ColorType, Compression, Encoder, EncodingError};
use riverseed::export;
use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::{Map, Session};

use tiny_skia::Pixmap;

use super::{Repetition, recipe};

/// The side of a picture that is kept, in pixels.
const LARGE: u32 = 2048;

/// A writer that only counts.
#[derive(Default)]
struct Counter(u64);

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// An island with `trim=0` and all rounds of meandering, whose size grows with the number of attractors.
fn large(growth: &str, attractors: &str) -> Option<Recipe> {
    recipe(&format!("growth={growth}&land=island&mouths=0&trim=0&style=atlas&attractors={attractors}"))
}

/// Prepares a task; `None` if there is no such task.
pub fn repetition(task: &[&str]) -> Option<Repetition> {
    match *task {
        ["whole", growth, attractors] => whole(large(growth, attractors)?, &["json", "geojson", "svg"]),
        ["to-json", link] => whole(link::read(link).ok()?, &["json"]),
        ["file", form, attractors] => file(form, attractors),
        ["png", style] => png(style, false),
        ["balanced-png", style] => png(style, true),
        _ => None,
    }
}

/// Makes a whole map, with the relief that its style shows, and some of its data files. Returns the number of vertices.
fn whole(recipe: Recipe, forms: &'static [&str]) -> Option<Repetition> {
    let vertices = move || -> Option<u32> {
        let mut session = Session::new(recipe.clone()).ok()?;
        let map = session.finish().ok()?;
        forms.iter().try_for_each(|form| written(&map, form).map(drop))?;
        Some(map.network().vertices.len() as u32)
    };
    Some(Box::new(move || vertices().unwrap_or(0)))
}

/// Writes a file of a finished map. Returns its length in kB.
fn file(form: &str, attractors: &str) -> Option<Repetition> {
    let mut session = Session::new(large("colonize", attractors)?).ok()?;
    let map = session.finish().ok()?;
    let form = form.to_owned();
    Some(Box::new(move || written(&map, &form).map_or(0, |bytes| (bytes / 1000) as u32)))
}

fn written(map: &Map, form: &str) -> Option<u64> {
    let mut out = Counter::default();
    match form {
        "json" => export::json::write(&mut out, map, None).ok()?,
        "geojson" => export::geojson::write(&mut out, map).ok()?,
        _ => out.write_all(export::svg::svg(map).ok()?.as_bytes()).ok()?,
    }
    Some(out.0)
}

/// Writes a picture of a default map as PNG, with our settings or the crate's own balance of time and size. Returns its
/// length in kB.
fn png(style: &str, is_balanced: bool) -> Option<Repetition> {
    let recipe = link::read(&format!("style={style}&labels=none")).ok()?;
    let mut session = Session::new(recipe.clone()).ok()?;
    let mut picture = Picture::new(LARGE, LARGE).ok()?;
    session.finish().ok()?;
    picture.paint(&session);
    let (write, link) = (if is_balanced { balanced } else { ours }, link::write(&recipe));
    Some(Box::new(move || {
        let mut out = Counter::default();
        write(&mut out, picture.pixmap(), &link).map_or(0, |()| (out.0 / 1000) as u32)
    }))
}

fn ours(out: &mut Counter, pixmap: &Pixmap, link: &str) -> Result<(), EncodingError> {
    export::png::write(out, pixmap, link)
}

fn balanced(out: &mut Counter, pixmap: &Pixmap, _: &str) -> Result<(), EncodingError> {
    let mut encoder = Encoder::new(out, pixmap.width(), pixmap.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_compression(Compression::Balanced);
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|rgba| rgba[..3].iter().copied()).collect();
    encoder.write_header()?.write_image_data(&rgb)
}
