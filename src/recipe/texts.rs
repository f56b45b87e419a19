//! Labels and help texts, which a build without the feature `texts` does not carry.

/// Returns a text for people, or an empty one in a build without texts.
pub(super) const fn explained(text: &'static str) -> &'static str {
    if cfg!(feature = "texts") { text } else { "" }
}

/// A text that is put together while the crate is compiled. One that is too long does not compile.
pub(super) struct Written {
    bytes: [u8; 256],
    length: usize,
}

impl Written {
    pub const fn new() -> Self {
        Self { bytes: [0; 256], length: 0 }
    }

    /// Appends a text.
    pub const fn and(mut self, text: &str) -> Self {
        let mut i = 0;
        while i < text.len() {
            self.bytes[self.length] = text.as_bytes()[i];
            (self.length, i) = (self.length + 1, i + 1);
        }
        self
    }

    /// Appends an item of an enumeration of so many, with what stands before it: "one, two and three".
    pub const fn and_item(self, i: usize, count: usize, item: &str) -> Self {
        let before = match i {
            0 => "",
            _ if i + 1 == count => " and ",
            _ => ", ",
        };
        self.and(before).and(item)
    }

    pub const fn text(&self) -> &str {
        match str::from_utf8(self.bytes.split_at(self.length).0) {
            Ok(text) => text,
            Err(_) => "", // never: it is made of whole texts
        }
    }
}
