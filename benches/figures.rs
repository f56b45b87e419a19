//! The native side of `make bench`: says its process number, then does a task for every line it is given and answers
//! with the result. `run.mjs` asks, and times it.

mod workload;

use std::io::{BufRead, Write};

fn main() -> std::io::Result<()> {
    let mut workload = workload::Workload::default();
    let mut out = std::io::stdout();
    writeln!(out, "{}", std::process::id())?;
    for line in std::io::stdin().lock().lines() {
        let task = line?;
        match workload.prepare(&task) {
            Some(run) => writeln!(out, "{}", run())?,
            None => writeln!(out, "no such task: {task}")?,
        }
    }
    Ok(())
}
