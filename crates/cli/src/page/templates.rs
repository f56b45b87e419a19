//! The templates of a map's page and of its embed page, which the gallery of the built site uses too (www/build/gallery).
//! Handlebars escapes what is put into them.

use std::io;

use handlebars::Handlebars;
use riverseed::glam::Vec2;
use serde_json::{Value, json};

use super::super::Failure;
use super::address::Address;
use super::attributes::attribute;
use super::card;
use super::element::Element;
use super::file_names::{CARD, JPEG, OEMBED, PNG, SHAPE, SHEET};
use super::markup::{escaped, referenced};

/// All that a page says.
pub struct Content {
    pub name: String,
    pub title: String,
    pub description: String,
    /// The words for readers who do not see the picture.
    pub alternative: String,
    /// Labels and values.
    pub settings: Vec<Value>,
    /// The map's width over its height, as a link writes it.
    pub aspect: String,
    /// The map's width and height, in units.
    pub ratio: Vec2,
    pub picture: Shot,
    /// The recipe as attributes of the element.
    pub attributes: Vec<Value>,
    /// The recipe as a link.
    pub link: String,
    /// The address of the folder, if it is known.
    pub address: Option<Address>,
    /// The address of a page of Riverseed, where the map can be changed.
    pub maker: Option<Address>,
    pub element: Element,
}

/// The size of a picture, in pixels.
pub struct Shot {
    pub width: u32,
    pub height: u32,
}

/// The icon of the page, as on the gallery's pages.
const ICON: &str = include_str!("templates/icon.txt");
/// The address that stands for the page's where that is not known.
const SOME_SITE: &str = "https://example.org/map/";

/// Writes the page.
pub fn page(content: &Content) -> Result<String, Failure> {
    filled("page", &data(content))
}

/// Writes the page for frames: the map and nothing else.
pub fn embed(content: &Content) -> Result<String, Failure> {
    filled("embed", &data(content))
}

fn filled(name: &str, data: &Value) -> Result<String, Failure> {
    let mut templates = Handlebars::new();
    templates.set_strict_mode(false);
    templates.register_escape_fn(|text| referenced(&handlebars::html_escape(text)));
    for (name, text) in [
        ("head", include_str!("templates/head.hbs")),
        ("page", include_str!("templates/page.hbs")),
        ("embed", include_str!("templates/embed.hbs")),
    ] {
        templates.register_template_string(name, text).map_err(io::Error::other)?;
    }
    Ok(templates.render(name, data).map_err(io::Error::other)?)
}

/// Collects the data of a template. The members are listed in the head of www/build/gallery/templates.ts.
fn data(content: &Content) -> Value {
    let Content { address, maker, link, element, .. } = content;
    let whole = |file: &str| address.as_ref().map(|address| address.of(file));
    let made_by = maker.as_ref().map(|maker| attribute("maker", &maker.of("")));
    let attributes: Vec<Value> = content.attributes.iter().cloned().chain(made_by).collect();
    let here = whole("").unwrap_or_else(|| SOME_SITE.into());
    json!({
        "policy": policy(element),
        "title": content.title,
        "name": content.name,
        "description": content.description,
        "icon": ICON.trim_end(),
        "sheets": [SHEET, SHAPE],
        "address": whole(""),
        "card": whole(CARD).map(|file| json!({
            "address": file, "width": card::SIZE.0, "height": card::SIZE.1, "alt": content.alternative,
        })),
        "oembed": whole(OEMBED),
        "picture": {
            "file": JPEG, "width": content.picture.width, "height": content.picture.height, "alt": content.alternative,
        },
        "maker": maker.as_ref().map(|maker| maker.with_query(link)),
        "element": element.script().map(|script| json!({ "script": script, "attributes": attributes })),
        "acts": acts(content),
        "settings": content.settings,
        "link": link,
        "snippet": {
            "lead": "Paste this into a page of yours:",
            "code": snippet(content, &attributes, &here),
            "placeholder": address.is_none().then_some(SOME_SITE),
        },
    })
}

/// Makes the buttons under the map.
fn acts(Content { maker, link, .. }: &Content) -> Vec<Value> {
    let open = maker.as_ref().map(|maker| json!({ "address": maker.with_query(link), "label": "Change this map" }));
    let save = json!({ "address": PNG, "download": PNG, "label": "Save the picture" });
    open.into_iter().chain([save]).collect()
}

/// Writes the element, or the picture if there is none, as it is pasted into other pages.
fn snippet(content: &Content, attributes: &[Value], here: &str) -> String {
    let Content { element, alternative, aspect, picture: Shot { width, height }, .. } = content;
    let image = |style: &str| {
        format!(
            "<a href=\"{}\"><img src=\"{}{JPEG}\"\n  alt=\"{}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\" style=\"{style}\"></a>",
            escaped(here),
            escaped(here),
            escaped(alternative)
        )
    };
    let Some(script) = element.script() else { return image("width:100%;height:auto") };
    let script = if script.contains("://") { script } else { format!("{here}{script}") };
    let text = |value: &Value, name: &str| escaped(value[name].as_str().unwrap_or_default());
    let attributes = attributes.iter().map(|one| format!(" {}=\"{}\"", text(one, "name"), text(one, "value")));
    format!(
        "<script type=\"module\" src=\"{}\"></script>\n<river-seed{} style=\"display:block;aspect-ratio:{};min-height:0;overflow:hidden\">\n{}\n</river-seed>",
        escaped(&script),
        attributes.collect::<String>(),
        escaped(aspect),
        image("display:block;width:100%;height:auto")
    )
}

/// Writes the content security policy of a page with this element. `'wasm-unsafe-eval'` allows WebAssembly and no more.
fn policy(element: &Element) -> String {
    let origin = element.origin();
    // In a frame without an origin, and from another host, the worker's script is a blob.
    let scripts = match element {
        Element::None => String::new(),
        Element::Files(_) | Element::Elsewhere(_) => {
            format!("; script-src {origin} 'wasm-unsafe-eval'; connect-src {origin}; worker-src 'self' blob:")
        }
    };
    format!(
        "default-src 'none'{scripts}; style-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'"
    )
}
