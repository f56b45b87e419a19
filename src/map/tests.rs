//! Promises about finished maps: they are shared, stay as they are, and have an id.

use super::*;
use crate::recipe::link;
use crate::session::Session;

#[test]
fn making_and_cloning_a_map_copies_no_river() {
    let mut session = Session::new(link::read("attractors=300").unwrap()).unwrap();
    let map = session.finish().unwrap();
    let other = session.map().unwrap();
    assert!(Arc::ptr_eq(map.network(), other.network()) && Arc::ptr_eq(map.tree(), other.tree()));
    // The map stays the same, whatever happens to the session.
    let before = map.clone();
    session.change(link::read("attractors=300&width=30").unwrap()).unwrap();
    assert_ne!(session.finish().unwrap().network(), before.network());
    assert_eq!(map, before);
}

#[test]
fn maps_have_one_id_as_long_as_only_the_style_changes() {
    let mut session = Session::new(link::read("attractors=300").unwrap()).unwrap();
    let id = session.finish().unwrap().id();
    let mut changed = |text: &str| {
        session.change(link::read(text).unwrap()).unwrap();
        session.finish().unwrap().id()
    };
    assert_eq!(changed("attractors=300&style=atlas"), id);
    assert_ne!(changed("attractors=300&style=atlas&width=30"), id);
    assert_ne!(changed("attractors=300"), id);
}
