//! The ground on which glyphs may stand: off the water, the coast, ridges, letters and other glyphs. Tests are exact, and of whole glyphs.

use glam::Vec2;

use super::background::{LAKE, Piece, RIDGE};
use super::banks::Banks;
use super::input::SceneryInput;
use super::letters::Box;
use super::standing::Standing;

/// The least distance of all of a glyph from banks, in units, and of a tree's foot.
pub const FROM_BANKS: f32 = 2.4;
pub const FOOT_FROM_BANKS: f32 = 4.2;
/// The least distance of all of a glyph from the coast, and from letters.
pub const FROM_COAST: f32 = 4.0;
pub const FROM_LETTERS: f32 = 3.0;
/// The least width of great rivers, in units.
pub const GREAT: f32 = 3.0;

/// A disc of the map: its middle and its radius.
pub type Disc = (Vec2, f32);

/// The water, ridges and letters that scenery keeps off.
#[derive(Clone, Debug)]
pub struct FreeGround {
    size: Vec2,
    water: Banks,
    /// Rivers so wide that marshes and rows of trees lie along them.
    great: Banks,
    ridges: Banks,
    letters: Vec<Box>,
}

impl FreeGround {
    /// Gathers the obstacles of a map.
    pub fn new(input: &SceneryInput<'_>) -> Self {
        let mut water = Piece::of_rivers(input.network);
        let great = water.iter().filter(|piece| piece.is_as_wide_as(GREAT)).copied().collect();
        water.extend(Piece::of_lines(LAKE, &input.lakes));
        Self {
            size: input.size,
            great: Banks::new(input.size, great),
            water: Banks::new(input.size, water),
            ridges: Banks::new(input.size, Piece::of_lines(RIDGE, &input.ridges)),
            letters: input.letters.clone(),
        }
    }

    /// Returns the distance of a place from the nearest bank, at most `most`.
    pub fn distance_to_bank(&self, at: Vec2, most: f32) -> f32 {
        self.water.distance(at, most)
    }

    /// Returns the distance of a place from the nearest bank of a great river, at most `most`.
    pub fn distance_to_great_bank(&self, at: Vec2, most: f32) -> f32 {
        self.great.distance(at, most)
    }

    /// Returns the distance of a place from the nearest ridge, at most `most`.
    pub fn distance_to_ridge(&self, at: Vec2, most: f32) -> f32 {
        self.ridges.distance(at, most)
    }

    /// Returns `true` if all of a glyph is clear of water, coast, ridges and letters.
    pub fn is_clear(&self, input: &SceneryInput<'_>, one: &Standing) -> bool {
        // If one disc around all of them is clear of something, they all are.
        let (middle, reach) = one.around();
        let [dry, blank] = [FROM_BANKS, FROM_LETTERS].map(|clear| reach + clear);
        let is_dry_around = self.distance_to_bank(middle, dry) >= dry && self.distance_to_ridge(middle, dry) >= dry;
        let is_near = |letter: &&Box| middle.distance_squared(letter.middle) <= squared(blank + letter.radius());
        let mut near: Vec<&Box> = Vec::new();
        near.extend(self.letters.iter().filter(is_near));
        let is_ashore = |(at, radius): Disc| input.coast().is_none_or(|coast| coast.height(at) >= radius + FROM_COAST);
        let is_dry = |(at, radius): Disc| {
            let clear = radius + FROM_BANKS;
            is_dry_around || self.distance_to_bank(at, clear) >= clear && self.distance_to_ridge(at, clear) >= clear
        };
        let is_blank = |(at, radius): Disc| {
            let clear = radius + FROM_LETTERS;
            let is_far = |letter: &Box| at.distance_squared(letter.middle) > squared(clear + letter.radius());
            near.iter().all(|letter| is_far(letter) || letter.gap([at, at]) > clear)
        };
        one.discs().all(|disc| is_ashore(disc) && is_dry(disc) && is_blank(disc))
    }

    /// Makes an empty index of discs for a map that is `times` times as high as this one.
    pub fn spots(&self, times: f32) -> Spots {
        Spots::new(self.size * Vec2::new(1.0, times))
    }
}

fn squared(x: f32) -> f32 {
    x * x
}

/// Discs, sorted by squares of the map.
#[derive(Clone, Debug)]
pub struct Spots {
    columns: usize,
    squares: Vec<Vec<Disc>>,
    /// The radius of the greatest.
    most: f32,
}

impl Spots {
    /// The side of a square, in units.
    const SQUARE: f32 = 24.0;

    fn new(size: Vec2) -> Self {
        let [columns, rows] = [size.x, size.y].map(|length| (length / Self::SQUARE) as usize + 1);
        Self { columns, squares: vec![Vec::new(); columns * rows], most: 0.0 }
    }

    fn square(&self, at: Vec2) -> [usize; 2] {
        let rows = self.squares.len() / self.columns;
        // A conversion makes 0 of what is below.
        [((at.x / Self::SQUARE) as usize).min(self.columns - 1), ((at.y / Self::SQUARE) as usize).min(rows - 1)]
    }

    /// Adds a disc.
    pub fn add(&mut self, disc: Disc) {
        let [column, row] = self.square(disc.0);
        self.squares[row * self.columns + column].push(disc);
        self.most = self.most.max(disc.1);
    }

    /// Returns `true` if a disc overlaps none of these.
    pub fn is_free(&self, (at, radius): Disc) -> bool {
        let reach = radius + self.most;
        let ([left, top], [right, bottom]) = (self.square(at - reach), self.square(at + reach));
        let is_apart = |other: &Disc| at.distance_squared(other.0) >= squared(radius + other.1);
        (top..=bottom).all(|row| {
            self.squares[row * self.columns + left..=row * self.columns + right].iter().flatten().all(is_apart)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::input::Weather;
    use super::super::shapes::SHAPES;
    use super::*;
    use crate::base::random::Seed;
    use crate::land::CoastDistance;
    use crate::network::{NONE, Network, Place, River, Vertex};

    const SIZE: Vec2 = Vec2::new(200.0, 120.0);
    const STREAM: [Vec2; 2] = [Vec2::new(80.0, 20.0), Vec2::new(110.0, 50.0)];
    const LAKE: [Vec2; 2] = [Vec2::new(70.0, 95.0), Vec2::new(85.0, 90.0)];
    const RIDGE: [Vec2; 2] = [Vec2::new(150.0, 25.0), Vec2::new(155.0, 50.0)];
    const LETTER: Box = Box { middle: Vec2::new(150.0, 90.0), along: Vec2::new(8.0, 4.0), down: Vec2::new(-1.5, 3.0) };

    /// Makes a line of one width.
    fn line(ends: [Vec2; 2], half: f32) -> Vec<Place> {
        ends.map(|at| Place { at, half }).to_vec()
    }

    fn to_segment(at: Vec2, [from, to]: [Vec2; 2]) -> f32 {
        let way = to - from;
        at.distance(from + way * ((at - from).dot(way) / way.length_squared()).clamp(0.0, 1.0))
    }

    fn to_letter(at: Vec2) -> f32 {
        let outside = |half: Vec2| ((at - LETTER.middle).dot(half).abs() / half.length() - half.length()).max(0.0);
        Vec2::new(outside(LETTER.along), outside(LETTER.down)).length()
    }

    /// Measures by how much a glyph is clear of the coast, which lies along x = 20, of the stream, the lake, the ridge and the letter.
    fn rooms(one: &Standing) -> [f32; 5] {
        let rooms = |(at, radius): Disc| {
            let bank = |ends: [Vec2; 2], half: f32| to_segment(at, ends) - half - 2.4 - radius;
            let (coast, letter) = (at.x - 20.0 - 4.0 - radius, to_letter(at) - 3.0 - radius);
            [coast, bank(STREAM, 3.0), bank(LAKE, 5.0), bank(RIDGE, 0.5), letter]
        };
        one.discs()
            .map(rooms)
            .fold([f32::MAX; 5], |least, next| std::array::from_fn(|rule| least[rule].min(next[rule])))
    }

    #[test]
    fn a_glyph_is_clear_where_all_of_it_is_far_enough_from_everything() {
        // Inland by as much as x is over 20.
        let inland = (0..12 * 8).map(|i| (i % 12) as f32 * 20.0 - 20.0).collect();
        let coast = CoastDistance::of_heights(SIZE, 20.0, inland).unwrap();
        let vertex = |at: Vec2| Vertex { at, discharge: 1, left: 3.0, right: 3.0, ..Vertex::default() };
        // A tributary: any other river goes on past its last place.
        let river = River { start: 0, end: 1, junction: 1, parent: NONE, order: 1, magnitude: 1, identity: 0 };
        let network = Network { vertices: STREAM.map(vertex).to_vec(), rivers: vec![river], oxbows: Vec::new() };
        let input = SceneryInput {
            size: SIZE,
            seed: Seed::from_text("kea"),
            woods: 1.0,
            hills: 1.0,
            weather: Weather::even(0.5, 0.5),
            network: &network,
            lakes: vec![line(LAKE, 5.0)],
            ridges: vec![line(RIDGE, 0.5)],
            coast: Some(std::borrow::Cow::Borrowed(&coast)),
            heights: None,
            letters: vec![LETTER],
        };
        let ground = FreeGround::new(&input);
        // For each rule, how many glyphs only that one forbids, and by next to nothing.
        let mut narrowly = [0; 5];
        for (i, shape) in (0..250_000).zip((0..SHAPES.len() as u8).cycle()) {
            let foot = Vec2::new((i as f32 * 0.618_034).fract(), (i as f32 / 250_000.0 * 499.0).fract()) * SIZE;
            let size = 6.2 + 2.6 * (i % 7) as f32 / 6.0;
            let one = Standing { shape, number: 0, foot, size };
            let rooms = rooms(&one);
            let least = rooms.into_iter().fold(f32::MAX, f32::min);
            if least.abs() > 1e-3 {
                let is_clear = ground.is_clear(&input, &one);
                assert_eq!(is_clear, least > 0.0, "{one:?}: {rooms:?}");
            }
            for rule in 0..5 {
                let is_alone = (0..5).all(|other| (rooms[other] < 0.0) == (other == rule));
                narrowly[rule] += usize::from(is_alone && rooms[rule] > -0.1);
            }
        }
        assert!(narrowly.iter().all(|count| *count > 20), "{narrowly:?}");
    }

    #[test]
    fn a_disc_is_free_if_it_overlaps_none_wherever_that_lies() {
        let mut spots = Spots::new(Vec2::new(200.0, 100.0));
        assert!(spots.is_free((Vec2::new(50.0, 50.0), 500.0)));
        spots.add((Vec2::new(23.0, 23.0), 4.0));
        spots.add((Vec2::new(150.0, 90.0), 60.0));
        assert!(spots.is_free((Vec2::new(30.0, 23.0), 3.0)) && !spots.is_free((Vec2::new(30.0, 23.0), 3.1)));
        assert!(!spots.is_free((Vec2::new(95.0, 90.0), 0.0)) && spots.is_free((Vec2::new(89.0, 90.0), 0.5)));
    }
}
