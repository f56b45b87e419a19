//! The ground in a picture: the share of land in each block of pixels, and the ridges.

/// The resolution at which a picture is looked at.
pub(super) struct Detail {
    /// The greatest number of blocks on a side.
    most_blocks: usize,
    /// `true` if the steps of a picture in two colours are smoothed.
    is_softened: bool,
    /// The smallest area of a ring that is not a speck, as a fraction of the picture's area.
    speck: f32,
}

/// The smallest area of a ring that is not a speck, in most pictures.
pub(in crate::land) const SPECK: f32 = 1e-4;

impl Detail {
    const MOST_BLOCKS_A_SIDE: usize = 2048;
    /// The greatest number of blocks of any picture.
    pub const MOST_BLOCKS: usize = Self::MOST_BLOCKS_A_SIDE.pow(2);

    /// The detail for an outline: finer than the lattice of the coast distances that are made from it.
    pub const OUTLINE: Self = Self { most_blocks: 512, is_softened: true, speck: SPECK };
    /// The detail for a mask: as fine as the cells of land. An islet or a pond of four cells is not a speck.
    pub const MASK: Self = Self { most_blocks: Self::MOST_BLOCKS_A_SIDE, is_softened: false, speck: 4e-6 };
}

/// Blocks of a picture.
pub(super) struct Ground {
    pub columns: usize,
    pub rows: usize,
    /// The share of land in each block: 0 for water to 1 for land.
    pub land: Vec<f32>,
    /// Nonzero for blocks with a ridge.
    pub ridges: Vec<u8>,
    /// The width and height of a block in pixels. The last blocks may be smaller.
    pub block: f32,
    /// The share of pixels that are more land than water.
    pub light: f32,
    /// The smallest area of a ring that is not a speck, as a fraction of the picture's area.
    pub speck: f32,
    width: f32,
    height: f32,
}

impl Ground {
    /// Divides a picture, given as RGBA, into blocks. Neither side may be 0.
    pub fn of(width: usize, height: usize, rgba: &[u8], detail: &Detail) -> Self {
        let block = width.max(height).div_ceil(detail.most_blocks);
        let (columns, rows) = (width.div_ceil(block), height.div_ceil(block));
        let mut sums = vec![Sum::default(); columns * rows];
        let picture = Picture { width, height, rgba };
        for y in 0..height {
            for x in 0..width {
                sums[y / block * columns + x / block].add(picture.kind(x, y));
            }
        }
        // A ridge one pixel wide counts in each block that it crosses.
        let is_ridge = |sum: &Sum| u8::from(sum.ridges > 0 && sum.ridges * 2 >= block as u32);
        let land: Vec<f32> = sums.iter().map(Sum::share).collect();
        Self {
            columns,
            rows,
            land: if detail.is_softened { softened(&land, columns) } else { land },
            ridges: sums.iter().map(is_ridge).collect(),
            block: block as f32,
            light: sums.iter().map(|sum| sum.light).sum::<u32>() as f32 / (width * height) as f32,
            speck: detail.speck,
            width: width as f32,
            height: height as f32,
        }
    }

    /// Makes a ground from blocks without a picture, row by row.
    pub fn of_blocks(columns: usize, land: Vec<f32>, speck: f32) -> Self {
        let rows = land.len() / columns;
        Self {
            columns,
            rows,
            land,
            ridges: Vec::new(),
            block: 1.0,
            light: 1.0,
            speck,
            width: columns as f32,
            height: rows as f32,
        }
    }

    /// Makes a ground from the same blocks with other land, 0 or 1 in each.
    pub fn with_land(&self, land: &[f32]) -> Self {
        Self { land: softened(land, self.columns), ridges: Vec::new(), speck: SPECK, ..*self }
    }

    /// Returns the picture's width divided by its height.
    pub fn aspect(&self) -> f32 {
        self.width / self.height
    }

    /// Returns the middle of a column of blocks, as a fraction of the picture's width. The columns next to the picture
    /// on either side are mirrored, so that its border lies half-way between.
    pub fn across(&self, column: i32) -> f32 {
        middle(column, self.columns as i32, self.block, self.width)
    }

    /// Returns the middle of a row of blocks, as a fraction of the picture's height.
    pub fn down(&self, row: i32) -> f32 {
        middle(row, self.rows as i32, self.block, self.height)
    }
}

fn middle(i: i32, count: i32, block: f32, length: f32) -> f32 {
    let within = |i: i32| (i as f32 * block + ((i + 1) as f32 * block).min(length)) / (2.0 * length);
    match i {
        i if i < 0 => -within(0),
        i if i >= count => 2.0 - within(count - 1),
        i => within(i),
    }
}

#[derive(Clone, Default)]
struct Sum {
    land: f32,
    pixels: u32,
    light: u32,
    ridges: u32,
}

impl Sum {
    fn add(&mut self, kind: Kind) {
        self.pixels += 1;
        let land = match kind {
            Kind::Ground(land) => land,
            Kind::Ridge => 1.0,
        };
        self.ridges += u32::from(matches!(kind, Kind::Ridge));
        self.light += u32::from(land > 0.5);
        self.land += land;
    }

    fn share(&self) -> f32 {
        self.land / self.pixels.max(1) as f32
    }
}

/// The content of a pixel.
enum Kind {
    /// A share of land, from 0 for water to 1 for land.
    Ground(f32),
    /// A ridge on land.
    Ridge,
}

struct Picture<'a> {
    width: usize,
    height: usize,
    rgba: &'a [u8],
}

impl Picture<'_> {
    fn kind(&self, x: usize, y: usize) -> Kind {
        const COLOURED: u8 = 96;
        let [light, colour] = self.light_and_colour(x, y);
        if colour >= COLOURED || ((MID.0..=MID.1).contains(&light) && !self.is_soft_edge(x, y)) {
            Kind::Ridge
        } else {
            Kind::Ground(f32::from(light) / 255.0)
        }
    }

    /// Returns the lightness of a pixel and the difference between its channels, over black.
    fn light_and_colour(&self, x: usize, y: usize) -> [u8; 2] {
        let i = (y * self.width + x) * 4;
        let [r, g, b, a] = [0, 1, 2, 3].map(|channel| u32::from(self.rgba[i + channel]));
        let light = (r * 54 + g * 183 + b * 19) / 256;
        let colour = r.max(g).max(b) - r.min(g).min(b);
        [light, colour].map(|value| (value * a / 255) as u8)
    }

    /// Returns `true` if there is something darker and something lighter than grey nearby: the grey is then an edge
    /// between the two.
    fn is_soft_edge(&self, x: usize, y: usize) -> bool {
        const NEAR: usize = 2;
        let (mut is_dark_near, mut is_light_near) = (false, false);
        for y in y.saturating_sub(NEAR)..(y + NEAR + 1).min(self.height) {
            for x in x.saturating_sub(NEAR)..(x + NEAR + 1).min(self.width) {
                let [light, _] = self.light_and_colour(x, y);
                is_dark_near |= light < MID.0;
                is_light_near |= light > MID.1;
            }
        }
        is_dark_near && is_light_near
    }
}

/// The greys that may be ridges.
const MID: (u8, u8) = (96, 160);

/// Averages each value with its neighbours, weighted 1 2 1 in both directions, to smooth the steps of a picture in two
/// colours.
fn softened(values: &[f32], columns: usize) -> Vec<f32> {
    let rows = values.len() / columns;
    let at = |x: usize, y: usize| values[y * columns + x];
    let along =
        |x: usize, y: usize| (at(x.saturating_sub(1), y) + 2.0 * at(x, y) + at((x + 1).min(columns - 1), y)) / 4.0;
    let both = |x: usize, y: usize| {
        (along(x, y.saturating_sub(1)) + 2.0 * along(x, y) + along(x, (y + 1).min(rows - 1))) / 4.0
    };
    (0..values.len()).map(|i| both(i % columns, i / columns)).collect()
}
