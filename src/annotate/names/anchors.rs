//! The places in the plane by which names of places are dealt. They depend on the seed alone and not on the map, so that a
//! place which moves a little, or is no longer the largest but one of its kind, keeps its name.

use glam::Vec2;

use super::PlaceKind;
use super::places::Place;
use super::squares::Squares;
use crate::base::random::ItemHash;

/// Squares with an anchor of each kind. The larger they are, the fewer places come nearer to another anchor by moving; if several places of
/// a kind share one, they depend on each other.
const SQUARES: Squares = Squares(112.0);

/// The share of a square, across, in which its anchor may lie.
const JITTER: f32 = 0.8;

/// The items of the chances of anchors.
const ANCHOR: u32 = 1 << 19;

/// The number of an anchor of a kind.
pub(super) type Anchor = [u32; 2];

/// Chooses an anchor for each place: the nearest of those around it that no place before it has chosen. A square has as many of a kind, in
/// turn, as are needed.
pub(super) fn of(places: &[Place], chance: ItemHash) -> Vec<Anchor> {
    let mut chosen = Vec::new();
    for place in places {
        let kind = kind_of(place.found.kind);
        let layers = (0..=places.len() as u32).map(|layer| nearest(place.found.at, [kind, layer], chance, &chosen));
        let anchor = layers.flatten().next();
        chosen.push(anchor.unwrap_or([u32::MAX, kind]));
    }
    chosen
}

/// Returns the number of a kind of anchor. A gulf that a little more land makes a bay keeps its name.
fn kind_of(kind: PlaceKind) -> u32 {
    if kind == PlaceKind::Gulf { PlaceKind::Bay as u32 } else { kind as u32 }
}

/// Returns the nearest free anchor of a layer in the nine squares around a place.
fn nearest(at: Vec2, [kind, layer]: [u32; 2], chance: ItemHash, chosen: &[Anchor]) -> Option<Anchor> {
    let [column, row] = SQUARES.cell(at);
    let mut best = (f32::INFINITY, None);
    // By one more: squares beside the map have anchors, too.
    for (column, row) in (row..=row + 2).flat_map(|row| (column..=column + 2).map(move |column| (column, row))) {
        let anchor = [row << 10 | column | layer << 20, kind];
        let jitter = [0, 1].map(|axis| JITTER * (chance.unit([anchor[0], kind, ANCHOR + axis]) - 0.5));
        let there = (Vec2::new(column as f32, row as f32) - 0.5 + Vec2::from(jitter)) * SQUARES.0;
        let away = at.distance(there);
        if away < best.0 && !chosen.contains(&anchor) {
            best = (away, Some(anchor));
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::super::regions::Found;
    use super::*;
    use crate::base::random::{Purpose, Seed};
    use crate::land::Region;

    fn place(kind: PlaceKind, x: f32, y: f32) -> Place {
        let found = Found { kind, at: Vec2::new(x, y), line: vec![], size: 50.0 };
        Place { found, region: Region::default(), rank: 1, extent: 50.0 }
    }

    fn anchors(places: &[Place]) -> Vec<Anchor> {
        of(places, Seed::from_text("kauri").item_hash(Purpose::Names))
    }

    #[test]
    fn a_place_that_moves_a_little_mostly_keeps_its_anchor_and_one_that_moves_far_does_not() {
        let at = |i: u32| [120.0 + 37.0 * (i % 25) as f32, 120.0 + 29.0 * (i / 25) as f32];
        let kept = |by: f32| {
            let is_kept = |&i: &u32| {
                let [x, y] = at(i);
                anchors(&[place(PlaceKind::Cape, x, y)]) == anchors(&[place(PlaceKind::Cape, x + by, y)])
            };
            (0..500).filter(is_kept).count()
        };
        assert!(kept(4.0) >= 465 && kept(300.0) == 0, "{} {}", kept(4.0), kept(300.0));
    }

    #[test]
    fn no_two_places_share_an_anchor_and_a_gulf_has_that_of_a_bay() {
        let crowd: Vec<Place> = (0..60).map(|i| place(PlaceKind::Island, 400.0 + i as f32, 300.0)).collect();
        let mut all = anchors(&crowd);
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), crowd.len());
        let [gulf, bay] = [PlaceKind::Gulf, PlaceKind::Bay].map(|kind| anchors(&[place(kind, 500.0, 300.0)]));
        assert_eq!(gulf, bay);
        assert_ne!(bay, anchors(&[place(PlaceKind::Cape, 500.0, 300.0)]));
        assert_eq!(anchors(&[place(PlaceKind::Cape, 1e9, f32::NAN)]).len(), 1);
    }
}
