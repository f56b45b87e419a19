//! The JSON form of a network (design: one data form). Columns, full precision, stable names; the README explains them.

use serde::{Serialize, Serializer};

use super::{ExportError, rivers};
use crate::grow::{Ending, Procedure, scatter};
use crate::network::{self, NONE, Network, Oxbow, River, Vertex};
use crate::prune::Pruned;
use crate::recipe::{Key, Recipe};
use crate::session::Session;

#[derive(Serialize)]
struct Form<'a> {
    recipe: &'a Recipe,
    resolved: Resolved,
    domain: Size,
    growth: Growth,
    nodes: Nodes,
    rivers: Rivers<'a>,
    oxbows: Oxbows<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    attractors: Option<Columns>,
}

/// The values used, lengths in domain units.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
struct Resolved {
    spacing: f32,
    reach: f32,
    kill: f32,
    step: f32,
    momentum: f32,
    curl: f32,
    stretch: u32,
    sensitivity: f32,
    trim: u32,
    width: f32,
    everything: u32,
    vertex_spacing: f32,
    simplify: f32,
    vary: f32,
    meander: String,
    meander_rounds: u32,
    meander_strength: f32,
    meander_mix: f32,
    gentle: f32,
    great: u32,
    flat: f32,
    neck: f32,
    buffer: f32,
    taper: f32,
}

#[derive(Serialize)]
struct Size {
    width: f32,
    height: f32,
}

#[derive(Serialize)]
struct Growth {
    ticks: u32,
    attractors: u32,
    unreached: u32,
    complete: bool,
}

#[derive(Serialize)]
struct Columns {
    x: Vec<f32>,
    y: Vec<f32>,
}

#[derive(Serialize)]
struct Nodes {
    #[serde(flatten)]
    at: Columns,
    parent: Vec<i32>,
    tick: Vec<u32>,
    depth: Vec<u32>,
    order: Vec<u8>,
    magnitude: Vec<u32>,
    discharge: Vec<u32>,
}

impl FromIterator<glam::Vec2> for Columns {
    fn from_iter<I: IntoIterator<Item = glam::Vec2>>(points: I) -> Self {
        let (x, y) = points.into_iter().map(|point| (point.x, point.y)).unzip();
        Self { x, y }
    }
}

/// Rivers, made one by one as they are written.
struct Rivers<'a>(&'a Network);

#[derive(Serialize)]
struct RiverForm {
    id: u32,
    parent: Option<u32>,
    order: u8,
    magnitude: u32,
    discharge: u32,
    /// x, y, width.
    points: Vec<[f32; 3]>,
}

struct Oxbows<'a>(&'a [Oxbow]);

#[derive(Serialize)]
struct OxbowForm {
    id: u32,
    river: u32,
    born: u32,
    points: Vec<[f32; 3]>,
}

impl Serialize for Rivers<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let form = |(id, river): (u32, &River)| RiverForm {
            id,
            parent: (river.parent != NONE).then_some(river.parent),
            order: river.order,
            magnitude: river.magnitude,
            discharge: self.0.discharge(river),
            points: self.0.course(river).map(|vertex| point(vertex, 1.0)).collect(),
        };
        serializer.collect_seq((0..).zip(&self.0.rivers).map(form))
    }
}

impl Serialize for Oxbows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let form = |(id, oxbow): (u32, &Oxbow)| OxbowForm {
            id,
            river: oxbow.river,
            born: oxbow.born,
            points: oxbow.vertices.iter().zip(oxbow.shares()).map(|(vertex, share)| point(vertex, share)).collect(),
        };
        serializer.collect_seq((0..).zip(self.0).map(form))
    }
}

fn point(vertex: &Vertex, share: f32) -> [f32; 3] {
    [vertex.at.x, vertex.at.y, vertex.width() * share]
}

/// The network of a session as it is, ready to be written, with its attractors if asked for.
///
/// # Errors
/// If there are no rivers yet, or the memory is not to be had.
pub fn network(session: &Session, with_attractors: bool) -> Result<impl Serialize + '_, ExportError> {
    /// Of the nodes' columns, about two nodes a vertex.
    const BYTES_A_VERTEX: usize = 64;
    let rivers_and_oxbows = rivers(session, BYTES_A_VERTEX)?;
    let parameters = session.growth().parameters();
    let summary = session.summary();
    Ok(Form {
        recipe: session.recipe(),
        resolved: resolved(session),
        domain: Size { width: parameters.domain.size.x, height: parameters.domain.size.y },
        growth: Growth {
            ticks: summary.ticks,
            attractors: summary.attractors,
            unreached: summary.unreached,
            complete: summary.ending == Some(Ending::Complete),
        },
        nodes: nodes(session.pruned()),
        rivers: Rivers(rivers_and_oxbows),
        oxbows: Oxbows(&rivers_and_oxbows.oxbows),
        attractors: with_attractors.then(|| match parameters.procedure {
            Procedure::Colonize => scatter(parameters).into_iter().collect(),
            Procedure::Brownian => Columns::from_iter([]),
        }),
    })
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

fn resolved(session: &Session) -> Resolved {
    let (recipe, grown) = (session.recipe(), session.growth().parameters());
    let shaped: network::Parameters = session.network_parameters();
    Resolved {
        spacing: grown.spacing,
        reach: grown.reach,
        kill: grown.kill,
        step: grown.step,
        momentum: grown.momentum,
        curl: grown.curl,
        stretch: grown.stretch,
        sensitivity: grown.sensitivity,
        trim: recipe.integer(Key::Trim),
        width: shaped.full_width,
        everything: shaped.everything,
        vertex_spacing: shaped.spacing,
        simplify: shaped.simplify,
        vary: shaped.vary,
        meander: Key::Meander.parameter().text_of(recipe.value(Key::Meander)),
        meander_rounds: shaped.rounds,
        meander_strength: shaped.strength,
        meander_mix: shaped.mix,
        gentle: shaped.gentle,
        great: shaped.great,
        flat: shaped.flat,
        neck: shaped.neck,
        buffer: shaped.buffer,
        taper: shaped.taper,
    }
}

fn nodes(Pruned { tree, hydrology, .. }: Pruned) -> Nodes {
    Nodes {
        tick: tree.ticks().collect(),
        parent: (0..tree.len()).map(|node| tree.parent_of(node).map_or(-1, |parent| parent as i32)).collect(),
        at: tree.at.into_iter().collect(),
        depth: hydrology.depth,
        order: hydrology.order,
        magnitude: hydrology.magnitude,
        discharge: hydrology.discharge,
    }
}
