#!/usr/bin/env bash
# A union of two lands that do not touch moves their corners, the farther apart they lie the more, and in the end returns nothing at all.
#
# Version:  geo 0.33.1 with i_overlay 4.5.2, Rust 1.95.
# Input:    a pond of 0.3 by 0.3 with a corner at (0.1, 0.2), and another shape of 1 by 1 at 5,000, at 1e6 or at 1e10, both in 64-bit floats.
# Guess:    corners that take no part in a crossing come back to the bit, as from polyclip-ts 0.16.8 and Shapely 2.2.0 with the same input.
# Seen:     all corners are rounded to a grid of 2^-30 or so of what both shapes span: with the shape at 5,000 the pond's corner is at 0.10000..., with
#           that at 1e6 it is somewhere else, by up to a thousandth, and with that at 1e10 the result has no polygon: both are gone, without an error.
# So:       two unions with different partners no longer share the border that their inputs shared. Unite what lies near, or compare with a
#           tolerance of the whole map's size; do not join neighbours of which each was made by a union of its own.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export CARGO_TARGET_DIR=$folder/target
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "union"
version = "0.0.0"
edition = "2024"

[dependencies]
geo = { version = "=0.33.1", default-features = false }
i_overlay = "=4.5.2"

[workspace]
TOML
cat > src/main.rs <<'RUST'
use geo::{Area, BooleanOps, Polygon, polygon};

fn square(x: f64, y: f64, side: f64) -> Polygon {
    polygon![(x: x, y: y), (x: x + side, y: y), (x: x + side, y: y + side), (x: x, y: y + side)]
}

fn main() {
    let mut corners = Vec::new();
    for far in [5e3, 1e6, 1e10] {
        let both = square(0.1, 0.2, 0.3).union(&square(far, far, 1.0));
        let all = both.0.iter().flat_map(|polygon| polygon.exterior().0.clone());
        let nearest = all.min_by(|a, b| (a.x + a.y).total_cmp(&(b.x + b.y)));
        println!("other at {far:e}: {} polygons, area {} of 1.09, nearest corner {nearest:?}", both.0.len(), both.unsigned_area());
        corners.extend(nearest);
    }
    let moved = |corner: &geo::Coord| (corner.x, corner.y) != (0.1, 0.2) && (corner.x - 0.1).abs() < 1e-2;
    assert!(corners.len() == 2 && corners.iter().all(moved) && corners[0] != corners[1], "this has changed");
}
RUST
cargo run --quiet
