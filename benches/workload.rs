//! The work that `make bench` measures, without a clock. The native program and the wasm module do the same work, and
//! `run.mjs` measures both.
//!
//! A task is named by a line of words, such as `grow 100000 3`. Each task is prepared once, and then run as often as it
//! is measured. Our ways of drawing and tiny-skia's get the same segments with the same widths.

use std::collections::BTreeMap;

use riverseed::recipe::{Recipe, link};

#[path = "bends.rs"]
mod bends;
mod drawing;
#[cfg(feature = "png")]
mod files;
mod growth;
mod labels;
#[path = "../tests/common/literal.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod literal;
mod maps;
mod nature;
mod network;
#[path = "../tests/common/pairs.rs"]
mod pairs;
mod pictures;
#[path = "../tests/common/plain.rs"]
mod plain;
mod relief;
#[path = "../tests/common/twin.rs"]
mod twin;
#[path = "../tests/common/words.rs"]
mod words;

/// The side of every picture, in pixels.
const SIDE: u32 = 1024;

/// The number of attractors for a tree with slightly more segments than are drawn.
const ATTRACTORS_FOR_SEGMENTS: u32 = 100_000;

/// A function that runs a task once. Its result depends on the task, and is the same natively and as wasm.
pub type Repetition = Box<dyn FnMut() -> u32>;

/// All tasks that have been prepared.
#[derive(Default)]
pub struct Workload(BTreeMap<String, Repetition>);

impl Workload {
    /// Prepares a task, unless it is prepared. `None` if there is no such task.
    pub fn prepare(&mut self, task: &str) -> Option<&mut Repetition> {
        if !self.0.contains_key(task) {
            self.0.insert(task.into(), repetition(task)?);
        }
        self.0.get_mut(task)
    }
}

fn repetition(task: &str) -> Option<Repetition> {
    let words: Vec<&str> = task.split(' ').collect();
    match words[..] {
        ["variants"] => Some(Box::new(growth::equal_variants)),
        ["grow", attractors, reach] => growth::growth(attractors, reach),
        ["twin", attractors, reach] => growth::the_twin(attractors, reach),
        ["land", kind] => growth::shaping(kind),
        ["grow-on", kind, attractors] => growth::growth_on(kind, attractors),
        ["brownian", side, sensitivity] => growth::brownian(side, sensitivity),
        ["drain", attractors] => growth::drainage(attractors),
        ["finish", growth, attractors] => pictures::finished(growth, attractors),
        ["literal-brownian", side, sensitivity] => growth::literal_brownian(side, sensitivity),
        ["capsules"] => drawing::capsules(),
        ["mask-ribbons"] => drawing::mask_ribbons(),
        ["ribbons"] => drawing::ribbons(),
        ["strokes"] => drawing::strokes(),
        ["picture"] => pictures::changes("width=12", "width=12.5", ATTRACTORS_FOR_SEGMENTS, BARE),
        ["slider", attractors] => pictures::changes("reach=3", "reach=3.05", attractors.parse().ok()?, BARE),
        ["page-slider", attractors] => pictures::changes("", "reach=2.45", attractors.parse().ok()?, "aspect=1"),
        ["shape"] => network::shaping_of_rivers(),
        ["round", maps] => network::round(maps.parse().ok()?),
        ["pairs"] => network::all_pairs(),
        ["bends", model, measure, percent] => network::bends_of(model, measure, percent.parse().ok()?),
        ["nature", measure, which] => nature::figure(measure, which),
        ["late", key, one, other] => pictures::late(&format!("{key}={one}"), &format!("{key}={other}")),
        #[cfg(feature = "png")]
        ["whole" | "to-json" | "file" | "png" | "balanced-png", ..] => files::repetition(&words),
        ["relief"] => relief::relief(),
        ["map", look] => maps::whole(look),
        ["map-picture", look] => maps::picture(look),
        ["count", what, look] => maps::count(what, look),
        ["phases", look] => maps::phases(look),
        ["grid", cells, threads] => relief::grid(cells.parse().ok()?, threads.parse().ok()?),
        ["restyle", land, style] => relief::repaint(land, &relief::restyled(style), true),
        ["restyle-less-painting", land, style] => relief::repaint(land, &relief::restyled(style), false),
        ["reshade", land] => relief::repaint(land, &["style=atlas", "style=atlas&shade=1"].map(String::from), true),
        ["wooded", woods] => pictures::pictured(
            link::read(&format!("land=island&style=ink&labels=none&woods={woods}&hills={woods}")).ok()?,
        ),
        ["labelled", labels] => pictures::pictured(link::read(&format!("land=island&style=ink&labels={labels}")).ok()?),
        ["labels", labels, places] => {
            labels::of_parts(link::read(&format!("land=island&style=ink&labels={labels}")).ok()?, places == "kept")
        }
        ["pen"] => pictures::changes("roughness=0.5", "roughness=0.51", 6000, DRAWN),
        ["differing"] => Some(Box::new(|| pictures::differing_bytes().unwrap_or(u32::MAX))),
        _ => None,
    }
}

/// A land drawn by hand with a lake and a ridge; otherwise like the plain rectangle.
const DRAWN: &str = "land=drawn&outline=.3CgA5Tmy30twyhyhrhz8lJzMgAyja2zMUez8NeyhILtwGsmyI9gAMza2P7WuR8R8UeMDZNGsf_EfmyGsrhMDuDR8wEWuzMa2.jMZmoUa4mZgA.AAzMHr2ZJm__AA__..TMgAcznr";

/// The settings shared by all figures: one mouth in a square, kill and step half a spacing, and no trimming.
const BARE: &str = "aspect=1&mouths=1&reach=3&kill=0.5&step=0.5&trim=0&tributary-spacing=0";

/// Makes a recipe. Keys that a link leaves out are as on the plain rectangle, so that no figure changes with a default.
fn recipe(link: &str) -> Option<Recipe> {
    link::read(&plain::plain(link)).ok()
}
