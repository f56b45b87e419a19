//! The native side of `make bench`: does a task for every line it is given, and answers with the milliseconds that it
//! took and its result. `run.mjs` asks.

mod workload;

use std::io::{BufRead, Write};

use workload::Workload;

fn main() -> std::io::Result<()> {
    let mut workload = Workload::default();
    let mut out = std::io::stdout();
    for line in std::io::stdin().lock().lines() {
        let task = line?;
        match workload.prepare(&task) {
            Some(run) => {
                let (milliseconds, result) = timed(run);
                writeln!(out, "{milliseconds} {result}")?;
            }
            None => writeln!(out, "no such task: {task}")?,
        }
        out.flush()?;
    }
    Ok(())
}

#[expect(clippy::disallowed_types, reason = "a measurement is all about time")]
fn timed(run: &mut workload::Repetition) -> (f64, u32) {
    let start = std::time::Instant::now();
    let result = run();
    (start.elapsed().as_secs_f64() * 1000.0, result)
}
