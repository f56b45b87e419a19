//! A style's look in the colours of a climate.

use super::climate::{Climate, Climates, Ramp, mixed};
use super::look::{Look, haloed};
use crate::paint::palette::ReliefLook;

impl Look {
    /// Returns the look in a climate.
    pub fn in_climate(&self, climate: Climate) -> Self {
        let Some(temperate) = self.ramp().filter(|_| climate != Climate::TEMPERATE) else { return *self };
        match self.climates {
            Climates::Alike => *self,
            Climates::Ramps(&four) => self.coloured(&mixed(temperate, four, climate)),
            Climates::Tinges(four) => {
                let heights = self.palette.relief.map_or([0.0; _], |relief| relief.tints.stops.map(|stop| stop.0));
                self.coloured(&mixed(temperate, four.map(|tinge| temperate.tinged(tinge, heights)), climate))
            }
        }
    }

    /// Returns the look in the colours of a ramp.
    fn coloured(&self, ramp: &Ramp) -> Self {
        let mut look = *self;
        let palette = &mut look.palette;
        (palette.lowland, palette.inland, palette.plain) = (ramp.lowland, ramp.land, ramp.land);
        (palette.deep, palette.shallows, palette.coast) = (ramp.water, ramp.shallows, ramp.coast);
        palette.river = ramp.river;
        if let Some(paper) = &mut palette.paper {
            paper.blotch = ramp.blotch;
        }
        if let Some(ReliefLook { tints, casing, .. }) = &mut palette.relief {
            tints.stops.iter_mut().zip(ramp.tints).for_each(|(stop, tint)| stop.1 = tint);
            (tints.shadow, tints.highlight) = (ramp.shadow, ramp.light);
            (casing.colour, casing.strength) = (ramp.casing, ramp.cased);
        }
        look.labels = haloed(ramp.letters, ramp.halo, look.labels.halo.map_or(0.0, |halo| halo.1));
        if let Some(scenery) = &mut look.scenery {
            scenery.ink = ramp.trees;
            scenery.body = scenery.body.map(|(_, covers)| (ramp.land, covers));
        }
        look
    }

    /// Takes the colours that a climate can change; `None` if the style has no relief.
    fn ramp(&self) -> Option<Ramp> {
        let Self { palette, labels, scenery, .. } = self;
        let ReliefLook { tints, casing, .. } = palette.relief?;
        Some(Ramp {
            tints: tints.stops.map(|stop| stop.1),
            shadow: tints.shadow,
            light: tints.highlight,
            land: palette.plain,
            lowland: palette.lowland,
            blotch: palette.paper.map_or([0; 3], |paper| paper.blotch),
            water: palette.deep,
            shallows: palette.shallows,
            coast: palette.coast,
            river: palette.river,
            casing: casing.colour,
            cased: casing.strength,
            letters: labels.ink,
            halo: labels.panel,
            trees: scenery.map_or([0; 3], |scenery| scenery.ink),
        })
    }
}
