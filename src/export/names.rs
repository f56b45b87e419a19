//! Names in files of data.

use glam::Vec2;

use super::data::{Json, Members};
use crate::annotate::names::{Names, PlaceKind, PlaceName, ReachName, RiverName};

/// Writes a name as JSON: null if it is empty.
pub(super) fn name<'a>(name: &str) -> Json<'a> {
    if name.is_empty() { Json::Null } else { Json::Owned(name.into()) }
}

/// Adds the number by which names know a river for JSON.
pub(super) fn identity<'a>(members: &mut Members<'a>, river: Option<&RiverName>) {
    if let Some(river) = river {
        members.whole("identity", river.identity);
    }
}

/// Adds a river's name for JSON.
pub(super) fn river<'a>(members: &mut Members<'a>, river: Option<&RiverName>) {
    if let Some(river) = river {
        members.value("name", name(&river.name));
    }
}

/// Adds a river's name for GeoJSON.
pub(super) fn river_feature<'a>(members: &mut Members<'a>, named: Option<&RiverName>) {
    river(members, named);
    if let Some(named) = named {
        members.owned("kind_name", named.kind.clone());
    }
}

/// Adds the map's title for GeoJSON.
pub(super) fn title<'a>(members: &mut Members<'a>, names: &Names) {
    if !names.title.is_empty() {
        members.owned("title", names.title.clone());
    }
}

/// Writes all names except those of rivers as a list for JSON.
pub(super) fn list<'a>(names: Names) -> Json<'a> {
    let Names { reaches, places, title, .. } = names;
    let entry = |kind, identity, text: &str| {
        let mut members = Members::default();
        members.text("kind", kind).value("identity", identity).value("text", name(text));
        Json::from(members)
    };
    let (first_place, last) = (1 + reaches.len(), 1 + reaches.len() + places.len());
    Json::list(last, move |i| match (i.checked_sub(1), i.checked_sub(first_place)) {
        (_, Some(i)) => entry(places[i].kind.word(), Json::Whole(places[i].number.into()), &places[i].name),
        (Some(i), _) => entry("reach", Json::Whole(reaches[i].identity.into()), &reaches[i].name),
        _ => entry("title", Json::Null, &title),
    })
}

/// The parts of a GeoJSON feature: its id, its position, and its properties.
pub(super) enum Feature<'a, 'b> {
    Line(String, &'b [Vec2], Members<'a>),
    Point(String, Vec2, Members<'a>),
}

/// Makes the feature of name `i` of those that do not belong to a river, reaches as lines, then places as points.
pub(super) fn feature<'a, 'b>(names: &'b Names, i: usize) -> Feature<'a, 'b> {
    match i.checked_sub(names.reaches.len()) {
        None => reach(&names.reaches[i]),
        Some(i) => place(&names.places[i]),
    }
}

/// Adds the name of the lake in whose water a point lies, for GeoJSON; null if there is none.
pub(super) fn lake<'a>(members: &mut Members<'a>, names: &Names, is_here: impl Fn(Vec2) -> bool) {
    let named = names.places.iter().find(|place| place.kind == PlaceKind::Lake && is_here(place.at));
    members.value("name", name(named.map_or("", |place| &place.name)));
}

fn reach<'a, 'b>(reach: &'b ReachName) -> Feature<'a, 'b> {
    let mut properties = Members::default();
    properties.text("kind", "reach").whole("number", reach.river).whole("river", reach.river);
    properties.value("reach_name", name(&reach.name));
    Feature::Line(format!("reach-{}", reach.river), &reach.course, properties)
}

fn place<'a, 'b>(place: &'b PlaceName) -> Feature<'a, 'b> {
    let mut properties = Members::default();
    properties.text("kind", place.kind.word()).whole("number", place.number).value("name", name(&place.name));
    Feature::Point(format!("{}-{}", place.kind.word(), place.number), place.at, properties)
}
