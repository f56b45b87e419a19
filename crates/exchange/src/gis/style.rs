//! Styles for QGIS, in its own form QML: the colours of the style `atlas`.
//!
//! A style is never made from a map's texts. It names columns, and QGIS reads their values as data.

use std::io::{Result, Write};

use riverseed::paint::atlas;
use riverseed::scale::{MapScale, USUAL_METRES};

use crate::xml::escaped;

const NONE: &str = "0,0,0,0";

/// The outlines of basins. The style of pictures has none.
const BASIN: &str = "120,140,110,150";

/// The colours of depths in metres. The style of pictures has them by the way to the coast.
const DEPTHS: [(f32, [u8; 3]); 3] = [(-600.0, [0x5f, 0x93, 0xae]), (-150.0, atlas::WATER), (0.0, atlas::SHALLOWS)];

/// The least height of land in metres, so that the sea's surface has a colour of its own.
const ASHORE: f32 = 0.01;

/// Lists the colours of depths and heights in metres, from below, as the picture has them.
fn tints(scale: &MapScale) -> impl Iterator<Item = (f32, [u8; 3])> {
    let told = scale.metres_up / USUAL_METRES;
    let land = move |(metres, colour): &(f32, _)| ((metres * told).max(ASHORE), *colour);
    DEPTHS.into_iter().map(move |(metres, colour)| (metres * told, colour)).chain(atlas::TINTS.iter().map(land))
}

/// Writes a colour as QGIS has it in the options of a symbol.
fn opaque([red, green, blue]: [u8; 3]) -> String {
    format!("{red},{green},{blue},255")
}

/// Makes the style of a layer of a GeoPackage.
pub fn of_layer(name: &str) -> String {
    match name {
        "land" => vector(&fill(&opaque(atlas::LAND), &opaque(atlas::COAST), "0.3"), ""),
        "lakes" => vector(&fill(&opaque(atlas::WATER), &opaque(atlas::COAST), "0.3"), ""),
        "deltas" => vector(&fill(NONE, &opaque(atlas::COAST), "0.1"), ""),
        "distributaries" => vector(&line(&opaque(atlas::RIVER), Some(r#"0.12 + 1.1 * sqrt("share")"#)), ""),
        "basins" => vector(&fill(NONE, BASIN, "0.2"), ""),
        "oxbow_lakes" => vector(&fill(&opaque(atlas::WATER), &opaque(atlas::COAST), "0.1"), ""),
        // Width goes with the root of discharge, as in nature.
        "rivers" => vector(
            &line(&opaque(atlas::RIVER), Some(r#"0.12 + 1.1 * sqrt("discharge" / maximum("discharge"))"#)),
            &labels_along_lines("name", r#""order" >= maximum("order") - 1"#, "9"),
        ),
        // They lie on the rivers.
        "segments" => vector(&line(NONE, None), ""),
        "reaches" => vector(&line(NONE, None), &labels_along_lines("reach_name", "true", "8")),
        "ridges" => vector(&line(&opaque(atlas::RIDGE), None), ""),
        _ => vector(&point(), &labels_over_points("name")),
    }
}

/// Writes the style of heights. It holds the link, which says to which map it belongs.
///
/// # Errors
/// Fails with the writer's errors.
pub fn write_heights(mut out: impl Write, link: &str, scale: &MapScale) -> Result<()> {
    let items: Vec<String> = tints(scale)
        .map(|(metres, [red, green, blue])| {
            format!(
                "<item value=\"{metres}\" color=\"#{red:02x}{green:02x}{blue:02x}\" label=\"{metres:.0} m\" alpha=\"255\"/>\n"
            )
        })
        .collect();
    let (least, most) =
        tints(scale).fold((f32::MAX, f32::MIN), |(least, most), (metres, _)| (least.min(metres), most.max(metres)));
    writeln!(
        out,
        "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n\
         <qgis version=\"3.22\" styleCategories=\"Symbology|CustomProperties\">\n\
         <customproperties><Option type=\"Map\"><Option name=\"riverseed\" type=\"QString\" value=\"{}\"/></Option></customproperties>\n\
         <pipe><rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"1\" alphaBand=\"-1\" \
         classificationMin=\"{least}\" classificationMax=\"{most}\">\n\
         <rastershader><colorrampshader colorRampType=\"INTERPOLATED\" classificationMode=\"1\" clip=\"0\" \
         minimumValue=\"{least}\" maximumValue=\"{most}\">\n{}</colorrampshader></rastershader>\n\
         </rasterrenderer></pipe>\n\
         <blendMode>0</blendMode>\n</qgis>",
        escaped(link),
        items.concat(),
    )
}

/// Writes a style of one symbol, and of labels if there are any.
fn vector(symbol: &str, labeling: &str) -> String {
    format!(
        "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n\
         <qgis version=\"3.22\" styleCategories=\"Symbology|Labeling\" labelsEnabled=\"{}\">\n\
         <renderer-v2 type=\"singleSymbol\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\">\n\
         <symbols>{symbol}</symbols>\n</renderer-v2>\n{labeling}<blendMode>0</blendMode>\n</qgis>\n",
        u8::from(!labeling.is_empty()),
    )
}

fn symbol(kind: &str, layer: &str, options: &[(&str, &str)], by_data: Option<(&str, &str)>) -> String {
    let options: Vec<String> = options
        .iter()
        .map(|(name, value)| format!("<Option name=\"{name}\" type=\"QString\" value=\"{value}\"/>"))
        .collect();
    let by_data = by_data.map(|(property, expression)| by_expression(property, expression)).unwrap_or_default();
    format!(
        "<symbol type=\"{kind}\" name=\"0\" alpha=\"1\" clip_to_extent=\"1\" force_rhr=\"0\">\
         <layer class=\"{layer}\" enabled=\"1\" locked=\"0\" pass=\"0\"><Option type=\"Map\">{}</Option>{by_data}</layer></symbol>",
        options.concat()
    )
}

/// Writes a property of a symbol that an expression gives.
fn by_expression(property: &str, expression: &str) -> String {
    format!(
        "<data_defined_properties><Option type=\"Map\"><Option name=\"name\" type=\"QString\" value=\"\"/>\
         <Option name=\"properties\" type=\"Map\"><Option name=\"{property}\" type=\"Map\">\
         <Option name=\"active\" type=\"bool\" value=\"true\"/>\
         <Option name=\"expression\" type=\"QString\" value=\"{}\"/>\
         <Option name=\"type\" type=\"int\" value=\"3\"/></Option></Option>\
         <Option name=\"type\" type=\"QString\" value=\"collection\"/></Option></data_defined_properties>",
        escaped(expression)
    )
}

fn fill(colour: &str, outline: &str, width: &str) -> String {
    let options = [
        ("color", colour),
        ("style", if colour == NONE { "no" } else { "solid" }),
        ("outline_color", outline),
        ("outline_style", "solid"),
        ("outline_width", width),
        ("outline_width_unit", "MM"),
        ("joinstyle", "round"),
    ];
    symbol("fill", "SimpleFill", &options, None)
}

fn line(colour: &str, width: Option<&str>) -> String {
    let options = [
        ("line_color", colour),
        ("line_style", if colour == NONE { "no" } else { "solid" }),
        ("line_width", "0.3"),
        ("line_width_unit", "MM"),
        ("capstyle", "round"),
        ("joinstyle", "round"),
    ];
    symbol("line", "SimpleLine", &options, width.map(|expression| ("outlineWidth", expression)))
}

/// Writes a dot, for capes: all else is larger than a place, and its name alone marks it.
fn point() -> String {
    let ink = opaque(atlas::LETTERS);
    let options = [("name", "circle"), ("color", &ink), ("outline_style", "no"), ("size", "0.8"), ("size_unit", "MM")];
    symbol("marker", "SimpleMarker", &options, Some(("size", r#"if("kind" = 'cape', 0.8, 0)"#)))
}

/// Labels along lines, for features that a condition holds for.
fn labels_along_lines(field: &str, condition: &str, size: &str) -> String {
    let expression = format!("if({condition}, \"{field}\", '')");
    labels(
        &expression,
        size,
        "placement=\"3\" placementFlags=\"10\" dist=\"0.6\"",
        "maxCurvedCharAngleIn=\"25\" maxCurvedCharAngleOut=\"-25\"",
    )
}

/// Labels over points.
fn labels_over_points(field: &str) -> String {
    labels(&format!("\"{field}\""), "10", "placement=\"1\" quadOffset=\"4\"", "")
}

fn labels(expression: &str, size: &str, placement: &str, more: &str) -> String {
    let (ink, halo) = (opaque(atlas::LETTERS), opaque(atlas::HALO));
    format!(
        "<labeling type=\"simple\"><settings calloutType=\"simple\">\
         <text-style fieldName=\"{}\" isExpression=\"1\" fontFamily=\"serif\" fontItalic=\"1\" fontSize=\"{size}\" \
         fontSizeUnit=\"Point\" textColor=\"{ink}\" textOpacity=\"1\">\
         <text-buffer bufferDraw=\"1\" bufferSize=\"0.6\" bufferSizeUnits=\"MM\" bufferColor=\"{halo}\" bufferOpacity=\"0.8\"/>\
         </text-style><placement {placement} distUnits=\"MM\" priority=\"5\" {more}/>\
         <rendering drawLabels=\"1\" scaleVisibility=\"0\" obstacle=\"1\"/></settings></labeling>\n",
        escaped(expression)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gis::layers::LAYERS;

    fn scale(link: &str) -> MapScale {
        MapScale::of(&link.parse().unwrap())
    }

    #[test]
    fn every_style_is_a_document_of_qgis() {
        let mut heights = Vec::new();
        write_heights(&mut heights, "seed=a%3Cb&edition=1", &scale("span=200")).unwrap();
        let heights = String::from_utf8(heights).unwrap();
        let layers: Vec<String> = LAYERS.iter().map(|layer| of_layer(layer.name)).collect();
        for style in layers.iter().chain([&heights]) {
            let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
            let document = roxmltree::Document::parse_with_options(style, options).unwrap();
            assert_eq!(document.root_element().tag_name().name(), "qgis");
        }
        assert!(heights.contains("value=\"seed=a%3Cb&amp;edition=1\""));
    }

    #[test]
    fn tints_rise_with_the_span() {
        let heights: Vec<f32> = tints(&scale("span=200")).map(|(metres, _)| metres).collect();
        assert!(heights.windows(2).all(|pair| pair[0] < pair[1]), "{heights:?}");
        let wider: Vec<f32> = tints(&scale("span=5000")).map(|(metres, _)| metres).collect();
        let rises =
            |(wider, height): (&f32, &f32)| *height == ASHORE || (wider - height * 3.624).abs() <= 1e-5 * wider.abs();
        assert!(wider.iter().zip(&heights).all(rises), "{wider:?}");
    }
}
