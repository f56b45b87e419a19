//! Tables of some letters of a face, for what carries its own type.

use std::collections::BTreeSet;

use super::table::{Face, Point, Row, Rows, table};
use crate::base::numbers::Writer;

/// Writes a table of the letters of a face that have these codes, without what is between them.
pub(crate) fn write_subset(writer: &mut Writer, face: Face, codes: &BTreeSet<u32>) {
    let Rows { shapes, letters } = Rows::read(&mut table(face));
    let letters: Vec<Row> = letters.into_iter().filter(|letter| codes.contains(&letter.code)).collect();
    let used: BTreeSet<usize> =
        letters.iter().flat_map(|letter| letter.parts.iter().map(|(shape, _)| *shape)).collect();
    let used: Vec<usize> = used.into_iter().collect();
    writer.list(&used, |writer, shape| write_shape(writer, &shapes[*shape]));
    let mut before = 0;
    writer.list(&letters, |writer, Row { code, base, advance, parts }| {
        [code - before, *base, *advance].into_iter().for_each(|number| writer.whole(number));
        before = *code;
        writer.list(parts, |writer, (shape, by)| {
            writer.whole(used.partition_point(|used| used < shape) as u32);
            by.iter().for_each(|by| writer.signed(*by));
        });
    });
}

fn write_shape(writer: &mut Writer, contours: &[Vec<Point>]) {
    let mut before = [0; 2];
    writer.list(contours, |writer, contour| {
        writer.whole(contour.len() as u32);
        let on_line: Vec<bool> = contour.iter().map(|(_, is_on_line)| *is_on_line).collect();
        writer.answers(&on_line);
        for (at, _) in contour {
            [0, 1].into_iter().for_each(|axis| writer.signed(at[axis] - before[axis]));
            before = *at;
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::annotate::glyph::Typeface;
    use crate::base::numbers::Reader;

    #[test]
    fn letters_of_a_subset_are_those_of_the_face() {
        for face in [Face::Italic, Face::Roman] {
            for text in ["", "a", "Älvé fjörð 0123", "ŐőžZ"] {
                let codes: BTreeSet<u32> = text.chars().map(u32::from).collect();
                let mut writer = Writer::default();
                write_subset(&mut writer, face, &codes);
                let subset = Typeface::unspaced(&mut Reader::of_text(&writer.0).unwrap());
                let expected: Vec<_> = codes.iter().filter_map(|code| Typeface::of(face).glyph(*code)).collect();
                assert_eq!(subset.glyphs().iter().collect::<Vec<_>>(), expected, "{text}");
                assert_eq!(expected.len(), codes.len());
            }
        }
    }
}
