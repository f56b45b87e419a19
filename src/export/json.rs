//! The JSON form of a network (design: one data form). Columns, full precision, stable names; the README explains them.

use std::io::Write;

use serde::Serialize;

use crate::grow::{Procedure, scatter};
use crate::prune::Pruned;
use crate::recipe::{self, Key};
use crate::session::Session;

#[derive(Serialize)]
struct Network {
    recipe: serde_json::Value,
    resolved: Resolved,
    domain: Size,
    growth: Growth,
    nodes: Nodes,
    #[serde(skip_serializing_if = "Option::is_none")]
    attractors: Option<Columns>,
}

/// The values used, lengths in domain units.
#[derive(Serialize)]
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
    parent: Vec<i64>,
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

/// Writes the network of a session that has finished growing, with its attractors if asked for.
///
/// # Errors
/// Those of the writer.
pub fn write(out: impl Write, session: &Session, with_attractors: bool) -> serde_json::Result<()> {
    let parameters = session.growth().parameters();
    let summary = session.summary();
    let recipe = session.recipe();
    let network = Network {
        recipe: recipe::json::to_json(recipe),
        resolved: Resolved {
            spacing: parameters.spacing,
            reach: parameters.reach,
            kill: parameters.kill,
            step: parameters.step,
            momentum: parameters.momentum,
            curl: parameters.curl,
            stretch: parameters.stretch,
            sensitivity: parameters.sensitivity,
            trim: recipe.integer(Key::Trim),
            width: recipe.number(Key::Width),
        },
        domain: Size { width: parameters.domain.size.x, height: parameters.domain.size.y },
        growth: Growth {
            ticks: summary.ticks,
            attractors: summary.attractors,
            unreached: summary.unreached,
            complete: summary.ending == Some(crate::grow::Ending::Complete),
        },
        nodes: nodes(session.pruned()),
        attractors: with_attractors.then(|| match parameters.procedure {
            Procedure::Colonize => scatter(parameters).into_iter().collect(),
            Procedure::Brownian => Columns::from_iter([]),
        }),
    };
    serde_json::to_writer(out, &network)
}

fn nodes(Pruned { tree, hydrology, .. }: Pruned) -> Nodes {
    Nodes {
        tick: tree.ticks().collect(),
        parent: (0..tree.len()).map(|node| tree.parent_of(node).map_or(-1, |parent| parent as i64)).collect(),
        at: tree.at.into_iter().collect(),
        depth: hydrology.depth,
        order: hydrology.order,
        magnitude: hydrology.magnitude,
        discharge: hydrology.discharge,
    }
}
