//! The tables of type, and their decoding.
//!
//! `italic.bin` and `roman.bin` are written by `www/scripts/type.mjs`, in the numbers of `base/numbers.rs`. Lengths are 256ths of the em, y up.
//! Letters that somebody carries on are a table with nothing but these (`subset.rs`), and may come from anywhere.
//!
//! ```text
//! table:   shapes, letters, rows of kerning
//! shape:   contours
//! contour: number of points, a bit for each that lies on the line, each point less the one before (x, y)
//! letter:  code less that before, code without its accent, advance, parts: (shape, x, y)
//! row:     codes of first letters, pairs: (code of the second, space between the two)
//! ```
//!
//! A contour's first point lies on the line. Between two points off it, the one midway is left out, as in TrueType.

use std::sync::LazyLock;

use glam::Vec2;

use crate::base::numbers::Reader;
use crate::base::sort;

static BYTES: [&[u8]; 2] = [include_bytes!("italic.bin"), include_bytes!("roman.bin")];

/// A style of type. Maps name water in italic letters and land in upright ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Face {
    /// EB Garamond Italic.
    #[default]
    Italic,
    /// EB Garamond Roman.
    Roman,
}

/// The number of units of the table to the em.
const EM: f32 = 256.0;
/// How many curves the letters of a face have at most, all together. A carried table may name a shape a thousand times.
const MOST_CURVES: usize = 1 << 16;

/// A quadratic curve that goes on from where the one before ended: its control point and its end. A straight piece has its control point in
/// its middle.
pub type Curve = [Vec2; 2];

/// A letter.
#[derive(Clone, Debug, PartialEq)]
pub struct Glyph {
    /// Its code point.
    pub code: u32,
    /// The code point of the letter without its accent.
    pub base: u32,
    /// The distance from its origin to that of the next letter.
    pub advance: f32,
    /// Its contours: the start of each and its curves, the last of which ends there.
    pub contours: Vec<(Vec2, Vec<Curve>)>,
    /// The upper left corner of the box around all of it, control points included; both corners are the origin if it is empty.
    pub least: Vec2,
    /// The lower right corner of that box.
    pub most: Vec2,
}

/// All letters, by their codes, and the kerning between them.
#[derive(Debug, Default)]
pub struct Typeface {
    glyphs: Vec<Glyph>,
    /// Pairs of base letters with the space between them, in order.
    kerning: Vec<([u32; 2], f32)>,
}

impl Typeface {
    /// Returns the letters of a face.
    pub fn of(face: Face) -> &'static Self {
        static FACES: [LazyLock<Typeface>; 2] = [
            LazyLock::new(|| Typeface::read(&mut table(Face::Italic))),
            LazyLock::new(|| Typeface::read(&mut table(Face::Roman))),
        ];
        &FACES[face as usize]
    }

    /// Returns both faces.
    pub(crate) fn all() -> [&'static Self; 2] {
        [Face::Italic, Face::Roman].map(Self::of)
    }

    /// Returns the letter of a code point; `None` if there is none.
    pub fn glyph(&self, code: u32) -> Option<&Glyph> {
        self.glyphs.binary_search_by_key(&code, |glyph| glyph.code).ok().map(|i| &self.glyphs[i])
    }

    /// Returns the space between two letters that is added to the advance of the first.
    pub fn kerning(&self, first: &Glyph, second: &Glyph) -> f32 {
        let pair = [first.base, second.base];
        self.kerning.binary_search_by_key(&pair, |(pair, _)| *pair).map_or(0.0, |i| self.kerning[i].1)
    }

    /// Returns all letters, by their codes.
    pub fn glyphs(&self) -> &[Glyph] {
        &self.glyphs
    }

    /// Reads the letters of a table, as many as there are, without what is between them.
    pub(crate) fn unspaced(bytes: &mut Reader<'_>) -> Self {
        let Rows { shapes, letters } = Rows::read(bytes);
        let mut left = MOST_CURVES;
        let glyphs = letters.iter().map(|letter| letter.glyph(&shapes, &mut left)).collect();
        Self { glyphs, kerning: Vec::new() }
    }

    /// Reads a table, as far as its bytes go.
    fn read(bytes: &mut Reader<'_>) -> Self {
        let this = Self::unspaced(bytes);
        let rows = bytes
            .list(|bytes| (bytes.list(Reader::whole), bytes.list(|bytes| (bytes.whole(), bytes.signed() as f32 / EM))));
        let pairs = |(firsts, pairs): &(Vec<u32>, Vec<(u32, f32)>)| -> Vec<([u32; 2], f32)> {
            firsts.iter().flat_map(|&first| pairs.iter().map(move |&(second, by)| ([first, second], by))).collect()
        };
        let kerning: Vec<_> = rows.iter().flat_map(pairs).collect();
        // Letters have 16 bits at most.
        let order = sort::argsort(kerning.iter().map(|([first, second], _)| (first << 16) | second));
        let kerning = order.into_iter().map(|i| kerning[i]).collect();
        Self { kerning, ..this }
    }
}

/// Returns the table of a face.
pub(super) fn table(face: Face) -> Reader<'static> {
    Reader::of_bytes(BYTES[face as usize])
}

/// A point of a contour, in units of the table, y up, and whether it lies on the line.
pub(super) type Point = ([i32; 2], bool);

/// The shapes and letters of a table as it has them.
pub(super) struct Rows {
    /// The contours of each shape.
    pub shapes: Vec<Vec<Vec<Point>>>,
    pub letters: Vec<Row>,
}

/// A letter as a table has it.
pub(super) struct Row {
    pub code: u32,
    pub base: u32,
    pub advance: u32,
    /// The numbers of its shapes, and how far each is moved.
    pub parts: Vec<(usize, [i32; 2])>,
}

impl Rows {
    pub fn read(bytes: &mut Reader<'_>) -> Self {
        let shapes = bytes.list(shape);
        let mut code = 0u32;
        let letters = bytes.list(|bytes| {
            code = code.wrapping_add(bytes.whole());
            let (base, advance) = (bytes.whole(), bytes.whole());
            Row { code, base, advance, parts: bytes.list(|bytes| (bytes.whole() as usize, offset(bytes))) }
        });
        Self { shapes, letters }
    }
}

fn offset(bytes: &mut Reader<'_>) -> [i32; 2] {
    [bytes.signed(), bytes.signed()]
}

fn shape(bytes: &mut Reader<'_>) -> Vec<Vec<Point>> {
    let mut at = [0i32; 2];
    bytes.list(|bytes| {
        let count = bytes.whole() as usize;
        let on_line = bytes.answers(count);
        let point = |is_on_line: bool| {
            let by = offset(bytes);
            at = [at[0].wrapping_add(by[0]), at[1].wrapping_add(by[1])];
            (at, is_on_line)
        };
        on_line.into_iter().map(point).collect()
    })
}

impl Row {
    /// Makes the letter of its shapes, of so many curves at most, less those that it has.
    fn glyph(&self, shapes: &[Vec<Vec<Point>>], left: &mut usize) -> Glyph {
        let mut contours = Vec::new();
        for (shape, by) in &self.parts {
            for contour in shapes.get(*shape).into_iter().flatten().filter(|contour| !contour.is_empty()) {
                if contour.len() <= *left {
                    *left -= contour.len();
                    contours.push(curves(contour, *by));
                }
            }
        }
        let points = || contours.iter().flat_map(|(start, curves)| curves.iter().flatten().chain([start]));
        let least = points().copied().reduce(Vec2::min).unwrap_or_default();
        let most = points().copied().reduce(Vec2::max).unwrap_or_default();
        Glyph { code: self.code, base: self.base, advance: self.advance as f32 / EM, contours, least, most }
    }
}

/// Returns the start and the curves of a contour, moved by `by`.
fn curves(contour: &[Point], by: [i32; 2]) -> (Vec2, Vec<Curve>) {
    let place = |i: usize| {
        let at = contour[i % contour.len()].0;
        let [x, y] = [at[0].wrapping_add(by[0]), at[1].wrapping_add(by[1])];
        Vec2::new(x as f32, y.wrapping_neg() as f32) / EM
    };
    let is_on = |i: usize| contour[i % contour.len()].1;
    let (mut curves, mut from) = (Vec::new(), place(0));
    for i in 1..=contour.len() {
        let to = match (is_on(i), is_on(i - 1)) {
            (true, true) => {
                curves.push([(from + place(i)) * 0.5, place(i)]);
                place(i)
            }
            // A control point has its curve once it is known where that ends.
            (false, true) => continue,
            (is_on, false) => {
                let to = if is_on { place(i) } else { (place(i - 1) + place(i)) * 0.5 };
                curves.push([place(i - 1), to]);
                to
            }
        };
        from = to;
    }
    (place(0), curves)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faces() -> [&'static Typeface; 2] {
        [Face::Italic, Face::Roman].map(Typeface::of)
    }

    #[test]
    fn both_faces_have_the_same_letters() {
        let codes = |face: &Typeface| face.glyphs.iter().map(|glyph| glyph.code).collect::<Vec<_>>();
        let [italic, roman] = faces().map(codes);
        assert_eq!(italic, roman);
    }

    #[test]
    fn italic_letters_lean_and_roman_ones_do_not() {
        // The middle of an l's upper half is to the right of that of its lower half by this much.
        let lean = |face: &Typeface| {
            let glyph = face.glyph('l'.into()).unwrap();
            let points = || glyph.contours.iter().flat_map(|(_, curves)| curves.iter().map(|curve| curve[1]));
            let middle = |is_upper: bool| {
                let xs: Vec<f32> = points().filter(|at| (at.y < -0.35) == is_upper).map(|at| at.x).collect();
                xs.iter().sum::<f32>() / xs.len() as f32
            };
            middle(true) - middle(false)
        };
        let [italic, roman] = faces().map(lean);
        assert!(italic > 0.05 && roman.abs() < 0.04, "{italic} {roman}");
    }

    #[test]
    fn all_letters_of_latin_1_and_extended_a_are_there() {
        let face = Typeface::of(Face::Italic);
        let codes = (0x20..0x7f).chain(0xc0..0x180).filter(|code| ![0xd7, 0xf7].contains(code));
        let missing: Vec<u32> = codes.filter(|&code| face.glyph(code).is_none()).collect();
        assert_eq!(missing, [0x149, 0x17f][..0], "{missing:x?}");
        assert!(face.glyph(0x4e2d).is_none() && face.glyph(0).is_none());
    }

    #[test]
    fn letters_are_as_large_as_letters_of_this_face_are() {
        let face = Typeface::of(Face::Italic);
        let [x, capital, p] = ['x', 'H', 'p'].map(|letter| face.glyph(letter.into()).unwrap());
        assert!((x.least.y + 0.41).abs() < 0.03, "x is {} high", -x.least.y);
        assert!((capital.least.y + 0.65).abs() < 0.03, "H is {} high", -capital.least.y);
        assert!(p.most.y > 0.2, "p goes {} down", p.most.y);
        assert!(face.glyph(' '.into()).unwrap().contours.is_empty());
        for glyph in &face.glyphs {
            assert!((0.0..1.5).contains(&glyph.advance), "{glyph:?}");
            assert!(
                glyph.least.cmpge(Vec2::splat(-1.1)).all() && glyph.most.cmple(Vec2::splat(1.3)).all(),
                "{glyph:?}"
            );
        }
    }

    #[test]
    fn contours_are_closed_and_an_accent_is_added_to_its_letter() {
        let face = Typeface::of(Face::Italic);
        let ends = face.glyphs.iter().flat_map(|glyph| &glyph.contours);
        assert!(ends.clone().all(|(start, curves)| curves.last().is_some_and(|curve| curve[1] == *start)));
        assert!(ends.count() > 400);
        let [plain, accented] = ['e', 'é'].map(|letter| face.glyph(letter.into()).unwrap());
        assert_eq!(accented.base, plain.code);
        assert_eq!(accented.contours[..plain.contours.len()], plain.contours);
        assert!(accented.least.y < plain.least.y);
    }

    #[test]
    fn kerning_is_that_of_base_letters() {
        let face = Typeface::of(Face::Italic);
        let between = |a: char, b: char| face.kerning(face.glyph(a.into()).unwrap(), face.glyph(b.into()).unwrap());
        assert!(between('T', 'y') < -0.05 && between('W', 'e') < -0.1 && between('n', 'n') == 0.0);
        assert_eq!(between('T', 'ý'), between('T', 'y'));
        assert!((100..2000).contains(&face.kerning.len()), "{} pairs", face.kerning.len());
    }

    #[test]
    fn what_is_cut_off_reads_as_less_and_never_fails() {
        for (bytes, length) in BYTES.into_iter().flat_map(|bytes| (0..bytes.len()).step_by(7).map(move |n| (bytes, n)))
        {
            let face = Typeface::read(&mut Reader::of_bytes(&bytes[..length]));
            assert!(face.glyphs.len() < 400);
        }
    }
}
