//! File names that contain a seed, whatever its text.

use std::fs;
use std::path::{Path, PathBuf};

use super::super::{Failure, hash};

/// The placeholder of the seed.
pub const PLACE: &str = "{seed}";

/// The reason why two outputs of a call are refused.
pub const MEETS: &str =
    "two outputs may write the same file: in one folder, use '{seed}.' followed by different endings";

/// An output whose name has a place for the seed.
pub struct Pattern {
    folder: PathBuf,
    before: String,
    after: String,
}

impl Pattern {
    /// # Errors
    /// Fails if the last part of the path does not have exactly one place for the seed, or if a folder has one.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        let refused = |reason| Failure::Pattern { path: path.into(), reason };
        let folder = path.parent().unwrap_or(Path::new(""));
        if folder.to_string_lossy().contains(PLACE) {
            return Err(refused("'{seed}' may stand in the name of the file, not in that of a folder"));
        }
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let (before, after) =
            name.split_once(PLACE).ok_or_else(|| refused("for --seeds the output's name has to hold '{seed}'"))?;
        if after.contains(PLACE) {
            return Err(refused("'{seed}' may stand in the name only once"));
        }
        Ok(Self { folder: folder.into(), before: before.into(), after: after.into() })
    }

    /// Returns the file of a seed. Different seeds have different files, even on disks that ignore case.
    pub fn path(&self, seed: &str) -> PathBuf {
        self.folder.join(format!("{}{}{}", self.before, escaped(seed), self.after))
    }

    /// Returns `true` if a file of some seed may also be one of another pattern. Escaped seeds contain no dots.
    pub fn may_meet(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|pattern| pattern.after.to_lowercase());
        let are_told_apart = own != others && [&own, &others].iter().all(|after| after.starts_with('.'));
        let is_alike = self.before.to_lowercase() == other.before.to_lowercase();
        self.is_beside(other) && !(is_alike && are_told_apart)
    }

    fn is_beside(&self, other: &Self) -> bool {
        let place = |folder: &Path| fs::canonicalize(Path::new(".").join(folder));
        match (place(&self.folder), place(&other.folder)) {
            (Ok(own), Ok(others)) => own == others,
            _ => true,
        }
    }
}

/// Puts the escaped seed into each place for it in a text. An escaped seed in a path names no other folder.
///
/// # Errors
/// Fails if there is a place for the seed and the seed is empty: the path would be that of the folder above.
pub fn with_seed(text: &str, seed: &str) -> Result<String, Failure> {
    match text.contains(PLACE) {
        true if seed.is_empty() => {
            Err(Failure::Pattern { path: text.into(), reason: "'{seed}' stands for nothing, since the seed is empty" })
        }
        true => Ok(text.replace(PLACE, &escaped(seed))),
        false => Ok(text.into()),
    }
}

/// The greatest length of an escaped seed, in bytes. Most disks allow names of 255.
const LONGEST: usize = 200;

/// Escapes a seed for a file name: lower-case ASCII letters, digits, `-` and `_` stay; every other byte of UTF-8
/// becomes `%` and two digits. A longer result ends in `%h` and a hash.
fn escaped(seed: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_';
    let is_reserved = is_device(seed);
    let mut parts = (0..).zip(seed.bytes()).map(|(i, byte)| match byte {
        _ if i == 0 && is_reserved => percent(byte),
        // Programs take a name that begins with a hyphen for an option.
        b'-' if i > 0 => "-".into(),
        _ if is_plain(byte) => char::from(byte).into(),
        _ => percent(byte),
    });
    let mut name = String::new();
    let hash = format!("%h{:032x}", hash::of(seed.as_bytes()));
    let room = LONGEST - hash.len();
    let mut cut = 0;
    for part in parts.by_ref() {
        name += &part;
        if name.len() <= room {
            cut = name.len();
        }
    }
    if name.len() <= LONGEST {
        return name;
    }
    name.truncate(cut);
    name + &hash
}

fn percent(byte: u8) -> String {
    format!("%{byte:02X}")
}

/// Returns `true` if Windows takes a name for a device, whatever its ending.
fn is_device(name: &str) -> bool {
    let is_numbered = |device: &str| {
        name.strip_prefix(device)
            .is_some_and(|number| number.len() == 1 && number.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(name, "con" | "prn" | "aux" | "nul") || is_numbered("com") || is_numbered("lpt")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_become_names_that_any_disk_tells_apart() {
        let names = [
            ("kea", "kea"),
            ("Kea", "%4Bea"),
            ("te awa", "te%20awa"),
            ("te-awa_9", "te-awa_9"),
            ("-rf", "%2Drf"),
            ("", ""),
            (".", "%2E"),
            ("../../etc/passwd", "%2E%2E%2F%2E%2E%2Fetc%2Fpasswd"),
            ("c:\\x", "c%3A%5Cx"),
            ("a%20b", "a%2520b"),
            ("kea.heights", "kea%2Eheights"),
            ("ā", "%C4%81"),
            ("a\u{304}", "a%CC%84"),
            ("nul", "%6Eul"),
            ("lpt1", "%6Cpt1"),
            ("lpt12", "lpt12"),
            ("console", "console"),
        ];
        for (seed, name) in names {
            assert_eq!(escaped(seed), name);
        }
    }

    #[test]
    fn names_of_long_seeds_are_short_and_no_two_are_the_same() {
        let long = |last: &str| escaped(&format!("{}{last}", "\u{1f30a}".repeat(63)));
        let (one, other) = (long("a"), long("b"));
        assert!(one.len() <= LONGEST && other.len() <= LONGEST);
        assert!(one != other && one.starts_with("%F0%9F%8C%8A%F0"), "{one}");
        let (_, hash) = one.split_once("%h").unwrap();
        assert!(hash.len() == 32 && hash.bytes().all(|byte| byte.is_ascii_hexdigit()), "{one}");
        assert_eq!(escaped(&"K".repeat(64)).len(), 192, "what is short enough is whole");
    }

    #[test]
    fn outputs_that_may_name_one_file_are_told() {
        let meet = |a: &str, b: &str| Pattern::of(Path::new(a)).unwrap().may_meet(&Pattern::of(Path::new(b)).unwrap());
        assert!(!meet("{seed}.json", "{seed}.heights.png"));
        assert!(!meet("a-{seed}.png", "a-{seed}.heights.png"));
        assert!(meet("{seed}.png", "./{seed}.PNG"));
        assert!(meet("{seed}.png", "a{seed}.json"), "however they end");
        assert!(meet("{seed}-a.png", "{seed}.png"), "of the seeds 'k' and 'k-a'");
        assert!(!meet("src/{seed}.png", "tests/{seed}.png"));
    }

    #[test]
    fn place_of_the_seed_is_one_in_the_file_s_name() {
        for path in ["a.json", "{seed}/a.json", "{seed}/{seed}.json", "{seed}{seed}.json", "{seed.json"] {
            assert!(Pattern::of(Path::new(path)).is_err(), "{path}");
        }
        let pattern = Pattern::of(Path::new("out/map-{seed}.x.json")).unwrap();
        assert_eq!(pattern.path("a/b"), Path::new("out/map-a%2Fb.x.json"));
    }
}
