//! Scenery: the trees and hills of a map, placed part by part.

use glam::Vec2;

use super::free::FreeGround;
use super::hills::hills;
use super::input::SceneryInput;
use super::scatter::scatter;
use super::standing::Standing;
use super::woods::woods;
use crate::annotate::divides::Divides;
use crate::base::sort;

/// The scenery of a map in the making.
#[derive(Clone, Debug, Default)]
pub struct Scenery {
    points: Option<Vec<Vec2>>,
    ground: Option<(FreeGround, Option<Divides>)>,
    hills: Option<Vec<Standing>>,
    all: Option<Vec<Standing>>,
}

impl Scenery {
    /// The greatest number of bytes that it takes, besides those of the pieces of rivers: points, cells, and glyphs.
    pub const BYTES: usize = 8_000_000;

    /// Places all of a map's scenery at once.
    pub fn whole(input: &SceneryInput<'_>) -> Vec<Standing> {
        let mut this = Self::default();
        while this.advance(input) {}
        this.all.unwrap_or_default()
    }

    /// Makes a part of a few milliseconds, of the same map each time. Returns whether there is more to do.
    pub fn advance(&mut self, input: &SceneryInput<'_>) -> bool {
        let Some(points) = &self.points else {
            self.points = Some(scatter(input.size, input.seed));
            return true;
        };
        let Some((ground, divides)) = &self.ground else {
            self.ground =
                Some((FreeGround::new(input), (input.hills > 0.0).then(|| Divides::new(input.size, input.network))));
            return true;
        };
        let Some(placed) = &self.hills else {
            let wanted = divides.as_ref().map_or_else(Vec::new, |divides| hills(input, points, ground, divides));
            self.hills = Some(wanted);
            return true;
        };
        if self.all.is_none() {
            let trees = if input.woods > 0.0 { woods(input, points, ground, placed) } else { Vec::new() };
            self.all = Some(from_behind(&placed.iter().copied().chain(trees).collect::<Vec<_>>()));
        }
        false
    }

    /// Returns the glyphs on the map, the hindmost first; none before all of the scenery is placed.
    pub fn placed(&self) -> &[Standing] {
        self.all.as_deref().unwrap_or_default()
    }
}

/// Sorts glyphs by y, then x, then number.
fn from_behind(all: &[Standing]) -> Vec<Standing> {
    // One copy of the sort for the three keys.
    let sorted = |all: &[Standing], key: &dyn Fn(&Standing) -> u32| sort::sorted_by(all, key);
    let all = sorted(all, &|one| one.number);
    let all = sorted(&all, &|one| sort::key(one.foot.x));
    sorted(&all, &|one| sort::key(one.foot.y))
}
