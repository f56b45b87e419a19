//! The JSON form of a network: columns, full precision, stable names. `docs/files.md` explains them.

use glam::Vec2;

use super::data::{Json, Members};
use super::names;
use super::{ExportError, names_of, rivers};
use crate::grow::Ending;
use crate::measure::{self, Measures};
use crate::name::Names;
use crate::network::{NONE, Network, Vertex};
use crate::prune::Pruned;
use crate::recipe::table::TABLE;
use crate::recipe::{self, Key, Recipe, Stage};
use crate::session::Session;
use crate::tree::NO_PARENT;

/// The network of a session as it is, ready to be written, with its attractors if asked for.
///
/// # Errors
/// If there are no rivers yet, or there is not enough memory.
pub fn network(session: &Session, with_attractors: bool) -> Result<Json<'_>, ExportError> {
    compose(session, with_attractors, Some(names_of(session)))
}

/// The same without names and what they are made of, which no digest is of.
pub(crate) fn unnamed(session: &Session, with_attractors: bool) -> Result<Json<'_>, ExportError> {
    compose(session, with_attractors, None)
}

/// The same with names that were made elsewhere; without, what they are made of is left out, too.
///
/// # Errors
/// As [`json`].
#[inline(never)] // one copy is enough
pub fn compose(session: &Session, with_attractors: bool, names: Option<Names>) -> Result<Json<'_>, ExportError> {
    /// Of the nodes' columns, about two nodes a vertex.
    const BYTES_A_VERTEX: usize = 64;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let mut domain = Members::default();
    domain.single("width", session.domain().size.x).single("height", session.domain().size.y);
    let mut form = Members::default();
    let is_named = names.is_some();
    let named_rivers = names.as_ref().map_or_else(Vec::new, |names| names.rivers.clone());
    let river = move |i: usize| {
        let mut members = river(network, i as u32);
        if is_named {
            members.whole("identity", network.rivers[i].identity);
        }
        names::river(&mut members, named_rivers.get(i));
        members.value("points", points(course(network, i)));
        Json::from(members)
    };
    form.value("recipe", values(session.recipe(), is_named))
        .object("resolved", resolved(session))
        .object("domain", domain)
        .object("growth", growth(session))
        .value("measures", Measures::of(session).as_ref().map_or(Json::Null, measures))
        .object("nodes", nodes(session.pruned()))
        .value("rivers", Json::list(network.rivers.len(), river))
        .value("oxbows", Json::list(network.oxbows.len(), |i| oxbow(network, i as u32)));
    if let Some(names) = names {
        form.value("names", names::list(names));
    }
    if with_attractors {
        form.object("attractors", columns(&session.growth().scattered()));
    }
    Ok(form.into())
}

/// Writes the network of a session, with its attractors if asked for.
///
/// # Errors
/// If there are no rivers yet, or there is not enough memory; and those of the writer.
#[cfg(feature = "json")]
pub fn write(out: impl std::io::Write, session: &Session, with_attractors: bool) -> std::io::Result<()> {
    let network = network(session, with_attractors).map_err(std::io::Error::other)?;
    Ok(serde_json::to_writer(out, &network)?)
}

/// All values of a recipe, defaults too: so that the recipe keeps its meaning when a default changes. Numbers are numbers,
/// everything else is text.
pub fn recipe<'a>(recipe: &Recipe) -> Json<'a> {
    values(recipe, true)
}

fn values<'a>(recipe: &Recipe, is_named: bool) -> Json<'a> {
    let mut members = Members::default();
    for parameter in TABLE.iter().filter(|parameter| is_named || parameter.stage != Stage::Name) {
        match recipe.value(parameter.key) {
            recipe::Value::Integer(number) => members.whole(parameter.name, *number),
            recipe::Value::Number(number) => members.double(parameter.name, number.to_f64()),
            other => members.owned(parameter.name, parameter.text_of(other)),
        };
    }
    members.into()
}

/// The values used, lengths in domain units.
fn resolved<'a>(session: &Session) -> Members<'a> {
    let grown = session.growth().settings();
    let shaped = session.network_settings();
    let mut members = Members::default();
    members
        .single("spacing", grown.spacing)
        .single("reach", grown.reach)
        .single("kill", grown.kill)
        .single("step", grown.step)
        .single("momentum", grown.momentum)
        .single("curl", grown.curl)
        .whole("stretch", grown.stretch)
        .single("sensitivity", grown.sensitivity)
        .single("trim", session.recipe().number(Key::Trim))
        .whole("trim-nodes", session.trim().nodes)
        .single("width", shaped.max_width)
        .whole("total-discharge", shaped.total_discharge)
        .single("vertex-spacing", shaped.spacing)
        .single("simplify", shaped.simplify)
        .single("bank-variation", shaped.bank_variation)
        .owned("meander", Key::Meander.parameter().text_of(session.recipe().value(Key::Meander)))
        .whole("meander-rounds", shaped.rounds)
        .single("meander-strength", shaped.strength)
        .single("meander-mix", shaped.mix)
        .single("meander-elsewhere", shaped.meander_elsewhere)
        .whole("great-rivers", shaped.great_rivers)
        .single("flat-share", shaped.flat_share)
        .single("neck", shaped.neck)
        .single("clearance", shaped.min_clearance)
        .single("taper", shaped.taper);
    members
}

fn growth<'a>(session: &Session) -> Members<'a> {
    let summary = session.summary();
    let mut members = Members::default();
    members
        .whole("ticks", summary.ticks)
        .whole("attractors", summary.attractors)
        .whole("unreached", summary.unreached)
        .value("complete", Json::Truth(summary.ending == Some(Ending::Complete)));
    members
}

/// What is measured of a network, by the names of the table of measures; null where it is too small.
pub fn measures<'a>(measured: &Measures) -> Json<'a> {
    let mut members = Members::default();
    for measure in &measure::TABLE {
        members.value(measure.name, (measure.value)(measured).map_or(Json::Null, Json::Double));
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
        .value("points", points(line.collect()));
    members.into()
}

/// x, y and a share of the width.
fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}

#[inline(never)]
fn points<'a>(points: Vec<[f32; 3]>) -> Json<'a> {
    Json::list(points.len(), move |i| Json::singles(points[i].to_vec()))
}
