//! A hash that is the same on every machine, to compare two things, not to keep anybody from making two alike.

/// A 64-bit FNV-1a hash.
pub(crate) struct Fnv1a(pub u64);

impl Fnv1a {
    /// Returns the hash of nothing.
    pub fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.0 = bytes.iter().fold(self.0, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    }

    /// Adds words, the lowest byte of each first.
    pub fn words(&mut self, words: impl IntoIterator<Item = u32>) {
        words.into_iter().for_each(|word| self.bytes(&word.to_le_bytes()));
    }

    /// Returns half as many bits, which all of them decide.
    pub fn folded(&self) -> u32 {
        (self.0 >> 32) as u32 ^ self.0 as u32
    }
}
