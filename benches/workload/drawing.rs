//! Drawing of segments in our way and in tiny-skia's ways.

use glam::Vec2;
use riverseed::domain::Domain;
use riverseed::paint::{Coverage, Pen, View, Widths};
use riverseed::recipe::CourseShape;
use riverseed::tree::{Hydrology, Tree};
use tiny_skia::{FillRule, LineCap, Mask, Paint, PathBuilder, Pixmap, Stroke, Transform};

use super::growth::{grown, settings};
use super::{ATTRACTORS_FOR_SEGMENTS, Repetition, SIDE};

/// The number of segments.
const SEGMENTS: usize = 100_000;

/// A line whose radius runs from one end to the other, in pixels.
struct Segment {
    a: Vec2,
    radius_a: f32,
    b: Vec2,
    radius_b: f32,
}

/// The first hundred thousand segments of a tree, with the widths of its rivers.
fn segments() -> Option<Vec<Segment>> {
    let settings = settings(&ATTRACTORS_FOR_SEGMENTS.to_string(), "3")?;
    let growth = grown(&settings)?;
    let segments = segments_of(growth.tree(), &settings.domain)?;
    (segments.len() == SEGMENTS).then_some(segments)
}

fn segments_of(tree: &Tree, domain: &Domain) -> Option<Vec<Segment>> {
    let view = View::new(domain, SIDE, SIDE).ok()?;
    let hydrology = Hydrology::of(tree);
    let pen = Pen::new(
        view,
        Widths::ByDischarge { full: 12.0, total_discharge: hydrology.discharge[0] },
        CourseShape::Smooth,
    );
    let radius = |node: usize| f32::from(pen.radius(hydrology.depth[node], hydrology.discharge[node])) / 16.0;
    let segment = |child: usize| {
        let node = tree.parent_of(child)?;
        let (a, b) = (view.pixel(tree.at[node]), view.pixel(tree.at[child]));
        Some(Segment { a, radius_a: radius(node), b, radius_b: radius(child) })
    };
    Some((0..tree.len()).filter_map(segment).take(SEGMENTS).collect())
}

/// Our way: capsules into a coverage mask.
pub fn capsules() -> Option<Repetition> {
    let segments = segments()?;
    let mut coverage = Coverage::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        coverage.clear();
        segments.iter().for_each(|s| coverage.capsule(s.a, s.radius_a, s.b, s.radius_b));
        sum(coverage.mask().data())
    }))
}

/// tiny-skia's first way: one ribbon a segment, filled into a mask.
pub fn mask_ribbons() -> Option<Repetition> {
    let segments = segments()?;
    let mut mask = Mask::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        mask.clear();
        fill_ribbons(&segments, |path| mask.fill_path(path, FillRule::Winding, true, Transform::identity()));
        sum(mask.data())
    }))
}

/// The second way: ribbons filled into a picture.
pub fn ribbons() -> Option<Repetition> {
    let segments = segments()?;
    let mut pixmap = Pixmap::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        pixmap.data_mut().fill(0);
        fill_ribbons(&segments, |path| {
            pixmap.fill_path(path, &Paint::default(), FillRule::Winding, Transform::identity(), None);
        });
        sum(pixmap.data())
    }))
}

/// The third way: one stroke a segment with round ends and one width, because tiny-skia has no strokes of varying
/// width.
pub fn strokes() -> Option<Repetition> {
    let segments = segments()?;
    let mut pixmap = Pixmap::new(SIDE, SIDE)?;
    Some(Box::new(move || {
        pixmap.data_mut().fill(0);
        let mut stroke = Stroke { line_cap: LineCap::Round, ..Stroke::default() };
        let mut builder = PathBuilder::new();
        for &Segment { a, radius_a, b, radius_b } in &segments {
            builder.move_to(a.x, a.y);
            builder.line_to(b.x, b.y);
            stroke.width = radius_a + radius_b;
            let Some(path) = builder.finish() else { return 0 };
            pixmap.stroke_path(&path, &Paint::default(), &stroke, Transform::identity(), None);
            builder = path.clear();
        }
        sum(pixmap.data())
    }))
}

/// Makes a path for each segment, in the memory of the previous one, and fills it.
fn fill_ribbons(segments: &[Segment], mut fill: impl FnMut(&tiny_skia::Path)) {
    let mut builder = PathBuilder::new();
    for &Segment { a, radius_a, b, radius_b } in segments {
        let aside = (b - a).perp().normalize_or_zero();
        let corners = [a + aside * radius_a, b + aside * radius_b, b - aside * radius_b, a - aside * radius_a];
        builder.move_to(corners[0].x, corners[0].y);
        corners[1..].iter().for_each(|corner| builder.line_to(corner.x, corner.y));
        builder.close();
        let Some(path) = builder.finish() else { return };
        fill(&path);
        builder = path.clear();
    }
}

/// Keeps the compiler from leaving out pixels, at a low cost compared with drawing.
fn sum(pixels: &[u8]) -> u32 {
    pixels.iter().map(|&pixel| u32::from(pixel)).sum()
}
