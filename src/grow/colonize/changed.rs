//! A set of nodes whose attractors have changed: a bitmap, with a bitmap of its words, so that the few members are
//! visited in order without sorting.

/// A set of small numbers that is emptied in ascending order.
#[derive(Clone, Debug, Default)]
pub(super) struct Changed {
    words: Vec<u64>,
    /// Bit `w % 64` of word `w / 64` is set if `words[w]` is not empty.
    summary: Vec<u64>,
}

impl Changed {
    /// Makes room for numbers below `count`.
    pub fn grow(&mut self, count: usize) {
        let words = count.div_ceil(64);
        if words > self.words.len() {
            self.words.resize(words, 0);
            self.summary.resize(words.div_ceil(64), 0);
        }
    }

    /// Adds a number.
    #[inline]
    pub fn insert(&mut self, number: u32) {
        let word = (number / 64) as usize;
        self.words[word] |= 1 << (number % 64);
        self.summary[word / 64] |= 1 << (word % 64);
    }

    /// Moves all numbers to `list` in ascending order, and leaves the set empty.
    pub fn drain_into(&mut self, list: &mut Vec<u32>) {
        list.clear();
        for (s, summary) in self.summary.iter_mut().enumerate() {
            for w in bits(std::mem::take(summary)) {
                let w = s * 64 + w;
                list.extend(bits(std::mem::take(&mut self.words[w])).map(|bit| (w * 64 + bit) as u32));
            }
        }
    }
}

/// Iterates over the positions of the bits that are set, in ascending order.
fn bits(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = word.trailing_zeros();
        (bit < 64).then(|| {
            word &= word - 1;
            bit as usize
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drains_in_order_once() {
        let mut changed = Changed::default();
        changed.grow(100_000);
        let numbers = [99_999, 0, 64, 63, 4096, 4095, 70_000, 64];
        numbers.iter().for_each(|&n| changed.insert(n));
        let mut list = vec![1];
        changed.drain_into(&mut list);
        assert_eq!(list, [0, 63, 64, 4095, 4096, 70_000, 99_999]);
        changed.drain_into(&mut list);
        assert!(list.is_empty());
    }
}
