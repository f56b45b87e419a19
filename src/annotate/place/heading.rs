//! The heading of a picture that is sent: the title, as large as a box that the picture keeps free for it allows.

use glam::Vec2;

use super::cartouche::{CAPITAL, LINE, TO_SEED, UNDER, UNDER_TITLE, broken};
use super::letters::{Kind, Label, Placed, Text};

/// The share of their size that letters of two lines count for in comparisons with letters of one.
const WORTH_OF_TWO: f32 = 0.7;

/// Sets a title in the middle of a box, its upper left and its lower right corner, with a line under it where that is no
/// smaller than the smallest letters that can be read. None if the type has no letter of it.
pub fn heading(title: &str, under: &str, within: [Vec2; 2], least: f32) -> Vec<Label> {
    let room = within[1] - within[0];
    let forms = [(1, 1.0), (2, WORTH_OF_TWO)];
    let set = |(count, worth): (usize, f32)| {
        let lines: Vec<Text> = broken(title, count)?.into_iter().map(|line| Text::new(line, Kind::Title)).collect();
        let with_line = Heading::new(&lines, Some(Text::new(under, Kind::Seed)), room);
        let heading = with_line.filter(|heading| UNDER_TITLE * heading.em >= least);
        let heading = heading.or_else(|| Heading::new(&lines, None, room))?;
        Some((heading.em * worth, heading))
    };
    let better = |a: (f32, Heading), b: (f32, Heading)| if b.0 > a.0 { b } else { a };
    let best = forms.into_iter().filter_map(set).reduce(better);
    best.map_or_else(Vec::new, |(_, heading)| heading.labels(title, under, (within[0] + within[1]) * 0.5))
}

/// Lines of type, one under the other, each in the middle.
struct Heading {
    titles: Vec<Text>,
    under: Option<Text>,
    /// The length of the title's em, in units.
    em: f32,
}

impl Heading {
    /// Makes the largest heading that fits into a room; `None` if there are no letters, or if the line under the title is too wide.
    fn new(titles: &[Text], under: Option<Text>, room: Vec2) -> Option<Self> {
        let wide = titles.iter().map(|text| text.length).fold(0.0, f32::max);
        if titles.iter().any(|text| text.letters.is_empty()) || wide <= 0.0 {
            return None;
        }
        let mut this = Self { titles: titles.to_vec(), under, em: 1.0 };
        this.em = (room.x / wide).min(room.y / this.height());
        let under = this.under.as_ref().map_or(0.0, |text| text.length * UNDER_TITLE * this.em);
        let has_letters = this.under.as_ref().is_none_or(|text| !text.letters.is_empty());
        (has_letters && this.em > 0.0 && under <= room.x).then_some(this)
    }

    /// Returns the distance of a line's baseline below the upper side, in ems.
    fn down(&self, line: usize) -> f32 {
        CAPITAL + LINE * line as f32
    }

    /// Returns the distance of the baseline of the line under the title below the upper side, in ems.
    fn down_to_under(&self) -> f32 {
        self.down(self.titles.len() - 1) + TO_SEED * UNDER_TITLE + 0.12
    }

    /// Returns its height, in ems.
    fn height(&self) -> f32 {
        match self.under {
            Some(_) => self.down_to_under() + UNDER * UNDER_TITLE,
            None => self.down(self.titles.len() - 1) + UNDER,
        }
    }

    /// Sets the labels around a middle: the title, and the line under it.
    fn labels(&self, title: &str, under: &str, middle: Vec2) -> Vec<Label> {
        let top = middle.y - 0.5 * self.height() * self.em;
        let line = |text: &Text, em: f32, down: f32| -> Vec<Placed> {
            text.level(Vec2::new(middle.x - 0.5 * text.length * em, top + down * self.em), em)
        };
        let letters = (0..).zip(&self.titles).flat_map(|(i, text)| line(text, self.em, self.down(i))).collect();
        let mut labels = vec![Label::new(Kind::Title, None, title, self.em, letters)];
        if let Some(text) = &self.under {
            let em = UNDER_TITLE * self.em;
            labels.push(Label::new(Kind::Seed, None, under, em, line(text, em, self.down_to_under())));
        }
        labels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: [Vec2; 2] = [Vec2::new(100.0, 50.0), Vec2::new(900.0, 250.0)];

    /// Returns the corners of all letters of a label.
    fn corners(label: &Label) -> impl Iterator<Item = Vec2> + '_ {
        label.letters.iter().flat_map(|letter| letter.around(label.em).corners())
    }

    #[test]
    fn a_heading_fills_its_box_and_no_letter_leaves_it() {
        for title in ["Ra", "Ardenmoor", "The Rivers of Wobegonshire", "Quinquagesima-upon-Severn"] {
            let labels = heading(title, "and its rivers", BOX, 11.0);
            let slack = 0.1 * labels[0].em;
            let within = |at: Vec2| at.cmpge(BOX[0] - slack).all() && at.cmple(BOX[1] + slack).all();
            assert!(labels.iter().flat_map(corners).all(within), "{title}");
            let wide = corners(&labels[0]).map(|at| at.x).fold(0.0, f32::max);
            let high = labels.iter().map(|label| label.em).sum::<f32>();
            assert!(wide > 850.0 || high > 140.0, "{title} is smaller than it could be");
        }
    }

    #[test]
    fn the_line_under_a_title_is_left_out_where_it_could_not_be_read() {
        let count = |least| heading("Ardenmoor", "and its rivers", BOX, least).len();
        assert_eq!((count(11.0), count(200.0)), (2, 1));
        assert_eq!(heading("Ardenmoor", "", BOX, 11.0).len(), 1);
    }

    #[test]
    fn a_title_without_letters_and_a_box_without_room_have_no_heading() {
        assert_eq!(heading("", "", BOX, 11.0), []);
        assert_eq!(heading("Ardenmoor", "", [BOX[0]; 2], 11.0), []);
    }
}
