//! Strahler's orders and Shreve's magnitudes of rivers.

use super::{NONE, Network, River};
use crate::base::sort;

/// Recomputes the orders and magnitudes of all rivers, which change when a river comes to join another one than before.
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

/// Returns the order and magnitude of a river at its end; `arms` join it in the order from its source down. Where
/// several of those that meet, the river itself among them, have the highest order, it rises by one.
fn fed_by<'a>(arms: impl Iterator<Item = &'a River>) -> (u8, u32) {
    let (mut order, mut magnitude) = (1, 1);
    // The last vertex looked at, the highest order of what meets there, and how many times it does.
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

    /// Makes rivers from the number of vertices of each, its junction and its parent.
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
