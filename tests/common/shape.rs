//! Measures of the shape of an island, the same for a grown and for a real one.
#![allow(dead_code, reason = "each test file uses its own part")]

use riverseed::Land;
use riverseed::glam::Vec2;

/// Land and water on squares, row by row.
pub struct Raster {
    pub is_land: Vec<bool>,
    pub columns: usize,
    pub rows: usize,
    /// The side of a square, in units.
    pub side: f32,
}

/// The shape of an island. Real ones, 25 of the GSHHS shorelines from Madagascar to Skye, have a median box of 0.51
/// (0.31 to 0.67), solidity not measured here, coast 2.63 (1.5 to 4.8), peninsulas 0.144 (0.03 to 0.32), bays 0.060
/// (0 to 0.19).
#[derive(Clone, Copy, Debug)]
pub struct Measures {
    /// The area, in square units.
    pub area: f32,
    /// The area as a share of that of the smallest turned rectangle around it.
    pub boxed: f32,
    /// The length of the coast by a ruler of √area / 60 over that of a circle of the same area.
    pub coast: f32,
    /// The share of the land that an opening by a disc of radius √area / 12 removes.
    pub peninsulas: f32,
    /// The land that a closing by the same disc adds, as a share of the area.
    pub bays: f32,
}

impl Raster {
    /// The land of a map, on a raster of so many columns.
    pub fn of(land: &Land, columns: usize) -> Self {
        let side = land.size().x / columns as f32;
        let rows = (land.size().y / side) as usize;
        let at = |i: usize| (Vec2::new((i % columns) as f32, (i / columns) as f32) + 0.5) * side;
        let is_land = (0..columns * rows).map(|i| land.coast_distance().height(at(i)) > 0.0).collect();
        Self { is_land, columns, rows, side }
    }

    /// The islands, as lists of squares, the largest first.
    pub fn islands(&self) -> Vec<Vec<usize>> {
        let (mut seen, mut islands) = (vec![false; self.is_land.len()], Vec::new());
        for start in 0..self.is_land.len() {
            let (mut island, mut next) = (Vec::new(), vec![start]);
            while let Some(i) = next.pop() {
                if !self.is_land[i] || std::mem::replace(&mut seen[i], true) {
                    continue;
                }
                island.push(i);
                let (column, row) = (i % self.columns, i / self.columns);
                next.extend((column > 0).then(|| i - 1));
                next.extend((column + 1 < self.columns).then(|| i + 1));
                next.extend((row > 0).then(|| i - self.columns));
                next.extend((row + 1 < self.rows).then(|| i + self.columns));
            }
            islands.extend((!island.is_empty()).then_some(island));
        }
        islands.sort_by_key(|island| std::cmp::Reverse(island.len()));
        islands
    }

    /// The largest island alone, in water as wide as a disc of an opening, its lakes filled.
    pub fn main_island(&self) -> Self {
        let island = self.islands().swap_remove(0);
        let rim = (island.len() as f32).sqrt() as usize / 6 + 3;
        let (west, east) = min_max(island.iter().map(|i| i % self.columns));
        let (north, south) = min_max(island.iter().map(|i| i / self.columns));
        let (columns, rows) = (east - west + 1 + 2 * rim, south - north + 1 + 2 * rim);
        let mut is_land = vec![false; columns * rows];
        for i in island {
            is_land[(i / self.columns - north + rim) * columns + i % self.columns - west + rim] = true;
        }
        let mut sea = Self { is_land: is_land.iter().map(|land| !land).collect(), columns, rows, side: self.side };
        let around = sea.islands().swap_remove(0);
        sea.is_land.fill(true);
        around.into_iter().for_each(|i| sea.is_land[i] = false);
        sea
    }

    /// The area of the only island of a raster as a share of that of its convex hull.
    pub fn fullness(&self) -> f32 {
        let mut corners = self.outline();
        corners.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        // The lower and the upper chain (Andrew 1979).
        let chain = |corners: &mut dyn Iterator<Item = Vec2>| {
            let mut chain: Vec<Vec2> = Vec::new();
            for at in corners {
                while let [.., before, last] = chain[..]
                    && (last - before).perp_dot(at - last) <= 0.0
                {
                    chain.pop();
                }
                chain.push(at);
            }
            chain
        };
        let hull = [chain(&mut corners.iter().copied()), chain(&mut corners.iter().rev().copied())].concat();
        let twice: f32 = hull.iter().zip(hull.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum();
        self.is_land.iter().filter(|&&land| land).count() as f32 / (twice.abs() / 2.0)
    }

    /// The length of the only island of a raster over its breadth: of a rectangle, the ratio of its sides.
    pub fn elongation(&self) -> f32 {
        let squares = (0..self.is_land.len()).filter(|&i| self.is_land[i]);
        let at: Vec<Vec2> = squares.map(|i| Vec2::new((i % self.columns) as f32, (i / self.columns) as f32)).collect();
        let middle = at.iter().sum::<Vec2>() / at.len() as f32;
        let off = at.iter().map(|at| *at - middle);
        let [xx, xy, yy] =
            off.fold([0.0, 0.0, 0.0], |[xx, xy, yy], off| [xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y]);
        // The greater and the lesser of the moments about the axes of the island.
        let (mean, half) = ((xx + yy) / 2.0, (xx - yy) / 2.0);
        let apart = (half * half + xy * xy).sqrt();
        ((mean + apart) / (mean - apart)).sqrt()
    }

    /// The measures of the only island of a raster.
    pub fn measures(&self) -> Measures {
        let squares = self.is_land.iter().filter(|&&land| land).count() as f32;
        let size = squares.sqrt();
        let outline = self.outline();
        let radius = size / 12.0;
        let opened = self.eroded(radius).dilated(radius);
        let closed = self.dilated(radius).eroded(radius);
        let differing =
            |other: &Self| self.is_land.iter().zip(&other.is_land).filter(|(a, b)| a != b).count() as f32 / squares;
        Measures {
            area: squares * self.side * self.side,
            boxed: squares / smallest_box(&outline),
            coast: ruled(&outline, size / 60.0) / (2.0 * (std::f32::consts::PI * squares).sqrt()),
            peninsulas: differing(&opened),
            bays: differing(&closed),
        }
    }

    /// The border of the only island, from corner to corner of squares, clockwise.
    fn outline(&self) -> Vec<Vec2> {
        const WAYS: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
        let land = |x: i32, y: i32| {
            let inside = (0..self.columns as i32).contains(&x) && (0..self.rows as i32).contains(&y);
            inside && self.is_land[y as usize * self.columns + x as usize]
        };
        let first = self.is_land.iter().position(|&land| land).unwrap_or(0);
        let start = ((first % self.columns) as i32, (first / self.columns) as i32);
        let (mut at, mut way, mut line) = (start, 0_usize, Vec::new());
        loop {
            line.push(Vec2::new(at.0 as f32, at.1 as f32));
            at = (at.0 + WAYS[way].0, at.1 + WAYS[way].1);
            // The squares ahead, to the left and to the right.
            let (left, right) = match way {
                0 => ((0, -1), (0, 0)),
                1 => ((0, 0), (-1, 0)),
                2 => ((-1, 0), (-1, -1)),
                _ => ((-1, -1), (0, -1)),
            };
            let is_land = |(x, y): (i32, i32)| land(at.0 + x, at.1 + y);
            way = match (is_land(left), is_land(right)) {
                (false, true) => way,
                (_, false) => (way + 1) % 4,
                (true, true) => (way + 3) % 4,
            };
            if at == start && way == 0 {
                return line;
            }
        }
    }

    fn eroded(&self, radius: f32) -> Self {
        let water: Vec<bool> = self.is_land.iter().map(|land| !land).collect();
        self.with(self.squared_distances(&water).into_iter().map(|squared| squared > radius * radius).collect())
    }

    fn dilated(&self, radius: f32) -> Self {
        self.with(self.squared_distances(&self.is_land).into_iter().map(|d| d <= radius * radius).collect())
    }

    fn with(&self, is_land: Vec<bool>) -> Self {
        Self { is_land, columns: self.columns, rows: self.rows, side: self.side }
    }

    /// The squared distance of each square from the nearest of some, exactly (Felzenszwalb and Huttenlocher 2012).
    fn squared_distances(&self, from: &[bool]) -> Vec<f32> {
        let mut squared: Vec<f32> = from.iter().map(|&is| if is { 0.0 } else { 1e12 }).collect();
        for column in 0..self.columns {
            let line: Vec<f32> = (0..self.rows).map(|row| squared[row * self.columns + column]).collect();
            for (row, value) in lower_envelope(&line).into_iter().enumerate() {
                squared[row * self.columns + column] = value;
            }
        }
        squared.chunks(self.columns).flat_map(lower_envelope).collect()
    }
}

fn min_max(values: impl Iterator<Item = usize>) -> (usize, usize) {
    values.fold((usize::MAX, 0), |(least, most), value| (least.min(value), most.max(value)))
}

/// The lower envelope of parabolas that stand on the values of a line.
fn lower_envelope(values: &[f32]) -> Vec<f32> {
    let meets = |q: usize, p: usize| {
        let [value, other] = [q, p].map(|i| f64::from(values[i]) + (i * i) as f64);
        (value - other) / (2.0 * (q as f64 - p as f64))
    };
    let mut feet: Vec<(usize, f64)> = vec![(0, f64::NEG_INFINITY)];
    for q in 1..values.len() {
        while feet.last().is_some_and(|&(foot, from)| meets(q, foot) <= from) {
            feet.pop();
        }
        let from = feet.last().map_or(f64::NEG_INFINITY, |&(foot, _)| meets(q, foot));
        feet.push((q, from));
    }
    let mut k = 0;
    let value = |q: usize| {
        while feet.get(k + 1).is_some_and(|&(_, from)| from < q as f64) {
            k += 1;
        }
        let off = q as f32 - feet[k].0 as f32;
        off * off + values[feet[k].0]
    };
    (0..values.len()).map(value).collect()
}

/// The area of the smallest rectangle, turned in any direction, around points.
fn smallest_box(points: &[Vec2]) -> f32 {
    let area = |degree: u32| {
        let angle = (degree as f32).to_radians();
        let way = Vec2::new(libm::cosf(angle), libm::sinf(angle));
        let width = |way: Vec2| {
            let (least, most) =
                points.iter().map(|at| at.dot(way)).fold((f32::MAX, f32::MIN), |(a, b), x| (a.min(x), b.max(x)));
            most - least
        };
        width(way) * width(way.perp())
    };
    (0..90).map(area).fold(f32::MAX, f32::min)
}

/// The length of a closed line by a ruler: steps of this length from point to point (Richardson 1961).
fn ruled(line: &[Vec2], ruler: f32) -> f32 {
    let (mut at, mut length) = (line[0], 0.0);
    for &next in line {
        let step = at.distance(next);
        if step >= ruler {
            length += step;
            at = next;
        }
    }
    length + at.distance(line[0])
}

/// The slope of sizes over ranks, largest first, both as logarithms, by least squares: about −1 to −1.6 for the islands
/// of real archipelagos (Korčak's law).
pub fn rank_slope(sizes: &[f32]) -> f32 {
    let points = (1..).zip(sizes).map(|(rank, size)| (libm::logf(rank as f32), libm::logf(*size)));
    let (count, sums) = points
        .fold((0.0, [0.0; 4]), |(count, [x, y, xx, xy]), (a, b)| (count + 1.0, [x + a, y + b, xx + a * a, xy + a * b]));
    let [x, y, xx, xy]: [f32; 4] = sums;
    (count * xy - x * y) / (count * xx - x * x)
}
