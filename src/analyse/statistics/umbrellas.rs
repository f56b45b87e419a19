//! Umbrellas: trunks of similar size that meet at one place on the coast, which natural rivers do not do.

use glam::Vec2;

use super::index::Index;
use crate::base::geometry::distance;
use crate::base::sort;
use crate::network::{NONE, Network, River, Vertex};

/// Trunks that come together within this distance of a mouth meet there; in widths of the mouth.
const WIDTHS: f32 = 3.0;

/// Two trunks are similar if the smaller discharge is at least this share of the larger one.
const SIMILAR: f32 = 1.0 / 3.0;

/// Counts the trunks of similar size that meet at mouths. Of the trunks that come together within three widths of a
/// mouth, it counts all with at least a third of the greatest one's discharge, without that one. It also counts each
/// pair of similar mouths within three widths of the wider one.
pub fn umbrellas(network: &Network) -> u32 {
    let mouths = network.rivers.iter().filter(|river| river.junction == NONE && river.end > river.start);
    let mouths: Vec<&River> = mouths.collect();
    let arms = Arms::of(network);
    let at_mouths: usize = mouths.iter().map(|mouth| similar(&arms.above(mouth))).sum();
    (at_mouths + pairs(&mouths.iter().map(|mouth| network.vertices[mouth.end as usize - 1]).collect::<Vec<_>>())) as u32
}

/// Counts the trunks similar to the greatest, without that one.
fn similar(trunks: &[u32]) -> usize {
    let greatest = trunks.iter().copied().max().unwrap_or(0);
    trunks.iter().filter(|&&trunk| are_similar(trunk, greatest)).count().saturating_sub(1)
}

fn are_similar(a: u32, b: u32) -> bool {
    a.min(b) as f32 >= a.max(b) as f32 * SIMILAR
}

/// Counts the pairs of mouths that are similar and near each other.
fn pairs(mouths: &[Vertex]) -> usize {
    let places: Vec<Vec2> = mouths.iter().map(|mouth| mouth.at).collect();
    let mean = mouths.iter().map(Vertex::width).sum::<f32>() / mouths.len().max(1) as f32;
    let index = Index::new(&places, WIDTHS * mean);
    // The wider mouth of a pair finds the other; if both are equally wide, the first one does.
    let is_pair = |i: usize, j: usize| {
        let (own, other) = (mouths[i], mouths[j]);
        let looks = own.width() > other.width() || (own.width() == other.width() && i < j);
        looks && distance(own.at, other.at) < WIDTHS * own.width() && are_similar(own.discharge, other.discharge)
    };
    let of_mouth = |i: usize| index.around(places[i], WIDTHS * mouths[i].width()).filter(|&j| is_pair(i, j)).count();
    (0..mouths.len()).map(of_mouth).sum()
}

/// The rivers of a network, sorted by their junctions.
struct Arms<'a> {
    network: &'a Network,
    /// The numbers of the rivers, in the order of their junctions.
    by_junction: Vec<usize>,
}

impl<'a> Arms<'a> {
    fn of(network: &'a Network) -> Self {
        Self { network, by_junction: sort::argsort(network.rivers.iter().map(|river| river.junction)) }
    }

    fn joining(&self, vertex: u32) -> impl Iterator<Item = &'a River> + '_ {
        let rivers = &self.network.rivers;
        let first = self.by_junction.partition_point(|&river| rivers[river].junction < vertex);
        self.by_junction[first..].iter().map(|&river| &rivers[river]).take_while(move |river| river.junction == vertex)
    }

    /// Returns the discharges of all trunks three widths above a mouth, measured along their courses. Rivers with a
    /// nearer source do not count.
    fn above(&self, mouth: &River) -> Vec<u32> {
        let vertex = |vertex: u32| &self.network.vertices[vertex as usize];
        let mut trunks = Vec::new();
        // Open ways upstream: the source of the river, the vertex reached, and the distance left.
        let mut open = vec![(mouth.start, mouth.end - 1, WIDTHS * vertex(mouth.end - 1).width())];
        while let Some((source, here, far)) = open.pop() {
            if far <= 0.0 {
                trunks.push(vertex(here).discharge);
                continue;
            }
            let mut go_on = |source, next| open.push((source, next, far - distance(vertex(here).at, vertex(next).at)));
            self.joining(here).filter(|arm| arm.end > arm.start).for_each(|arm| go_on(arm.start, arm.end - 1));
            if here > source {
                go_on(source, here - 1);
            }
        }
        trunks
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Sample, into, network, to_sea};
    use super::*;

    /// ```text
    /// 20 ───────J──K────~   Two arms join a river of discharge 20: `a` at J, `above` units above its mouth,
    ///           │  │        and `b` at K, two units less. The mouth is 4 units wide.
    ///          `a` `b`
    /// ```
    fn fan(above: f32, a: u32, b: u32) -> u32 {
        let stem = [(0.0, 0.0), (100.0 - above, 0.0), (102.0 - above, 0.0), (100.0, 0.0)];
        let arms = [[(100.0 - above, 50.0)], [(102.0 - above, 50.0)]];
        umbrellas(&network(&[
            Sample { discharge: 20, width: 4.0, ..to_sea(&stem) },
            Sample { discharge: a, ..into(&arms[0], 0, 1) },
            Sample { discharge: b, ..into(&arms[1], 0, 2) },
        ]))
    }

    #[test]
    fn trunks_of_similar_size_count_that_meet_within_three_widths_of_a_mouth() {
        assert_eq!(fan(10.0, 20, 19), 2);
        // Just under a third of 20.
        assert_eq!(fan(10.0, 20, 6), 1);
        assert_eq!(fan(10.0, 6, 6), 0);
        // A third of the greatest is needed, whichever trunk that is.
        assert_eq!(fan(10.0, 61, 6), 0);
        // One joins 13 units above the mouth, the other 11; then 15 and 13.
        assert_eq!((fan(13.0, 20, 20), fan(15.0, 20, 20)), (1, 0));
    }

    #[test]
    fn mouths_of_similar_size_count_that_are_within_three_widths_of_the_wider() {
        let mouths = |apart: f32, discharge: u32| {
            let lines = [[(0.0, 50.0), (0.0, 0.0)], [(apart, 50.0), (apart, 0.0)]];
            umbrellas(&network(&[
                Sample { discharge: 30, width: 4.0, ..to_sea(&lines[0]) },
                Sample { discharge, width: 2.0, ..to_sea(&lines[1]) },
            ]))
        };
        assert_eq!((mouths(11.0, 10), mouths(13.0, 10), mouths(11.0, 9)), (1, 0, 0));
        assert_eq!(umbrellas(&Network::default()), 0);
    }
}
