//! Reports on many maps: a bar with the time left, warnings and failures by seed, and a summary.

use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use riverseed::recipe::visible;

use super::super::{Failure, say};

/// The outcome of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    Made,
    /// The files of another recipe were replaced.
    Replaced,
    WasThere,
}

/// Counts maps and shows progress.
pub struct Report {
    all: u64,
    made: AtomicU64,
    replaced: AtomicU64,
    there: AtomicU64,
    failed: AtomicU64,
    warnings: AtomicU64,
    bar: ProgressBar,
}

impl Report {
    /// The number of warnings that are printed. Further ones are only counted, because all maps may have the same.
    const WARNINGS: u64 = 20;

    pub fn new(all: u64) -> Self {
        let style = ProgressStyle::with_template("{pos} of {len} maps {wide_bar} {eta} left");
        let bar = ProgressBar::new(all).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let [made, replaced, there, failed, warnings] = [(); 5].map(|()| AtomicU64::new(0));
        Self { all, made, replaced, there, failed, warnings, bar }
    }

    pub fn count(&self, outcome: Outcome) {
        let counter = match outcome {
            Outcome::Made => &self.made,
            Outcome::Replaced => &self.replaced,
            Outcome::WasThere => &self.there,
        };
        counter.fetch_add(1, Ordering::Relaxed);
        match outcome {
            // Maps that take no time say nothing about the time left.
            Outcome::WasThere => self.bar.dec_length(1),
            _ => self.bar.inc(1),
        }
    }

    pub fn failed(&self, seed: &str, failure: &Failure) {
        self.failed.fetch_add(1, Ordering::Relaxed);
        self.say(seed, &failure.to_string());
        self.bar.inc(1);
    }

    pub fn warn(&self, seed: &str, text: &str) {
        if self.warnings.fetch_add(1, Ordering::Relaxed) < Self::WARNINGS {
            self.say(seed, text);
        }
    }

    fn say(&self, seed: &str, text: &str) {
        self.note(&format!("seed '{}': {text}", visible(seed)));
    }

    /// Prints a note about no single map.
    pub fn note(&self, text: &str) {
        self.bar.suspend(|| say(text));
    }

    /// Prints the summary. `faults` is the number of lines in the list that were not seeds, `end` the reason why not
    /// all maps were tried. `has_files` is `true` if finished files need not be made again.
    ///
    /// # Errors
    /// Fails if not all maps are there.
    pub fn finish(self, faults: u64, end: Option<Failure>, has_files: bool) -> Result<(), Failure> {
        self.bar.finish_and_clear();
        let warnings = self.warnings.into_inner().saturating_sub(Self::WARNINGS);
        if warnings > 0 {
            say(&format!("{warnings} further warnings are not shown"));
        }
        let counted = [(self.made, "made"), (self.replaced, "replaced"), (self.there, "there before")];
        let counted = counted.map(|(count, what)| (count.into_inner(), what));
        let parts = counted.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
        let parts: Vec<String> = parts.collect();
        if !parts.is_empty() {
            say(&format!("maps: {}", parts.join(", ")));
        }
        let (failed, all) = (self.failed.into_inner() + faults, self.all + faults);
        match end {
            Some(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => Err(error.into()),
            Some(failure) => {
                let advice = if has_files { "; the same call goes on from here" } else { "" };
                Err(Failure::Stopped { failure: failure.into(), all, advice })
            }
            None if failed > 0 => Err(Failure::Maps { failed, all }),
            None => Ok(()),
        }
    }
}
