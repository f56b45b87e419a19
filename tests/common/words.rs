//! Words that nothing was tuned for.

pub const WORDS: [&str; 12] = [
    "Thornwick",
    "Oslund",
    "Quillmere",
    "Maribel",
    "Brackenfell",
    "Isolde",
    "Pemberley",
    "Zanzara",
    "Fenmarch",
    "Oakhollow",
    "Delphine",
    "Cairnmoor",
];
