//! What a check has found, for programs.

use std::io;

use riverseed::Map;
use riverseed::analyse::proof::{BITS, Breach, Finding, Proof};
use riverseed::analyse::statistics::Measures;
use riverseed::scale::MapScale;
use serde_json::{Value, json};

use super::verdicts::{Compared, compared, kept};

/// Writes all that was found, with the digest under a name of its own, for programs.
pub fn as_json(map: &Map, proof: &Proof, measures: &Measures) -> io::Result<String> {
    let scale = map.scale();
    let promise = |finding: &Finding| {
        let breaches: Vec<Value> = finding.breaches.iter().map(|breach| breach_as_json(breach, &scale)).collect();
        json!({
            "name": finding.promise.name,
            "says": finding.promise.says,
            "verdict": kept(breaches.is_empty()),
            "counted": finding.promise.counted,
            "count": finding.looked_at,
            "breaches": breaches,
        })
    };
    let bits = json!({
        "name": BITS.name,
        "says": BITS.says,
        "verdict": kept(proof.bits.are_the_same()),
        "counted": BITS.counted,
        "count": 2,
        "digest": proof.bits.digest,
        "again": proof.bits.again,
        "committed": proof.bits.committed,
        "relief-on-threads": proof.bits.relief_is_the_same,
    });
    let promises: Vec<Value> = proof.findings.iter().map(promise).chain([bits]).collect();
    let nature: Vec<Value> = compared(measures).map(|row| range_as_json(row, measures)).collect();
    let all = json!({
        "link": map.recipe().to_string(),
        "digest": proof.bits.digest,
        "verdict": kept(proof.broken() == 0),
        "promises": promises,
        "nature": nature,
    });
    Ok(serde_json::to_string_pretty(&all)?)
}

fn breach_as_json(breach: &Breach, scale: &MapScale) -> Value {
    json!({ "river": breach.river, "at": [breach.at.x, breach.at.y], "says": breach.fault.told(scale) })
}

fn range_as_json((measure, nature, place): Compared, measures: &Measures) -> Value {
    json!({
        "name": measure.name,
        "value": (measure.value)(measures),
        "median": nature.median,
        "least": nature.least,
        "most": nature.most,
        "verdict": place.word(),
        "source": nature.source,
    })
}
