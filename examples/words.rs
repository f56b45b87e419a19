//! Prints made-up words of many languages, one a line. `www/scripts/words.mjs` searches them for words that nobody
//! wants to read.
//!
//! `words LANGUAGES WORDS`: the number of languages, and of words in each.

use std::io::{self, Write};

fn main() -> io::Result<()> {
    let mut given = std::env::args().skip(1).filter_map(|number| number.parse().ok());
    let (languages, words) = (given.next().unwrap_or(10), given.next().unwrap_or(10));
    let mut out = io::BufWriter::new(io::stdout().lock());
    for language in 0..languages {
        riverseed::name::words(&format!("seed {language}"), words).try_for_each(|word| writeln!(out, "{word}"))?;
    }
    out.flush()
}
