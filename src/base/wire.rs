//! The wire format in which one wasm module hands data to another: numbers of 32 bits. Both are built from one source, so it has no version.

use glam::Vec2;

/// A message as it is written. Lists have their length before them, texts are lists of letters.
#[derive(Debug, Default)]
pub(crate) struct Writer(pub Vec<u32>);

impl Writer {
    #[inline(never)]
    pub fn push(&mut self, data: &[u32]) {
        self.0.extend_from_slice(data);
    }

    pub fn count(&mut self, count: usize) {
        self.push(&[count as u32]);
    }

    pub fn list(&mut self, data: &[u32]) {
        self.count(data.len());
        self.push(data);
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
        points.iter().for_each(|at| self.push(&at.to_array().map(f32::to_bits)));
    }
}

/// The part of a message that has not been read.
#[derive(Debug)]
pub(crate) struct Reader<'a>(pub &'a [u32]);

impl<'a> Reader<'a> {
    pub fn take<const N: usize>(&mut self) -> Option<[u32; N]> {
        self.0.split_off(..N)?.first_chunk().copied()
    }

    pub fn items<const N: usize>(&mut self) -> Option<&'a [[u32; N]]> {
        let [count] = self.take()?;
        Some(self.0.split_off(..(count as usize).checked_mul(N)?)?.as_chunks().0)
    }

    pub fn list(&mut self) -> Option<Vec<u32>> {
        Some(self.items::<1>()?.as_flattened().to_vec())
    }

    pub fn text(&mut self) -> Option<String> {
        self.items::<1>()?.iter().map(|[letter]| char::from_u32(*letter)).collect()
    }

    pub fn numbers(&mut self) -> Option<Vec<f32>> {
        Some(self.items::<1>()?.as_flattened().iter().copied().map(f32::from_bits).collect())
    }

    /// Reads a list of items that have no fixed length.
    pub fn several<T>(&mut self, mut item: impl FnMut(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let [count] = self.take()?;
        (0..count).map(|_| item(self)).collect()
    }

    pub fn points(&mut self) -> Option<Vec<Vec2>> {
        Some(self.items()?.iter().map(|&at| point(at)).collect())
    }
}

/// Reads a point from the bits of its two numbers.
pub(crate) fn point(at: [u32; 2]) -> Vec2 {
    Vec2::from_array(at.map(f32::from_bits))
}
