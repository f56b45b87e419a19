//! Coasts along chosen sides of the domain, with gulfs, peninsulas and islands.

use fastnoise_lite::FastNoiseLite;
use glam::{Vec2, Vec2Swizzles};

use super::kinds::Shape;
use super::layout::Dice;
use super::spine::{Spine, highest, smooth_max};
use crate::domain::Domain;
use crate::recipe::LandKind;

/// The coasts of a land that runs off the map.
pub(super) struct Coasts {
    domain: Domain,
    /// The sides with the sea, as the numbers of `sides`, and the slants of their coasts from end to end as shares of
    /// the domain.
    slants: Vec<(usize, f32)>,
    /// The mean distance of the coast from its side, in units.
    depth: f32,
    /// The difference of heights up to which coasts of two sides pass into one another, in units.
    round: f32,
    /// Peninsulas and islands.
    land: Vec<Spine>,
    gulfs: Vec<Spine>,
}

impl Coasts {
    pub fn new(shape: &Shape, dice: &mut Dice) -> Self {
        let domain = shape.domain;
        let sea = shape.sea;
        let most = if shape.kind == LandKind::Valley { 0.35 } else { 0.75 };
        let chosen: Vec<usize> = (0..4).filter(|&i| shape.sides.contains(SIDES[i])).collect();
        let slants: Vec<(usize, f32)> = (0..4)
            .map(|i| (i, dice.either(0.2, 1.0) * most * sea.min(1.0 - sea)))
            .filter(|(i, _)| chosen.contains(i))
            .collect();
        let length: f32 = chosen.iter().map(|&i| if i % 2 == 0 { domain.size.x } else { domain.size.y }).sum();
        let depth = sea * domain.size.x * domain.size.y / length.max(1.0);
        let mut this = Self { domain, slants, depth, round: 0.5 * shape.span(), land: Vec::new(), gulfs: Vec::new() };
        for side in chosen {
            let capes = shape.capes(SIDES[side]);
            this.furnish(dice, side, shape.span(), &capes);
        }
        this
    }

    /// Adds peninsulas, islands and gulfs to a side. Where ridges reach it (`capes`), peninsulas lie there, and a gulf
    /// between them.
    fn furnish(&mut self, dice: &mut Dice, side: usize, span: f32, capes: &[f32]) {
        let reach = self.depth.min(0.4 * span);
        let anywhere = dice.count(1, 3).saturating_sub(capes.len() as u32);
        let places: Vec<f32> = capes.iter().copied().chain((0..anywhere).map(|_| dice.between(0.05, 0.95))).collect();
        for along in places {
            let lean = dice.either(0.0, if capes.is_empty() { 0.3 } else { 0.08 });
            let (tip, width) = (dice.between(0.1, 0.6) * reach, dice.between(0.03, 0.08) * span);
            let from = self.place(side, along, self.depth + 0.1 * span);
            let to = self.place(side, along + lean, tip);
            self.land.push(bent(dice, from, to, width, 0.45));
        }
        for _ in 0..dice.count(1, 4) {
            let (along, off) = (dice.between(0.0, 1.0), dice.between(0.2, 0.7) * reach);
            let half = dice.direction() * dice.between(0.01, 0.06) * span;
            let middle = self.place(side, along, off);
            let width = dice.between(0.012, 0.04) * span;
            self.land.push(bent(dice, middle - half, middle + half, width, 0.7));
        }
        for number in 0..dice.count(1, 2) {
            let along = match capes {
                [first, second] if number == 0 => first + (second - first) * dice.between(0.3, 0.7),
                _ => dice.between(0.1, 0.9),
            };
            let (head, lean) = if capes.is_empty() { (0.35, 0.3) } else { (0.2, 0.1) };
            let (head, lean) = (dice.between(0.1, head) * span, dice.either(0.0, lean));
            let width = dice.between(0.025, 0.075) * span;
            let from = self.place(side, along, 0.7 * self.depth);
            let to = self.place(side, along + lean, self.depth + head);
            self.gulfs.push(bent(dice, from, to, width, 0.3));
        }
    }

    /// The place so far along a side, as a share of it, and so far from it, in units.
    fn place(&self, side: usize, along: f32, off: f32) -> Vec2 {
        let size = self.domain.size;
        match side {
            0 => Vec2::new(along * size.x, off),
            1 => Vec2::new(size.x - off, along * size.y),
            2 => Vec2::new(along * size.x, size.y - off),
            _ => Vec2::new(off, along * size.y),
        }
    }

    /// The height of a point, in units.
    pub fn height(&self, at: Vec2) -> f32 {
        let size = self.domain.size;
        let off = (at / size - 0.5) * size.yx();
        let distance = |&(side, slant): &(usize, f32)| {
            let off = if side % 2 == 0 { off.x } else { off.y };
            self.domain.sides(at)[side].1 + slant * off
        };
        let inland = self.slants.iter().map(distance).fold(1e4, |a, b| -smooth_max(-a, -b, self.round)) - self.depth;
        let land = smooth_max(inland, highest(&self.land, at, 40.0), 40.0);
        -smooth_max(-land, highest(&self.gulfs, at, 40.0), 40.0)
    }
}

/// The initials of sides, clockwise from the north.
const SIDES: [char; 4] = ['n', 'e', 's', 'w'];

/// A spine with a bend, from its full width to a share of it.
fn bent(dice: &mut Dice, from: Vec2, to: Vec2, width: f32, tip: f32) -> Spine {
    let bend = (to - from).perp() * dice.either(0.0, 0.3);
    let at = |t: f32| from.lerp(to, t) + bend * (4.0 * t * (1.0 - t));
    Spine::new((0..=5).map(|i| i as f32 / 5.0).map(|t| (at(t), width * (1.0 + (tip - 1.0) * t))).collect())
}
