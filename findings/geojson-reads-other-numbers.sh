#!/usr/bin/env bash
# Of the coordinates in a GeoJSON file, the crate of that name reads one in eight as another number than was written.
#
# Version:  geojson 1.0.0 with serde_json 1.0.154, Rust 1.95.
# Input:    100,000 longitudes as Rust prints them: the shortest text that is one 64-bit float and no other.
# Guess:    reading is the inverse of writing; every language's own parser does that.
# Seen:     some 12,000 of them come back as the float beside theirs. serde_json parses faster than exactly unless its feature `float_roundtrip` is on;
#           geojson neither turns it on nor says that it does not. With the feature, turned on by whoever uses geojson, none is off.
# So:       shared borders still meet, as the same text is always the same float; but a file that is read and written again differs, and so does
#           what is compared with the numbers that it was written from.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export CARGO_TARGET_DIR=$folder/target
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "numbers"
version = "0.0.0"
edition = "2024"

[dependencies]
geojson = "=1.0.0"
serde_json = "=1.0.154"

[features]
exact = ["serde_json/float_roundtrip"]

[workspace]
TOML
cat > src/main.rs <<'RUST'
use geojson::{GeoJson, GeometryValue};

fn main() {
    let mut state = 7u64;
    let mut longitude = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 360.0 - 180.0
    };
    let is_read = |x: &f64| {
        let text = format!(r#"{{"type":"Point","coordinates":[{x},0]}}"#);
        let Ok(GeoJson::Geometry(point)) = text.parse() else { panic!("not read") };
        matches!(point.value, GeometryValue::Point { coordinates } if coordinates[0] == *x)
    };
    let others = (0..100_000).map(|_| longitude()).filter(|x| !is_read(x)).count();
    let is_exact = cfg!(feature = "exact");
    println!("{others} of 100000 are read as another number, float_roundtrip: {is_exact}");
    assert!(if is_exact { others == 0 } else { (10_000..14_000).contains(&others) }, "this has changed");
}
RUST
cargo run --quiet
cargo run --quiet --features exact
