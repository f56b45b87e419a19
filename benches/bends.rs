//! Bends as geomorphologists measure them: from one inflection of a river to the next.

use glam::Vec2;
use riverseed::network::{Network, River, Vertex, curvature};

/// One bend, in widths of its river.
#[derive(Clone, Copy, Debug)]
pub struct Bend {
    /// Twice the straight distance between the inflections.
    pub wavelength: f32,
    /// The radius at its apex.
    pub radius: f32,
    /// The length along the river divided by the straight distance.
    pub sinuosity: f32,
}

/// The bends where rivers meander freely, with a turn of a right angle or more in each.
pub fn bends(network: &Network) -> Vec<Bend> {
    network.rivers.iter().flat_map(|river| of_river(network, river)).collect()
}

fn of_river(network: &Network, river: &River) -> Vec<Bend> {
    let course: Vec<&Vertex> = network.course(river).collect();
    let bent: Vec<f32> = (0..course.len()).map(|i| bent(&course, i)).collect();
    let inflections: Vec<usize> = (1..course.len()).filter(|&i| bent[i] * bent[i - 1] < 0.0).collect();
    inflections.windows(2).filter_map(|pair| bend(&course[pair[0]..=pair[1]], &bent[pair[0]..pair[1]])).collect()
}

/// The curvature over about a width in both directions.
fn bent(course: &[&Vertex], i: usize) -> f32 {
    let step = course[i].at.distance(course[(i + 1).min(course.len() - 1)].at).max(1e-3);
    let stride = ((course[i].width() / step) as usize).clamp(1, 8);
    if i < stride || i + stride >= course.len() {
        return 0.0;
    }
    curvature(course[i - stride].at, course[i].at, course[i + stride].at)
}

fn bend(part: &[&Vertex], bent: &[f32]) -> Option<Bend> {
    let width = part.iter().map(|vertex| vertex.width()).sum::<f32>() / part.len() as f32;
    let free = part.iter().filter(|vertex| vertex.mobility > 0.7).count() * 4 > part.len() * 3;
    let straight = part.first()?.at.distance(part.last()?.at);
    let steps = part.windows(2).map(|pair| pair[1].at - pair[0].at).collect::<Vec<Vec2>>();
    let turn: f32 = steps.windows(2).map(|pair| pair[0].angle_to(pair[1])).sum();
    let sharpest = bent.iter().fold(0.0f32, |most, bent| most.max(bent.abs()));
    let length: f32 = steps.iter().map(|step| step.length()).sum();
    (free && turn.abs() > 1.57 && width > 0.0 && straight > 0.0).then(|| Bend {
        wavelength: 2.0 * straight / width,
        radius: 1.0 / (sharpest * width),
        sinuosity: length / straight,
    })
}
