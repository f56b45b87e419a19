//! Space colonization straight from the paper (section 2.2), every blue node against every black node in every
//! round: what the incremental index must equal node for node. Only the arithmetic of a single pull and of a single
//! heading is shared with the crate.

use glam::Vec2;
use riverseed::grow::{Parameters, Pull, heading, is_twin, mouths, scatter};
use riverseed::tree::NO_PARENT;

/// A node of the growing structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Black {
    pub at: Vec2,
    pub parent: u32,
    pub tick: u32,
    pub drained: u32,
    from_mouth: u32,
    /// The blue nodes it had when it last tried to grow.
    tried: Vec<u32>,
}

/// Grows by the numbered steps of the paper.
pub fn grow(parameters: &Parameters) -> Vec<Black> {
    // Step 1: start nodes, and blue nodes spread over the space.
    let mut blue: Vec<Option<Vec2>> = scatter(parameters).into_iter().map(Some).collect();
    let mut black: Vec<Black> = mouths(parameters).iter().map(|mouth| node(mouth.at, NO_PARENT, 0, 0)).collect();
    let mut tick = run_inland(parameters, &blue, &mut black);
    loop {
        tick += 1;
        let assigned = assign(parameters, &blue, &black);
        let born = grow_all(parameters, &blue, &mut black, assigned, tick);
        if born.is_empty() {
            break;
        }
        black.extend(born);
        remove(parameters, &mut blue, &mut black);
    }
    // What is left drains to the node it is assigned to.
    for (node, blue) in assign(parameters, &blue, &black).into_iter().enumerate() {
        black[node].drained += blue.len() as u32;
    }
    black
}

fn node(at: Vec2, parent: u32, tick: u32, from_mouth: u32) -> Black {
    Black { at, parent, tick, drained: 0, from_mouth, tried: Vec::new() }
}

fn squared_distance(a: Vec2, b: Vec2) -> f32 {
    let gap = a - b;
    gap.x * gap.x + gap.y * gap.y
}

/// The closest black node nearer than a distance, with no ridge between; the first of equals.
fn closest(parameters: &Parameters, blue: Vec2, black: &[Black], distance: f32) -> Option<usize> {
    let mut best = (distance * distance, None);
    for (i, node) in black.iter().enumerate() {
        let squared = squared_distance(blue, node.at);
        if squared < best.0 && parameters.sees(node.at, blue) {
            best = (squared, Some(i));
        }
    }
    best.1
}

/// Step 2: the blue nodes of each black node.
fn assign(parameters: &Parameters, blue: &[Option<Vec2>], black: &[Black]) -> Vec<Vec<u32>> {
    let mut assigned = vec![Vec::new(); black.len()];
    for (i, blue) in (0u32..).zip(blue) {
        if let Some(node) = blue.and_then(|blue| closest(parameters, blue, black, parameters.reach)) {
            assigned[node].push(i);
        }
    }
    assigned
}

/// Steps 3 and 4, for black nodes whose blue nodes are not those they last tried with.
fn grow_all(
    parameters: &Parameters,
    blue: &[Option<Vec2>],
    black: &mut [Black],
    assigned: Vec<Vec<u32>>,
    tick: u32,
) -> Vec<Black> {
    let mut born = Vec::new();
    for (i, assigned) in assigned.into_iter().enumerate() {
        if assigned == black[i].tried {
            continue;
        }
        let parent = &black[i];
        let mut sum = Pull::default();
        assigned.iter().filter_map(|&b| blue[b as usize]).for_each(|b| sum.add(Pull::toward(parent.at, b)));
        if let Some(direction) = sum.direction() {
            let came_from = black.get(parent.parent as usize).map(|node| node.at);
            let at = heading(parameters, parent.at, came_from, direction, parent.from_mouth, tick);
            let mut children = black.iter().filter(|node| node.parent == i as u32);
            if parameters.allows(parent.at, at) && !children.any(|child| is_twin(at, child.at, parameters.step)) {
                born.push(node(at, i as u32, tick, parent.from_mouth + 1));
            }
        }
        black[i].tried = assigned;
    }
    born
}

/// Step 5: blue nodes near a black node go, and drain into it.
fn remove(parameters: &Parameters, blue: &mut [Option<Vec2>], black: &mut [Black]) {
    for blue in blue {
        if let Some(node) = blue.and_then(|blue| closest(parameters, blue, black, parameters.kill)) {
            black[node].drained += 1;
            *blue = None;
        }
    }
}

/// Before the rounds: a river that no blue node reaches runs straight inland until one does, or the land ends.
fn run_inland(parameters: &Parameters, blue: &[Option<Vec2>], black: &mut Vec<Black>) -> u32 {
    let is_reached =
        |at: Vec2| blue.iter().flatten().any(|&blue| squared_distance(blue, at) < parameters.reach * parameters.reach);
    let mut tips: Vec<(usize, Vec2)> = mouths(parameters).iter().map(|mouth| mouth.inland).enumerate().collect();
    let mut tick = 0;
    loop {
        tips.retain(|&(tip, _)| !is_reached(black[tip].at));
        tips.retain(|&(tip, inland)| parameters.allows(black[tip].at, black[tip].at + inland * parameters.step));
        if tips.is_empty() {
            return tick;
        }
        tick += 1;
        for (tip, inland) in &mut tips {
            let at = black[*tip].at + *inland * parameters.step;
            let from_mouth = black[*tip].from_mouth + 1;
            black.push(node(at, *tip as u32, tick, from_mouth));
            *tip = black.len() - 1;
        }
    }
}
