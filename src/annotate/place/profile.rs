//! The long profile of a river: its height along its course, from the source at the left to the sea at the right.

use glam::Vec2;

use super::input::LongProfile;
use super::lengths::SHORTEST;
use super::letters::{Kind, Text};
use super::panel::{Panel, step};
use crate::scale::figures;

/// The width of the scale of heights, and the height of that of kilometres, in ems.
const HEIGHTS: f32 = 3.2;
const KILOMETRES: f32 = 1.35;
/// Half the widths of the profile, of axes and of the lines that fill it, and the distance between these, in ems.
const LINE: f32 = 0.055;
const AXIS: f32 = 0.022;
const FILL: f32 = 0.011;
const APART: f32 = 0.3;
/// The length of the marks of tributaries, in ems, and their greatest number.
const MARK: f32 = 0.6;
const MARKS: usize = 24;
/// The greatest number of names of tributaries, their size, and the distance between them, in ems.
const NAMES: usize = 5;
const NAME: f32 = 0.9;
const NAMES_APART: f32 = 1.5;
/// The least width and height of the figure, in ems.
const LEAST: Vec2 = Vec2::new(9.0, 3.0);

/// Draws a profile. Returns `false` if there is no room for it.
pub fn draw(panel: &mut Panel, profile: &LongProfile) -> bool {
    let (em, [least, most]) = (panel.em, panel.within);
    let Some(&highest) = profile.heights.last().filter(|height| **height > 0.0) else { return false };
    let heading = panel.heading.middle.y + panel.heading.down.y;
    let corner = Vec2::new(least.x + HEIGHTS * em, most.y - KILOMETRES * em);
    let end = Vec2::new(most.x - 0.6 * em, least.y + 0.4 * em);
    let size = Vec2::new(end.x - corner.x, corner.y - end.y);
    if size.cmplt(LEAST * em).any() {
        return false;
    }
    // Upstream is to the left.
    let last = (profile.heights.len() - 1).max(1) as f32;
    let height = |share: f32| {
        let at = share * last;
        let i = (at as usize).min(profile.heights.len().saturating_sub(2));
        let next = profile.heights.get(i + 1).copied().unwrap_or(highest);
        profile.heights[i] + (next - profile.heights[i]) * (at - i as f32)
    };
    // No part of it reaches into the heading.
    let left_of_heading = panel.heading.middle.x - panel.heading.along.x;
    let under = height(((end.x - left_of_heading) / size.x).clamp(0.0, 1.0)).max(1.0);
    let per_metre = (size.y / highest).min((corner.y - heading - 0.8 * em) / under);
    if per_metre <= 0.0 {
        return false;
    }
    let x = |share: f32| end.x - share * size.x;
    let place = |share: f32| Vec2::new(x(share), corner.y - height(share) * per_metre);
    let points: Vec<Vec2> = (0..profile.heights.len()).map(|i| place(i as f32 / last)).collect();
    points.windows(2).for_each(|ends| panel.line(ends[0], ends[1], LINE * em));
    let fills = (size.x / (APART * em)) as u32;
    for i in 1..=fills {
        let at = place(i as f32 / (fills + 1) as f32);
        panel.line(at, Vec2::new(at.x, corner.y), FILL * em);
    }
    draw_tributaries(panel, profile, place);
    draw_axes(panel, corner, end.x, [highest, profile.kilometres], per_metre);
    true
}

/// Marks where tributaries join, with the names of the greatest as far as there is room.
fn draw_tributaries(panel: &mut Panel, profile: &LongProfile, place: impl Fn(f32) -> Vec2) {
    let em = panel.em;
    let mut named: Vec<f32> = Vec::new();
    for tributary in profile.tributaries.iter().take(MARKS) {
        let at = place(tributary.share);
        let top = at - Vec2::new(0.0, MARK * em);
        panel.line(at, top, AXIS * em);
        let text = Text::new(&tributary.name, Kind::Plate);
        let size = NAME * em;
        let is_free = named.iter().all(|other| (other - at.x).abs() >= NAMES_APART * em);
        let end = top.y - (text.length + 1.0) * size;
        let is_within = end >= panel.ceiling(at.x + size) && at.x - size > panel.within[0].x + (HEIGHTS + 0.4) * em;
        if !text.letters.is_empty() && is_free && is_within && named.len() < NAMES {
            named.push(at.x);
            panel.upward(
                Some(tributary.river),
                &tributary.name,
                &text,
                top + Vec2::new(0.25 * size, -0.35 * size),
                size,
            );
        }
    }
}

/// Draws the sea with kilometres from the source, and heights in metres.
fn draw_axes(panel: &mut Panel, corner: Vec2, right: f32, [highest, kilometres]: [f32; 2], per_metre: f32) {
    let em = panel.em;
    let top = corner.y - highest * per_metre;
    panel.line(corner, Vec2::new(right, corner.y), 1.5 * AXIS * em);
    panel.line(corner, Vec2::new(corner.x, top), AXIS * em);
    // The last is the height of the source, and others keep off that.
    let metres_apart = step(highest, ((corner.y - top) / (1.6 * em)).clamp(1.0, 5.0));
    let ticks = (0..=(highest / metres_apart) as u32).map(|i| metres_apart * i as f32);
    let ticks = ticks.filter(|height| (highest - height) * per_metre > 1.2 * em);
    let source = (highest + 0.5) as u32;
    for (height, says) in
        ticks.map(|height| (height, (height as u32).to_string())).chain([(highest, format!("{source} m"))])
    {
        let y = corner.y - height * per_metre;
        panel.line(Vec2::new(corner.x, y), Vec2::new(corner.x - 0.3 * em, y), AXIS * em);
        panel.number(&says, Vec2::new(corner.x - 0.5 * em, y + 0.25 * em), 1.0, 0.9);
    }
    let per_kilometre = (right - corner.x) / kilometres.max(SHORTEST);
    let apart = step(kilometres, 5.0);
    let ticks = (1..=(kilometres / apart) as u32).map(|i| apart * i as f32);
    let ticks = ticks.filter(|along| (kilometres - along) * per_kilometre > 3.4 * em);
    for (along, says) in ticks
        .map(|along| (along, (along as u32).to_string()))
        .chain([(kilometres, format!("{} km", figures(kilometres)))])
    {
        let at = Vec2::new(corner.x + along * per_kilometre, corner.y);
        panel.line(at, at + Vec2::new(0.0, 0.3 * em), AXIS * em);
        let share = if along < kilometres { 0.5 } else { 0.8 };
        panel.number(&says, at + Vec2::new(0.0, 1.25 * em), share, 0.9);
    }
}
