//! Widths: by discharge, with a small variation of each bank.
//!
//! Width is the square root of discharge (Leopold and Maddock 1953), so that squared widths add where rivers join; 0 at a
//! source. The two banks vary each for itself, since banks that bulge together look like beads on a string. Below a junction no
//! river is ever narrower than its arms were there.

use fastnoise_lite::FastNoiseLite;

use super::settings::NetworkSettings;
use super::{NONE, Network};
use crate::base::geometry::{distance, fast_max, fast_min};

/// The distance, in spacings, over which a river widens from nothing to its full width.
const TAPER: f32 = 8.0;

/// Sets the distance of both banks at each vertex.
pub(super) fn widen(network: &mut Network, settings: &NetworkSettings) {
    let noise = settings.width_noise();
    let mut floors = Floors(vec![(0.0, 0.0); network.vertices.len()]);
    // Tributaries stand after the rivers that they join.
    for number in (0..network.rivers.len()).rev() {
        widen_river(network, number, settings, &noise, &mut floors);
    }
}

/// The least half-widths that tributaries demand at junctions.
struct Floors(Vec<(f32, f32)>);

impl Floors {
    fn raise(&mut self, vertex: u32, half: f32) {
        if let Some((left, right)) = self.0.get_mut(vertex as usize) {
            (*left, *right) = (fast_max(*left, half), fast_max(*right, half));
        }
    }
}

/// Widens a vertex that has become a junction to what joins there, `arm` being half the tributary's width, and the
/// banks below it to no less: down to the next junction that is wide enough already.
pub(super) fn settle(network: &mut Network, river: usize, junction: u32, arm: f32) {
    let is_junction = network.junctions();
    let river = network.rivers[river];
    let above = network.vertices[(junction.max(river.start + 1) - 1) as usize];
    let mut floor = (fast_max(arm, above.left), fast_max(arm, above.right));
    let below = junction as usize..river.end as usize;
    for (i, (vertex, &is_junction)) in network.vertices[below.clone()].iter_mut().zip(&is_junction[below]).enumerate() {
        if i > 0 && is_junction && vertex.left >= floor.0 && vertex.right >= floor.1 {
            return;
        }
        (vertex.left, vertex.right) = (fast_max(vertex.left, floor.0), fast_max(vertex.right, floor.1));
        if is_junction {
            floor = (vertex.left, vertex.right);
        }
    }
    let last = network.vertices[river.end as usize - 1];
    if river.junction != NONE {
        settle(network, river.parent as usize, river.junction, last.width() * 0.5);
    }
}

fn widen_river(
    network: &mut Network,
    number: usize,
    settings: &NetworkSettings,
    noise: &FastNoiseLite,
    floors: &mut Floors,
) {
    let river = network.rivers[number];
    let (mut along, mut floor, mut last) = (0.0f32, (0.0f32, 0.0f32), (0.0f32, 0.0f32));
    let mut previous = None;
    for i in river.vertex_range() {
        let vertex = &mut network.vertices[i];
        along += previous.map_or(0.0, |at| distance(vertex.at, at));
        previous = Some(vertex.at);
        let taper = fast_min(along / (settings.spacing * TAPER), 1.0).sqrt();
        let half = settings.half_width(vertex.discharge) * taper;
        let bank = |side: f32| {
            // Some ten widths to a bulge.
            let place = along / (fast_max(half, settings.hairline) * 20.0) * 1.7;
            half * (1.0 + settings.bank_variation * noise.get_noise_2d(place, number as f32 * 17.3 + side))
        };
        let arms = floors.0[i];
        let is_junction = arms.0 > 0.0;
        if is_junction {
            floor = (fast_max(floor.0, fast_max(arms.0, last.0)), fast_max(floor.1, fast_max(arms.1, last.1)));
        }
        (vertex.left, vertex.right) = (fast_max(bank(0.0), floor.0), fast_max(bank(71.0), floor.1));
        if is_junction {
            floor = (vertex.left, vertex.right);
        }
        last = (vertex.left, vertex.right);
    }
    if river.junction != NONE {
        // Below the junction the river is at least as wide as the tributary, half of it on each side.
        floors.raise(river.junction, fast_max((last.0 + last.1) * 0.5, f32::MIN_POSITIVE));
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, settings, straight};
    use super::*;
    use crate::network::Vertex;

    /// Makes a river that an arm with a share of its discharge, in percent, joins halfway.
    fn confluence(share: u32) -> Network {
        let mut network = river(&straight((0.0, 500.0), (200.0, 500.0), 200), 0.0).with_arm(
            &straight((100.0, 400.0), (100.0, 499.0), 99),
            100,
            share,
        );
        network.vertices[..100].iter_mut().for_each(|vertex| vertex.discharge = 100 - share);
        network
    }

    fn widened(mut network: Network, bank_variation: f32) -> Network {
        widen(&mut network, &NetworkSettings { bank_variation, total_discharge: 100, max_width: 10.0, ..settings() });
        network
    }

    #[test]
    fn squared_widths_add_where_rivers_join() {
        for share in [10, 30, 50] {
            let network = widened(confluence(share), 0.0);
            let [above, arm, below] = [99, 299, 101].map(|i| network.vertices[i].width());
            assert!((above * above + arm * arm - below * below).abs() < 1e-3, "{above}² + {arm}² = {below}²");
            assert_eq!(below, 10.0);
        }
    }

    #[test]
    fn no_river_is_narrower_than_the_arms_it_has_taken_in() {
        // As banks vary, an arm may be wider just above its end than the river is just below it; here it is by far.
        let mut network = confluence(50);
        network.vertices[..201].iter_mut().for_each(|vertex| vertex.discharge = 20);
        let network = widened(network, 0.0);
        let [arm, junction, mouth] = [299, 100, 200].map(|i| network.vertices[i].width());
        assert!(arm > 7.0 && junction >= arm && mouth >= arm, "{arm} {junction} {mouth}");
    }

    #[test]
    fn rivers_begin_as_nothing_and_widen_soon() {
        let network = widened(confluence(30), 0.0);
        let widths: Vec<f32> = network.vertices[..100].iter().map(Vertex::width).collect();
        assert!(widths[0] == 0.0 && widths.is_sorted() && widths[8] == widths[99]);
    }

    #[test]
    fn banks_vary_each_for_itself_and_within_bounds() {
        let network = widened(confluence(30), 0.3);
        let below: Vec<&Vertex> = network.vertices[120..200].iter().collect();
        assert!(below.iter().any(|vertex| (vertex.left - vertex.right).abs() > 0.2));
        assert!(below.iter().all(|vertex| (vertex.left - 5.0).abs() < 2.5 && (vertex.right - 5.0).abs() < 2.5));
    }

    #[test]
    fn a_new_junction_is_as_wide_as_its_arms_and_so_is_all_below() {
        let mut network = widened(confluence(30), 0.0);
        settle(&mut network, 0, 50, 4.9);
        let half = |i: usize| network.vertices[i].left;
        assert!(half(49) < 4.9 && half(50) == 4.9 && half(99) == 4.9 && half(101) == 5.0);
    }
}
