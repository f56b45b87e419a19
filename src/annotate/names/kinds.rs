//! The making of names from words: by the kind of water or land, and by the manner of a language.

use super::PlaceKind;

/// A kind of river, by its length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Size {
    River,
    Creek,
    Brook,
}

impl Size {
    /// Returns the size of a river of so many kilometres.
    pub fn of(kilometres: f32) -> Self {
        match kilometres {
            20.0.. => Self::River,
            6.0.. => Self::Creek,
            _ => Self::Brook,
        }
    }

    /// Returns the word for rivers of this size, such as `River` or `Beck`.
    pub fn generic(self, manner: u32) -> &'static str {
        const GENERICS: [[&str; 3]; 3] =
            [["River", "Creek", "Brook"], ["River", "Beck", "Burn"], ["Water", "Stream", "Rill"]];
        GENERICS[manner as usize % GENERICS.len()][self as usize]
    }
}

/// Forms the name of a river: `X River`, `River X`, `X Water`.
pub(super) fn river(word: &str, size: Size, manner: u32) -> String {
    let generic = size.generic(manner);
    if generic == "River" && (manner / 4).is_multiple_of(2) {
        format!("River {word}")
    } else {
        format!("{word} {generic}")
    }
}

/// Forms the name of the greatest tributary of a river, and its short form: by the side that it comes from, or `Little X`.
pub(super) fn fork(parent: &str, [east, south]: [f32; 2], manner: u32) -> [String; 2] {
    let side = match (east.abs() > south.abs(), east > 0.0, south > 0.0) {
        (true, true, _) => "East",
        (true, false, _) => "West",
        (false, _, true) => "South",
        (false, _, false) => "North",
    };
    if (manner / 8).is_multiple_of(3) {
        return [format!("Little {parent}"), format!("Little {parent}")];
    }
    [format!("{side} Fork of the {parent}"), format!("{side} Fork")]
}

/// Forms the name of a place from its kind, its word, its real size and some chance. The size of seas, lakes and islands is in square
/// kilometres, that of ranges their height in metres, that of others in kilometres.
pub(super) fn place(kind: PlaceKind, word: &str, size: f32, chance: u32) -> String {
    /// The forms of places' names, with the word where `#` is, from some size on; the largest of a kind first.
    const FORMS: [(PlaceKind, f32, &str); 14] = [
        (PlaceKind::Sea, 1000.0, "The # Sea|Sea of #|The # Sea"),
        (PlaceKind::Sea, 0.0, "# Sound|The # Water"),
        (PlaceKind::Gulf, 5.0, "Gulf of #|The Gulf of #|# Gulf"),
        (PlaceKind::Gulf, 0.0, "Bay of #|# Bay|# Bight"),
        (PlaceKind::Lake, 15.0, "Lake #|Lough #|Lake #"),
        (PlaceKind::Lake, 1.0, "# Mere|# Water"),
        (PlaceKind::Lake, 0.0, "# Mere|# Water|# Tarn"),
        (PlaceKind::Island, 10.0, "Isle of #|# Island|#"),
        (PlaceKind::Island, 3.0, "# Holm|# Skerry"),
        (PlaceKind::Island, 0.0, "# Holm|# Skerry|# Eyot|The # Stone"),
        (PlaceKind::Bay, 0.0, "Bay of #|# Bay|# Bight|# Bay"),
        (PlaceKind::Cape, 0.0, "Cape #|# Point|# Head|Cape #|The Naze of #|# Ness"),
        (PlaceKind::Strait, 0.0, "Strait of #|# Sound|The # Narrows|Strait of #"),
        (PlaceKind::Range, 600.0, "The # Mountains|The # Range|# Mountains"),
    ];
    /// The forms of ranges that are lower.
    const HILLS: &str = "The # Hills|# Fells|The # Heights";
    let forms = FORMS.iter().find(|(of, least, _)| *of == kind && size >= *least).map_or(HILLS, |(.., forms)| forms);
    let count = forms.split('|').count().max(1);
    let form = forms.split('|').nth(chance as usize % count).unwrap_or("#");
    form.replace('#', word)
}

/// Names of reaches that wind: the first half stand after `The`.
const WINDING: [&str; 48] = [
    "Meanders",
    "Rambles",
    "Cringle-Crangles",
    "Crinkum-Crankums",
    "Windings",
    "Wanders",
    "Crankles",
    "Wimples",
    "Crooks",
    "Links",
    "Ambages",
    "Flexures",
    "Serpentines",
    "Twines",
    "Coils",
    "Loops",
    "Vagaries",
    "Mazes",
    "Whirligigs",
    "Circumbendibus",
    "Curlicues",
    "Strays",
    "Divagations",
    "Anfractuosities",
    "Snake",
    "Serpent",
    "Adder",
    "Viper",
    "Asp",
    "Anaconda",
    "Python",
    "Boa",
    "Cobra",
    "Mamba",
    "Rattler",
    "Sidewinder",
    "Basilisk",
    "Hydra",
    "Wyrm",
    "Lindworm",
    "Eel",
    "Lamprey",
    "Conger",
    "Blindworm",
    "Naga",
    "Ouroboros",
    "Whiplash",
    "Corkscrew",
];

/// Returns `true` if a folded word is one of those for winding rivers.
pub(super) fn is_winding_word(folded: &[u8]) -> bool {
    WINDING.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(folded))
}

/// Chooses the name of a reach that winds: after its bends, or after something that winds as it does. Returns that word with it.
pub(super) fn reach(bits: u32, size: Size, manner: u32) -> (&'static str, String) {
    let which = bits as usize % WINDING.len();
    let word = WINDING[which];
    let name = match bits / WINDING.len() as u32 % 2 {
        0 if which >= WINDING.len() / 2 => format!("{word} {}", size.generic(manner)),
        _ => format!("The {word}"),
    };
    (word, name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_river_s_size_is_its_length() {
        let sizes = [20.0, 19.9, 6.0, 5.9].map(Size::of);
        assert_eq!(sizes, [Size::River, Size::Creek, Size::Creek, Size::Brook]);
    }

    #[test]
    fn forks_are_named_by_the_side_that_they_come_from() {
        let sides = [[3.0, 1.0], [-3.0, 1.0], [1.0, -3.0], [1.0, 3.0]].map(|from| fork("Dellen", from, 8)[0].clone());
        assert_eq!(sides, ["East", "West", "North", "South"].map(|side| format!("{side} Fork of the Dellen")));
        assert_eq!(fork("Dellen", [1.0, 0.0], 0)[0], "Little Dellen");
        assert_eq!(fork("Dellen", [1.0, 0.0], 8)[1], "East Fork");
    }

    #[test]
    fn only_small_islands_are_stones_holms_and_skerries() {
        let forms = |size: f32| (0..12).map(move |chance| place(PlaceKind::Island, "Dellen", size, chance));
        let is = |name: &str, words: &[&str]| words.iter().any(|word| name.ends_with(word));
        assert!(forms(2.9).any(|name| is(&name, &["Stone"])) && forms(2.9).any(|name| is(&name, &["Eyot"])));
        assert!(!forms(3.0).any(|name| is(&name, &["Stone", "Eyot"])));
        assert!(forms(9.9).all(|name| is(&name, &["Holm", "Skerry"])));
        assert!(!forms(10.0).any(|name| is(&name, &["Holm", "Skerry", "Stone", "Eyot"])));
    }

    #[test]
    fn the_kinds_have_their_forms() {
        assert_eq!(
            [0, 4, 1, 2].map(|manner| river("Dellen", Size::River, manner)),
            ["River Dellen", "Dellen River", "River Dellen", "Dellen Water"]
        );
        assert_eq!(river("Dellen", Size::Brook, 1), "Dellen Burn");
        let named = |kind, size| [0, 1].map(|chance| place(kind, "Dellen", size, chance));
        assert_eq!(named(PlaceKind::Island, 10.0), ["Isle of Dellen", "Dellen Island"]);
        assert_eq!(named(PlaceKind::Island, 9.9), ["Dellen Holm", "Dellen Skerry"]);
        assert_eq!(named(PlaceKind::Lake, 15.0)[0], "Lake Dellen");
        assert_eq!(named(PlaceKind::Lake, 14.0), ["Dellen Mere", "Dellen Water"]);
        assert_eq!(named(PlaceKind::Sea, 1000.0), ["The Dellen Sea", "Sea of Dellen"]);
        assert_eq!(named(PlaceKind::Sea, 999.0), ["Dellen Sound", "The Dellen Water"]);
        assert_eq!(named(PlaceKind::Gulf, 5.0)[0], "Gulf of Dellen");
        assert_eq!(named(PlaceKind::Gulf, 4.9)[0], "Bay of Dellen");
        assert_eq!(named(PlaceKind::Bay, 0.0)[1], "Dellen Bay");
        assert_eq!(named(PlaceKind::Cape, 0.0), ["Cape Dellen", "Dellen Point"]);
        assert_eq!(named(PlaceKind::Strait, 0.0), ["Strait of Dellen", "Dellen Sound"]);
        assert_eq!(named(PlaceKind::Range, 600.0)[0], "The Dellen Mountains");
        assert_eq!(named(PlaceKind::Range, 599.0), ["The Dellen Hills", "Dellen Fells"]);
        let reaches = [0, 24, 72].map(|bits| reach(bits, Size::River, 0));
        let expected = [("Meanders", "The Meanders"), ("Snake", "Snake River"), ("Snake", "The Snake")];
        assert_eq!(reaches, expected.map(|(word, name)| (word, name.into())));
    }
}
