//! Text in HTML: signs that mean something in markup, and signs that turn the direction of what stands after them.

/// Escapes text for quoted attributes and the content of elements, where no template does.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            _ => out.push(sign),
        }
    }
    referenced(&out)
}

/// Writes signs that turn text as references, so that the markup itself reads in its own order. A program reads the same signs.
pub fn referenced(text: &str) -> String {
    replaced(text, |sign| format!("&#x{:x};", u32::from(sign)))
}

/// Writes signs that turn text as `\u{202e}`, so that words and what stands after them read in their own order.
pub fn in_order(text: &str) -> String {
    replaced(text, |sign| sign.escape_unicode().to_string())
}

fn replaced(text: &str, other: impl Fn(char) -> String) -> String {
    text.chars().map(|sign| if turns(sign) { other(sign) } else { sign.into() }).collect()
}

/// Returns `true` for a sign that embeds, overrides or isolates a direction, or ends that. Marks of direction and signs that join
/// letters, which languages need, turn only themselves.
fn turns(sign: char) -> bool {
    matches!(sign, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sign_turns_what_stands_after_it_and_all_others_stay() {
        assert_eq!(escaped("a\u{202e}<b"), "a&#x202e;&lt;b");
        assert_eq!(in_order("a\u{2066}b\u{202c}"), r"a\u{2066}b\u{202c}");
        let others = "\u{1f469}\u{200d}\u{1f467} \u{5d0}\u{200f}! \u{645}\u{200c}";
        assert_eq!((escaped(others), in_order(others)), (others.into(), others.into()));
    }
}
