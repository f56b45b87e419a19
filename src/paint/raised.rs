//! Ground with relief: a relief is laid on flat ground, some rows at a time.

use std::sync::Arc;

use super::beyond;
use super::coverage::Coverage;
use super::flat::{FlatGround, plain};
use super::ground::{Ground, ShownCoast};
use super::palette::{LAND_ONLY, Palette, ReliefLook, Tints};
use super::relief::{Inks, Prepared, ReliefDisplay, Sheet, tints_of};
use super::rivers::{Rivers, Widening, draw_network, is_same_lakes};
use super::settings::PaintSettings;
use super::styles::palette;
use super::view::{Rows, View};
use super::waters::Waters;
use crate::lakes::Lakes;
use crate::land::Land;
use crate::relief::{Relief, Wind};

/// The share of land in each pixel, in 255ths, from north to south as far as it is known.
#[derive(Clone, Debug)]
pub(super) struct LandShares {
    /// The painter of land alone; `None` if there is no sea, and once everything is painted.
    coast: Option<Ground>,
    shares: Vec<u8>,
}

impl LandShares {
    pub fn new(view: &View, land: Option<&Land>, shown: Option<ShownCoast<'_>>) -> Self {
        let coast = land.zip(shown).map(|(land, shown)| Ground::new(view, land, shown.smooth, (&LAND_ONLY, None)));
        let mut shares = if coast.is_some() { Vec::with_capacity(view.pixels()) } else { vec![255; view.pixels()] };
        if coast.is_none() && view.shows_beyond() {
            drop_beyond(view, 0..view.height, &mut shares);
        }
        Self { coast, shares }
    }

    /// Works out some more rows, if any are left. Returns `true` if there are more.
    pub fn advance(&mut self, view: &View, shown: Option<ShownCoast<'_>>) -> bool {
        let (Some(coast), Some(shown)) = (&mut self.coast, shown) else { return false };
        let (rows, mut pixels) = (view.next_rows(self.shares.len()), Vec::new());
        coast.paint(view, shown, rows.clone(), &mut pixels);
        self.shares.extend(pixels.into_iter().map(|[share, ..]| share));
        if view.shows_beyond() {
            drop_beyond(view, rows.clone(), &mut self.shares[view.range(rows.clone())]);
        }
        self.coast.take_if(|_| rows.end == view.height);
        self.coast.is_some()
    }

    pub fn of_pixels(&self) -> &[u8] {
        &self.shares
    }
}

/// Makes the pixels of some rows that lie beyond the map no land.
#[inline(never)] // one copy
fn drop_beyond(view: &View, rows: Rows, shares: &mut [u8]) {
    beyond::for_each(view, rows, shares, |share, _| *share = 0);
}

/// Ground with relief, as far as it is painted.
#[derive(Clone, Debug)]
pub(super) struct RaisedGround {
    relief: Arc<Relief>,
    lakes: Option<Arc<Lakes>>,
    display: ReliefDisplay,
    wind: Option<Wind>,
    palette: Palette,
    /// The means of painting it; `None` once everything is painted.
    making: Option<Making>,
    pixels: Vec<[u8; 4]>,
}

#[derive(Clone, Debug)]
struct Making {
    look: ReliefLook,
    /// Its tints at each level of rain.
    tints: Vec<Tints>,
    /// Rivers with their casings, if the look depends on rivers.
    rivers: Coverage,
    inks: Option<Inks>,
}

impl RaisedGround {
    /// Begins the ground. `None` if it would have no pixels.
    pub fn new(look: ReliefLook, relief: &Arc<Relief>, view: &View, rivers: &Rivers<'_>) -> Option<Self> {
        let PaintSettings { scheme, relief: display, wind, .. } = rivers.settings;
        let palette = palette(scheme);
        let mut cased = Waters::of(Coverage::new(view.width, view.height)?);
        if look.minds_rivers() {
            let wider = Widening { margin: look.casing.margin, ..Widening::NONE };
            draw_network(&mut cased, view, rivers.inland(), rivers.settings.courses, palette.lines, wider);
        }
        let making = Some(Making { look, tints: tints_of(scheme, wind), rivers: cased.banks, inks: None });
        let (relief, lakes, pixels) = (relief.clone(), rivers.lakes.cloned(), Vec::with_capacity(view.pixels()));
        Some(Self { relief, lakes, display, wind, palette, making, pixels })
    }

    /// Returns `true` if it is made from this relief, with these lakes, shown like this.
    pub fn is_of(&self, relief: &Arc<Relief>, lakes: Option<&Arc<Lakes>>, settings: &PaintSettings) -> bool {
        Arc::ptr_eq(&self.relief, relief)
            && is_same_lakes(self.lakes.as_ref(), lakes)
            && (self.display, self.wind) == (settings.relief, settings.wind)
    }

    pub fn pixels(&self) -> &[[u8; 4]] {
        &self.pixels
    }

    /// Returns `true` if all of it is painted.
    pub fn is_whole(&self) -> bool {
        self.making.is_none()
    }

    /// Prepares a part, or paints some more rows, if any are left. Lays the prepared relief on flat ground (`None` for
    /// plain land), where `land` holds the share of land in each pixel. Returns `true` if there is more.
    pub fn advance(&mut self, prepared: &mut Prepared, view: &View, land: &[u8], ground: Option<&FlatGround>) -> bool {
        let Some(Making { look, tints, rivers, inks }) = &mut self.making else { return false };
        let Some(inks) = inks else {
            *inks = Some(Inks::new(*look, tints, rivers, view));
            return true;
        };
        if inks.advance(prepared, view) {
            return true;
        }
        let rows = view.next_rows(self.pixels.len());
        let range = view.range(rows.clone());
        let flat = ground.and_then(FlatGround::pixels);
        match flat {
            Some(flat) => self.pixels.extend_from_slice(&flat[range.clone()]),
            None => self.pixels.resize(range.end, plain(&self.palette)),
        }
        let sheet = Sheet { view, plain: self.palette.plain, land, rivers: rivers.mask().data() };
        prepared.lay(inks, &sheet, rows.clone(), &mut self.pixels[range.clone()]);
        if let Some((neatline, flat)) = ground.and_then(FlatGround::neatline).zip(flat) {
            neatline.restore(view, rows.clone(), &flat[range.clone()], &mut self.pixels[range]);
        }
        self.making.take_if(|_| rows.end == view.height);
        self.making.is_some()
    }
}
