//! No word becomes markup: whatever a seed or a name of one's own says, an SVG file is XML with the elements and attributes of a harmless one.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::sync::{LazyLock, OnceLock};

use crate::common::property::large;
use crate::common::tier::{first, one_in, tiers};
use form_urlencoded::Serializer;
use proptest::prelude::*;
use riverseed::annotate::labels;
use riverseed::annotate::place::{Label, Raster, place};
use riverseed::export::{ExportError, svg};
use riverseed::glam::Vec2;
use riverseed::recipe::{Choice, Key, Style, link};
use riverseed::{Map, Session};
use roxmltree::Document;

/// A small map with all that a file can say: names, trees and hills, lakes and former beds.
const MAP: &str = "land=island&sea=0.55&attractors=900&trim=20&great-rivers=4&meander-rounds=40&aspect=1&labels=few&label-size=1.5&woods=0.2&hills=0.2&neck=4&oxbows=1";

/// What would end an attribute, begin an element or be something else than itself, if it were not escaped.
const HOSTILE: &[&str] = &[
    r#"" tabindex="0" autofocus="" onfocus="x=1"#,
    r#"' onload='x=1' a='"#,
    r#""><script>x=1</script><g a=""#,
    r#"</title><script>x()</script>"#,
    "]]><!-- a -- b --><![CDATA[<b>]]>",
    "<!DOCTYPE x [<!ENTITY e 'x'>]>&e;",
    "&quot; onload=&quot;&#34;&#x3c;b&#x3e;",
    "<?xml-stylesheet href='x'?>\\\"",
];

/// All of these at once, as long as a seed may be, with marks that turn the direction of writing and what XML forbids.
const SEED: &str = "\" onload=\"x\" '><g a='b'>]]>&e;&#34;--><![CDATA[<?\u{202e}\u{2066}\u{fffe}\u{ffff}";
/// As long as a name may be, without what a name may not hold.
const NAME: &str = "\" onload=\"x\" '><g a='b'>]]>&e;-->";

/// With letters as outlines or as text.
type Form = fn(&Map) -> Result<String, ExportError>;

/// The kinds of file, and a cartouche for each. Without one a map has its legend or seal.
const FILES: [(&str, Form); 3] = [("plain", svg::svg), ("framed", svg::svg_with_text), ("none", svg::svg_with_text)];

/// The elements of a file and their attributes.
type Shape = BTreeSet<(String, Option<String>)>;

fn shape(document: &Document<'_>) -> Shape {
    let elements = document.descendants().filter(roxmltree::Node::is_element);
    let named = elements.flat_map(|element| {
        let name = element.tag_name().name().to_string();
        let attributes = element.attributes().map(|attribute| Some(attribute.name().to_string()));
        [None].into_iter().chain(attributes).map(|attribute| (name.clone(), attribute)).collect::<Vec<_>>()
    });
    named.collect()
}

/// The finished map of a seed, with names of one's own. Values that no recipe holds are corrected.
fn grown(map: &str, seed: &str, names: &str) -> Session {
    let text = Serializer::new(map.to_string()).append_pair("seed", seed).append_pair("names", names).finish();
    let mut session = Session::new(link::read_leniently(&text).0).unwrap();
    session.finish().unwrap();
    session
}

fn dress(session: &mut Session, style: Style, cartouche: &str) {
    let mut recipe = session.recipe().clone();
    recipe.set(Key::Style, style.word().name).unwrap();
    recipe.set(Key::Cartouche, cartouche).unwrap();
    session.change(recipe).unwrap();
    session.finish().unwrap();
}

/// What files of harmless seeds and names in a style are made of.
fn harmless(style: Style) -> &'static Shape {
    static GROWN: LazyLock<[Session; 3]> =
        LazyLock::new(|| ["kauri", "rimu", "kea"].map(|seed| grown(MAP, seed, "t.Home_0.Old River")));
    static SHAPES: [OnceLock<Shape>; Style::ALL.len()] = [const { OnceLock::new() }; Style::ALL.len()];
    SHAPES[style as usize].get_or_init(|| {
        let mut all = Shape::new();
        for (mut session, (cartouche, form)) in GROWN.clone().into_iter().zip(FILES) {
            dress(&mut session, style, cartouche);
            all.extend(shape(&Document::parse(&form(&session.map().unwrap()).unwrap()).unwrap()));
        }
        all
    })
}

/// A file has no element and no attribute that harmless ones lack, and each word stands in it as a text. Returns it.
fn check(map: &Map, style: Style, form: Form) -> String {
    let text = form(map).unwrap();
    let document = Document::parse(&text).unwrap_or_else(|error| panic!("{error}: {}", map.recipe()));
    let strange: Vec<_> = shape(&document).difference(harmless(style)).cloned().collect();
    assert_eq!(strange, [], "{}", map.recipe());
    check_words(map, &document);
    text
}

fn check_words(map: &Map, document: &Document<'_>) {
    let recipe = map.recipe();
    let first = |name: &str| document.descendants().find(|node| node.has_tag_name(name)).and_then(|node| node.text());
    assert_eq!(first("title").unwrap_or(""), readable(recipe.seed()));
    assert_eq!(link::read(first("metadata").unwrap()).as_ref(), Ok(recipe));
    let placed = placed(map);
    let expected: Vec<String> =
        placed.iter().filter(|label| label.kind.is_of_cartouche()).map(|label| readable(&label.text)).collect();
    let cartouche = document.descendants().find(|node| node.attribute("id") == Some("cartouche"));
    let said = cartouche.map(|node| node.attribute("aria-label").unwrap());
    assert_eq!(said, (!expected.is_empty()).then(|| expected.join(", ")).as_deref());
    let titles: BTreeSet<&str> =
        document.descendants().filter(|node| node.has_tag_name("title")).filter_map(|node| node.text()).collect();
    for label in placed.iter().filter(|label| !label.text.is_empty() && !label.letters.is_empty()) {
        assert!(titles.contains(readable(&label.text).as_str()), "{:?} in {}", label.text, recipe);
    }
}

fn placed(map: &Map) -> Vec<Label> {
    let input = labels::input(map, [Vec2::ZERO, map.domain().size], 1.0);
    input.map_or_else(Vec::new, |input| place(&input, &Raster::new(&input)))
}

/// A text with a sign in the place of what XML cannot hold.
fn readable(text: &str) -> String {
    let is_held = |c: char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().map(|c| if is_held(c) { c } else { '\u{fffd}' }).collect()
}

fn a_hostile_seed_and_name_stay_texts_in_every_style_and_form() {
    let mut session = grown(MAP, SEED, &format!("t.{NAME}_0.{NAME}"));
    assert_eq!(session.recipe().seed(), SEED, "nothing is corrected");
    for style in one_in(6, Style::ALL) {
        let mut named = 0;
        for (cartouche, form) in FILES {
            dress(&mut session, *style, cartouche);
            let text = check(&session.map().unwrap(), *style, form);
            named += usize::from(text.contains("aria-label=\"&quot; onload="));
        }
        assert!(named >= 2, "the map's name stands in its cartouche");
    }
}

tiers!(a_hostile_seed_and_name_stay_texts_in_every_style_and_form);

#[test]
fn each_hostile_word_stays_a_text() {
    for word in HOSTILE {
        let mut session = grown("land=island&attractors=150&labels=many", word, &format!("t.{word}_0.{word}"));
        assert_eq!(session.recipe().seed(), *word, "nothing is corrected");
        dress(&mut session, Style::Ink, "plain");
        for form in [svg::svg, svg::svg_with_text] {
            check(&session.map().unwrap(), Style::Ink, form);
        }
    }
}

/// Pieces of markup, and letters between.
const WORDS: &[&str] = &[
    "\"",
    "'",
    "<",
    ">",
    "&",
    "/",
    "=",
    "a",
    " ",
    "_",
    ".",
    "\n",
    "\t",
    "\0",
    "]]>",
    "<![CDATA[",
    "--",
    "<!--",
    "-->",
    "<?",
    "?>",
    "&quot;",
    "&#34;",
    "&lt;",
    " onload=",
    "<script>",
    "</title>",
    "</g>",
    "xmlns:a=",
    "\u{85}",
    "\u{202e}",
    "\u{2028}",
    "\u{fffe}",
    "\u{fffd}",
    "\u{1f30a}",
];

/// A text made of these, and of any other character.
fn hostile() -> impl Strategy<Value = String> {
    let word = prop_oneof![9 => proptest::sample::select(WORDS).prop_map(String::from), 1 => any::<char>().prop_map(String::from)];
    proptest::collection::vec(word, 0..16).prop_map(|words| words.concat())
}

proptest! {
    #![proptest_config(first(2, large(1000)))]

    fn no_seed_and_no_name_becomes_markup(
        seed in hostile(), name in hostile(), style in proptest::sample::select(Style::ALL), file in 0..FILES.len(),
    ) {
        let mut session = grown("land=island&attractors=150&labels=many", &seed, &format!("t.{name}_0.{name}"));
        let (cartouche, form) = FILES[file];
        dress(&mut session, style, cartouche);
        check(&session.map().unwrap(), style, form);
    }
}

tiers!(no_seed_and_no_name_becomes_markup);
