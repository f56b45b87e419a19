//! Growth, with warnings about its shortfalls.

use indicatif::{ProgressBar, ProgressStyle};
use riverseed::recipe::{IntegerKey, LandKind, Recipe};
use riverseed::session::{Session, SessionError, Shortfall};

use super::order::Order;
use super::{Failure, Say};

/// Grows a recipe to its end.
pub fn grow(order: Order, progress: &ProgressBar, say: Say<'_>) -> Result<Session, Failure> {
    let mut session = begin(order)?;
    if is_undrawn(&session) {
        say("land is 'drawn' but no outline shows both land and water; all of the map is land");
    }
    progress.set_length(u64::from(session.growth().total_discharge()));
    progress.set_message("growing");
    while session.advance(16)? {
        progress.set_position(u64::from(session.growth().drained()));
    }
    match session.summary().shortfall() {
        Some(Shortfall::NoRiver) => say("no river grew: no land lies open to the sea"),
        Some(Shortfall::Unreached) => {
            let (attractors, unreached) = (session.growth().attractors(), session.growth().unreached());
            let advice = "a shorter 'step', a longer 'kill' or 'reach', or less 'mouth-spacing' helps";
            say(&format!("rivers leave {unreached} of {attractors} attractors unreached; {advice}"));
        }
        Some(Shortfall::CutOff) => {
            let (parcels, unreached) = (session.growth().attractors(), session.growth().unreached());
            let advice = "a gap in the ridges that cut them off, or more 'mouths' (0 for all), helps";
            say(&format!("{unreached} of {parcels} parcels have no way to a river mouth; {advice}"));
        }
        Some(_) => say("rivers leave much of the land dry"),
        None => {}
    }
    Ok(session)
}

/// Begins the session of a recipe, on its land if that is given.
pub fn begin(order: Order) -> Result<Session, SessionError> {
    match order.land {
        Some(land) => Session::on_land(order.recipe, land),
        None => Session::new(order.recipe),
    }
}

/// Returns `true` if a drawn land is asked for, but nothing is drawn that could be land.
fn is_undrawn(session: &Session) -> bool {
    let recipe = session.recipe();
    recipe.get::<LandKind>() == LandKind::Drawn && session.land().is_none() && recipe.rivers().is_empty()
}

/// Makes a progress bar on standard error for long work; invisible if that is not a terminal.
pub fn progress(recipe: &Recipe, size: u32) -> ProgressBar {
    const LONG_GROWTH: u32 = 200_000;
    const LONG_PAINTING: u32 = 4096;
    let attractors = recipe.integer(IntegerKey::Attractors);
    if attractors < LONG_GROWTH && size < LONG_PAINTING {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg} {wide_bar} {percent}%");
    ProgressBar::new(u64::from(attractors)).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
