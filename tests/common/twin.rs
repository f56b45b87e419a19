//! Space colonization straight from the paper (section 2.2), every blue node against every black node in every round:
//! the incremental index must equal it node for node. Momentum and curl are written again as well. Only the starting
//! positions, the fixed-point sum of pulls and the hash for random angles are shared with the crate.

use glam::Vec2;
use riverseed::base::random::Purpose;
use riverseed::grow::{GrowthSettings, Mouth, Pull, curl_toward, mouths, scatter, shores, stem_nodes};
use riverseed::tree::NO_PARENT;

/// A node of the growing structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Black {
    pub at: Vec2,
    pub parent: u32,
    pub tick: u32,
    pub drained: u32,
    from_mouth: u32,
    /// The blue nodes that it had when it last tried to grow.
    tried: Vec<u32>,
}

/// Grows by the numbered steps of the paper, or along valleys.
pub fn grow(settings: &GrowthSettings) -> Vec<Black> {
    if settings.has_valleys() { grow_along_valleys(settings) } else { grow_everywhere(settings) }
}

/// Reaches one blue node after another: always the lowest within reach of any black node, for which all are looked at.
/// A black node that found no step toward a blue node does not try it again.
fn grow_along_valleys(settings: &GrowthSettings) -> Vec<Black> {
    let mut blue: Vec<Option<Vec2>> = scatter(settings).into_iter().map(Some).collect();
    let (mut black, mut pilots) = start_nodes(settings);
    let mut stuck = vec![None; blue.len()];
    loop {
        let mut born = run_inland(settings, &blue, &black, &mut pilots, 0);
        remove(settings, &mut blue, &mut black);
        if born.is_empty() {
            while let Some(lowest) = lowest_in_reach(settings, &blue, &black, &stuck) {
                stuck[lowest] = run_toward(settings, &mut blue, &mut black, lowest);
            }
            if let Some(mouth) = mouth_for_the_rest(settings, &blue, &black) {
                born = stem(settings, mouth, black.len() as u32, 0);
                pilots.push((black.len() + born.len() - 1, mouth.inland));
            } else if blue.iter().flatten().count() > blue.len() / 2 {
                born.extend(extend_last_tip(settings, &black, 0));
                pilots.extend(born.first().map(|_| (black.len(), onward(settings, &black))));
            }
        }
        if born.is_empty() {
            drain_the_rest(settings, &blue, &mut black);
            return black;
        }
        black.extend(born);
        // A stem may at once use up the blue nodes that its river would have followed, which then runs straight inland.
        remove(settings, &mut blue, &mut black);
    }
}

/// The first blue node that some black node reaches, unless its closest black node is stuck.
fn lowest_in_reach(
    settings: &GrowthSettings,
    blue: &[Option<Vec2>],
    black: &[Black],
    stuck: &[Option<usize>],
) -> Option<usize> {
    let closest = |blue: Vec2| closest(settings, blue, black, settings.reach);
    (0..blue.len()).find(|&i| blue[i].and_then(closest).is_some_and(|node| stuck[i] != Some(node)))
}

/// Runs a river to a blue node. Returns the black node at which it is stuck, if any.
fn run_toward(
    settings: &GrowthSettings,
    blue: &mut [Option<Vec2>],
    black: &mut Vec<Black>,
    lowest: usize,
) -> Option<usize> {
    for step in 0.. {
        let Some(aim) = blue[lowest] else { break };
        let from = closest(settings, aim, black, settings.reach)?;
        let parent = &black[from];
        let v2 = Pull::toward(parent.at, aim).direction()?;
        let came_from = black.get(parent.parent as usize).map(|node| node.at);
        let ([column, row], to_the_right) = curl_toward(settings, aim);
        let u = with_momentum(settings, parent.at, came_from, v2);
        let u = curled(settings, u, to_the_right, [column, row, step]);
        let is_step = |at: &Vec2| {
            squared_distance(*at, aim) < squared_distance(parent.at, aim)
                && settings.allows(parent.at, *at)
                && !has_twin(settings, black, from, *at)
        };
        let steps = [parent.at + u * settings.step, parent.at + v2 * settings.step];
        let Some(at) = steps.into_iter().find(is_step) else { return Some(from) };
        black.push(node(at, from as u32, 0, black[from].from_mouth + 1));
        remove(settings, blue, black);
    }
    None
}

fn grow_everywhere(settings: &GrowthSettings) -> Vec<Black> {
    // Step 1: start nodes, and blue nodes spread over the space.
    let mut blue: Vec<Option<Vec2>> = scatter(settings).into_iter().map(Some).collect();
    let (mut black, mut pilots) = start_nodes(settings);
    for tick in 1.. {
        let assigned = assign(settings, &blue, &black);
        let mut born = run_inland(settings, &blue, &black, &mut pilots, tick);
        born.extend(grow_all(settings, &blue, &mut black, &assigned, tick));
        if born.is_empty() {
            born = reach_out(settings, &blue, &black, &assigned, tick);
        }
        if born.is_empty()
            && let Some(mouth) = mouth_for_the_rest(settings, &blue, &black)
        {
            born = stem(settings, mouth, black.len() as u32, tick);
            pilots.push((black.len() + born.len() - 1, mouth.inland));
        }
        if born.is_empty() && blue.iter().flatten().count() > blue.len() / 2 {
            born.extend(extend_last_tip(settings, &black, tick));
            pilots.extend(born.first().map(|_| (black.len(), onward(settings, &black))));
        }
        if born.is_empty() {
            break;
        }
        black.extend(born);
        remove(settings, &mut blue, &mut black);
    }
    drain_the_rest(settings, &blue, &mut black);
    black
}

/// Drains the remaining blue nodes to the nodes that they are assigned to.
fn drain_the_rest(settings: &GrowthSettings, blue: &[Option<Vec2>], black: &mut [Black]) {
    for (node, blue) in assign(settings, blue, black).into_iter().enumerate() {
        black[node].drained += blue.len() as u32;
    }
}

fn node(at: Vec2, parent: u32, tick: u32, from_mouth: u32) -> Black {
    Black { at, parent, tick, drained: 0, from_mouth, tried: Vec::new() }
}

fn squared_distance(a: Vec2, b: Vec2) -> f32 {
    let gap = a - b;
    gap.x * gap.x + gap.y * gap.y
}

/// The closest black node nearer than a distance, with no ridge between; the first among equals.
fn closest(settings: &GrowthSettings, blue: Vec2, black: &[Black], distance: f32) -> Option<usize> {
    let mut best = (distance * distance, None);
    for (i, node) in black.iter().enumerate() {
        let squared = squared_distance(blue, node.at);
        if squared < best.0 && settings.sees(node.at, blue) {
            best = (squared, Some(i));
        }
    }
    best.1
}

/// Step 2: the blue nodes of each black node.
fn assign(settings: &GrowthSettings, blue: &[Option<Vec2>], black: &[Black]) -> Vec<Vec<u32>> {
    let mut assigned = vec![Vec::new(); black.len()];
    for (i, blue) in (0u32..).zip(blue) {
        if let Some(node) = blue.and_then(|blue| closest(settings, blue, black, settings.reach)) {
            assigned[node].push(i);
        }
    }
    assigned
}

/// Steps 3 and 4, for black nodes whose blue nodes have changed since they last tried.
fn grow_all(
    settings: &GrowthSettings,
    blue: &[Option<Vec2>],
    black: &mut [Black],
    assigned: &[Vec<u32>],
    tick: u32,
) -> Vec<Black> {
    let mut born = Vec::new();
    for (i, assigned) in assigned.iter().enumerate() {
        if *assigned == black[i].tried {
            continue;
        }
        let parent = &black[i];
        let mut sum = Pull::default();
        assigned.iter().filter_map(|&b| blue[b as usize]).for_each(|b| sum.add(Pull::toward(parent.at, b)));
        if let Some(v2) = sum.direction() {
            let came_from = black.get(parent.parent as usize).map(|node| node.at);
            let identity = [parent.at.x.to_bits(), parent.at.y.to_bits(), tick];
            // The first c nodes of a branch turn right, the next ones left.
            let to_the_right = parent.from_mouth % (2 * settings.stretch) < settings.stretch;
            let u = curled(settings, with_momentum(settings, parent.at, came_from, v2), to_the_right, identity);
            let bent = parent.at + u * settings.step;
            let straight = parent.at + v2 * settings.step;
            let at = if settings.allows(parent.at, bent) { bent } else { straight };
            if settings.allows(parent.at, at) && !has_twin(settings, black, i, at) {
                born.push(node(at, i as u32, tick, parent.from_mouth + 1));
            }
        }
        black[i].tried.clone_from(assigned);
    }
    born
}

/// When nothing grows any more: every black node that has blue nodes grows straight toward the nearest.
fn reach_out(
    settings: &GrowthSettings,
    blue: &[Option<Vec2>],
    black: &[Black],
    assigned: &[Vec<u32>],
    tick: u32,
) -> Vec<Black> {
    let mut born = Vec::new();
    for (i, parent) in black.iter().enumerate() {
        let mine = assigned[i].iter().filter_map(|&b| blue[b as usize]);
        let nearest = mine.min_by(|a, b| {
            let distance = |blue: &Vec2| squared_distance(*blue, parent.at);
            distance(a).total_cmp(&distance(b)).then(a.x.total_cmp(&b.x)).then(a.y.total_cmp(&b.y))
        });
        let Some(direction) = nearest.and_then(|blue| Pull::toward(parent.at, blue).direction()) else { continue };
        let at = parent.at + direction * settings.step;
        if settings.allows(parent.at, at) && !has_twin(settings, black, i, at) {
            born.push(node(at, i as u32, tick, parent.from_mouth + 1));
        }
    }
    born
}

/// When most blue nodes are left, but none is within reach: the last black node runs straight on.
fn extend_last_tip(settings: &GrowthSettings, black: &[Black], tick: u32) -> Option<Black> {
    let last = black.last()?;
    black.get(last.parent as usize)?;
    let at = last.at + onward(settings, black) * settings.step;
    settings.allows(last.at, at).then(|| node(at, black.len() as u32 - 1, tick, last.from_mouth + 1))
}

/// The direction in which the last black node was made.
fn onward(settings: &GrowthSettings, black: &[Black]) -> Vec2 {
    let last = &black[black.len() - 1];
    (last.at - black[last.parent as usize].at) / settings.step
}

/// Returns `true` if a node has a child within an eighth of a step of a place.
fn has_twin(settings: &GrowthSettings, black: &[Black], parent: usize, at: Vec2) -> bool {
    let eighth = settings.step * 0.125;
    let mut children = black.iter().filter(|node| node.parent == parent as u32);
    children.any(|child| squared_distance(at, child.at) < eighth * eighth)
}

/// Section 4.2: u = v₂ − k·v₁, normalised, where v₁ is the direction in which the node itself was made.
fn with_momentum(settings: &GrowthSettings, at: Vec2, came_from: Option<Vec2>, v2: Vec2) -> Vec2 {
    let Some(parent) = came_from.filter(|_| settings.momentum > 0.0) else { return v2 };
    let (v1_x, v1_y) = ((at.x - parent.x) / settings.step, (at.y - parent.y) / settings.step);
    let (x, y) = (v2.x - v1_x * settings.momentum, v2.y - v1_y * settings.momentum);
    let length_squared = x * x + y * y;
    if length_squared <= 1e-6 {
        return v2;
    }
    let length = length_squared.sqrt();
    Vec2::new(x / length, y / length)
}

/// Section 4.3: turns by a random angle up to θ_c, to the right or to the left.
fn curled(settings: &GrowthSettings, u: Vec2, to_the_right: bool, identity: [u32; 3]) -> Vec2 {
    if settings.curl == 0.0 {
        return u;
    }
    let hash = settings.seed.item_hash(Purpose::Curl);
    let angle = settings.curl * hash.unit(identity);
    // In double precision, rounded once.
    let (sine, cosine) = (libm::sin(f64::from(angle)) as f32, libm::cos(f64::from(angle)) as f32);
    let sine = if to_the_right { sine } else { -sine };
    Vec2::new(u.x * cosine - u.y * sine, u.y * cosine + u.x * sine)
}

/// Step 5: removes blue nodes near a black node, which drain into it.
fn remove(settings: &GrowthSettings, blue: &mut [Option<Vec2>], black: &mut [Black]) {
    for blue in blue {
        if let Some(node) = blue.and_then(|blue| closest(settings, blue, black, settings.kill)) {
            black[node].drained += 1;
            *blue = None;
        }
    }
}

/// The mouths, each with a stem of about a spacing straight inland, and the ends of the stems.
fn start_nodes(settings: &GrowthSettings) -> (Vec<Black>, Vec<(usize, Vec2)>) {
    let (mut black, mut ends) = (Vec::new(), Vec::new());
    for mouth in mouths(settings) {
        let first = black.len() as u32;
        let drawn = settings.starts.iter().find(|start| start.mouth == mouth);
        let drawn = drawn.and_then(|start| drawn_stem(settings, &start.course, mouth, first));
        let (stem, inland) = drawn.unwrap_or_else(|| (stem(settings, mouth, first, 0), mouth.inland));
        black.extend(stem);
        ends.push((black.len() - 1, inland));
    }
    (black, ends)
}

/// A mouth with the river drawn from it, step by step toward the next point that is a step away or more, and the
/// direction of the last step. `None` if there is no room for a step.
fn drawn_stem(settings: &GrowthSettings, course: &[Vec2], mouth: Mouth, first: u32) -> Option<(Vec<Black>, Vec2)> {
    let mut stem = vec![node(mouth.at, NO_PARENT, 0, 0)];
    let (mut onward, mut next) = (None, 0);
    while next < course.len() {
        let from = stem[stem.len() - 1].at;
        let way = course[next] - from;
        let far = squared_distance(course[next], from).sqrt();
        if far < settings.step {
            next += 1;
            continue;
        }
        let direction = way / far;
        let at = from + direction * settings.step;
        if !settings.allows(from, at) {
            break;
        }
        let last = stem.len() as u32 - 1;
        stem.push(node(at, first + last, 0, last + 1));
        onward = Some(direction);
    }
    onward.map(|onward| (stem, onward))
}

/// A mouth and its stem. The nodes are numbered from `first`.
fn stem(settings: &GrowthSettings, mouth: Mouth, first: u32, tick: u32) -> Vec<Black> {
    let mut stem = vec![node(mouth.at, NO_PARENT, tick, 0)];
    for i in 1..=stem_nodes(settings) {
        let from = stem[stem.len() - 1].at;
        let at = from + mouth.inland * settings.step;
        if settings.allows(from, at) {
            stem.push(node(at, first + stem.len() as u32 - 1, tick, i));
        }
    }
    stem
}

/// The mouth for unreached land: when more than a fiftieth of the blue nodes are within reach of no black node, the
/// place on the coast with the most of them in reach; the first among equals.
fn mouth_for_the_rest(settings: &GrowthSettings, blue: &[Option<Vec2>], black: &[Black]) -> Option<Mouth> {
    let is_lost = |blue: &Vec2| closest(settings, *blue, black, settings.reach).is_none();
    let lost: Vec<Vec2> = blue.iter().flatten().copied().filter(is_lost).collect();
    if lost.len() <= blue.len() / 50 {
        return None;
    }
    let mut best = (0, None);
    for shore in shores(settings) {
        let mut mouths = black.iter().filter(|node| node.parent == NO_PARENT);
        let reach = settings.reach * settings.reach;
        let is_in_reach = |blue: &&Vec2| squared_distance(**blue, shore.at) < reach && settings.sees(shore.at, **blue);
        let seen = lost.iter().filter(is_in_reach).count();
        if seen > best.0 && mouths.all(|mouth| mouth.at.distance(shore.at) > settings.mouth_spacing) {
            best = (seen, Some(Mouth { at: shore.at, inland: shore.inland }));
        }
    }
    best.1
}

/// Extends rivers that no blue node reaches straight inland, until one does or the land ends.
fn run_inland(
    settings: &GrowthSettings,
    blue: &[Option<Vec2>],
    black: &[Black],
    pilots: &mut Vec<(usize, Vec2)>,
    tick: u32,
) -> Vec<Black> {
    let reach = settings.reach * settings.reach;
    pilots.retain(|&(tip, inland)| {
        let at = black[tip].at;
        let is_reached = blue.iter().flatten().any(|&blue| squared_distance(blue, at) < reach);
        !is_reached && settings.allows(at, at + inland * settings.step)
    });
    let mut born = Vec::new();
    for (tip, inland) in pilots {
        let at = black[*tip].at + *inland * settings.step;
        born.push(node(at, *tip as u32, tick, black[*tip].from_mouth + 1));
        *tip = black.len() + born.len() - 1;
    }
    born
}
