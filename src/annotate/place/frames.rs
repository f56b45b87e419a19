//! Frames around blocks of lines, of strokes: a double line with notched corners, and lines that roll up at the corners.

use glam::Vec2;

use super::input::Frame;
use super::letters::Stroke;

/// Half the widths of the outer and the inner line, and the distance between them, in ems.
const RULES: [f32; 2] = [0.035, 0.014];
const BETWEEN: f32 = 0.14;
/// The depth of the notches in the inner line's corners, in ems.
const NOTCH: f32 = 0.22;

/// The radius of a scroll, in ems; the number of its pieces, the turn of each, and its length over that of the one before.
const SCROLL: f32 = 0.34;
const PIECES: u32 = 17;
const TURN: Vec2 = Vec2::new(0.866_025_4, 0.5);
const SHORTER: f32 = 0.955;

/// The greatest em that frames are drawn by, in units.
const MOST: f32 = 24.0;

/// Returns the width of a frame around letters of a size, in units.
pub fn width(frame: Frame, em: f32) -> f32 {
    let widths = match frame {
        Frame::Rules => 0.35,
        Frame::Scrolls => 0.85,
    };
    widths * em.min(MOST)
}

/// Draws a frame just within a block.
pub fn strokes(frame: Frame, at: Vec2, size: Vec2, em: f32) -> Vec<Stroke> {
    let em = em.min(MOST);
    match frame {
        Frame::Rules => notched(at, size, em),
        Frame::Scrolls => scrolled(at, size, em),
    }
}

/// Returns the strokes along some points.
pub fn along(points: &[Vec2], half: f32) -> impl Iterator<Item = Stroke> + '_ {
    points.windows(2).map(move |ends| Stroke { ends: [ends[0], ends[1]], half })
}

/// Returns the four sides between two corners, as one line.
pub fn sides(least: Vec2, most: Vec2) -> [Vec2; 5] {
    [least, Vec2::new(most.x, least.y), most, Vec2::new(least.x, most.y), least]
}

fn notched(at: Vec2, size: Vec2, em: f32) -> Vec<Stroke> {
    let [outer, inner] = [RULES[0], BETWEEN].map(|inward| [at + inward * em, at + size - inward * em]);
    let notch = NOTCH * em;
    let mut points: Vec<Vec2> = Vec::new();
    let corners = sides(inner[0], inner[1]);
    let inward = [Vec2::ONE, Vec2::new(-1.0, 1.0), Vec2::NEG_ONE, Vec2::new(1.0, -1.0)];
    for (i, (corner, inward)) in corners.into_iter().zip(inward).enumerate() {
        let by = inward * notch;
        let [across, down] = [Vec2::new(by.x, 0.0), Vec2::new(0.0, by.y)];
        // Clockwise, so that the sides alternate.
        let [first, last] = if i % 2 == 0 { [down, across] } else { [across, down] };
        points.extend([corner + first, corner + by, corner + last]);
    }
    points.extend(points.first().copied());
    let outer = along(&sides(outer[0], outer[1]), RULES[0] * em).collect::<Vec<_>>();
    outer.into_iter().chain(along(&points, RULES[1] * em)).collect()
}

/// Draws two lines, of which the outer one ends in a scroll at both ends of the level sides.
fn scrolled(at: Vec2, size: Vec2, em: f32) -> Vec<Stroke> {
    let (thick, thin) = (RULES[0] * em, RULES[1] * em);
    let [outer, inner] = [0.55, 0.7].map(|inward| [at + inward * em, at + size - inward * em]);
    let mut strokes: Vec<Stroke> = along(&sides(inner[0], inner[1]), thin).collect();
    let middle = at + 0.5 * size;
    for corner in &sides(outer[0], outer[1])[..4] {
        // Outward along both axes.
        let out = (*corner - middle).signum();
        let across = *corner - Vec2::new(out.x * 0.42 * em, 0.0);
        let down = *corner - Vec2::new(0.0, out.y * 0.42 * em);
        for (from, ahead, side) in [
            (across, Vec2::new(out.x, 0.0), Vec2::new(0.0, out.y)),
            (down, Vec2::new(0.0, out.y), Vec2::new(out.x, 0.0)),
        ] {
            strokes.extend(along(&scroll(from, ahead, side, SCROLL * em), thick));
        }
        let [far_across, far_down] = [Vec2::new(middle.x, corner.y), Vec2::new(corner.x, middle.y)];
        strokes.extend([[across, far_across], [down, far_down]].map(|ends| Stroke { ends, half: thick }));
    }
    strokes
}

/// Draws a line that sets out ahead and rolls up to a side.
fn scroll(from: Vec2, ahead: Vec2, side: Vec2, radius: f32) -> Vec<Vec2> {
    let (mut at, mut step, mut length) = (from, Vec2::X, radius * 0.52);
    let mut points = vec![from];
    for _ in 0..PIECES {
        at += (ahead * step.x + side * step.y) * length;
        points.push(at);
        step = step.rotate(TURN);
        length *= SHORTER - 0.03;
    }
    points
}
