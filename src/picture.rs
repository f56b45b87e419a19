//! The picture of a session: its pixels, brought up to date by drawing only what is new.

use std::sync::Arc;

use tiny_skia::Pixmap;

#[cfg(feature = "names")]
use crate::chart::{Label, Scenery};
use crate::domain::Domain;
#[cfg(feature = "names")]
use crate::labels::labels;
use crate::land::Land;
use crate::paint::{PaintError, Painted, Painter, Progress, Rect, Rivers};
use crate::recipe::Key;
#[cfg(feature = "names")]
use crate::scenery;
use crate::session::{Generation, Phase, Session};

/// The picture of a session.
///
/// ```
/// use riverseed::{Picture, Session};
///
/// let mut session = Session::new("seed=kauri&curl=0.6".parse()?)?;
/// let mut picture = Picture::new(300, 200)?;
/// while session.advance(10)? {
///     picture.paint(&session); // only what is new
/// }
/// picture.paint(&session);
/// assert_eq!(picture.pixmap().width(), 300);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Picture {
    painter: Painter,
    /// The generation, domain and land of the session that it shows; `None` before it is painted.
    shown: Option<(Generation, Domain, Option<Arc<Land>>)>,
    /// The trimmed tree whose rivers it shows; `None` if it shows none.
    rivers_of: Option<Generation>,
    /// The labels of finished rivers, and the generation that they belong to.
    #[cfg(feature = "names")]
    labels: Option<(Generation, Vec<Label>)>,
    /// Trees and hills, likewise, and whether there are more to come.
    #[cfg(feature = "names")]
    scenery: Option<(Generation, Scenery, bool)>,
}

impl Picture {
    /// An empty picture, with sides in pixels.
    ///
    /// # Errors
    /// If a side is out of range, or there is not enough memory.
    pub fn new(width: u32, height: u32) -> Result<Self, PaintError> {
        Ok(Self {
            painter: Painter::new(&Domain::with_aspect(1.0), width, height)?,
            shown: None,
            rivers_of: None,
            #[cfg(feature = "names")]
            labels: None,
            #[cfg(feature = "names")]
            scenery: None,
        })
    }

    /// Brings the picture up to date with its session, however that has changed. Where their aspects differ, the map's edges
    /// are cut, evenly. Returns the rectangle that changed; `None` if nothing did. While the rivers of a tree are made again,
    /// the picture keeps those that it shows, and while their relief is, the relief.
    pub fn paint(&mut self, session: &Session) -> Option<Rect> {
        loop {
            match self.paint_part(session) {
                Painted::Part => {}
                Painted::Whole(changed) => return changed,
            }
        }
    }

    /// Does a part of that, so that a program can do other work in between: 65,536 pixels of ground, or one of the things that a relief
    /// is painted with. The picture changes with the last part. If the session changes before, another picture is begun.
    pub fn paint_part(&mut self, session: &Session) -> Painted {
        let tree = Some(session.tree_generation());
        let is_kept = match session.phase() {
            Phase::Shaping => true,
            Phase::Relief => self.painter.is_raised(),
            Phase::Growing | Phase::Meandering | Phase::Finished => false,
        };
        if is_kept && self.rivers_of == tree {
            return Painted::Whole(None);
        }
        self.forget_what_is_over(session);
        self.rivers_of = tree.filter(|_| session.network().is_some());
        let (recipe, land) = (session.recipe(), session.land().map(Arc::as_ref));
        let (courses, style) = (recipe.get(), recipe.get());
        #[cfg(feature = "names")]
        if self.place_labels(session) || self.advance_scenery(session) {
            return Painted::Part;
        }
        #[cfg(feature = "names")]
        let labels = self.labels.as_ref().map_or(&[][..], |(_, labels)| labels);
        #[cfg(feature = "names")]
        let scenery = self.scenery.as_ref().map_or(&[][..], |(_, scenery, _)| scenery.placed());
        if let Some(((network, rounds), past)) = session.network().zip(session.rounds()).zip(session.past()) {
            let relief = session.relief().map(|relief| (relief, recipe.number(Key::Shade)));
            return self.painter.paint_rivers(&Rivers {
                network,
                past,
                rounds,
                courses,
                land,
                relief,
                #[cfg(feature = "names")]
                labels,
                #[cfg(feature = "names")]
                scenery,
                style,
            });
        }
        let growth = session.growth();
        Painted::Whole(self.painter.paint(&Progress {
            tree: growth.tree(),
            finished: growth.ending().is_some(),
            trim: session.trim(),
            total_discharge: growth.total_discharge(),
            max_width: recipe.number(Key::Width),
            courses,
            land,
            style,
        }))
    }

    /// Places labels, once for as long as the rivers are the same; none while they change. Returns whether that took time, and scenery
    /// comes next.
    #[cfg(feature = "names")]
    fn place_labels(&mut self, session: &Session) -> bool {
        let generation = session.generation();
        let are_placed = self.labels.as_ref().is_some_and(|(of, _)| *of == generation);
        if !matches!(session.phase(), Phase::Relief | Phase::Finished) {
            self.labels = None;
        } else if !are_placed {
            let placed = labels(session, self.painter.frame(), self.painter.scale());
            let is_long = !placed.is_empty();
            self.labels = Some((generation, placed));
            return is_long;
        }
        false
    }

    /// Places a part of the trees and hills, if there are to be any and they are not placed. Returns whether there is more to do.
    #[cfg(feature = "names")]
    fn advance_scenery(&mut self, session: &Session) -> bool {
        let generation = session.generation();
        if session.phase() != Phase::Finished {
            self.scenery = None;
            return false;
        }
        if self.scenery.as_ref().is_none_or(|(of, ..)| *of != generation) {
            self.scenery = Some((generation, Scenery::default(), true));
        }
        let Some((_, scenery, has_more)) = self.scenery.as_mut().filter(|(.., has_more)| *has_more) else {
            return false;
        };
        let labels = self.labels.as_ref().map_or(&[][..], |(_, labels)| labels);
        *has_more = scenery::input(session, labels).is_some_and(|input| scenery.advance(&input));
        *has_more
    }

    fn forget_what_is_over(&mut self, session: &Session) {
        let now = (session.generation(), session.domain(), session.land().cloned());
        let (is_same, is_on_same_land) = self.shown.as_ref().map_or((false, false), |(generation, domain, land)| {
            (*generation == now.0, *domain == now.1 && is_same(land.as_ref(), now.2.as_ref()))
        });
        if !is_on_same_land {
            self.painter.invalidate_ground(&now.1);
        }
        if !is_same {
            self.painter.reset();
        }
        self.shown = Some(now);
    }

    /// The picture: RGBA, opaque.
    pub fn pixmap(&self) -> &Pixmap {
        self.painter.pixmap()
    }
}

/// Whether land is the very same, shaped once.
fn is_same(land: Option<&Arc<Land>>, other: Option<&Arc<Land>>) -> bool {
    match (land, other) {
        (None, None) => true,
        (Some(land), Some(other)) => Arc::ptr_eq(land, other),
        (None, Some(_)) | (Some(_), None) => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::memory::testing::with_lists_up_to;
    use crate::recipe::link;

    const SMALL: &str = "attractors=300&trim=0&meander=flow&meander-rounds=3";

    fn finished(text: &str) -> Session {
        let mut session = Session::new(link::read(text).unwrap()).unwrap();
        while session.advance(50).unwrap() {}
        session
    }

    fn painted(session: &Session) -> Vec<u8> {
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(session);
        picture.pixmap().data().to_vec()
    }

    #[test]
    fn picture_that_there_is_no_memory_for_is_refused() {
        let refused = with_lists_up_to(2_000_000, || Picture::new(500, 500)).map(drop).unwrap_err();
        assert_eq!(refused, PaintError::OutOfMemory { width: 500, height: 500, megabytes: 12 });
        assert_eq!(Picture::new(0, 70).map(drop).unwrap_err(), PaintError::Size { width: 0, height: 70 });
    }

    #[test]
    fn nothing_is_painted_twice() {
        let session = finished(SMALL);
        let mut picture = Picture::new(100, 80).unwrap();
        assert!(picture.paint(&session).is_some());
        assert_eq!(picture.paint(&session), None);
    }

    #[test]
    fn rivers_stay_in_the_picture_until_there_are_others_of_their_tree() {
        let mut session = finished(SMALL);
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        let before = painted(&session);
        session.change(link::read(&format!("{SMALL}&width=30&style=atlas")).unwrap()).unwrap();
        let mut steps = 0;
        while session.phase() == Phase::Shaping {
            assert_eq!(picture.paint(&session), None);
            assert!(picture.pixmap().data() == before);
            session.advance(1).unwrap();
            steps += 1;
        }
        assert!(steps > 1 && picture.paint(&session).is_some());
        assert!(picture.pixmap().data() == painted(&session), "{steps} steps");
    }

    #[test]
    fn relief_stays_in_the_picture_until_there_is_another_of_its_rivers() {
        let mut session = finished(&format!("{SMALL}&style=atlas"));
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        let before = painted(&session);
        for change in ["mountains=3", "mountains=3&plains=20"] {
            let steps = steps_of_relief(&mut session, change, |session| {
                assert_eq!(picture.paint(session), None, "{change}");
                assert!(picture.pixmap().data() == before, "{change}");
            });
            assert!(steps > 1, "{change}");
        }
        assert!(picture.paint(&session).is_some());
        assert!(picture.pixmap().data() == painted(&session) && picture.pixmap().data() != before);
        // A picture that shows none goes on to the last of the rivers.
        let mut flat = Picture::new(100, 80).unwrap();
        session.change(link::read(&format!("{SMALL}&style=atlas&width=20")).unwrap()).unwrap();
        while session.phase() != Phase::Relief {
            flat.paint(&session);
            session.advance(2).unwrap();
        }
        flat.paint(&session);
        assert!(flat.pixmap().data() == painted(&session));
    }

    /// Changes a session, and looks at it before each step of its relief. Returns how many there are.
    fn steps_of_relief(session: &mut Session, change: &str, mut look: impl FnMut(&Session)) -> u32 {
        session.change(link::read(&format!("{SMALL}&style=atlas&{change}")).unwrap()).unwrap();
        let mut steps = 0;
        while session.phase() == Phase::Relief {
            look(session);
            session.advance(1).unwrap();
            steps += 1;
        }
        steps
    }

    #[test]
    fn whatever_becomes_of_the_session_the_picture_is_that_of_a_fresh_one() {
        let mut session = finished(SMALL);
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        for change in
            ["aspect=0.5", "land=valley", "land=rectangle", "land=rectangle&momentum=0.5", "style=atlas", "width=30"]
        {
            session.change(link::read(&format!("{SMALL}&{change}")).unwrap()).unwrap();
            while session.advance(50).unwrap() {}
            picture.paint(&session);
            assert!(picture.pixmap().data() == painted(&session), "{change}");
        }
        session.restart().unwrap();
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session), "restarted");
        let other = finished(&format!("{SMALL}&seed=rimu&land=rectangle"));
        let mut picture = Picture::new(100, 80).unwrap();
        for session in [finished(&format!("{SMALL}&land=rectangle")), other] {
            picture.paint(&session);
            assert!(picture.pixmap().data() == painted(&session), "another session");
        }
    }
}
