//! Texts in XML.

/// Escapes a text for an element or an attribute. Links are ASCII, but titles and names are anybody's: what XML has no
/// place for, such as a NUL, becomes a space.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&apos;",
            '\t' | '\n' => out.push(letter),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push(' '),
            letter => out.push(letter),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn any_text_is_one_element_without_markup() {
        for text in ["<b>\"'../../x", "a & b", "nul\0bell\u{7}end\u{ffff}", "]]>", "<!-- -->", "\u{202e}right"] {
            let xml = format!("<x a=\"{0}\">{0}</x>", escaped(text));
            let document = roxmltree::Document::parse(&xml).unwrap();
            assert!(document.root_element().children().all(|node| node.is_text()), "{text:?}");
            if !text.contains('\0') {
                assert_eq!(document.root_element().attribute("a"), Some(text));
            }
        }
    }
}
