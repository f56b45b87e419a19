//! The order in which simplification removes vertices: one ranking for all rivers, made once, so that any degree of
//! simplification removes a prefix of it.
//!
//! The method is that of Visvalingam and Whyatt, but spikes count for less. A network has rules of its own: sources,
//! mouths and junctions stay; a vertex goes only while its triangle with its neighbours contains no other vertex, so
//! that the line cannot come to cross another, nor so near to one that rounding could make them cross; and only if the
//! line that is left stays on land.

use glam::Vec2;

use super::smooth::LEAST_CLEARANCE;
use super::{NONE, Network, Vertex};
use crate::base::geometry::{height, is_in_triangle};
use crate::base::simplify::{Lines, Place, area_unless_spike};
use crate::base::work;
use crate::land::Land;

/// Ranks the vertices that simplification may remove, the first to go first; simplified lines stay on `land`.
pub(super) fn rank(network: &Network, land: Option<&Land>) -> Vec<u32> {
    let places = places(network);
    let cells = Cells::new(&places);
    let mut order = Vec::with_capacity(places.len());
    Lines::new(places, area_unless_spike).simplify(
        |lines, triangle| {
            let corners @ [a, _, c] = triangle.map(|i| lines.at(i));
            land.is_none_or(|land| land.allows(a, c))
                && cells.is_clear(corners, |other| lines.is_gone(other) || triangle.contains(&other))
        },
        |gone, _| order.push(gone),
    );
    order
}

/// Returns a network without a share, from 0 to 1, of the ranked vertices.
pub(super) fn simplified(network: &Network, ranking: &[u32], share: f32) -> Network {
    let count = (ranking.len() as f32 * share) as usize;
    let mut stays = vec![true; network.vertices.len()];
    ranking.iter().take(count).for_each(|&vertex| stays[vertex as usize] = false);
    let mut place = Vec::with_capacity(stays.len() + 1);
    let mut left = 0;
    for &stays in &stays {
        place.push(left);
        left += u32::from(stays);
    }
    place.push(left);
    let mut simplified = network.clone();
    simplified.vertices = network.vertices.iter().zip(&stays).filter(|(_, stays)| **stays).map(|(v, _)| *v).collect();
    for river in &mut simplified.rivers {
        (river.start, river.end) = (place[river.start as usize], place[river.end as usize]);
        river.junction = place.get(river.junction as usize).copied().unwrap_or(NONE);
    }
    simplified
}

/// Returns all vertices, each with its neighbours along the course; those that have to stay have none upstream.
fn places(network: &Network) -> Vec<Place> {
    let place = |(i, (vertex, after)): (u32, (&Vertex, u32))| Place { at: vertex.at, before: i.wrapping_sub(1), after };
    let mut places: Vec<Place> = (0..).zip(network.vertices.iter().zip(network.downstream())).map(place).collect();
    for river in network.rivers.iter().filter(|river| river.end > river.start) {
        places[river.start as usize].before = NONE;
    }
    for (place, _) in places.iter_mut().zip(network.junctions()).filter(|(_, is_junction)| *is_junction) {
        // Without a neighbour upstream a junction is no triangle's middle, and so stays.
        place.before = NONE;
    }
    places
}

/// Points sorted into the cells of a grid, with their positions, so that a row of cells is one run in memory.
struct Cells {
    starts: Vec<u32>,
    points: Vec<(Vec2, u32)>,
    columns: usize,
    rows: usize,
    side: f32,
    corner: Vec2,
}

impl Cells {
    fn new(places: &[Place]) -> Self {
        let corner = places.iter().fold(Vec2::INFINITY, |least, place| least.min(place.at));
        let size = (places.iter().fold(corner, |most, place| most.max(place.at)) - corner).max(Vec2::ONE);
        let side = (size.x * size.y / (places.len() + 1) as f32).sqrt().max(size.max_element() / 4096.0);
        let (columns, rows) = ((size.x / side) as usize + 1, (size.y / side) as usize + 1);
        let (starts, points) = (vec![0; columns * rows + 1], vec![(corner, NONE); places.len()]);
        let mut this = Self { starts, points, columns, rows, side, corner };
        for place in places {
            let cell = this.cell(place.at);
            this.starts[cell] += 1;
        }
        let mut end = 0;
        for start in &mut this.starts {
            end += *start;
            *start = end;
        }
        for (i, place) in places.iter().enumerate().rev() {
            let cell = this.cell(place.at);
            this.starts[cell] -= 1;
            this.points[this.starts[cell] as usize] = (place.at, i as u32);
        }
        this
    }

    fn cell(&self, at: Vec2) -> usize {
        self.place(at.y, self.corner.y, self.rows) * self.columns + self.place(at.x, self.corner.x, self.columns)
    }

    fn place(&self, x: f32, from: f32, end: usize) -> usize {
        (((x - from) / self.side) as usize).min(end - 1)
    }

    /// Returns `true` if no point lies in a triangle or close to its side from the first corner to the last, except
    /// those that are apart.
    fn is_clear(&self, [a, b, c]: [Vec2; 3], mut is_apart: impl FnMut(u32) -> bool) -> bool {
        let (least, most) = (a.min(b).min(c) - LEAST_CLEARANCE, a.max(b).max(c) + LEAST_CLEARANCE);
        let left = self.place(least.x, self.corner.x, self.columns);
        let right = self.place(most.x, self.corner.x, self.columns);
        (self.place(least.y, self.corner.y, self.rows)..=self.place(most.y, self.corner.y, self.rows)).all(|row| {
            let run = self.starts[row * self.columns + left]..self.starts[row * self.columns + right + 1];
            work::count(1 + run.len());
            self.points[run.start as usize..run.end as usize].iter().all(|&(at, number)| {
                !(is_in_triangle(at, a, b, c) || height(at, a, c) < LEAST_CLEARANCE) || is_apart(number)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{places, river, sine_generated, sinuosity, straight};
    use super::*;

    #[test]
    fn what_is_least_seen_goes_first() {
        let points = [(0.0, 0.0), (10.0, 0.1), (20.0, 0.0), (30.0, 8.0), (40.0, 0.0)].map(Vec2::from);
        assert_eq!(rank(&river(&points, 1.0), None), [1, 2, 3]);
    }

    #[test]
    fn sources_mouths_and_junctions_stay() {
        let main = straight((0.0, 0.0), (80.0, 0.0), 8);
        let arm = straight((30.0, 50.0), (40.0, 10.0), 4);
        let network = river(&main, 1.0).with_arm(&arm, 4, 10);
        let ranking = rank(&network, None);
        let left = simplified(&network, &ranking, 1.0);
        assert_eq!(places(&left), [(0.0, 0.0), (40.0, 0.0), (80.0, 0.0), (30.0, 50.0)].map(Vec2::from));
        assert_eq!((left.rivers[1].start, left.rivers[1].junction), (3, 1));
    }

    #[test]
    fn a_line_never_comes_to_lie_across_another_river() {
        // The bend of one river goes round the source of the other.
        let bend = [(0.0, 0.0), (50.0, 40.0), (100.0, 0.0), (150.0, 0.0)].map(Vec2::from);
        let brook = [(50.0, 20.0), (60.0, -20.0), (110.0, -20.0)].map(Vec2::from);
        assert!(rank(&river(&bend, 1.0), None).contains(&1));
        assert!(!rank(&river(&bend, 1.0).with_arm(&brook, 3, 10), None).contains(&1));
    }

    #[test]
    fn any_degree_is_a_part_of_a_lesser_one() {
        let network = river(&sine_generated(1.2, 90.0, 3, 40), 1.0);
        let ranking = rank(&network, None);
        let mut before = places(&network);
        for percent in [10, 35, 60, 85, 100] {
            let left = places(&simplified(&network, &ranking, percent as f32 / 100.0));
            assert!(left.len() < before.len() && left.iter().all(|at| before.contains(at)), "{percent}");
            before = left;
        }
    }

    #[test]
    fn sine_generated_curve_keeps_its_sinuosity() {
        for degrees in [45.0f32, 70.0, 90.0, 110.0] {
            let omega = degrees.to_radians();
            let network = river(&sine_generated(omega, 100.0, 3, 200), 1.0);
            let ranking = rank(&network, None);
            let analytic = 1.0 / libm::j0f(omega);
            for percent in [20, 60, 90] {
                let left = places(&simplified(&network, &ranking, percent as f32 / 100.0));
                let measured = sinuosity(&left);
                assert!(
                    (measured / analytic - 1.0).abs() < 0.01,
                    "{degrees}°, {percent} %: {measured} is not {analytic}"
                );
            }
        }
    }
}
