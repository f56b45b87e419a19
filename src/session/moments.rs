//! Seeking back and forth between the steps of a session. Earlier states are restored from copies kept on the way.

use super::{Phase, Session, SessionError};

/// A moment in the making of a map, as users tell them apart. Later moments compare greater.
/// Exhaustive, since whoever shows a timeline has a place for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Moment {
    /// After this number of ticks of growth; after 0 there is only land.
    Growth(u32),
    /// The tree has become rivers, which have meandered this number of rounds.
    Bends(u32),
    /// Nothing is left to do.
    Finished,
}

/// Copies of a session at some of its moments.
#[derive(Debug)]
pub struct Timeline {
    /// Ordered from early to late.
    kept: Vec<(Moment, Session)>,
    ticks: u32,
    rounds: u32,
    /// Number of ticks, or rounds, between two copies; `u32::MAX` if even one copy would take too much memory.
    stride: u32,
}

impl Session {
    /// Returns the moment that the session has reached.
    pub fn moment(&self) -> Moment {
        match self.phase() {
            Phase::Growing => Moment::Growth(self.ticks),
            Phase::Finished => Moment::Finished,
            Phase::Drowning | Phase::Shaping | Phase::Meandering | Phase::Relief => {
                Moment::Bends(self.rounds().unwrap_or(0))
            }
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
    /// Makes the timeline of a finished session; `None` for an unfinished one. Copies are kept once somebody goes back.
    pub fn new(session: &Session) -> Option<Self> {
        /// Limit on the memory of all copies, and the measured bytes of each for a node or an attractor.
        const MOST_BYTES: usize = 24_000_000;
        const BYTES_AN_ITEM: usize = 96;
        const MOST_COPIES: usize = 16;
        let rounds = session.rounds().filter(|_| session.is_finished())?;
        // Without a relief to follow, the last round is the end.
        let rounds = if session.needs_relief() || session.has_deltas() { rounds } else { rounds.saturating_sub(1) };
        let items = session.tree().len() + session.growth().attractors() as usize;
        let copies = (MOST_BYTES / (items * BYTES_AN_ITEM + 1)).min(MOST_COPIES) as u32;
        let stride = (session.ticks + rounds).checked_div(copies).map_or(u32::MAX, |stride| stride + 1);
        Some(Self { kept: Vec::new(), ticks: session.ticks, rounds, stride })
    }

    /// Returns the number of ticks that the session grows.
    pub fn ticks(&self) -> u32 {
        self.ticks
    }

    /// Returns the last round after which the session is not finished.
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// Seeks towards a moment in a session of the same recipe: jumps back, or advances one step. Returns `true` until
    /// it arrives.
    ///
    /// # Errors
    /// Fails if there is not enough memory.
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

    /// Keeps a copy if one is due.
    fn keep(&mut self, session: &Session) {
        let moment = session.moment();
        let is_due = match moment {
            Moment::Growth(count) | Moment::Bends(count) => count > 0 && count.is_multiple_of(self.stride),
            Moment::Finished => self.stride < u32::MAX,
        };
        let next = self.kept.partition_point(|(kept, _)| *kept < moment);
        // Several steps may belong to one moment; the first of them represents it.
        let is_known = self.kept.get(next).is_some_and(|(kept, _)| *kept == moment);
        if is_due
            && !is_known
            && let Ok(copy) = session.try_clone()
        {
            self.kept.insert(next, (moment, copy));
        }
    }
}
