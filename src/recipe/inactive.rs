//! Parameters that have no effect in a recipe, and the reasons: the only place that decides this.

use super::choice::{CourseShape, GrowthMethod, Labels, LandKind, MeanderModel, Pattern, Style};
use super::key::Key;
use super::{Decimal, Recipe, Value};

/// The reason why a parameter has no effect; `None` if it has one.
type Reason = Option<&'static str>;

const STILL: &str = "rivers do not meander";

impl Recipe {
    /// The reason why a parameter has no effect in this recipe, worded to complete a sentence; `None` if it has one.
    /// `land` is the kind of land of the recipe, from [`Land::kind_of`](crate::Land::kind_of).
    pub fn inactive_reason(&self, key: Key, land: LandKind) -> Option<&'static str> {
        Given { recipe: self, land }.inactive_reason(key)
    }

    /// The reason why a parameter has no effect in data files, as [`inactive_reason`](Self::inactive_reason) gives it
    /// for pictures. Data files have widths and heights in every style.
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
            Key::Seed | Key::Edition | Key::Aspect | Key::Land | Key::Growth => None,
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
            Key::CenterX | Key::CenterY => self.not_draining().or_else(|| self.no_center()),
            Key::BendingVariation => self.not_draining().or_else(|| self.no_bending()),
            Key::ValleySpacing => self.brownian().or_else(|| self.no_valleys()),
            Key::HardnessScale => self.not_draining().or_else(|| self.no_hardness()),
            Key::TrimVariation => self.no_trim(),
            Key::Trim | Key::TributarySpacing | Key::Courses => None,
            Key::Simplify | Key::Meander => self.as_grown(),
            Key::Width | Key::BankVariation => self.no_widths(),
            Key::MeanderRounds => self.no_meandering(),
            Key::MeanderElsewhere | Key::GreatRivers => self.no_rounds(),
            Key::FlatShare => self.no_rounds().or_else(|| self.no_great_rivers()),
            Key::MeanderStrength | Key::Neck | Key::Oxbows | Key::Clearance | Key::Taper => self.no_bends(),
            Key::MeanderMix => self.no_bends().or_else(|| self.no_choice_of_direction()),
            Key::Mountains | Key::Plains => self.heights_only_in_files(),
            Key::Rills => self.heights_only_in_files().or_else(|| self.no_hillsides()),
            Key::Shade => self.no_relief(),
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
            LandKind::Island | LandKind::Archipelago => Some("this land has the sea all around it"),
            LandKind::Basin => Some("rivers flow to the lake in the middle"),
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
        let has_center = matches!(self.pattern(), Pattern::Radial | Pattern::Annular | Pattern::Centripetal);
        (!has_center).then_some("this pattern has no centre")
    }

    /// Parallel drainage has no valleys, and deranged drainage the deepest.
    fn valleys_are_given(&self) -> Reason {
        matches!(self.pattern(), Pattern::Parallel | Pattern::Deranged).then_some("the pattern determines the valleys")
    }

    /// The pattern, which only drainage has.
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

    /// The skeleton draws no widths, but where rivers meander, bends grow in proportion to them.
    fn no_widths(&self) -> Reason {
        let is_skeleton = self.recipe.get::<Style>() == Style::Skeleton;
        (is_skeleton && self.no_rounds().is_some()).then_some("the skeleton is one pixel wide everywhere")
    }

    fn heights_only_in_files(&self) -> Reason {
        self.no_relief().map(|_| "this style shows no relief, though files of heights have it")
    }

    /// Only drainage and what trimming removes reach beyond the drawn rivers.
    fn no_hillsides(&self) -> Reason {
        let has_hillsides = self.recipe.get::<GrowthMethod>() == GrowthMethod::Drainage;
        (!has_hillsides && self.is_zero(Key::Trim) && self.is_zero(Key::TributarySpacing))
            .then_some("nothing is trimmed, so all streams are drawn")
    }

    fn no_relief(&self) -> Reason {
        (!self.recipe.get::<Style>().has_relief()).then_some("this style shows no relief")
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
mod tests {
    use super::*;
    use crate::land::Land;
    use crate::recipe::link;
    use crate::recipe::table::TABLE;

    fn reason(link: &str, key: Key) -> Option<&'static str> {
        let recipe = link::read(link).unwrap();
        recipe.inactive_reason(key, Land::kind_of(&recipe))
    }

    #[test]
    fn what_does_something_has_no_reason_not_to() {
        for (link, key) in [
            ("land=valley", Key::Sides),
            ("land=island", Key::Shores),
            ("land=continent", Key::Sides),
            ("land=drawn&outline=.MzMzzMMzzMzM", Key::Outline),
            ("meander-rounds=0", Key::MeanderRounds),
            ("great-rivers=0", Key::Taper),
            ("style=skeleton", Key::Width),
            ("growth=colonize&curl=0.5", Key::Stretch),
            ("growth=colonize&valleys=0", Key::Scatter),
            ("growth=colonize&valleys=0.3", Key::ValleySpacing),
            ("growth=drainage&hardness=0.1", Key::HardnessScale),
            ("growth=drainage&bending=0.1", Key::BendingVariation),
            ("growth=drainage&pattern=trellis", Key::Strike),
            ("growth=drainage&pattern=annular", Key::CenterY),
            ("growth=drainage&pattern=deranged&valleys=0", Key::ValleySpacing),
            ("growth=colonize&pattern=parallel", Key::Valleys),
            ("growth=drainage&land=island", Key::MouthSpacing),
            ("growth=drainage&land=valley", Key::Drowning),
            ("labels=none", Key::Labels),
            ("labels=none&cartouche=plain", Key::LabelSize),
            ("labels=few&cartouche=none", Key::LabelSize),
            ("style=ink&land=rectangle", Key::Woods),
            ("style=ink&land=rectangle", Key::Hills),
            ("style=survey", Key::Woods),
            ("style=parchment", Key::Hills),
            ("style=ink-wash", Key::Hills),
        ] {
            assert_eq!(reason(link, key), None, "{link}");
        }
    }

    /// A recipe in which nearly every parameter has an effect, whatever the defaults are.
    const LIVELY: &str = "land=rectangle&growth=colonize&valleys=0.3&curl=0.5&courses=smooth&meander=bend&meander-rounds=60&meander-strength=0.5&great-rivers=3&meander-elsewhere=0.3&labels=some&style=basins&trim=20";

    const NO_COAST: (&str, &str) =
        ("sea drowning roughness mouth-spacing shores", "the whole rectangle is land, so there is no coast");
    const DRAWN_MOUTHS: &str = "the drawing determines where rivers begin";
    const NOT_DRAWN: (&str, &str) = ("outline", "the land is not drawn");
    const NO_SENSITIVITY: (&str, &str) = ("sensitivity", "only Brownian trees use it");
    const NOT_DRAINING: (&str, &str) = (
        "drowning concavity captures hardness hardness-scale bending bending-variation pattern strike center-x center-y fall channel-area head-variation",
        "only drainage uses it",
    );
    const NO_STRIKE: (&str, &str) = ("strike", "this pattern has no strike");
    const NO_CENTER: (&str, &str) = ("center-x center-y", "this pattern has no centre");
    const IN_CELLS: (&str, &str) = ("scatter", "with valleys, attractors lie in cells of the map");
    const NOT_COLONIZING: (&str, &str) =
        ("scatter reach kill step momentum curl stretch", "only space colonization uses it");
    const BROWNIAN: (&str, &str) =
        ("mouths mouth-spacing shores attractors valleys valley-spacing", "Brownian trees do not use it");
    const NO_LONGER_SHAPED: &str = "simplify meander meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper";
    const NO_RELIEF: (&str, &str) = ("shade", "this style shows no relief");
    const NO_HEIGHTS: (&str, &str) =
        ("mountains plains rills", "this style shows no relief, though files of heights have it");
    const NO_WOODS: (&str, &str) = ("woods", "this style shows no woods");
    const NO_HILLS: (&str, &str) = ("hills", "this style shows no hills");
    const RELIEF_ITSELF: (&str, &str) = ("hills", "this style shows the relief itself, without signs for hills");
    const RECTANGULAR: &[(&str, &str)] = &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS];

    /// Values that are set over the lively recipe, and the keys without effect in the result, each with its reason.
    const EXPECTED: &[(&str, &[(&str, &str)])] = &[
        ("", RECTANGULAR),
        ("land=drawn&outline=", RECTANGULAR),
        // A drawing without sea, with and without a lake too small to be seen; and one with hardly any land.
        ("land=drawn&outline=.AAAA__AA____AA__", RECTANGULAR),
        ("land=drawn&outline=.AAAA__AA____AA__.gAgAgBgAgBgB", RECTANGULAR),
        ("land=drawn&outline=.gAgAhhgAgAhh", RECTANGULAR),
        (
            "land=drawn&outline=.MzMzzMMzzMzM",
            &[
                ("sea drowning sides", "the drawing determines where the sea is"),
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
            ],
        ),
        (
            "land=island",
            &[("sides", "this land has the sea all around it"), NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS],
        ),
        (
            "land=drawn&outline=.MzMzzMMzzMzM...gAgA",
            &[
                ("sea drowning", "the drawing determines where the sea is"),
                ("sides mouths mouth-spacing shores", DRAWN_MOUTHS),
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
            ],
        ),
        (
            "land=drawn&outline=...gAgA",
            &[NO_COAST, ("sides mouths", DRAWN_MOUTHS), NO_SENSITIVITY, NOT_DRAINING, IN_CELLS],
        ),
        // A drawing that is not used as land gives no mouths either.
        (
            "land=island&outline=...gAgA",
            &[("sides", "this land has the sea all around it"), NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS],
        ),
        (
            "land=archipelago",
            &[("sides", "this land has the sea all around it"), NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS],
        ),
        ("land=continent", &[NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS]),
        ("land=valley", &[NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS]),
        (
            "land=basin",
            &[("sides", "rivers flow to the lake in the middle"), NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS],
        ),
        ("land=continent&growth=brownian", &[NOT_DRAWN, NOT_DRAINING, BROWNIAN, NOT_COLONIZING]),
        ("growth=brownian", &[NO_COAST, NOT_DRAWN, NOT_DRAINING, BROWNIAN, NOT_COLONIZING]),
        ("curl=0", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, ("stretch", "there is no curl")]),
        (
            "meander=none",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (
                    "meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                    STILL,
                ),
            ],
        ),
        (
            "meander-rounds=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (
                    "meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                    STILL,
                ),
            ],
        ),
        (
            "great-rivers=0&meander-elsewhere=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                ("meander-strength meander-mix neck oxbows clearance taper", STILL),
                ("flat-share", "there are no great rivers"),
            ],
        ),
        (
            "great-rivers=0",
            &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, ("flat-share", "there are no great rivers")],
        ),
        ("meander-elsewhere=0", RECTANGULAR),
        (
            "meander-strength=0",
            &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, ("meander-mix", "bends do not move")],
        ),
        (
            "meander=flow",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                ("meander-mix", "only bends that grow outward use it"),
            ],
        ),
        (
            "courses=grown",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (NO_LONGER_SHAPED, "rivers keep the steps of their tree"),
            ],
        ),
        (
            "courses=grown&meander=none&great-rivers=0&meander-elsewhere=0&style=skeleton",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (NO_LONGER_SHAPED, "rivers keep the steps of their tree"),
                ("width bank-variation", "the skeleton is one pixel wide everywhere"),
                NO_RELIEF,
                NO_HEIGHTS,
                NO_WOODS,
                NO_HILLS,
            ],
        ),
        ("style=ink", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_RELIEF, NO_HEIGHTS]),
        (
            "style=skeleton",
            &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_RELIEF, NO_HEIGHTS, NO_WOODS, NO_HILLS],
        ),
        ("style=atlas", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, RELIEF_ITSELF]),
        ("style=orbit", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, NO_WOODS, RELIEF_ITSELF]),
        (
            "style=skeleton&meander-rounds=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (
                    "meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                    STILL,
                ),
                ("width bank-variation", "the skeleton is one pixel wide everywhere"),
                NO_RELIEF,
                NO_HEIGHTS,
                NO_WOODS,
                NO_HILLS,
            ],
        ),
        (
            "style=skeleton&meander=none",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_DRAINING,
                IN_CELLS,
                (
                    "meander-rounds meander-strength meander-mix meander-elsewhere great-rivers flat-share neck oxbows clearance taper",
                    STILL,
                ),
                ("width bank-variation", "the skeleton is one pixel wide everywhere"),
                NO_RELIEF,
                NO_HEIGHTS,
                NO_WOODS,
                NO_HILLS,
            ],
        ),
        ("growth=drainage", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_COLONIZING, NO_STRIKE, NO_CENTER]),
        (
            "growth=drainage&pattern=parallel&bending=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_COLONIZING,
                NO_CENTER,
                ("valleys", "the pattern determines the valleys"),
                ("valley-spacing", "there are no valleys"),
                ("bending-variation", "courses are not bent"),
            ],
        ),
        (
            "growth=drainage&pattern=deranged",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_COLONIZING,
                NO_STRIKE,
                NO_CENTER,
                ("valleys", "the pattern determines the valleys"),
            ],
        ),
        (
            "trim=0",
            &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, IN_CELLS, ("trim-variation", "nothing is trimmed")],
        ),
        (
            "growth=drainage&land=island",
            &[
                ("sides", "this land has the sea all around it"),
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_COLONIZING,
                NO_STRIKE,
                NO_CENTER,
            ],
        ),
        ("valleys=0", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, NOT_DRAINING, ("valley-spacing", "there are no valleys")]),
        (
            "growth=drainage&valleys=0&hardness=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                NOT_COLONIZING,
                NO_STRIKE,
                NO_CENTER,
                ("valley-spacing", "there are no valleys"),
                ("hardness-scale", "all ground is equally hard"),
            ],
        ),
    ];

    #[test]
    fn letters_have_a_size_where_there_are_letters() {
        for link in ["labels=none", "labels=none&cartouche=auto", "labels=none&cartouche=none"] {
            assert_eq!(reason(link, Key::LabelSize), Some("there are no labels"), "{link}");
        }
    }

    #[test]
    fn each_kind_of_recipe_has_its_idle_keys_and_no_others() {
        for (over, expected) in EXPECTED {
            let lively = link::pairs(LIVELY).unwrap().into_iter();
            let over = link::pairs(over).unwrap();
            let kept = lively.filter(|(key, _)| over.iter().all(|(other, _)| other != key));
            let recipe = link::apply(Recipe::default(), &kept.chain(over.clone()).collect::<Vec<_>>()).unwrap();
            for parameter in &TABLE {
                let names = |(keys, _): &&(&str, &str)| keys.split(' ').any(|key| key == parameter.name);
                let reason = expected.iter().find(names).map(|(_, reason)| *reason);
                assert_eq!(
                    recipe.inactive_reason(parameter.key, Land::kind_of(&recipe)),
                    reason,
                    "{} with {over:?}",
                    parameter.name
                );
            }
        }
    }
}
