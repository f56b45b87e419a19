//! Layouts: where the spines of an island, of an archipelago or of a lake lie. Each is one of many drafts.

use glam::Vec2;

use super::spine::Spine;
use crate::base::geometry::{direction, distance, length};
use crate::base::random::ItemHash;
use crate::base::trigonometry::sine_and_cosine;

use std::f32::consts::PI;

/// The random numbers of one draft, one after the other.
pub(super) struct Dice {
    hash: ItemHash,
    draft: u32,
    next: u32,
}

impl Dice {
    pub fn new(hash: ItemHash, draft: u32) -> Self {
        Self { hash, draft, next: 0 }
    }

    /// A number from `least` to `most`.
    pub fn between(&mut self, least: f32, most: f32) -> f32 {
        /// Apart from all other items of land.
        const DRAFTS: u32 = 100;
        self.next += 1;
        least + (most - least) * self.hash.unit([DRAFTS, self.draft, self.next])
    }

    /// A number from 0 to 1, more often about a half than near the ends.
    pub fn middling(&mut self) -> f32 {
        0.5 * (self.between(0.0, 1.0) + self.between(0.0, 1.0))
    }

    /// Tells whether a thing of some likelihood happens.
    pub fn is(&mut self, likelihood: f32) -> bool {
        self.between(0.0, 1.0) < likelihood
    }

    /// A number from `least` to `most`, either positive or negative.
    pub fn either(&mut self, least: f32, most: f32) -> f32 {
        let sign = if self.is(0.5) { -1.0 } else { 1.0 };
        sign * self.between(least, most)
    }

    /// A whole number from `least` to `most`.
    pub fn count(&mut self, least: u32, most: u32) -> u32 {
        (self.between(least as f32, most as f32 + 1.0) as u32).min(most)
    }

    /// A unit vector in any direction.
    pub fn direction(&mut self) -> Vec2 {
        turned(Vec2::X, self.between(-PI, PI))
    }
}

/// Rotates a vector by an angle of up to π.
pub(super) fn turned(vector: Vec2, angle: f32) -> Vec2 {
    let (sine, cosine) = sine_and_cosine(angle);
    Vec2::new(cosine, sine).rotate(vector)
}

/// A cubic curve (Bézier).
#[derive(Clone, Copy)]
struct Curve([Vec2; 4]);

impl Curve {
    /// A curve between two points that bends aside by shares of its length, after a third and after two thirds of it.
    fn bent(from: Vec2, to: Vec2, bends: [f32; 2]) -> Self {
        let (along, aside) = (to - from, (to - from).perp());
        let control = |share: f32, bend: f32| from + along * share + aside * (bend * 4.0 / 3.0);
        Self([from, control(0.333, bends[0]), control(0.667, bends[1]), to])
    }

    fn at(&self, t: f32) -> Vec2 {
        let [a, b, c, d] = self.0;
        let s = 1.0 - t;
        a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
    }

    /// The direction in which the curve runs, as long as a whole pass at that speed.
    fn way(&self, t: f32) -> Vec2 {
        (self.at((t + 0.05).min(1.0)) - self.at((t - 0.05).max(0.0)))
            * if (0.05..=0.95).contains(&t) { 10.0 } else { 20.0 }
    }

    /// The length, about.
    fn length(&self) -> f32 {
        distance(self.at(0.0), self.at(0.5)) + distance(self.at(0.5), self.at(1.0))
    }

    fn reversed(&self) -> Self {
        let [a, b, c, d] = self.0;
        Self([d, c, b, a])
    }

    /// A spine along the curve, with a half width at each place.
    fn spine(&self, pieces: u32, width: impl Fn(f32) -> f32) -> Spine {
        let place = |i: u32| i as f32 / pieces as f32;
        Spine::new((0..=pieces).map(|i| (self.at(place(i)), width(place(i)))).collect())
    }
}

/// Grows from `end` at both ends to 1 at `middle`.
fn swelling(t: f32, middle: f32, end: f32) -> f32 {
    let off = if t < middle { (middle - t) / middle } else { (t - middle) / (1.0 - middle) };
    end + (1.0 - end) * (1.0 - off * off)
}

/// The spines of an island with its lesser ones: a bent main spine, branches of it, perhaps one beside it en échelon,
/// and islets in line with them. They cover about `area` square units within a rectangle of this size.
pub(super) fn island(dice: &mut Dice, size: Vec2, area: f32) -> Vec<Spine> {
    let (mut spines, curves) = masses(dice, size, area);
    let widest = spines.first().map_or(0.0, Spine::widest);
    for (number, curve) in curves.iter().enumerate() {
        // The main spine may go on at both of its ends, a branch at its tip.
        let is_main = number == 0;
        if is_main && dice.is(0.55) {
            let width = widest * dice.between(0.25, 0.5);
            islets(dice, &curve.reversed(), width, &mut spines);
        }
        if dice.is(if is_main { 0.55 } else { 0.4 }) {
            let width = widest * if is_main { dice.between(0.25, 0.5) } else { dice.between(0.15, 0.3) };
            islets(dice, curve, width, &mut spines);
        }
    }
    placed(dice, spines, size)
}

/// The spines of a lake: like those of an island, but without lesser ones.
pub(super) fn lake(dice: &mut Dice, size: Vec2, area: f32) -> Vec<Spine> {
    let (spines, _) = masses(dice, size, area);
    placed(dice, spines, size)
}

/// The spines of the main island, and their curves.
fn masses(dice: &mut Dice, size: Vec2, area: f32) -> (Vec<Spine>, Vec<Curve>) {
    let way = roomier(dice, size);
    let room = room(size, way);
    let long = room * dice.between(0.5, 1.0);
    let bend = dice.either(0.02, 0.3);
    let bends = [bend, if dice.is(0.3) { -bend } else { bend * dice.between(0.3, 1.3) }];
    let curve = Curve::bent(way * (-0.5 * long), way * (0.5 * long), bends);
    let (mut spines, mut curves) = (vec![main_spine(dice, curve, long)], vec![curve]);
    for _ in 0..dice.count(1, if long < 0.75 * room { 4 } else { 3 }) {
        let (branch, curve) = branch(dice, curve, long);
        spines.push(branch);
        curves.push(curve);
    }
    if dice.is(0.45) {
        spines.push(beside(dice, curve, long));
    }
    let widened = widened(&spines, area * dice.between(0.86, 0.95));
    (spines.iter().map(|spine| spine.widened(widened)).collect(), curves)
}

/// The length of a line of a direction through the middle of a rectangle, within a border.
fn room(size: Vec2, way: Vec2) -> f32 {
    let inner = (size - 0.12 * size.min_element()) / way.abs().max(Vec2::splat(1e-3));
    inner.min_element()
}

/// One of two directions, mostly the one in which there is more room.
fn roomier(dice: &mut Dice, size: Vec2) -> Vec2 {
    // Most directions of a long rectangle lead across it at once.
    let slender = (size / size.min_element()).map(f32::sqrt);
    let ways = [dice.direction(), dice.direction()].map(|way| direction(way * slender));
    let first_is_roomier = room(size, ways[0]) > room(size, ways[1]);
    ways[usize::from(first_is_roomier != dice.is(0.85))]
}

/// The main spine: widest at one place, with waists and swellings.
fn main_spine(dice: &mut Dice, curve: Curve, long: f32) -> Spine {
    let (middle, end) = (dice.between(0.2, 0.8), dice.between(0.05, 0.45));
    let (waves, phase, depth) = (dice.between(1.0, 2.6), dice.between(-0.5, 0.5), dice.between(0.1, 0.5));
    curve.spine(10, |t| {
        let (wave, _) = sine_and_cosine(wrapped(waves * t + phase));
        0.12 * long * swelling(t, middle, end) * (1.0 + depth * wave)
    })
}

/// The angle of a number of turns, from −π to π.
fn wrapped(turns: f32) -> f32 {
    (turns - turns.round()) * (2.0 * PI)
}

/// A branch from the main spine outward, tapering: a peninsula.
fn branch(dice: &mut Dice, curve: Curve, long: f32) -> (Spine, Curve) {
    let t = dice.between(0.05, 0.95);
    let way = direction(curve.way(t));
    // Near an end a branch leans outward more often, as the arms of a fork do.
    let ahead = if dice.is(t) { way } else { -way };
    let out = turned(ahead, dice.either(0.5, 1.45));
    let reach = long * dice.between(0.2, 0.48);
    let bend = dice.either(0.0, 0.25);
    let width = long * dice.between(0.045, 0.085);
    let tip = dice.between(0.1, 0.6);
    let from = curve.at(t);
    let branch = Curve::bent(from, from + out * reach, [bend, bend]);
    (branch.spine(6, |t| width * (1.0 + (tip - 1.0) * t)), branch)
}

/// A lesser spine beside the main one, shifted along it: en échelon.
fn beside(dice: &mut Dice, curve: Curve, long: f32) -> Spine {
    let t = dice.between(0.1, 0.9);
    let way = direction(curve.way(t));
    let middle = curve.at(t) + way.perp() * (long * dice.either(0.2, 0.34));
    let half = turned(way, dice.either(0.0, 0.5)) * (long * dice.between(0.12, 0.32));
    let bend = dice.either(0.0, 0.2);
    let width = long * dice.between(0.04, 0.09);
    let highest = dice.between(0.3, 0.7);
    Curve::bent(middle - half, middle + half, [bend, bend]).spine(6, |t| width * swelling(t, highest, 0.2))
}

/// Islets that go on where a curve ends, from a half width on smaller and smaller.
fn islets(dice: &mut Dice, curve: &Curve, widest: f32, spines: &mut Vec<Spine>) {
    let mut way = direction(curve.way(1.0));
    let (turn, mut width) = (dice.either(0.05, 0.35), widest);
    let mut at = curve.at(1.0) + way * (width * dice.between(1.2, 2.2));
    for _ in 0..dice.count(1, 5) {
        way = turned(way, turn);
        at += way * (width * dice.between(1.8, 3.2));
        let half = turned(way, dice.either(0.0, 0.8)) * (width * dice.between(0.3, 1.2));
        let off = way.perp() * (width * dice.either(0.0, 0.8));
        spines.push(
            Curve::bent(at + off - half, at + off + half, [0.1, 0.1]).spine(3, |t| width * swelling(t, 0.5, 0.5)),
        );
        width *= dice.between(0.55, 0.9);
    }
}

/// The factor by which half widths must grow so that spines cover an area.
fn widened(spines: &[Spine], area: f32) -> f32 {
    /// The share of the area of spines that lies on no other.
    const APART: f32 = 0.82;
    let piece = |pair: &[(Vec2, f32)]| distance(pair[0].0, pair[1].0) * (pair[0].1 + pair[1].1);
    let covered: f32 = spines.iter().map(|spine| spine.points().windows(2).map(piece).sum::<f32>()).sum();
    area / (APART * covered).max(1.0)
}

/// Moves spines to a random place of a rectangle where there is room for them; too large ones shrink.
fn placed(dice: &mut Dice, spines: Vec<Spine>, size: Vec2) -> Vec<Spine> {
    let border = 0.075 * size.min_element();
    let all = || spines.iter().flat_map(|spine| spine.points());
    let low = all().map(|(at, width)| *at - 0.8 * width).fold(Vec2::INFINITY, Vec2::min);
    let high = all().map(|(at, width)| *at + 0.8 * width).fold(Vec2::NEG_INFINITY, Vec2::max);
    let inner = size - 2.0 * border;
    let shrunk = (inner / (high - low).max(Vec2::ONE)).min_element().min(1.0);
    let free = (inner - (high - low) * shrunk).max(Vec2::ZERO);
    let corner = border + free * Vec2::new(dice.middling(), dice.middling());
    let place = |(at, width): &(Vec2, f32)| ((*at - low) * shrunk + corner, width * shrunk);
    spines.iter().map(|spine| Spine::new(spine.points().iter().map(place).collect())).collect()
}

/// The summits of drowned ranges: short spines in rows along arcs. Areas fall with a power of the rank (Korčak 1940).
pub(super) fn archipelago(dice: &mut Dice, size: Vec2, area: f32) -> Vec<Spine> {
    /// The exponent of areas over ranks.
    const FALL: f32 = 0.7;
    let arcs = arcs(dice, size);
    let count = dice.count(12, 17);
    let shares: Vec<f32> = (1..=count).map(|rank| libm::powf(rank as f32, -FALL)).collect();
    let whole: f32 = shares.iter().sum();
    let mut rows: Vec<Vec<f32>> = arcs.iter().map(|_| Vec::new()).collect();
    for share in shares {
        let area = share / whole * area;
        // Most likely where there is room. A row that is full takes no more.
        let room =
            |row: usize, rows: &[Vec<f32>]| arcs[row].length() - rows[row].iter().map(|area| laid(*area)).sum::<f32>();
        let chances: Vec<f32> = (0..arcs.len()).map(|row| room(row, &rows) * dice.between(0.4, 1.0)).collect();
        let row = (0..arcs.len()).fold(0, |best, row| if chances[row] > chances[best] { row } else { best });
        // As likely at one end of a row as at the other.
        let place = dice.count(0, rows[row].len() as u32) as usize;
        rows[row].insert(place, area);
    }
    let mut spines: Vec<Spine> = Vec::new();
    for (arc, areas) in arcs.iter().zip(&rows) {
        row(dice, arc, areas, &mut spines);
    }
    for _ in 0..dice.count(20, 36) {
        spines.extend(stray(dice, &arcs, &spines, size));
    }
    placed(dice, spines, size)
}

/// The length of an island of some area and of the strait beside it, about.
fn laid(area: f32) -> f32 {
    1.9 * area.sqrt() + 85.0
}

/// Three or four arcs, the longest first, aslant beside one another.
fn arcs(dice: &mut Dice, size: Vec2) -> Vec<Curve> {
    let way = roomier(dice, size);
    let (room, span) = (room(size, way), size.min_element());
    let bend = dice.either(0.05, 0.26);
    let side = dice.either(0.24, 0.34);
    let mut arcs = Vec::new();
    for number in 0..dice.count(3, 4) {
        let (off, long) = match number {
            0 => (0.0, dice.between(0.95, 1.15)),
            1 => (side, dice.between(0.7, 1.0)),
            2 => (-side, dice.between(0.5, 0.9)),
            _ => (2.0 * side, dice.between(0.3, 0.6)),
        };
        let way = turned(way, if number == 0 { 0.0 } else { dice.either(0.0, 0.35) });
        let middle = size / 2.0 + way.perp() * (off * span) + way * (room * dice.either(0.0, 0.18));
        let half = way * (0.5 * long * room);
        let bends = [0, 1].map(|_| bend * dice.between(0.5, 1.4));
        arcs.push(Curve::bent(middle - half, middle + half, bends));
    }
    fitted(arcs, size)
}

/// Moves curves to the middle of a rectangle; too large ones shrink to its inner part.
fn fitted(curves: Vec<Curve>, size: Vec2) -> Vec<Curve> {
    let border = 0.1 * size.min_element();
    let points = || curves.iter().flat_map(|curve| (0..=8).map(|i| curve.at(i as f32 / 8.0)));
    let low = points().fold(Vec2::INFINITY, Vec2::min);
    let high = points().fold(Vec2::NEG_INFINITY, Vec2::max);
    let shrunk = ((size - 2.0 * border) / (high - low).max(Vec2::ONE)).min(Vec2::ONE);
    let place = |at: Vec2| (at - (low + high) / 2.0) * shrunk + size / 2.0;
    curves.iter().map(|curve| Curve(curve.0.map(place))).collect()
}

/// Adds a row of islands of these areas along an arc. They are as long as leaves straits between them.
fn row(dice: &mut Dice, arc: &Curve, areas: &[f32], spines: &mut Vec<Spine>) {
    let long = arc.length();
    let halves: Vec<f32> = areas.iter().map(|area| area.sqrt() * dice.between(0.75, 1.4)).collect();
    let straits: Vec<f32> = areas.iter().map(|_| dice.between(45.0, 130.0)).collect();
    let laid: f32 = halves.iter().map(|half| 2.0 * half).chain(straits.iter().copied()).sum();
    let fitted = (long / laid.max(1.0)).min(1.3);
    let lean = dice.either(0.0, 0.4);
    let mut t = dice.between(0.0, 1.0) * (1.0 - fitted * laid / long).max(0.0);
    for ((area, half), strait) in areas.iter().zip(halves).zip(straits) {
        let half_share = half * fitted / long;
        let (from, to) = (arc.at(t), arc.at((t + 2.0 * half_share).min(1.0)));
        t += 2.0 * half_share + strait * fitted / long;
        let width = area / (3.1 * half * fitted).max(1.0);
        let aside = (to - from).perp() * dice.either(0.0, 0.2);
        let middle = (from + to) / 2.0 + aside;
        let half = turned((to - from) / 2.0, lean * dice.between(0.5, 1.0));
        let bend = dice.either(0.02, 0.22);
        let (swollen, end) = (dice.between(0.2, 0.8), dice.between(0.1, 0.5));
        // A half width counts beyond the ends, too.
        let inner = half * (1.0 - 0.5 * end * width / half.length().max(width)).max(0.1);
        spines.push(
            Curve::bent(middle - inner, middle + inner, [bend, bend])
                .spine(6, |t| 1.15 * width * swelling(t, swollen, end)),
        );
    }
}

/// A small island beside an arc; `None` if there is no room at the place.
fn stray(dice: &mut Dice, arcs: &[Curve], spines: &[Spine], size: Vec2) -> Option<Spine> {
    let arc = arcs.get(dice.count(0, arcs.len() as u32 - 1) as usize)?;
    let t = dice.between(0.0, 1.0);
    let way = direction(arc.way(t));
    let at = arc.at(t) + way.perp() * dice.either(0.02, 0.2) * size.min_element();
    let width = 10.0 + 26.0 * dice.between(0.0, 1.0) * dice.between(0.0, 1.0);
    let half = turned(way, dice.either(0.0, 0.7)) * (width * dice.between(0.4, 2.2));
    let highest = spines.iter().map(|spine| spine.height(at)).fold(f32::NEG_INFINITY, f32::max);
    let has_room = highest < -1.6 * width - 10.0;
    has_room.then(|| Curve::bent(at - half, at + half, [0.1, 0.1]).spine(3, |t| width * swelling(t, 0.5, 0.5)))
}
