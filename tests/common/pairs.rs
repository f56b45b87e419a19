//! The survey of clearances, pair by pair: every segment against every other.

use riverseed::network::{NONE, NearbyPair, Network, gap};

/// The result of [`riverseed::network::ClearanceGrid::measure`]: the clearance of each segment, and the pairs near each
/// other, in order.
pub fn measure(network: &Network, reach: &[f32], caps: Vec<f32>) -> (Vec<f32>, Vec<NearbyPair>) {
    let downstream = network.downstream();
    let at = |i: usize| network.vertices[i].at;
    let mut clearance = caps;
    let mut near = Vec::new();
    let segments: Vec<usize> = (0..downstream.len()).filter(|&i| downstream[i] != NONE).collect();
    for (n, &i) in segments.iter().enumerate() {
        for &j in &segments[n + 1..] {
            let (below_i, below_j) = (downstream[i] as usize, downstream[j] as usize);
            if below_i == j || below_j == i || below_i == below_j {
                continue;
            }
            let distance = gap((at(i), at(below_i)), (at(j), at(below_j)));
            if reach[i].max(reach[j]) > 0.0 {
                clearance[i] = clearance[i].min(distance);
                clearance[j] = clearance[j].min(distance);
            }
            if distance < reach[i].max(reach[j]) && i.abs_diff(j) > 3 {
                near.push(NearbyPair { first: i as u32, second: j as u32, distance });
            }
        }
    }
    (clearance, near)
}
