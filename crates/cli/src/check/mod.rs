//! `riverseed check`: whether one map keeps the promises of all maps, and which of nature's ranges.

mod json;
mod table;
mod verdicts;

use std::io::{self, Write};
use std::panic::resume_unwind;
use std::thread;

use clap::ArgMatches;
use indicatif::ProgressBar;
use riverseed::analyse::proof::Proof;
use riverseed::analyse::statistics::Measures;
use riverseed::digest::{DigestError, digest_of_session};
use riverseed::session::Session;

use super::grow::{begin, grow, progress};
use super::order::Order;
use super::{Failure, say, stdout};

/// Checks the map of a recipe, and prints a line for each promise and each of nature's ranges, or JSON.
pub fn check(matches: &ArgMatches) -> Result<(), Failure> {
    stdout::check()?;
    let order = Order::of(matches)?;
    order.say_what_is_idle(&[true]);
    let progress = progress(&order.recipe, 0);
    let (mut session, again) = grown_twice(order, &progress)?;
    let proof = Proof::of(&mut session, again)?;
    let map = session.finish()?;
    progress.finish_and_clear();
    let measures = Measures::of(&map);
    let text = match matches.get_flag("json") {
        true => json::as_json(&map, &proof, &measures)?,
        false => table::table(&map, &proof, &measures),
    };
    writeln!(io::stdout().lock(), "{text}")?;
    verdict(&proof)
}

/// Grows a recipe on two threads at once, each for itself. Returns the session of one and the digest of the other.
fn grown_twice(order: Order, progress: &ProgressBar) -> Result<(Session, String), Failure> {
    let other = order.clone();
    let again = move || -> Result<String, DigestError> { digest_of_session(&mut begin(other)?) };
    thread::scope(|scope| {
        let again = thread::Builder::new().spawn_scoped(scope, again)?;
        let session = finished(order, progress);
        let again = again.join().unwrap_or_else(|panic| resume_unwind(panic));
        Ok((session?, again?))
    })
}

/// Grows a recipe and runs all that comes after growth.
fn finished(order: Order, progress: &ProgressBar) -> Result<Session, Failure> {
    let mut session = grow(order, progress, &say)?;
    session.finish()?;
    Ok(session)
}

/// Fails if a promise is broken, which gives the command an exit code of its own.
fn verdict(proof: &Proof) -> Result<(), Failure> {
    let all = proof.findings.len() + 1;
    match proof.broken() {
        0 => Ok(()),
        broken => Err(Failure::Broken { broken, all }),
    }
}

#[cfg(test)]
mod tests {
    use std::process::ExitCode;

    use riverseed::Map;
    use riverseed::analyse::proof::{Breach, Fault};
    use riverseed::glam::Vec2;
    use serde_json::Value;

    use super::*;

    fn small() -> (Map, Proof) {
        let session = || Session::new("seed=kea&country=usual&attractors=300&style=ink".parse().unwrap()).unwrap();
        let mut one = session();
        let proof = Proof::of(&mut one, digest_of_session(&mut session()).unwrap()).unwrap();
        (one.finish().unwrap(), proof)
    }

    fn code(proof: &Proof) -> String {
        let code = verdict(proof).map_or_else(|failure| failure.exit_code(), |()| ExitCode::SUCCESS);
        format!("{code:?}")
    }

    #[test]
    fn a_broken_promise_is_told_with_its_places_and_has_an_exit_code_of_its_own() {
        let (map, mut proof) = small();
        let measures = Measures::of(&map);
        assert_eq!(code(&proof), format!("{:?}", ExitCode::SUCCESS));
        let crossing = Breach { river: 7, at: Vec2::new(12.0, 34.56), fault: Fault::Crosses { other: 9 } };
        proof.findings[1].breaches = vec![crossing; 6];
        proof.bits.again = "0123456789abcdef".into();
        assert_eq!(code(&proof), format!("{:?}", ExitCode::from(3)));
        let table = table::table(&map, &proof, &measures);
        let lines: Vec<&str> = table.lines().collect();
        let line = |label: &str| lines.iter().position(|line| line.starts_with(label)).unwrap();
        let (crossings, bits) = (line("Nothing crosses"), line("The same bits"));
        assert!(lines[crossings].ends_with("  broken") && lines[bits].ends_with("  broken"), "{table}");
        assert_eq!(lines[crossings + 1], "    at 12.0, 34.6: river 7 crosses river 9");
        assert_eq!(lines[crossings + 6], "    and 1 more");
        assert_eq!(lines[bits + 1], "    grown once more, the digest is 0123456789abcdef");
        let json: Value = serde_json::from_str(&json::as_json(&map, &proof, &measures).unwrap()).unwrap();
        assert_eq!((&json["verdict"], &json["promises"][1]["verdict"]), (&"broken".into(), &"broken".into()));
        let breaches = json["promises"][1]["breaches"].as_array().unwrap();
        assert_eq!((breaches.len(), &breaches[5]["says"]), (6, &"crosses river 9".into()));
    }
}
