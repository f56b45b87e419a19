//! The forms of a file: a table with a row for each.

use riverseed::export::rasters::Layer;

/// The forms of a file, each named after the ending of its files. Not `#[non_exhaustive]`: programs that write all forms
/// want the compiler to ask for a new one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The picture.
    Png,
    /// The map as shapes.
    Svg,
    /// The map as lines on a sheet of paper, for plotters and other machines that follow lines.
    Plot,
    /// The rivers, coasts and ridges for geographic information systems.
    GeoJson,
    /// The network, as described in `network.schema.json`.
    Json,
    /// The picture, all rasters and the meaning of their values, for games.
    Pack,
    /// One of the rasters.
    Raster(Layer),
    /// The heights as bare 16-bit numbers, for game engines.
    RawHeights,
    /// The directions that the ground faces, as a texture of game engines.
    Normals,
    /// The shares of four kinds of ground in each pixel, as a texture for game engines.
    Splat,
    /// The rivers as lines in space with width and depth, for game engines.
    Splines,
    /// The relief as a mesh under the picture.
    Gltf,
    /// Everything that one game engine needs.
    Engine(Engine),
    /// The map in layers, for geographic information systems.
    GeoPackage,
    /// The picture at its place, for geographic information systems.
    GeoTiff,
    /// One of the rasters at its place, for geographic information systems.
    RasterTiff(Layer),
    /// The colours of heights, for the geographic information system QGIS.
    HeightStyle,
}

/// A game engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Unreal Engine.
    Unreal,
    /// Unity.
    Unity,
    /// Godot.
    Godot,
}

/// The contents of a file, on which its options and its memory depend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// A picture whose size in pixels can be chosen.
    Pixels,
    /// Rasters.
    Rasters,
    /// Heights, even in a style without relief.
    Relief,
    /// Drawn letters.
    Letters,
    /// Names as data.
    Names,
    /// A picture and no data.
    PictureAlone,
    /// Other files, compressed.
    Files,
}

/// The readers that a form is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Readers {
    /// Browsers, editors and programs of any kind.
    Any,
    /// Game engines.
    Engines,
    /// Geographic information systems.
    Gis,
}

/// Makes the list of forms and the table of what each is, of the same rows: a form that is in the table is in the list, and
/// without its row the table does not compile.
macro_rules! rows {
    ($($Form:ident $(($of:path))? => $row:expr,)+) => {
        const ALL: &'static [Self] = &[$(Self::$Form $(($of))?),+];

        /// Returns the row of a form: the ending of its files, their readers, the copies of the map's features that are in
        /// memory while one is written, and the contents. Writers of pixels and rasters ask for what they need by
        /// themselves.
        const fn row(self) -> (&'static str, Readers, usize, &'static [Holds]) {
            use Holds::{Files, Letters, Names, PictureAlone, Pixels, Rasters, Relief};
            use Readers::{Any, Engines, Gis};
            match self {
                $(Self::$Form $(($of))? => $row,)+
            }
        }
    };
}

impl Form {
    // The order is that in which people are told of forms.
    rows! {
        Png => ("png", Any, 0, &[Pixels, Letters, PictureAlone]),
        Svg => ("svg", Any, 1, &[Letters, PictureAlone]),
        Plot => ("plot.svg", Any, 1, &[Relief]),
        GeoJson => ("geojson", Any, 1, &[Relief, Names]),
        Json => ("json", Any, 1, &[Names]),
        Pack => ("zip", Any, 1, &[Pixels, Letters, Rasters, Relief, Files]),
        Raster(Layer::Heights) => ("heights.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Land) => ("land.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Rivers) => ("rivers.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Flow) => ("flow.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Basins) => ("basins.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Water) => ("water.png", Any, 0, &[Rasters, Relief]),
        Raster(Layer::Depth) => ("depth.png", Any, 0, &[Rasters, Relief]),
        RawHeights => ("r16", Engines, 0, &[Rasters, Relief]),
        Normals => ("normals.png", Engines, 0, &[Rasters, Relief]),
        Splat => ("splat.png", Engines, 0, &[Rasters, Relief]),
        Splines => ("splines.json", Engines, 1, &[Rasters, Relief, Names]),
        Gltf => ("glb", Engines, 0, &[Pixels, Letters, Rasters, Relief]),
        Engine(Engine::Unreal) => ("unreal.zip", Engines, 1, &[Pixels, Letters, Rasters, Relief, Names, Files]),
        Engine(Engine::Unity) => ("unity.zip", Engines, 1, &[Pixels, Letters, Rasters, Relief, Names, Files]),
        Engine(Engine::Godot) => ("godot.zip", Engines, 1, &[Pixels, Letters, Rasters, Relief, Names, Files]),
        // The features are in memory together, rivers twice, and then the file.
        GeoPackage => ("gpkg", Gis, 5, &[Relief, Names]),
        GeoTiff => ("tif", Gis, 0, &[Pixels, Letters, PictureAlone]),
        RasterTiff(Layer::Heights) => ("heights.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Land) => ("land.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Rivers) => ("rivers.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Flow) => ("flow.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Basins) => ("basins.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Water) => ("water.tif", Gis, 0, &[Rasters, Relief]),
        RasterTiff(Layer::Depth) => ("depth.tif", Gis, 0, &[Rasters, Relief]),
        HeightStyle => ("heights.qml", Gis, 1, &[Relief]),
    }

    fn holds(self, part: Holds) -> bool {
        self.row().3.contains(&part)
    }

    /// Lists all forms.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied()
    }

    /// Returns the ending of the names of a form's files, without the dot before it.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// Finds the form with this name; `None` if there is none.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|form| form.name() == name)
    }

    /// Finds the form of a file by the longest known ending of its name, in upper or lower case. `None` if the name has no
    /// known ending, or consists of nothing else, like that of a hidden file.
    pub fn of_file(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let is_of =
            |form: &Self| name.strip_suffix(form.name()).is_some_and(|rest| rest.len() > 1 && rest.ends_with('.'));
        Self::all().filter(is_of).max_by_key(|form| form.name().len())
    }

    /// Returns the readers that such files are made for.
    pub fn readers(self) -> Readers {
        self.row().1
    }

    /// Returns how many copies of a map's features are in memory while such a file is written.
    pub(crate) fn copies(self) -> usize {
        self.row().2
    }

    /// Returns `true` if the file holds other files, compressed.
    pub(crate) fn has_files(self) -> bool {
        self.holds(Holds::Files)
    }

    /// Returns `true` if the file holds a picture whose size in pixels can be chosen.
    pub fn has_pixels(self) -> bool {
        self.holds(Holds::Pixels)
    }

    /// Returns `true` if the file holds rasters.
    pub fn has_rasters(self) -> bool {
        self.holds(Holds::Rasters)
    }

    /// Returns `true` if the file holds heights, even in a style without relief.
    pub fn has_relief(self) -> bool {
        self.holds(Holds::Relief)
    }

    /// Returns `true` if the file is drawn with letters.
    pub fn has_letters(self) -> bool {
        self.holds(Holds::Letters)
    }

    /// Returns `true` if the file lists names as data.
    pub fn lists_names(self) -> bool {
        self.holds(Holds::Names)
    }

    /// Returns `true` if the file is a picture and no data.
    pub fn is_picture(self) -> bool {
        self.holds(Holds::PictureAlone)
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
            ("kauri.Unity.zip", Some(Form::Engine(Engine::Unity))),
            ("unity.zip", Some(Form::Pack)),
            ("kauri.plot.svg", Some(Form::Plot)),
            ("plot.svg", Some(Form::Svg)),
            ("kauri.land.tif", Some(Form::RasterTiff(Layer::Land))),
            ("island.tif", Some(Form::GeoTiff)),
            ("a.splines.json", Some(Form::Splines)),
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
            assert_eq!(Form::RasterTiff(layer).name(), format!("{}.tif", layer.name()));
        }
        assert_eq!(Form::named("gif"), None);
    }
}
