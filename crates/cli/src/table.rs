//! `riverseed table`: the page of all parameters, `docs/parameters.md`, by group.

use std::io::{self, Write};

use riverseed::recipe::choice::Word;
use riverseed::recipe::preset::{PRESETS, Preset};
use riverseed::recipe::table::TABLE;
use riverseed::recipe::{Kind, LONGEST_OUTLINE, Parameter, is_decided};

const INTRODUCTION: &str = "\
# Parameters

<!-- Written by `make docs` from the parameter table, src/recipe/rows.rs: change it there. -->

A recipe is a value for each of these parameters. One that is left out has its default or, if the default is in italics, the value of its
country, which the word draws: see [Countries](algorithms.md#countries). The value in italics is the *usual* one, which `country=usual` has
for every word. Name a value to keep it whatever the word; `auto` (`sea=auto`) leaves it to the country again. The same keys are used in links
(`seed=kauri&valleys=0.6`), as command-line options (`--valleys 0.6`), in JSON recipes, and as attributes of `<river-seed>`, where
`style` and `width` are written `river-style` and `river-width`. The tables below follow the groups of the page's controls.

Numbers keep four decimal places. Units of length:

- a *unit* is a domain unit: the map's area is always a million square units, whatever its aspect. On the ground it is `span` kilometres divided by
  the map's width in units: 158 m at the default aspect and a span of 200 km;
- a *spacing* is the distance between streams that growth begins with: in space colonization the mean distance between attractors,
  √(area of land that has river mouths / `attractors`); in drainage, and where `valleys` lead space colonization, √(usual area of land / `attractors`),
  whatever the actual sea: the mean distance between parcels; in a Brownian tree, for `clearance`, its `sensitivity`;
- a *width* is the width of the river at that point;
- a *node* is one step of growth;
- a *parcel* is a piece of land that drains itself, in drainage.
";

const NOTES: &str = "
## Drawn land

`land=drawn` reads coasts, ridges and rivers from `outline`. Each line starts with a dot for a coast, two dots for a ridge or three for a
river, followed by its points. A point is four base64url characters: two for its distance from the west edge, two for its distance from the
north edge, each a whole number from 0 to 4095 across the domain. A point is on land if it is inside an odd number of coasts. Where a coast runs along the
map's edge, the land continues beyond that edge.

A river is drawn from its mouth, which may be all that is drawn of it. The mouth comes to lie on the nearest coast, or where the line comes
ashore; without any coast, on the nearest edge of the map. Where rivers are drawn, there are no other mouths: `mouths`, `mouth-spacing`,
`shores` and `sides` have no effect, and land without a mouth stays dry. A course is followed as far as neither water nor a ridge is in its
way, and all courses together over 8,000 units. It is there before anything grows, and the rest of the tree grows from it. For example,
`land=drawn&outline=...AAgAMzczTMmZgAgAmZTM...zM-t` draws no coast, a river that flows west, and a mouth in the south.

`riverseed outline` makes an outline from a PNG. White is land; black and transparent are water; a third colour, or a mid grey, is a
ridge. A thin ridge becomes a line along its middle; a wide one becomes the outline of an area without rivers. The command reports how
much of the image fitted into the outline. An image longer than 4:1 is centred on the map, and what touches its long edges is extended to
the map's edge. [`riverseed render --land`](command-line.md#a-picture-as-the-land) takes the PNG itself as the land, in full detail.

## Trimming

A branch's length is that of its nodes: one `step` each in space colonization, a spacing in drainage, 1.1 units on average in a Brownian
tree. `trim` is rounded to whole nodes. In a Brownian tree, and in drainage with `mouths=0`, unless mouths are
drawn, rivers that reach the sea on their own are trimmed too if they are shorter than that; the longest one always stays. In drainage, rivers are trimmed after `channel-area` has decided
where they begin.

## Own names

`names` gives names of your own to at most 40 things: `names=203367.Silver+Water_m203367.The+Old+Man_214329._c48025.Cape+Anna_t.Home`. An entry is a
mark, a full stop and a name of at most 40 characters; an underscore ends it. No name after the full stop takes a thing's name away. `riverseed names`
prints the marks of a map.

| mark | what it names |
| --- | --- |
| `t` | the map: its title |
| `i0` | the main land |
| `203367` | a river, by its identity |
| `m203367` | the stretch where that river meanders |
| `s98158` | a sea |
| `b52101` | a bay or a gulf |
| `l56107` | a lake |
| `i30120` | an island |
| `c48025` | a cape |
| `n57109` | a strait |
| `h37074` | a range of mountains or hills, in styles that show heights |

The number of a river is that of a square of 2 units through which it runs: 1000 · row + column, counted from 0 from the north and the west. If the map has no
river with the number, the nearest one takes the name, if it runs within 6 units of the square.

The number of a place is that of the cell of 8 units in which its midst lies, counted alike. The nearest
place of the kind takes the name, if its midst is within 48 units and half its size of the mark (the size of a sea, lake or island is the side of a square of
its area, that of a bay the width of its mouth, that of a strait or range its length). So a name stays where it is when the coast moves a little. A mark that the map has
not is kept and does nothing.

A seed that can be a name is the name of the country: the title, and the name of the main land. It has letters and digits that EB Garamond has, with spaces, `&`,
`.`, apostrophes and hyphens between them, at most 24 characters. Other seeds get a made-up word; but a seed in a script that EB Garamond has not is the country's name as it
was typed, on pages and in files, and its words in such letters are left out on the map. If only one of `t` and `i0` is given, the other follows it.

Case does not count for what grows from a seed: `Kauri` and `kauri` are one country, with the same names of rivers, and only the title keeps what was typed. That holds for the
Latin letters of Latin-1, Latin Extended-A and Vietnamese but `İ` and `ẞ`, for Greek without its ancient accents and for Cyrillic; case counts in all other alphabets. Links,
files and their names keep the seed as it was typed.

Own names get their places before any made-up one, on pictures some 560 pixels wide and larger in any way that can be read: in letters down to 70 % of their size, level in two
lines beside the river, or with a hairline that leads to it. Where even that has no room, the river's card on the page says so.

Each name makes a link longer by its own length and some seven characters more; letters other than those of English count six or nine each. Ten names take some 200
characters. Links of 2,000 characters work everywhere; longer ones, to which 1,200 characters of names in another script can come, may be cut by mail and chat programs.
Files hold names as they were typed; control characters, and those that turn the direction of writing, are refused. On pages an entry that is wrong is left out, a name that is too long is cut, and each
is told by itself; the command line refuses them. On the map a character that EB Garamond has no letter for is left out.

## Limits

Growth always ends. Drainage makes one node per parcel and one per river mouth; space colonization makes at most 10 nodes per attractor,
and 10,000 besides; a Brownian tree makes at most one node per cell of the land's grid. So the recipe limits how much memory is used.
";

/// Writes the page.
pub fn print() -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(INTRODUCTION.as_bytes())?;
    for group in groups() {
        write_group(&mut out, group)?;
    }
    write_presets(&mut out)?;
    out.write_all(NOTES.as_bytes())
}

/// Lists the groups. Those used by every growth method or by the default one come first; the others follow in the order of
/// their parameters, as in the page's panel.
fn groups() -> Vec<&'static str> {
    let mut groups = vec!["Seed", "Land", "Growth", "Drainage"];
    for parameter in &TABLE {
        if !groups.contains(&parameter.group) {
            groups.push(parameter.group);
        }
    }
    groups
}

fn write_group(out: &mut impl Write, group: &str) -> io::Result<()> {
    let rows = || TABLE.iter().filter(|parameter| parameter.group == group);
    writeln!(out, "\n## {group}\n\n| key | values | default | what it does |\n| --- | --- | --- | --- |")?;
    for parameter in rows() {
        let usual = parameter.text_of(&parameter.default_value());
        let default = if is_decided(parameter.key) { format!("*{usual}*") } else { usual };
        writeln!(out, "| `{}` | {} | {default} | {} |", parameter.name, values(parameter), parameter.help)?;
    }
    for parameter in rows() {
        if let Kind::Choice { choices, .. } = parameter.kind {
            write_choices(out, parameter.name, choices)?;
        }
    }
    Ok(())
}

fn write_choices(out: &mut impl Write, key: &str, choices: &[Word]) -> io::Result<()> {
    writeln!(out, "\n| `{key}` | what it is |\n| --- | --- |")?;
    choices.iter().try_for_each(|word| writeln!(out, "| `{}` | {} |", word.name, word.help))
}

fn write_presets(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "\n## Presets\n")?;
    writeln!(
        out,
        "`preset=NAME` in a link sets several parameters. It is read first, wherever it stands, so that other keys"
    )?;
    writeln!(out, "override it. Links that Riverseed writes contain the values, not the preset's name.\n")?;
    writeln!(out, "| preset | how it looks | what it sets |\n| --- | --- | --- |")?;
    PRESETS
        .iter()
        .try_for_each(|preset| writeln!(out, "| `{}` | {} | {} |", preset.name, preset.help, settings(preset)))
}

/// Writes the values of a preset as link text, each separate so that a line can break between them.
fn settings(preset: &Preset) -> String {
    let settings = preset.values.iter().map(|(key, value)| format!("`{}={value}`", key.parameter().name));
    settings.collect::<Vec<_>>().join(" ")
}

/// Writes a parameter's range in words.
pub fn values(parameter: &Parameter) -> String {
    let unit = if parameter.unit.is_empty() { String::new() } else { format!(" {}", parameter.unit) };
    match parameter.kind {
        Kind::Text { longest, .. } => format!("text, at most {longest} characters"),
        Kind::Integer { min, max, .. } if min == max => min.to_string(),
        Kind::Integer { min, max, .. } => format!("{min} to {max}{unit}"),
        Kind::Number { min, max, .. } => format!("{min} to {max}{unit}"),
        Kind::Choice { choices, .. } => choices.iter().map(|word| word.name).collect::<Vec<_>>().join(", "),
        Kind::Sides { .. } => "some of n, e, s, w".into(),
        Kind::Outline => format!("text, at most {LONGEST_OUTLINE} characters: see [below](#drawn-land)"),
    }
}
