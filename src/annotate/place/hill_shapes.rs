//! The drawing of hills and mountains: a profile from foot to foot, crest lines that wander down from each peak towards the reader, and
//! hatches and a wash on the flank that lies in the dark.

use glam::Vec2;

use super::pen::{Feature, Hand, PenStroke, Shape};

/// Half the width of a pen, in halves of a hill's width.
const PEN: f32 = 0.034;

const fn at(x: f32, y: f32) -> Vec2 {
    Vec2::new(x, y)
}

/// Draws a mountain of one peak, or of two or three. `share` is the share of all mountains that are lower.
pub(super) fn mountain(mut hand: Hand, share: f32) -> Shape {
    let height = 0.92 + 0.55 * share + hand.swing(0.04);
    let (mut summits, mut saddles) = (Vec::new(), Vec::new());
    let kind = hand.number % 4;
    let peak = at([0.0, -0.18, 0.2, 0.02][usize::from(kind)] + hand.swing(0.08), -height);
    if kind >= 2 {
        let side = at(peak.x - hand.between(0.46, 0.56), -height * hand.between(0.58, 0.74));
        summits.push(side);
        saddles.push(saddle(&mut hand, side, peak));
    }
    summits.push(peak);
    if kind % 2 == 1 {
        let side = at(peak.x + hand.between(0.44, 0.54), -height * hand.between(0.56, 0.72));
        summits.push(side);
        saddles.push(saddle(&mut hand, peak, side));
    }
    massif(&mut hand, &summits, &saddles)
}

/// Chooses the lowest place between two summits.
fn saddle(hand: &mut Hand, left: Vec2, right: Vec2) -> Vec2 {
    let lower = left.y.max(right.y);
    // It is nearer to the lower one.
    let along = if left.y > right.y { hand.between(0.3, 0.42) } else { hand.between(0.58, 0.7) };
    at(left.x + (right.x - left.x) * along, lower * hand.between(0.78, 0.88))
}

/// Draws a mountain of summits with a saddle between each two, from left to right.
fn massif(hand: &mut Hand, summits: &[Vec2], saddles: &[Vec2]) -> Shape {
    let feet = [at(-1.0, hand.swing(0.03)), at(1.0, hand.swing(0.03))];
    let (mut profile, mut outline, mut shade) = (vec![feet[0]], Vec::new(), Vec::new());
    let mut wash = None;
    let mut from = feet[0];
    for (i, &summit) in summits.iter().enumerate() {
        let is_last = i + 1 == summits.len();
        let to = if is_last { feet[1] } else { saddles[i] };
        let (ascent, descent) = (slope(hand, from, summit), slope(hand, summit, to));
        outline.push(hand.line(&ascent, [PEN * 0.7, PEN * 1.1]));
        outline.push(hand.line(&descent, [PEN * 1.5, PEN * 0.9]));
        let crest = crest(hand, summit, 0.8);
        shade.extend(hatches(hand, &crest, &descent, feet[1]));
        shade.extend(lit(hand, &crest, &ascent));
        outline.push(hand.line(&crest, [PEN * 1.3, PEN * 0.4]));
        if is_last {
            let around: Vec<Vec2> = descent.iter().chain(crest.iter().rev()).copied().collect();
            wash = Some(hand.line(&around, [0.0; 2]));
        }
        profile.extend(ascent[1..].iter().chain(&descent[1..]));
        from = to;
    }
    // The profile without its wavering: what lies between is thinner than the pen.
    let silhouette = outline_of(&outline, feet[0]);
    let top = summits.iter().fold(Vec2::ZERO, |top, at| if at.y < top.y { *at } else { top });
    let middles =
        [at(-0.66, -0.1), at(0.66, -0.1), at(0.0, -0.25), at(-0.3, -0.45), at(0.34, -0.45), top * 0.6, top * 0.86];
    Shape { feature: Feature::Mountain, silhouette, wash, outline, shade, discs: Vec::new() }.within(&middles)
}

/// Joins the ascents and descents of an outline to one line.
fn outline_of(outline: &[PenStroke], start: Vec2) -> PenStroke {
    // Of each summit there are an ascent, a descent and a crest.
    let slopes = outline.chunks(3).flat_map(|summit| summit.iter().take(2));
    PenStroke { start, curves: slopes.flat_map(|slope| slope.curves.iter().copied()).collect(), halves: [0.0; 2] }
}

/// Draws a rugged slope from one place to another, flatter at its lower end.
fn slope(hand: &mut Hand, from: Vec2, to: Vec2) -> Vec<Vec2> {
    let way = to - from;
    let pieces = (way.length() * 4.5) as u8 + 2;
    let between = (1..pieces).map(|i| {
        let t = (f32::from(i) + hand.swing(0.25)) / f32::from(pieces);
        let sag = 0.34 * t * (1.0 - t) * way.y.abs();
        from + way * t + at(hand.swing(0.022), sag + hand.swing(0.03))
    });
    let between: Vec<Vec2> = between.collect();
    std::iter::once(from).chain(between).chain([to]).collect()
}

/// Draws a ridge that wanders from a summit down towards the reader, over a share of its height.
fn crest(hand: &mut Hand, summit: Vec2, share: f32) -> Vec<Vec2> {
    const TURNS: u8 = 5;
    let mut side = if hand.between(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
    let reach = -summit.y * hand.between(share * 0.8, share);
    let drift = hand.swing(0.12);
    let turn = |i: u8| {
        let t = (f32::from(i) + hand.swing(0.2)) / f32::from(TURNS);
        side = -side;
        summit + at(drift * t + side * hand.between(0.02, 0.075) * (0.5 + t), reach * t)
    };
    let turns: Vec<Vec2> = (1..=TURNS).map(turn).collect();
    std::iter::once(summit).chain(turns).collect()
}

/// Returns the place of a line that runs down at a height; its end below that.
fn at_height(line: &[Vec2], y: f32) -> Vec2 {
    let crosses = |pair: &&[Vec2]| pair[0].y <= y && pair[1].y > y;
    let Some(pair) = line.windows(2).find(crosses) else { return line.last().copied().unwrap_or_default() };
    pair[0].lerp(pair[1], (y - pair[0].y) / (pair[1].y - pair[0].y))
}

/// Draws hatches down the dark flank between a crest and a descent, in two rows: from the crest, and below them.
fn hatches(hand: &mut Hand, crest: &[Vec2], descent: &[Vec2], foot: Vec2) -> Vec<PenStroke> {
    let (Some(&summit), Some(&end)) = (crest.first(), descent.last()) else { return Vec::new() };
    let height = -summit.y;
    // How far a slope goes to the right on its way down.
    let lean = (foot.x - summit.x) / height;
    let count = (height * 7.0) as u8 + 2;
    let mut all = Vec::new();
    for row in [0.04, 0.42] {
        for i in 0..count {
            let y = summit.y + height * (f32::from(i) + 0.7 + hand.swing(0.25)) / (f32::from(count) + 1.0) * 0.86;
            let (left, right) = (at_height(crest, y), at_height(descent, y.min(end.y)));
            let start = at(left.x + (right.x - left.x) * row + 0.015, y);
            let long = height * hand.between(0.13, 0.24) * if row < 0.1 { 1.0 } else { 0.7 };
            let low = (y + long).min(-0.03);
            let limit = at_height(descent, low.min(end.y)).x - 0.05;
            let stop = at((start.x + lean * (low - y) * hand.between(0.7, 0.9)).min(limit), low);
            if stop.x > start.x && right.x - start.x > 0.07 && low > y {
                let control = (start + stop) * 0.5 + at(-0.012, 0.012);
                all.push(PenStroke::dash(start, control, stop, [PEN, PEN * 0.35]));
            }
        }
    }
    all
}

/// Draws two short strokes on the lit flank, where ravines begin.
fn lit(hand: &mut Hand, crest: &[Vec2], ascent: &[Vec2]) -> Vec<PenStroke> {
    let (Some(&summit), Some(&foot)) = (crest.first(), ascent.first()) else { return Vec::new() };
    let stroke = |share: f32| {
        let y = summit.y * (1.0 - share) + hand.swing(0.05);
        let start = at_height(crest, y) + at(-hand.between(0.05, 0.12), 0.0);
        let way = at((foot.x - summit.x) * 0.16, -summit.y * 0.16) * hand.between(0.7, 1.1);
        PenStroke::dash(start, start + way * 0.5 + at(0.01, 0.01), start + way, [PEN * 0.7, PEN * 0.25])
    };
    [0.34, 0.6].map(stroke).into()
}

/// Draws a hill: round, with a few hatches down its dark flank. `share` is the share of all hills that are lower.
pub(super) fn hill(mut hand: Hand, share: f32) -> Shape {
    let height = 0.44 + 0.3 * share;
    let top = at(hand.swing(0.14), -height);
    let (left, right) = (hand.between(-0.56, -0.42), hand.between(0.44, 0.58));
    let (left_y, right_y) = (-height * hand.between(0.48, 0.62), -height * hand.between(0.44, 0.58));
    // In one tangent before and after the top.
    let tilt = hand.swing(0.03);
    let ascent = vec![[at(left - 0.24, -0.03), at(left, left_y)], [at(top.x - 0.24, -height * 1.04 + tilt), top]];
    let descent =
        vec![[at(top.x + 0.24, -height * 0.98 - tilt), at(right, right_y)], [at(right + 0.2, -0.04), at(1.0, 0.02)]];
    let start = at(-1.0, 0.0);
    let curves = ascent.iter().chain(&descent).copied().collect();
    let silhouette = PenStroke { start, curves, halves: [0.0; 2] };
    let flank = PenStroke { start: top, curves: descent, halves: [PEN * 1.4, PEN * 0.8] };
    let outline = vec![PenStroke { start, curves: ascent, halves: [PEN * 0.6, PEN * 1.2] }, flank.clone()];
    let points: Vec<Vec2> = flank.points().collect();
    let shade = (0..5u8).filter_map(|i| {
        let from = points.get(usize::from(i) * 2 + 2)?;
        let start = *from + at(-0.02, 0.07);
        let stop = start + at(0.09, -from.y * hand.between(0.34, 0.52));
        (stop.y < 0.0).then(|| PenStroke::dash(start, (start + stop) * 0.5 + at(0.03, -0.01), stop, [PEN, PEN * 0.4]))
    });
    let shade = shade.collect();
    let mut wash = flank;
    wash.curves.push([at(0.3, -0.02), at(top.x + 0.1, -height * 0.4)]);
    let middles = [at(-0.64, -0.1), at(0.0, -0.3), at(0.64, -0.1)];
    Shape { feature: Feature::Hill, silhouette, wash: Some(wash), outline, shade, discs: Vec::new() }.within(&middles)
}
