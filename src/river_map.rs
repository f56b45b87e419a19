//! A map as a chart is made of it: rivers as they are, and the land that they run on, but nothing of how that came about.
//!
//! A session has one. So has a wasm module that knows no sessions (`own_map.rs`): it reads what another module writes (`wire.rs`).

#[cfg(feature = "names")]
mod own_map;
pub mod wire;

#[cfg(feature = "names")]
pub use own_map::OwnMap;

use crate::land::Land;
use crate::network::{Network, PastCourses, Place, Reach};
use crate::recipe::{Cartouche, Key, Labels, Recipe, Style};
use crate::relief::Relief;
use crate::session::{Phase, Session};
use crate::tree::Tree;

/// What of a recipe a chart is made by: names, labels, woods and hills.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartOptions {
    /// The seed.
    pub seed: String,
    /// The number of the language of names; 0 for the seed's own.
    pub language: u32,
    /// Names of one's own, as links have them.
    pub names: String,
    /// How many labels there are to be.
    pub labels: Labels,
    /// Whether the map's name stands in a corner.
    pub cartouche: Cartouche,
    /// What sizes of letters are multiplied by.
    pub label_size: f32,
    /// The map's width over its height.
    pub aspect: f32,
    /// The style.
    pub style: Style,
    /// How much of the land is to be wooded, from 0 to 1.
    pub woods: f32,
    /// How thickly hills are to stand, from 0 to 1.
    pub hills: f32,
}

impl ChartOptions {
    /// Those of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        Self {
            seed: recipe.seed().into(),
            language: recipe.integer(Key::Language),
            names: Key::Names.parameter().text_of(recipe.value(Key::Names)),
            labels: recipe.get(),
            cartouche: recipe.get(),
            label_size: recipe.number(Key::LabelSize),
            aspect: recipe.number(Key::Aspect),
            style: recipe.get(),
            woods: recipe.number(Key::Woods),
            hills: recipe.number(Key::Hills),
        }
    }

    /// How much there is to be of woods and of hills, in a style that may show none.
    pub fn scenery(&self) -> [f32; 2] {
        let shown = |amount: f32, is_shown: bool| if is_shown { amount } else { 0.0 };
        [shown(self.woods, self.style.has_woods()), shown(self.hills, self.style.has_hills())]
    }

    /// Whether there are to be woods or hills.
    pub fn has_scenery(&self) -> bool {
        self.scenery() != [0.0; 2]
    }

    /// Whether labels are to be more than names, as the style has it.
    pub fn has_marks(&self) -> bool {
        self.labels != Labels::None && self.style.has_marks()
    }

    /// The style, if that, too, decides what there is on the map.
    pub fn deciding_style(&self) -> Option<Style> {
        (self.has_scenery() || self.has_marks()).then_some(self.style)
    }

    /// Whether there is to be anything.
    pub fn any(&self) -> bool {
        self.labels != Labels::None || self.cartouche != Cartouche::None || self.has_scenery()
    }
}

/// Rivers as they are, and what lies around them.
#[derive(Clone, Debug)]
pub struct RiverMap<'a> {
    /// What its chart is made by.
    pub options: ChartOptions,
    /// The untrimmed tree.
    pub tree: &'a Tree,
    /// The discharge that would be everything a river can drain.
    pub total_discharge: u32,
    /// The rivers.
    pub network: &'a Network,
    /// Where the great ones are flat.
    pub reaches: &'a [Reach],
    /// The land; `None` if all of the domain is.
    pub land: Option<&'a Land>,
    /// Its heights, if the style shows them, and there is to be scenery, or numbers that say them.
    pub relief: Option<&'a Relief>,
    /// The beds in which great rivers ran before, if the style shows them, and there is to be scenery.
    pub beds: Vec<Vec<Place>>,
    /// Whether there is nothing more to do: neither rivers nor heights will change.
    pub is_finished: bool,
}

impl<'a> RiverMap<'a> {
    /// The map of a session; `None` while there are no rivers.
    pub fn of(session: &'a Session) -> Option<Self> {
        let options = ChartOptions::of(session.recipe());
        let has_scenery = options.has_scenery();
        let has_heights =
            options.style.has_relief() && (has_scenery || (options.has_marks() && options.style.has_spot_heights()));
        Some(Self {
            relief: session.relief().filter(|_| has_heights).map(AsRef::as_ref),
            beds: if has_scenery && options.style == Style::PastCourses { beds(session) } else { Vec::new() },
            options,
            tree: session.tree(),
            total_discharge: session.growth().total_discharge(),
            network: session.network()?,
            reaches: session.reaches(),
            land: session.land().map(AsRef::as_ref),
            is_finished: session.phase() == Phase::Finished,
        })
    }
}

/// The beds in which great rivers ran before.
fn beds(session: &Session) -> Vec<Vec<Place>> {
    let rounds = session.past().map_or(&[][..], PastCourses::rounds);
    rounds.iter().flat_map(|round| round.courses.iter().chain(&round.loops)).map(|bed| bed.line.clone()).collect()
}
