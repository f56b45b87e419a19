//! The options of files.

use std::num::NonZero;

use riverseed::domain::Domain;
use riverseed::paint::{PaintError, View};
use riverseed::picture::Picture;

use crate::form::{Engine, Form, Readers};
use crate::gis::crs::Crs;
use crate::plot::Sheet;

/// The longer side of a picture in pixels, unless another one is given.
pub const SIZE: u32 = 1200;

/// The options of files, each with the default if it is not given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The longer side of a picture, in pixels; [`SIZE`] unless given.
    pub size: Option<u32>,
    /// Device pixels per CSS pixel, one that [`is_ratio`]; 1 unless given.
    pub ratio: Option<f32>,
    /// The longer side of rasters, in pixels; a pixel per cell of the relief unless given.
    pub raster_size: Option<u32>,
    /// `true` for an SVG whose labels are text on paths.
    pub has_svg_text: bool,
    /// The sheet of lines for plotters; the default one unless given.
    pub sheet: Option<Sheet>,
    /// `true` for heights for game engines that are lowered under rivers, `false` for heights that are not. Unless given, those
    /// in packs for Unity and Godot are.
    pub beds: Option<bool>,
    /// `true` for JSON with the attractors that the tree grew to.
    pub has_attractors: bool,
    /// `true` for GeoJSON with the rivers cut into segments.
    pub has_segments: bool,
    /// `true` for GeoJSON without heights.
    pub is_flat: bool,
    /// The coordinate system of files for geographic information systems; the map's own unless given.
    pub crs: Crs,
    /// The number of threads, 1 unless given. Files do not depend on it.
    pub threads: Option<NonZero<usize>>,
}

/// An option that goes with some forms only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// [`Options::size`].
    Size,
    /// [`Options::ratio`].
    Ratio,
    /// [`Options::raster_size`].
    RasterSize,
    /// [`Options::has_svg_text`].
    SvgText,
    /// [`Options::sheet`](field@Options::sheet).
    Sheet,
    /// [`Options::beds`].
    Beds,
    /// [`Options::has_attractors`].
    Attractors,
    /// [`Options::has_segments`].
    Segments,
    /// [`Options::is_flat`].
    Flat,
    /// [`Options::crs`].
    Crs,
}

impl Setting {
    fn goes_with(self, form: Form) -> bool {
        match self {
            Self::Size | Self::Ratio => form.has_pixels(),
            Self::RasterSize => form.has_rasters(),
            Self::SvgText => form == Form::Svg,
            Self::Sheet => form == Form::Plot,
            Self::Beds => matches!(form, Form::Engine(_) | Form::RawHeights),
            Self::Attractors => form == Form::Json,
            Self::Segments | Self::Flat => form == Form::GeoJson,
            Self::Crs => form.readers() == Readers::Gis && form != Form::HeightStyle,
        }
    }
}

/// Returns `true` for ratios of pixels that pictures can have: from 0.5 to 4, in quarters.
pub fn is_ratio(ratio: f32) -> bool {
    (0.5..=4.0).contains(&ratio) && (ratio * 4.0).fract() == 0.0
}

impl Options {
    /// Finds an option that is given and goes with none of the forms.
    pub fn misplaced(&self, forms: &[Form]) -> Option<Setting> {
        let given = [
            (Setting::Attractors, self.has_attractors),
            (Setting::Size, self.size.is_some()),
            (Setting::Ratio, self.ratio.is_some()),
            (Setting::SvgText, self.has_svg_text),
            (Setting::Sheet, self.sheet.is_some()),
            (Setting::Beds, self.beds.is_some()),
            (Setting::RasterSize, self.raster_size.is_some()),
            (Setting::Segments, self.has_segments),
            (Setting::Flat, self.is_flat),
            (Setting::Crs, self.crs != Crs::Own),
        ];
        let is_misplaced = |setting: &Setting| !forms.iter().any(|form| setting.goes_with(*form));
        given.into_iter().filter(|(_, is_given)| *is_given).map(|(setting, _)| setting).find(is_misplaced)
    }

    /// Returns the longest given side of the contents of some forms, in pixels; 0 if none is given.
    pub fn longest(&self, forms: &[Form]) -> u32 {
        let picture = forms.iter().any(|form| form.has_pixels()).then_some(self.longer_side());
        let rasters = self.raster_size.filter(|_| forms.iter().any(|form| form.has_rasters()));
        picture.max(rasters).unwrap_or(0)
    }

    /// Allocates the picture that files in these forms hold. `None` if none of them holds one.
    ///
    /// # Errors
    /// Fails if the size is out of range, or if there is not enough memory.
    pub fn picture(&self, forms: &[Form], domain: &Domain) -> Result<Option<Picture>, PaintError> {
        if !forms.iter().any(|form| form.has_pixels()) {
            return Ok(None);
        }
        let [width, height] = self.sides(domain);
        Ok(Some(Picture::new(width, height)?.with_ratio(self.ratio.unwrap_or(1.0))))
    }

    /// Returns the sheet of lines for plotters.
    pub(crate) fn sheet(&self) -> Sheet {
        self.sheet.unwrap_or_default()
    }

    /// Returns `true` if the heights in files of a form are lowered under rivers. Unreal Engine digs beds by itself.
    pub(crate) fn has_beds(&self, form: Form) -> bool {
        self.beds.unwrap_or(matches!(form, Form::Engine(Engine::Unity | Engine::Godot)))
    }

    /// Returns the width and height of a picture, in pixels.
    pub(crate) fn sides(&self, domain: &Domain) -> [u32; 2] {
        View::sides_for(domain, self.longer_side()).into()
    }

    pub(crate) fn threads(&self) -> NonZero<usize> {
        self.threads.unwrap_or(NonZero::<usize>::MIN)
    }

    fn longer_side(&self) -> u32 {
        self.size.unwrap_or(SIZE)
    }
}
