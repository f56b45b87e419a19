//! Strahler's order at every vertex of a network.

use crate::base::sort;
use crate::network::{Network, River};

/// Counts Strahler's order of the river at each vertex, including the rivers that join there: 1 at a source, and never
/// lower downstream.
pub(super) fn along(network: &Network) -> Vec<u8> {
    let rivers = &network.rivers;
    let arms = sort::argsort(rivers.iter().map(|river| river.junction));
    let mut orders = vec![1; network.vertices.len()];
    for river in rivers {
        let mut next = arms.partition_point(|&arm| rivers[arm].junction < river.start);
        let mut order = 1;
        for vertex in river.start..river.end {
            let first = next;
            next += arms[first..].iter().take_while(|&&arm| rivers[arm].junction == vertex).count();
            order = below(order, arms[first..next].iter().map(|&arm| &rivers[arm]));
            orders[vertex as usize] = order;
        }
    }
    orders
}

/// Returns the order of a river below a junction: one above the highest, if several that meet have it.
fn below<'a>(order: u8, arms: impl Iterator<Item = &'a River>) -> u8 {
    let (highest, times) = arms.fold((order, 1), |(highest, times), arm| match arm.order.cmp(&highest) {
        std::cmp::Ordering::Less => (highest, times),
        std::cmp::Ordering::Equal => (highest, times + 1),
        std::cmp::Ordering::Greater => (arm.order, 1),
    });
    highest + u8::from(times > 1)
}
