//! Starts: the drawn mouths (the paper's start nodes), each with the drawn course of its river. Where there are any,
//! there are no other mouths, and land without one stays dry.

use std::sync::Arc;

use glam::Vec2;

use super::mouth::Mouth;
use crate::base::geometry::distance;
use crate::base::work;
use crate::domain::Domain;
use crate::land::{Cell, Land, divided, in_units};
use crate::recipe::Recipe;

/// A drawn mouth.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The place on a coast nearest to the point where the drawn river enters the land; on a plain rectangle, a place
    /// on the border.
    pub mouth: Mouth,
    /// The points of the river's course from its mouth on, up to 2 units apart, as far as it runs over land. Empty if
    /// only a mouth is drawn.
    pub course: Vec<Vec2>,
}

/// The greatest distance between points of a course, in units.
pub(in crate::grow) const PIECE: f32 = 2.0;

/// The total length to which courses are followed, in units: ten times across the map. A longer drawing would be a
/// scribble.
const LONGEST: f32 = 8_000.0;

/// A course that has just come ashore may touch water once more within this number of points. It is connected to its
/// mouth after that.
const ASHORE: usize = 6;

/// Mouths that are closer together than this, in units, count as one.
const APART: f32 = 4.0;

/// Makes the starts of a recipe, in the order in which they are drawn.
pub(in crate::grow) fn starts(recipe: &Recipe, domain: &Domain, land: Option<&Land>) -> Arc<[Start]> {
    let of_rectangle = || in_units(recipe.rivers(), domain);
    let mut starts: Vec<Start> = Vec::new();
    let mut left = (LONGEST / PIECE) as usize;
    for mut line in land.map_or_else(of_rectangle, |land| land.rivers().to_vec()) {
        line.iter_mut().for_each(|at| *at = at.clamp(Vec2::ZERO, domain.size));
        if let Some(start) = start(&line, domain, land, left)
            && starts.iter().all(|other| distance(other.mouth.at, start.mouth.at) > APART)
        {
            left -= start.course.len();
            starts.push(start);
        }
    }
    starts.into()
}

/// Makes a start from a line, with a course of up to `most` points; `None` if there is no coast at all.
fn start(line: &[Vec2], domain: &Domain, land: Option<&Land>, most: usize) -> Option<Start> {
    let is_land = |at: &Vec2| land.is_none_or(|land| land.at(*at) == Cell::Land);
    let mut pieces = divided(line, PIECE, false).inspect(|_| work::count(1));
    let ashore = if line.len() > 1 { pieces.find(is_land) } else { None };
    let entry = ashore.or_else(|| line.first().copied())?;
    let mouth = match land {
        Some(land) => on_coast(land, entry)?,
        None => on_border(domain, entry),
    };
    let course = ashore.map(|ashore| course(mouth.at, ashore, &mut pieces, land, most));
    Some(Start { mouth, course: course.unwrap_or_default() })
}

/// Returns the course from a mouth to a point ashore and along the points after it, up to `most` of them, until water
/// or a ridge is in the way.
fn course(
    mouth: Vec2,
    ashore: Vec2,
    inland: &mut dyn Iterator<Item = Vec2>,
    land: Option<&Land>,
    most: usize,
) -> Vec<Vec2> {
    let mut ashore = vec![ashore];
    ashore.extend(inland.take(ASHORE - 1));
    let tied = ashore.iter().rposition(|&at| allows(land, mouth, at)).unwrap_or(0);
    let mut way: Vec<Vec2> = divided(&[mouth, ashore[tied]], PIECE, false).collect();
    way.extend(&ashore[tied + 1..]);
    way.extend(inland.take(most));
    way.truncate(most);
    let end = (1..way.len()).find(|&i| !allows(land, way[i - 1], way[i]));
    way.truncate(end.unwrap_or(most));
    way
}

#[inline(never)] // each copy weighs half a kilobyte
fn allows(land: Option<&Land>, from: Vec2, to: Vec2) -> bool {
    land.is_none_or(|land| land.allows(from, to))
}

/// Returns the mouth on a coast that is nearest to a point; `None` if there is no coast.
fn on_coast(land: &Land, point: Vec2) -> Option<Mouth> {
    let (mut nearest, mut least) = (None, f32::INFINITY);
    for region in land.regions() {
        for shore in &region.shores {
            let away = distance(shore.at, point);
            if away < least {
                (nearest, least) = (Some(Mouth { at: shore.at, inland: shore.inland }), away);
            }
        }
    }
    nearest
}

/// Returns the mouth on the border of a rectangle that is nearest to a point in it.
fn on_border(domain: &Domain, point: Vec2) -> Mouth {
    let sides = domain.sides(point).into_iter().zip([Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y, Vec2::X]);
    let nearest = sides.map(|((_, away), inland)| (away, inland));
    let (away, inland) = nearest.fold((f32::INFINITY, Vec2::Y), |a, b| if b.0 < a.0 { b } else { a });
    Mouth { at: (point - inland * away).clamp(Vec2::ZERO, domain.size), inland }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::{Key, link};

    /// Makes the starts of a smooth drawing on a square: a land from 200 to 800, with a lake from 440 to 560, and rivers.
    fn of(ridges: &[&[(f32, f32)]], rivers: &[&[(f32, f32)]]) -> (Arc<[Start]>, Option<Arc<Land>>) {
        let square = |near: f32, far: f32| vec![(near, near), (far, near), (far, far), (near, far)];
        on(&[&square(0.2, 0.8), &square(0.44, 0.56)], ridges, rivers)
    }

    fn on(
        coasts: &[&[(f32, f32)]],
        ridges: &[&[(f32, f32)]],
        rivers: &[&[(f32, f32)]],
    ) -> (Arc<[Start]>, Option<Arc<Land>>) {
        use crate::recipe::{GridPoint, Outline};
        let lines = |lines: &[&[(f32, f32)]]| {
            lines.iter().map(|line| line.iter().map(|&at| GridPoint::nearest(at.into())).collect()).collect()
        };
        let outline = Outline::new(lines(coasts), lines(ridges), lines(rivers)).unwrap();
        let recipe = link::read(&format!("land=drawn&roughness=0&aspect=1&outline={outline}")).unwrap();
        let land = Land::of(&recipe);
        (starts(&recipe, &Domain::of(&recipe), land.as_deref()), land)
    }

    fn near(at: Vec2, x: f32, y: f32) -> bool {
        at.distance(Vec2::new(x, y)) < 3.0
    }

    #[test]
    fn a_point_is_a_mouth_on_the_nearest_coast_wherever_it_lies() {
        for (point, mouth) in [((0.3, 0.5), (200.0, 500.0)), ((0.9, 0.4), (800.0, 400.0)), ((0.0, 0.0), (200.0, 200.0))]
        {
            let (starts, _) = of(&[], &[&[point]]);
            assert!(near(starts[0].mouth.at, mouth.0, mouth.1) && starts[0].course.is_empty(), "{:?}", starts[0].mouth);
        }
        let (starts, _) = of(&[], &[&[(0.5, 0.5)]]);
        let lake = (starts[0].mouth.at - 500.0).abs().max_element();
        assert!((59.0..62.0).contains(&lake), "{lake}");
    }

    #[test]
    fn a_line_enters_the_land_where_it_comes_ashore_and_is_tied_to_the_coast_where_it_begins_inland() {
        let (starts, _) = of(&[], &[&[(0.1, 0.3), (0.4, 0.35)], &[(0.25, 0.7), (0.4, 0.7)]]);
        assert!(
            near(starts[0].mouth.at, 200.0, 317.0) && near(starts[0].course[starts[0].course.len() - 1], 400.0, 350.0)
        );
        assert!(
            near(starts[1].mouth.at, 200.0, 700.0) && near(starts[1].course[starts[1].course.len() - 1], 400.0, 700.0)
        );
        for start in starts.iter() {
            assert!(start.course.windows(2).all(|pair| pair[0].distance(pair[1]) < PIECE + 0.01));
        }
    }

    #[test]
    fn a_course_ends_before_the_first_water_or_ridge_in_its_way() {
        let across: &[(f32, f32)] = &[(0.1, 0.5), (0.9, 0.5)];
        let end = |ridges: &[&[(f32, f32)]]| {
            let (starts, land) = of(ridges, &[across]);
            let course = &starts[0].course;
            assert!(course.windows(2).all(|pair| land.as_deref().unwrap().allows(pair[0], pair[1])));
            course[course.len() - 1].x
        };
        assert!((435.0..440.0).contains(&end(&[])), "{}", end(&[]));
        let ridge: &[(f32, f32)] = &[(0.35, 0.3), (0.35, 0.7)];
        assert!((345.0..350.0).contains(&end(&[ridge])), "{}", end(&[ridge]));
    }

    #[test]
    fn on_a_rectangle_rivers_start_at_the_nearest_border() {
        let (starts, land) = on(&[], &[], &[&[(0.3, 0.1)], &[(0.9, 0.4), (0.5, 0.5)], &[(0.2, 1.0)], &[(0.1, 0.6)]]);
        assert!(land.is_none());
        let mouths: Vec<(Vec2, Vec2)> = starts.iter().map(|start| (start.mouth.at, start.mouth.inland)).collect();
        let expected =
            [(300.0, 0.0, Vec2::Y), (1000.0, 400.0, Vec2::NEG_X), (200.0, 1000.0, Vec2::NEG_Y), (0.0, 600.0, Vec2::X)];
        for ((at, inland), (x, y, expected)) in mouths.into_iter().zip(expected) {
            assert!(near(at, x, y) && inland == expected, "{at} {inland}");
        }
        assert!(near(starts[1].course[0], 1000.0, 400.0));
    }

    #[test]
    fn mouths_at_one_place_are_one_and_scribbles_end() {
        let (starts, _) = of(&[], &[&[(0.1, 0.3)], &[(0.12, 0.3), (0.4, 0.3)], &[(0.1, 0.6)]]);
        assert_eq!(starts.len(), 2);
        let scribble: Vec<(f32, f32)> = (0..240).map(|i| (i as f32 / 240.0, (i % 2) as f32)).collect();
        let (starts, _) = on(&[], &[], &[&scribble]);
        assert_eq!(starts[0].course.len(), (LONGEST / PIECE) as usize);
    }

    #[test]
    fn a_scribble_is_looked_at_no_farther_than_it_is_followed() {
        let scribble: Vec<(f32, f32)> = (0..240).map(|i| (i as f32 / 240.0, (i % 2) as f32)).collect();
        let length: f32 = scribble.windows(2).map(|pair| 1000.0 * Vec2::from(pair[0]).distance(pair[1].into())).sum();
        assert!(length > 20.0 * LONGEST);
        let begun = work::steps();
        on(&[], &[], &[&scribble]);
        let looked_at = work::steps() - begun;
        assert!((LONGEST / PIECE..2.0 * LONGEST / PIECE).contains(&(looked_at as f32)), "{looked_at} points");
    }

    #[test]
    fn rivers_of_another_kind_of_land_are_none() {
        let mut recipe = link::read("land=drawn&outline=...gAgA").unwrap();
        assert_eq!(starts(&recipe, &Domain::of(&recipe), None).len(), 1);
        recipe.set(Key::Land, "rectangle").unwrap();
        assert_eq!(starts(&recipe, &Domain::of(&recipe), None).len(), 0);
    }
}
