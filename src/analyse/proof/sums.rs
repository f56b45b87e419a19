//! Discharge adds up: what rivers carry, their magnitudes and their orders are those of a count from the sources down.

use super::{Breach, Fault, Finding, Promise};
use crate::network::{NONE, Network, River};

/// The promise that rivers carry what flows into them, and that their orders and magnitudes are those of what they take in.
pub const SUMS: Promise = Promise { name: "adds-up", says: "Discharge adds up", counted: "vertices" };

/// Finds the vertices whose discharge is less than that of all vertices right above them, and the rivers whose order
/// (Strahler 1957) or magnitude (Shreve 1966) at their end is another than a count vertex by vertex finds.
pub fn sums(network: &Network) -> Finding {
    let downstream = network.downstream();
    let (inflows, ranks) = (inflows(network, &downstream), ranks(&downstream));
    let mut breaches = Vec::new();
    for (number, river) in (0..).zip(&network.rivers) {
        let breach = |(at, fault): (usize, Fault)| Breach { river: number, at: network.vertices[at].at, fault };
        let loses = river.vertex_range().filter_map(|at| Some((at, loss(network, &inflows, at)?)));
        let end = (river.end as usize).max(1) - 1;
        let ends = miscounts(river, ranks.get(end).copied().unwrap_or_default()).map(|fault| (end, fault));
        breaches.extend(loses.chain(ends).map(breach));
    }
    Finding { promise: SUMS, looked_at: network.vertices.len(), breaches }
}

fn loss(network: &Network, inflows: &[u64], at: usize) -> Option<Fault> {
    let (discharge, inflow) = (network.vertices[at].discharge, inflows[at]);
    (u64::from(discharge) < inflow).then_some(Fault::Carries { discharge, inflow })
}

/// Lists what is wrong with a river's order and magnitude.
fn miscounts(river: &River, counted: Rank) -> impl Iterator<Item = Fault> {
    let order = Fault::Order { has: river.order, counted: counted.order };
    let magnitude = Fault::Magnitude { has: river.magnitude, counted: counted.magnitude };
    let order = (river.order != counted.order).then_some(order);
    order.into_iter().chain((river.magnitude != counted.magnitude).then_some(magnitude))
}

/// Sums up, for each vertex, the discharges of the vertices right above it.
fn inflows(network: &Network, downstream: &[u32]) -> Vec<u64> {
    let mut inflows = vec![0; downstream.len()];
    for (vertex, &below) in network.vertices.iter().zip(downstream) {
        if let Some(inflow) = inflows.get_mut(below as usize) {
            *inflow += u64::from(vertex.discharge);
        }
    }
    inflows
}

/// The order and the magnitude at a vertex.
#[derive(Clone, Copy, Default)]
struct Rank {
    order: u8,
    magnitude: u32,
}

/// Counts order and magnitude of each vertex, from the sources down. Vertices on a way that runs in a circle keep 0.
fn ranks(downstream: &[u32]) -> Vec<Rank> {
    let mut awaited = vec![0u32; downstream.len()];
    downstream.iter().filter(|below| **below != NONE).for_each(|&below| awaited[below as usize] += 1);
    let mut ready: Vec<usize> = (0..downstream.len()).filter(|&vertex| awaited[vertex] == 0).collect();
    let mut ranks = vec![Rank::default(); downstream.len()];
    ready.iter().for_each(|&source| ranks[source] = Rank { order: 1, magnitude: 1 });
    // The highest order above each vertex, and whether two have it.
    let mut is_shared = vec![false; downstream.len()];
    while let Some(vertex) = ready.pop() {
        ranks[vertex].order += u8::from(is_shared[vertex]);
        let (below, rank) = (downstream[vertex] as usize, ranks[vertex]);
        let Some(next) = ranks.get_mut(below) else { continue };
        is_shared[below] = rank.order == next.order || (is_shared[below] && rank.order < next.order);
        next.order = next.order.max(rank.order);
        next.magnitude += rank.magnitude;
        awaited[below] -= 1;
        if awaited[below] == 0 {
            ready.push(below);
        }
    }
    ranks
}
