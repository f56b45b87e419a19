//! The tips of branches: carried straight on to the new coast, or given up where something is in the way.

use glam::Vec2;

use super::fan::Link;
use super::plain::Plain;
use crate::base::geometry::{distance, fast_max};
use crate::base::work;

/// The distance by which tips run out into the sea, in units.
const OUT: f32 = 0.8;

/// The length of a step, in units.
const STEP: f32 = 1.0;

/// Brings all branches to the sea. If arms cannot reach it, returns the branches without them as an error: there is less land then,
/// through which the branch that they were arms of has to go alone.
pub(super) fn carry(links: &[Link], plain: &Plain, kept: &[(Vec2, f32)]) -> Result<Vec<Link>, Vec<Link>> {
    let (mut done, mut is_gone) = (links.to_vec(), vec![false; links.len()]);
    for i in (0..links.len()).filter(|&i| links[i].arms.is_none()) {
        match carried(&done, i, &is_gone, plain, kept) {
            Some(line) => done[i].line = line,
            None => is_gone[i] = true,
        }
    }
    if !is_gone.contains(&true) {
        return Ok(done);
    }
    let mut left = links.to_vec();
    for i in (0..links.len()).rev() {
        if let Some(arms) = links[i].arms.filter(|arms| arms.iter().any(|&arm| is_gone[arm])) {
            give_up(links, &mut is_gone, arms);
            left[i].arms = None;
        }
    }
    let has_lost_first = (0..links.len()).any(|i| links[i].parent.is_none() && is_gone[i]);
    Err(if has_lost_first { Vec::new() } else { without(left, &is_gone) })
}

/// Gives up two arms and all that belongs to them.
fn give_up(links: &[Link], is_gone: &mut [bool], arms: [usize; 2]) {
    let mut left = arms.to_vec();
    while let Some(arm) = left.pop() {
        is_gone[arm] = true;
        left.extend(links[arm].arms.into_iter().flatten());
    }
}

/// Returns the line of a branch that ends just in the sea; `None` if there is no room, or it would be longer than the one before.
fn carried(links: &[Link], i: usize, is_gone: &[bool], plain: &Plain, kept: &[(Vec2, f32)]) -> Option<Vec<Vec2>> {
    /// The farthest that a branch of the river itself goes on, as a share of its length.
    const FAR: f32 = 1.0;
    let link = &links[i];
    let length = link.length();
    let longest = link.parent.map_or(length * (1.0 + FAR), |parent| links[parent].length());
    let mut line = link.line.clone();
    while line.len() > 2 && plain.height(line[line.len() - 2]) < -OUT {
        line.pop();
    }
    let heading = link.heading();
    let mut at = *line.last()?;
    let mut way = line.windows(2).map(|pair| distance(pair[0], pair[1])).sum::<f32>();
    while plain.height(at) > -OUT {
        at += heading * STEP;
        way += STEP;
        if way > longest || !has_room(links, i, is_gone, at, kept) {
            return None;
        }
        line.push(at);
    }
    Some(line)
}

/// Returns `true` if a branch can go on to a place without coming near another.
fn has_room(links: &[Link], i: usize, is_gone: &[bool], at: Vec2, kept: &[(Vec2, f32)]) -> bool {
    let link = &links[i];
    let others = links.iter().enumerate().filter(|(other, _)| *other != i && !is_gone[*other]);
    work::count(kept.len());
    kept.iter().all(|&(place, far)| distance(at, place) >= far)
        && others.filter(|(other, _)| Some(*other) != link.parent).all(|(_, other)| {
            work::count(other.line.len());
            let clear = fast_max(0.8 * (link.width + other.width), 1.5) + 1.0;
            other.line.iter().all(|place| distance(at, *place) >= clear)
        })
}

/// Drops branches that have gone.
fn without(links: Vec<Link>, is_gone: &[bool]) -> Vec<Link> {
    let mut number = vec![0; links.len()];
    let mut left = 0;
    for (i, is_gone) in is_gone.iter().enumerate() {
        number[i] = left;
        left += usize::from(!is_gone);
    }
    let renumbered = |link: Link| Link {
        parent: link.parent.map(|parent| number[parent]),
        arms: link.arms.map(|arms| arms.map(|arm| number[arm])),
        ..link
    };
    links.into_iter().zip(is_gone).filter(|(_, is_gone)| !**is_gone).map(|(link, _)| renumbered(link)).collect()
}
