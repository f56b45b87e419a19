//! The JSON form of a network (design: one data form). Columns, full precision, stable names; the README explains them.

use glam::Vec2;

use super::value::Value;
use super::{ExportError, rivers};
use crate::grow::{Ending, Procedure, scatter};
use crate::network::{NONE, Network, Vertex};
use crate::prune::Pruned;
use crate::recipe::table::TABLE;
use crate::recipe::{self, Key, Recipe};
use crate::session::Session;

/// Names and values.
type Members<'a> = Vec<(&'static str, Value<'a>)>;

/// The network of a session as it is, ready to be written, with its attractors if asked for.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had.
pub fn network(session: &Session, with_attractors: bool) -> Result<Value<'_>, ExportError> {
    /// Of the nodes' columns, about two nodes a vertex.
    const BYTES_A_VERTEX: usize = 64;
    let network = rivers(session, BYTES_A_VERTEX)?;
    let parameters = session.growth().parameters();
    let [width, height] = parameters.domain.size.to_array().map(Value::Single);
    let mut form = vec![
        ("recipe", recipe(session.recipe())),
        ("resolved", Value::Object(resolved(session))),
        ("domain", Value::Object(vec![("width", width), ("height", height)])),
        ("growth", Value::Object(growth(session))),
        ("nodes", Value::Object(nodes(session.pruned()))),
        ("rivers", Value::list(network.rivers.len(), |i| river(network, i))),
        ("oxbows", Value::list(network.oxbows.len(), |i| oxbow(network, i))),
    ];
    if with_attractors {
        let attractors = match parameters.procedure {
            Procedure::Colonize => scatter(parameters),
            Procedure::Brownian => Vec::new(),
        };
        form.push(("attractors", Value::Object(columns(&attractors))));
    }
    Ok(Value::Object(form))
}

/// Writes the network of a session, with its attractors if asked for.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had; and those of the writer.
#[cfg(feature = "json")]
pub fn write(out: impl std::io::Write, session: &Session, with_attractors: bool) -> std::io::Result<()> {
    let network = network(session, with_attractors).map_err(std::io::Error::other)?;
    Ok(serde_json::to_writer(out, &network)?)
}

/// All values of a recipe, defaults too: such a recipe stays readable when a default is chosen anew. Numbers are numbers,
/// everything else is text.
pub fn recipe<'a>(recipe: &Recipe) -> Value<'a> {
    let member = |parameter: &recipe::Parameter| {
        let value = match recipe.value(parameter.key) {
            recipe::Value::Integer(number) => Value::whole(*number),
            recipe::Value::Number(number) => Value::Double(number.to_f64()),
            other => Value::Owned(parameter.text_of(other)),
        };
        (parameter.name, value)
    };
    Value::Object(TABLE.iter().map(member).collect())
}

/// The values used, lengths in domain units.
fn resolved<'a>(session: &Session) -> Members<'a> {
    let grown = session.growth().parameters();
    let shaped = session.network_parameters();
    let numbers = [
        ("spacing", grown.spacing),
        ("reach", grown.reach),
        ("kill", grown.kill),
        ("step", grown.step),
        ("momentum", grown.momentum),
        ("curl", grown.curl),
        ("sensitivity", grown.sensitivity),
        ("width", shaped.full_width),
        ("vertex-spacing", shaped.spacing),
        ("simplify", shaped.simplify),
        ("vary", shaped.vary),
        ("meander-strength", shaped.strength),
        ("meander-mix", shaped.mix),
        ("gentle", shaped.gentle),
        ("flat", shaped.flat),
        ("neck", shaped.neck),
        ("buffer", shaped.buffer),
        ("taper", shaped.taper),
    ];
    let wholes = [
        ("stretch", grown.stretch),
        ("trim", session.recipe().integer(Key::Trim)),
        ("everything", shaped.everything),
        ("meander-rounds", shaped.rounds),
        ("great", shaped.great),
    ];
    let meander = Key::Meander.parameter().text_of(session.recipe().value(Key::Meander));
    let numbers = numbers.into_iter().map(|(name, number)| (name, Value::Single(number)));
    let wholes = wholes.into_iter().map(|(name, number)| (name, Value::whole(number)));
    numbers.chain(wholes).chain([("meander", Value::Owned(meander))]).collect()
}

fn growth<'a>(session: &Session) -> Members<'a> {
    let summary = session.summary();
    vec![
        ("ticks", Value::whole(summary.ticks)),
        ("attractors", Value::whole(summary.attractors)),
        ("unreached", Value::whole(summary.unreached)),
        ("complete", Value::Truth(summary.ending == Some(Ending::Complete))),
    ]
}

fn columns<'a>(points: &[Vec2]) -> Members<'a> {
    let column = |axis: usize| Value::singles(points.iter().map(|point| point[axis]).collect());
    vec![("x", column(0)), ("y", column(1))]
}

fn nodes<'a>(Pruned { tree, hydrology, .. }: Pruned) -> Members<'a> {
    let mut nodes = columns(&tree.at);
    let tick = tree.ticks().collect();
    let parent = move |node: usize| Value::Whole(tree.parent_of(node).map_or(-1, |parent| parent as i64));
    nodes.extend([
        ("parent", Value::list(hydrology.depth.len(), parent)),
        ("tick", Value::wholes(tick)),
        ("depth", Value::wholes(hydrology.depth)),
        ("order", Value::wholes(hydrology.order.into_iter().map(u32::from).collect())),
        ("magnitude", Value::wholes(hydrology.magnitude)),
        ("discharge", Value::wholes(hydrology.discharge)),
    ]);
    nodes
}

fn river<'a>(network: &Network, id: usize) -> Value<'a> {
    let river = &network.rivers[id];
    Value::Object(vec![
        ("id", Value::Whole(id as i64)),
        ("parent", Value::unless(river.parent, NONE)),
        ("order", Value::whole(river.order.into())),
        ("magnitude", Value::whole(river.magnitude)),
        ("discharge", Value::whole(network.discharge(river))),
        ("points", points(network.course(river).map(|vertex| point(vertex, 1.0)).collect())),
    ])
}

fn oxbow<'a>(network: &Network, id: usize) -> Value<'a> {
    let oxbow = &network.oxbows[id];
    let lake = oxbow.lake();
    let points_of = lake.iter().map(|(vertex, share)| point(vertex, *share));
    Value::Object(vec![
        ("id", Value::Whole(id as i64)),
        ("river", Value::whole(oxbow.river)),
        ("born", Value::whole(oxbow.born)),
        ("points", points(points_of.collect())),
    ])
}

/// x, y and so much of the width.
fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}

fn points<'a>(points: Vec<[f32; 3]>) -> Value<'a> {
    Value::list(points.len(), move |i| Value::singles(points[i].to_vec()))
}
