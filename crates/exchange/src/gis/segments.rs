//! Segments: the rivers cut at their confluences. Where rivers are lines from source to end, tributaries join them in the middle, and
//! a graph of lines knows nothing of it; segments meet at their ends alone.

use std::collections::BTreeMap;
use std::io::{Error, Result};

use riverseed::Map;
use riverseed::glam::Vec2;
use riverseed::network::{NONE, Network, River};
use riverseed::relief::{CELL_SIZE, Flow, Grid};

use crate::memory::ask;

/// The number that stands for no segment: downstream of it is the sea.
pub const SEA: u32 = 0;

/// A stretch of a river without a confluence.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// The river that it is a part of.
    pub river: u32,
    /// Its first and last place in the river's course.
    pub from: usize,
    pub to: usize,
    pub from_node: u32,
    pub to_node: u32,
    /// The segment downstream, counted from 1; [`SEA`] at a mouth.
    pub next: u32,
    pub order: u8,
    pub magnitude: u32,
    /// What it drains at its end, before anything joins it there.
    pub discharge: u32,
    /// The part of that which comes from no segment.
    pub lateral: u32,
    /// The length in units.
    pub length: f32,
    /// The area of all land whose water runs through it, in square units.
    pub area: f32,
}

/// Cuts the rivers of a map at their confluences. Each segment's number is its place in the list, counted from 1: rivers one after
/// another, each from its source.
///
/// # Errors
/// Fails if there is not enough memory.
pub fn of(map: &Map) -> Result<Vec<Segment>> {
    /// The segment that each cell's water comes to.
    const BYTES_A_CELL: usize = 32;
    /// The segments, their nodes, and the vertices of each river.
    const BYTES_A_VERTEX: usize = 200;
    let network = map.network();
    let relief = map.make_relief().map_err(Error::other)?;
    ask(relief.heights().len() * BYTES_A_CELL + network.vertices.len() * BYTES_A_VERTEX)?;
    let mut segments = cut(network);
    join(&mut segments);
    gather(&mut segments);
    let flow = Flow::new(&relief, network, &map.relief_settings()).map_err(Error::other)?;
    let cells = cells(&segments, network, &flow, &relief.grid());
    segments.iter_mut().zip(cells).for_each(|(segment, cells)| segment.area = cells as f32 * CELL_SIZE * CELL_SIZE);
    let order = downward(&segments);
    for i in order {
        let area = segments[i].area;
        if let Some(next) = downstream(&segments, i) {
            segments[next].area += area;
        }
    }
    Ok(segments)
}

/// Returns the index of the segment downstream.
fn downstream(segments: &[Segment], i: usize) -> Option<usize> {
    (segments[i].next as usize).checked_sub(1)
}

/// Returns the vertices of a river's course, the junction included.
fn course(river: &River) -> Vec<usize> {
    river.vertex_range().chain((river.junction != NONE).then_some(river.junction as usize)).collect()
}

/// Cuts rivers into segments, which do not know yet what is upstream and downstream.
fn cut(network: &Network) -> Vec<Segment> {
    let is_junction = network.junctions();
    let mut nodes = BTreeMap::new();
    let mut node = |vertex: usize| {
        let next = nodes.len() as u32 + 1;
        *nodes.entry(vertex).or_insert(next)
    };
    let mut segments = Vec::new();
    for (number, river) in (0..).zip(&network.rivers) {
        let course = course(river);
        let place = |i: usize| network.vertices[course[i]].at;
        let last = course.len().saturating_sub(1);
        let mut from = 0;
        for to in (1..=last).filter(|&to| to == last || is_junction[course[to]]) {
            // What a junction holds has come together there already.
            let end = network.vertices[course[if is_junction[course[to]] { to - 1 } else { to }]];
            segments.push(Segment {
                river: number,
                from,
                to,
                from_node: node(course[from]),
                to_node: node(course[to]),
                next: SEA,
                order: 1,
                magnitude: 1,
                discharge: end.discharge,
                lateral: end.discharge,
                length: (from..to).map(|i| place(i).distance(place(i + 1))).sum(),
                area: 0.0,
            });
            from = to;
        }
    }
    segments
}

/// Finds the segment downstream of each.
fn join(segments: &mut [Segment]) {
    let beginning: BTreeMap<u32, u32> =
        (1..).zip(&*segments).map(|(number, segment)| (segment.from_node, number)).collect();
    segments.iter_mut().for_each(|segment| segment.next = beginning.get(&segment.to_node).copied().unwrap_or(SEA));
}

/// Lists segments so that each comes before the one downstream.
fn downward(segments: &[Segment]) -> Vec<usize> {
    let mut waiting = vec![0; segments.len()];
    (0..segments.len()).filter_map(|i| downstream(segments, i)).for_each(|next| waiting[next] += 1);
    let mut order: Vec<usize> = (0..segments.len()).filter(|&i| waiting[i] == 0).collect();
    let mut done = 0;
    while let Some(&i) = order.get(done) {
        done += 1;
        if let Some(next) = downstream(segments, i) {
            waiting[next] -= 1;
            if waiting[next] == 0 {
                order.push(next);
            }
        }
    }
    order
}

/// Adds up what comes from upstream: order, magnitude, and discharge, the rest of which is lateral.
fn gather(segments: &mut [Segment]) {
    /// The greatest order of those that meet, how many have it, and the sums of magnitudes and discharges.
    #[derive(Clone, Copy, Default)]
    struct Met {
        order: u8,
        of_order: u32,
        magnitude: u32,
        discharge: u32,
    }
    let mut met = vec![Met::default(); segments.len()];
    for i in downward(segments) {
        let Met { order, of_order, magnitude, discharge } = met[i];
        let segment = &mut segments[i];
        if of_order > 0 {
            segment.order = order + u8::from(of_order > 1);
            segment.magnitude = magnitude;
        }
        segment.lateral = segment.discharge.saturating_sub(discharge);
        let Segment { order, magnitude, discharge, .. } = *segment;
        if let Some(next) = downstream(segments, i) {
            let met = &mut met[next];
            match order.cmp(&met.order) {
                std::cmp::Ordering::Greater => (met.order, met.of_order) = (order, 1),
                std::cmp::Ordering::Equal => met.of_order += 1,
                std::cmp::Ordering::Less => {}
            }
            met.magnitude += magnitude;
            met.discharge += discharge;
        }
    }
}

/// Counts the cells of land whose water comes to each segment and to none before it. Those of a basin are all in one of its segments.
fn cells(segments: &[Segment], network: &Network, flow: &Flow, grid: &Grid) -> Vec<u32> {
    let basins = network.basins();
    let near = Near::of(segments, network);
    let mut last_of = vec![None; flow.mouths.len() + 1];
    for (i, segment) in segments.iter().enumerate().filter(|(_, segment)| segment.next == SEA) {
        last_of[basins[segment.river as usize] as usize] = Some(i);
    }
    // The segment that the water of each cell comes to first.
    let mut first: Vec<Option<Option<usize>>> = vec![None; flow.basins.len()];
    let own = |cell: usize| {
        let river = flow.rivers[cell];
        let is_own = river != NONE && basins[river as usize] == flow.basins[cell];
        is_own.then(|| near.segment(river, middle(grid, cell))).flatten()
    };
    let mut counts = vec![0; segments.len()];
    let mut waiting = Vec::new();
    for start in (0..first.len()).filter(|&cell| flow.basins[cell] > 0) {
        let mut cell = start;
        let found = loop {
            if let Some(found) = first[cell] {
                break found;
            }
            waiting.push(cell);
            if let Some(found) = own(cell) {
                break Some(found);
            }
            match flow.next(grid, cell).filter(|&next| flow.basins[next] == flow.basins[cell]) {
                Some(next) => cell = next,
                None => break last_of[flow.basins[cell] as usize],
            }
        };
        waiting.drain(..).for_each(|cell| first[cell] = Some(found));
        if let Some(found) = found {
            counts[found] += 1;
        }
    }
    counts
}

/// Returns the middle of a cell, in units.
fn middle(grid: &Grid, cell: usize) -> Vec2 {
    Vec2::new((cell % grid.columns) as f32 + 0.5, (cell / grid.columns) as f32 + 0.5) * grid.cell_size
}

/// The vertices of each river with their segments.
struct Near(Vec<Vec<(Vec2, usize)>>);

impl Near {
    fn of(segments: &[Segment], network: &Network) -> Self {
        let mut near = vec![Vec::new(); network.rivers.len()];
        for (i, segment) in segments.iter().enumerate() {
            let course = course(&network.rivers[segment.river as usize]);
            // A confluence is where the next one begins.
            let vertices = course[segment.from..segment.to].iter().map(|&vertex| (network.vertices[vertex].at, i));
            near[segment.river as usize].extend(vertices);
        }
        Self(near)
    }

    /// Finds the segment of a river that lies nearest to a place.
    fn segment(&self, river: u32, at: Vec2) -> Option<usize> {
        let far = |(vertex, _): &&(Vec2, usize)| vertex.distance_squared(at);
        let nearest = self.0[river as usize].iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        nearest.map(|(_, segment)| *segment)
    }
}
