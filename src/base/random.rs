//! Random numbers that are the same everywhere: a seed text becomes 64 bits, and each use of chance has its own stream.
//!
//! A stream serves one purpose, so a new use of chance never shifts an old one. Where items are visited in no fixed
//! order (such as growing nodes, for their curl), the random number is a hash of the item, not of the moment at which
//! it is visited: see [`ItemHash`].
//!
//! Sources: FNV-1a (Fowler, Noll, Vo; 64 bit) for text, the SplitMix64 finaliser (Steele, Lea, Flood 2014) for
//! mixing, PCG32 (O'Neill 2014) from `rand_pcg`, which promises stable values.

use fastnoise_lite::{FastNoiseLite, FractalType, NoiseType};
use rand::Rng;
use rand_pcg::Pcg32;

use super::case::small;

/// The 64 bits that represent a seed text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Seed(u64);

/// The purpose of a random stream. The numbers decide every picture: never change one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
pub enum Purpose {
    /// Positions of river mouths.
    Mouths = 1,
    /// Positions of attractors.
    Attractors = 2,
    /// Turns of each node's direction.
    Curl = 3,
    /// The shape of coasts and ridges.
    Land = 4,
    /// Births, order and movement of the particles of a Brownian tree.
    Particles = 5,
    /// Variation of river banks, and places where rivers meander.
    Courses = 6,
    /// Hard and soft ground, and the heights from which valleys are found.
    Ground = 7,
    /// Steepness of hillsides.
    Relief = 8,
    /// The language of names.
    Names = 9,
    /// Positions of trees and hills.
    Scenery = 10,
    /// Channel heads, and the side branches that trimming removes.
    Trimming = 11,
    /// The strike and slope of the country, and its wind.
    Country = 12,
    /// Detail of coasts in large pictures.
    CoastDetail = 13,
    /// The kind of country, and its values.
    Kind = 14,
    /// Places of lakes.
    Lakes = 15,
    /// Sediment of rivers, and the branches of their deltas.
    Deltas = 16,
}

impl Seed {
    /// Hashes a text, in small letters: `Kauri` and `kauri` have one seed. Every text has a seed, even an empty one.
    #[inline(never)] // each copy weighs some hundred bytes
    pub fn from_text(text: &str) -> Self {
        const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
        const PRIME: u64 = 0x0000_0100_0000_01b3;
        let mut fnv1a = OFFSET_BASIS;
        for letter in text.chars() {
            for byte in small(letter).encode_utf8(&mut [0; 4]).bytes() {
                fnv1a = (fnv1a ^ u64::from(byte)).wrapping_mul(PRIME);
            }
        }
        Self(mix(fnv1a))
    }

    /// Returns a sequence of random numbers for one purpose.
    pub fn stream(self, purpose: Purpose) -> Stream {
        Stream(Pcg32::new(self.0, purpose as u64))
    }

    /// Returns random numbers for one purpose, one for each item.
    pub fn item_hash(self, purpose: Purpose) -> ItemHash {
        ItemHash(mix(self.0 ^ (purpose as u64).wrapping_mul(GOLDEN_GAMMA)))
    }

    /// Returns hard and soft ground over the plane, from −1 to 1, hard where it is high. Growth and relief share it.
    #[inline(never)] // each copy weighs three hundred bytes
    pub(crate) fn rock(self, wavelength: f32) -> FastNoiseLite {
        let mut noise = self.noise(Purpose::Ground, 2, 1.0 / wavelength, 4);
        noise.set_fractal_gain(Some(0.6));
        noise
    }

    /// Returns fractal noise over the plane, from −1 to 1. `index` separates uses with the same purpose; `frequency` is
    /// that of the broadest octave and doubles with each further one. Multiplied by [`DEVIATION`], it has a deviation
    /// of about 1.
    #[inline(never)] // each copy weighs three hundred bytes
    pub(crate) fn noise(self, purpose: Purpose, index: u32, frequency: f32, octaves: i32) -> FastNoiseLite {
        let mut noise = FastNoiseLite::with_seed(self.item_hash(purpose).bits([index, 0, 0]) as i32);
        noise.set_noise_type(Some(NoiseType::OpenSimplex2));
        noise.set_fractal_type(Some(FractalType::FBm));
        noise.set_fractal_octaves(Some(octaves));
        noise.set_frequency(Some(frequency));
        noise
    }
}

/// The factor that brings fractal noise from −1 to 1 to a deviation of about 1.
pub(crate) const DEVIATION: f32 = 3.0;

/// A sequence of random numbers.
#[derive(Clone, Debug)]
pub struct Stream(Pcg32);

impl Stream {
    /// Returns the next number, uniform in `[0, 1)`, a multiple of 2⁻²⁴.
    pub fn unit(&mut self) -> f32 {
        unit_from_bits(self.bits())
    }

    /// Returns the next 32 random bits.
    #[inline]
    pub fn bits(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// Returns the next whole number below `end`, or 0 if there is none. Uniform to within `end` in 2³².
    #[inline]
    pub fn below(&mut self, end: u32) -> u32 {
        ((u64::from(self.bits()) * u64::from(end)) >> 32) as u32
    }
}

/// Random numbers by item. An item is identified by three numbers and always has the same random number, however often
/// and in whatever order it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ItemHash(u64);

impl ItemHash {
    /// Returns random numbers for what has a name, one for each item.
    #[inline(never)] // each copy weighs a hundred bytes
    pub fn of(self, name: &str) -> Self {
        Self(mix(self.0 ^ Seed::from_text(name).0))
    }

    /// Returns the number of an item, uniform in `[0, 1)`, a multiple of 2⁻²⁴.
    pub fn unit(self, item: [u32; 3]) -> f32 {
        unit_from_bits(self.bits(item))
    }

    /// Returns the approximately normal deviate of an item, with mean 0 and deviation 1, from −3.5 to 3.5: the sum of
    /// four random numbers (Irwin and Hall).
    #[inline(never)] // each copy weighs a hundred bytes
    pub fn normal(self, item: [u32; 3]) -> f32 {
        const OF_BYTES: f32 = 147.8;
        let sum: u32 = self.bits(item).to_be_bytes().into_iter().map(u32::from).sum();
        (sum as f32 - 510.0) / OF_BYTES
    }

    /// Returns the 32 random bits of an item.
    #[inline]
    pub fn bits(self, [a, b, c]: [u32; 3]) -> u32 {
        bits_of(self.0, a, b, c)
    }
}

/// Mixes a hash with an item's three numbers. Four numbers are handed over in less code than a list of three.
#[inline(never)] // each copy weighs two hundred bytes
fn bits_of(hash: u64, a: u32, b: u32, c: u32) -> u32 {
    let hash = mix(hash ^ (u64::from(a) << 32 | u64::from(b)));
    (mix(hash ^ u64::from(c)) >> 32) as u32
}

const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// Mixes bits as the finaliser of SplitMix64 does, after one step of its counter.
fn mix(bits: u64) -> u64 {
    let z = bits.wrapping_add(GOLDEN_GAMMA);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Returns the upper 24 bits as a fraction: exact in `f32`, and never 1.
fn unit_from_bits(bits: u32) -> f32 {
    const TWO_POW_MINUS_24: f32 = 1.0 / 16_777_216.0;
    (bits >> 8) as f32 * TWO_POW_MINUS_24
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_of_a_word_never_changes() {
        assert_eq!(Seed::from_text("kauri"), Seed(10_438_155_951_948_749_760));
    }

    #[test]
    fn streams_of_one_seed_are_unlike() {
        let seed = Seed::from_text("kauri");
        let (mut a, mut b) = (seed.stream(Purpose::Mouths), seed.stream(Purpose::Attractors));
        assert!((0..8).any(|_| a.unit() != b.unit()));
    }

    #[test]
    fn neighbouring_items_have_evenly_spread_numbers() {
        let hash = Seed::from_text("kauri").item_hash(Purpose::Curl);
        let mut tenths = [0; 10];
        for i in 0..10_000 {
            tenths[(hash.unit([i / 100, i % 100, 7]) * 10.0) as usize] += 1;
        }
        assert!(tenths.iter().all(|&n| (900..1100).contains(&n)), "{tenths:?}");
    }
}
