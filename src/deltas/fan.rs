//! The branches of a delta: each splits in two at its tip, until too little water or sediment is left.

use glam::Vec2;

use super::sediment::reach;
use crate::base::geometry::{direction, distance, fast_min};
use crate::base::queue::Queue;
use crate::base::random::ItemHash;
use crate::base::trigonometry::sine_and_cosine;
use crate::base::work;
use crate::domain::Domain;
use crate::land::CoastDistance;

/// The angle between two branches, in radians: 72° (Coffey and Shaw 2017), and the least and greatest multiple of it.
const ANGLE: f32 = 1.256_637;
const ANGLES: (f32, f32) = (0.82, 1.15);

/// The greater share of water at a split: the least, the growth with a deviate, and the most.
const SHARES: (f32, f32, f32) = (0.5, 0.14, 0.8);

/// The share of the trunk's water below which a branch does not split, and the least that a branch has.
const LEAST_SPLIT: f32 = 0.15;
const LEAST: f32 = 0.03;

/// The least and greatest multiple of the usual length of a branch.
const LENGTHS: (f32, f32) = (0.75, 1.25);

/// The greatest length of a branch, as a share of that of the branch before it; the rest is left for its way over new land to the sea.
const SHORTER: f32 = 0.58;

/// The room that a branch finds ahead of its tip, in units and in widths, so that it can go on to the sea over its own land.
const AHEAD: (f32, f32) = (5.0, 1.0);

/// The distance between two places of a branch, in units.
const STEP: f32 = 2.0;

/// The deviation of the turn of a step, in radians, and the share of all turns that is taken back.
const TURN: f32 = 0.1;
const PULL: f32 = 0.1;

/// The distance from a coast, beyond what a branch needs, from which it turns away, in units, and the greatest turn of a step, in
/// radians.
const SHY: f32 = 7.0;
const AWAY: f32 = 0.3;

/// The distance that branches keep from the frame of the map, in units.
const OFF_FRAME: f32 = 14.0;

/// The greatest number of branches of a delta.
const MOST: usize = 60;

/// A branch.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub parent: Option<usize>,
    /// The two arms that it splits into.
    pub arms: Option<[usize; 2]>,
    /// The share of the trunk's water, and the width, in units.
    pub share: f32,
    pub width: f32,
    pub line: Vec<Vec2>,
    /// The place up to which there is room ahead of the tip.
    pub ahead: Vec2,
}

impl Link {
    /// Returns the length, in units.
    pub fn length(&self) -> f32 {
        self.line.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
    }

    /// Returns the direction at the tip.
    pub fn heading(&self) -> Vec2 {
        let [.., from, to] = self.line[..] else { return Vec2::ZERO };
        direction(to - from)
    }

    pub fn tip(&self) -> Vec2 {
        self.line.last().copied().unwrap_or_default()
    }
}

/// The place in which a delta grows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site<'a> {
    pub domain: Domain,
    pub coast: &'a CoastDistance,
    /// The mouth, the direction of the river there, and its width, in units.
    pub apex: Vec2,
    pub heading: Vec2,
    pub width: f32,
    /// Places with the distance that branches keep from them, in units.
    pub kept: &'a [(Vec2, f32)],
    pub identity: u32,
    pub chance: ItemHash,
}

/// The branches of a delta in the making.
pub(super) struct Fan<'a> {
    site: Site<'a>,
    pub links: Vec<Link>,
    /// The sediment that is left, in cubic units.
    pub left: f32,
    /// The usual length of a branch of all the water, in units.
    pub reach: f32,
}

/// Counts the branches that do not divide.
pub(super) fn count_tips(links: &[Link]) -> usize {
    links.iter().filter(|link| link.arms.is_none()).count()
}

/// A branch to grow: where it begins, which way it is to run, and the branch that it is an arm of.
#[derive(Clone, Copy)]
struct Arm {
    from: Vec2,
    way: Vec2,
    share: f32,
    parent: Option<usize>,
    /// The number by which chance knows it.
    number: u32,
}

impl<'a> Fan<'a> {
    /// Grows the branches of a delta out of a volume of sediment: as long as there is room for, so that many reach the sea.
    pub fn grow(site: Site<'a>, volume: f32) -> Self {
        const SCALES: [f32; 4] = [1.0, 0.8, 0.65, 0.5];
        const MANY: usize = 5;
        /// The least length of branches in widths: shorter ones look like stumps.
        const LEAST_WIDTHS: f32 = 3.2;
        let reach = reach(site.width, volume);
        let mut best = Self::of_reach(site, volume, SCALES[0] * reach);
        for scale in &SCALES[1..] {
            if count_tips(&best.links) >= MANY || scale * reach < LEAST_WIDTHS * site.width {
                break;
            }
            let next = Self::of_reach(site, volume, scale * reach);
            if count_tips(&next.links) > count_tips(&best.links) {
                best = next;
            }
        }
        best
    }

    fn of_reach(site: Site<'a>, volume: f32, reach: f32) -> Self {
        let mut this = Self { site, links: Vec::new(), left: volume, reach };
        let mut queue = Queue::default();
        let seaward = -direction(site.coast.slope(site.apex));
        let way = direction(0.6 * seaward + 0.4 * site.heading);
        // Where the coast is in the way, the river turns aside.
        for aside in [0.0, 0.35, -0.35, 0.7, -0.7, 1.05, -1.05] {
            if this.split(None, turned(way, aside), &mut queue) {
                break;
            }
        }
        while let Some(link) = queue.pop() {
            let link = link as usize;
            if this.links[link].share >= LEAST_SPLIT && this.links.len() + 2 <= MOST && this.left > 0.0 {
                this.split(Some(link), this.links[link].heading(), &mut queue);
            }
        }
        this
    }

    /// Splits a branch, or the river itself, at its tip. Returns `false` if there is no room for both arms.
    fn split(&mut self, parent: Option<usize>, way: Vec2, queue: &mut Queue) -> bool {
        let Site { apex, identity, chance, .. } = self.site;
        let number = parent.map_or(0, |parent| parent as u32 + 1);
        let (from, share) = parent.map_or((apex, 1.0), |parent| (self.links[parent].tip(), self.links[parent].share));
        let (least, growth, most) = SHARES;
        let greater = fast_min(most, least + growth * chance.normal([identity, number, 1]).abs());
        let angle = ANGLE * (ANGLES.0 + (ANGLES.1 - ANGLES.0) * chance.unit([identity, number, 2]));
        let side = if chance.unit([identity, number, 3]) < 0.5 { 1.0 } else { -1.0 };
        if share * (1.0 - greater) < LEAST {
            return false;
        }
        let arm = |share: f32, turn: f32, arm: u32| Arm {
            from,
            way: turned(way, turn),
            share,
            parent,
            number: 2 * number + arm,
        };
        let before = (self.links.len(), self.left);
        // The greater arm turns less.
        let arms = [
            arm(share * greater, side * angle * (1.0 - greater), 0),
            arm(share * (1.0 - greater), -side * angle * greater, 1),
        ];
        if !arms.into_iter().all(|arm| self.grow_arm(arm)) {
            self.links.truncate(before.0);
            self.left = before.1;
            return false;
        }
        for i in before.0..before.0 + 2 {
            queue.push(-self.links[i].share, i as u32);
        }
        if let Some(parent) = parent {
            self.links[parent].arms = Some([before.0, before.0 + 1]);
        }
        true
    }

    /// Grows an arm. Returns `false` if there is no room for it, or sediment is spent.
    fn grow_arm(&mut self, arm: Arm) -> bool {
        let Site { identity, chance, width, .. } = self.site;
        let width = width * arm.share.sqrt();
        let chosen = chance.unit([identity, arm.number, 4]);
        let usual = self.reach * arm.share.sqrt();
        let mut whole = usual * (LENGTHS.0 + (LENGTHS.1 - LENGTHS.0) * chosen);
        if let Some(parent) = arm.parent {
            whole = fast_min(whole, SHORTER * self.links[parent].length());
        }
        let count = (whole / STEP).ceil().max(4.0);
        let step = whole / count;
        let mut line = vec![arm.from];
        let (mut at, mut turn, mut heading) = (arm.from, 0.0, arm.way);
        for i in 0..count as u32 {
            // The first step keeps the angle of the split.
            if i > 0 {
                turn += TURN * chance.normal([identity, arm.number, 16 + i]) - PULL * turn;
                heading = self.away_from_coast(at, heading, width);
            }
            at += turned(heading, turn) * step;
            let cost = COST * width * (SHOAL + depth(self.site.coast.height(at)) / DEEP) * step;
            if cost > self.left || !self.has_room(at, i as f32 * step, width, arm.parent) {
                return false;
            }
            self.left -= cost;
            line.push(at);
        }
        let ahead = at + turned(heading, turn) * (AHEAD.0 + AHEAD.1 * width);
        if ![0.5, 1.0].into_iter().all(|share| self.has_room(at.lerp(ahead, share), whole, width, arm.parent)) {
            return false;
        }
        self.links.push(Link { parent: arm.parent, arms: None, share: arm.share, width, line, ahead });
        true
    }

    /// Turns a branch away from a coast that it comes near to.
    fn away_from_coast(&self, at: Vec2, heading: Vec2, width: f32) -> Vec2 {
        let coast = self.site.coast;
        let ahead = at + heading * (STEP + 0.5 * width);
        let nearness = ((coast.height(ahead) + clearance(width)) / SHY + 1.0).clamp(0.0, 1.0);
        let landward = direction(coast.slope(ahead));
        let along = direction(heading - landward * heading.dot(landward).max(0.0));
        let angle = libm::asinf(heading.perp_dot(along).clamp(-1.0, 1.0));
        turned(heading, angle.clamp(-AWAY, AWAY) * nearness)
    }

    /// Returns `true` if a branch can run on to a place, some way from where it begins.
    fn has_room(&self, at: Vec2, way: f32, width: f32, parent: Option<usize>) -> bool {
        let Site { domain, coast, apex, width: trunk, kept, .. } = self.site;
        let off_frame = domain.sides(at).into_iter().map(|(_, far)| far).fold(f32::INFINITY, fast_min);
        let is_near_apex = parent.is_none() && distance(at, apex) < 2.0 * trunk + 8.0;
        if off_frame < OFF_FRAME || (!is_near_apex && coast.height(at) > -clearance(width)) {
            return false;
        }
        work::count(kept.len());
        if kept.iter().any(|&(place, far)| distance(at, place) < far + 0.5 * width + 1.0) {
            return false;
        }
        // Its parent and the other arm begin where it does.
        let is_related = |i: usize, link: &Link| Some(i) == parent || link.parent == parent;
        self.links.iter().enumerate().all(|(i, link)| {
            work::count(link.line.len());
            let clear = 0.8 * (width + link.width) + 3.0;
            // Ahead of a tip there is to be room as well.
            let ahead = link.arms.is_none().then(|| [link.ahead, link.tip().midpoint(link.ahead)]);
            let mut places = link.line.iter().copied().chain(ahead.into_iter().flatten());
            (is_related(i, link) && way < 2.0 * clear)
                || Some(i) == parent
                || places.all(|at_it| distance(at, at_it) >= clear)
        })
    }
}

/// Returns the distance from the coast that a branch needs, in units.
fn clearance(width: f32) -> f32 {
    0.5 * width + 1.5
}

/// The sediment of a branch: by its width, and by its depth in units, more than on a shoal.
const COST: f32 = 6.0;
const SHOAL: f32 = 0.5;
const DEEP: f32 = 4.0;

/// Returns the depth of the sea at a distance from the coast that is negative there, both in units.
pub(super) fn depth(coast: f32) -> f32 {
    const DEEPEST: f32 = 12.0;
    const FAR: f32 = 80.0;
    DEEPEST * (1.0 - libm::expf(fast_min(coast, 0.0) / FAR))
}

/// Turns a direction by an angle.
pub(super) fn turned(way: Vec2, angle: f32) -> Vec2 {
    let (sine, cosine) = sine_and_cosine(angle);
    Vec2::new(way.x * cosine - way.y * sine, way.x * sine + way.y * cosine)
}
