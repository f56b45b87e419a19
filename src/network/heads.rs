//! Heads without hooks: a brook that drains a few parcels only has no room for the bends of a river.
//!
//! The flow that bends the plane (`grow/drainage/bends.rs`) folds short lines as it does long ones, and a brook of two spacings
//! comes out as a fishhook. Where it turns so much within a short way, each place moves to the mean of the course around
//! it, over a stretch that is shorter the more water there is: no order enters, so the head of a trunk is treated
//! like a brook.

use glam::Vec2;

use super::turns::greatest_turns;
use super::{Network, NetworkSettings};
use crate::base::geometry::{fast_max, fast_min, smooth_step};

/// The stretch of the mean, as the deviation of its weights: in vertices, where at most so many parcels are drained.
const STRETCH: f32 = 7.0;
const PARCELS: f32 = 16.0;

/// The least stretch that moves anything, in vertices.
const SHORTEST: f32 = 0.35;

/// The way within which turns count, in vertices.
const WITHIN: f32 = 16.0;

/// The turns from which on a place begins to move, and moves all the way, in degrees.
const GENTLE: f32 = 100.0;
const SHARP: f32 = 130.0;

/// Unfolds the hooks of all courses: moves the targets that vertices are smoothed to. Returns for each vertex `true` if its
/// target has moved.
pub(super) fn unhook(network: &Network, targets: &mut [Vec2], settings: &NetworkSettings) -> Vec<bool> {
    let mut has_moved = vec![false; targets.len()];
    let read = targets.to_vec();
    for river in &network.rivers {
        let own = river.vertex_range();
        let course: Vec<Vec2> =
            own.clone().chain([river.junction as usize]).filter_map(|i| read.get(i).copied()).collect();
        let turns = greatest_turns(&course, WITHIN * settings.spacing);
        let mut shares: Vec<f32> =
            turns.iter().map(|turn| smooth_step((turn.to_degrees() - GENTLE) / (SHARP - GENTLE))).collect();
        let mut stretches: Vec<f32> = own.clone().map(|i| stretch(network.vertices[i].discharge)).collect();
        spread(&mut shares);
        ease(&mut stretches);
        for (place, i) in own.enumerate() {
            if stretches[place] >= SHORTEST && shares[place] > 0.0 {
                let target = read[i].lerp(mean(&course, place, stretches[place]), shares[place]);
                targets[i] = target.max(Vec2::ZERO).min(settings.domain.size);
                has_moved[i] = true;
            }
        }
    }
    has_moved
}

/// Returns the deviation of the weights of the mean at a vertex that drains some parcels, in vertices.
fn stretch(parcels: u32) -> f32 {
    let share = fast_min(PARCELS / parcels.max(1) as f32, 1.0);
    STRETCH * share * share
}

/// Spreads shares to both sides, less and less, so that no place moves without its neighbours.
fn spread(shares: &mut [f32]) {
    /// The greatest difference between neighbours.
    const STEP: f32 = 0.125;
    for i in 1..shares.len() {
        shares[i] = fast_max(shares[i], shares[i - 1] - STEP);
    }
    for i in (1..shares.len()).rev() {
        shares[i - 1] = fast_max(shares[i - 1], shares[i] - STEP);
    }
}

/// Shortens stretches above a confluence, below which there is more water, so that the course has no corner there.
fn ease(stretches: &mut [f32]) {
    /// The greatest fall from a vertex to the next.
    const FALL: f32 = 0.7;
    for i in (1..stretches.len()).rev() {
        stretches[i - 1] = fast_min(stretches[i - 1], stretches[i] + FALL);
    }
}

/// Returns the mean of a course around one of its places, with the weights of a Gaussian. Beyond its ends the course goes on as its
/// own mirror image, turned around the end, so that both ends stay.
fn mean(course: &[Vec2], place: usize, stretch: f32) -> Vec2 {
    /// The reach of the weights, in deviations.
    const REACH: f32 = 2.5;
    let (mut sum, mut weights) = (course[place], 1.0);
    for off in 1..=(REACH * stretch).ceil() as i32 {
        let away = off as f32 / stretch;
        let weight = libm::expf(-0.5 * away * away);
        sum += (around(course, place as i32 - off) + around(course, place as i32 + off)) * weight;
        weights += 2.0 * weight;
    }
    sum / weights
}

/// Returns a place of a course that is continued beyond its ends, each time as the mirror image of what lies before the end.
fn around(course: &[Vec2], place: i32) -> Vec2 {
    let last = course.len() as i32 - 1;
    match place {
        place if place < 0 => 2.0 * course[0] - around(course, -place),
        place if place > last => 2.0 * course[last as usize] - around(course, 2 * last - place),
        place => course[place as usize],
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{river, settings, straight};
    use super::*;

    /// A hook: down, round and back up, over a little more than the way within which turns count.
    const HOOK: [(f32, f32); 8] = [
        (100.0, 100.0),
        (103.0, 100.0),
        (106.0, 101.0),
        (107.0, 104.0),
        (106.0, 107.0),
        (103.0, 108.0),
        (100.0, 108.0),
        (97.0, 108.0),
    ];

    /// Unhooks a line on which the water of so many parcels runs. Returns the line, and for each of its places if it has moved.
    fn unhooked(line: &[Vec2], parcels: u32) -> (Vec<Vec2>, Vec<bool>) {
        let mut network = river(line, 1.0);
        network.vertices.iter_mut().for_each(|vertex| vertex.discharge = parcels);
        let mut targets = line.to_vec();
        let has_moved = unhook(&network, &mut targets, &settings());
        (targets, has_moved)
    }

    fn sharpest(line: &[Vec2]) -> f32 {
        greatest_turns(line, WITHIN).into_iter().fold(0.0, f32::max).to_degrees()
    }

    #[test]
    fn hook_of_a_brook_opens_and_its_ends_stay() {
        let hook = HOOK.map(Vec2::from);
        let (line, has_moved) = unhooked(&hook, 3);
        assert!(sharpest(&hook) > 170.0 && sharpest(&line) < 90.0, "{} to {}", sharpest(&hook), sharpest(&line));
        assert!(has_moved[1..7].iter().all(|moved| *moved));
        assert!(line[0].distance(hook[0]) < 1e-3 && line[7].distance(hook[7]) < 1e-3);
    }

    #[test]
    fn more_water_opens_it_less_and_a_river_keeps_it() {
        let hook = HOOK.map(Vec2::from);
        let turns = [3, 16, 30, 60].map(|parcels| sharpest(&unhooked(&hook, parcels).0));
        assert!(turns.windows(2).all(|pair| pair[0] <= pair[1]) && turns[0] < turns[3], "{turns:?}");
        assert_eq!(unhooked(&hook, 80), (hook.to_vec(), vec![false; 8]));
    }

    #[test]
    fn stretches_are_as_short_above_a_confluence_as_below_and_lengthen_from_there_up() {
        let mut stretches = [7.0, 7.0, 7.0, 0.6, 0.6];
        ease(&mut stretches);
        assert!(
            stretches.iter().zip([2.7, 2.0, 1.3, 0.6, 0.6]).all(|(one, asked)| (one - asked).abs() < 1e-5),
            "{stretches:?}"
        );
    }

    #[test]
    fn neighbours_of_what_moves_move_with_it_less_and_less() {
        let mut shares = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        spread(&mut shares);
        assert_eq!(shares, [0.75, 0.875, 1.0, 0.875, 0.75, 0.625]);
    }

    #[test]
    fn gentle_bends_stay() {
        let bend: Vec<Vec2> =
            (0..20).map(|i| Vec2::new(100.0 + i as f32, 100.0 + 3.0 * libm::sinf(i as f32 * 0.3))).collect();
        assert_eq!(unhooked(&bend, 3).0, bend);
    }

    #[test]
    fn tributary_keeps_its_junction() {
        let hook = HOOK.map(Vec2::from);
        let network = river(&straight((90.0, 112.0), (120.0, 112.0), 30), 1.0).with_arm(&hook, 5, 3);
        let mut targets: Vec<Vec2> = network.vertices.iter().map(|vertex| vertex.at).collect();
        let before = targets.clone();
        let has_moved = unhook(&network, &mut targets, &settings());
        assert_eq!(targets[..31], before[..31], "the river");
        assert!(has_moved[33..38].iter().all(|moved| *moved), "the brook");
        let last = targets[38].distance(before[5]) / before[38].distance(before[5]);
        assert!((0.3..2.0).contains(&last), "{last}");
    }
}
