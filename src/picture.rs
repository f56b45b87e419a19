//! The picture of a session: its pixels, brought up to date by drawing only what is new.

use std::sync::Arc;

use tiny_skia::Pixmap;

#[cfg(feature = "names")]
use crate::chart_builder::ChartBuilder;
use crate::domain::Domain;
use crate::land::Land;
use crate::paint::{ChartMasks, Framing, PaintError, Painted, Painter, Progress, Rect, Rivers, View};
#[cfg(feature = "controls")]
use crate::recipe::Recipe;
use crate::recipe::{Key, Style};
use crate::river_map::ChartOptions;
#[cfg(feature = "names")]
use crate::river_map::RiverMap;
#[cfg(feature = "controls")]
use crate::session::SessionDrafts;
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
    /// What a chart lays over a finished map, and what it is of.
    chart: Option<(ChartKey, Arc<ChartMasks>)>,
    #[cfg(feature = "controls")]
    drafts: SessionDrafts,
    /// The next one, in the making.
    #[cfg(feature = "names")]
    builder: Option<(ChartKey, ChartBuilder)>,
    /// Pixels of the picture to one of those that letters are measured by.
    #[cfg(feature = "names")]
    ratio: f32,
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
            chart: None,
            #[cfg(feature = "controls")]
            drafts: SessionDrafts::default(),
            #[cfg(feature = "names")]
            builder: None,
            #[cfg(feature = "names")]
            ratio: 1.0,
        })
    }

    /// Shows another part of the map, or what lies around it; all that covers the picture, if no part is named. A chart stays with the part
    /// that it was made for.
    pub fn frame(&mut self, session: &Session, framing: Option<Framing>) {
        let before = *self.view();
        self.painter.frame(&session.domain(), framing);
        if *self.view() != before {
            self.chart = None;
            #[cfg(feature = "names")]
            {
                self.builder = None;
            }
        }
    }

    /// The same picture for a screen with so many pixels to a CSS pixel, from 0.5 to 4 in quarters, to the nearest of which it comes: no letter is
    /// smaller than 11 CSS pixels, times the recipe's `label-size`.
    #[cfg(feature = "names")]
    #[must_use]
    pub fn with_ratio(mut self, ratio: f32) -> Self {
        self.ratio = ratio;
        (self.chart, self.builder) = (None, None);
        self.painter.reset();
        self
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
        if self.advance_chart(session) {
            return Painted::Part;
        }
        let chart = self.chart.as_ref().map(|(_, chart)| chart);
        if let Some(((network, rounds), past)) = session.network().zip(session.rounds()).zip(session.past()) {
            let relief = session.relief().map(|relief| (relief, recipe.number(Key::Shade)));
            return self.painter.paint_rivers(&Rivers { network, past, rounds, courses, land, relief, chart, style });
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

    /// Paints the rivers of a session as they are, be they finished or not, in one go: without a chart, so many times as wide, and on the
    /// ground that the picture shows, even if its relief is that of other rivers. It lasts until `paint` paints anything else. Returns the
    /// rectangle that changed; `None`, and nothing has, if there are no rivers, or the ground is that of another land.
    #[cfg(feature = "controls")]
    pub fn paint_draft(&mut self, session: &Session, times: f32) -> Option<Rect> {
        let (network, recipe) = (session.network()?, session.recipe());
        if !self.is_on_land_of(session) {
            return None;
        }
        let changed = self.painter.paint_draft(network, recipe.get(), recipe.get(), times)?;
        self.rivers_of = Some(session.tree_generation());
        Some(changed)
    }

    /// Does a part of painting the finished rivers of a session, without a chart, with nearly the relief that they would have by another
    /// recipe, of other mountains or plains alone; by its own, with the very one. The picture changes with the last part. It lasts until
    /// `paint` paints anything else. `None`, and nothing is painted, if that is another recipe in more, or no relief of these rivers has
    /// been solved.
    #[cfg(feature = "controls")]
    pub fn paint_relief_draft(&mut self, session: &Session, wanted: &Recipe) -> Option<Painted> {
        let ((network, rounds), past) = session.network().zip(session.rounds()).zip(session.past())?;
        if !self.is_on_land_of(session) {
            return None;
        }
        if self.drafts.prepare(session, wanted)? {
            return Some(Painted::Part);
        }
        let relief = self.drafts.relief(session, wanted)?;
        let (recipe, land) = (session.recipe(), session.land().map(Arc::as_ref));
        let relief = Some((&relief, recipe.number(Key::Shade)));
        let (courses, style) = (recipe.get(), recipe.get());
        self.rivers_of = Some(session.tree_generation());
        let rivers = Rivers { network, past, rounds, courses, land, relief, chart: None, style };
        Some(self.painter.paint_rivers(&rivers))
    }

    /// Whether the ground of the picture is that of a session's land.
    #[cfg(feature = "controls")]
    fn is_on_land_of(&self, session: &Session) -> bool {
        self.shown
            .as_ref()
            .is_some_and(|(_, domain, land)| *domain == session.domain() && is_same(land.as_ref(), session.land()))
    }

    /// Whether the recipe of a session, which is finished, wants a chart over this picture that it has not got.
    pub fn wants_chart(&self, session: &Session) -> bool {
        let has_one = self.chart.as_ref().is_some_and(|(of, _)| *of == ChartKey::of(session));
        is_to_be_charted(session) && !has_one
    }

    /// Takes a chart for a session as it is, and for a picture of this size. It is seen when next this is painted, for as long as the
    /// session stays so.
    pub fn take_chart(&mut self, session: &Session, chart: ChartMasks) {
        self.chart = Some((ChartKey::of(session), Arc::new(chart)));
    }

    /// How much of the ground of a finished session is painted, from 0 to 1: what is left then is short.
    #[cfg(feature = "files")]
    pub fn progress(&self, session: &Session) -> f32 {
        self.painter.progress(session.recipe().get())
    }

    /// Takes the ground out of a painted picture of this session. Of a style with relief, and of past courses, the sea goes, and land, rivers and letters
    /// stay; of a style of lines, ink, dark or skeleton, the paper. Colours are not multiplied by their opacity. The next `paint` brings all of it back.
    #[cfg(feature = "files")]
    pub fn cut_out(&mut self, session: &Session) {
        self.painter.cut_out(session.recipe().get());
    }

    /// How the domain lies on the picture.
    pub fn view(&self) -> &View {
        self.painter.view()
    }

    /// Drops a chart of another map, and does a part of making one of this, if that can be done here. Returns whether it did.
    fn advance_chart(&mut self, session: &Session) -> bool {
        if self.chart.is_none() && !is_to_be_charted(session) {
            return false;
        }
        let now = ChartKey::of(session);
        if self.chart.as_ref().is_some_and(|(of, _)| *of != now) {
            self.chart = None;
        }
        #[cfg(feature = "names")]
        if self.wants_chart(session)
            && let Some(map) = RiverMap::of(session)
        {
            let (view, ratio) = (*self.view(), self.ratio);
            if self.builder.as_ref().is_none_or(|(of, _)| *of != now) {
                self.builder = Some((now, ChartBuilder::default()));
            }
            let chart = self.builder.as_mut().and_then(|(_, builder)| builder.advance(&map, &view, ratio));
            if let Some(chart) = chart {
                self.builder = None;
                self.take_chart(session, chart);
            }
            return true;
        }
        false
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

/// What a chart is of: woods, hills and marks of one style are none for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct ChartKey {
    generation: Generation,
    style: Option<Style>,
}

impl ChartKey {
    fn of(session: &Session) -> Self {
        let style = ChartOptions::of(session.recipe()).deciding_style();
        Self { generation: session.map_generation(), style }
    }
}

/// Whether a session is finished, and its recipe wants a chart.
pub(crate) fn is_to_be_charted(session: &Session) -> bool {
    session.phase() == Phase::Finished && ChartOptions::of(session.recipe()).any()
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

    #[cfg(feature = "controls")]
    #[test]
    fn draft_is_on_the_ground_that_is_there_and_leaves_nothing_behind() {
        for style in ["atlas", "ink", "basins", "past-courses", "skeleton"] {
            let link = format!("{SMALL}&land=island&style={style}");
            let mut session = finished(&link);
            let mut picture = Picture::new(100, 80).unwrap();
            picture.paint(&session);
            let before = painted(&session);
            // Wider on the same courses, and back.
            assert!(picture.paint_draft(&session, 3.0).is_some(), "{style}");
            assert_eq!(picture.pixmap().data() != before, style != "skeleton", "{style}");
            picture.paint(&session);
            assert!(picture.pixmap().data() == before, "{style}");
            // Of rivers that change their courses, over the relief of those before.
            session.change(link::read(&format!("{link}&simplify=40&width=30")).unwrap()).unwrap();
            while session.rounds() != Some(1) {
                session.advance(1).unwrap();
            }
            assert!(picture.paint_draft(&session, 1.0).is_some(), "{style}");
            let draft = picture.pixmap().data();
            let kept = draft.chunks(4).zip(before.chunks(4)).filter(|(now, then)| now == then).count();
            // Of these courses a skeleton so small shows no difference.
            assert!((draft != before || style == "skeleton") && kept > 100 * 80 / 2, "{style}: {kept}");
            while session.advance(50).unwrap() {}
            picture.paint(&session);
            assert!(picture.pixmap().data() == painted(&session), "{style}");
        }
    }

    #[cfg(feature = "controls")]
    #[test]
    fn draft_needs_rivers_and_the_ground_of_their_land() {
        let mut session = finished(SMALL);
        assert_eq!(Picture::new(100, 80).unwrap().paint_draft(&session, 1.0), None);
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        session.change(link::read(&format!("{SMALL}&land=valley")).unwrap()).unwrap();
        assert_eq!(picture.paint_draft(&session, 1.0), None);
        while session.advance(50).unwrap() {}
        assert_eq!(picture.paint_draft(&session, 1.0), None);
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session));
    }

    #[cfg(feature = "controls")]
    #[test]
    fn draft_of_other_mountains_is_nearly_their_picture_and_leaves_nothing_behind() {
        // Of what a picture without a draft would be off, a draft is at most one part in so many: edges of basins move by whole pixels.
        for (style, parts) in [("atlas", 5.0), ("survey", 5.0), ("basins", 1.8)] {
            let link = format!("{SMALL}&land=island&style={style}");
            let mut session = finished(&link);
            let mut picture = Picture::new(100, 80).unwrap();
            picture.paint(&session);
            let before = painted(&session);
            let other = link::read(&format!("{link}&mountains=3&plains=60")).unwrap();
            draft(&mut picture, &session, &other).unwrap();
            let drafted = picture.pixmap().data().to_vec();
            // Back to its own, and then there again while theirs is solved.
            draft(&mut picture, &session, session.recipe()).unwrap();
            assert!(picture.pixmap().data() == before, "{style}");
            picture.paint(&session);
            assert!(picture.pixmap().data() == before, "{style}");
            session.change(other.clone()).unwrap();
            session.advance(2).unwrap();
            draft(&mut picture, &session, &other).unwrap();
            assert!(picture.pixmap().data() == drafted, "{style}");
            while session.advance(50).unwrap() {}
            picture.paint(&session);
            let exact = painted(&session);
            assert!(picture.pixmap().data() == exact, "{style}");
            let off = |pixels: &[u8]| -> f32 {
                pixels.iter().zip(&exact).map(|(&one, &other)| f32::from(one.abs_diff(other))).sum()
            };
            assert!(off(&drafted) * parts < off(&before), "{style}: {}, {}", off(&drafted), off(&before));
        }
    }

    /// Paints a draft to its end.
    #[cfg(feature = "controls")]
    fn draft(picture: &mut Picture, session: &Session, wanted: &Recipe) -> Option<()> {
        while matches!(picture.paint_relief_draft(session, wanted)?, Painted::Part) {}
        Some(())
    }

    #[cfg(feature = "controls")]
    #[test]
    fn there_are_drafts_of_other_mountains_alone_and_of_rivers_with_a_relief() {
        let link = format!("{SMALL}&land=island&style=atlas");
        let read = |more: &str| link::read(&format!("{link}&{more}")).unwrap();
        let mut session = finished(&link);
        let mut picture = Picture::new(100, 80).unwrap();
        assert_eq!(draft(&mut picture, &session, &read("mountains=3")), None, "not on a picture of nothing");
        picture.paint(&session);
        for other in ["width=20&mountains=3", "shade=0.8&mountains=3", "seed=rimu&mountains=3"] {
            assert_eq!(draft(&mut picture, &session, &read(other)), None, "{other}");
        }
        assert!(picture.pixmap().data() == painted(&session));
        // Other rivers, whose relief is not there yet.
        draft(&mut picture, &session, &read("mountains=3")).unwrap();
        session.change(read("simplify=40")).unwrap();
        while session.phase() != Phase::Relief {
            assert_eq!(draft(&mut picture, &session, &read("simplify=40&mountains=3")), None);
            session.advance(1).unwrap();
        }
        assert_eq!(draft(&mut picture, &session, &read("simplify=40&mountains=3")), None);
        while session.advance(50).unwrap() {}
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session));
        draft(&mut picture, &session, &read("simplify=40&mountains=3")).unwrap();
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
