//! Texts of rows, cut at a sign.

/// The parts of a text between the places of a sign. (One function cuts all rows: each of the library's, for each kind of sign, weighs
/// some hundred bytes of a page's download.)
pub(in crate::recipe) struct Parts {
    rest: Option<&'static str>,
    sign: u8,
}

impl Parts {
    /// Begins to cut a text.
    pub fn of(text: &'static str, sign: u8) -> Self {
        Self { rest: Some(text), sign }
    }

    /// Cuts a text once: what stands before the sign, and what stands behind it.
    #[inline(never)]
    pub fn cut(text: &'static str, sign: u8) -> (&'static str, Option<&'static str>) {
        let mut parts = Self::of(text, sign);
        (parts.next().unwrap_or_default(), parts.rest)
    }
}

impl Iterator for Parts {
    type Item = &'static str;

    #[inline(never)]
    fn next(&mut self) -> Option<&'static str> {
        let rest = self.rest?;
        let end = rest.bytes().position(|byte| byte == self.sign);
        self.rest = end.and_then(|end| rest.get(end + 1..));
        rest.get(..end.unwrap_or(rest.len()))
    }
}
