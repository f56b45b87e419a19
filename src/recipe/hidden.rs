//! Characters that are not seen, but change how the text around them is read.

/// Returns `true` if nobody sees a character: control characters, tags, what is no character, and those that separate
/// lines, join or divide letters or turn the direction of writing.
#[inline(never)] // each copy weighs some hundred bytes
pub(crate) fn is_hidden(c: char) -> bool {
    let is_unseen = matches!(c, '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fffd}'..='\u{ffff}' | '\u{e0000}'..='\u{e007f}');
    c.is_control() || is_unseen
}

/// Writes a text with its hidden characters as `\u{202e}`.
pub fn visible(text: &str) -> String {
    text.chars().map(escaped).collect()
}

/// Writes a text as a message quotes it: hidden characters as `\u{202e}`, and cut off where it would fill the screen.
///
/// ```
/// assert_eq!(riverseed::recipe::shown("1.\u{202e}"), r"1.\u{202e}");
/// ```
pub fn shown(text: &str) -> String {
    const MOST: usize = 40;
    let (mut shown, mut room) = (String::new(), MOST);
    for c in text.chars() {
        let escaped = escaped(c);
        let length = escaped.chars().count();
        if length > room {
            shown.push('…');
            break;
        }
        room -= length;
        shown.push_str(&escaped);
    }
    shown
}

fn escaped(c: char) -> String {
    if is_escaped(c) { c.escape_unicode().to_string() } else { c.into() }
}

/// Returns `true` if messages escape a character. The sign that stands for bytes that are no text is hidden in a name,
/// but can be seen.
fn is_escaped(c: char) -> bool {
    is_hidden(c) && c != char::REPLACEMENT_CHARACTER
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_characters_are_quoted_escaped_and_all_others_as_they_are() {
        for c in (0..=0x10_ffff).filter_map(char::from_u32) {
            let shown = shown(&format!("a{c}b"));
            let is_whole = shown == format!("a{c}b");
            assert_eq!(is_whole, !is_escaped(c), "{shown}");
            assert!(is_whole || shown == format!("a\\u{{{:x}}}b", u32::from(c)), "{shown}");
        }
        let bidirectional =
            "\u{61c}\u{200e}\u{200f}\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}";
        assert!(bidirectional.chars().all(is_escaped));
    }

    #[test]
    fn a_long_text_is_cut_off_between_characters() {
        assert_eq!(shown(&"ā".repeat(40)), "ā".repeat(40));
        assert_eq!(shown(&"ā".repeat(41)), format!("{}…", "ā".repeat(40)));
        assert_eq!(shown(&"\u{202e}".repeat(41)), format!("{}…", r"\u{202e}".repeat(5)));
    }
}
