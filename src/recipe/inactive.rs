//! Parameters that have no effect in a recipe, and the reasons: the only place that decides this.

use super::choice::{CourseShape, GrowthMethod, Labels, LandKind, MeanderModel, Pattern};
use super::key::Key;
use super::style::Style;
use super::{Decimal, Recipe, Value};

/// The reason why a parameter has no effect; `None` if it has one.
type Reason = Option<&'static str>;

const STILL: &str = "rivers do not meander";

impl Recipe {
    /// Returns the reason why a parameter has no effect in this recipe, worded to complete a sentence; `None` if it has
    /// one. `land` is the kind of land of the recipe, from [`Land::kind_of`](crate::Land::kind_of).
    pub fn inactive_reason(&self, key: Key, land: LandKind) -> Option<&'static str> {
        Given { recipe: self, land }.inactive_reason(key)
    }

    /// Returns the reason why a parameter has no effect in data files, as [`inactive_reason`](Self::inactive_reason)
    /// gives it for pictures. Data files have widths and heights in every style.
    pub fn inactive_reason_in_data(&self, key: Key, land: LandKind) -> Option<&'static str> {
        let mut shown = self.clone();
        shown.put(Key::Style, Value::Choice(Style::Atlas.word().name));
        shown.inactive_reason(key, land)
    }
}

/// A recipe and its actual kind of land: a drawing without water, or with hardly any land, is the whole rectangle.
struct Given<'a> {
    recipe: &'a Recipe,
    land: LandKind,
}

impl Given<'_> {
    fn inactive_reason(&self, key: Key) -> Reason {
        match key {
            Key::Seed | Key::Edition | Key::Country | Key::Aspect | Key::Span | Key::Land | Key::Growth => None,
            Key::Sea => self.no_coast().or_else(|| self.sea_is_drawn()),
            Key::Drowning => self.no_coast().or_else(|| self.sea_is_drawn()).or_else(|| self.not_draining()),
            Key::Roughness => self.no_coast(),
            Key::Sides => self.mouths_are_drawn().or_else(|| self.sea_is_drawn()).or_else(|| self.sides_are_given()),
            Key::Outline => self.nothing_is_drawn(),
            Key::MouthSpacing | Key::Shores => self.no_coast().or_else(|| self.no_choice_of_mouths()),
            Key::Mouths => self.no_choice_of_mouths(),
            Key::Attractors => self.brownian(),
            Key::Scatter => self.not_colonizing().or_else(|| self.has_cells()),
            Key::Reach | Key::Kill | Key::Step => self.not_colonizing(),
            Key::Momentum | Key::Curl => self.not_colonizing(),
            Key::Stretch => self.not_colonizing().or_else(|| self.no_curl()),
            Key::Sensitivity => self.not_brownian(),
            Key::Valleys => self.brownian().or_else(|| self.valleys_are_given()),
            Key::Concavity | Key::Captures | Key::Hardness => self.not_draining(),
            Key::Bending | Key::ChannelArea | Key::HeadVariation => self.not_draining(),
            Key::Pattern | Key::Fall => self.not_draining(),
            Key::Strike => self.not_draining().or_else(|| self.no_strike()),
            Key::CenterX | Key::CenterY => self.no_center(),
            Key::BendingVariation => self.not_draining().or_else(|| self.no_bending()),
            Key::ValleySpacing => self.brownian().or_else(|| self.no_valleys()),
            Key::HardnessScale => self.not_draining().or_else(|| self.no_hardness()),
            Key::TrimVariation => self.no_trim(),
            Key::Trim | Key::TributarySpacing | Key::Courses => None,
            Key::Simplify | Key::Meander => self.as_grown(),
            Key::Width | Key::BankVariation => self.no_widths(),
            Key::Deltas => self.no_coast(),
            Key::Waves => self.no_coast().or_else(|| self.no_deltas()),
            Key::MeanderRounds => self.no_meandering(),
            Key::MeanderElsewhere | Key::GreatRivers => self.no_rounds(),
            Key::FlatShare => self.no_rounds().or_else(|| self.no_great_rivers()),
            Key::MeanderStrength | Key::Neck | Key::Oxbows | Key::Clearance | Key::Taper => self.no_bends(),
            Key::MeanderMix => self.no_bends().or_else(|| self.no_choice_of_direction()),
            Key::Mountains | Key::Plains => self.heights_only_in_files(),
            Key::Lakes => self.no_lakes(),
            Key::Rills => self.heights_only_in_files().or_else(|| self.no_hillsides()),
            Key::Shade => self.no_relief(),
            Key::Warmth | Key::Rain => self.no_weather(),
            Key::Ground => self.no_climate(),
            Key::RainShadow => self.no_relief().or_else(|| self.no_weather()),
            Key::Wind => self.no_relief().or_else(|| self.no_weather()).or_else(|| self.no_rain_shadow()),
            Key::LabelSize => self.no_labels(),
            Key::Woods => self.no_woods(),
            Key::Hills => self.no_hills(),
            Key::Style | Key::Labels | Key::Language | Key::Names | Key::Cartouche => None,
        }
    }

    fn no_coast(&self) -> Reason {
        (self.land == LandKind::Rectangle).then_some("the whole rectangle is land, so there is no coast")
    }

    fn nothing_is_drawn(&self) -> Reason {
        (self.land != LandKind::Drawn && self.recipe.rivers().is_empty()).then_some("the land is not drawn")
    }

    fn mouths_are_drawn(&self) -> Reason {
        (!self.recipe.rivers().is_empty()).then_some("the drawing determines where rivers begin")
    }

    fn no_choice_of_mouths(&self) -> Reason {
        self.brownian().or_else(|| self.mouths_are_drawn())
    }

    fn sea_is_drawn(&self) -> Reason {
        (self.land == LandKind::Drawn).then_some("the drawing determines where the sea is")
    }

    fn sides_are_given(&self) -> Reason {
        match self.land {
            LandKind::Basin => Some("rivers flow to the lake in the middle"),
            LandKind::Gulf => Some("rivers flow to the gulf in the middle"),
            LandKind::Island | LandKind::Archipelago => Some("this land has the sea all around it"),
            LandKind::Crescent | LandKind::Twins | LandKind::Long | LandKind::Arms => {
                Some("this land has the sea all around it")
            }
            LandKind::Continent | LandKind::Valley | LandKind::Rectangle | LandKind::Drawn => None,
        }
    }

    fn not_colonizing(&self) -> Reason {
        self.unless_grown_by(GrowthMethod::Colonize, "only space colonization uses it")
    }

    fn not_brownian(&self) -> Reason {
        self.unless_grown_by(GrowthMethod::Brownian, "only Brownian trees use it")
    }

    fn not_draining(&self) -> Reason {
        self.unless_grown_by(GrowthMethod::Drainage, "only drainage uses it")
    }

    fn unless_grown_by(&self, method: GrowthMethod, reason: &'static str) -> Reason {
        (self.recipe.get::<GrowthMethod>() != method).then_some(reason)
    }

    fn brownian(&self) -> Reason {
        match self.recipe.get() {
            GrowthMethod::Brownian => Some("Brownian trees do not use it"),
            GrowthMethod::Colonize | GrowthMethod::Drainage => None,
        }
    }

    fn no_valleys(&self) -> Reason {
        let has_none = match self.pattern() {
            Pattern::Parallel => true,
            Pattern::Deranged => false,
            _ => self.is_zero(Key::Valleys),
        };
        has_none.then_some("there are no valleys")
    }

    fn has_cells(&self) -> Reason {
        (!self.is_zero(Key::Valleys)).then_some("with valleys, attractors lie in cells of the map")
    }

    fn no_hardness(&self) -> Reason {
        self.is_zero(Key::Hardness).then_some("all ground is equally hard")
    }

    fn no_bending(&self) -> Reason {
        self.is_zero(Key::Bending).then_some("courses are not bent")
    }

    fn no_strike(&self) -> Reason {
        let has_strike = matches!(self.pattern(), Pattern::Trellis | Pattern::Rectangular | Pattern::Parallel);
        (!has_strike).then_some("this pattern has no strike")
    }

    fn no_center(&self) -> Reason {
        if self.land.holds_water() {
            return None;
        }
        let has_center = matches!(self.pattern(), Pattern::Radial | Pattern::Annular | Pattern::Centripetal);
        self.not_draining().or_else(|| (!has_center).then_some("this pattern has no centre"))
    }

    /// Explains why valleys have no effect: parallel drainage has none, and deranged drainage the deepest.
    fn valleys_are_given(&self) -> Reason {
        matches!(self.pattern(), Pattern::Parallel | Pattern::Deranged).then_some("the pattern determines the valleys")
    }

    /// Returns the pattern of drainage, which is that of a tree in other ways of growing.
    fn pattern(&self) -> Pattern {
        match self.recipe.get() {
            GrowthMethod::Drainage => self.recipe.get(),
            GrowthMethod::Colonize | GrowthMethod::Brownian => Pattern::Dendritic,
        }
    }

    fn no_trim(&self) -> Reason {
        self.is_zero(Key::Trim).then_some("nothing is trimmed")
    }

    fn no_curl(&self) -> Reason {
        self.is_zero(Key::Curl).then_some("there is no curl")
    }

    /// Explains why widths have no effect: the skeleton draws none, but where rivers meander, bends grow in proportion
    /// to them.
    fn no_widths(&self) -> Reason {
        let is_skeleton = self.recipe.get::<Style>() == Style::Skeleton;
        (is_skeleton && self.no_rounds().is_some()).then_some("the skeleton is one pixel wide everywhere")
    }

    fn no_deltas(&self) -> Reason {
        self.is_zero(Key::Deltas).then_some("rivers carry no sediment")
    }

    fn heights_only_in_files(&self) -> Reason {
        // Lakes lie as the relief has them.
        let has_no_lakes = self.is_zero(Key::Lakes);
        self.no_relief().filter(|_| has_no_lakes).map(|_| "this style shows no relief, though files of heights have it")
    }

    fn no_lakes(&self) -> Reason {
        let is_skeleton = self.recipe.get::<Style>() == Style::Skeleton;
        is_skeleton.then_some("the skeleton shows rivers alone, though files have lakes")
    }

    /// Explains why rills have no effect: only drainage and what trimming removes reach beyond the drawn rivers.
    fn no_hillsides(&self) -> Reason {
        let has_hillsides = self.recipe.get::<GrowthMethod>() == GrowthMethod::Drainage;
        (!has_hillsides && self.is_zero(Key::Trim) && self.is_zero(Key::TributarySpacing))
            .then_some("nothing is trimmed, so all streams are drawn")
    }

    fn no_relief(&self) -> Reason {
        (!self.recipe.get::<Style>().has_relief()).then_some("this style shows no relief")
    }

    fn no_climate(&self) -> Reason {
        (!self.recipe.get::<Style>().has_climate()).then_some("this style has the same colours in every climate")
    }

    /// Explains why the weather has no effect: it decides colours, and where woods stand.
    fn no_weather(&self) -> Reason {
        let [woods, _] = self.recipe.scenery();
        self.no_climate().filter(|_| woods == 0.0)
    }

    fn no_rain_shadow(&self) -> Reason {
        self.is_zero(Key::RainShadow).then_some("rain falls evenly")
    }

    fn no_woods(&self) -> Reason {
        (!self.recipe.get::<Style>().has_woods()).then_some("this style shows no woods")
    }

    fn no_hills(&self) -> Reason {
        let style = self.recipe.get::<Style>();
        match (style.has_hills(), style.has_relief()) {
            (true, _) => None,
            (false, true) => Some("this style shows the relief itself, without signs for hills"),
            (false, false) => Some("this style shows no hills"),
        }
    }

    fn no_labels(&self) -> Reason {
        let has_none = self.recipe.get::<Labels>() == Labels::None && !self.recipe.has_title();
        has_none.then_some("there are no labels")
    }

    fn as_grown(&self) -> Reason {
        match self.recipe.get() {
            CourseShape::Grown => Some("rivers keep the steps of their tree"),
            CourseShape::Smooth => None,
        }
    }

    fn no_meandering(&self) -> Reason {
        let is_still = self.recipe.get::<MeanderModel>() == MeanderModel::None;
        self.as_grown().or_else(|| is_still.then_some(STILL))
    }

    fn no_rounds(&self) -> Reason {
        self.no_meandering().or_else(|| self.is_zero(Key::MeanderRounds).then_some(STILL))
    }

    fn no_bends(&self) -> Reason {
        let has_none = self.is_zero(Key::GreatRivers) && self.is_zero(Key::MeanderElsewhere);
        self.no_rounds().or_else(|| has_none.then_some(STILL))
    }

    fn no_great_rivers(&self) -> Reason {
        self.is_zero(Key::GreatRivers).then_some("there are no great rivers")
    }

    fn no_choice_of_direction(&self) -> Reason {
        match self.recipe.get() {
            _ if self.is_zero(Key::MeanderStrength) => Some("bends do not move"),
            MeanderModel::Flow => Some("only bends that grow outward use it"),
            MeanderModel::Bend | MeanderModel::None => None,
        }
    }

    fn is_zero(&self, key: Key) -> bool {
        match self.recipe.value(key) {
            Value::Integer(integer) => *integer == 0,
            Value::Number(decimal) => *decimal == Decimal::whole(0),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests;
