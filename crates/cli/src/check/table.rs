//! What a check has found, as a table to read.

use riverseed::Map;
use riverseed::analyse::proof::{BITS, Bits, Breach, Finding, Proof};
use riverseed::analyse::statistics::Measures;
use riverseed::scale::MapScale;

use super::verdicts::{Compared, Place, compared, kept};
use crate::measure::{in_words, sources};

/// A line of the table: what is asked, what the map has, what nature has, the verdict, and the places of what is wrong.
struct Row {
    cells: [String; 4],
    notes: Vec<String>,
}

/// Writes a line for each promise and each range, below each broken promise its first places, and the sources.
pub fn table(map: &Map, proof: &Proof, measures: &Measures) -> String {
    let (scale, sources) = (map.scale(), sources());
    let head = Row { cells: ["", "this map", "nature", "verdict"].map(String::from), notes: Vec::new() };
    let promises = proof.findings.iter().map(|finding| promise_row(finding, &scale)).chain([bits_row(&proof.bits)]);
    let ranges = compared(measures).map(|row| range_row(row, measures, &scale, &sources));
    let rows: Vec<Row> = [head].into_iter().chain(promises).chain(ranges).collect();
    let width = |column: usize| rows.iter().map(|row| row.cells[column].chars().count()).max().unwrap_or(0);
    let [asked, figures, natures] = [0, 1, 2].map(width);
    let lines = rows.iter().flat_map(|Row { cells: [name, figure, nature, verdict], notes }| {
        let line = format!("{name:asked$}  {figure:figures$}  {nature:natures$}  {verdict}");
        [line].into_iter().chain(notes.iter().map(|note| format!("    {note}")))
    });
    let notes = sources.iter().enumerate().map(|(i, source)| format!("[{}] {source}", i + 1));
    lines.chain(notes).chain(outside(measures)).collect::<Vec<_>>().join("\n")
}

fn promise_row(finding: &Finding, scale: &MapScale) -> Row {
    /// The number of places that are told. There may be thousands, and JSON has them all.
    const TOLD: usize = 5;
    let Finding { promise, looked_at, breaches, .. } = finding;
    let note = |breach: &Breach| {
        let (x, y) = (breach.at.x, breach.at.y);
        format!("at {x:.1}, {y:.1}: river {} {}", breach.river, breach.fault.told(scale))
    };
    let more = (breaches.len() > TOLD).then(|| format!("and {} more", breaches.len() - TOLD));
    let verdict = kept(breaches.is_empty());
    Row {
        cells: [promise.says.into(), format!("{looked_at} {}", promise.counted), String::new(), verdict.into()],
        notes: breaches.iter().take(TOLD).map(note).chain(more).collect(),
    }
}

fn bits_row(bits: &Bits) -> Row {
    let Bits { digest, again, committed, .. } = bits;
    let differs = |is_other: bool, note: String| is_other.then_some(note);
    let notes = [
        differs(digest != again, format!("grown once more, the digest is {again}")),
        committed
            .filter(|committed| committed != digest)
            .map(|committed| format!("everywhere else the digest is {committed}")),
        differs(!bits.relief_is_the_same, "the relief is another on several threads".into()),
    ];
    let figure = if committed.is_some() { format!("{digest}, as committed") } else { digest.clone() };
    let verdict = kept(bits.are_the_same());
    Row {
        cells: [BITS.says.into(), figure, String::new(), verdict.into()],
        notes: notes.into_iter().flatten().collect(),
    }
}

fn range_row((measure, nature, place): Compared, measures: &Measures, scale: &MapScale, sources: &[&str]) -> Row {
    let (value, unit) = measure.told(measures, scale);
    let places = measure.places;
    let figure = value.map_or(String::new(), |value| format!("{value:.places$} {unit}").trim_end().to_owned());
    let cells = [measure.label.into(), figure, in_words(nature, sources), place.word().into()];
    Row { cells, notes: Vec::new() }
}

/// Says what it means that some values lie outside nature's ranges; `None` if none does.
fn outside(measures: &Measures) -> Option<String> {
    let outside = compared(measures).filter(|(.., place)| matches!(place, Place::Below | Place::Above)).count();
    (outside > 0).then(|| {
        format!(
            "Outside nature's range: {outside} of {}. No promise is broken by that: a single map may lie outside.",
            compared(measures).count()
        )
    })
}
