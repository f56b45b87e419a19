//! Cutoffs: where two limbs of a river come near each other, the river breaks through, and leaves the loop as an oxbow lake.
//!
//! A loop that other rivers join is not left whole: the uppermost of them takes over the bed below its junction, as
//! brooks do, and joins the river below the neck; the other tributaries join it. So no tributary is ever cut off.

use super::super::clearance::NearbyPair;
use super::super::orders;
use super::super::settings::NetworkSettings;
use super::super::width::settle;
use super::super::{NONE, Network, Oxbow, River, Vertex};
use super::{NARROWEST, river_of};
use crate::base::geometry::{distance, fast_max};
use crate::base::sort::argsort;

/// A neck: the vertices above and below the loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cut {
    pub river: u32,
    pub above: u32,
    pub below: u32,
}

/// Returns the distance between two limbs at which their river breaks through, in units; never less than banks have to
/// keep.
fn neck(network: &Network, [a, b]: [u32; 2], settings: &NetworkSettings) -> f32 {
    let width = |i: u32| network.vertices[i as usize].width();
    let neck = settings.neck * fast_max(width(a), NARROWEST * settings.spacing);
    fast_max(neck, (width(a) + width(b)) * 0.5 + settings.min_clearance)
}

/// Returns `true` if two segments of a river are limbs of a loop, not only of a bend, so near each other that it breaks through.
pub(super) fn is_neck(network: &Network, pair: &NearbyPair, settings: &NetworkSettings) -> bool {
    /// The least way along a loop from limb to limb, in necks; shorter ones are only bends.
    const LEAST: f32 = 2.0;
    let neck = neck(network, [pair.first, pair.second], settings);
    pair.distance < neck && way(network, pair.first, pair.second) > LEAST * neck
}

/// Returns the distance along a river from one vertex to another, in units.
fn way(network: &Network, from: u32, to: u32) -> f32 {
    network.vertices[from as usize..=to as usize].windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum()
}

/// Finds the necks to be cut among some pairs of segments: those of the longest loops of each river, none within another.
pub(super) fn necks(network: &Network, near: &[NearbyPair], settings: &NetworkSettings) -> Vec<Cut> {
    let river_of = river_of(network);
    let moves = |i: u32| network.vertices[i as usize].mobility > 0.0;
    let is_cut = |pair: &&NearbyPair| {
        let [first, second] = [pair.first, pair.second];
        river_of[first as usize] == river_of[second as usize]
            && (moves(first) || moves(second))
            && is_neck(network, pair, settings)
    };
    let cut = |pair: &NearbyPair| nearest_ends(network, river_of[pair.first as usize], pair.first, pair.second);
    let mut necks: Vec<Cut> = near.iter().filter(is_cut).filter_map(cut).collect();
    // By river, then by length, the longest first, then from the source on.
    for key in [|cut: &Cut| cut.above, |cut: &Cut| u32::MAX - (cut.below - cut.above), |cut: &Cut| cut.river] {
        necks = argsort(necks.iter().map(key)).into_iter().map(|i| necks[i]).collect();
    }
    let mut longest: Vec<Cut> = Vec::new();
    for cut in necks {
        let meets = |other: &&Cut| cut.above <= other.below && other.above <= cut.below;
        if !longest.iter().rev().take_while(|other| other.river == cut.river).any(|other| meets(&other)) {
            longest.push(cut);
        }
    }
    longest
}

/// Finds the ends of two segments of a river that lie nearest each other, the upper one above the loop; `None` if the river has none.
fn nearest_ends(network: &Network, river: u32, first: u32, second: u32) -> Option<Cut> {
    let end = network.rivers[river as usize].end;
    let at = |i: u32| network.vertices[i as usize].at;
    let pairs = [(first, second), (first, second + 1), (first + 1, second), (first + 1, second + 1)];
    let own = pairs.into_iter().filter(|&(_, below)| below < end);
    let nearest = own.min_by_key(|&(above, below)| at(above).distance_squared(at(below)).to_bits());
    nearest.map(|(above, below)| Cut { river, above, below })
}

/// Cuts through necks, which are sorted by river, none within another.
pub(super) fn cut(network: &mut Network, cuts: &[Cut], round: u32) {
    let loops: Vec<Loop> = cuts.iter().map(|&cut| Loop::of(network, cut)).collect();
    let oxbows: Vec<Oxbow> = loops.iter().filter_map(|cut_off| cut_off.oxbow(network, round)).collect();
    network.oxbows.extend(oxbows);
    let cuts_of = |river: u32| {
        let from = cuts.partition_point(|cut| cut.river < river);
        let count = cuts[from..].partition_point(|cut| cut.river == river);
        &cuts[from..from + count]
    };
    let mut bed_of = vec![None; network.rivers.len()];
    for cut_off in &loops {
        if let Some(heir) = cut_off.heir {
            bed_of[heir as usize] = Some(cut_off);
        }
    }
    let mut vertices = Vec::with_capacity(network.vertices.len());
    let mut place = vec![NONE; network.vertices.len()];
    let mut rivers = network.rivers.clone();
    for (number, river) in rivers.iter_mut().enumerate() {
        let old = *river;
        river.start = vertices.len() as u32;
        let mut take = |i: u32, vertex: Vertex| {
            place[i as usize] = vertices.len() as u32;
            vertices.push(vertex);
        };
        let own_cuts = cuts_of(number as u32);
        let is_left = |i: &u32| !own_cuts.iter().any(|cut| cut.above < *i && *i < cut.below);
        (old.start..old.end).filter(is_left).for_each(|i| take(i, network.vertices[i as usize]));
        if let Some(cut_off) = bed_of[number] {
            cut_off.bed(network, &old).for_each(|(i, vertex)| take(i, vertex));
            river.junction = cut_off.cut.below;
        }
        river.end = vertices.len() as u32;
    }
    let mut moved: Vec<u32> = loops.iter().filter_map(|cut_off| cut_off.heir).collect();
    for (number, river) in (0..).zip(&mut rivers) {
        if let Some(cut_off) = loops.iter().find(|cut_off| cut_off.is_left_to_heir(number, river)) {
            river.parent = cut_off.heir.unwrap_or(NONE);
            moved.push(number);
        }
        river.junction = place.get(river.junction as usize).copied().unwrap_or(NONE);
    }
    (network.vertices, network.rivers) = (vertices, rivers);
    if !moved.is_empty() {
        orders::count(network);
    }
    for river in moved {
        let river = network.rivers[river as usize];
        let arm = network.vertices[river.vertex_range()].last().map_or(0.0, Vertex::width);
        settle(network, river.parent as usize, river.junction, arm * 0.5);
    }
}

/// A loop that is cut off.
struct Loop {
    cut: Cut,
    /// The river that takes over its bed, if any, and the vertex from which on.
    heir: Option<u32>,
    taken_from: u32,
}

impl Loop {
    fn of(network: &Network, cut: Cut) -> Self {
        let joins = |river: &River| (cut.above + 1..cut.below).contains(&river.junction);
        let size = |river: &River| network.vertices[river.vertex_range()].last().map_or(0, |vertex| vertex.discharge);
        let uppermost = (0u32..)
            .zip(&network.rivers)
            .filter(|(_, river)| joins(river))
            .min_by_key(|(_, river)| (river.junction, u32::MAX - size(river)));
        let (heir, taken_from) = uppermost.map_or((None, cut.below), |(heir, river)| (Some(heir), river.junction));
        Self { cut, heir, taken_from }
    }

    /// Returns `true` if a river, as it was before the cut, joins the part of the loop that goes over to the heir.
    fn is_left_to_heir(&self, number: u32, river: &River) -> bool {
        self.heir.is_some_and(|heir| heir != number) && (self.taken_from..self.cut.below).contains(&river.junction)
    }

    /// Iterates over the vertices of the bed that the heir takes over, with their indices. The bed has lost the river's own water.
    fn bed<'a>(&'a self, network: &'a Network, heir: &River) -> impl Iterator<Item = (u32, Vertex)> + 'a {
        let gone = network.vertices[self.cut.above as usize].discharge;
        let last = network.vertices[heir.vertex_range()].last().copied().unwrap_or_default();
        (self.taken_from..self.cut.below).map(move |i| {
            let old = network.vertices[i as usize];
            let discharge = (old.discharge - gone).max(last.discharge);
            let narrower = (discharge as f32 / old.discharge.max(1) as f32).sqrt();
            let (left, right) = (fast_max(old.left * narrower, last.left), fast_max(old.right * narrower, last.right));
            (i, Vertex { discharge, left, right, mobility: 0.0, ..old })
        })
    }

    /// Returns the part of the loop that is left without a river; `None` if it is too short for a lake.
    fn oxbow(&self, network: &Network, round: u32) -> Option<Oxbow> {
        const LEAST_WIDTHS: f32 = 5.0;
        let vertices = network.vertices[self.cut.above as usize..=self.taken_from as usize].to_vec();
        let is_lake = way(network, self.cut.above, self.taken_from) > LEAST_WIDTHS * vertices[0].width();
        is_lake.then_some(Oxbow { river: self.cut.river, born: round, silt: 0.0, vertices })
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::samples::{places, river, settings, straight};
    use super::*;
    use glam::Vec2;

    /// Makes a river that runs east (vertices 0 to 20), loops to the south and comes back to within a unit (to 60), and runs on.
    fn hairpin() -> Network {
        let mut line = straight((0.0, 50.0), (20.0, 50.0), 20);
        line.extend(straight((20.0, 51.0), (20.0, 70.0), 19));
        line.extend(straight((21.0, 70.0), (21.0, 50.0), 20));
        line.extend(straight((22.0, 50.0), (40.0, 50.0), 18));
        river(&line, 1.0)
    }

    fn near(first: u32, second: u32) -> NearbyPair {
        NearbyPair { first, second, distance: 1.0 }
    }

    #[test]
    fn a_loop_is_found_where_limbs_come_near_and_the_longest_is_taken() {
        let network = hairpin();
        let settings = NetworkSettings { neck: 1.5, ..settings() };
        let cuts = necks(&network, &[near(30, 49), near(20, 59), near(38, 41)], &settings);
        assert_eq!(cuts.len(), 1);
        assert!(cuts[0].above <= 21 && cuts[0].below >= 59, "{cuts:?}");
        // Limbs too far apart, a loop too short, or both limbs held: no neck.
        assert!(necks(&network, &[NearbyPair { distance: 1.6, ..near(20, 59) }, near(38, 41)], &settings).is_empty());
        let mut held = network;
        held.vertices.iter_mut().for_each(|vertex| vertex.mobility = 0.0);
        assert!(necks(&held, &[near(20, 59)], &settings).is_empty());
    }

    #[test]
    fn the_river_breaks_through_and_leaves_a_lake() {
        let mut network = hairpin();
        let line = places(&network);
        cut(&mut network, &[Cut { river: 0, above: 20, below: 60 }], 7);
        assert_eq!(places(&network), [&line[..=20], &line[60..]].concat());
        assert_eq!(network.rivers[0].end as usize, network.vertices.len());
        let lake = &network.oxbows[0];
        assert_eq!((lake.river, lake.born), (0, 7));
        assert_eq!(lake.vertices.iter().map(|vertex| vertex.at).collect::<Vec<Vec2>>(), line[20..=60]);
    }

    #[test]
    fn a_tributary_takes_over_the_bed_below_it() {
        let mut network = hairpin().with_arm(&straight((0.0, 60.0), (19.0, 60.0), 19), 30, 10);
        network.vertices[30..79].iter_mut().for_each(|vertex| vertex.discharge = 110);
        let (line, arm) = (places(&network), network.rivers[1]);
        let (old_own, bed) = (line[arm.vertex_range()].to_vec(), &line[30..60]);
        cut(&mut network, &[Cut { river: 0, above: 20, below: 60 }], 1);
        let heir = network.rivers[1];
        assert_eq!(places(&network)[heir.vertex_range()], [&old_own, bed].concat(), "it runs on in the old bed");
        assert_eq!(network.vertices[heir.junction as usize].at, line[60], "and joins below the neck");
        assert!(
            network.vertices[heir.vertex_range()].iter().all(|vertex| vertex.discharge == 10),
            "with its own water"
        );
        let lake = &network.oxbows[0];
        assert_eq!(lake.vertices.last().unwrap().at, line[30], "only what is above it becomes a lake");
    }

    #[test]
    fn the_rest_of_the_loop_s_tributaries_join_the_heir() {
        let mut network = hairpin().with_arm(&straight((0.0, 60.0), (19.0, 60.0), 19), 30, 10).with_arm(
            &straight((50.0, 60.0), (22.0, 60.0), 28),
            50,
            10,
        );
        let joined = network.vertices[50].at;
        cut(&mut network, &[Cut { river: 0, above: 20, below: 60 }], 1);
        let [main, heir, other] = network.rivers[..] else { panic!("three rivers") };
        assert_eq!((heir.parent, other.parent), (0, 1));
        assert_eq!(network.vertices[other.junction as usize].at, joined);
        assert_eq!([main, heir, other].map(|river| (river.order, river.magnitude)), [(2, 3), (2, 2), (1, 1)]);
    }

    #[test]
    fn an_old_bed_narrows_as_the_root_of_its_water() {
        let mut network = hairpin().with_arm(&straight((0.0, 60.0), (19.0, 60.0), 19), 30, 25);
        let arm = network.rivers[1];
        // Below the neck the river carries four times what the arm brings, and the arm has no banks to speak of.
        network.vertices[21..79].iter_mut().for_each(|vertex| vertex.discharge = 100);
        network.vertices[..=20].iter_mut().for_each(|vertex| vertex.discharge = 75);
        network.vertices[arm.vertex_range()].iter_mut().for_each(|vertex| (vertex.left, vertex.right) = (0.1, 0.1));
        let old = network.vertices[40];
        cut(&mut network, &[Cut { river: 0, above: 20, below: 60 }], 1);
        let heir = network.rivers[1];
        let bed = network.vertices[heir.vertex_range()].iter().find(|vertex| vertex.at == old.at).unwrap();
        let squared_width = |vertex: &Vertex| vertex.width() * vertex.width() / vertex.discharge as f32;
        assert_eq!((old.discharge, bed.discharge), (100, 25));
        assert!(
            (squared_width(bed) / squared_width(&old) - 1.0).abs() < 1e-5,
            "{} wide, of {}",
            bed.width(),
            old.width()
        );
    }

    #[test]
    fn of_two_tributaries_at_one_place_the_larger_takes_over_the_bed() {
        for (first, second, larger) in [(10, 20, 2), (20, 10, 1)] {
            let mut network = hairpin().with_arm(&straight((0.0, 60.0), (19.0, 60.0), 19), 30, first).with_arm(
                &straight((0.0, 62.0), (19.0, 62.0), 19),
                30,
                second,
            );
            network.vertices[30..79].iter_mut().for_each(|vertex| vertex.discharge = 130);
            let line = places(&network);
            cut(&mut network, &[Cut { river: 0, above: 20, below: 60 }], 1);
            let [heir, other] = if larger == 1 { [1, 2] } else { [2, 1] }.map(|river: usize| network.rivers[river]);
            assert_eq!(network.vertices[heir.junction as usize].at, line[60], "the larger one runs on below the neck");
            assert_eq!(other.parent, larger, "and takes the smaller one in");
            assert_eq!(network.vertices[other.junction as usize].at, line[30], "where both of them ended");
        }
    }
}
