//! The native side of `make bench`: prints its process number, then runs a task for each line of input and prints the
//! result. `run.mjs` sends the lines and measures the time.

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
