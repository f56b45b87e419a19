//! `riverseed render --seeds`: the maps of many seeds, on all cores. Each map depends on its seed and the recipe alone,
//! so threads take one after the other from the list. Complete files are not made again.

mod file_name;
mod lines;
mod place;
mod report;
mod seeds;

use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use clap::ArgMatches;
use indicatif::ProgressBar;
use riverseed::recipe::{Key, Recipe, given};
use riverseed_exchange::{Form, Found, Options};

use self::file_name::Pattern;
pub use self::file_name::{PLACE, with_seed};
use self::lines::{Lines, Turn};
use self::place::Places;
use self::report::{Outcome, Report};
use self::seeds::Seeds;
pub use self::seeds::Shard;
use super::map::make;
use super::order::Order;
use super::output::{Output, folder};
use super::wanted::Wanted;
use super::{Failure, say};

/// Writes the files of all maps.
///
/// # Errors
/// Fails if the call is wrong, if a map could not be made, or if none of the rest can be.
pub fn render(
    matches: &ArgMatches,
    source: &OsStr,
    order: &Order,
    wanted: &[Wanted<'_>],
    options: Options,
) -> Result<(), Failure> {
    refuse_a_seed(matches)?;
    let files = patterns(wanted)?;
    let seeds = Seeds::read(source, &say)?;
    let shard = matches.get_one::<Shard>("shard").copied().unwrap_or_default();
    let threads = matches.get_one::<usize>("threads").copied();
    let threads = threads.or_else(|| thread::available_parallelism().ok().map(Into::into)).unwrap_or(1);
    let all = seeds.count(shard);
    let run = Run {
        order,
        files,
        places: Places::of(matches, source),
        has_lines: wanted.iter().any(|wanted| wanted.path.is_none()),
        options,
        is_again: matches.get_flag("again"),
        next: AtomicU64::new(0),
        lines: Lines::default(),
        report: Report::new(all),
        end: OnceLock::new(),
        shard,
        seeds: &seeds,
    };
    run.make_all(threads.min(usize::try_from(all).unwrap_or(usize::MAX)));
    run.report.finish(seeds.faults, run.end.into_inner(), !run.files.is_empty())
}

/// Refuses a seed in the recipe, because each map has its own.
fn refuse_a_seed(matches: &ArgMatches) -> Result<(), Failure> {
    let seed = Key::Seed.parameter().name;
    let link = matches.get_one::<String>("link").map(|text| given::pairs(text)).transpose()?;
    let is_linked = link.into_iter().flat_map(|(pairs, _)| pairs).any(|(name, _)| name == seed);
    if is_linked || matches.contains_id(seed) { Err(Failure::SeedBesides) } else { Ok(()) }
}

/// Reads the file names of the outputs. Also checks, before the work begins, that files can be written there.
fn patterns(wanted: &[Wanted<'_>]) -> Result<Vec<(Form, Pattern)>, Failure> {
    let mut patterns: Vec<(Form, Pattern)> = Vec::new();
    let mut has_lines = false;
    for Wanted { form, path } in wanted {
        let Some(path) = path else {
            if std::mem::replace(&mut has_lines, true) {
                return Err(Failure::Pattern { path: "-".into(), reason: "it is given twice" });
            }
            continue;
        };
        let pattern = Pattern::of(path)?;
        Output::open(path)?;
        if patterns.iter().any(|(_, other)| other.may_meet(&pattern)) {
            return Err(Failure::Pattern { path: path.into(), reason: file_name::MEETS });
        }
        patterns.push((*form, pattern));
    }
    Ok(patterns)
}

/// The data shared by all threads.
struct Run<'a> {
    order: &'a Order,
    files: Vec<(Form, Pattern)>,
    places: Places,
    has_lines: bool,
    options: Options,
    is_again: bool,
    seeds: &'a Seeds,
    shard: Shard,
    /// The place in the shard of the next map to be made.
    next: AtomicU64,
    lines: Lines,
    report: Report,
    /// The reason why none of the remaining maps can be made.
    end: OnceLock<Failure>,
}

impl Run<'_> {
    /// Renders all maps on up to `threads` threads, including this one.
    fn make_all(&self, threads: usize) {
        thread::scope(|scope| {
            for i in 1..threads {
                if let Err(error) = thread::Builder::new().spawn_scoped(scope, || self.make_maps()) {
                    let noun = if i == 1 { "thread" } else { "threads" };
                    self.report.note(&format!("could start only {i} {noun}: {error}"));
                    break;
                }
            }
            self.make_maps();
        });
    }

    /// Makes one map after the other until there are none left.
    fn make_maps(&self) {
        while self.end.get().is_none() {
            let place = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(seed) = self.seeds.get(self.shard, place) else { return };
            let turn = (self.has_lines && self.lines.is_open()).then(|| self.lines.turn(place));
            match self.make_map(&seed, turn) {
                Ok(outcome) => self.report.count(outcome),
                Err(failure) if ends_all(&failure) => drop(self.end.set(failure)),
                Err(failure) => self.report.failed(&seed, &failure),
            }
        }
    }

    /// Makes the missing files of a map.
    fn make_map(&self, seed: &str, turn: Option<Turn<'_>>) -> Result<Outcome, Failure> {
        let mut recipe = self.order.recipe.clone();
        recipe.set(Key::Seed, seed)?;
        let (missing, is_other) = self.missing(&recipe);
        if missing.is_empty() && turn.is_none() {
            return Ok(Outcome::WasThere);
        }
        // Destinations are checked before the work begins, but opened one at a time, because a process can have few
        // open files.
        missing.iter().try_for_each(|(_, path)| self.places.open(path).map(drop))?;
        let line = turn.as_ref().map(|_| Form::Json);
        let forms: Vec<Form> = missing.iter().map(|(form, _)| *form).chain(line).collect();
        let order = Order { recipe, given: Vec::new(), land: self.order.land.clone() };
        let warn = |text: &str| self.report.warn(seed, text);
        let files = make(order, &forms, self.options, &ProgressBar::hidden(), &warn)?;
        for (form, path) in missing {
            self.places.open(&path)?.write(|out| Ok(files.write(form, out)?))?;
        }
        if let Some(turn) = turn {
            let mut line = Vec::new();
            files.write(Form::Json, &mut line).map_err(Failure::file(Path::new("-")))?;
            drop(files); // or as many would wait as there are threads
            self.write_line(turn, &line)?;
        }
        Ok(if is_other { Outcome::Replaced } else { Outcome::Made })
    }

    /// Writes a line. If nobody reads lines any more, files are made without them.
    fn write_line(&self, turn: Turn<'_>, line: &[u8]) -> Result<(), Failure> {
        match turn.write(line) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe && !self.files.is_empty() => self.lines.close(),
            written => written?,
        }
        Ok(())
    }

    /// Finds the files to be made. Also returns `true` if another recipe's files are in the place of some.
    fn missing(&self, recipe: &Recipe) -> (Vec<(Form, PathBuf)>, bool) {
        let mut is_other = false;
        let files = self.files.iter().map(|(form, pattern)| (*form, pattern.path(recipe.seed())));
        let missing = files.filter(|(form, path)| {
            let found = Found::at(path, *form, recipe, &self.options);
            is_other |= found == Found::Other;
            self.is_again || found != Found::Whole
        });
        let missing = missing.collect();
        (missing, is_other)
    }
}

/// Returns `true` if a failure would occur for all other maps too: nobody reads, the disk is full, or the folder is
/// gone.
fn ends_all(failure: &Failure) -> bool {
    match failure {
        Failure::Output(_) => true,
        Failure::File { path, error } => match error.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::ReadOnlyFilesystem => true,
            ErrorKind::NotFound => !folder(path).is_dir(),
            _ => false,
        },
        _ => false,
    }
}
