//! What `make bench` measures, without a clock: the native program and the wasm module do the same work, and
//! `run.mjs` times both.
//!
//! A task is named by a line of words, such as `grow 100000 3`. Each task is made ready once, and then run as often as
//! it is timed. Ours and tiny-skia's ways of drawing get the same segments with the same widths.

use std::collections::BTreeMap;

use bends::Bend;
use glam::Vec2;
use riverseed::domain::Domain;
use riverseed::grow::{Brownian, Colonize, Growth, GrowthSettings, Raster};
use riverseed::land::Land;
use riverseed::network::{self, Meander, NONE, Network, River, Shaping, Vertex};
use riverseed::paint::{Coverage, Pen, View, Widths};
use riverseed::picture::Picture;
use riverseed::prune::{self, Trim};
use riverseed::random::Seed;
use riverseed::recipe::preset::PRESETS;
use riverseed::recipe::{CourseShape, Key, Recipe, Sides, link};
use riverseed::session::Session;
use riverseed::tree::{Hydrology, Tree};
use tiny_skia::{FillRule, LineCap, Mask, Paint, PathBuilder, Pixmap, Stroke, Transform};

#[path = "bends.rs"]
mod bends;
#[path = "../tests/common/literal.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod literal;
#[path = "../tests/common/pairs.rs"]
mod pairs;
#[path = "../tests/common/plain.rs"]
mod plain;
#[path = "../tests/common/twin.rs"]
mod twin;

/// The side of every picture, in pixels.
const SIDE: u32 = 1024;

/// How many segments the drawing tasks draw, and how many attractors make a tree with a few more than that.
const SEGMENTS: usize = 100_000;
const ATTRACTORS_FOR_SEGMENTS: u32 = 100_000;

/// Runs a task once. What it returns depends on the task, and is the same natively and as wasm.
pub type Repetition = Box<dyn FnMut() -> u32>;

/// All tasks that have been made ready.
#[derive(Default)]
pub struct Workload(BTreeMap<String, Repetition>);

impl Workload {
    /// Makes a task ready, if it is not. `None` if there is no such task.
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
        ["variants"] => Some(Box::new(equal_variants)),
        ["grow", attractors, reach] => growth(attractors, reach),
        ["twin", attractors, reach] => the_twin(attractors, reach),
        ["land", kind] => shaping(kind),
        ["grow-on", kind, attractors] => growth_on(kind, attractors),
        ["brownian", side, sensitivity] => brownian(side, sensitivity),
        ["drain", attractors] => drainage(attractors),
        ["finish", growth, attractors] => finished(growth, attractors),
        ["literal-brownian", side, sensitivity] => literal_brownian(side, sensitivity),
        ["capsules"] => capsules(),
        ["mask-ribbons"] => mask_ribbons(),
        ["ribbons"] => ribbons(),
        ["strokes"] => strokes(),
        ["picture"] => changes("width=12", "width=12.5", ATTRACTORS_FOR_SEGMENTS, BARE),
        ["slider", attractors] => changes("reach=3", "reach=3.05", attractors.parse().ok()?, BARE),
        ["page-slider", attractors] => changes("", "reach=2.45", attractors.parse().ok()?, "aspect=1"),
        ["shape"] => shaping_of_rivers(),
        ["round", maps] => round(maps.parse().ok()?),
        ["pairs"] => all_pairs(),
        ["bends", model, measure, percent] => bends_of(model, measure, percent.parse().ok()?),
        ["late", key, one, other] => late(&format!("{key}={one}"), &format!("{key}={other}")),
        ["relief"] => relief(),
        ["restyle", land, style] => repaint(land, &restyled(style), true),
        ["restyle-less-painting", land, style] => repaint(land, &restyled(style), false),
        ["reshade", land] => repaint(land, &["style=atlas", "style=atlas&shade=1"].map(String::from), true),
        ["wooded", woods] => pictured(link::read(&format!("land=island&style=ink&woods={woods}&hills={woods}")).ok()?),
        ["labelled", labels] => pictured(link::read(&format!("land=island&style=ink&labels={labels}")).ok()?),
        ["pen"] => changes("roughness=0.5", "roughness=0.51", 6000, DRAWN),
        ["differing"] => Some(Box::new(|| differing_bytes().unwrap_or(u32::MAX))),
        _ => None,
    }
}

/// A land drawn by hand, with a lake and a ridge, as the plain rectangle otherwise.
const DRAWN: &str = "land=drawn&outline=.3CgA5Tmy30twyhyhrhz8lJzMgAyja2zMUez8NeyhILtwGsmyI9gAMza2P7WuR8R8UeMDZNGsf_EfmyGsrhMDuDR8wEWuzMa2.jMZmoUa4mZgA.AAzMHr2ZJm__AA__..TMgAcznr";

/// The work all figures agree on: one mouth in a square, kill and step half a spacing, everything that has grown stays.
const BARE: &str = "aspect=1&mouths=1&reach=3&kill=0.5&step=0.5&trim=0";

/// What a link leaves out is as on the plain rectangle, so that no figure changes with a default.
fn recipe(link: &str) -> Option<Recipe> {
    link::read(&plain::plain(link)).ok()
}

fn settings(attractors: &str, reach: &str) -> Option<GrowthSettings> {
    let mut recipe = recipe(BARE)?;
    recipe.set(Key::Attractors, attractors).ok()?;
    recipe.set(Key::Reach, reach).ok()?;
    Some(GrowthSettings::of(&recipe))
}

fn grown(settings: &GrowthSettings) -> Option<Colonize> {
    let mut growth = Colonize::new(settings.clone()).ok()?;
    while growth.tick() {}
    Some(growth)
}

/// Growth from the recipe to the last node; the number of nodes.
fn growth(attractors: &str, reach: &str) -> Option<Repetition> {
    let settings = settings(attractors, reach)?;
    Some(Box::new(move || grown(&settings).map_or(0, |growth| growth.tree().len() as u32)))
}

/// Shaping a land; how many regions it has.
fn shaping(kind: &str) -> Option<Repetition> {
    let recipe = recipe(&format!("land={kind}"))?;
    Some(Box::new(move || Land::of(&recipe).map_or(0, |land| land.regions().len() as u32)))
}

/// Growth on a land that is there already; the number of nodes.
fn growth_on(kind: &str, attractors: &str) -> Option<Repetition> {
    let land = if kind == "drawn" { DRAWN.to_owned() } else { format!("land={kind}") };
    let settings = GrowthSettings::of(&recipe(&format!("{BARE}&{land}&attractors={attractors}"))?);
    Some(Box::new(move || grown(&settings).map_or(0, |growth| growth.tree().len() as u32)))
}

/// The same by brute force.
fn the_twin(attractors: &str, reach: &str) -> Option<Repetition> {
    let settings = settings(attractors, reach)?;
    Some(Box::new(move || twin::grow(&settings).len() as u32))
}

/// How many of 120 trees, six presets with twenty seeds each, are the twin's to the bit.
fn equal_variants() -> u32 {
    let links = PRESETS.iter().flat_map(|preset| {
        (0..20u32).map(move |seed| format!("seed={seed}&preset={}&attractors=400&mouths={}", preset.name, 1 + seed % 4))
    });
    links.filter(|link| equals_twin(link).unwrap_or(false)).count() as u32
}

fn equals_twin(link: &str) -> Option<bool> {
    let growth = grown(&GrowthSettings::of(&recipe(link)?))?;
    let tree = growth.tree();
    let twin = twin::grow(growth.settings());
    let bits = |at: Vec2| [at.x.to_bits(), at.y.to_bits()];
    let is_same = |(i, (node, tick)): (usize, (&twin::Black, u32))| {
        let ours = (bits(tree.at[i]), tree.parent[i], tree.drained[i], tick);
        ours == (bits(node.at), node.parent, node.drained, node.tick)
    };
    Some(tree.len() == twin.len() && twin.iter().zip(tree.ticks()).enumerate().all(is_same))
}

// ---- Brownian trees

/// A square raster of land with sea on all sides.
fn square(side: &str) -> Option<Raster> {
    let side = side.parse().ok()?;
    Some(Raster::with_sea(side, side, 1.0, Sides::parse("nesw")?))
}

/// Growth from the raster to the last node; the number of nodes.
fn brownian(side: &str, sensitivity: &str) -> Option<Repetition> {
    let (raster, sensitivity) = (square(side)?, sensitivity.parse().ok()?);
    Some(Box::new(move || {
        let Ok(mut growth) = Brownian::new(raster.clone(), Seed::from_text("kauri"), sensitivity) else { return 0 };
        while growth.tick() {}
        growth.tree().len() as u32
    }))
}

/// The same by a literal search of the disc after every move.
fn literal_brownian(side: &str, sensitivity: &str) -> Option<Repetition> {
    let (raster, sensitivity) = (square(side)?, sensitivity.parse().ok()?);
    Some(Box::new(move || literal::grow(&raster, Seed::from_text("kauri"), sensitivity).len() as u32))
}

// ---- drainage

/// Drainage of a square from the recipe to its last round; the number of nodes.
fn drainage(attractors: &str) -> Option<Repetition> {
    let recipe = recipe(&format!("growth=drainage&aspect=1&mouths=0&captures=5&attractors={attractors}"))?;
    Some(Box::new(move || all_grown(&recipe).map_or(0, |growth| growth.tree().len() as u32)))
}

/// An island from its link to the finished picture; the number of rivers.
fn finished(growth: &str, attractors: &str) -> Option<Repetition> {
    pictured(recipe(&format!("growth={growth}&land=island&mouths=0&attractors={attractors}"))?)
}

/// A map from its recipe to the finished picture; the number of rivers.
fn pictured(recipe: Recipe) -> Option<Repetition> {
    let rivers = move || -> Option<u32> {
        let mut session = Session::new(recipe.clone()).ok()?;
        let mut picture = Picture::new(SIDE, SIDE).ok()?;
        session.advance(u32::MAX).ok()?;
        picture.paint(&session);
        Some(session.network()?.rivers.len() as u32)
    };
    Some(Box::new(move || rivers().unwrap_or(0)))
}

// ---- the network

/// A plain map's tree to its rivers, all rounds of meandering made; the number of vertices.
fn shaping_of_rivers() -> Option<Repetition> {
    let recipe = recipe("")?;
    let growth = all_grown(&recipe)?;
    Some(Box::new(move || {
        let Some(mut shaping) = unshaped(&recipe, &growth) else { return 0 };
        while shaping.step() {}
        shaping.network().map_or(0, |network| network.vertices.len() as u32)
    }))
}

/// The rivers of a tree on a plain rectangle, before they are shaped.
fn unshaped(recipe: &Recipe, growth: &Growth) -> Option<Shaping> {
    let pruned = prune::trim(
        growth.tree(),
        &Hydrology::of(growth.tree()),
        Trim::new(recipe.number(Key::Trim), growth.node_length(), !growth.mouths_are_chosen()),
    );
    let settings = network::NetworkSettings::new(recipe, None, growth.stream_spacing(), growth.total_discharge());
    Shaping::new(&pruned.tree, growth.may_cross(), settings).ok()
}

fn all_grown(recipe: &Recipe) -> Option<Growth> {
    let mut growth = Growth::new(GrowthSettings::of(recipe)).ok()?;
    while growth.tick() {}
    Some(growth)
}

/// Some 10,000 vertices of rivers that are halfway through their rounds, on each of several maps side by side.
fn half_meandered(maps: u32) -> Option<Meander> {
    const ATTRACTORS: &str = "9000";
    let mut recipe = recipe("meander-rounds=400")?;
    recipe.set(Key::Attractors, ATTRACTORS).ok()?;
    let growth = all_grown(&recipe)?;
    let mut shaping = unshaped(&recipe, &growth)?;
    while shaping.meander().is_none_or(|meander| meander.rounds() < 20) {
        shaping.step();
    }
    let meander = shaping.meander()?;
    Some(Meander::of(side_by_side(meander.network(), maps, meander.settings().domain.size), wide(meander, maps)))
}

/// The settings for several maps from west to east.
fn wide(meander: &Meander, maps: u32) -> network::NetworkSettings {
    let mut settings = meander.settings().clone();
    settings.domain.size.x *= maps as f32;
    settings
}

fn side_by_side(network: &Network, maps: u32, size: Vec2) -> Network {
    let mut all = Network::default();
    for map in 0..maps {
        let (east, first) = (Vec2::new(size.x * map as f32, 0.0), all.vertices.len() as u32);
        let rivers = all.rivers.len() as u32;
        let moved = |number: u32, by: u32| if number == NONE { NONE } else { number + by };
        all.vertices.extend(network.vertices.iter().map(|vertex| Vertex { at: vertex.at + east, ..*vertex }));
        all.rivers.extend(network.rivers.iter().map(|river| River {
            start: river.start + first,
            end: river.end + first,
            junction: moved(river.junction, first),
            parent: moved(river.parent, rivers),
            ..*river
        }));
    }
    all
}

/// Rounds of meandering, one after the other; the number of rivers.
fn round(maps: u32) -> Option<Repetition> {
    const ROUNDS: u32 = 12;
    let halfway = half_meandered(maps)?;
    let mut meander = halfway.clone();
    Some(Box::new(move || {
        if meander.rounds() == ROUNDS {
            meander = halfway.clone();
        }
        meander.round();
        meander.network().rivers.len() as u32
    }))
}

/// What a round has to know, by all pairs: without moving anything.
fn all_pairs() -> Option<Repetition> {
    let meander = half_meandered(1)?;
    let network = meander.network().clone();
    let reach = meander.reach(&network.downstream(), &meander.step_scale());
    Some(Box::new(move || pairs::measure(&network, &reach, meander.caps()).1.len() as u32))
}

/// A quantile, in percent, of a measure of the free bends of twenty maps, in hundredths.
fn bends_of(model: &str, measure: &str, percent: usize) -> Option<Repetition> {
    let measure = match measure {
        "wavelength" => |bend: &Bend| bend.wavelength,
        "radius" => |bend: &Bend| bend.radius,
        _ => |bend: &Bend| bend.sinuosity,
    };
    let link = format!("meander={model}&great-rivers=4&meander-rounds=60");
    let mut all: Vec<f32> = (0..20)
        .filter_map(|seed| {
            let mut session = Session::new(recipe(&format!("seed={seed}&{link}"))?).ok()?;
            session.advance(u32::MAX).ok()?;
            Some(bends::bends(session.network()?).iter().map(measure).collect::<Vec<f32>>())
        })
        .flatten()
        .collect();
    all.sort_by(f32::total_cmp);
    let value = all.get((all.len().saturating_sub(1)) * percent / 100).copied()?;
    Some(Box::new(move || (value * 100.0) as u32))
}

/// A parameter of the network or of its painting changes, on a plain map that is there already: until the finished picture.
fn late(one: &str, other: &str) -> Option<Repetition> {
    let recipes = [recipe(one)?, recipe(other)?];
    let mut session = Session::new(recipes[0].clone()).ok()?;
    let mut picture = Picture::new(SIDE, SIDE).ok()?;
    session.advance(u32::MAX).ok()?;
    picture.paint(&session);
    let mut turn = 0;
    Some(Box::new(move || {
        turn = 1 - turn;
        if session.change(recipes[turn].clone()).is_err() || session.advance(u32::MAX).is_err() {
            return 0;
        }
        picture.paint(&session);
        session.network().map_or(0, |network| network.rivers.len() as u32)
    }))
}

// ---- the relief

/// A default map with the rivers of its finished network, but for what is said.
fn map(link: &str) -> Option<Session> {
    let mut session = Session::new(link::read(link).ok()?).ok()?;
    session.finish().ok()?;
    Some(session)
}

/// The relief of a default map's finished rivers; the height of one cell, in bits.
fn relief() -> Option<Repetition> {
    let session = map("style=ink")?;
    Some(Box::new(move || {
        let Ok(relief) = session.make_relief() else { return 0 };
        relief.heights()[relief.heights().len() / 2].to_bits()
    }))
}

/// A style, after another one.
fn restyled(style: &str) -> [String; 2] {
    [if style == "atlas" { "night" } else { "atlas" }, style].map(|style| format!("style={style}"))
}

/// A map on some land that is painted in another way, in which it has been painted before; one of its pixels. The picture that it is
/// painted into is a copy, so that it is the same each time: without painting, that is all.
fn repaint(land: &str, looks: &[String; 2], paints: bool) -> Option<Repetition> {
    let [Some(before), Some(after)] = looks.each_ref().map(|look| link::read(&format!("land={land}&{look}")).ok())
    else {
        return None;
    };
    let mut session = Session::new(before.clone()).ok()?;
    session.advance(u32::MAX).ok()?;
    let mut shown = Picture::new(SIDE, SIDE).ok()?;
    for recipe in [&after, &before] {
        session.change(recipe.clone()).ok()?;
        shown.paint(&session);
    }
    Some(Box::new(move || {
        let mut picture = shown.clone();
        if [&before, &after].into_iter().any(|recipe| session.change(recipe.clone()).is_err()) {
            return 0;
        }
        if paints {
            picture.paint(&session);
        }
        picture.pixmap().data().chunks(4096).map(|row| u32::from(row[0])).sum()
    }))
}

// ---- drawing

/// A line whose radius runs from one end to the other, in pixels.
struct Segment {
    a: Vec2,
    radius_a: f32,
    b: Vec2,
    radius_b: f32,
}

/// The first hundred thousand segments of a tree, as wide as its rivers are.
fn segments() -> Option<Vec<Segment>> {
    let settings = settings(&ATTRACTORS_FOR_SEGMENTS.to_string(), "3")?;
    let growth = grown(&settings)?;
    let segments = segments_of(growth.tree(), &settings.domain)?;
    (segments.len() == SEGMENTS).then_some(segments)
}

fn segments_of(tree: &Tree, domain: &Domain) -> Option<Vec<Segment>> {
    let view = View::new(domain, SIDE, SIDE).ok()?;
    let hydrology = Hydrology::of(tree);
    let pen = Pen::new(
        view,
        Widths::ByDischarge { full: 12.0, total_discharge: hydrology.discharge[0] },
        CourseShape::Smooth,
    );
    let radius = |node: usize| f32::from(pen.radius(hydrology.depth[node], hydrology.discharge[node])) / 16.0;
    let segment = |child: usize| {
        let node = tree.parent_of(child)?;
        let (a, b) = (view.pixel(tree.at[node]), view.pixel(tree.at[child]));
        Some(Segment { a, radius_a: radius(node), b, radius_b: radius(child) })
    };
    Some((0..tree.len()).filter_map(segment).take(SEGMENTS).collect())
}

/// Our way: capsules into a coverage mask.
fn capsules() -> Option<Repetition> {
    let segments = segments()?;
    let mut coverage = Coverage::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        coverage.clear();
        segments.iter().for_each(|s| coverage.capsule(s.a, s.radius_a, s.b, s.radius_b));
        sum(coverage.mask().data())
    }))
}

/// tiny-skia's first way: a ribbon a segment, filled into a mask.
fn mask_ribbons() -> Option<Repetition> {
    let segments = segments()?;
    let mut mask = Mask::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        mask.clear();
        fill_ribbons(&segments, |path| mask.fill_path(path, FillRule::Winding, true, Transform::identity()));
        sum(mask.data())
    }))
}

/// The second: the same onto a picture.
fn ribbons() -> Option<Repetition> {
    let segments = segments()?;
    let mut pixmap = Pixmap::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        pixmap.data_mut().fill(0);
        fill_ribbons(&segments, |path| {
            pixmap.fill_path(path, &Paint::default(), FillRule::Winding, Transform::identity(), None);
        });
        sum(pixmap.data())
    }))
}

/// The third: a stroke a segment with round ends, of one width, as tiny-skia knows no other.
fn strokes() -> Option<Repetition> {
    let segments = segments()?;
    let mut pixmap = Pixmap::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        pixmap.data_mut().fill(0);
        let mut stroke = Stroke { line_cap: LineCap::Round, ..Stroke::default() };
        let mut builder = PathBuilder::new();
        for &Segment { a, radius_a, b, radius_b } in &segments {
            builder.move_to(a.x, a.y);
            builder.line_to(b.x, b.y);
            stroke.width = radius_a + radius_b;
            let Some(path) = builder.finish() else { return 0 };
            pixmap.stroke_path(&path, &Paint::default(), &stroke, Transform::identity(), None);
            builder = path.clear();
        }
        sum(pixmap.data())
    }))
}

/// Makes a path of each segment, in the memory of the one before, and fills it.
fn fill_ribbons(segments: &[Segment], mut fill: impl FnMut(&tiny_skia::Path)) {
    let mut builder = PathBuilder::new();
    for &Segment { a, radius_a, b, radius_b } in segments {
        let aside = (b - a).perp().normalize_or_zero();
        let corners = [a + aside * radius_a, b + aside * radius_b, b - aside * radius_b, a - aside * radius_a];
        builder.move_to(corners[0].x, corners[0].y);
        corners[1..].iter().for_each(|corner| builder.line_to(corner.x, corner.y));
        builder.close();
        let Some(path) = builder.finish() else { return };
        fill(&path);
        builder = path.clear();
    }
}

/// Keeps the compiler from leaving pixels out; costs little compared with drawing them.
fn sum(pixels: &[u8]) -> u32 {
    pixels.iter().map(|&pixel| u32::from(pixel)).sum()
}

// ---- whole pictures

/// A session that goes from one recipe to another and back, painting each; the number of nodes.
fn changes(one: &str, other: &str, attractors: u32, common: &str) -> Option<Repetition> {
    // What a link says twice, it says for the last time.
    let recipe = |change: &str| {
        let mut recipe = recipe(&format!("{common}&attractors={attractors}"))?;
        if let Some((name, value)) = change.split_once('=') {
            recipe.set(Key::from_name(name)?, value).ok()?;
        }
        Some(recipe)
    };
    let recipes = [recipe(one)?, recipe(other)?];
    let mut session = Session::new(recipes[0].clone()).ok()?;
    let mut picture = Picture::new(SIDE, SIDE).ok()?;
    grow(&mut session)?;
    let mut turn = 0;
    Some(Box::new(move || {
        turn = 1 - turn;
        if session.change(recipes[turn].clone()).is_err() || grow(&mut session).is_none() {
            return 0;
        }
        picture.paint(&session);
        session.tree().len() as u32
    }))
}

/// Grows the tree, of which rivers are made in the frames that follow; `None` if there is no memory for it.
fn grow(session: &mut Session) -> Option<()> {
    while session.growth().ending().is_none() {
        session.advance(1).ok()?;
    }
    Some(())
}

/// How many bytes of a picture painted while it grew differ from the picture painted at once.
fn differing_bytes() -> Option<u32> {
    const TICKS_A_FRAME: u32 = 8;
    let recipe = recipe(&format!("{BARE}&attractors={ATTRACTORS_FOR_SEGMENTS}"))?;
    let painted = |ticks: u32| {
        let mut session = Session::new(recipe.clone()).ok()?;
        let mut picture = Picture::new(SIDE, SIDE).ok()?;
        while session.growth().ending().is_none() {
            for _ in 0..ticks {
                if session.growth().ending().is_none() {
                    session.advance(1).ok()?;
                }
            }
            picture.paint(&session);
        }
        Some(picture.pixmap().data().to_vec())
    };
    let (frames, at_once) = (painted(TICKS_A_FRAME)?, painted(u32::MAX)?);
    Some(frames.iter().zip(&at_once).filter(|(a, b)| a != b).count() as u32)
}
