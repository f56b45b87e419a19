//! The tests of the library, in one program: it is linked once, and its tests share both processors to the end.
//!
//! A new file needs its line here.

mod common;

mod architecture;
mod bends;
mod brownian;
mod carried;
mod countries;
mod cut_out;
mod digest;
mod documents;
mod drowned;
mod examples;
mod export;
mod files;
mod fixed_seeds;
mod framing;
mod golden;
mod great_mouths;
mod grown;
mod growth;
mod hypsometry;
mod identity;
mod inner_waters;
mod inspect;
mod label_places;
mod labels;
mod lakes;
mod margins;
mod marks;
mod markup;
mod mask;
mod meanders;
mod mouths;
mod names;
mod names_stay;
mod network;
mod outlines;
mod own_names;
mod painting;
mod patterns;
mod pieces;
mod presets;
mod proof;
mod ranges;
mod rasters;
mod real_sizes;
mod recipes;
mod relief;
mod scenery;
mod schema;
mod shapes;
mod starts;
mod statistics;
mod steady;
mod timeline;
mod trimming;
mod uphill;
mod valleys;
mod work;

/// Cargo would not say so: a file that no program has is not compiled.
#[test]
fn every_file_of_tests_is_in_a_program() {
    let lines: Vec<_> = include_str!("all.rs").lines().collect();
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests")).into_iter().flatten().flatten()
    {
        let name = entry.file_name().to_string_lossy().into_owned();
        let Some(module) = name.strip_suffix(".rs").filter(|module| *module != "all") else {
            continue;
        };
        assert!(lines.contains(&format!("mod {module};").as_str()), "tests/all.rs does not name {module}");
    }
}
