//! Any outline text is refused with a reason, or read into an outline that is written and read back. The land of any
//! outline has a coast that can be measured everywhere.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riverseed::land::Land;
use riverseed::recipe::{Key, Outline, Recipe};
use riverseed_fuzz::{check_message, check_recipe};

fuzz_target!(|text: &str| {
    let outline = match Outline::parse(text) {
        Ok(outline) => outline,
        Err(error) => return check_message(&error.to_string()),
    };
    // Coasts are written before ridges, in whatever order they were read.
    let written = outline.to_string();
    assert_eq!(Outline::parse(&written), Ok(outline), "{written}");
    assert_eq!(written.len(), text.len());
    let mut recipe = Recipe::default();
    recipe.set(Key::Land, "drawn").expect("it is one of the lands");
    recipe.set(Key::Outline, text).expect("it was parsed already");
    check_recipe(&recipe);
    // There is no land if nothing is drawn, or no water, or hardly any land.
    let Some(land) = Land::of(&recipe) else { return };
    for (x, y) in (0..=10).flat_map(|x| (0..=10).map(move |y| (x, y))) {
        let height = land.coast_distance().height((x as f32 * 120.0, y as f32 * 80.0).into());
        assert!(height.is_finite(), "{height} at {x}, {y}");
    }
});
