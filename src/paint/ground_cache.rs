//! The ground under a picture's rivers, and what it is made of, kept for the next: the coast as pictures show it and the share of land in
//! each pixel for as long as the land is the same, flat ground for as long as its style is, and what a relief alone decides for as long as
//! that lasts.

use std::sync::Arc;

use super::beds::GroundWithBeds;
use super::coverage::{Coverage, Rect};
use super::grid;
use super::ground::ground;
use super::palette::{Colour, LAND_ONLY, Palette};
use super::paper;
use super::relief::{Prepared, Sheet};
use super::rivers::{Exaggerated, Rivers, draw_network};
use super::styles::palette;
use super::view::View;
use crate::land::{Land, SmoothedDistance};
use crate::recipe::Style;
use crate::relief::Relief;

/// What a picture has besides its rivers.
#[derive(Clone, Debug, Default)]
pub(super) struct GroundCache {
    shown: Option<SmoothedDistance>,
    /// How much of each pixel is land, in 255ths; empty until a relief is laid.
    shares: Vec<u8>,
    /// In a style; no pixels where all is plain land.
    flat: Option<(Style, Option<Vec<[u8; 4]>>)>,
    prepared: Option<Prepared>,
    /// With great rivers and their former beds.
    beds: Option<GroundWithBeds>,
    raised: Option<Raised>,
}

/// Ground with relief.
#[derive(Clone, Debug)]
struct Raised {
    relief: Arc<Relief>,
    exaggeration: f32,
    pixels: Vec<[u8; 4]>,
    /// The number of the colour that rivers have in each pixel; none if they have but one.
    numbers: Vec<u8>,
}

impl GroundCache {
    /// What a picture takes at most, beyond its own pixels and mask, in bytes a pixel: flat ground, the same twice with former beds, and a
    /// mask that is drawn for them. With relief it is one less: flat ground and raised, the shares of land, the numbers of basins or a
    /// casing before its blur and after it, and a mask.
    pub const BYTES_A_PIXEL: usize = 4 + 4 + 4 + 1;

    /// What a relief takes besides, however large the picture is: heights, light and contours of 250,000 cells, and what they are made of.
    pub const BYTES: usize = 6_000_000;

    /// The pixels, and the number of the colour that rivers have in each; none if they have but one. `None` for plain land.
    pub fn pixels(&self) -> Option<(&[[u8; 4]], &[u8])> {
        match (&self.raised, &self.beds, &self.flat) {
            (Some(raised), ..) => Some((&raised.pixels, &raised.numbers)),
            (None, Some(GroundWithBeds { pixels, .. }), _) | (None, None, Some((_, Some(pixels)))) => {
                Some((pixels, &[]))
            }
            (None, None, _) => None,
        }
    }

    /// Whether it shows a relief.
    pub fn is_raised(&self) -> bool {
        self.raised.is_some()
    }

    /// Whether it shows this relief, or none if there is none.
    pub fn shows(&self, relief: Option<Exaggerated<'_>>) -> bool {
        match (&self.raised, relief) {
            (None, None) => true,
            (Some(raised), Some((relief, by))) => Arc::ptr_eq(&raised.relief, relief) && raised.exaggeration == by,
            (None, Some(_)) | (Some(_), None) => false,
        }
    }

    /// Shows flat ground again.
    pub fn lower(&mut self) {
        self.raised = None;
    }

    /// Shows the ground alone: other rivers come next.
    pub fn forget_rivers(&mut self) {
        (self.raised, self.beds) = (None, None);
    }

    /// The same, and keeps nothing of a relief: there will be another.
    pub fn forget_relief(&mut self) {
        self.forget_rivers();
        self.prepared = None;
    }

    /// Paints flat ground, unless it is there.
    pub fn lay(&mut self, view: &View, land: Option<&Land>, style: Style) {
        if self.flat.as_ref().is_some_and(|(painted, _)| *painted == style) {
            return;
        }
        self.flat = None;
        self.forget_rivers();
        let palette = palette(style);
        let mut pixels = land.map(|land| self.coast(view, land, palette));
        if let Some(paper) = palette.paper {
            paper::lay(view, paper, pixels.get_or_insert_with(|| bare(view, palette.plain)));
        }
        for grid in palette.grids {
            grid::lay(view, grid, pixels.get_or_insert_with(|| bare(view, palette.plain)));
        }
        self.flat = Some((style, pixels));
    }

    /// Lays great rivers and their former beds over flat ground, if the style has any.
    pub fn lay_beds(&mut self, view: &View, rivers: &Rivers<'_>) {
        if let (Some(look), Some((_, Some(flat)))) = (palette(rivers.style).beds, &self.flat) {
            self.beds.get_or_insert_default().lay(look, view, rivers, flat);
        }
    }

    fn coast(&mut self, view: &View, land: &Land, palette: &Palette) -> Vec<[u8; 4]> {
        let shown = self.shown.get_or_insert_with(|| SmoothedDistance::of(land.coast_distance()));
        ground(view, land, shown, palette)
    }

    /// Raises a relief on flat ground, with casings along the rivers.
    pub fn raise(&mut self, view: &View, rivers: &Rivers<'_>, (relief, exaggeration): Exaggerated<'_>) {
        let palette = palette(rivers.style);
        let Some(look) = palette.relief else { return };
        if self.shares.is_empty() {
            self.shares = rivers.land.map_or_else(
                || vec![255; view.pixels()],
                |land| self.coast(view, land, &LAND_ONLY).into_iter().map(|[share, ..]| share).collect(),
            );
        }
        let flat = self.flat.as_ref().and_then(|(_, pixels)| pixels.clone());
        let mut pixels = flat.unwrap_or_else(|| bare(view, palette.plain));
        let Some(mut mask) = Coverage::new(view.width, view.height) else { return };
        if look.minds_rivers() {
            draw_network(&mut mask, view, rivers.network, rivers.courses, palette.lines, look.casing.margin);
        }
        let sheet = Sheet {
            view,
            plain: palette.plain,
            land: &self.shares,
            touched: mask.take_touched().into_iter().reduce(Rect::union),
            rivers: mask.mask().data(),
        };
        let kept = self.prepared.take().filter(|prepared| prepared.is_of(relief));
        let prepared = self.prepared.insert(kept.unwrap_or_else(|| Prepared::new(relief)));
        let numbers = prepared.lay(look, exaggeration, rivers.network, &sheet, &mut pixels);
        self.raised = Some(Raised { relief: relief.clone(), exaggeration, pixels, numbers });
    }
}

/// Plain land.
fn bare(view: &View, [r, g, b]: Colour) -> Vec<[u8; 4]> {
    vec![[r, g, b, 255]; view.pixels()]
}
