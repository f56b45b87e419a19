//! Mobility: how freely each vertex meanders. Most rivers do so gently, more in some regions than in others, and less
//! the steeper they are; great rivers do so fully where they are flat. The ends of a river stay, and mobility rises
//! away from them. Tributaries do not hold a river: it carries their ends along.

use super::super::hydrology::slopes;
use super::super::settings::NetworkSettings;
use super::super::{Network, Vertex};
use crate::base::geometry::{distance, fast_max, fast_min, lengths, smooth_step};
use crate::base::sort;
use crate::recipe::MeanderModel;

/// The distance, in widths, from a fixed point of a river within which it does not meander.
const HELD: f32 = 1.0;

/// The share of flatter courses up to which other rivers meander gently, and that from which on they do not.
const GENTLE: f32 = 0.4;
const STEEP: f32 = 0.85;

/// The mobility below which vertices stay: their moves would not be seen, and take as long as others.
const LEAST: f32 = 0.05;

/// Sets the mobility of every vertex. Returns the indices of the great rivers, in descending order of flat length.
pub(super) fn assign(network: &mut Network, settings: &NetworkSettings) -> Vec<u32> {
    if settings.model == MeanderModel::None {
        return Vec::new();
    }
    let steepness = steepness(network, settings);
    let is_flat: Vec<bool> = steepness.iter().map(|&share| share < settings.flat_share).collect();
    let great = great_rivers(network, &is_flat, settings.great_rivers);
    let noise = settings.gentle_noise();
    for (number, river) in network.rivers.clone().iter().enumerate() {
        let along = lengths(&network.places(river));
        let Some(&length) = along.last() else { continue };
        let own = &mut network.vertices[river.vertex_range()];
        let width: Vec<f32> = own.iter().map(|vertex| fast_max(vertex.width(), settings.spacing)).collect();
        let ramp = |far: f32, width: f32| smooth_step((far / width - HELD) / fast_max(settings.taper - HELD, 0.1));
        let in_flat = great.contains(&(number as u32)).then(|| depths_in_flat(&is_flat[river.vertex_range()], &along));
        for (i, vertex) in own.iter_mut().enumerate() {
            let gently = settings.meander_elsewhere
                * smooth_step(noise.get_noise_2d(vertex.at.x, vertex.at.y) * 1.25 + 0.25)
                * (1.0 - smooth_step((steepness[river.start as usize + i] - GENTLE) / (STEEP - GENTLE)));
            let fully = in_flat.as_ref().map_or(0.0, |depths| ramp(depths[i], width[i]));
            let mobility = fast_max(gently, fully) * ramp(along[i], width[i]) * ramp(length - along[i], width[i]);
            vertex.mobility = if mobility < LEAST { 0.0 } else { mobility };
        }
    }
    great
}

/// Lowers mobility toward vertices that have none, so that a river does not bend sharply where it is held.
pub(super) fn ease_off(network: &mut Network, spacing: f32) {
    const WIDTHS: f32 = 5.0;
    let ease = |vertex: &mut Vertex, beside: &mut Vertex| {
        let rise = distance(beside.at, vertex.at) / (WIDTHS * fast_max(vertex.width(), spacing));
        vertex.mobility = fast_min(vertex.mobility, beside.mobility + rise);
    };
    for river in &network.rivers {
        let own = &mut network.vertices[river.vertex_range()];
        for i in 1..own.len() {
            let (before, rest) = own.split_at_mut(i);
            ease(&mut rest[0], &mut before[i - 1]);
        }
        for i in (1..own.len()).rev() {
            let (before, rest) = own.split_at_mut(i);
            ease(&mut before[i - 1], &mut rest[0]);
        }
    }
}

/// Returns, for each vertex, the share of all vertices, which are evenly spaced, that are flatter.
#[inline(never)] // two copies weigh more than a call
fn steepness(network: &Network, settings: &NetworkSettings) -> Vec<f32> {
    let slopes = slopes(network, settings.total_discharge);
    let by_slope = sort::argsort(slopes.iter().map(|&slope| sort::key(slope)));
    let mut steepness = vec![0.0; slopes.len()];
    let mut flatter = 0;
    for (rank, &i) in by_slope.iter().enumerate() {
        if rank > 0 && slopes[i] > slopes[by_slope[rank - 1]] {
            flatter = rank;
        }
        steepness[i] = flatter as f32 / slopes.len() as f32;
    }
    steepness
}

/// Returns the rivers with the greatest flat lengths, in descending order.
fn great_rivers(network: &Network, is_flat: &[bool], count: u32) -> Vec<u32> {
    let length =
        |river: &super::super::River| is_flat[river.vertex_range()].iter().filter(|&&flat| flat).count() as u32;
    let lengths: Vec<u32> = network.rivers.iter().map(length).collect();
    let by_length = sort::argsort(lengths.iter().map(|&length| u32::MAX - length));
    let has_any = by_length.into_iter().take(count as usize).filter(|&river| lengths[river] > 0);
    has_any.map(|river| river as u32).collect()
}

/// Returns how far inside a flat stretch each vertex of a river lies, in units: the distance to the stretch's nearer
/// end, where the river's own end is none; 0 where it is not flat.
fn depths_in_flat(is_flat: &[bool], along: &[f32]) -> Vec<f32> {
    let mut depths = vec![0.0; is_flat.len()];
    let mut start = 0;
    for stretch in is_flat.chunk_by(|a, b| a == b) {
        let end = start + stretch.len();
        if stretch[0] {
            for i in start..end {
                let below = if end < is_flat.len() { along[end] - along[i] } else { f32::INFINITY };
                depths[i] = fast_min(along[i] - along[start], below);
            }
        }
        start = end;
    }
    depths
}

/// The longest flat stretch of a great river, given by the discharge at its ends, which grows all along a river,
/// however vertices are spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// The index of the river.
    pub river: u32,
    /// The discharge at the upper end.
    pub least_discharge: u32,
    /// The discharge at the lower end.
    pub most_discharge: u32,
}

/// Finds the longest flat stretch of each great river.
pub(super) fn reaches(network: &Network, great: &[u32], settings: &NetworkSettings) -> Vec<Reach> {
    let is_flat: Vec<bool> = steepness(network, settings).iter().map(|&share| share < settings.flat_share).collect();
    great.iter().map(|&river| reach(network, river, &is_flat)).collect()
}

fn reach(network: &Network, river: u32, is_flat: &[bool]) -> Reach {
    let (mut longest, mut start) = (0..0, 0);
    let own = network.rivers[river as usize].vertex_range();
    for stretch in is_flat[own.clone()].chunk_by(|a, b| a == b) {
        let end = start + stretch.len();
        if stretch[0] && stretch.len() > longest.len() {
            longest = start..end;
        }
        start = end;
    }
    let discharge = |i: usize| network.vertices[own.start + i].discharge;
    Reach { river, least_discharge: discharge(longest.start), most_discharge: discharge(longest.end.max(1) - 1) }
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{river, settings, straight};
    use super::*;
    use crate::network::River;

    /// Makes a river 400 units long and two wide, with mobility, that an arm with a discharge of `share` joins halfway.
    fn swaying(share: u32, settings: &NetworkSettings) -> (Network, River) {
        let mut network = river(&straight((0.0, 400.0), (400.0, 400.0), 400), 2.0).with_arm(
            &straight((200.0, 100.0), (200.0, 399.0), 299),
            200,
            share,
        );
        network.vertices.iter_mut().for_each(|vertex| vertex.mobility = 0.0);
        assign(&mut network, settings);
        let main = network.rivers[0];
        (network, main)
    }

    fn only_great(great_rivers: u32) -> NetworkSettings {
        NetworkSettings {
            great_rivers,
            meander_elsewhere: 0.0,
            flat_share: 1.0,
            taper: 6.0,
            total_discharge: 100,
            ..settings()
        }
    }

    #[test]
    fn nothing_moves_at_the_ends_of_rivers() {
        let (network, main) = swaying(40, &NetworkSettings { meander_elsewhere: 1.0, ..only_great(2) });
        let mobility = |i: usize| network.vertices[i].mobility;
        for held in [0, 1, main.end as usize - 1, main.end as usize, network.vertices.len() - 1] {
            assert_eq!(mobility(held), 0.0, "{held}");
        }
        assert!(mobility(100) > 0.9 && mobility(300) > 0.9, "{} {}", mobility(100), mobility(300));
    }

    #[test]
    fn tributaries_do_not_hold_a_river() {
        for share in [2, 40] {
            let (network, _) = swaying(share, &only_great(1));
            assert_eq!(network.vertices[200].mobility, 1.0, "{share}");
        }
    }

    #[test]
    fn other_rivers_meander_the_less_the_steeper_they_are() {
        let mut network = river(&straight((0.0, 400.0), (400.0, 400.0), 400), 2.0);
        network.vertices.iter_mut().enumerate().for_each(|(i, vertex)| vertex.discharge = i as u32 + 1);
        assign(&mut network, &NetworkSettings { meander_elsewhere: 1.0, ..only_great(0) });
        let most = |part: std::ops::Range<usize>| network.vertices[part].iter().map(|v| v.mobility).fold(0.0, f32::max);
        assert_eq!(most(0..60), 0.0, "the steepest seventh");
        assert!(most(60..160) < most(240..380), "{} {}", most(60..160), most(240..380));
    }

    #[test]
    fn as_many_rivers_meander_as_are_asked_for() {
        for great in 0..4 {
            let (network, _) = swaying(40, &only_great(great));
            let moves =
                |river: &&River| network.vertices[river.vertex_range()].iter().any(|vertex| vertex.mobility > 0.0);
            assert_eq!(network.rivers.iter().filter(moves).count(), great.min(2) as usize);
        }
    }

    #[test]
    fn only_what_is_flat_meanders_fully() {
        let mut network = river(&straight((0.0, 400.0), (400.0, 400.0), 400), 2.0);
        network.vertices.iter_mut().enumerate().for_each(|(i, vertex)| vertex.discharge = i as u32 + 1);
        assign(&mut network, &NetworkSettings { flat_share: 0.25, total_discharge: 400, ..only_great(1) });
        assert!(network.vertices[..300].iter().all(|vertex| vertex.mobility == 0.0));
        assert_eq!(network.vertices[350].mobility, 1.0);
    }

    #[test]
    fn sway_falls_off_toward_what_is_held() {
        let mut network = river(&straight((0.0, 0.0), (60.0, 0.0), 60), 2.0);
        network.vertices[30].mobility = 0.0;
        ease_off(&mut network, 1.0);
        let mobility: Vec<f32> = network.vertices.iter().map(|vertex| vertex.mobility).collect();
        assert!(mobility[30..45].is_sorted() && mobility[15..=30].iter().rev().is_sorted());
        assert!(mobility[31] < 0.2 && mobility[45] == 1.0 && mobility[15] == 1.0);
    }
}
