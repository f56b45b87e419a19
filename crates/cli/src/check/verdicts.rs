//! The words of verdicts, on promises and on measures.

use riverseed::analyse::statistics::{Measure, Measures, Nature, TABLE};

/// A measure, nature's values of it, and where the map's value lies.
pub type Compared = (&'static Measure, Nature, Place);

/// Compares each measure of a map with nature's range, but for those that are not known of natural rivers.
pub fn compared(measures: &Measures) -> impl Iterator<Item = Compared> {
    TABLE.iter().filter_map(|measure| {
        let nature = measure.nature?;
        Some((measure, nature, Place::of((measure.value)(measures), nature)))
    })
}

/// Where a value lies, compared with nature's range.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Place {
    Within,
    Below,
    Above,
    /// The network is too small for the measure.
    Unknown,
}

impl Place {
    fn of(value: Option<f64>, nature: Nature) -> Self {
        match value {
            None => Self::Unknown,
            Some(value) if nature.holds(value) => Self::Within,
            Some(value) if value < nature.least => Self::Below,
            Some(_) => Self::Above,
        }
    }

    /// Names the place.
    pub fn word(self) -> &'static str {
        match self {
            Self::Within => "within",
            Self::Below => "below",
            Self::Above => "above",
            Self::Unknown => "too small",
        }
    }
}

/// Names the verdict on a promise.
pub fn kept(is_kept: bool) -> &'static str {
    if is_kept { "kept" } else { "broken" }
}
