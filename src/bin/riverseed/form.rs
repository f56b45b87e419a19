//! The forms of a file.

use std::path::Path;

use riverseed::export::rasters::Layer;

use super::Failure;

/// The forms of a file, by its ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Png,
    Svg,
    GeoJson,
    Json,
    Pack,
    Raster(Layer),
}

impl Form {
    const ALL: [(Self, &'static str); 10] = [
        (Self::Raster(Layer::Heights), ".heights.png"),
        (Self::Raster(Layer::Land), ".land.png"),
        (Self::Raster(Layer::Rivers), ".rivers.png"),
        (Self::Raster(Layer::Flow), ".flow.png"),
        (Self::Raster(Layer::Basins), ".basins.png"),
        (Self::Png, ".png"),
        (Self::Svg, ".svg"),
        (Self::GeoJson, ".geojson"),
        (Self::Json, ".json"),
        (Self::Pack, ".zip"),
    ];

    /// The form that a path's ending names.
    ///
    /// # Errors
    /// If it names none.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default().to_ascii_lowercase();
        // Whose name is nothing but an ending is a hidden file.
        let is_of = |(_, ending): &&(Self, &str)| name.len() > ending.len() && name.ends_with(ending);
        let found = Self::ALL.iter().find(is_of).map(|(form, _)| *form);
        found.ok_or_else(|| Failure::Ending { path: path.into() })
    }

    fn ending(self) -> &'static str {
        Self::ALL.iter().find(|(form, _)| *form == self).map_or("", |(_, ending)| ending)
    }

    /// Whether it holds a picture of so many pixels.
    pub fn has_pixels(self) -> bool {
        matches!(self, Self::Png | Self::Pack)
    }

    /// Whether it holds rasters.
    pub fn has_rasters(self) -> bool {
        matches!(self, Self::Raster(_) | Self::Pack)
    }

    /// Whether it holds heights, in a style without relief too.
    pub fn has_relief(self) -> bool {
        self.has_rasters() || self == Self::GeoJson
    }

    /// Whether it is drawn with letters.
    pub fn has_letters(self) -> bool {
        self.is_picture() || self == Self::Pack
    }

    /// Whether it lists names as data.
    pub fn lists_names(self) -> bool {
        matches!(self, Self::Json | Self::GeoJson)
    }

    /// Whether it is a picture and no data.
    pub fn is_picture(self) -> bool {
        matches!(self, Self::Png | Self::Svg)
    }
}

/// The endings of some forms, for messages.
pub fn listed(forms: &[Form]) -> String {
    forms.iter().map(|form| form.ending()).collect::<Vec<_>>().join(", ")
}
