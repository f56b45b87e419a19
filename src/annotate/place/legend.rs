//! The legend: a box in a corner that shows the name of the map, the length of some kilometres, and the number of rivers of each
//! order.

use glam::Vec2;

use super::background::Background;
use super::corner;
use super::input::{Input, Legend, RiverClass};
use super::letters::{Box, Kind, Label, Stroke, Text};
use crate::scale::{MapScale, figures, round_length};

/// The length of its em, in units.
const EM: f32 = 11.0;
/// The size of the title over that of other lines.
const TITLE: f32 = 1.4;
/// The greatest shares of the map's width and height that the legend takes up, and on land.
const MOST: Vec2 = Vec2::new(0.36, 0.4);
const MOST_ON_LAND: Vec2 = Vec2::new(0.25, 0.25);
/// The number of orders of rivers, and the numbers that are tried if there is no room for these.
const ORDERS: [usize; 3] = [6, 3, 0];

/// The distance of its lines from the frame around it, the distance between them, and that of the lines between its parts from both, in
/// ems.
const AROUND: f32 = 0.8;
const LINE: f32 = 1.35;
const BETWEEN: f32 = 0.5;
/// Half the width of the lines between its parts, in ems.
const RULE: f32 = 0.014;

/// The greatest length of the scale, in units.
const SCALE: f32 = 100.0;
/// The length of the samples of rivers, the least and the greatest half of their width, and the distance of type behind them and the scale,
/// in ems.
const SAMPLE: f32 = 2.4;
const HALF: [f32; 2] = [0.03, 0.25];
const BEHIND: f32 = 0.7;
/// The height of the samples of rivers over the line that type stands on, in ems.
const ABOVE: f32 = 0.22;

/// A legend in its place: its lines of type, the first with all strokes.
pub struct Set {
    pub labels: Vec<Label>,
    /// The box that other labels keep off.
    pub around: Box,
}

/// Puts it into the corner with the most sea that is not taken; shorter if that keeps it off land, and on land. `None` if there is no room.
pub fn set<G: Background>(input: &Input<'_>, background: &G, legend: &Legend, taken: &[(u32, Box)]) -> Option<Set> {
    let em = EM.max(input.least_em) * input.label_size;
    let blocks = ORDERS.map(|orders| Block::new(legend, &input.map.scale, em, orders));
    let corner = |block: &Block| corner::best(input, background, block.size, em, taken);
    let room = |share: Vec2| move |block: &&Block| block.size.cmple((input.frame[1] - input.frame[0]) * share).all();
    let at_sea = blocks.iter().filter(room(MOST)).find_map(|block| {
        let corner = corner(block)?;
        (corner.sea == 1.0).then_some((block, corner))
    });
    let on_land = || blocks[1..].iter().filter(room(MOST_ON_LAND)).find_map(|block| Some((block, corner(block)?)));
    let (block, corner) = at_sea.or_else(on_land)?;
    Some(block.set(corner.at, corner.sea < 1.0))
}

/// Lines of type with strokes, one under the other.
struct Block {
    em: f32,
    lines: Vec<Line>,
    strokes: Vec<Stroke>,
    /// The size of all with the frame, in units.
    size: Vec2,
}

struct Line {
    says: String,
    text: Text,
    em: f32,
    /// The place where it begins, from the block's upper left corner, in units.
    at: Vec2,
}

impl Block {
    /// Sets a legend with some orders of rivers at most.
    fn new(legend: &Legend, scale: &MapScale, em: f32, orders: usize) -> Self {
        let mut this = Self { em, lines: Vec::new(), strokes: Vec::new(), size: Vec2::splat(2.0 * AROUND * em) };
        let mut rules = Vec::new();
        if let Some([title, seed]) = &legend.heading {
            this.add(title, 0.0, TITLE);
            this.add(seed, 0.0, 1.0);
            rules.push(this.part());
        }
        this.add_scale(scale);
        if orders > 0 {
            rules.push(this.part());
        }
        legend.classes.iter().take(orders).for_each(|class| this.add_class(class));
        let (left, right) = (AROUND * em, this.size.x - AROUND * em);
        let rule = |y: f32| Stroke { ends: [left, right].map(|x| Vec2::new(x, y)), half: RULE * em };
        this.strokes.extend(rules.into_iter().map(rule));
        this.strokes.extend(corner::rules(Vec2::ZERO, this.size, em));
        this
    }

    /// Adds a line of type that begins so far from the left, in ems; nothing if there are no letters for it. Returns how high it stands.
    fn add(&mut self, says: &str, from: f32, size: f32) -> f32 {
        let (text, em) = (Text::new(says, Kind::Legend), size * self.em);
        let down = self.size.y - AROUND * self.em + em;
        if !text.letters.is_empty() {
            let at = Vec2::new((AROUND + from) * self.em, down);
            self.size = Vec2::new(self.size.x.max(at.x + text.length * em + AROUND * self.em), self.size.y + LINE * em);
            self.lines.push(Line { says: says.into(), text, em, at });
        }
        down
    }

    /// Ends a part. Returns where the line under it is.
    fn part(&mut self) -> f32 {
        let at = self.size.y - (AROUND - BETWEEN * 0.5) * self.em;
        self.size.y += BETWEEN * self.em;
        at
    }

    fn stroke(&mut self, ends: [[f32; 2]; 2], half: f32) {
        self.strokes.push(Stroke { ends: ends.map(Vec2::from), half });
    }

    /// Adds a bar in two halves, the first of them filled.
    fn add_scale(&mut self, scale: &MapScale) {
        const HEIGHT: f32 = 0.36;
        const THIN: f32 = 0.03;
        let (left, em) = (AROUND * self.em, self.em);
        let kilometres = round_length(scale.kilometres(SCALE));
        let length = scale.units(kilometres);
        let foot = self.add(&format!("{} km", figures(kilometres)), length / em + BEHIND, 1.0);
        let (top, thin) = (foot - HEIGHT * em, THIN * em);
        let [middle, right] = [0.5, 1.0].map(|share| left + share * length);
        self.stroke([[left, top], [right, top]], thin);
        self.stroke([[left, foot], [right, foot]], thin);
        [left, middle, right].into_iter().for_each(|x| self.stroke([[x, top], [x, foot]], thin));
        let half = 0.5 * HEIGHT * em;
        self.stroke([[left + half, foot - half], [middle - half, foot - half]], half);
    }

    fn add_class(&mut self, class: &RiverClass) {
        let (left, em) = (AROUND * self.em, self.em);
        let rivers = if class.count == 1 { "river" } else { "rivers" };
        let y =
            self.add(&format!("{} {rivers} of order {}", class.count, class.order), SAMPLE + BEHIND, 1.0) - ABOVE * em;
        // (`clamp` could panic, and would bring all that prints floats into the page.)
        let half = class.half.max(HALF[0] * em).min(HALF[1] * em);
        self.stroke([[left + half, y], [left + SAMPLE * em - half, y]], half);
    }

    /// Puts the block into its place.
    fn set(&self, at: Vec2, is_on_land: bool) -> Set {
        let label = |line: &Line| {
            let letters = line.text.level(at + line.at, line.em);
            Label::new(Kind::Legend, None, &line.says, line.em, letters)
        };
        let mut labels: Vec<Label> = self.lines.iter().map(label).collect();
        if let Some(first) = labels.first_mut() {
            let moved = |stroke: &Stroke| Stroke { ends: stroke.ends.map(|end| at + end), ..*stroke };
            first.strokes = self.strokes.iter().map(moved).collect();
            first.cleared = if is_on_land { corner::filled(at, self.size, 0.3 * self.em) } else { Vec::new() };
        }
        Set { labels, around: Box::level(at, at + self.size) }
    }
}
