//! What is known of rivers, worked out again by definition.

use glam::DVec2;
use riverseed::network::{NONE, Network, Oxbow, River};
use riverseed::session::Session;

/// Strahler's order at the end of each river, from where rivers join each other alone.
pub fn orders(network: &Network) -> Vec<u8> {
    fn of(network: &Network, river: &River) -> u8 {
        let arms = network
            .rivers
            .iter()
            .filter(|arm| arm.junction != NONE && river.vertex_range().contains(&(arm.junction as usize)));
        let mut joining: Vec<(u32, u8)> = arms.map(|arm| (arm.junction, of(network, arm))).collect();
        joining.sort_unstable();
        joining.chunk_by(|a, b| a.0 == b.0).fold(1, |order, arms| {
            let orders = || arms.iter().map(|(_, order)| *order).chain([order]);
            let highest = orders().max().unwrap();
            highest + u8::from(orders().filter(|order| *order == highest).count() > 1)
        })
    }
    network.rivers.iter().map(|river| of(network, river)).collect()
}

/// Whether a river is another one, or drains into it.
pub fn drains_into(network: &Network, mut river: u32, other: u32) -> bool {
    while river != other && river != NONE {
        river = network.rivers[river as usize].parent;
    }
    river == other
}

/// Shreve's magnitude: how many rivers begin upstream of the end of each, itself among them.
pub fn magnitudes(network: &Network) -> Vec<u32> {
    let all = || 0..network.rivers.len() as u32;
    all().map(|end| all().filter(|&river| drains_into(network, river, end)).count() as u32).collect()
}

pub fn mouth(network: &Network, river: u32) -> u32 {
    let reaches_sea = |&mouth: &u32| network.rivers[mouth as usize].parent == NONE;
    (0..network.rivers.len() as u32).filter(reaches_sea).find(|&mouth| drains_into(network, river, mouth)).unwrap()
}

/// The vertices of a river, source first, the junction last if it ends in one.
pub fn course(river: &River) -> Vec<usize> {
    river.vertex_range().chain((river.junction != NONE).then_some(river.junction as usize)).collect()
}

pub fn line(network: &Network, river: &River) -> Vec<DVec2> {
    course(river).into_iter().map(|vertex| network.vertices[vertex].at.as_dvec2()).collect()
}

pub fn length(line: &[DVec2]) -> f64 {
    line.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// How high each vertex lies over the sea, in metres: as the relief's cell there, or the vertex below it where that is higher.
pub fn heights(session: &Session) -> Vec<f64> {
    let metres_a_unit = f64::from(session.map().unwrap().scale().metres_up);
    let (network, relief) = (session.network().unwrap(), session.map().unwrap().make_relief().unwrap());
    let mut heights = vec![f64::NAN; network.vertices.len()];
    // A river stands before those that join it, but for what a cutoff has given to another.
    while heights.iter().any(|height| height.is_nan()) {
        for river in &network.rivers {
            let course = course(river);
            if river.junction == NONE {
                heights[course[course.len() - 1]] = 0.0;
            }
            for pair in course.windows(2).rev() {
                let own = f64::from(relief.at(network.vertices[pair[0]].at)) * metres_a_unit;
                let below = heights[pair[1]];
                heights[pair[0]] = if below.is_nan() { below } else { below.max(own) };
            }
        }
    }
    heights
}

/// The lakes that there are to see: those that are open anywhere between their ends, which silt has closed.
pub fn lakes(network: &Network) -> Vec<(u32, &Oxbow)> {
    let is_open = |oxbow: &Oxbow| oxbow.lake().iter().any(|(vertex, share)| vertex.width() * share > 0.0);
    (0..).zip(&network.oxbows).filter(|(_, oxbow)| is_open(oxbow)).collect()
}
