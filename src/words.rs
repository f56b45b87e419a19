//! Data as words of 32 bits, in which one wasm module hands it to another. Both are built from one source, so that forms have no version.

use glam::Vec2;

/// Words as they are written. Lists have their length before them, texts are lists of letters.
#[derive(Debug, Default)]
pub(crate) struct Writer(pub Vec<u32>);

impl Writer {
    #[inline(never)]
    pub fn some(&mut self, words: &[u32]) {
        self.0.extend_from_slice(words);
    }

    pub fn count(&mut self, count: usize) {
        self.some(&[count as u32]);
    }

    pub fn list(&mut self, words: &[u32]) {
        self.count(words.len());
        self.some(words);
    }

    pub fn text(&mut self, text: &str) {
        self.count(text.chars().count());
        self.0.extend(text.chars().map(u32::from));
    }

    #[inline(never)]
    pub fn numbers(&mut self, numbers: &[f32]) {
        self.count(numbers.len());
        numbers.iter().for_each(|number| self.0.push(number.to_bits()));
    }

    #[inline(never)]
    pub fn points(&mut self, points: &[Vec2]) {
        self.count(points.len());
        points.iter().for_each(|at| self.some(&at.to_array().map(f32::to_bits)));
    }
}

/// The words that have not been read.
#[derive(Debug)]
pub(crate) struct Reader<'a>(pub &'a [u32]);

impl<'a> Reader<'a> {
    pub fn some<const N: usize>(&mut self) -> Option<[u32; N]> {
        self.0.split_off(..N)?.first_chunk().copied()
    }

    pub fn items<const N: usize>(&mut self) -> Option<&'a [[u32; N]]> {
        let [count] = self.some()?;
        Some(self.0.split_off(..(count as usize).checked_mul(N)?)?.as_chunks().0)
    }

    #[cfg(feature = "names")]
    pub fn list(&mut self) -> Option<Vec<u32>> {
        Some(self.items::<1>()?.as_flattened().to_vec())
    }

    pub fn text(&mut self) -> Option<String> {
        self.items::<1>()?.iter().map(|[letter]| char::from_u32(*letter)).collect()
    }

    pub fn points(&mut self) -> Option<Vec<Vec2>> {
        Some(self.items()?.iter().map(|&at| point(at)).collect())
    }
}

/// A point of two words.
pub(crate) fn point(at: [u32; 2]) -> Vec2 {
    Vec2::from_array(at.map(f32::from_bits))
}
