//! Letters that are carried: the names of one map in their places, with the type that they are set in, as a text beside the map's
//! link. Whoever has it shows the map with its names, and can do without what finds names, places them and knows all letters.
//!
//! Letters become smaller, step by step, on pictures that are larger: a step for each of the levels on which labels are chosen. A
//! picture has those of the last step at which they can be read. Places are rounded, in the same way for whoever has placed them and
//! whoever carries them: so both paint the same.
//!
//! ```text
//! text:   sum of all that follows, version, rivers, keys, italic letters, roman letters, steps; numbers as in base/numbers.rs
//! rivers: a hash of the network that the letters stand on
//! key:    a hash of a link that they hold for; a map on a light page and on a dark one has two
//! step:   labels, see rows.rs
//! ```

mod read;
mod rows;
mod steps;
mod write;

use std::sync::Arc;

use crate::annotate::glyph::Typeface;
use crate::annotate::place::LabelIn;
use crate::base::hash::Fnv1a;
use crate::map::Map;
use crate::network::Network;
use crate::paint::{AnnotationMasks, View, letters};
use crate::recipe::{Recipe, link};

use rows::Row;
pub use steps::stepped;
pub use write::sealed;

/// The first number of all carried letters, which tells whoever reads them that they are of this form.
const VERSION: u32 = 1;

/// The letters of one map.
#[derive(Debug)]
pub struct Carried {
    /// The hash of the network that they stand on.
    rivers: u32,
    /// The hashes of the links that they hold for.
    keys: Vec<u32>,
    faces: [Typeface; 2],
    /// The labels of each step.
    steps: Vec<Vec<Row>>,
}

impl Carried {
    /// The longest text that is read, in characters.
    pub const LONGEST: usize = 1 << 16;

    /// Returns `true` if the letters are for the map of a recipe.
    pub fn are_for(&self, recipe: &Recipe) -> bool {
        self.keys.contains(&key_of(recipe))
    }

    /// Returns `true` if they are placed for pictures of this size and shape, with `ratio` pixels to a CSS pixel.
    pub fn have_room(view: &View, ratio: f32) -> bool {
        steps::step_of(view, ratio).is_some()
    }

    /// Returns the masks of the letters for a picture with `ratio` pixels to a CSS pixel; `None` if they are for another map, or for
    /// no picture of this size or shape.
    pub fn masks(&self, map: &Map, view: &View, ratio: f32) -> Option<AnnotationMasks> {
        if !self.are_for(map.recipe()) || self.rivers != hash_of(map.network()) {
            return None;
        }
        let rows = self.steps.get(steps::step_of(view, ratio)?)?;
        let labels: Vec<LabelIn<'_>> = rows.iter().map(|row| row.label(self.faces.each_ref())).collect();
        Some(letters::masks(view, &labels))
    }
}

/// Where the letters of a picture come from.
#[derive(Clone, Debug, Default)]
pub enum Lettering {
    /// They are placed for this very picture.
    #[default]
    Placed,
    /// They are placed for the step that it belongs to, as carried letters are.
    InSteps,
    /// They are carried.
    Carried(Arc<Carried>),
}

impl Lettering {
    /// Returns `true` if somebody carries the letters.
    pub fn are_carried(&self) -> bool {
        matches!(self, Self::Carried(_))
    }

    /// Returns the masks of letters in steps; `None` if the picture has none, or if letters are to be placed for it. Whoever carries
    /// no letters needs to know names to place them.
    pub fn masks(&self, map: &Map, view: &View, ratio: f32) -> Option<AnnotationMasks> {
        match self {
            Self::Carried(carried) => carried.masks(map, view, ratio),
            Self::InSteps if cfg!(feature = "names") => Some(letters::masks(view, &stepped(map, view, ratio)?)),
            Self::InSteps | Self::Placed => None,
        }
    }
}

/// Returns the hash of a recipe's link.
fn key_of(recipe: &Recipe) -> u32 {
    let mut hash = Fnv1a::new();
    hash.bytes(link::write(recipe).as_bytes());
    hash.folded()
}

/// Returns the hash of rivers: where they run and how wide they are.
fn hash_of(network: &Network) -> u32 {
    let mut hash = Fnv1a::new();
    hash.words(network.rivers.iter().flat_map(|river| [river.start, river.end, river.parent]));
    let words = |vertex: &crate::Vertex| [vertex.at.x, vertex.at.y, vertex.left, vertex.right].map(f32::to_bits);
    hash.words(network.vertices.iter().flat_map(words));
    hash.folded()
}
