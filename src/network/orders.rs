//! Strahler's orders and Shreve's magnitudes of rivers.

use super::{NONE, Network, River};
use crate::base::sort;

/// Counts all rivers' orders and magnitudes. Those of the tree stand until rivers join others than they did.
pub(super) fn count(network: &mut Network) {
    let rivers = &mut network.rivers;
    let arms = sort::argsort(rivers.iter().map(|river| river.junction));
    let mut awaited = vec![0u32; rivers.len()];
    for river in rivers.iter() {
        if let Some(awaited) = awaited.get_mut(river.parent as usize) {
            *awaited += 1;
        }
    }
    let mut ready: Vec<u32> = (0..rivers.len() as u32).filter(|&river| awaited[river as usize] == 0).collect();
    while let Some(number) = ready.pop() {
        let river = rivers[number as usize];
        let first = arms.partition_point(|&arm| rivers[arm].junction < river.start);
        let own = arms[first..].iter().map(|&arm| &rivers[arm]).take_while(|arm| arm.junction < river.end);
        let (order, magnitude) = fed_by(own);
        rivers[number as usize] = River { order, magnitude, ..river };
        if let Some(awaited) = awaited.get_mut(river.parent as usize) {
            *awaited -= 1;
            if *awaited == 0 {
                ready.push(river.parent);
            }
        }
    }
}

/// Order and magnitude of a river below arms that join it at some vertices, from its source down. Where the highest order
/// is that of several, the river itself among them, it rises by one.
fn fed_by<'a>(arms: impl Iterator<Item = &'a River>) -> (u8, u32) {
    let (mut order, mut magnitude) = (1, 1);
    // At the vertex that was looked at last: the highest order that came to it, and how many times.
    let (mut vertex, mut highest, mut times) = (NONE, 0, 0);
    for arm in arms {
        if arm.junction != vertex {
            (vertex, highest, times) = (arm.junction, order, 1);
        }
        if arm.order > highest {
            (highest, times) = (arm.order, 0);
        }
        times += u32::from(arm.order == highest);
        order = highest + u8::from(times > 1);
        magnitude += arm.magnitude;
    }
    (order, magnitude)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::Vertex;

    /// Rivers with a number of vertices each, which join a vertex of another one.
    fn network(rivers: &[(u32, u32, u32)]) -> Network {
        let mut start = 0;
        let river = |&(length, junction, parent): &(u32, u32, u32)| {
            let own = start..start + length;
            start = own.end;
            River { start: own.start, end: own.end, junction, parent, order: 0, magnitude: 0, identity: 0 }
        };
        let rivers: Vec<River> = rivers.iter().map(river).collect();
        Network { vertices: vec![Vertex::default(); start as usize], rivers, oxbows: vec![] }
    }

    fn counted(rivers: &[(u32, u32, u32)]) -> Vec<(u8, u32)> {
        let mut network = network(rivers);
        count(&mut network);
        network.rivers.iter().map(|river| (river.order, river.magnitude)).collect()
    }

    #[test]
    fn order_rises_where_equals_meet() {
        // Two brooks join the first river, one after the other: the second meets an order that is higher already.
        assert_eq!(counted(&[(5, NONE, NONE), (2, 2, 0), (2, 3, 0)]), [(2, 3), (1, 1), (1, 1)]);
        // Both at one vertex raise it once, too.
        assert_eq!(counted(&[(5, NONE, NONE), (2, 2, 0), (2, 2, 0)]), [(2, 3), (1, 1), (1, 1)]);
    }

    #[test]
    fn arms_count_before_what_they_join_whatever_their_numbers() {
        // The last river takes in the first one's arms: 0 ← 2 ← 1.
        assert_eq!(counted(&[(5, NONE, NONE), (2, 8, 2), (3, 3, 0)]), [(2, 3), (1, 1), (2, 2)]);
    }
}
