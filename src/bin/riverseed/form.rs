//! The forms of a file.

use std::path::Path;

use riverseed::export::rasters::Layer;

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

    /// The form that a path's ending names, and that ending.
    pub fn of(path: &Path) -> Option<(Self, &'static str)> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        // Whose name is nothing but an ending is a hidden file.
        Self::ALL.into_iter().find(|(_, ending)| name.len() > ending.len() && name.ends_with(ending))
    }
}
