//! Checks that several fuzz targets share.

use riverseed::land::trace::{Traced, trace};
use riverseed::recipe::{LONGEST_OUTLINE, Outline, Recipe, link, table::TABLE};

/// Checks that every value of the recipe is in its range, and that its link reads back, strictly and leniently.
pub fn check_recipe(recipe: &Recipe) {
    for parameter in &TABLE {
        assert!(parameter.accepts(recipe.value(parameter.key)), "{}: {recipe:?}", parameter.name);
    }
    let written = link::write(recipe);
    assert_eq!(link::read(&written).as_ref(), Ok(recipe), "{written}");
    assert_eq!(link::read_leniently(&written), (recipe.clone(), vec![]), "{written}");
}

/// Checks that a message is not empty, and is text that can be shown anywhere.
pub fn check_message(message: &str) {
    assert!(!message.is_empty());
    assert!(!message.chars().any(char::is_control), "{message:?}");
}

/// Checks that a picture is traced to an outline that a recipe can hold, or refused with a reason.
pub fn check_trace(width: u32, height: u32, rgba: &[u8]) {
    match trace(width, height, rgba) {
        Ok(Traced { outline, coasts, ridges, aspect, .. }) => {
            let text = outline.to_string();
            assert!(text.len() <= LONGEST_OUTLINE, "{text}");
            assert_eq!(Outline::parse(&text), Ok(outline.clone()));
            assert!(
                !outline.coasts().is_empty() && outline.coasts().len() <= coasts && outline.ridges().len() <= ridges
            );
            assert!((0.25..=4.0).contains(&aspect), "{aspect}");
        }
        Err(error) => check_message(&error.to_string()),
    }
}
