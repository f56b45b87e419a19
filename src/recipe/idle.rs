//! Which parameters do nothing in a recipe, and why: the one place where that is decided.

use super::Recipe;
use super::parameter::Key;

/// Keys that do nothing while all of some facts hold.
struct Rule {
    keys: &'static [Key],
    /// One of these facts holds, and one of those.
    when: [u32; 2],
    reason: &'static str,
}

// Facts of a recipe, a bit each. The choices of a parameter come one after the other, in the table's order.
const RECTANGLE: u32 = 1;
const ISLAND: u32 = 1 << 1;
const ARCHIPELAGO: u32 = 1 << 3;
const BASIN: u32 = 1 << 5;
const DRAWN: u32 = 1 << 6;
const GROWTH: usize = 8;
const COLONIZE: u32 = 1 << GROWTH;
const BROWNIAN: u32 = 2 << GROWTH;
const MEANDER: usize = 10;
const FLOW: u32 = 2 << MEANDER;
const STRAIGHT: u32 = 4 << MEANDER;
const STYLE: usize = 14;
const SKELETON: u32 = 2 << STYLE;
const ZERO: usize = 20;
/// Parameters of which it matters whether they are 0.
const ZEROS: [Key; 5] = [Key::Curl, Key::MeanderRounds, Key::MeanderStrength, Key::Great, Key::Gentle];
const NO_CURL: u32 = 1 << ZERO;
const NO_ROUNDS: u32 = 2 << ZERO;
const NO_STRENGTH: u32 = 4 << ZERO;
const NO_GREAT: u32 = 8 << ZERO;
const NO_GENTLE: u32 = 16 << ZERO;
const ALWAYS: u32 = !0;

/// All that meandering goes by, but its model.
const MEANDERS: &[Key] = &[
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

const fn rule(keys: &'static [Key], when: u32, and: u32, reason: &'static str) -> Rule {
    Rule { keys, when: [when, and], reason }
}

/// Of several rules for a key the first that holds gives the reason.
static RULES: [Rule; 17] = [
    rule(&[Key::Sea, Key::Rough, Key::Apart], RECTANGLE, ALWAYS, "The whole rectangle is land: it has no coast."),
    rule(&[Key::Sea, Key::Sides], DRAWN, ALWAYS, "The drawing says where the sea is."),
    rule(&[Key::Sides], ISLAND | ARCHIPELAGO, ALWAYS, "This land has the sea all round."),
    rule(&[Key::Sides], BASIN, ALWAYS, "Rivers run to the lake in the middle."),
    rule(&[Key::Mouths, Key::Apart], BROWNIAN, ALWAYS, "A Brownian tree finds its own mouths."),
    rule(&[Key::Sensitivity], COLONIZE, ALWAYS, "Only a Brownian tree has it."),
    rule(
        &[Key::Attractors, Key::Scatter, Key::Reach, Key::Kill, Key::Step],
        BROWNIAN,
        ALWAYS,
        "A Brownian tree has no attractors.",
    ),
    rule(&[Key::Momentum, Key::Curl, Key::Stretch], BROWNIAN, ALWAYS, "A Brownian tree bends as its particles wander."),
    rule(&[Key::Stretch], NO_CURL, ALWAYS, "Only rivers with curl have stretches."),
    rule(MEANDERS, STRAIGHT, ALWAYS, "Rivers do not meander here."),
    rule(MEANDERS.split_at(1).1, NO_ROUNDS, ALWAYS, "Without a round no river meanders."),
    rule(&[Key::MeanderMix], FLOW, ALWAYS, "Only bends that grow outward have it."),
    rule(&[Key::MeanderMix], NO_STRENGTH, ALWAYS, "Bends without strength do not move."),
    rule(&[Key::Flat], NO_GREAT, ALWAYS, "No great rivers, none that is flat."),
    rule(
        &[Key::MeanderStrength, Key::MeanderMix, Key::Neck, Key::Buffer, Key::Taper],
        NO_GREAT,
        NO_GENTLE,
        "No river meanders, great or gently.",
    ),
    // Bends grow in proportion to widths: of rivers that meander the skeleton shows widths, too.
    rule(&[Key::Width, Key::Vary], SKELETON, STRAIGHT | NO_ROUNDS, "The skeleton is one pixel wide everywhere."),
    rule(&[Key::Outline], !DRAWN & 0xff, ALWAYS, "The land is not drawn."),
];

impl Recipe {
    /// Why a parameter does nothing in this recipe, in a sentence; `None` if it does something.
    pub fn idle_reason(&self, key: Key) -> Option<&'static str> {
        let facts = self.facts();
        let holds = |rule: &&Rule| rule.keys.contains(&key) && rule.when.iter().all(|any| facts & any != 0);
        RULES.iter().find(holds).map(|rule| rule.reason)
    }

    /// What the rules go by.
    fn facts(&self) -> u32 {
        // A drawn land of which nothing is drawn is the whole rectangle.
        let land = 1 << self.choice(Key::Land);
        let land = if land == DRAWN && self.outline().is_none() { RECTANGLE } else { land };
        let choices = [(Key::Growth, GROWTH), (Key::Meander, MEANDER), (Key::Style, STYLE)];
        let zeros = ZEROS.iter().enumerate().filter(|(_, key)| self.number(**key) == 0.0);
        choices.iter().fold(land, |facts, (key, at)| facts | 1 << (at + self.choice(*key)))
            | zeros.fold(0, |facts, (i, _)| facts | 1 << (ZERO + i))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn reason(link: &str, key: Key) -> Option<&'static str> {
        link::read(link).unwrap().idle_reason(key)
    }

    #[test]
    fn rules_go_by_the_choices_that_they_name() {
        for (link, key, expected) in [
            ("land=rectangle", Key::Sea, "The whole rectangle"),
            ("land=drawn", Key::Sea, "The whole rectangle"),
            ("land=drawn&outline=.MzMzzMMzzMzM", Key::Sea, "The drawing"),
            ("growth=colonize", Key::Sensitivity, "Only a Brownian tree"),
            ("growth=brownian", Key::Mouths, "A Brownian tree finds"),
            ("meander=flow", Key::MeanderMix, "Only bends that grow outward"),
            ("meander=none", Key::MeanderRounds, "Rivers do not meander"),
            ("meander-rounds=0", Key::Taper, "Without a round"),
            ("meander-strength=0", Key::MeanderMix, "Bends without strength"),
            ("great=0", Key::Flat, "No great rivers"),
            ("great=0&gentle=0", Key::Taper, "No river meanders"),
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
}
