//! The data of a path: smooth lines, in hundredths of a unit.

use glam::Vec2;

use super::text::Text;

/// A point in hundredths of a unit. Whole numbers add without error, and can be printed without tables.
type Point = [i32; 2];

/// The number of points in a row after which one is not relative: readers that add up rounded steps would drift off a long coast.
const ANCHORED: usize = 64;

/// A path's data while it is written. Most points are relative to the one before.
#[derive(Debug, Default)]
pub(super) struct Path {
    data: Text,
    at: Point,
    /// `true` if the next number would run into the one before.
    is_after_number: bool,
}

impl Text {
    /// Appends the data of a path.
    pub fn path(&mut self, path: &Path) -> &mut Self {
        self.written(path.data())
    }
}

impl Path {
    /// Returns the path as data for the attribute `d`.
    pub fn data(&self) -> &str {
        self.data.as_str()
    }

    /// Returns `true` if nothing is drawn.
    pub fn is_empty(&self) -> bool {
        self.data().is_empty()
    }

    /// Begins a line.
    pub fn start(&mut self, at: Vec2) {
        self.at = [0, 0];
        self.command("M");
        self.go_to(whole(at));
    }

    /// Begins a line, unless the last one ends there.
    pub fn go_on(&mut self, at: Vec2) {
        if self.is_empty() || self.at != whole(at) {
            self.start(at);
        }
    }

    /// Draws a line from corner to corner.
    pub fn line(&mut self, points: &[Vec2]) {
        let [first, ..] = points else { return };
        self.start(*first);
        self.straight(points);
    }

    /// Draws a line from corner to corner, starting at the first of the points, where the path is now.
    pub fn straight(&mut self, points: &[Vec2]) {
        let [_, rest @ ..] = points else { return };
        self.command("l");
        rest.iter().for_each(|&to| self.go_to(whole(to)));
    }

    /// Draws a smooth line from the first of the points, where the path is now, to the last: a chain of parabolas from
    /// the middle of one side to the middle of the next.
    #[inline(never)]
    pub fn smooth(&mut self, points: &[Vec2]) {
        let [_, rest @ ..] = points else { return };
        let Some(&last) = rest.last() else { return };
        self.parabolas(rest);
        self.command("l");
        self.go_to(whole(last));
    }

    /// Draws the same smooth line, whose last point is where the path began, and closes the path.
    pub fn smooth_home(&mut self, points: &[Vec2]) {
        if let [_, rest @ ..] = points {
            self.parabolas(rest);
        }
        self.close();
    }

    /// Draws a line from corner to corner like [`straight`](Self::straight), whose last point is where the path began, and
    /// closes the path.
    pub fn straight_home(&mut self, points: &[Vec2]) {
        if let [first @ .., _] = points {
            self.straight(first);
        }
        self.close();
    }

    /// Draws a parabola from where the path is now, given its control point and its end.
    pub fn curve(&mut self, [control, end]: [Vec2; 2]) {
        self.command("q");
        self.number_pair(difference(whole(control), self.at));
        self.go_to(whole(end));
    }

    /// Draws a smooth closed line around some points.
    pub fn ring(&mut self, points: &[Vec2]) {
        let [first, .., last] = points else { return };
        self.start((*first + *last) * 0.5);
        self.command("q");
        self.number_pair(difference(whole(*first), self.at));
        let control = whole(*first);
        self.go_to(middle(control, whole(points[1])));
        self.reflected(control, points[2..].iter().chain([first]));
        self.close();
    }

    /// Draws a half circle from where the path is now, bulging to the left of the way.
    pub fn half_circle(&mut self, to: Vec2) {
        let way = difference(whole(to), self.at);
        // A radius that is too short is lengthened by the reader until it fits.
        let radius = way[0].unsigned_abs().max(way[1].unsigned_abs()).div_ceil(2) as i32;
        self.command("a");
        self.number_pair([radius, radius]);
        self.data.text(" 0 0 1");
        self.go_to(whole(to));
    }

    /// Draws a straight line back to where the path began. A line that is to end there has this for its last piece: readers
    /// add up what is relative, and would come to a place beside the first.
    pub fn close(&mut self) {
        self.command("z");
    }

    /// Draws parabolas round corners, from where the path is now to half the way from the last but one to the last.
    fn parabolas(&mut self, corners: &[Vec2]) {
        let [first, rest @ ..] = corners else { return };
        // The first piece is straight: its control point is its start.
        let control = self.at;
        self.data.text("q0 0");
        self.is_after_number = true;
        self.go_to(middle(control, whole(*first)));
        self.reflected(control, rest.iter());
    }

    /// Draws further parabolas. Each control point is the mirror image of the one before, so it is left out. It lies in
    /// a corner, give or take the hundredth lost when the last middle was rounded.
    fn reflected<'a>(&mut self, mut control: Point, corners: impl Iterator<Item = &'a Vec2>) {
        let mut is_relative = false;
        for (i, &corner) in corners.enumerate() {
            control = [2 * self.at[0] - control[0], 2 * self.at[1] - control[1]];
            let to = middle(control, whole(corner));
            let was_relative = std::mem::replace(&mut is_relative, i % ANCHORED != ANCHORED - 1);
            match (was_relative, is_relative) {
                (_, false) => self.anchor(to),
                (true, true) => self.go_to(to),
                (false, true) => {
                    self.command("t");
                    self.go_to(to);
                }
            }
        }
    }

    /// Draws a parabola with a mirrored control point to a place that is not relative to the one before.
    fn anchor(&mut self, to: Point) {
        self.command("T");
        self.number_pair(to);
        self.at = to;
    }

    fn command(&mut self, letter: &'static str) {
        self.data.text(letter);
        self.is_after_number = false;
    }

    fn go_to(&mut self, to: Point) {
        self.number_pair(difference(to, self.at));
        self.at = to;
    }

    #[inline(never)]
    fn number_pair(&mut self, pair: Point) {
        for hundredths in pair {
            if self.is_after_number && hundredths >= 0 {
                self.data.text(" ");
            }
            self.data.hundredths(hundredths);
            self.is_after_number = true;
        }
    }
}

/// Rounds a point to hundredths. NaN counts as 0.
fn whole(at: Vec2) -> Point {
    [at.x, at.y].map(|x| (x * 100.0 + 0.5).floor() as i32)
}

fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn middle(a: Point, b: Point) -> Point {
    [(a[0] + b[0]) >> 1, (a[1] + b[1]) >> 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_goes_by_the_middles_of_its_sides() {
        let points = [(0.0, 0.0), (4.0, 0.0), (8.0, 4.0), (8.0, 10.0)].map(Vec2::from);
        let mut path = Path::default();
        path.start(points[0]);
        path.smooth(&points);
        assert_eq!(path.data(), "M0 0q0 0 2 0t4 2 2 5l0 3");
    }

    #[test]
    fn a_long_line_has_a_place_that_is_not_relative_now_and_then() {
        let points: Vec<Vec2> = (0..68u8).map(|i| Vec2::new(f32::from(i) * 2.0, 0.0)).collect();
        let mut path = Path::default();
        path.start(points[0]);
        path.smooth(&points);
        // The 63 middles after the first one are relative, the next is not.
        let relative = format!("t{}", ["2 0"; 63].join(" "));
        assert_eq!(path.data(), format!("M0 0q0 0 1 0{relative}T129 0t2 0 2 0l1 0"));
    }

    #[test]
    fn a_line_goes_on_where_the_last_one_ends_and_else_begins() {
        let mut path = Path::default();
        for x in [0.0, 1.0, 5.0] {
            path.go_on(Vec2::new(x, 0.0));
            path.curve([Vec2::new(x, 1.0), Vec2::new(x + 1.0, 0.0)]);
        }
        assert_eq!(path.data(), "M0 0q0 1 1 0q0 1 1 0M5 0q0 1 1 0");
    }

    #[test]
    fn shortest_lines_are_whole() {
        let points = [Vec2::ZERO, Vec2::splat(2.0)];
        let mut path = Path::default();
        path.start(points[0]);
        path.smooth(&points);
        path.smooth(&points[1..]);
        assert_eq!(path.data(), "M0 0q0 0 1 1l1 1");
    }

    #[test]
    fn way_home_ends_with_the_path_and_not_beside_its_start() {
        let points = [(0.0, 4.0), (4.0, 4.0), (0.0, 0.0)].map(Vec2::from);
        let (mut smooth, mut straight) = (Path::default(), Path::default());
        for path in [&mut smooth, &mut straight] {
            path.start(Vec2::ZERO);
            path.straight(&[Vec2::ZERO, points[0]]);
        }
        smooth.smooth_home(&points);
        straight.straight_home(&points);
        assert_eq!([smooth.data(), straight.data()], ["M0 0l0 4q0 0 2 0t0-2z", "M0 0l0 4l4 0z"]);
    }

    #[test]
    fn ring_ends_where_it_began() {
        let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(Vec2::from);
        let mut path = Path::default();
        path.ring(&points);
        assert_eq!(path.data(), "M0 2q0-2 2-2t2 2-2 2-2-2z");
    }
}
