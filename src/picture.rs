//! The picture of a session or of a finished map. It is brought up to date by drawing only what is new.

mod annotator;
#[doc(hidden)]
pub mod builder;
#[doc(hidden)]
pub mod carried;
mod composition;
mod drafts;

use std::num::NonZero;
use std::sync::Arc;

use tiny_skia::Pixmap;

use self::annotator::Annotator;
use self::carried::Lettering;
use crate::domain::Domain;
use crate::land::Land;
use crate::map::{Map, MapId};
use crate::paint::{
    AnnotationMasks, Framing, PaintError, PaintSettings, Painted, Painter, Progress, Rect, Rivers, Scheme, View,
};
use crate::recipe::{Recipe, Style};
use crate::relief::{Relief, ReliefError};
use crate::session::SessionDrafts;
use crate::session::{Generation, Phase, Session};

/// The picture of a session or of a finished map.
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
    /// The source, domain and land of the rivers shown; `None` before the first painting.
    shown: Option<(Source, Domain, Option<Arc<Land>>)>,
    /// The trimmed tree of the rivers shown; `None` if none are shown.
    rivers_of: Option<Generation>,
    /// The annotation laid over a finished map, and the map and style that it belongs to.
    annotation: Option<(AnnotationKey, Arc<AnnotationMasks>)>,
    drafts: SessionDrafts,
    /// The land in a rising sea, with the session and the step of the rise that it belongs to.
    transgression: Option<((Generation, u32), Arc<Land>)>,
    /// The relief on a finer grid than its map's own, for a large picture.
    finer: Option<(MapId, Arc<Relief>)>,
    annotator: Annotator,
}

impl Picture {
    /// Makes an empty picture, with sides in pixels.
    ///
    /// # Errors
    /// Fails if a side is out of range, or if there is not enough memory.
    pub fn new(width: u32, height: u32) -> Result<Self, PaintError> {
        Ok(Self {
            painter: Painter::new(&Domain::with_aspect(1.0), width, height)?,
            shown: None,
            rivers_of: None,
            annotation: None,
            drafts: SessionDrafts::default(),
            transgression: None,
            finer: None,
            annotator: Annotator::default(),
        })
    }

    /// Shows another part of the map or its surroundings; `None` shows the whole map, cut evenly to cover the picture.
    /// An annotation is dropped if the view changes.
    pub fn frame(&mut self, session: &Session, framing: Option<Framing>) {
        let before = *self.view();
        self.painter.frame(&session.domain(), framing);
        if *self.view() != before {
            self.annotation = None;
            self.annotator.begin_anew();
        }
    }

    /// Adapts the picture to a screen with this number of device pixels per CSS pixel. No letter is then smaller than
    /// 11 CSS pixels times the recipe's `label-size`. The ratio is rounded to a quarter and clamped to 0.5-4.
    #[must_use]
    pub fn with_ratio(mut self, ratio: f32) -> Self {
        self.annotator.set_ratio(ratio);
        self.annotation = None;
        self.painter.reset();
        self
    }

    /// Takes letters from elsewhere than from the place that is best for each on this very picture.
    #[doc(hidden)]
    pub fn letter(&mut self, lettering: Lettering) {
        self.annotator.letter(lettering);
        self.annotation = None;
        self.painter.reset();
    }

    /// Returns `true` if a finished session's recipe asks for an annotation that this picture does not have.
    #[doc(hidden)]
    pub fn lacks_annotation(&self, session: &Session) -> bool {
        is_to_be_annotated(session) && !self.has_annotation(AnnotationKey::of(session.map_id(), session.recipe()))
    }

    /// Takes over the letters, and the places of labels, of a picture of another size, which this one replaces.
    #[doc(hidden)]
    #[must_use]
    pub fn in_place_of(mut self, before: Self) -> Self {
        self.annotator.follow(before.annotator);
        self
    }

    /// Brings the picture up to date with its session, however that has changed. If their aspects differ, the map's
    /// edges are cut evenly. Returns the rectangle that changed, or `None` if nothing did. The old rivers stay in the
    /// picture while the rivers of the same tree are made again, and the old relief while the relief is.
    pub fn paint(&mut self, session: &Session) -> Option<Rect> {
        whole(|| self.paint_part(session))
    }

    /// Paints a finished map: the picture that its session would have had. Returns the rectangle that changed, or `None`
    /// if nothing did.
    pub fn paint_map(&mut self, map: &Map) -> Option<Rect> {
        whole(|| self.paint_map_part(map))
    }

    /// Does a part of [`Picture::paint_map`], like [`Picture::paint_part`].
    pub fn paint_map_part(&mut self, map: &Map) -> Painted {
        self.forget_what_is_over(Source::Map(map.id()), map.domain(), map.land());
        self.rivers_of = None;
        let key = AnnotationKey::of(map.id(), map.recipe());
        if self.advance_annotation(key, map.recipe().is_annotated(), || Some(map.clone())) {
            return Painted::Part;
        }
        let relief = self.finer_or(map.id(), map.shown_relief().cloned());
        self.paint_rivers(Rivers {
            network: map.network(),
            distributaries: &map.deltas().distributaries,
            past: map.past(),
            rounds: map.rounds(),
            finished: true,
            land: map.land().map(Arc::as_ref),
            relief: relief.as_ref(),
            lakes: Some(map.lakes()),
            annotation: None,
            settings: PaintSettings::of(map.recipe()),
        })
    }

    /// Does a part of [`Picture::paint`], so that a program can do other work in between: 65,536 pixels of ground, or
    /// one layer of a relief. The picture changes with the last part. If the session changes before that, a new picture
    /// is begun.
    pub fn paint_part(&mut self, session: &Session) -> Painted {
        self.paint_part_with(session, is_to_be_annotated(session))
    }

    /// Does a part of painting a session like [`Picture::paint_part`], but leaves an annotation that is not made yet for later.
    #[doc(hidden)]
    pub fn paint_part_bare(&mut self, session: &Session) -> Painted {
        self.paint_part_with(session, false)
    }

    fn paint_part_with(&mut self, session: &Session, is_annotated: bool) -> Painted {
        let tree = Some(session.tree_generation());
        let is_kept = match session.phase() {
            Phase::Shaping => true,
            Phase::Relief => self.painter.is_raised(),
            Phase::Growing | Phase::Drowning | Phase::Meandering | Phase::Finished => false,
        };
        if is_kept && self.rivers_of == tree && self.is_on_land_of(session) {
            return Painted::Whole(None);
        }
        if self.make_land_in_transgression(session) {
            return Painted::Part;
        }
        let land = self.transgression.as_ref().map(|(_, land)| land).or(session.shown_shore().0).cloned();
        self.forget_what_is_over(Source::Session(session.generation()), session.domain(), land.as_ref());
        self.rivers_of = tree.filter(|_| session.network().is_some());
        let (recipe, land) = (session.recipe(), land.as_deref());
        let key = AnnotationKey::of(session.map_id(), recipe);
        if self.advance_annotation(key, is_annotated, || session.map()) {
            return Painted::Part;
        }
        if let Some(rivers) = rivers_of(session) {
            let (relief, finished) =
                (self.finer_or(session.map_id(), session.relief().cloned()), session.is_finished());
            return self.paint_rivers(Rivers { finished, relief: relief.as_ref(), ..rivers });
        }
        // While the sea rises, each picture has another ground.
        if session.transgression().is_some() && self.painter.lay_ground(land, Scheme::of(recipe)) {
            return Painted::Part;
        }
        let growth = session.growth();
        Painted::Whole(self.painter.paint(&Progress {
            tree: growth.tree(),
            finished: growth.ending().is_some(),
            trim: session.trim(),
            total_discharge: growth.total_discharge(),
            land,
            settings: PaintSettings::of(recipe),
        }))
    }

    /// Makes the land in the sea that is seen rising in a session, or forgets that in an earlier sea. Returns `true` if it
    /// made one.
    fn make_land_in_transgression(&mut self, session: &Session) -> bool {
        let now = session.transgression().map(|transgression| (session.generation(), transgression.step()));
        if self.transgression.as_ref().map(|(of, _)| *of) == now {
            return false;
        }
        self.transgression = now.zip(session.transgression().map(|transgression| transgression.land()));
        self.transgression.is_some()
    }

    /// Solves the relief of a map again for this picture, if its pixels are much smaller than the cells of the map's own
    /// relief, so that the ground of large pictures is as sharp as their lines. The next paint of that map, or of the
    /// session that made it, shows it. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
    pub fn refine(&mut self, map: &Map, threads: NonZero<usize>) -> Result<(), ReliefError> {
        let longer = self.pixmap().width().max(self.pixmap().height());
        let finer = map.relief_for_picture(longer, threads).transpose()?;
        self.finer = finer.map(|relief| (map.id(), Arc::new(relief)));
        Ok(())
    }

    fn finer_or(&self, map: MapId, own: Option<Arc<Relief>>) -> Option<Arc<Relief>> {
        let finer = self.finer.as_ref().filter(|(of, _)| *of == map).map(|(_, relief)| relief.clone());
        own.map(|own| finer.unwrap_or(own))
    }

    /// Paints a part of rivers with the annotation that is there.
    fn paint_rivers(&mut self, rivers: Rivers<'_>) -> Painted {
        let annotation = self.annotation.as_ref().map(|(_, annotation)| annotation);
        self.painter.paint_rivers(&Rivers { annotation, ..rivers })
    }

    fn has_annotation(&self, key: AnnotationKey) -> bool {
        self.annotation.as_ref().is_some_and(|(of, _)| *of == key)
    }

    /// Takes an annotation of the session in its present state, for a picture of this size. The next `paint` shows it, until
    /// the session changes.
    pub fn take_annotation(&mut self, session: &Session, annotation: AnnotationMasks) {
        let key = AnnotationKey::of(session.map_id(), session.recipe());
        self.annotation = Some((key, Arc::new(annotation)));
    }

    /// Returns the share of a finished session's ground that is painted, from 0 to 1. The rest of the painting is short.
    pub fn progress(&self, session: &Session) -> f32 {
        self.painter.progress(Scheme::of(session.recipe()))
    }

    /// Makes the background of a painted picture of this session transparent: the sea in styles with relief and in past
    /// courses, leaving land, rivers and letters; the paper in the line styles ink, dark and skeleton. Colours are not
    /// premultiplied by alpha. The next `paint` restores the background.
    pub fn cut_out(&mut self, session: &Session) {
        self.painter.cut_out(Scheme::of(session.recipe()));
    }

    /// Returns `true` if the picture's ground is that of the session's land.
    fn is_on_land_of(&self, session: &Session) -> bool {
        self.shown.as_ref().is_some_and(|(_, domain, land)| {
            *domain == session.domain() && is_same(land.as_ref(), session.shown_shore().0)
        })
    }

    /// Returns the position of the domain on the picture.
    pub fn view(&self) -> &View {
        self.painter.view()
    }

    /// Drops the annotation of another map. Then does a part of making the annotation of this one, if this build can. Returns
    /// `true` if it did a part.
    fn advance_annotation(&mut self, now: AnnotationKey, is_wanted: bool, map: impl FnOnce() -> Option<Map>) -> bool {
        if !self.has_annotation(now) {
            self.annotation = None;
        }
        if !self.annotator.is_able() || !is_wanted || self.annotation.is_some() {
            return false;
        }
        let Some(map) = map() else { return false };
        let view = *self.view();
        if let Some(letters) = self.annotator.letters(&map, &view) {
            self.annotation = Some((now, Arc::new(letters)));
            return true;
        }
        if !cfg!(feature = "names") {
            return false;
        }
        let annotation = self.annotator.advance(now, &map, &view);
        self.annotation = annotation.map(|annotation| (now, Arc::new(annotation)));
        true
    }

    fn forget_what_is_over(&mut self, source: Source, domain: Domain, land: Option<&Arc<Land>>) {
        let now = (source, domain, land.cloned());
        let (is_same, is_on_same_land) = self.shown.as_ref().map_or((false, false), |(source, domain, land)| {
            (*source == now.0, *domain == now.1 && is_same(land.as_ref(), now.2.as_ref()))
        });
        if !is_on_same_land {
            self.painter.invalidate_ground(&now.1);
        }
        if !is_same {
            self.painter.reset();
        }
        self.shown = Some(now);
    }

    /// Returns the pixels: RGBA, opaque.
    pub fn pixmap(&self) -> &Pixmap {
        self.painter.pixmap()
    }
}

/// Returns the rivers of a session without relief and annotation, as before they are finished; `None` before there are any.
fn rivers_of(session: &Session) -> Option<Rivers<'_>> {
    let (land, distributaries) = session.shown_shore();
    Some(Rivers {
        network: session.network()?,
        distributaries,
        past: session.past()?,
        rounds: session.rounds()?,
        finished: false,
        land: land.map(Arc::as_ref),
        relief: None,
        lakes: session.lakes(),
        annotation: None,
        settings: PaintSettings::of(session.recipe()),
    })
}

/// The session or map that a picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Source {
    Session(Generation),
    Map(MapId),
}

/// Paints part after part. Returns the rectangle that changed.
fn whole(mut paint_part: impl FnMut() -> Painted) -> Option<Rect> {
    loop {
        match paint_part() {
            Painted::Part => {}
            Painted::Whole(changed) => return changed,
        }
    }
}

/// The map and style that an annotation belongs to. Woods, hills and marks of one style do not fit another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct AnnotationKey {
    map: MapId,
    style: Option<Style>,
}

impl AnnotationKey {
    fn of(map: MapId, recipe: &Recipe) -> Self {
        Self { map, style: recipe.annotating_style() }
    }
}

/// Returns `true` if a session is finished and its recipe wants an annotation.
fn is_to_be_annotated(session: &Session) -> bool {
    session.is_finished() && session.recipe().is_annotated()
}

/// Returns `true` if both are the same shared land, or both are `None`.
fn is_same(land: Option<&Arc<Land>>, other: Option<&Arc<Land>>) -> bool {
    match (land, other) {
        (None, None) => true,
        (Some(land), Some(other)) => Arc::ptr_eq(land, other),
        (None, Some(_)) | (Some(_), None) => false,
    }
}

#[cfg(test)]
mod testing {
    use super::Picture;
    use crate::recipe::link;
    use crate::session::Session;

    pub const SMALL: &str = "attractors=300&trim=0&meander=flow&meander-rounds=3&labels=none";

    pub fn finished(text: &str) -> Session {
        let mut session = Session::new(link::read(text).unwrap()).unwrap();
        while session.advance(50).unwrap() {}
        session
    }

    pub fn painted(session: &Session) -> Vec<u8> {
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(session);
        picture.pixmap().data().to_vec()
    }
}

#[cfg(test)]
mod tests;
