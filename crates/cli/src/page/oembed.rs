//! The oEmbed response of a map's page, as a static file that the page names. Programs that preview links by
//! discovery show the map in a frame, or its card. See the oEmbed specification, section 4.

use serde_json::{Value, json};

use super::address::Address;
use super::card;
use super::file_names::{CARD, EMBED};
use super::markup::escaped;
use super::templates::Content;

/// The width of the frame where the page around it sets none, in CSS pixels.
const WIDTH: u32 = 720;

/// Makes the response. The frame's HTML is escaped here, once.
pub fn response(content: &Content, address: &Address) -> Value {
    let size = content.ratio;
    let height = (WIDTH as f32 * size.y / size.x).round();
    let frame = format!(
        "<iframe src=\"{}\" title=\"{}\" width=\"{WIDTH}\" height=\"{height}\" loading=\"lazy\" \
         sandbox=\"allow-scripts allow-same-origin\" \
         style=\"width:100%;height:auto;aspect-ratio:{};border:0\"></iframe>",
        escaped(&address.of(EMBED)),
        escaped(&content.title),
        escaped(&content.aspect),
    );
    json!({
        "version": "1.0",
        "type": "rich",
        "title": content.title,
        "provider_name": "Riverseed",
        "html": frame,
        "width": WIDTH,
        "height": height as u32,
        "thumbnail_url": address.of(CARD),
        "thumbnail_width": card::SIZE.0,
        "thumbnail_height": card::SIZE.1,
    })
}
