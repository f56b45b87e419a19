//! Nothing crosses: a sweep over all segments from west to east.

use super::{Breach, Fault, Finding, Promise};
use crate::base::geometry::{Segment, meet, meeting};
use crate::base::sort;
use crate::network::Network;

/// The promise that no two rivers cross, and none crosses itself.
pub const CROSSINGS: Promise = Promise { name: "apart", says: "Nothing crosses", counted: "segments" };

/// A piece of a river between two neighbouring vertices of its course.
#[derive(Clone, Copy)]
struct Piece {
    river: u32,
    /// The indices of its vertices. Two pieces that share one meet there by right.
    ends: [u32; 2],
    line: Segment,
    west: f32,
    east: f32,
}

/// Finds the segments that meet another one without having an end in common with it; touching counts. Each pair is told
/// once, at the river whose segment begins farther west.
pub fn crossings(network: &Network) -> Finding {
    let pieces = sort::sorted_by(&pieces(network), |piece| sort::key(piece.west));
    let mut breaches = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        let beside = pieces[i + 1..].iter().take_while(|other| other.west <= piece.east);
        breaches.extend(beside.filter(|other| piece.meets(other)).map(|other| piece.breach(other)));
    }
    let breaches = sort::sorted_by(&breaches, |breach| breach.river);
    Finding { promise: CROSSINGS, looked_at: pieces.len(), breaches }
}

impl Piece {
    fn meets(&self, other: &Self) -> bool {
        !self.ends.iter().any(|end| other.ends.contains(end)) && meet(self.line, other.line)
    }

    fn breach(&self, other: &Self) -> Breach {
        let at = self.line.0.lerp(self.line.1, meeting(self.line, other.line));
        Breach { river: self.river, at, fault: Fault::Crosses { other: other.river } }
    }
}

/// Lists the segments of all courses.
fn pieces(network: &Network) -> Vec<Piece> {
    let downstream = network.downstream();
    let mut pieces = Vec::with_capacity(downstream.len());
    for (number, river) in (0..).zip(&network.rivers) {
        for upper in river.start..river.end {
            let lower = downstream[upper as usize];
            let Some(below) = network.vertices.get(lower as usize) else { continue };
            let (from, to) = (network.vertices[upper as usize].at, below.at);
            let (west, east) = (from.x.min(to.x), from.x.max(to.x));
            pieces.push(Piece { river: number, ends: [upper, lower], line: (from, to), west, east });
        }
    }
    pieces
}
