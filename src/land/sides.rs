//! Coasts along chosen sides of the domain, with gulfs, peninsulas and islands.

use glam::{Vec2, Vec2Swizzles};

use super::draws::Draws;
use super::kinds::Shape;
use super::spine::{Spine, Spines, smooth_max};
use crate::domain::Domain;
use crate::recipe::LandKind;

/// The coasts of a land that runs off the map.
pub(super) struct Coasts {
    domain: Domain,
    /// The sides with the sea, as indices of `SIDES`, and the slants of their coasts from end to end as shares of the
    /// domain.
    slants: Vec<(usize, f32)>,
    /// The mean distance of the coast from its side, in units.
    depth: f32,
    /// The difference of heights up to which the coasts of two sides blend, in units.
    round: f32,
    /// Peninsulas and islands.
    land: Spines,
    gulfs: Spines,
}

impl Coasts {
    pub fn new(shape: &Shape) -> Self {
        let (size, sea) = (shape.domain.size, shape.sea);
        // Each part of a valley, between and beside its ridges, needs a coast.
        let most = if shape.kind == LandKind::Valley { 0.35 } else { 0.75 } * sea.min(1.0 - sea);
        let chosen: Vec<usize> = (0..4).filter(|&i| shape.sides.contains(SIDES[i])).collect();
        let length: f32 = chosen.iter().map(|&i| if i % 2 == 0 { size.x } else { size.y }).sum();
        let depth = sea * size.x * size.y / length.max(1.0);
        let (mut slants, mut land, mut gulfs) = (Vec::new(), Vec::new(), Vec::new());
        for side in chosen {
            // Each side keeps its coast, whichever other sides have the sea.
            let mut draws = Draws::new(shape, side as u32);
            slants.push((side, draws.either(0.2, 1.0) * most));
            let side = Side { number: side, size, span: shape.span(), depth, capes: shape.capes(SIDES[side]) };
            side.peninsulas(&mut draws, &mut land);
            side.islands(&mut draws, &mut land);
            side.gulfs(&mut draws, &mut gulfs);
        }
        let [land, gulfs] = [land, gulfs].map(|spines| Spines::new(&spines, size, ROUND));
        Self { domain: shape.domain, slants, depth, round: 0.5 * shape.span(), land, gulfs }
    }

    /// Returns the height of a point, in units.
    pub fn height(&self, at: Vec2) -> f32 {
        let size = self.domain.size;
        let off = (at / size - 0.5) * size.yx();
        let distance = |&(side, slant): &(usize, f32)| {
            let off = if side % 2 == 0 { off.x } else { off.y };
            self.domain.sides(at)[side].1 + slant * off
        };
        let inland = self.slants.iter().map(distance).fold(1e4, |a, b| -smooth_max(-a, -b, self.round)) - self.depth;
        let land = smooth_max(inland, self.land.height(at), ROUND);
        -smooth_max(-land, self.gulfs.height(at), ROUND)
    }
}

/// A side with the sea, to which peninsulas, islands and gulfs are added.
struct Side {
    /// The index of the side, clockwise from the north.
    number: usize,
    size: Vec2,
    /// The shorter side of the domain, in units.
    span: f32,
    /// The mean distance of the coast from the side, in units.
    depth: f32,
    /// The places along the side where ridges reach it, as shares of its length.
    capes: Vec<f32>,
}

impl Side {
    /// Returns the place at a distance along the side, as a share of it, and at a distance from it, in units.
    fn place(&self, along: f32, off: f32) -> Vec2 {
        let size = self.size;
        match self.number {
            0 => Vec2::new(along * size.x, off),
            1 => Vec2::new(size.x - off, along * size.y),
            2 => Vec2::new(along * size.x, size.y - off),
            _ => Vec2::new(off, along * size.y),
        }
    }

    /// Returns the distance from the side up to which land lies off the coast, in units.
    fn reach(&self) -> f32 {
        self.depth.min(0.4 * self.span)
    }

    /// Adds peninsulas: where ridges reach the sea, or anywhere.
    fn peninsulas(&self, draws: &mut Draws, land: &mut Vec<Spine>) {
        let anywhere = draws.count(1, 3).saturating_sub(self.capes.len() as u32);
        let places: Vec<f32> = (0..anywhere).map(|_| draws.between(0.05, 0.95)).collect();
        for along in self.capes.iter().copied().chain(places) {
            let lean = draws.either(0.0, if self.capes.is_empty() { 0.3 } else { 0.08 });
            let (tip, width) = (draws.between(0.1, 0.6) * self.reach(), draws.between(0.03, 0.08) * self.span);
            let from = self.place(along, self.depth + 0.1 * self.span);
            land.push(bent(draws, from, self.place(along + lean, tip), width, 0.45));
        }
    }

    /// Adds islands off the coast.
    fn islands(&self, draws: &mut Draws, land: &mut Vec<Spine>) {
        for _ in 0..draws.count(1, 4) {
            let middle = self.place(draws.between(0.0, 1.0), draws.between(0.2, 0.7) * self.reach());
            let half = draws.direction() * draws.between(0.01, 0.06) * self.span;
            let width = draws.between(0.012, 0.04) * self.span;
            land.push(bent(draws, middle - half, middle + half, width, 0.7));
        }
    }

    /// Adds gulfs, the first between the ridges if there are any.
    fn gulfs(&self, draws: &mut Draws, gulfs: &mut Vec<Spine>) {
        let (farthest, most) = if self.capes.is_empty() { (0.35, 0.3) } else { (0.2, 0.1) };
        for number in 0..draws.count(1, 2) {
            let along = match self.capes[..] {
                [first, second] if number == 0 => first + (second - first) * draws.between(0.3, 0.7),
                _ => draws.between(0.1, 0.9),
            };
            let (head, lean) = (draws.between(0.1, farthest) * self.span, draws.either(0.0, most));
            let width = draws.between(0.035, 0.08) * self.span;
            let from = self.place(along, 0.4 * self.depth);
            gulfs.push(bent(draws, from, self.place(along + lean, self.depth + head), width, 0.3));
        }
    }
}

/// The difference of heights up to which a spine and the coast blend, in units.
const ROUND: f32 = 40.0;

/// The initials of sides, clockwise from the north.
const SIDES: [char; 4] = ['n', 'e', 's', 'w'];

/// Makes a spine with a bend, whose half width goes from `width` to a share of it at the tip.
fn bent(draws: &mut Draws, from: Vec2, to: Vec2, width: f32, tip: f32) -> Spine {
    let bend = (to - from).perp() * draws.either(0.0, 0.3);
    let at = |t: f32| from.lerp(to, t) + bend * (4.0 * t * (1.0 - t));
    Spine::new((0..=5).map(|i| i as f32 / 5.0).map(|t| (at(t), width * (1.0 + (tip - 1.0) * t))).collect())
}
