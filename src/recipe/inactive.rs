//! Which parameters do nothing in a recipe, and why: the one place where that is decided.

use super::choice::{GrowthMethod, LandKind, MeanderModel, Style};
use super::key::Key;
use super::{Decimal, Recipe, Value};

/// Why a parameter does nothing; `None` if it does something.
type Reason = Option<&'static str>;

const STILL: &str = "Rivers do not meander here.";

impl Recipe {
    /// Why a parameter does nothing in this recipe, in a sentence; `None` if it does something.
    pub fn inactive_reason(&self, key: Key) -> Option<&'static str> {
        match key {
            Key::Seed | Key::Edition | Key::Aspect | Key::Land | Key::Growth => None,
            Key::Sea => self.no_coast().or_else(|| self.sea_is_drawn()),
            Key::Rough => self.no_coast(),
            Key::Sides => self.sea_is_drawn().or_else(|| self.sides_are_given()),
            Key::Outline => (self.shown_land() != LandKind::Drawn).then_some("The land is not drawn."),
            Key::Apart | Key::Shores => self.no_coast().or_else(|| self.not_colonizing()),
            Key::Mouths | Key::Attractors | Key::Scatter | Key::Reach | Key::Kill | Key::Step => self.not_colonizing(),
            Key::Momentum | Key::Curl => self.not_colonizing(),
            Key::Stretch => self.not_colonizing().or_else(|| self.no_curl()),
            Key::Sensitivity => self.not_brownian(),
            Key::Trim | Key::Simplify => None,
            Key::Width | Key::Vary => self.no_widths(),
            Key::Meander => None,
            Key::MeanderRounds => self.no_meandering(),
            Key::Gentle | Key::Great => self.no_rounds(),
            Key::Flat => self.no_rounds().or_else(|| self.no_great_rivers()),
            Key::MeanderStrength | Key::Neck | Key::Buffer | Key::Taper => self.no_bends(),
            Key::MeanderMix => self.no_bends().or_else(|| self.no_choice_of_direction()),
            Key::Style => None,
        }
    }

    fn no_coast(&self) -> Reason {
        (self.shown_land() == LandKind::Rectangle).then_some("The whole rectangle is land: it has no coast.")
    }

    fn sea_is_drawn(&self) -> Reason {
        (self.shown_land() == LandKind::Drawn).then_some("The drawing says where the sea is.")
    }

    fn sides_are_given(&self) -> Reason {
        match self.shown_land() {
            LandKind::Island | LandKind::Archipelago => Some("This land has the sea all round."),
            LandKind::Basin => Some("Rivers run to the lake in the middle."),
            LandKind::Continent | LandKind::Valley | LandKind::Rectangle | LandKind::Drawn => None,
        }
    }

    fn not_colonizing(&self) -> Reason {
        match self.get() {
            GrowthMethod::Colonize => None,
            GrowthMethod::Brownian => Some("Only space colonization has it."),
        }
    }

    fn not_brownian(&self) -> Reason {
        match self.get() {
            GrowthMethod::Brownian => None,
            GrowthMethod::Colonize => Some("Only a Brownian tree has it."),
        }
    }

    fn no_curl(&self) -> Reason {
        self.is_zero(Key::Curl).then_some("Only rivers with curl have stretches.")
    }

    /// Bends grow in proportion to widths: of rivers that meander the skeleton shows widths, too.
    fn no_widths(&self) -> Reason {
        let is_skeleton = self.get::<Style>() == Style::Skeleton;
        (is_skeleton && self.no_rounds().is_some()).then_some("The skeleton is one pixel wide everywhere.")
    }

    fn no_meandering(&self) -> Reason {
        (self.get::<MeanderModel>() == MeanderModel::None).then_some(STILL)
    }

    fn no_rounds(&self) -> Reason {
        self.is_zero(Key::MeanderRounds).then_some(STILL).or_else(|| self.no_meandering())
    }

    fn no_bends(&self) -> Reason {
        (self.is_zero(Key::Great) && self.is_zero(Key::Gentle)).then_some(STILL).or_else(|| self.no_rounds())
    }

    fn no_great_rivers(&self) -> Reason {
        self.is_zero(Key::Great).then_some("There are no great rivers.")
    }

    fn no_choice_of_direction(&self) -> Reason {
        match self.get() {
            _ if self.is_zero(Key::MeanderStrength) => Some(STILL),
            MeanderModel::Flow => Some("Only bends that grow outward have it."),
            MeanderModel::Bend | MeanderModel::None => None,
        }
    }

    /// The land as it is: a drawn one of which nothing is drawn is the whole rectangle.
    fn shown_land(&self) -> LandKind {
        match self.get() {
            LandKind::Drawn if self.outline().is_none() => LandKind::Rectangle,
            land => land,
        }
    }

    fn is_zero(&self, key: Key) -> bool {
        match self.value(key) {
            Value::Integer(integer) => *integer == 0,
            Value::Number(decimal) => *decimal == Decimal::whole(0),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::recipe::table::TABLE;

    fn reason(link: &str, key: Key) -> Option<&'static str> {
        link::read(link).unwrap().inactive_reason(key)
    }

    #[test]
    fn rules_go_by_the_choices_that_they_name() {
        for (link, key, expected) in [
            ("land=rectangle", Key::Sea, "The whole rectangle"),
            ("land=drawn", Key::Sea, "The whole rectangle"),
            ("land=rectangle", Key::Shores, "The whole rectangle"),
            ("land=island", Key::Sides, "This land"),
            ("land=drawn&outline=.MzMzzMMzzMzM", Key::Sea, "The drawing"),
            ("growth=colonize", Key::Sensitivity, "Only a Brownian tree"),
            ("growth=brownian", Key::Mouths, "Only space colonization"),
            ("meander=flow", Key::MeanderMix, "Only bends that grow outward"),
            ("meander=none", Key::MeanderRounds, "Rivers do not meander"),
            ("meander-rounds=0", Key::Taper, "Rivers do not meander"),
            ("meander-strength=0", Key::MeanderMix, "Rivers do not meander"),
            ("great=0", Key::Flat, "There are no great rivers"),
            ("great=0&gentle=0", Key::Taper, "Rivers do not meander"),
            ("curl=0", Key::Stretch, "Only rivers with curl"),
            ("style=skeleton&meander=none", Key::Width, "The skeleton"),
            ("land=island&outline=.MzMzzMMzzMzM", Key::Outline, "The land is not drawn"),
        ] {
            assert!(
                reason(link, key).is_some_and(|reason| reason.starts_with(expected)),
                "{link}: {:?}",
                reason(link, key)
            );
        }
    }

    #[test]
    fn what_does_something_has_no_reason_not_to() {
        for (link, key) in [
            ("land=valley", Key::Sides),
            ("land=island", Key::Shores),
            ("land=continent", Key::Sides),
            ("land=drawn&outline=.MzMzzMMzzMzM", Key::Outline),
            ("meander-rounds=0", Key::MeanderRounds),
            ("great=0", Key::Taper),
            ("style=skeleton", Key::Width),
            ("curl=0.5", Key::Stretch),
        ] {
            assert_eq!(reason(link, key), None, "{link}");
        }
    }

    /// A recipe in which next to everything does something, whatever the defaults are.
    const LIVELY: &str = "land=rectangle&growth=colonize&curl=0.5&meander=bend&meander-rounds=60&meander-strength=0.5&great=3&gentle=0.3&style=ink";

    const NO_COAST: (&str, &str) = ("sea rough apart shores", "The whole rectangle is land: it has no coast.");
    const NOT_DRAWN: (&str, &str) = ("outline", "The land is not drawn.");
    const NO_SENSITIVITY: (&str, &str) = ("sensitivity", "Only a Brownian tree has it.");
    const RECTANGULAR: &[(&str, &str)] = &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY];

    /// What is set over the lively recipe, and all keys that do nothing then, each with its reason.
    const EXPECTED: &[(&str, &[(&str, &str)])] = &[
        ("", RECTANGULAR),
        ("land=drawn&outline=", RECTANGULAR),
        ("land=drawn&outline=.MzMzzMMzzMzM", &[("sea sides", "The drawing says where the sea is."), NO_SENSITIVITY]),
        ("land=island", &[("sides", "This land has the sea all round."), NOT_DRAWN, NO_SENSITIVITY]),
        ("land=archipelago", &[("sides", "This land has the sea all round."), NOT_DRAWN, NO_SENSITIVITY]),
        ("land=continent", &[NOT_DRAWN, NO_SENSITIVITY]),
        ("land=valley", &[NOT_DRAWN, NO_SENSITIVITY]),
        ("land=basin", &[("sides", "Rivers run to the lake in the middle."), NOT_DRAWN, NO_SENSITIVITY]),
        (
            "land=continent&growth=brownian",
            &[
                NOT_DRAWN,
                (
                    "mouths apart shores attractors scatter reach kill step momentum curl stretch",
                    "Only space colonization has it.",
                ),
            ],
        ),
        (
            "growth=brownian",
            &[
                NO_COAST,
                NOT_DRAWN,
                ("mouths attractors scatter reach kill step momentum curl stretch", "Only space colonization has it."),
            ],
        ),
        ("curl=0", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, ("stretch", "Only rivers with curl have stretches.")]),
        (
            "meander=none",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                ("meander-rounds meander-strength meander-mix gentle great flat neck buffer taper", STILL),
            ],
        ),
        (
            "meander-rounds=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                ("meander-strength meander-mix gentle great flat neck buffer taper", STILL),
            ],
        ),
        (
            "great=0&gentle=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                ("meander-strength meander-mix neck buffer taper", STILL),
                ("flat", "There are no great rivers."),
            ],
        ),
        ("great=0", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, ("flat", "There are no great rivers.")]),
        ("gentle=0", RECTANGULAR),
        ("meander-strength=0", &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, ("meander-mix", STILL)]),
        (
            "meander=flow",
            &[NO_COAST, NOT_DRAWN, NO_SENSITIVITY, ("meander-mix", "Only bends that grow outward have it.")],
        ),
        ("style=skeleton", RECTANGULAR),
        (
            "style=skeleton&meander-rounds=0",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                ("meander-strength meander-mix gentle great flat neck buffer taper", STILL),
                ("width vary", "The skeleton is one pixel wide everywhere."),
            ],
        ),
        (
            "style=skeleton&meander=none",
            &[
                NO_COAST,
                NOT_DRAWN,
                NO_SENSITIVITY,
                ("meander-rounds meander-strength meander-mix gentle great flat neck buffer taper", STILL),
                ("width vary", "The skeleton is one pixel wide everywhere."),
            ],
        ),
    ];

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
                assert_eq!(recipe.inactive_reason(parameter.key), reason, "{} with {over:?}", parameter.name);
            }
        }
    }
}
