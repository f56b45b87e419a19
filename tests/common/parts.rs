//! Pictures of finished maps that are painted in parts and abandoned for others in between.

use proptest::prelude::*;
use riverseed::paint::Painted;
use riverseed::picture::Picture;
use riverseed::recipe::Recipe;
use riverseed::session::Session;

/// Shows a map by one recipe after the other, each for up to a number of parts of its picture. Checks that nothing is
/// visible before the last part, and that the last picture equals a fresh one. Returns the session and its picture.
pub fn paint_in_parts(
    start: Recipe,
    changes: impl IntoIterator<Item = (Recipe, u32)>,
    picture: impl Fn() -> Picture,
) -> Result<(Session, Picture), TestCaseError> {
    let (mut session, mut kept) = (Session::new(start).unwrap(), picture());
    for (recipe, parts) in changes {
        session.change(recipe).unwrap();
        session.finish().unwrap();
        let before = kept.pixmap().data().to_vec();
        for _ in 0..parts {
            if kept.paint_part(&session) != Painted::Part {
                break;
            }
            prop_assert!(kept.pixmap().data() == before, "a part is not to be seen");
        }
    }
    kept.paint(&session);
    let mut fresh = picture();
    fresh.paint(&session);
    prop_assert!(kept.pixmap().data() == fresh.pixmap().data());
    prop_assert_eq!(kept.paint_part(&session), Painted::Whole(None));
    Ok((session, kept))
}
