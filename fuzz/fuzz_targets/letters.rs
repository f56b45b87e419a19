//! Any text is refused as carried letters, or read as letters that can be laid over a map.
#![no_main]

use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;
use riverseed::paint::View;
use riverseed::picture::carried::{Carried, sealed};
use riverseed::{Map, Session};

fuzz_target!(|text: &str| {
    static MAP: OnceLock<Map> = OnceLock::new();
    let map = MAP.get_or_init(|| {
        let recipe = "seed=a&attractors=100".parse().expect("a link");
        Session::new(recipe).and_then(|mut session| session.finish()).expect("a small map")
    });
    for text in [text, &sealed(text)] {
        if let Some(letters) = Carried::read(text) {
            let view = View::new(&map.domain(), 300, 200).expect("a size");
            letters.masks(map, &view, 1.0);
        }
    }
});
