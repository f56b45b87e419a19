//! Back and forth between the steps of a session: what is behind is made again from copies that were kept on the way.

use super::{Phase, Session, SessionError};

/// A moment in the making of a map, as people tell them apart. Later ones are greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Moment {
    /// After so many ticks of growth; after none there is land alone.
    Growth(u32),
    /// The tree has become rivers, which have meandered so many rounds.
    Bends(u32),
    /// Nothing is left to be done.
    Finished,
}

/// Copies of a session at some of its moments.
#[derive(Debug)]
pub struct Timeline {
    /// From early to late.
    kept: Vec<(Moment, Session)>,
    ticks: u32,
    rounds: u32,
    /// How many ticks, or rounds, lie between two copies; none where even one copy would take too much.
    stride: u32,
}

impl Session {
    /// How far it has come.
    pub fn moment(&self) -> Moment {
        match self.phase() {
            Phase::Growing => Moment::Growth(self.ticks),
            Phase::Finished => Moment::Finished,
            Phase::Shaping | Phase::Meandering | Phase::Relief => Moment::Bends(self.rounds().unwrap_or(0)),
        }
    }

    pub(super) fn count_tick(&mut self) {
        self.ticks += 1;
    }

    pub(super) fn forget_ticks(&mut self) {
        self.ticks = 0;
    }
}

impl Timeline {
    /// That of a finished session; `None` of any other. Nothing is kept before somebody goes back.
    pub fn new(session: &Session) -> Option<Self> {
        /// What all copies may take, and each of them takes for a node or an attractor, as measured.
        const MOST_BYTES: usize = 24_000_000;
        const BYTES_AN_ITEM: usize = 96;
        const MOST_COPIES: usize = 16;
        let rounds = session.rounds().filter(|_| session.is_finished())?;
        // Without a relief to follow, the last round is the end.
        let rounds = if session.shows_relief() { rounds } else { rounds.saturating_sub(1) };
        let items = session.tree().len() + session.growth().attractors() as usize;
        let copies = (MOST_BYTES / (items * BYTES_AN_ITEM + 1)).min(MOST_COPIES) as u32;
        let stride = (session.ticks + rounds).checked_div(copies).map_or(u32::MAX, |stride| stride + 1);
        Some(Self { kept: Vec::new(), ticks: session.ticks, rounds, stride })
    }

    /// How many ticks it grows.
    pub fn ticks(&self) -> u32 {
        self.ticks
    }

    /// The last round after which it is not finished.
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// Takes a session of the same recipe nearer to a moment: back at once, forth by a step. Returns whether it has not come there yet.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn seek(&mut self, session: &mut Session, to: Moment) -> Result<bool, SessionError> {
        let from = session.moment();
        if from == to {
            return Ok(false);
        }
        if from == Moment::Finished {
            self.keep(session);
        }
        let next = self.kept.partition_point(|(moment, _)| *moment <= to);
        match self.kept[..next].last().filter(|(moment, _)| from > to || *moment > from) {
            Some((_, copy)) => *session = copy.try_clone()?,
            None if from > to => session.restart()?,
            None => {
                session.advance(1)?;
                self.keep(session);
            }
        }
        Ok(session.moment() < to)
    }

    /// Keeps a copy, if it is time for one.
    fn keep(&mut self, session: &Session) {
        let moment = session.moment();
        let is_due = match moment {
            Moment::Growth(count) | Moment::Bends(count) => count > 0 && count.is_multiple_of(self.stride),
            Moment::Finished => self.stride < u32::MAX,
        };
        let next = self.kept.partition_point(|(kept, _)| *kept < moment);
        // Of the steps between two moments the first is the moment.
        let is_known = self.kept.get(next).is_some_and(|(kept, _)| *kept == moment);
        if is_due
            && !is_known
            && let Ok(copy) = session.try_clone()
        {
            self.kept.insert(next, (moment, copy));
        }
    }
}
