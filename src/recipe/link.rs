//! Link text: `seed=kauri&edition=1&curl=0.6`, the form that people share.
//!
//! Defaults and what the country decides are left out, the edition never is. [`read`] is strict, for the command line and for tests;
//! [`read_leniently`] is total, for pages: a shared link must never leave a blank page, so invalid values are corrected
//! and reported.

use std::fmt;
use std::str::FromStr;

use super::error::RecipeError;
use super::hidden::{shown, visible};
use super::key::Key;
use super::names::OwnNames;
use super::parameter::{Kind, Parameter};
use super::table::TABLE;
use super::value::{Decimal, Value};
use super::{Recipe, preset};

/// The longest link that is read, in bytes.
pub const LONGEST: usize = 20_480;

/// The key that names a preset: read first, overridden by all other keys, never written.
pub const PRESET: &str = "preset";

/// Names of parameters and the texts of their values, as they follow each other in a link.
pub type Pairs = Vec<(String, String)>;

/// A correction that lenient reading made.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Notice {
    /// The corrected key; `link` if damage to the link was mended, and empty for the link as a whole.
    pub key: String,
    /// A sentence that names the fault and the value used instead.
    pub message: String,
}

/// Writes a recipe as link text, in the table's order. [`read`] returns the same recipe.
pub fn write(recipe: &Recipe) -> String {
    write_if(recipe, |_, is_default| !is_default)
}

/// Writes a recipe as the link of a file. It names the style even if that is the default: on a dark page the link then
/// shows what the file shows. [`read`] returns the same recipe.
pub fn write_for_file(recipe: &Recipe) -> String {
    write_if(recipe, |parameter, is_default| parameter.key == Key::Style || !is_default)
}

/// Writes the seed, the edition and each parameter that `is_written` selects, given whether it is left at its default or to the country.
pub(crate) fn write_if(recipe: &Recipe, is_written: impl Fn(&Parameter, bool) -> bool) -> String {
    let mut link = form_urlencoded::Serializer::new(String::new());
    for parameter in &TABLE {
        let value = recipe.value(parameter.key);
        let is_default = !recipe.is_named(parameter.key);
        if matches!(parameter.key, Key::Seed | Key::Edition) || is_written(parameter, is_default) {
            link.append_pair(parameter.name, &parameter.text_of(value));
        }
    }
    link.finish()
}

impl fmt::Display for Recipe {
    /// Writes link text, as [`write()`] does.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&write(self))
    }
}

impl FromStr for Recipe {
    type Err = RecipeError;

    /// Reads link text strictly, as [`read`] does.
    fn from_str(link: &str) -> Result<Self, RecipeError> {
        read(link)
    }
}

/// Reads link text strictly. What people hand over goes through [`given`](super::given) first.
///
/// # Errors
/// Refuses unknown and repeated keys, values that are not of their kind or out of range, and text that is too long.
pub fn read(link: &str) -> Result<Recipe, RecipeError> {
    apply(Recipe::default(), &pairs(link)?)
}

/// Splits link text into names and values, for [`apply`].
///
/// # Errors
/// If the link is too long.
pub fn pairs(link: &str) -> Result<Pairs, RecipeError> {
    refuse_if_long(link)?;
    Ok(split(link))
}

/// Refuses a link that is too long.
pub(super) fn refuse_if_long(link: &str) -> Result<(), RecipeError> {
    let length = link.len();
    if length > LONGEST { Err(RecipeError::TooLong { key: "link", length, max: LONGEST }) } else { Ok(()) }
}

/// Applies names and values to a recipe: a preset first, then everything else. All strict reading goes through here.
///
/// # Errors
/// Refuses what [`read`] refuses.
pub fn apply(mut recipe: Recipe, pairs: &[(String, String)]) -> Result<Recipe, RecipeError> {
    let mut presets = pairs.iter().filter(|(key, _)| key == PRESET);
    if let Some((_, name)) = presets.next() {
        apply_preset(&mut recipe, name)?;
    }
    if presets.next().is_some() {
        return Err(RecipeError::Duplicate { key: PRESET.into() });
    }
    let mut seen = [false; TABLE.len()];
    for (name, text) in pairs.iter().filter(|(key, _)| key != PRESET) {
        let key = Key::from_name(name).ok_or_else(|| RecipeError::UnknownKey { key: shown(name) })?;
        if std::mem::replace(&mut seen[key as usize], true) {
            return Err(RecipeError::Duplicate { key: shown(name) });
        }
        recipe.assign_text(key, text)?;
    }
    recipe.settle();
    Ok(recipe)
}

/// Reads link text as well as possible: values out of range are clamped, unreadable values and unknown keys are
/// ignored, and each correction is reported. Never fails.
pub fn read_leniently(link: &str) -> (Recipe, Vec<Notice>) {
    let mut notices = Vec::new();
    let pairs = split(shorten(link, &mut notices));
    (apply_leniently(&pairs, &mut notices).0, notices)
}

/// Applies names and values to the default recipe as [`read_leniently`] does; also returns for each parameter whether it is named.
pub(super) fn apply_leniently(pairs: &[(String, String)], notices: &mut Vec<Notice>) -> (Recipe, [bool; TABLE.len()]) {
    let mut recipe = Recipe::default();
    let mut presets = pairs.iter().filter(|(key, _)| key == PRESET);
    if let Some(Err(error)) = presets.next().map(|(_, name)| apply_preset(&mut recipe, name)) {
        notices.push(Notice { key: PRESET.into(), message: error.to_string() });
    }
    if presets.next().is_some() {
        notices.push(repeated(PRESET));
    }
    let (mut seen, mut refused) = ([false; TABLE.len()], Vec::new());
    for (name, text) in pairs.iter().filter(|(key, _)| key != PRESET) {
        let Some(key) = Key::from_name(name) else {
            notices.push(unknown(name));
            continue;
        };
        if std::mem::replace(&mut seen[key as usize], true) {
            notices.push(repeated(name));
        } else if key == Key::Names {
            take_names(&mut recipe, text, notices);
        } else if let Err(error) = recipe.assign_text(key, text) {
            refused.push((notices.len() + refused.len(), key, error));
            if let Some(value) = nearest_allowed(key.parameter(), text) {
                recipe.assign(key, value);
            }
        }
    }
    recipe.settle();
    // Only now it is known which value is drawn in place of one that cannot be read.
    for (at, key, error) in refused {
        notices.insert(at, corrected(&recipe, key, &error));
    }
    (recipe, seen)
}

/// Returns the notice that there is no parameter of a name.
pub(super) fn unknown(name: &str) -> Notice {
    told(&shown(name), &RecipeError::UnknownKey { key: shown(name) }, "it is left out")
}

fn repeated(name: &str) -> Notice {
    told(name, &RecipeError::Duplicate { key: name.into() }, "the first is used")
}

fn apply_preset(recipe: &mut Recipe, name: &str) -> Result<(), RecipeError> {
    let preset = preset::find(name).ok_or_else(|| RecipeError::UnknownPreset {
        name: shown(name),
        names: preset::PRESETS.iter().map(|preset| preset.name).collect::<Vec<_>>().join(", "),
    })?;
    preset.values.iter().try_for_each(|(key, text)| recipe.assign_text(*key, text))
}

/// Takes own names as far as they can be read: one that is wrong takes no other away, and is told by itself.
fn take_names(recipe: &mut Recipe, text: &str, notices: &mut Vec<Notice>) {
    let (names, faults) = OwnNames::corrected(text);
    recipe.assign(Key::Names, Value::Text(names.to_string()));
    let key = Key::Names.parameter().name;
    for reason in faults {
        let correction = reason.correction();
        notices.push(told(key, &RecipeError::Names { key, reason }, correction));
    }
}

/// Makes a notice of a fault and what is done about it.
#[inline(never)] // one copy
fn told(key: &str, error: &RecipeError, correction: &str) -> Notice {
    Notice { key: key.into(), message: format!("{error}: {correction}") }
}

/// Makes the notice of a refused value: the fault, and the value that is used instead.
fn corrected(recipe: &Recipe, key: Key, error: &RecipeError) -> Notice {
    let parameter = key.parameter();
    let used = parameter.text_of(recipe.value(key));
    let correction = match error {
        RecipeError::UnknownEdition { .. } => "the picture may differ from the one shared".into(),
        _ if used.is_empty() => "nothing is used".into(),
        _ => visible(&used) + " is used",
    };
    told(parameter.name, error, &correction)
}

fn nearest_allowed(parameter: &Parameter, text: &str) -> Option<Value> {
    let number = || Decimal::parse(text.trim());
    match parameter.kind {
        Kind::Integer { min, max, .. } => number().map(|n| Value::Integer(n.round().clamp(min, max))),
        Kind::Number { min, max, .. } => number().map(|x| Value::Number(x.clamp(min, max))),
        Kind::Text { longest, .. } => {
            let readable = |c: &char| !c.is_control() && *c != char::REPLACEMENT_CHARACTER;
            let cut: String = text.trim().chars().filter(readable).take(longest).collect();
            Some(Value::Text(cut.trim().into()))
        }
        Kind::Choice { .. } | Kind::Sides { .. } | Kind::Outline => None,
    }
}

/// Cuts a link that is too long, and adds a notice if it did.
pub(super) fn shorten<'a>(link: &'a str, notices: &mut Vec<Notice>) -> &'a str {
    let Err(error) = refuse_if_long(link) else { return link };
    notices.push(Notice { key: String::new(), message: format!("{error}: the rest is left out") });
    (0..=LONGEST).rev().find_map(|end| link.get(..end)).unwrap_or("")
}

/// Splits link text into names and values. Accepts any bytes.
#[inline(never)] // each copy weighs a thousand bytes
pub(super) fn split(link: &str) -> Pairs {
    form_urlencoded::parse(link.as_bytes())
        .into_owned()
        .filter(|(key, value)| !(key.is_empty() && value.is_empty()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::{IntegerKey, NumberKey};

    #[test]
    fn defaults_are_left_out_and_the_edition_is_not() {
        assert_eq!(write(&Recipe::default()), "seed=kauri&edition=1");
        let recipe = read("curl=0.60&seed=kauri").unwrap();
        assert_eq!(write(&recipe), "seed=kauri&edition=1&curl=0.6");
    }

    #[test]
    fn preset_is_read_first_wherever_it_stands() {
        let recipe = read("trim=9&preset=trimmed-curl").unwrap();
        assert_eq!(recipe.number(NumberKey::Trim), 9.0);
        assert!(recipe.number(NumberKey::Curl) > 0.0);
        assert!(!write(&recipe).contains("preset"));
    }

    #[test]
    fn strict_reading_names_what_is_wrong() {
        let error = |link: &str| read(link).unwrap_err().to_string();
        assert_eq!(error("depth=3"), "there is no parameter 'depth'");
        assert_eq!(error("curl=1&curl=1"), "'curl' is given more than once");
        assert_eq!(error("curl=3"), "curl: 3 is not between 0 and 2");
        assert_eq!(error("scatter=neon"), "scatter: 'neon' is not one of random, grid");
        assert_eq!(error("edition=7"), "edition: 7 is unknown here, this program draws edition 1");
        assert_eq!(error("seed=%FF"), "seed: the text holds a character that cannot be shown");
        assert!(error("preset=best").starts_with("there is no preset 'best': choose from original, "));
    }

    #[test]
    fn lenient_reading_clamps_and_tells() {
        let (recipe, notices) =
            read_leniently("country=usual&curl=3&mouths=2.6&trim=x&curl=1&depth=1&style=neon&kill=-9");
        assert_eq!(recipe.number(NumberKey::Curl), 2.0);
        assert_eq!(recipe.integer(IntegerKey::Mouths), 3);
        assert_eq!(recipe.value(Key::Trim), &Key::Trim.parameter().default_value());
        assert_eq!(recipe.number(NumberKey::Kill), 0.5);
        let keys: Vec<_> = notices.iter().map(|notice| notice.key.as_str()).collect();
        assert_eq!(keys, ["curl", "mouths", "trim", "curl", "depth", "style", "kill"]);
        assert_eq!(notices[0].message, "curl: 3 is not between 0 and 2: 2 is used");
    }

    #[test]
    fn notices_tell_the_value_that_is_drawn_wherever_they_stand() {
        for seed in ["Isolde", "ocean", "lullaby"] {
            let told = |link: &str| {
                let (recipe, notices) = read_leniently(link);
                let trim = Key::Trim.parameter().text_of(recipe.value(Key::Trim));
                assert_eq!(recipe, read(&format!("seed={seed}&curl=2")).unwrap());
                let messages: Vec<_> = notices.into_iter().map(|notice| notice.message).collect();
                let used = format!("trim: 'x' is not a number in plain digits: {trim} is used");
                assert!(messages.contains(&used), "{messages:?} does not tell of {trim}");
                messages
            };
            let first = told(&format!("trim=x&depth=1&curl=9&seed={seed}"));
            let last = told(&format!("seed={seed}&depth=1&trim=x&curl=9"));
            assert_eq!(
                [&first[1], &first[0], &first[2]],
                [&last[0], &last[1], &last[2]],
                "they are in the link's order"
            );
        }
    }

    #[test]
    fn each_wrong_name_is_told_by_itself_and_takes_no_other_away() {
        let told = |names: &str| {
            let (recipe, notices) = read_leniently(&format!("seed=kauri&names={names}&curl=9"));
            let messages: Vec<String> =
                notices.into_iter().map(|notice| notice.key + " | " + &notice.message).collect();
            assert_eq!(messages.last().map(String::as_str), Some("curl | curl: 9 is not between 0 and 2: 2 is used"));
            (recipe.own_names().to_string(), messages[..messages.len() - 1].join("\n"))
        };
        let mark = "expected a river's number, m and a river's number, a letter and a place's number (s sea, l lake, i island, b bay or gulf, c cape, n strait, h range), or t, then a full stop: it is left out";
        assert_eq!(told("zzz"), (String::new(), format!("names | names: 'zzz' is not a mark: {mark}")));
        let (kept, messages) = told(&format!("33.Silverrun_zzz_x4.y_33.Again_5.{}_t.Home", "a".repeat(41)));
        assert_eq!(kept, format!("33.Silverrun_5.{}_t.Home", "a".repeat(40)));
        let expected = [
            &format!("names | names: 'zzz' is not a mark: {mark}"),
            &format!("names | names: 'x4' is not a mark: {mark}"),
            "names | names: '33' is named more than once: the first is used",
            "names | names: the name of '5' has 41 characters, at most 40 are allowed: its beginning is used",
        ];
        assert_eq!(messages, expected.join("\n"));
        let all = |count: u32| (0..count).map(|i| format!("{i}.a")).collect::<Vec<_>>().join("_");
        let too_many = "names | names: there are 41 names, at most 40 are allowed: the first 40 are used";
        assert_eq!(told(&all(41)), (all(40), too_many.into()));
        let hidden = "names | names: the text holds a character that cannot be shown: it is left out";
        assert_eq!(told("1.a%E2%80%AEb"), ("1.ab".into(), hidden.into()));
        // However many are wrong, what is told stays short.
        assert!(told(&"z_".repeat(600)).1.len() < 10_000);
    }

    #[test]
    fn overlong_links_and_seeds_are_cut_at_a_character() {
        let link = format!("seed={}", "ā".repeat(15_000));
        assert!(matches!(read(&link), Err(RecipeError::TooLong { key: "link", .. })));
        let (recipe, notices) = read_leniently(&link);
        assert_eq!(recipe.seed(), "ā".repeat(64));
        assert_eq!(notices.len(), 2);
    }

    #[test]
    fn a_link_of_another_edition_is_drawn_with_a_warning() {
        for edition in ["0", "2", "7"] {
            let (recipe, notices) = read_leniently(&format!("seed=rimu&edition={edition}"));
            assert_eq!(recipe, read("seed=rimu").unwrap());
            let message = format!(
                "edition: {edition} is unknown here, this program draws edition 1: the picture may differ from the one shared"
            );
            assert_eq!(notices, [Notice { key: "edition".into(), message }]);
        }
    }
}
