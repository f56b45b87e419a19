//! A network as JSON: columns, full precision, stable names. `docs/files.md` explains them.

use glam::Vec2;

use super::data::{Json, Members};
use super::{ExportError, names, rivers, waters};
use crate::analyse::statistics::{self, Measures};
use crate::annotate::names::Names;
use crate::grow::Ending;
use crate::map::Map;
use crate::network::{NONE, Network, Vertex};
use crate::prune::Pruned;
use crate::recipe::table::TABLE;
use crate::recipe::{self, IntegerKey, Key, NumberKey, Parameter, Recipe, Stage, is_decided};
use crate::tree::NO_PARENT;

/// Makes the JSON of a map's network, ready to be written. It includes the attractors that the tree grew to if they are
/// given ([`Growth::scattered`](crate::grow::Growth::scattered)).
///
/// # Errors
/// Fails if there is not enough memory.
pub fn network<'a>(map: &'a Map, attractors: Option<&[Vec2]>) -> Result<Json<'a>, ExportError> {
    compose(map, attractors, Some(Names::of(map)))
}

/// Makes the JSON without names and the values that they depend on; digests of maps without names use it.
pub(crate) fn unnamed<'a>(map: &'a Map, attractors: Option<&[Vec2]>) -> Result<Json<'a>, ExportError> {
    compose(map, attractors, None)
}

/// Makes the JSON with these names. Without names, the values that they depend on are left out, too.
#[inline(never)] // one copy is enough
fn compose<'a>(map: &'a Map, attractors: Option<&[Vec2]>, names: Option<Names>) -> Result<Json<'a>, ExportError> {
    /// For the columns of the nodes, about two nodes per vertex.
    const BYTES_A_VERTEX: usize = 64;
    let network = rivers(map, BYTES_A_VERTEX)?;
    let mut domain = Members::default();
    domain.single("width", map.domain().size.x).single("height", map.domain().size.y);
    let mut form = Members::default();
    let is_named = names.is_some();
    let named_rivers = names.as_ref().map_or_else(Vec::new, |names| names.rivers.clone());
    let river = move |i: usize| {
        let mut members = river(network, i as u32);
        names::identity(&mut members, named_rivers.get(i));
        names::river(&mut members, named_rivers.get(i));
        waters::passages(&mut members, map, i);
        members.value("points", Json::points(course(network, i)));
        Json::from(members)
    };
    let (measured, deltas) = (Measures::of(map), map.deltas());
    let named_places = names.as_ref().map_or_else(Vec::new, |names| names.places.clone());
    form.value("recipe", values(map.recipe(), is_named))
        .object("resolved", resolved(map))
        .object("domain", domain)
        .object("growth", growth(map))
        .value("measures", measures(&measured))
        .value("pattern", pattern(&measured))
        .object("nodes", nodes(map.pruned()))
        .value("rivers", Json::list(network.rivers.len(), river))
        .value("oxbows", Json::list(network.oxbows.len(), |i| oxbow(network, i as u32)))
        .value("lakes", Json::list(map.lakes().list.len(), move |i| waters::lake(map, i, &named_places)))
        .value(
            "distributaries",
            Json::list(deltas.distributaries.len(), |i| waters::distributary(&deltas.distributaries[i])),
        )
        .value("deltas", Json::list(deltas.list.len(), |i| waters::delta(&deltas.list[i])));
    if let Some(names) = names {
        form.value("names", names::list(names));
    }
    if let Some(attractors) = attractors {
        form.object("attractors", columns(attractors));
    }
    Ok(form.into())
}

/// Writes the network of a map, with the attractors that the tree grew to if they are given.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
#[cfg(feature = "json")]
pub fn write(out: impl std::io::Write, map: &Map, attractors: Option<&[Vec2]>) -> std::io::Result<()> {
    let network = network(map, attractors).map_err(std::io::Error::other)?;
    Ok(serde_json::to_writer(out, &network)?)
}

/// Writes a recipe as JSON: all values but those that the country decides, so that the recipe keeps its meaning if a default
/// changes. Numbers are numbers, everything else is text.
pub fn recipe<'a>(recipe: &Recipe) -> Json<'a> {
    values(recipe, true)
}

fn values<'a>(recipe: &Recipe, is_named: bool) -> Json<'a> {
    let mut members = Members::default();
    let is_written = |parameter: &Parameter| !is_decided(parameter.key) || recipe.is_named(parameter.key);
    for parameter in TABLE.iter().filter(|parameter| is_named || parameter.stage != Stage::Name) {
        if is_written(parameter) {
            value(&mut members, recipe, parameter);
        }
    }
    members.into()
}

fn value(members: &mut Members, recipe: &Recipe, parameter: &Parameter) {
    match recipe.value(parameter.key) {
        recipe::Value::Integer(number) => members.whole(parameter.name, *number),
        recipe::Value::Number(number) => members.double(parameter.name, number.to_f64()),
        other => members.owned(parameter.name, parameter.text_of(other)),
    };
}

/// Writes the values that a map was made with as JSON, with lengths in domain units.
fn resolved<'a>(map: &Map) -> Members<'a> {
    let (recipe, grown, shaped) = (map.recipe(), map.grown(), map.network_settings());
    let mut members = Members::default();
    members
        .single("sea", recipe.sea())
        .single("spacing", grown.spacing)
        .single("reach", grown.reach)
        .single("kill", grown.kill)
        .single("step", grown.step)
        .single("momentum", recipe.number(NumberKey::Momentum))
        .single("curl", recipe.number(NumberKey::Curl))
        .whole("stretch", recipe.integer(IntegerKey::Stretch))
        .single("sensitivity", recipe.integer(IntegerKey::Sensitivity) as f32)
        .single("trim", recipe.number(NumberKey::Trim))
        .whole("trim-nodes", map.trim().nodes)
        .single("width", shaped.max_width)
        .whole("total-discharge", shaped.total_discharge)
        .single("vertex-spacing", shaped.spacing)
        .single("simplify", shaped.simplify)
        .single("bank-variation", shaped.bank_variation)
        .owned("meander", Key::Meander.parameter().text_of(recipe.value(Key::Meander)))
        .whole("meander-rounds", shaped.rounds)
        .single("meander-strength", shaped.strength)
        .single("meander-mix", shaped.mix)
        .single("meander-elsewhere", shaped.meander_elsewhere)
        .whole("great-rivers", shaped.great_rivers)
        .single("flat-share", shaped.flat_share)
        .single("neck", shaped.neck)
        .single("clearance", shaped.min_clearance)
        .single("taper", shaped.taper)
        .text("country", recipe.country());
    for parameter in TABLE.iter().filter(|parameter| is_decided(parameter.key)) {
        if !members.holds(parameter.name) {
            value(&mut members, recipe, parameter);
        }
    }
    members
}

fn growth<'a>(map: &Map) -> Members<'a> {
    let grown = map.grown();
    let mut members = Members::default();
    members
        .whole("ticks", (map.tree().tick_starts.len() as u32).saturating_sub(1))
        .whole("attractors", grown.attractors)
        .whole("unreached", grown.unreached)
        .value("complete", Json::Truth(grown.ending == Ending::Complete));
    members
}

/// Writes the measures of a network as JSON, by their names in the table of measures; null if the network is too small.
pub fn measures<'a>(measured: &Measures) -> Json<'a> {
    let mut members = Members::default();
    for measure in &statistics::TABLE {
        members.value(measure.name, (measure.value)(measured).map_or(Json::Null, Json::Double));
    }
    members.into()
}

/// Writes a network's distances from the patterns of drainage as JSON, nearest first; null if it is too small.
pub fn pattern<'a>(measured: &Measures) -> Json<'a> {
    let Some(pattern) = measured.pattern() else { return Json::Null };
    let mut members = Members::default();
    for (name, distance) in pattern.nearest_first() {
        members.value(name, Json::Double(distance));
    }
    members.into()
}

fn columns<'a>(points: &[Vec2]) -> Members<'a> {
    let mut members = Members::default();
    members
        .value("x", Json::singles(points.iter().map(|point| point.x).collect()))
        .value("y", Json::singles(points.iter().map(|point| point.y).collect()));
    members
}

fn nodes<'a>(Pruned { tree, hydrology, .. }: Pruned) -> Members<'a> {
    let mut members = columns(&tree.at);
    let count = tree.len();
    let parent = tree.parent;
    let starts = tree.tick_starts;
    members
        .value(
            "parent",
            Json::list(count, move |node| {
                Json::Whole(if parent[node] == NO_PARENT { -1 } else { parent[node].into() })
            }),
        )
        // The last tick that starts with the node or before it.
        .value(
            "tick",
            Json::list(count, move |node| {
                Json::Whole(starts.partition_point(|&start| start as usize <= node) as i64 - 1)
            }),
        )
        .value("depth", Json::wholes(hydrology.depth))
        .value("order", Json::list(count, move |node| Json::Whole(hydrology.order[node].into())))
        .value("magnitude", Json::wholes(hydrology.magnitude))
        .value("discharge", Json::wholes(hydrology.discharge));
    members
}

fn river<'a>(network: &Network, id: u32) -> Members<'a> {
    let river = &network.rivers[id as usize];
    let mut members = Members::default();
    members
        .whole("id", id)
        .unless("parent", river.parent, NONE)
        .whole("order", river.order.into())
        .whole("magnitude", river.magnitude)
        .whole("discharge", network.discharge(river));
    members
}

fn course(network: &Network, id: usize) -> Vec<[f32; 3]> {
    network.course(&network.rivers[id]).map(|vertex| point(vertex, 1.0)).collect()
}

fn oxbow<'a>(network: &Network, id: u32) -> Json<'a> {
    let oxbow = &network.oxbows[id as usize];
    let lake = oxbow.lake();
    let line = lake.iter().map(|(vertex, share)| point(vertex, *share));
    let mut members = Members::default();
    members
        .whole("id", id)
        .whole("river", oxbow.river)
        .whole("born", oxbow.born)
        .value("points", Json::points(line.collect()));
    members.into()
}

/// Returns the coordinates of a vertex, and a share of its width.
fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}
