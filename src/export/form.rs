//! The forms of a file.

use super::rasters::Layer;

/// The forms of a file, each called as the names of such files end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The picture.
    Png,
    /// Its lines.
    Svg,
    /// The rivers, coasts and ridges for geographic information systems.
    GeoJson,
    /// The network, as `network.schema.json` has it.
    Json,
    /// The picture, all rasters and what their values mean, for games.
    Pack,
    /// One of the rasters.
    Raster(Layer),
}

const NAMES: [(Form, &str); 10] = [
    (Form::Png, "png"),
    (Form::Svg, "svg"),
    (Form::GeoJson, "geojson"),
    (Form::Json, "json"),
    (Form::Pack, "zip"),
    (Form::Raster(Layer::Heights), "heights.png"),
    (Form::Raster(Layer::Land), "land.png"),
    (Form::Raster(Layer::Rivers), "rivers.png"),
    (Form::Raster(Layer::Flow), "flow.png"),
    (Form::Raster(Layer::Basins), "basins.png"),
];

impl Form {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        NAMES.iter().map(|(form, _)| *form)
    }

    /// What such a file's name ends with, without the dot before.
    pub fn name(self) -> &'static str {
        NAMES.iter().find(|(form, _)| *form == self).map_or("", |(_, name)| name)
    }

    /// The form that is called so; `None` if none is.
    pub fn named(name: &str) -> Option<Self> {
        NAMES.iter().find(|(_, known)| *known == name).map(|(form, _)| *form)
    }

    /// The form of a file by the longest known ending of its name, in capitals or not; `None` if its name has none, or is nothing else, as
    /// that of a hidden file.
    pub fn of_file(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let is_of = |(_, ending): &&(Self, &str)| {
            name.strip_suffix(ending).is_some_and(|rest| rest.len() > 1 && rest.ends_with('.'))
        };
        NAMES.iter().filter(is_of).max_by_key(|(_, ending)| ending.len()).map(|(form, _)| *form)
    }

    /// Whether it holds a picture whose size in pixels can be chosen.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn form_of_a_file_is_that_of_its_longest_ending() {
        for (name, form) in [
            ("kauri.png", Some(Form::Png)),
            ("Kauri.Heights.PNG", Some(Form::Raster(Layer::Heights))),
            ("a.b.geojson", Some(Form::GeoJson)),
            ("a.json.zip", Some(Form::Pack)),
            ("heights.png", Some(Form::Png)),
            ("xheights.png", Some(Form::Png)),
            (".heights.png", Some(Form::Png)),
            (".png", None),
            ("png", None),
            ("kauripng", None),
            ("kauri.gif", None),
            ("", None),
        ] {
            assert_eq!(Form::of_file(name), form, "{name}");
        }
    }

    #[test]
    fn every_form_has_a_name_of_its_own_that_files_may_end_with() {
        for form in Form::all() {
            assert_eq!(Form::named(form.name()), Some(form));
            assert_eq!(Form::of_file(&format!("kauri.{}", form.name())), Some(form));
        }
        for layer in Layer::ALL {
            assert_eq!(Form::Raster(layer).name(), format!("{}.png", layer.name()));
        }
        assert_eq!(Form::named("gif"), None);
    }
}
