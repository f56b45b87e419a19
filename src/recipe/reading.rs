//! Lenient reading of links, and of what people hand over, for pages and widgets: on dark pages in a dark style unless the link names
//! one, in widgets within their limits.

use super::choice::GrowthMethod;
use super::key::{IntegerKey, Key};
use super::link::{self, Notice};
use super::parcels::most_attractors;
use super::style::Style;
use super::value::Value;
use super::{Recipe, given};

/// The place where a link's rivers are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// A widget shares its page with text that somebody reads, so the recipe is kept within a widget's limits.
    pub widget: bool,
    /// On a dark page, a link that names no style gets the one for dark pages.
    pub dark: bool,
}

/// A link as read for a page or a widget.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reading {
    /// The recipe to draw.
    pub recipe: Recipe,
    /// Values that were wrong or beyond a widget's limits, and their replacements.
    pub notices: Vec<Notice>,
    /// `true` if the link names a style.
    pub names_style: bool,
}

/// Reads link text as [`link::read_leniently`] does, then applies the options. Never fails.
pub fn read(text: &str, options: ReadOptions) -> Reading {
    let mut notices = Vec::new();
    let pairs = link::split(link::shorten(text, &mut notices));
    reading_of(&pairs, notices, options)
}

/// Reads what was [handed over](given) as a link, then applies the options; also takes link text with values that take precedence,
/// as the attributes of an element do. If its seed is an address, that is read instead of the text. Never fails.
pub fn read_given(text: &str, values: &str, options: ReadOptions) -> Reading {
    let mut notices = Vec::new();
    let mut values = link::split(link::shorten(values, &mut notices));
    let address = values.iter().position(|(name, value)| name == SEED && given::is_address(value));
    let address = address.map(|at| values.remove(at).1);
    let mut given = given::read(link::shorten(address.as_deref().unwrap_or(text), &mut notices));
    notices.extend(given.notice());
    given.pairs.retain(|(name, _)| values.iter().all(|(other, _)| other != name));
    given.pairs.append(&mut values);
    reading_of(&given.pairs, notices, options)
}

fn reading_of(pairs: &[(String, String)], mut notices: Vec<Notice>, options: ReadOptions) -> Reading {
    let (mut recipe, is_given) = link::apply_leniently(pairs, &mut notices);
    let names_style = is_given[Key::Style as usize];
    if options.dark && !names_style {
        recipe.put(Key::Style, Value::Choice(DARK_PAGES.word().name));
    }
    if options.widget {
        notices.extend(widget_limit(&recipe).keep(&mut recipe));
    }
    Reading { recipe, notices, names_style }
}

impl Reading {
    /// Writes the canonical link to share. It has the style that the link named, even the default one; if none was
    /// named, each page that shows it uses its own.
    pub fn shared_link(&self) -> String {
        link::write_if(&self.recipe, |parameter, is_default| match parameter.key {
            Key::Style => self.names_style,
            _ => !is_default,
        })
    }
}

/// The parameter whose value people may hand over as an address.
const SEED: &str = "seed";

/// The style on dark pages of links that name none.
const DARK_PAGES: Style = Style::Night;

/// The limit of a widget for one growth method.
#[derive(Clone, Copy, Debug, PartialEq)]
enum WidgetLimit {
    AtMost(IntegerKey, u32),
    AtLeast(IntegerKey, u32),
}

/// Returns a widget's limit for a recipe's growth method. Within it no step, not even those that turn the tree into rivers,
/// holds up a page noticeably, even where the page's policy forbids workers. With workers the limits are the same, so
/// that a tag gives the same river everywhere. Authors who want more can use a picture.
fn widget_limit(recipe: &Recipe) -> WidgetLimit {
    match recipe.get() {
        GrowthMethod::Colonize | GrowthMethod::Drainage => {
            WidgetLimit::AtMost(IntegerKey::Attractors, most_attractors(recipe))
        }
        GrowthMethod::Brownian => WidgetLimit::AtLeast(IntegerKey::Sensitivity, 12),
    }
}

impl WidgetLimit {
    /// Brings a recipe within the limit, and reports if it was beyond.
    fn keep(self, recipe: &mut Recipe) -> Option<Notice> {
        let (key, limit, is_beyond, exceeds): (_, _, fn(&u32, &u32) -> bool, _) = match self {
            Self::AtMost(key, limit) => (key, limit, u32::gt, "exceeds"),
            Self::AtLeast(key, limit) => (key, limit, u32::lt, "is below"),
        };
        let value = recipe.integer(key);
        if !is_beyond(&value, &limit) {
            return None;
        }
        let key = Key::from(key);
        recipe.put(key, Value::Integer(limit));
        let name = key.parameter().name;
        let message = format!("{name}: {value} {exceeds} the widget's limit: {limit} is used");
        Some(Notice { key: name.into(), message })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Choice;
    use crate::recipe::Kind;

    const PAGE: ReadOptions = ReadOptions { widget: false, dark: false };
    const DARK: ReadOptions = ReadOptions { widget: false, dark: true };
    const WIDGET: ReadOptions = ReadOptions { widget: true, dark: false };

    fn bound(limit: WidgetLimit) -> (Key, u32, u32) {
        match limit {
            WidgetLimit::AtMost(key, limit) => (key.into(), limit, limit + 1),
            WidgetLimit::AtLeast(key, limit) => (key.into(), limit, limit - 1),
        }
    }

    fn limit_of(method: GrowthMethod) -> WidgetLimit {
        widget_limit(&link::read(&format!("growth={}", method.word().name)).unwrap())
    }

    #[test]
    fn with_little_sea_the_limit_is_lower_and_with_much_as_usual() {
        let limit = |over: &str| bound(widget_limit(&link::read(&format!("country=usual&{over}")).unwrap())).1;
        let all = ["land=island", "land=island&sea=0.8", "land=rectangle&sea=0.1", "land=basin&sea=0.3"].map(limit);
        assert_eq!(all, [24_000; 4]);
        assert_eq!([limit("land=island&sea=0.3"), limit("land=island&sea=0.01")], [9_600, 6_788]);
    }

    #[test]
    fn the_link_of_a_file_means_what_the_file_shows_on_dark_pages_too() {
        for text in ["seed=kauri", "seed=kauri&style=ink", "seed=kauri&style=atlas"] {
            let recipe = link::read(text).unwrap();
            assert_eq!(read(&link::write_for_file(&recipe), DARK).recipe, recipe, "{text}");
        }
        assert_ne!(read(&link::write(&Recipe::default()), DARK).recipe, Recipe::default());
    }

    #[test]
    fn each_way_of_growing_has_a_limit_within_the_range_that_its_default_keeps() {
        for &method in GrowthMethod::ALL {
            let (key, limit, beyond) = bound(limit_of(method));
            let Kind::Integer { min, max, .. } = key.parameter().kind else { panic!("{key:?} is no whole number") };
            assert!((min..=max).contains(&limit) && (min..=max).contains(&beyond));
            let text = format!("growth={}", method.word().name);
            let whole = read(&text, WIDGET);
            assert_eq!((whole.recipe, whole.notices), (link::read(&text).unwrap(), vec![]));
        }
    }

    #[test]
    fn what_is_beyond_a_limit_is_brought_to_it_in_widgets_and_told() {
        for &method in GrowthMethod::ALL {
            let (key, limit, beyond) = bound(limit_of(method));
            let link = |value| format!("growth={}&{}={value}", method.word().name, key.parameter().name);
            let kept = read(&link(beyond), WIDGET);
            assert_eq!(kept.recipe, link::read(&link(limit)).unwrap());
            let [Notice { key: name, message }] = &kept.notices[..] else { panic!("{:?}", kept.notices) };
            assert_eq!(name, key.parameter().name);
            assert!(message.contains(&beyond.to_string()) && message.contains(&limit.to_string()), "{message}");
            assert_eq!(read(&link(limit), WIDGET).notices, []);
            let on_a_page = read(&link(beyond), PAGE);
            assert_eq!((on_a_page.recipe, on_a_page.notices), (link::read(&link(beyond)).unwrap(), vec![]));
        }
    }

    #[test]
    fn where_a_parameter_does_nothing_it_has_no_limit() {
        for link in ["growth=brownian&attractors=90000", "growth=colonize&sensitivity=8"] {
            let Reading { recipe, notices, .. } = read(link, WIDGET);
            assert_eq!((recipe, notices), (link::read(link).unwrap(), vec![]));
        }
    }

    #[test]
    fn a_dark_page_has_its_own_style_unless_the_link_names_one() {
        let style = |text, options| read(text, options).recipe.get::<Style>();
        assert_eq!(style("seed=a", DARK), Style::Night);
        assert_eq!(style("seed=a&preset=curl", DARK), Style::Night);
        assert_eq!(style("seed=a", PAGE), Style::Atlas);
        assert_eq!(style("style=ink", DARK), Style::Ink);
        assert_eq!(style("style=atlas", DARK), Style::Atlas);
        // The style is named, though wrongly: the notice says which style is used instead, and must be true.
        assert_eq!(style("style=neon", DARK), Style::Atlas);
    }

    #[test]
    fn shared_link_names_a_style_where_it_was_named_and_opens_as_the_same_on_pages_alike() {
        let shared = |text, options| read(text, options).shared_link();
        assert_eq!(shared("seed=a", DARK), "seed=a&edition=1");
        assert_eq!(shared("seed=a&style=ink", DARK), "seed=a&edition=1&style=ink");
        assert_eq!(shared("seed=a", PAGE), "seed=a&edition=1");
        assert_eq!(shared("style=atlas&seed=a", PAGE), "seed=a&edition=1&style=atlas");
        // The default of a light page, too: a dark one would draw its own.
        let chosen = shared("seed=a&style=ink", PAGE);
        assert_eq!(chosen, "seed=a&edition=1&style=ink");
        assert_eq!(read(&chosen, DARK).recipe.get::<Style>(), Style::Ink);
        for text in ["", "style=ink", "style=dark&curl=1", "style=atlas", "style=neon"] {
            for options in [PAGE, DARK, WIDGET] {
                let first = read(text, options);
                assert_eq!(read(&first.shared_link(), options).recipe, first.recipe, "{text} {options:?}");
            }
        }
    }
}
