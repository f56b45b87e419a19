//! Comparative lengths of the principal rivers, the plate of the atlases of the 1850s: rivers straightened and side by side, their ends at a
//! common line, each with its name and its length.

use glam::Vec2;

use super::input::StraightRiver;
use super::letters::{Kind, Text};
use super::panel::{Panel, step};
use crate::scale::figures;

/// The least length by which the scale of a plate is chosen, in kilometres.
pub const SHORTEST: f32 = 0.01;
/// The greatest and the least number of rivers.
const MOST: usize = 14;
const LEAST: usize = 3;
/// The least and the greatest distance between rivers, and the width of the scale at their left, in ems.
const PITCH: [f32; 2] = [1.95, 2.6];
const SCALE: f32 = 2.6;
/// The distance of a name from its river's middle line, in ems.
const TO_NAME: f32 = 1.16;
/// Half the widths of the base line and of ticks, in ems.
const BASE: f32 = 0.035;
const TICK: f32 = 0.02;
/// The greatest distance of a drawn river from its line, in ems, and the winding that is drawn half as far from it, in units.
const ASIDE: f32 = 0.3;
const WINDING: f32 = 6.0;
/// The length of the pieces of a river, in ems.
const PIECE: f32 = 0.3;
/// Half the width of a river: the least, and that of the widest, in ems.
const HALF: [f32; 2] = [0.03, 0.19];
/// The number of steps of widths, each of which a file writes as one line.
const STEPS: f32 = 12.0;

/// Draws the longest rivers that there is room for. Returns `false` if that are too few.
pub fn draw(panel: &mut Panel, rivers: &[StraightRiver]) -> bool {
    let (em, [least, most]) = (panel.em, panel.within);
    let left = least.x + SCALE * em;
    let room = most.x - left;
    let count = rivers.len().min(MOST).min((room / (PITCH[0] * em)) as usize);
    if count < LEAST.min(rivers.len().max(1)) {
        return false;
    }
    let rivers = &rivers[..count];
    let pitch = (room / count as f32).min(PITCH[1] * em);
    let foot = most.y - 0.2 * em;
    let x = |i: usize| left + (i as f32 + 0.16) * pitch;
    let names: Vec<(String, Text)> = rivers.iter().map(named).collect();
    // As long as the heading leaves room for.
    let room_over = |i: usize| foot - panel.ceiling(x(i) + TO_NAME * em + 0.6 * em) - 0.3 * em;
    let per_kilometre = rivers
        .iter()
        .enumerate()
        .map(|(i, river)| room_over(i) / river.kilometres.max(SHORTEST))
        .fold(f32::MAX, f32::min);
    if names.iter().enumerate().any(|(i, (_, name))| name.length * em > room_over(i) - 0.5 * em) {
        return false;
    }
    let halves = rivers.iter().flat_map(|river| river.points.iter().map(|point| point[1]));
    let widest = halves.fold(f32::MIN_POSITIVE, f32::max);
    draw_scale(panel, foot, rivers.first().map_or(0.0, |river| river.kilometres), per_kilometre);
    for (i, (river, (says, text))) in rivers.iter().zip(&names).enumerate() {
        let from = Vec2::new(x(i), foot);
        draw_river(panel, river, from, per_kilometre * river.kilometres, widest);
        panel.upward(Some(river.river), says, text, from + Vec2::new(TO_NAME, -0.5) * em, em);
    }
    true
}

/// Returns the text beside a river.
fn named(river: &StraightRiver) -> (String, Text) {
    let says = format!("{}, {} km", river.name, figures(river.kilometres));
    let text = Text::new(&says, Kind::Plate);
    (says, text)
}

/// Draws the line that rivers end at, and kilometres at its left.
fn draw_scale(panel: &mut Panel, foot: f32, longest: f32, per_kilometre: f32) {
    let (em, [least, most]) = (panel.em, panel.within);
    let left = least.x + (SCALE - 0.6) * em;
    panel.line(Vec2::new(left, foot), Vec2::new(most.x, foot), BASE * em);
    let step = step(longest, 6.0);
    let count = (longest / step) as u32;
    panel.line(Vec2::new(left, foot), Vec2::new(left, foot - longest * per_kilometre), TICK * em);
    for tick in 0..=count {
        let kilometres = step * tick as f32;
        let y = foot - kilometres * per_kilometre;
        panel.line(Vec2::new(left, y), Vec2::new(left - 0.3 * em, y), TICK * em);
        panel.number(&(kilometres as u32).to_string(), Vec2::new(left - 0.5 * em, y + 0.25 * em), 1.0, 0.9);
    }
}

/// Draws a river upward from its end; `widest` is the half width that is drawn as the greatest.
fn draw_river(panel: &mut Panel, river: &StraightRiver, from: Vec2, length: f32, widest: f32) {
    let em = panel.em;
    let last = river.points.len().saturating_sub(1).max(1);
    let every = (PIECE * em / (length / last as f32).max(f32::MIN_POSITIVE)).ceil().max(1.0) as usize;
    // Its line is round at its end.
    let (foot, rise) = (from.y - HALF[1] * em, length - HALF[1] * em);
    let place = |i: usize, aside: f32| {
        let aside = ASIDE * em * aside / (WINDING + aside.abs());
        Vec2::new(from.x + aside, foot - rise * i as f32 / last as f32)
    };
    let points: Vec<(Vec2, f32)> = (0..=last / every)
        .map(|i| if i == last / every { last } else { i * every })
        .filter_map(|i| {
            // Its winding on average, so that no piece is a bend of its own.
            let near = river.points.get(i.saturating_sub(every)..(i + every + 1).min(river.points.len()))?;
            let aside = near.iter().map(|point| point[0]).sum::<f32>() / near.len().max(1) as f32;
            Some((place(i, aside), river.points.get(i)?[1]))
        })
        .collect();
    for pair in points.windows(2) {
        // Rounded, so that most neighbours are of one width.
        let share = 0.5 * (pair[0].1 + pair[1].1) / widest;
        let half = ((share * STEPS).round() / STEPS * HALF[1]).max(HALF[0]) * em;
        panel.line(pair[0].0, pair[1].0, half);
    }
}
