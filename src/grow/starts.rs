//! Starts: the mouths that a drawing gives (the paper's start nodes), each with the course that is drawn of its river. Where there are
//! any, there are no other mouths, and land without one stays dry.

use glam::Vec2;

use super::Mouth;
use crate::domain::Domain;
use crate::geometry::distance;
use crate::land::{Cell, Land, divided, in_units};
use crate::recipe::Recipe;
use crate::work;

/// A mouth that a drawing gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The place on a coast that lies nearest to where the drawn river enters the land; on the border of a plain rectangle.
    pub mouth: Mouth,
    /// Points of the river's course from its mouth on, [`PIECE`] apart at most, as far as it runs over land; none where nothing but a
    /// mouth is drawn.
    pub course: Vec<Vec2>,
}

/// How far apart points of a course are at most, in units.
pub(in crate::grow) const PIECE: f32 = 2.0;

/// How far courses are followed, all together, in units: ten times across the map. What is drawn beyond that would be a scribble.
const LONGEST: f32 = 10_000.0;

/// Mouths that are nearer to each other than this, in units, are one.
const APART: f32 = 4.0;

/// The starts of a recipe, in the order of their drawing.
pub(in crate::grow) fn starts(recipe: &Recipe, domain: &Domain, land: Option<&Land>) -> Vec<Start> {
    let of_rectangle = || in_units(recipe.rivers(), domain);
    let mut starts: Vec<Start> = Vec::new();
    let mut left = (LONGEST / PIECE) as usize;
    for mut line in land.map_or_else(of_rectangle, |land| land.rivers().to_vec()) {
        line.iter_mut().for_each(|at| *at = at.clamp(Vec2::ZERO, domain.size));
        if let Some(start) = start(&line, domain, land, left)
            && starts.iter().all(|other| other.mouth.at.distance(start.mouth.at) > APART)
        {
            left -= start.course.len();
            starts.push(start);
        }
    }
    starts
}

/// The start that a line gives, with a course of so many points at most; `None` if there is no coast at all.
fn start(line: &[Vec2], domain: &Domain, land: Option<&Land>, most: usize) -> Option<Start> {
    let pieces = divided(line, PIECE, false);
    work::count(pieces.len());
    let is_land = |at: &Vec2| land.is_none_or(|land| land.at(*at) == Cell::Land);
    let (entry, inland) = match pieces.iter().position(is_land) {
        Some(first) if line.len() > 1 => (pieces[first], &pieces[first..]),
        _ => (pieces[0], &[][..]),
    };
    let mouth = match land {
        Some(land) => on_coast(land, entry)?,
        None => on_border(domain.size, entry),
    };
    let tied = if inland.is_empty() { Vec::new() } else { divided(&[mouth.at, entry], PIECE, false) };
    let way = tied.into_iter().chain(inland.iter().copied().skip(1)).take(most);
    let mut last = mouth.at;
    let is_open = |&at: &Vec2| land.is_none_or(|land| land.allows(std::mem::replace(&mut last, at), at));
    Some(Start { mouth, course: way.take_while(is_open).collect() })
}

/// The mouth on a coast that is nearest to a point.
fn on_coast(land: &Land, point: Vec2) -> Option<Mouth> {
    let shores = land.regions().iter().flat_map(|region| &region.shores);
    let nearest = shores.map(|shore| (distance(shore.at, point), shore)).reduce(|a, b| if b.0 < a.0 { b } else { a });
    nearest.map(|(_, shore)| Mouth { at: shore.at, inland: shore.inland })
}

/// The mouth on the border of a rectangle that is nearest to a point in it.
fn on_border(size: Vec2, point: Vec2) -> Mouth {
    let far = size - point;
    let sides = [(point.y, Vec2::Y), (far.x, Vec2::NEG_X), (far.y, Vec2::NEG_Y), (point.x, Vec2::X)];
    let (away, inland) = sides.into_iter().fold((f32::INFINITY, Vec2::Y), |a, b| if b.0 < a.0 { b } else { a });
    Mouth { at: (point - inland * away).clamp(Vec2::ZERO, size), inland }
}
