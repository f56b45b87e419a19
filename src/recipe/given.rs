//! What people hand over in place of a link: an address, a link that mail, a chat or HTML damaged on its way, or a word.
//!
//! A canonical link is never changed, and a word never damaged: what a link could hold as it is stays as it is.

use super::country::AUTO;
use super::error::RecipeError;
use super::is_decided;
use super::key::Key;
use super::link::{self, Notice, PRESET, Pairs, split};
use super::parameter::Kind;
use super::preset;

/// The key of the notice that a link was mended.
pub const MENDED: &str = "link";

/// How often a link may have been percent-encoded once more.
const MOST_CODINGS: usize = 3;

/// What somebody handed over, as the names and values of a link.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Given {
    pub(super) pairs: Pairs,
    /// `true` if they stood in an address, which may hold more than a link.
    is_address: bool,
    /// `true` if the text was damaged.
    is_mended: bool,
}

/// Reads any text as names and values for [`link::apply`]: the link in an address, link text, or a word, which is a seed.
/// Also tells what was mended, and what was left out of an address.
///
/// ```
/// use riverseed::recipe::given;
///
/// let (pasted, _) = given::pairs("https://rivers.example/?seed=rimu&land=valley")?;
/// assert_eq!(pasted, given::pairs("seed=rimu&land=valley")?.0);
/// assert_eq!(given::pairs("Why?")?.0, [("seed".into(), "Why?".into())]);
/// # Ok::<(), riverseed::recipe::RecipeError>(())
/// ```
///
/// # Errors
/// If the text is too long.
pub fn pairs(text: &str) -> Result<(Pairs, Vec<Notice>), RecipeError> {
    link::refuse_if_long(text)?;
    let mut given = read(text);
    let notices = given.notice().into_iter().chain(given.leave_out_strangers()).collect();
    Ok((given.pairs, notices))
}

/// Reads any text as [`pairs`] does, and leaves nothing out. Never fails.
pub(super) fn read(text: &str) -> Given {
    let text = text.trim();
    let mut link = without_breaks(text);
    for _ in 0..=MOST_CODINGS {
        if let Some(mut given) = address(&link).or_else(|| known(&link)) {
            given.is_mended |= link != text;
            return given;
        }
        link = decoded(&link);
    }
    unknown(text)
}

/// Returns `true` if a text that should be a word is the address of a map. A word may hold all signs of an address, but it
/// holds no parameter after them.
pub fn is_address(word: &str) -> bool {
    address(&without_breaks(word)).is_some()
}

impl Given {
    /// Leaves out what an address holds besides a link, such as the marks of newsletters, and reports it. In a link it
    /// stays, to be refused: there it is a mistake.
    fn leave_out_strangers(&mut self) -> Vec<Notice> {
        let is_stranger = |(name, _): &mut (String, String)| !is_name(name);
        let strangers = self.pairs.extract_if(.., |pair| self.is_address && is_stranger(pair));
        strangers.map(|(name, _)| link::unknown(&name)).collect()
    }

    /// Returns the notice to give if the text was damaged.
    pub(super) fn notice(&self) -> Option<Notice> {
        let message = "the link was damaged on its way, and has been mended".into();
        self.is_mended.then(|| Notice { key: MENDED.into(), message })
    }

    /// Takes names out of what stands before them, such as `amp;` before `land`, and the last value out of what follows it.
    /// Returns `None` if there is no parameter among the names.
    fn mended(mut self) -> Option<Self> {
        for (name, _) in &mut self.pairs {
            if let Some(plain) = name_at_end(name).filter(|plain| plain != name) {
                *name = plain;
                self.is_mended = true;
            }
        }
        let (name, value) = self.pairs.iter_mut().rfind(|(name, _)| is_name(name))?;
        if let Some(plain) = value_at_start(name, value) {
            *value = plain;
            self.is_mended = true;
        }
        Some(self)
    }
}

/// Reads the link in an address.
#[inline(never)] // as for all functions here that say so: each copy weighs some hundred bytes
fn address(text: &str) -> Option<Given> {
    let (tail, is_whole) = after_host(text)?;
    let link = part_with_link(tail);
    let plain = if is_whole { without_markup(link) } else { link };
    let plain = without_end(plain, is_whole);
    Given { pairs: split(plain), is_address: true, is_mended: plain != link }.mended()
}

/// Reads link text that has the name of a parameter. A value without `=` is none: it is a word.
#[inline(never)]
fn known(text: &str) -> Option<Given> {
    let pairs = if text.contains('=') { split(text) } else { vec![] };
    Given { pairs, ..Given::default() }.mended()
}

/// Reads what has no parameter: a link with a name that there is none of, which others refuse, or else a word.
fn unknown(text: &str) -> Given {
    let is_plain = |name: &str| !name.is_empty() && name.bytes().all(|c| c.is_ascii_lowercase() || c == b'-');
    let query = text.trim_start_matches(BEFORE_LINK);
    let (link, is_address) = match (after_host(text), cut(query, &['='])) {
        (Some((tail, true)), _) => (tail, true),
        (_, Some((name, _))) if is_plain(name) => (query, false),
        _ => ("", false),
    };
    let mut pairs = split(link);
    if link.is_empty() && !text.is_empty() {
        pairs.push((Key::Seed.parameter().name.into(), text.into()));
    }
    Given { pairs, is_address, is_mended: false }
}

/// The signs before the link in an address.
const BEFORE_LINK: &[char] = &['?', '#'];

/// Returns what follows the first `?` or `#` of an address, the last one of several, and whether it has a `://`. Without that
/// the sign stands before the first `=`. Text that begins with a parameter is a link, whatever its values hold.
fn after_host(text: &str) -> Option<(&str, bool)> {
    let (head, _) = cut(text, &['='])?;
    if is_name(head) {
        return None;
    }
    let scheme = text.as_bytes().windows(3).rposition(|signs| signs == b"://");
    let tail = scheme.and_then(|at| text.get(at..)).unwrap_or(text);
    let (host, link) = cut(tail, BEFORE_LINK)?;
    let is_whole = scheme.is_some();
    (is_whole || !host.contains('=')).then_some((link, is_whole))
}

/// Returns the fragment if that holds a link, or else the query. The `#` of `&#38;` begins no fragment.
fn part_with_link(tail: &str) -> &str {
    match cut(tail, &['#']) {
        Some((query, _)) if query.ends_with('&') => tail,
        Some((_, fragment)) if known(fragment).is_some() => fragment,
        Some((query, _)) => query,
        None => tail,
    }
}

/// Ends an address where HTML or Markdown does.
fn without_markup(link: &str) -> &str {
    cut(link, &['"', '<', '>', '`', '|']).map_or(link, |(link, _)| link)
}

/// Leaves out what follows a link in a sentence. A canonical link holds none of these signs but the full stop, which ends no
/// seed at the end of a whole address: there an edition follows the seed.
fn without_end(link: &str, is_whole: bool) -> &str {
    let (_, last) = cut_last(link, &['&']).unwrap_or(("", link));
    let has_stop = is_whole && last.starts_with("seed=");
    let is_open = cut(link, &['(', '[']).is_some();
    let mut signs = vec![' ', ',', ';', '\'', '’', '”', '»', '\u{200b}'];
    signs.extend(has_stop.then_some('.'));
    signs.extend([')', ']'].into_iter().filter(|_| !is_open));
    link.trim_end_matches(&signs[..])
}

/// Returns the parameter at the end of a name that has something in front of it, such as `amp;`.
fn name_at_end(name: &str) -> Option<String> {
    // A blank is none: words may stand before `land=`, and then are a word with it.
    let is_sign = |c: char| !(c.is_ascii_alphanumeric() || "- ".contains(c));
    let plain = name.trim().rsplit(is_sign).next()?.to_ascii_lowercase();
    is_name(&plain).then_some(plain)
}

/// Returns the word or the number at the start of a value that its parameter refuses for what follows it. `None` if it is
/// accepted, if it is text, which may hold anything, or a decimal comma.
fn value_at_start(name: &str, value: &str) -> Option<String> {
    if accepts(name, value) {
        return None;
    }
    let value = value.trim();
    let is_sign = |c: char| !(c.is_ascii_alphanumeric() || "-._".contains(c));
    let (start, rest) = value.split_once(is_sign).unwrap_or((value, ""));
    let is_cut_number = rest.starts_with(|c: char| c.is_ascii_digit());
    let starts = [start, start.trim_end_matches(['.', '_'])];
    starts.into_iter().find(|start| !start.is_empty() && !is_cut_number && accepts(name, start)).map(String::from)
}

/// Returns `true` if a value is right for a parameter, or if it is text.
fn accepts(name: &str, value: &str) -> bool {
    match Key::from_name(name).map(Key::parameter) {
        Some(parameter) => {
            let is_auto = value == AUTO && is_decided(parameter.key);
            is_auto || matches!(parameter.kind, Kind::Text { .. }) || parameter.parse(value).is_ok()
        }
        None => name == PRESET && preset::find(value).is_some(),
    }
}

fn is_name(name: &str) -> bool {
    name == PRESET || Key::from_name(name).is_some()
}

/// Joins the lines into which mail breaks a link, without the marks of a reply.
fn without_breaks(text: &str) -> String {
    let lines = text.trim().split(['\n', '\r', '\t']);
    let mut lines = lines.map(str::trim);
    let first = lines.next().unwrap_or_default();
    let others = lines.map(|line| line.trim_start_matches(['>', ' ']));
    [first].into_iter().chain(others).collect()
}

/// Takes back one percent-encoding of a whole link.
fn decoded(link: &str) -> String {
    let joined = |(name, value): (String, String)| if value.is_empty() { name } else { format!("{name}={value}") };
    split(link).into_iter().map(joined).collect::<Vec<_>>().join("&")
}

/// Returns what stands before and behind the first of some signs.
#[inline(never)]
fn cut<'a>(text: &'a str, signs: &[char]) -> Option<(&'a str, &'a str)> {
    text.split_once(signs)
}

/// Returns what stands before and behind the last of some signs.
#[inline(never)]
fn cut_last<'a>(text: &'a str, signs: &[char]) -> Option<(&'a str, &'a str)> {
    text.rsplit_once(signs)
}

#[cfg(test)]
mod tests;
