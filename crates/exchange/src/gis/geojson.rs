//! GeoJSON as it was asked for: with segments of rivers, or with all positions in two dimensions.

use std::io::{Result, Write};

use riverseed::Map;
use riverseed::analyse::statistics::Drained;
use riverseed::export::{Json, geojson};
use riverseed::scale::MapScale;

use super::segments::{self, Segment};

/// Writes the features of a map, with segments if asked, and flat if asked: without heights.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(mut out: impl Write, map: &Map, has_segments: bool, is_flat: bool) -> Result<()> {
    serde_json::to_writer(&mut out, &collection(map, has_segments, is_flat)?)?;
    writeln!(out)
}

/// Writes the beginning of such a file, which tells it from others.
pub fn head(link: &str, has_segments: bool, is_flat: bool) -> String {
    let link = serde_json::Value::from(link);
    let more: String = more(has_segments, is_flat).map(|name| format!("\"{name}\":true,")).collect();
    format!("{{\"type\":\"FeatureCollection\",\"riverseed\":{link},{more}\"bbox\":")
}

/// Lists the members of the collection that say what was asked for.
fn more(has_segments: bool, is_flat: bool) -> impl Iterator<Item = &'static str> {
    [("segments", has_segments), ("flat", is_flat)].into_iter().filter(|(_, is_asked)| *is_asked).map(|(name, _)| name)
}

/// Makes the collection of a map.
///
/// # Errors
/// Fails if there is not enough memory.
pub(super) fn collection(map: &Map, has_segments: bool, is_flat: bool) -> Result<Json<'_>> {
    let plain = geojson::collection(map).map_err(std::io::Error::other)?;
    let mut collection = Vec::new();
    for (name, value) in members(plain) {
        match name {
            "bbox" => collection.extend(more(has_segments, is_flat).map(|name| (name, Json::Truth(true)))),
            "features" => {
                let features = if has_segments { with_segments(map, value)? } else { value };
                let features = if is_flat { each(features, flat) } else { features };
                collection.push((name, features));
                continue;
            }
            _ => {}
        }
        collection.push((name, value));
    }
    Ok(Json::Object(collection))
}

/// Adds the segments after all features.
fn with_segments<'a>(map: &'a Map, features: Json<'a>) -> Result<Json<'a>> {
    let Json::List(count, feature) = features else { return Ok(features) };
    let segments = segments::of(map)?;
    let all = count + segments.len();
    let sizes = Sizes { scale: map.scale(), drained: Drained::of(map) };
    let with = move |i: usize| match i.checked_sub(count) {
        None => feature(i),
        // Rivers come first, and their positions are those of their segments.
        Some(at) => {
            let river = feature(segments[at].river as usize);
            of_segment(&segments[at], &sizes, [at as i64 + 1, i as i64 + 1], river)
        }
    };
    Ok(Json::List(all, Box::new(with)))
}

/// The scale of a map, and the land that drains to its rivers: all that the real sizes of segments depend on.
struct Sizes {
    scale: MapScale,
    drained: Drained,
}

/// Makes the feature of a segment from that of its river.
fn of_segment<'a>(segment: &Segment, sizes: &Sizes, [number, key]: [i64; 2], river: Json<'a>) -> Json<'a> {
    let course = items(member(member(river, "geometry"), "coordinates"));
    let line: Vec<Json<'_>> = course.into_iter().skip(segment.from).take(segment.to - segment.from + 1).collect();
    let whole = |number: u32| Json::Whole(number.into());
    let properties = vec![
        ("kind", Json::Text("segment")),
        ("number", Json::Whole(number)),
        ("from_node", whole(segment.from_node)),
        ("to_node", whole(segment.to_node)),
        ("next", whole(segment.next)),
        ("river", whole(segment.river)),
        ("order", whole(segment.order.into())),
        ("magnitude", whole(segment.magnitude)),
        ("discharge", whole(segment.discharge)),
        ("lateral", whole(segment.lateral)),
        ("length_m", Json::Double(sizes.scale.metres(segment.length).round())),
        ("width_m", rounded(sizes.drained.river_width(segment.discharge) as f32, 100.0)),
        ("area_m2", Json::Double(sizes.scale.square_metres(segment.area.into()).round())),
        ("key", Json::Whole(key)),
    ];
    Json::Object(vec![
        ("type", Json::Text("Feature")),
        ("id", Json::Owned(format!("segment-{number}"))),
        ("geometry", Json::Object(vec![("type", Json::Text("LineString")), ("coordinates", numbers_of(line))])),
        ("properties", Json::Object(properties)),
    ])
}

/// Makes a list of positions, which are made already.
fn numbers_of<'a>(line: Vec<Json<'a>>) -> Json<'a> {
    let line: Vec<Vec<f64>> = line.into_iter().map(position).collect();
    Json::List(line.len(), Box::new(move |i| doubles(line[i].clone())))
}

fn position(json: Json<'_>) -> Vec<f64> {
    items(json).iter().filter_map(number).collect()
}

fn doubles<'a>(numbers: Vec<f64>) -> Json<'a> {
    Json::List(numbers.len(), Box::new(move |i| Json::Double(numbers[i])))
}

/// Returns the feature without the heights of its positions.
fn flat(feature: Json<'_>) -> Json<'_> {
    in_member(feature, "geometry", |geometry| in_member(geometry, "coordinates", level))
}

/// Returns coordinates, nested however deep, with the first two numbers of each position.
fn level(coordinates: Json<'_>) -> Json<'_> {
    match coordinates {
        Json::List(count, item) if count > 0 && number(&item(0)).is_some() => Json::List(count.min(2), item),
        nested => each(nested, level),
    }
}

/// Changes one member of an object.
fn in_member<'a>(object: Json<'a>, name: &str, change: impl Fn(Json<'a>) -> Json<'a>) -> Json<'a> {
    let changed = |(own, value)| (own, if own == name { change(value) } else { value });
    Json::Object(members(object).into_iter().map(changed).collect())
}

/// Changes each item of a list, when it is written.
fn each<'a>(list: Json<'a>, change: impl Fn(Json<'a>) -> Json<'a> + 'a) -> Json<'a> {
    match list {
        Json::List(count, item) => Json::List(count, Box::new(move |i| change(item(i)))),
        other => other,
    }
}

/// Rounds a number to a fraction of its unit.
fn rounded<'a>(x: f32, parts: f64) -> Json<'a> {
    Json::Double((f64::from(x) * parts).round() / parts)
}

/// Returns the number that a value is.
pub(super) fn number(json: &Json<'_>) -> Option<f64> {
    match json {
        Json::Whole(whole) => Some(*whole as f64),
        Json::Single(single) => Some(f64::from(*single)),
        Json::Double(double) => Some(*double),
        _ => None,
    }
}

fn member<'a>(object: Json<'a>, name: &str) -> Json<'a> {
    members(object).into_iter().find(|(own, _)| *own == name).map_or(Json::Null, |(_, value)| value)
}

pub(super) fn members(json: Json<'_>) -> Vec<(&'static str, Json<'_>)> {
    if let Json::Object(members) = json { members } else { Vec::new() }
}

pub(super) fn items(json: Json<'_>) -> Vec<Json<'_>> {
    if let Json::List(count, item) = json { (0..count).map(item).collect() } else { Vec::new() }
}
