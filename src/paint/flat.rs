//! The flat ground of a style: land and sea, or plain land, on paper and under a grid. It is painted some rows at a
//! time. In styles with relief, land whose relief is not known yet is tinted by its distance from the sea.

use super::beyond;
use super::grid;
use super::ground::{Ground, ShownCoast};
use super::neatline::Neatline;
use super::palette::Palette;
use super::paper;
use super::styles::{Scheme, palette};
use super::view::View;
use crate::land::Land;

/// The flat ground, as far as it is painted.
#[derive(Clone, Debug)]
pub(super) struct FlatGround {
    pub scheme: Scheme,
    /// `true` if a relief will be laid on it, so that its land has one colour.
    pub is_even: bool,
    /// The painter of land and sea; `None` if there is no sea, and once everything is painted.
    coast: Option<Ground>,
    /// The end of a land that runs off the map, if it is seen.
    neatline: Option<Neatline>,
    /// `None` if everything is plain land.
    pixels: Option<Vec<[u8; 4]>>,
}

impl FlatGround {
    pub fn new(
        view: &View,
        (scheme, is_even): (Scheme, bool),
        land: Option<&Land>,
        shown: Option<ShownCoast<'_>>,
    ) -> Self {
        let palette = palette(scheme);
        let tints = palette.relief.as_ref().filter(|_| !is_even).map(|look| &look.tints);
        let coast = land.zip(shown).map(|(land, shown)| Ground::new(view, land, shown.smooth, (&palette, tints)));
        let neatline = Neatline::of(view, scheme, land);
        let is_blank = coast.is_none() && palette.paper.is_none() && palette.grids.is_empty();
        let is_plain = is_blank && neatline.is_none() && !view.shows_beyond();
        Self { scheme, is_even, coast, neatline, pixels: (!is_plain).then(|| Vec::with_capacity(view.pixels())) }
    }

    /// Returns the pixels; `None` if everything is plain land.
    pub fn pixels(&self) -> Option<&[[u8; 4]]> {
        self.pixels.as_deref()
    }

    /// Returns the end of a land that runs off the map, if it is seen.
    pub fn neatline(&self) -> Option<Neatline> {
        self.neatline
    }

    /// Returns `true` if all of it is painted.
    pub fn is_whole(&self, view: &View) -> bool {
        self.pixels.as_ref().is_none_or(|pixels| pixels.len() == view.pixels())
    }

    /// Paints some more rows, if any are left. Returns `true` if there are more.
    pub fn advance(&mut self, view: &View, land: Option<&Land>, shown: Option<ShownCoast<'_>>) -> bool {
        let Some(pixels) = &mut self.pixels else { return false };
        let rows = view.next_rows(pixels.len());
        if rows.is_empty() {
            return false;
        }
        let (palette, range) = (palette(self.scheme), view.range(rows.clone()));
        match (&mut self.coast, shown) {
            (Some(coast), Some(shown)) => coast.paint(view, shown, rows.clone(), pixels),
            _ => pixels.resize(range.end, plain(&palette)),
        }
        match &self.neatline {
            Some(neatline) => neatline.lay(view, rows.clone(), &mut pixels[range.clone()]),
            None if view.shows_beyond() => beyond::lay(view, land, &palette, rows.clone(), &mut pixels[range.clone()]),
            None => {}
        }
        if let Some(paper) = &palette.paper {
            paper::lay(view, paper, rows.clone(), &mut pixels[range]);
        }
        let is_whole = rows.end == view.height;
        if is_whole {
            self.coast = None;
            palette.grids.iter().for_each(|lines| grid::lay(view, lines, pixels));
        }
        !is_whole
    }
}

/// Returns the colour of plain land.
pub(super) fn plain(palette: &Palette) -> [u8; 4] {
    let [r, g, b] = palette.plain;
    [r, g, b, 255]
}
