//! From words to names: what kind of water or land it is, and how a language says so.

/// A kind of river, by the share of all water that it drains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Size {
    River,
    Creek,
    Brook,
}

impl Size {
    /// By a share of the whole discharge, given in its parts.
    pub fn of(discharge: u32, total: u32) -> Self {
        let thousandths = u64::from(discharge) * 1000 / u64::from(total.max(1));
        match thousandths {
            20.. => Self::River,
            6.. => Self::Creek,
            _ => Self::Brook,
        }
    }

    /// The word for it.
    pub fn generic(self, manner: u32) -> &'static str {
        const GENERICS: [[&str; 3]; 3] =
            [["River", "Creek", "Brook"], ["River", "Beck", "Burn"], ["Water", "Stream", "Rill"]];
        GENERICS[manner as usize % GENERICS.len()][self as usize]
    }
}

/// The name of a river: `X River`, `River X`, `X Water`.
pub(super) fn river(word: &str, size: Size, manner: u32) -> String {
    let generic = size.generic(manner);
    if generic == "River" && (manner / 4).is_multiple_of(2) {
        format!("River {word}")
    } else {
        format!("{word} {generic}")
    }
}

/// The name of the greatest tributary of a river, and its short form: by the side that it comes from, or `Little X`.
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

/// The name of an island, by its square units.
pub(super) fn island(word: &str, area: f32) -> String {
    match area {
        4000.0.. => format!("Isle of {word}"),
        800.0.. => format!("{word} Holm"),
        _ => format!("{word} Skerry"),
    }
}

/// The name of a lake.
pub(super) fn lake(word: &str, area: f32) -> String {
    const MERE: f32 = 5000.0;
    if area < MERE { format!("{word} Mere") } else { format!("Lake {word}") }
}

/// The name of a sea.
pub(super) fn sea(word: &str, area: f32, manner: u32) -> String {
    const SOUND: f32 = 40_000.0;
    match manner / 32 % 3 {
        _ if area < SOUND => format!("{word} Sound"),
        0 => format!("Gulf of {word}"),
        _ => format!("The {word} Sea"),
    }
}

/// The name of a map, after its main land.
pub(super) fn title(word: &str, manner: u32) -> String {
    if (manner / 128).is_multiple_of(2) { format!("The Rivers of {word}") } else { format!("{word} and its Waters") }
}

/// Words for a stretch that winds: the first half stand after `The`.
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

/// Whether a folded word is one of those for winding rivers.
pub(super) fn is_winding_word(folded: &[u8]) -> bool {
    WINDING.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(folded))
}

/// The name of a stretch that winds, by some chance: after its bends, or after what winds as it does.
pub(super) fn reach(bits: u32, manner: u32) -> String {
    let which = bits as usize % WINDING.len();
    let word = WINDING[which];
    match bits / WINDING.len() as u32 % 2 {
        0 if which >= WINDING.len() / 2 => format!("{word} {}", Size::River.generic(manner)),
        _ => format!("The {word}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_river_s_size_is_its_share_of_all_water() {
        let sizes = [20, 19, 6, 5].map(|thousandths| Size::of(thousandths, 1000));
        assert_eq!(sizes, [Size::River, Size::Creek, Size::Creek, Size::Brook]);
        assert_eq!(Size::of(u32::MAX, 1), Size::River);
        assert_eq!(Size::of(0, 0), Size::Brook);
    }

    #[test]
    fn forks_are_named_by_the_side_that_they_come_from() {
        let sides = [[3.0, 1.0], [-3.0, 1.0], [1.0, -3.0], [1.0, 3.0]].map(|from| fork("Dellen", from, 8)[0].clone());
        assert_eq!(sides, ["East", "West", "North", "South"].map(|side| format!("{side} Fork of the Dellen")));
        assert_eq!(fork("Dellen", [1.0, 0.0], 0)[0], "Little Dellen");
        assert_eq!(fork("Dellen", [1.0, 0.0], 8)[1], "East Fork");
    }

    #[test]
    fn the_kinds_have_their_forms() {
        assert_eq!(
            [0, 4, 1, 2].map(|manner| river("Dellen", Size::River, manner)),
            ["River Dellen", "Dellen River", "River Dellen", "Dellen Water"]
        );
        assert_eq!(river("Dellen", Size::Brook, 1), "Dellen Burn");
        assert_eq!(
            [9e3, 1e3, 2e2].map(|area| island("Dellen", area)),
            ["Isle of Dellen", "Dellen Holm", "Dellen Skerry"]
        );
        assert_eq!([9e3, 1e3].map(|area| lake("Dellen", area)), ["Lake Dellen", "Dellen Mere"]);
        assert_eq!([0, 32].map(|manner| sea("Dellen", 1e5, manner)), ["Gulf of Dellen", "The Dellen Sea"]);
        assert_eq!(sea("Dellen", 1e4, 0), "Dellen Sound");
        assert_eq!([0, 128].map(|manner| title("Dellen", manner)), ["The Rivers of Dellen", "Dellen and its Waters"]);
        assert_eq!([0, 24, 72].map(|bits| reach(bits, 0)), ["The Meanders", "Snake River", "The Snake"]);
    }
}
