//! Which parameters do nothing in a recipe, and why: the one place where that is decided.

use super::parameter::Key;
use super::{Decimal, Recipe, Value};

/// Keys that do nothing while all of some facts hold.
struct Rule {
    /// A bit each, by number: smaller than lists.
    keys: u64,
    /// One of these facts holds, and one of those.
    when: [u32; 2],
    reason: &'static str,
}

/// Facts of a recipe, a bit each: that a choice is the one of that number, or a number is 0.
const FACTS: [(Key, u32); 15] = [
    (Key::Land, PLAIN_RECTANGLE),
    (Key::Land, 0),
    (Key::Land, 2),
    (Key::Land, 4),
    (Key::Land, DRAWN_LAND),
    (Key::Growth, 0),
    (Key::Growth, 1),
    (Key::Meander, 1),
    (Key::Meander, 2),
    (Key::Style, 1),
    (Key::Curl, 0),
    (Key::MeanderRounds, 0),
    (Key::MeanderStrength, 0),
    (Key::Great, 0),
    (Key::Gentle, 0),
];
const PLAIN_RECTANGLE: u32 = 5;
const DRAWN_LAND: u32 = 6;
const RECTANGLE: u32 = 1;
const ISLAND: u32 = 1 << 1;
const ARCHIPELAGO: u32 = 1 << 2;
const BASIN: u32 = 1 << 3;
const DRAWN: u32 = 1 << 4;
const COLONIZE: u32 = 1 << 5;
const BROWNIAN: u32 = 1 << 6;
const FLOW: u32 = 1 << 7;
const STRAIGHT: u32 = 1 << 8;
const SKELETON: u32 = 1 << 9;
const NO_CURL: u32 = 1 << 10;
const NO_ROUNDS: u32 = 1 << 11;
const NO_STRENGTH: u32 = 1 << 12;
const NO_GREAT: u32 = 1 << 13;
const NO_GENTLE: u32 = 1 << 14;
/// Known by the lack of another.
const UNDRAWN: u32 = 1 << 15;
const ALWAYS: u32 = !0;

/// All that space colonization goes by.
const COLONIZING: &[Key] = &[
    Key::Mouths,
    Key::Apart,
    Key::Shores,
    Key::Attractors,
    Key::Scatter,
    Key::Reach,
    Key::Kill,
    Key::Step,
    Key::Momentum,
    Key::Curl,
    Key::Stretch,
];
/// All that meandering goes by, but its model. Without rounds, rounds do something.
const MEANDERING: &[Key] = &[
    Key::MeanderRounds,
    Key::MeanderStrength,
    Key::MeanderMix,
    Key::Gentle,
    Key::Great,
    Key::Flat,
    Key::Neck,
    Key::Buffer,
    Key::Taper,
];
/// What is nothing to rivers none of which meanders.
const BENDING: &[Key] = &[Key::MeanderStrength, Key::MeanderMix, Key::Neck, Key::Buffer, Key::Taper];

const fn rule(keys: &[Key], when: u32, and: u32, reason: &'static str) -> Rule {
    Rule { keys: bits(keys), when: [when, and], reason }
}

const fn bits(keys: &[Key]) -> u64 {
    match keys {
        [first, rest @ ..] => 1 << *first as u64 | bits(rest),
        [] => 0,
    }
}

const STILL: &str = "Rivers do not meander here.";

/// Of several rules for a key the first that holds gives the reason.
static RULES: [Rule; 15] = [
    rule(
        &[Key::Sea, Key::Rough, Key::Apart, Key::Shores],
        RECTANGLE,
        ALWAYS,
        "The whole rectangle is land: it has no coast.",
    ),
    rule(&[Key::Sea, Key::Sides], DRAWN, ALWAYS, "The drawing says where the sea is."),
    rule(&[Key::Sides], ISLAND | ARCHIPELAGO, ALWAYS, "This land has the sea all round."),
    rule(&[Key::Sides], BASIN, ALWAYS, "Rivers run to the lake in the middle."),
    rule(&[Key::Outline], UNDRAWN, ALWAYS, "The land is not drawn."),
    rule(COLONIZING, BROWNIAN, ALWAYS, "Only space colonization has it."),
    rule(&[Key::Sensitivity], COLONIZE, ALWAYS, "Only a Brownian tree has it."),
    rule(&[Key::Stretch], NO_CURL, ALWAYS, "Only rivers with curl have stretches."),
    rule(MEANDERING, STRAIGHT, ALWAYS, STILL),
    rule(MEANDERING.split_at(1).1, NO_ROUNDS, ALWAYS, STILL),
    rule(BENDING, NO_GREAT, NO_GENTLE, STILL),
    rule(&[Key::MeanderMix], NO_STRENGTH, ALWAYS, STILL),
    rule(&[Key::MeanderMix], FLOW, ALWAYS, "Only bends that grow outward have it."),
    rule(&[Key::Flat], NO_GREAT, ALWAYS, "There are no great rivers."),
    // Bends grow in proportion to widths: of rivers that meander the skeleton shows widths, too.
    rule(&[Key::Width, Key::Vary], SKELETON, STRAIGHT | NO_ROUNDS, "The skeleton is one pixel wide everywhere."),
];

impl Recipe {
    /// Why a parameter does nothing in this recipe, in a sentence; `None` if it does something.
    pub fn idle_reason(&self, key: Key) -> Option<&'static str> {
        let facts = FACTS.iter().rev().fold(0, |facts, fact| facts << 1 | u32::from(self.holds(fact)));
        let facts = if facts & DRAWN == 0 { facts | UNDRAWN } else { facts };
        let applies = |rule: &&Rule| rule.keys >> key as u64 & 1 == 1 && rule.when.iter().all(|any| facts & any != 0);
        RULES.iter().find(applies).map(|rule| rule.reason)
    }

    // In line it would be there once a fact.
    #[inline(never)]
    fn holds(&self, &(key, number): &(Key, u32)) -> bool {
        match self.value(key) {
            // A drawn land of which nothing is drawn is the whole rectangle.
            Value::Choice(_) if key == Key::Land && self.is_undrawn() => number == PLAIN_RECTANGLE,
            Value::Choice(index) => *index as u32 == number,
            Value::Integer(integer) => *integer == number,
            Value::Number(decimal) => *decimal == Decimal::whole(number),
            _ => false,
        }
    }

    fn is_undrawn(&self) -> bool {
        self.choice(Key::Land) as u32 == DRAWN_LAND && self.outline().is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;
    use crate::recipe::table::TABLE;

    fn reason(link: &str, key: Key) -> Option<&'static str> {
        link::read(link).unwrap().idle_reason(key)
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
                assert_eq!(recipe.idle_reason(parameter.key), reason, "{} with {over:?}", parameter.name);
            }
        }
    }

    #[test]
    fn every_rule_is_expected_of_some_recipe() {
        for rule in &RULES {
            for parameter in TABLE.iter().filter(|parameter| rule.keys >> parameter.key as u64 & 1 == 1) {
                let is_expected = |(keys, reason): &(&str, &str)| {
                    *reason == rule.reason && keys.split(' ').any(|key| key == parameter.name)
                };
                let found = EXPECTED.iter().any(|(_, expected)| expected.iter().any(is_expected));
                assert!(found, "{}: {}", parameter.name, rule.reason);
            }
        }
    }
}
