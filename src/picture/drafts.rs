//! Drafts: previews that a picture shows while a slider moves. `paint` removes all traces of them.

use std::sync::Arc;

use super::{Picture, Source, is_same, rivers_of};
use crate::paint::{Inland, PaintSettings, Painted, Rivers};
use crate::recipe::{Key, Recipe};
use crate::session::{Generation, OF_COASTS, OF_RELIEF, Phase, Session};

/// The kind of difference between two recipes for which there is a draft.
enum Change {
    Nothing,
    Relief,
    /// The ratio of river widths.
    Width(f32),
    Coasts,
}

impl Change {
    /// Compares a recipe with a session's; `None` if they differ in anything that has no draft.
    fn between(session: &Session, wanted: &Recipe) -> Option<Self> {
        let recipe = session.recipe();
        if recipe == wanted {
            return Some(Self::Nothing);
        }
        if let Some(times) = session.widening_to(wanted) {
            return Some(Self::Width(times));
        }
        let kinds: [(&[Key], Self); 2] = [(&OF_RELIEF, Self::Relief), (&OF_COASTS, Self::Coasts)];
        kinds.into_iter().find_map(|(keys, change)| recipe.differs_in(wanted, keys).then_some(change))
    }
}

impl Picture {
    /// Paints a part of a draft of another recipe over the session's present rivers, without an annotation. The picture
    /// changes with the last part, and the draft lasts until `paint` paints anything else. The session's own recipe
    /// shows its rivers as they are, finished or not. `None`, and nothing is painted, if no draft is possible: the
    /// recipe differs in more than width, in more than mountains and plains, or in more than coasts, or the data that
    /// the draft starts from is missing.
    pub fn paint_draft(&mut self, session: &Session, wanted: &Recipe) -> Option<Painted> {
        match Change::between(session, wanted)? {
            Change::Nothing if !self.is_on_land_of(session) => self.paint_land_draft(session, wanted),
            Change::Nothing => {
                self.paint_relief_draft(session, wanted).or_else(|| self.paint_width_draft(session, 1.0))
            }
            Change::Relief => self.paint_relief_draft(session, wanted),
            Change::Width(times) => self.paint_width_draft(session, times),
            Change::Coasts => self.paint_land_draft(session, wanted),
        }
    }

    /// Paints the session's rivers as they are, finished or not, in one go, without an annotation and with their widths
    /// multiplied by `times`. They are painted on the ground in the picture, even if its relief belongs to other
    /// rivers. `None`, and nothing changes, if there are no rivers, or if the ground belongs to another land.
    fn paint_width_draft(&mut self, session: &Session, times: f32) -> Option<Painted> {
        let network = session.network()?;
        if !self.is_on_land_of(session) {
            return None;
        }
        let (_, distributaries) = session.shown_shore();
        let inland = Inland { network, distributaries, lakes: session.lakes().map(Arc::as_ref) };
        let changed = self.painter.paint_draft(inland, &PaintSettings::of(session.recipe()), times)?;
        self.rivers_of = Some(session.tree_generation());
        Some(Painted::Whole(Some(changed)))
    }

    /// Paints a part of the finished rivers with a preview of the relief under another recipe; under the session's own,
    /// with the exact relief. `None` if no relief of these rivers has been solved.
    fn paint_relief_draft(&mut self, session: &Session, wanted: &Recipe) -> Option<Painted> {
        let rivers = rivers_of(session)?;
        if !self.is_on_land_of(session) {
            return None;
        }
        if self.drafts.prepare(session, wanted)? {
            return Some(Painted::Part);
        }
        let relief = self.drafts.relief(session, wanted)?;
        self.rivers_of = Some(session.tree_generation());
        let lakes = self.drafts.lakes();
        Some(self.painter.paint_rivers(&Rivers { relief: Some(&relief), lakes, ..rivers }))
    }

    /// Paints a part of the finished rivers, without a relief, on a preview of another recipe's coasts, or on the
    /// session's own. The rivers stay as they are, and end at the new coast or short of it. `None` if there are no
    /// finished rivers.
    fn paint_land_draft(&mut self, session: &Session, wanted: &Recipe) -> Option<Painted> {
        let rivers = rivers_of(session)?;
        if !matches!(session.phase(), Phase::Relief | Phase::Finished) {
            return None;
        }
        let land = self.drafts.land(session, wanted)?;
        let is_there = self.shown.as_ref().is_some_and(|(_, _, shown)| is_same(shown.as_ref(), Some(&land)));
        if !is_there {
            self.painter.invalidate_ground(&session.domain());
            self.painter.reset();
            // A generation of no session, so that the next `paint` starts anew.
            self.shown = Some((Source::Session(Generation::next()), session.domain(), Some(land.clone())));
        }
        self.rivers_of = Some(session.tree_generation());
        // Other coasts have no deltas yet.
        let distributaries = if session.recipe() == wanted { rivers.distributaries } else { &[] };
        Some(self.painter.paint_rivers(&Rivers { land: Some(&land), distributaries, ..rivers }))
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::land::Land;
    use crate::picture::testing::{SMALL, finished, painted};
    use crate::recipe::link;

    #[test]
    fn draft_is_on_the_ground_that_is_there_and_leaves_nothing_behind() {
        for style in ["atlas", "ink", "basins", "past-courses", "skeleton"] {
            let link = format!("{SMALL}&land=island&style={style}");
            let mut session = finished(&link);
            let mut picture = Picture::new(100, 80).unwrap();
            picture.paint(&session);
            let before = painted(&session);
            // Wider on the same courses, and back.
            assert!(picture.paint_width_draft(&session, 3.0).is_some(), "{style}");
            assert_eq!(picture.pixmap().data() != before, style != "skeleton", "{style}");
            picture.paint(&session);
            assert!(picture.pixmap().data() == before, "{style}");
            // A draft of rivers that still change their courses, over the relief of the rivers before.
            session.change(link::read(&format!("{link}&simplify=40&width=30")).unwrap()).unwrap();
            while session.rounds() != Some(1) {
                session.advance(1).unwrap();
            }
            assert!(picture.paint_width_draft(&session, 1.0).is_some(), "{style}");
            let draft = picture.pixmap().data();
            let kept = draft.chunks(4).zip(before.chunks(4)).filter(|(now, then)| now == then).count();
            // At this size a skeleton shows no difference between these courses.
            assert!((draft != before || style == "skeleton") && kept > 100 * 80 / 2, "{style}: {kept}");
            while session.advance(50).unwrap() {}
            picture.paint(&session);
            assert!(picture.pixmap().data() == painted(&session), "{style}");
        }
    }

    #[test]
    fn draft_needs_rivers_and_the_ground_of_their_land() {
        let mut session = finished(SMALL);
        assert_eq!(Picture::new(100, 80).unwrap().paint_width_draft(&session, 1.0), None);
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        session.change(link::read(&format!("{SMALL}&land=valley")).unwrap()).unwrap();
        assert_eq!(picture.paint_width_draft(&session, 1.0), None);
        while session.advance(50).unwrap() {}
        assert_eq!(picture.paint_width_draft(&session, 1.0), None);
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session));
    }

    #[test]
    fn draft_of_other_mountains_is_nearly_their_picture_and_leaves_nothing_behind() {
        // A draft's error is at most one part in `parts` of the error without a draft: edges of basins move by whole
        // pixels, and colours with their size. Lakes stay where they were in a draft.
        for (style, lakes, parts) in [
            ("atlas", "&lakes=0", 10.0),
            ("survey", "&lakes=0", 10.0),
            ("atlas", "", 3.0),
            ("basins", "&deltas=0", 1.5),
        ] {
            let link = format!("{SMALL}&land=island&style={style}{lakes}");
            let mut session = finished(&link);
            let mut picture = Picture::new(100, 80).unwrap();
            picture.paint(&session);
            let before = painted(&session);
            let other = link::read(&format!("{link}&mountains=3&plains=60")).unwrap();
            draft(&mut picture, &session, &other).unwrap();
            let drafted = picture.pixmap().data().to_vec();
            // Back to its own mountains, and then to the others again while their relief is solved.
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
    fn draft(picture: &mut Picture, session: &Session, wanted: &Recipe) -> Option<()> {
        while matches!(picture.paint_draft(session, wanted)?, Painted::Part) {}
        Some(())
    }

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
        // The relief of the new rivers has not been made yet.
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

    /// Paints a draft of other coasts to its end.
    fn draft_of_coasts(picture: &mut Picture, session: &Session, wanted: &Recipe) -> Option<()> {
        while matches!(picture.paint_land_draft(session, wanted)?, Painted::Part) {}
        Some(())
    }

    #[test]
    fn draft_of_other_coasts_is_their_land_under_the_same_rivers_and_leaves_nothing_behind() {
        for style in ["atlas", "ink", "past-courses", "skeleton"] {
            let link = format!("{SMALL}&land=island&drowning=0&style={style}");
            let other = link::read(&format!("{link}&sea=0.7&roughness=0.2")).unwrap();
            let mut session = finished(&link);
            let mut picture = Picture::new(100, 80).unwrap();
            picture.paint(&session);
            let before = painted(&session);
            draft_of_coasts(&mut picture, &session, &other).unwrap();
            let drafted = picture.pixmap().data().to_vec();
            // Its sea is painted as before any river has grown; on its land there are rivers.
            let land = Land::draft_of(&other).unwrap();
            let bare = Session::on_land(other.clone(), land.clone()).unwrap();
            let ground = painted(&bare);
            let (mut sea, mut rivers) = (0, 0);
            for (i, (is, was)) in (0..).zip(drafted.chunks(4).zip(ground.chunks(4))) {
                let at = picture.view().point(Vec2::new((i % 100) as f32 + 0.5, (i / 100) as f32 + 0.5));
                let is_sea = land.coast_distance().height(at) < -15.0;
                assert!(is == was || !is_sea, "{style}: {at}");
                sea += u32::from(is_sea);
                rivers += u32::from(is != was);
            }
            assert!(sea > 3000 && rivers > 20, "{style}: {sea}, {rivers}");
            // Back to its own coasts, and to the exact picture.
            draft_of_coasts(&mut picture, &session, session.recipe()).unwrap();
            assert!(picture.pixmap().data() != drafted, "{style}");
            picture.paint(&session);
            assert!(picture.pixmap().data() == before, "{style}");
            draft_of_coasts(&mut picture, &session, &other).unwrap();
            assert!(picture.pixmap().data() == drafted, "{style}");
            picture.paint(&session);
            assert!(picture.pixmap().data() == before, "{style}");
            // Its own coasts again, while other rivers are being made.
            draft_of_coasts(&mut picture, &session, &other).unwrap();
            session.change(link::read(&format!("{link}&simplify=40")).unwrap()).unwrap();
            assert_eq!(session.phase(), Phase::Shaping);
            assert!(picture.paint(&session).is_some() && picture.pixmap().data() != drafted, "{style}");
            session.finish().unwrap();
            draft_of_coasts(&mut picture, &session, &link::read(&format!("{link}&simplify=40&sea=0.7")).unwrap())
                .unwrap();
            session.change(other).unwrap();
            while session.advance(50).unwrap() {
                picture.paint(&session);
            }
            picture.paint(&session);
            assert!(picture.pixmap().data() == painted(&session), "{style}");
        }
    }

    #[test]
    fn there_are_drafts_of_other_coasts_alone_and_of_finished_rivers_on_land_of_a_recipe() {
        let link = format!("{SMALL}&land=island&style=atlas");
        let read = |more: &str| link::read(&format!("{link}&{more}")).unwrap();
        let mut session = finished(&link);
        let mut picture = Picture::new(100, 80).unwrap();
        picture.paint(&session);
        for other in ["width=20&sea=0.7", "mountains=3&sea=0.7", "seed=rimu", "aspect=2"] {
            assert_eq!(draft_of_coasts(&mut picture, &session, &read(other)), None, "{other}");
        }
        assert!(picture.pixmap().data() == painted(&session));
        session.change(read("seed=rimu")).unwrap();
        assert_eq!(draft_of_coasts(&mut picture, &session, &read("seed=rimu&sea=0.7")), None, "it grows");
        let land = session.land().cloned().unwrap();
        let mut given = Session::on_land(session.recipe().clone(), land).unwrap();
        given.finish().unwrap();
        assert_eq!(draft_of_coasts(&mut picture, &given, &read("seed=rimu&sea=0.7")), None, "its land is given");
        let everywhere = finished(&format!("{SMALL}&land=rectangle"));
        let other = link::read(&format!("{SMALL}&land=rectangle&sea=0.7")).unwrap();
        assert_eq!(draft_of_coasts(&mut picture, &everywhere, &other), None, "there is no sea");
    }
}
