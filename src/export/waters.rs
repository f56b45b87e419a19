//! Lakes and deltas as JSON, beside the rivers that they belong to.

use glam::Vec2;

use super::data::{Json, Members};
use super::names;
use crate::annotate::names::PlaceName;
use crate::deltas::{Delta, Distributary};
use crate::lakes::{Lake, Passage};
use crate::map::Map;
use crate::network::Place;

/// Adds the lakes that a river passes, if there are any: the number of each, with the first and the last point in it.
pub(super) fn passages<'a>(members: &mut Members<'a>, map: &Map, river: usize) {
    let passages = map.lakes().passages(map.network(), &map.network().rivers[river]);
    let count = passages.len();
    if count > 0 {
        let passage = move |i: usize| {
            let Passage { lake, points: [first, last], .. } = passages[i];
            Json::wholes([lake, first, last].map(|number| number as u32).to_vec())
        };
        members.value("lakes", Json::list(count, passage));
    }
}

/// Makes the JSON of a lake.
pub(super) fn lake<'a>(map: &'a Map, id: usize, named: &[PlaceName]) -> Json<'a> {
    let Lake { identity, at, level, depth, area, outlet, rings, .. } = &map.lakes().list[id];
    let river = &map.network().rivers[outlet.river as usize];
    let mut place = Members::default();
    place.whole("river", outlet.river).whole("point", outlet.vertex - river.start);
    let mut members = Members::default();
    members
        .whole("id", id as u32)
        .whole("identity", *identity)
        .value("name", names::name(named.iter().find(|place| place.at == *at).map_or("", |place| &place.name)))
        .text("kind", "through")
        .single("level", *level)
        .single("depth", *depth)
        .single("area", *area)
        .object("outlet", place)
        .value("rings", Json::list(rings.len(), move |i| ring(&rings[i])));
    members.into()
}

/// Makes the JSON of a branch of a river in its delta.
pub(super) fn distributary<'a>(branch: &Distributary) -> Json<'a> {
    let mut members = Members::default();
    members.whole("id", branch.id).whole("river", branch.river);
    match branch.parent {
        Some(parent) => members.whole("parent", parent),
        None => members.value("parent", Json::Null),
    };
    let point = |place: &Place| [place.at.x, place.at.y, 2.0 * place.half];
    members
        .single("share", branch.share)
        .value("sea", Json::Truth(branch.reaches_sea))
        .value("points", Json::points(branch.line.iter().map(point).collect()));
    members.into()
}

/// Makes the JSON of the land that a river has built.
pub(super) fn delta(delta: &Delta) -> Json<'_> {
    let Delta { river, apex, waves, area, rings } = delta;
    let mut members = Members::default();
    members
        .whole("river", *river)
        .value("apex", Json::singles(apex.to_array().to_vec()))
        .single("waves", *waves)
        .single("area", *area)
        .value("rings", Json::list(rings.len(), move |i| ring(&rings[i])));
    members.into()
}

fn ring(ring: &[Vec2]) -> Json<'_> {
    Json::list(ring.len(), |i| Json::singles(ring[i].to_array().to_vec()))
}
