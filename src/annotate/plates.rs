//! The figures of plates: a map's longest rivers, straightened, and the long profile of its greatest.

use glam::Vec2;

use crate::annotate::names::Names;
use crate::annotate::place::{LongProfile, StraightRiver, Tributary};
use crate::base::geometry::distance;
use crate::base::sort;
use crate::map::Map;
use crate::network::{NONE, Network, River, Vertex};
use crate::scale::MapScale;

/// The greatest number of rivers that are straightened.
const MOST: usize = 14;
/// The number of pieces of a straightened river, and of a profile.
const PIECES: u16 = 96;
const HEIGHTS: u16 = 160;

/// Straightens the longest rivers that have names, the longest first.
pub fn longest(network: &Network, names: &Names, scale: &MapScale) -> Vec<StraightRiver> {
    let lengths: Vec<f32> = network.rivers.iter().map(|river| network.length(river)).collect();
    let order = sort::argsort(lengths.iter().map(|length| sort::key(-length)));
    let named =
        order.into_iter().filter_map(|i| Some((i, names.rivers.get(i).filter(|river| !river.name.is_empty())?)));
    let straight = |(i, name): (usize, &crate::annotate::names::RiverName)| StraightRiver {
        river: i as u32,
        name: name.name.clone(),
        kilometres: scale.kilometres(lengths[i]),
        points: straightened(network, &network.rivers[i]),
    };
    named.take(MOST).map(straight).collect()
}

/// A place on a course, with half the width and the height there.
#[derive(Clone, Copy)]
struct Station {
    at: Vec2,
    half: f32,
    elevation: f32,
}

/// Places at even distances along a river, from its end to its source.
fn stations(network: &Network, river: &River, pieces: u16) -> Vec<Station> {
    let upward: Vec<&Vertex> = network.course(river).rev().collect();
    let mut along = vec![0.0];
    for pair in upward.windows(2) {
        along.push(along[along.len() - 1] + distance(pair[0].at, pair[1].at));
    }
    let length = along[along.len() - 1];
    let mut next = 1;
    let station = |piece: u16| {
        let wanted = length * f32::from(piece) / f32::from(pieces);
        while next + 1 < upward.len() && along[next] < wanted {
            next += 1;
        }
        let (from, to) = (*upward.get(next - 1)?, *upward.get(next)?);
        let long = along[next] - along[next - 1];
        let share = if long > 0.0 { ((wanted - along[next - 1]) / long).min(1.0) } else { 0.0 };
        let between = |of: fn(&Vertex) -> f32| of(from) + (of(to) - of(from)) * share;
        Some(Station {
            at: from.at.lerp(to.at, share),
            half: between(|vertex| 0.5 * vertex.width()),
            elevation: between(|vertex| vertex.elevation),
        })
    };
    (0..=pieces).map_while(station).collect()
}

/// Straightens a river: returns for each place its distance to one side of the river's general course, and half its width.
fn straightened(network: &Network, river: &River) -> Vec<[f32; 2]> {
    /// The number of pieces before and behind a place that tell the general course there.
    const AROUND: usize = 6;
    let stations = stations(network, river, PIECES);
    let aside = |i: usize| {
        let reach = AROUND.min(i).min(stations.len() - 1 - i);
        let [before, after] = [stations[i - reach].at, stations[i + reach].at];
        let chord = after - before;
        let length = chord.length_squared().sqrt();
        if length > 0.0 { (stations[i].at - before.midpoint(after)).perp_dot(chord) / length } else { 0.0 }
    };
    let asides: Vec<f32> = (0..stations.len()).map(aside).collect();
    let smooth = |i: usize| {
        let near = &asides[i.saturating_sub(1)..(i + 2).min(asides.len())];
        (near.iter().sum::<f32>() + asides[i]) / (near.len() + 1) as f32
    };
    (0..stations.len()).map(|i| [smooth(i), stations[i].half]).collect()
}

/// Takes the profile of the greatest river that has a name and reaches the sea; `None` if nothing tells its heights: neither its tree nor a
/// relief that the style shows.
pub fn profile(map: &Map, names: &Names) -> Option<LongProfile> {
    let network = map.network();
    let is_named = |&i: &usize| names.rivers.get(i).is_some_and(|river| !river.name.is_empty());
    let of_the_sea = (0..network.rivers.len()).filter(|&i| network.rivers[i].parent == NONE).filter(is_named);
    let number = of_the_sea.min_by_key(|&i| u32::MAX - network.discharge(&network.rivers[i]))?;
    let river = &network.rivers[number];
    let relief = map.shown_relief().filter(|_| network.vertices.iter().all(|vertex| vertex.elevation <= 0.0));
    let (metres_up, mut highest) = (map.scale().metres_up, 0.0f32);
    // No river runs uphill, whatever the grid of a relief says between two of its corners.
    let height = |station: Station| {
        let height = relief.map_or(station.elevation, |relief| relief.at(station.at)) * metres_up;
        highest = highest.max(height);
        highest
    };
    let heights: Vec<f32> = stations(network, river, HEIGHTS).into_iter().map(height).collect();
    (heights.last()? > &1.0).then(|| LongProfile {
        river: number as u32,
        name: names.rivers[number].name.clone(),
        kilometres: map.scale().kilometres(network.length(river)),
        tributaries: tributaries(network, names, number as u32),
        heights,
    })
}

/// Lists the rivers that join another, the greatest first.
fn tributaries(network: &Network, names: &Names, number: u32) -> Vec<Tributary> {
    let main = &network.rivers[number as usize];
    let mut along = vec![0.0];
    let upward: Vec<Vec2> = network.course(main).rev().map(|vertex| vertex.at).collect();
    for pair in upward.windows(2) {
        along.push(along[along.len() - 1] + distance(pair[0], pair[1]));
    }
    let length = along[along.len() - 1].max(f32::MIN_POSITIVE);
    let is_joining = |&i: &usize| network.rivers[i].parent == number;
    let joining: Vec<usize> = (0..network.rivers.len()).filter(is_joining).collect();
    let joining = sort::sorted_by(&joining, |&i| u32::MAX - network.discharge(&network.rivers[i]));
    let tributary = |i: usize| {
        let at = along.get(main.end.checked_sub(1 + network.rivers[i].junction)? as usize)?;
        let name = names.rivers.get(i).map_or_else(String::new, |river| river.name.clone());
        Some(Tributary { river: i as u32, name, share: at / length })
    };
    joining.into_iter().filter_map(tributary).collect()
}
