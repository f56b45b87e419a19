//! Ids of SVG files: those that a file refers to end in a number that tells it from other files in the same page.

/// Returns the end of the ids that an SVG file refers to: a hyphen and the file's number.
pub fn end_of_ids(svg: &str) -> String {
    let (_, rest) = svg.split_once("<clipPath id=\"map").unwrap();
    rest[..rest.find('"').unwrap()].to_owned()
}

/// Returns an SVG file with its ids less these ends.
pub fn without_number(svg: &str) -> String {
    let end = end_of_ids(svg);
    assert!(end.len() > 1 && end[1..].bytes().all(|digit| digit.is_ascii_digit()), "{end}");
    svg.replace(&end, "")
}
