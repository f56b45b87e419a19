//! The ground under a picture's rivers, made part by part, and its ingredients, which are kept for the next picture:
//! the smoothed coast and the share of land in each pixel as long as the land is the same, flat ground as long as the
//! style is the same, and everything that depends on the relief alone as long as the relief is the same.

use super::beds::GroundWithBeds;
use super::beyond;
use super::flat::FlatGround;
use super::ground::{COAST_WIDTH, ShownCoast, thinned};
use super::raised::{LandShares, RaisedGround};
use super::relief::Prepared;
use super::rivers::Rivers;
use super::styles::{Scheme, palette};
use super::view::View;
use crate::land::{CoastDetail, Land, SmoothedDistance};

/// The parts of a picture other than its rivers.
#[derive(Clone, Debug, Default)]
pub(super) struct GroundCache {
    shown: Option<SmoothedDistance>,
    /// The detail of the coast beside finished rivers; `None` if there is none, or if it is not known yet whether there is.
    detail: Option<Option<CoastDetail>>,
    shares: Option<LandShares>,
    flat: Option<FlatGround>,
    prepared: Option<Prepared>,
    /// The ground with great rivers and their former beds.
    beds: Option<GroundWithBeds>,
    raised: Option<RaisedGround>,
}

impl GroundCache {
    /// The greatest memory of a picture beyond its own pixels and mask, in bytes a pixel: flat ground; ground with
    /// relief; the shares of land; the numbers of colours by height and light; those of basins, or two masks (rivers,
    /// and their casings or hachures); contours, of 8 bytes each, which cover an eighth of the pixels. Former beds need
    /// less: flat ground, two copies of it with beds, and a mask.
    pub const BYTES_A_PIXEL: usize = 4 + 4 + 1 + 2 + 1 + 2 + 1;

    /// The further memory of a relief, for pictures of any size: heights, light and contours of 250,000 cells, and
    /// their ingredients; and where the detail of a coast is free to move.
    pub const BYTES: usize = 10_000_000;

    /// Returns the pixels, and the number of the river colour in each, which is empty if rivers have only one colour.
    /// `None` for plain land.
    pub fn pixels(&self, scheme: Scheme) -> Option<(&[[u8; 4]], &[u8])> {
        if let Some(raised) = &self.raised {
            let has_numbers = palette(scheme).relief.is_some_and(|look| look.basins.is_some());
            let numbers = self.prepared.as_ref().filter(|_| has_numbers).map_or(&[][..], Prepared::numbers);
            return Some((raised.pixels(), numbers));
        }
        let beds = self.beds.as_ref().map(|beds| &beds.pixels[..]);
        beds.or_else(|| self.flat.as_ref()?.pixels()).map(|pixels| (pixels, &[][..]))
    }

    /// Returns the distances from the coast; `None` if there is no sea.
    pub fn shown(&self) -> Option<&SmoothedDistance> {
        self.shown.as_ref()
    }

    /// Returns the ground without relief, whose fourth channel says what is land; `None` if everything is plain land.
    pub fn flat_pixels(&self) -> Option<&[[u8; 4]]> {
        self.flat.as_ref()?.pixels()
    }

    /// Returns the painted share, from 0 to 1, for a style with or without relief.
    pub fn progress(&self, view: &View, has_relief: bool) -> f32 {
        let share = |painted: usize| painted as f32 / view.pixels() as f32;
        let flat = self.flat.as_ref().map_or(0.0, |flat| flat.pixels().map_or(1.0, |pixels| share(pixels.len())));
        if !has_relief {
            return flat;
        }
        let land = self.shares.as_ref().map_or(0.0, |shares| share(shares.of_pixels().len()));
        let raised = self.raised.as_ref().map_or(0.0, |raised| share(raised.pixels().len()));
        (flat + land + raised) / 3.0
    }

    /// Returns `true` if it shows a relief.
    pub fn is_raised(&self) -> bool {
        self.raised.is_some()
    }

    /// Returns `true` if it completely shows the relief of these rivers, or none if they have none.
    pub fn shows(&self, rivers: &Rivers<'_>) -> bool {
        match (&self.raised, rivers.relief) {
            (None, None) => true,
            (Some(raised), Some(relief)) => raised.is_whole() && raised.is_of(relief, rivers.lakes, &rivers.settings),
            (None, Some(_)) | (Some(_), None) => false,
        }
    }

    /// Drops former beds. Returns `true` if the remaining ground, flat or with relief, is completely painted in this
    /// style.
    pub fn is_ready_for_draft(&mut self, view: &View, scheme: Scheme) -> bool {
        self.beds = None;
        let is_flat = self.flat.as_ref().is_some_and(|flat| flat.scheme == scheme && flat.is_whole(view));
        is_flat && self.raised.as_ref().is_none_or(RaisedGround::is_whole)
    }

    /// Drops everything that depends on what part of the land is shown, because another comes next.
    pub fn forget_view(&mut self, before: &View, next: &View) {
        let is_as_wide = before.shows_beyond() == next.shows_beyond();
        *self = Self { shown: self.shown.take().filter(|_| is_as_wide), ..Self::default() };
    }

    /// Drops everything that depends on rivers, because others come next.
    pub fn forget_rivers(&mut self) {
        (self.raised, self.beds) = (None, None);
        self.forget_detail();
    }

    /// Drops everything that depends on rivers or on a relief.
    pub fn forget_relief(&mut self) {
        self.forget_rivers();
        self.prepared = None;
    }

    /// Paints a part of flat ground, if any is missing. Returns `true` if there is more.
    pub fn lay(&mut self, view: &View, land: Option<&Land>, scheme: Scheme) -> bool {
        self.advance_flat(view, land, (scheme, false))
    }

    /// Makes a part of the ground, if any is missing. Returns `true` if there is more.
    pub fn advance(&mut self, view: &View, rivers: &Rivers<'_>) -> bool {
        self.detail_coast(view, rivers);
        self.advance_flat(view, rivers.land, (rivers.settings.scheme, rivers.relief.is_some()))
            || self.advance_relief(view, rivers)
            || self.advance_beds(view, rivers)
    }

    /// Finds out what detail the coast has beside finished rivers, unless that is known.
    fn detail_coast(&mut self, view: &View, rivers: &Rivers<'_>) {
        if self.detail.is_some() {
            return;
        }
        let line = |river| rivers.network.middle(river).iter().map(|place| (place.at, place.half)).collect();
        let lines = rivers.network.rivers.iter().map(line);
        let land = rivers.land.filter(|_| rivers.finished);
        let line = COAST_WIDTH * thinned(view.scale);
        let of = |land| CoastDetail::of(land, view.domain(), rivers.settings.coast, (view.scale, line), lines);
        let detail = land.and_then(of);
        if detail.is_some() {
            (self.flat, self.shares, self.raised) = (None, None, None);
        }
        self.detail = rivers.finished.then_some(detail);
    }

    /// Drops the detail of the coast, and what is painted with it.
    fn forget_detail(&mut self) {
        if self.detail.take().flatten().is_some() {
            (self.flat, self.shares) = (None, None);
        }
    }

    fn advance_flat(&mut self, view: &View, land: Option<&Land>, (scheme, is_even): (Scheme, bool)) -> bool {
        // Without a relief in it, a style has but one ground.
        let is_even = is_even || palette(scheme).relief.is_none();
        if let Some(land) = land {
            self.shown.get_or_insert_with(|| {
                let shown = SmoothedDistance::of(land.coast_distance());
                if view.shows_beyond() { shown.widened(beyond::WIDENED) } else { shown }
            });
        }
        if self.flat.as_ref().is_none_or(|flat| (flat.scheme, flat.is_even) != (scheme, is_even)) {
            (self.raised, self.beds) = (None, None);
            // Drops the old ground first: both at once would need too much memory.
            self.flat = None;
        }
        let shown = shown_coast(&self.shown, &self.detail);
        let flat = self.flat.get_or_insert_with(|| FlatGround::new(view, (scheme, is_even), land, shown));
        flat.advance(view, land, shown)
    }

    /// Paints the relief, with casings along the rivers, or removes it.
    fn advance_relief(&mut self, view: &View, rivers: &Rivers<'_>) -> bool {
        let (Some(relief), Some(look)) = (rivers.relief, palette(rivers.settings.scheme).relief) else {
            self.raised = None;
            return false;
        };
        let shown = shown_coast(&self.shown, &self.detail);
        let shares = self.shares.get_or_insert_with(|| LandShares::new(view, rivers.land, shown));
        if shares.advance(view, shown) {
            return true;
        }
        let (display, wind) = (rivers.settings.relief, rivers.settings.wind);
        self.prepared.take_if(|prepared| !prepared.is_of(relief));
        let prepared = self.prepared.get_or_insert_with(|| Prepared::new(relief));
        if prepared.prepare(&look, (display, wind), (rivers.network, rivers.distributaries), view) {
            return true;
        }
        self.raised.take_if(|raised| !raised.is_of(relief, rivers.lakes, &rivers.settings));
        let Some(raised) = &mut self.raised else {
            self.raised = RaisedGround::new(look, relief, view, rivers);
            return self.raised.is_some();
        };
        raised.advance(prepared, view, shares.of_pixels(), self.flat.as_ref())
    }

    /// Lays great rivers and their former beds over flat ground, if the style has any.
    fn advance_beds(&mut self, view: &View, rivers: &Rivers<'_>) -> bool {
        let flat = self.flat.as_ref().and_then(FlatGround::pixels);
        let Some((look, flat)) = palette(rivers.settings.scheme).beds.zip(flat) else { return false };
        self.beds.get_or_insert_default().advance(look, view, rivers, flat)
    }
}

/// Returns the coast as it is shown; `None` if there is no sea.
fn shown_coast<'a>(
    smooth: &'a Option<SmoothedDistance>,
    detail: &'a Option<Option<CoastDetail>>,
) -> Option<ShownCoast<'a>> {
    let detail = detail.as_ref().and_then(Option::as_ref);
    smooth.as_ref().map(|smooth| ShownCoast { smooth, detail })
}
