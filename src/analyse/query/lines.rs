//! An index that finds the middle lines of all rivers by their place.

use glam::Vec2;

use crate::analyse::statistics::Index;
use crate::base::geometry::{distance, fast_max};
use crate::network::{Network, Place};

/// A place on a river.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The river's number.
    pub river: u32,
    /// The segment of its line, from one vertex to the next, counted from its source.
    pub segment: u32,
    /// The point on the middle line, and the distance to either bank.
    pub place: Place,
    /// Distance of the queried point from the bank, in units; negative on the water.
    pub off: f32,
}

/// The middle lines of all rivers.
#[derive(Debug)]
pub(super) struct CourseLines {
    /// The places of all rivers, one river after the other, from source to end.
    places: Vec<Place>,
    /// The position in `places` at which each river's line begins, and the end of the last one.
    starts: Vec<u32>,
    /// For each segment, the position in `places` of its first place, and its river.
    segments: Vec<(u32, u32)>,
    /// An index of the middles of segments.
    index: Index,
    /// The greatest distance of any bank from the middle of its segment.
    widest: f32,
}

impl CourseLines {
    pub fn new(network: &Network) -> Self {
        let (mut places, mut starts, mut segments) = (Vec::new(), vec![0], Vec::new());
        let (mut middles, mut widest) = (Vec::new(), 0.0);
        for (number, river) in (0..).zip(&network.rivers) {
            let line = network.middle(river);
            for (at, pair) in (places.len() as u32..).zip(line.windows(2)) {
                segments.push((at, number));
                middles.push((pair[0].at + pair[1].at) * 0.5);
                let half = fast_max(pair[0].half, pair[1].half);
                widest = fast_max(widest, distance(pair[0].at, pair[1].at) * 0.5 + half);
            }
            places.extend(line);
            starts.push(places.len() as u32);
        }
        Self { index: Index::new(&middles, widest), places, starts, segments, widest }
    }

    /// Returns the middle line of a river; empty if there is no such river.
    pub fn line(&self, river: u32) -> &[Place] {
        let [from, to] = [0, 1].map(|next| self.starts.get((river as usize).saturating_add(next)));
        from.zip(to).map_or(&[], |(&from, &to)| &self.places[from as usize..to as usize])
    }

    /// Returns the spot at a river's source; `None` if there is no such river.
    pub fn source(&self, river: u32) -> Option<Spot> {
        let &[place, _, ..] = self.line(river) else { return None };
        Some(Spot { river, segment: 0, place, off: 0.0 })
    }

    /// Returns the spot at a river's end; `None` if there is no such river.
    pub fn mouth(&self, river: u32) -> Option<Spot> {
        let &[.., _, place] = self.line(river) else { return None };
        Some(Spot { river, segment: self.line(river).len() as u32 - 2, place, off: 0.0 })
    }

    /// Finds the spot nearest to a point, of those whose bank is within reach. Among equally near spots the first
    /// river's wins.
    pub fn nearest(&self, at: Vec2, reach: f32) -> Option<Spot> {
        let mut nearest: Option<Spot> = None;
        if at.is_finite() && reach.is_finite() {
            for segment in self.index.around(at, reach + self.widest) {
                let spot = self.on(segment, at);
                let is_nearer = nearest.is_none_or(|best| {
                    let rank = (spot.river, spot.segment) < (best.river, best.segment);
                    spot.off < best.off || (spot.off == best.off && rank)
                });
                if spot.off <= reach && is_nearer {
                    nearest = Some(spot);
                }
            }
        }
        nearest
    }

    /// Returns the spot on a segment that is nearest to a point.
    fn on(&self, segment: usize, at: Vec2) -> Spot {
        let (first, river) = self.segments[segment];
        let [from, to] = [self.places[first as usize], self.places[first as usize + 1]];
        let along = to.at - from.at;
        let share = (at - from.at).dot(along) / fast_max(along.length_squared(), f32::MIN_POSITIVE);
        let share = share.clamp(0.0, 1.0);
        let place = Place { at: from.at.lerp(to.at, share), half: from.half + (to.half - from.half) * share };
        let off = distance(at, place.at) - place.half;
        Spot { river, segment: first - self.starts[river as usize], place, off }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use crate::recipe::link;
    use crate::session::Session;
    use proptest::prelude::*;

    fn lines(growth: &str) -> CourseLines {
        let text = format!("seed=kea&land=island&growth={growth}&attractors=900&meander-rounds=8&width=40");
        let mut session = Session::new(link::read(&text).unwrap()).unwrap();
        CourseLines::new(session.finish().unwrap().network())
    }

    /// Returns how far a point is off the nearest spot, by looking at every segment; `None` if that is out of reach.
    fn nearest_of_all(lines: &CourseLines, at: Vec2, reach: f32) -> Option<f32> {
        let off = (0..lines.segments.len()).map(|segment| lines.on(segment, at).off);
        Some(off.fold(f32::INFINITY, f32::min)).filter(|&off| off <= reach)
    }

    #[test]
    fn the_nearest_river_is_that_of_a_search_through_all() {
        for lines in ["drainage", "colonize", "brownian"].map(lines) {
            proptest!(cases(400), |(x in -100f32..1400.0, y in -100f32..1100.0, reach in 0f32..80.0)| {
                let at = Vec2::new(x, y);
                let found = lines.nearest(at, reach);
                prop_assert_eq!(found.map(|spot| spot.off), nearest_of_all(&lines, at, reach));
                if let Some(spot) = found {
                    let line = lines.line(spot.river);
                    let [from, to] = [line[spot.segment as usize], line[spot.segment as usize + 1]];
                    prop_assert!((distance(from.at, spot.place.at) + distance(spot.place.at, to.at) - distance(from.at, to.at)).abs() < 0.01);
                }
            });
        }
    }

    #[test]
    fn what_is_no_place_has_no_river() {
        let lines = lines("drainage");
        for at in [Vec2::NAN, Vec2::INFINITY] {
            assert_eq!(lines.nearest(at, 10.0), None);
            assert_eq!(lines.nearest(Vec2::ZERO, at.x), None);
        }
        assert_eq!(CourseLines::new(&Network::default()).nearest(Vec2::ZERO, 1e6), None);
    }
}
