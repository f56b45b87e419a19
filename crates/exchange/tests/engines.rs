//! Files that engines import: heights, textures, rivers and packs, whose recipes have numbers that give back the heights.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::num::NonZero;

use riverseed::Map;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::{DVec3, Vec2};
use riverseed_exchange::engine::{self, Terrain};
use riverseed_exchange::{Engine, Form};
use serde_json::Value;

use crate::maps::{LINKS, file, map, picture, with_beds};

const ENGINES: [Engine; 3] = [Engine::Unreal, Engine::Unity, Engine::Godot];

fn steps(rasters: &Rasters) -> Vec<u16> {
    let Values::Words(steps) = rasters.values(Layer::Heights) else { panic!() };
    steps
}

/// Makes the rasters of a map on its own grid, as squares.
fn squares(map: &Map) -> Rasters {
    Rasters::new(map).unwrap().into_squares().unwrap()
}

/// Reads the files of an archive.
fn unpacked(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let archive = rawzip::ZipArchive::from_slice(bytes).unwrap();
    let (mut entries, mut files) = (archive.entries(), BTreeMap::new());
    while let Some(entry) = entries.next_entry().unwrap() {
        let name = entry.file_path().try_normalize().unwrap().as_ref().to_owned();
        let mut content = Vec::new();
        let compressed = archive.get_entry(entry.wayfinder()).unwrap();
        flate2::read::DeflateDecoder::new(compressed.data()).read_to_end(&mut content).unwrap();
        files.insert(name, content);
    }
    files
}

/// Reads the sides, the pixels and the texts of a PNG.
fn image(bytes: &[u8]) -> ([u32; 2], Vec<u8>, Vec<String>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    let texts = reader.info().uncompressed_latin1_text.iter().map(|chunk| chunk.text.clone()).collect();
    ([reader.info().width, reader.info().height], pixels, texts)
}

#[test]
fn raw_heights_are_the_steps_of_the_raster_little_end_first() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let raw = file(Form::RawHeights, &map, Some(&rasters), None);
        let read: Vec<u16> = raw.chunks(2).map(|bytes| u16::from(bytes[0]) | u16::from(bytes[1]) << 8).collect();
        assert!(read == steps(&rasters), "{link}");
    }
}

#[test]
fn normals_have_length_one_and_face_away_from_where_the_ground_rises() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let (sides, pixels, texts) = image(&file(Form::Normals, &map, Some(&rasters), None));
        assert_eq!(sides, [rasters.columns as u32, rasters.rows as u32]);
        assert!(texts[0] == rasters.link && texts[1].contains("green to the north"), "{texts:?}");
        let (terrain, steps) = (Terrain::of(&rasters), steps(&rasters));
        let step_in_pixels = terrain.metres_a_step / terrain.metres_a_pixel;
        for row in 1..rasters.rows - 1 {
            for column in 1..rasters.columns - 1 {
                let cell = row * rasters.columns + column;
                let [east, north, up] = [0, 1, 2].map(|i| f64::from(pixels[cell * 3 + i]) / 127.5 - 1.0);
                assert!((DVec3::new(east, north, up).length() - 1.0).abs() < 0.015, "{link}");
                let rise =
                    |to: usize, from: usize| (f64::from(steps[to]) - f64::from(steps[from])) * step_in_pixels * 0.5;
                let (eastward, northward) =
                    (rise(cell + 1, cell - 1), rise(cell - rasters.columns, cell + rasters.columns));
                // A part of 8 bits is known to half a step of 2 / 255.
                let near = |part: f64, rise: f64| (part + rise * up).abs() < 0.0045 * (1.0 + rise.abs());
                assert!(near(east, eastward) && near(north, northward), "{link}: {column} {row}");
            }
        }
    }
}

#[test]
fn shares_of_grounds_add_up_and_the_sea_is_all_shore() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let (_, pixels, texts) = image(&file(Form::Splat, &map, Some(&rasters), None));
        assert_eq!(texts[0], rasters.link);
        let Values::Bytes(land) = rasters.values(Layer::Land) else { panic!() };
        let mut seen = [false; 4];
        for (shares, land) in pixels.chunks(4).zip(land) {
            assert_eq!(shares.iter().map(|share| u32::from(*share)).sum::<u32>(), 255, "{link}");
            assert!(land > 0 || shares == [0, 0, 255, 0], "{link}");
            (0..4).for_each(|i| seen[i] |= shares[i] > 127);
        }
        assert!(seen[0] && seen[2], "{link}: {seen:?}");
    }
}

/// Reads the points of all rivers in a file of lines, by the number of the river.
fn lines(json: &Value) -> Vec<Vec<[f64; 5]>> {
    let number = |value: &Value| value.as_f64().unwrap();
    let point = |point: &Value| std::array::from_fn(|i| number(&point[i]));
    let rivers = json["rivers"].as_array().unwrap().iter();
    rivers.map(|river| river["points"].as_array().unwrap().iter().map(point).collect()).collect()
}

#[test]
fn rivers_run_down_on_the_ground_and_end_on_their_parent_or_at_the_sea() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let terrain = Terrain::of(&rasters);
        let json: Value = serde_json::from_slice(&file(Form::Splines, &map, Some(&rasters), None)).unwrap();
        let lines = lines(&json);
        assert_eq!(lines.len(), map.network().rivers.len());
        let mut on_ground = 0;
        for (number, line) in lines.iter().enumerate() {
            assert!(line.windows(2).all(|pair| pair[1][2] <= pair[0][2]), "{link}: river {number} rises");
            assert!(line.iter().all(|point| point[3] >= point[4] && point[4] >= 0.0), "{link}: wider than deep");
            let end = line.last().unwrap();
            match json["rivers"][number]["parent"].as_u64() {
                Some(parent) => {
                    assert!(lines[parent as usize].contains(end), "{link}: river {number} ends beside its parent")
                }
                None => assert_eq!(end[2], 0.0, "{link}: river {number}"),
            }
            for point in line {
                let at = map.domain().size * 0.5
                    + Vec2::new(point[0] as f32, -point[1] as f32) / map.scale().metres_a_unit as f32;
                let ground = terrain.height_between(terrain.corners(at));
                let is_mouth = point == end && json["rivers"][number]["parent"].is_null();
                assert!(
                    is_mouth || point[2] > ground - 0.6,
                    "{link}: river {number} is {} below ground",
                    ground - point[2]
                );
                on_ground += usize::from((point[2] - ground).abs() < 0.6);
            }
        }
        let points = lines.iter().map(Vec::len).sum::<usize>();
        assert!(on_ground * 10 > points * 6, "{link}: {on_ground} of {points} lie on the ground");
    }
}

#[test]
fn lines_of_all_engines_are_the_same_places() {
    let map = map(LINKS[6]);
    let (rasters, picture) = (squares(&map), picture(&map));
    let of = |form, name: Option<&str>| {
        let bytes = file(form, &map, Some(&rasters), Some(&picture));
        let json = name.map_or_else(|| bytes.clone(), |name| unpacked(&bytes)[name].clone());
        lines(&serde_json::from_slice(&json).unwrap()).concat()
    };
    let plain = of(Form::Splines, None);
    let side = (rasters.columns - 1) as f64 * f64::from(rasters.cell_size) * map.scale().metres_a_unit;
    // The map lies in the middle, to half a pixel.
    let half = side * 0.5;
    for engine in ENGINES {
        let own = of(Form::Engine(engine), Some("splines.json"));
        assert_eq!(own.len(), plain.len());
        let mut shift = None;
        for (own, plain) in own.iter().zip(&plain) {
            let [x, y, z, width, depth] = *own;
            let ([east, north, up], unit) = match engine {
                Engine::Unreal => ([x / 100.0 - half, half - y / 100.0, z / 100.0], 0.01),
                Engine::Unity => ([x - half, z - half, y], 1.0),
                Engine::Godot => ([x - half, half - z, y], 1.0),
            };
            let off = [east - plain[0], north - plain[1]];
            let first = *shift.get_or_insert(off);
            assert!(
                (0..2).all(|i| (off[i] - first[i]).abs() < 0.03 && off[i].abs() < 101.0 * 200.0 / 63.0),
                "{engine:?}: {off:?}"
            );
            assert!((up - plain[2]).abs() < 0.02, "{engine:?}");
            assert!((width * unit - plain[3]).abs() < 0.02 && (depth * unit - plain[4]).abs() < 0.02, "{engine:?}");
        }
    }
}

#[test]
fn packs_hold_square_files_of_one_size_and_the_same_bytes_each_time() {
    let map = map(LINKS[4]);
    let (rasters, picture) = (squares(&map), picture(&map));
    let side = rasters.columns as u32;
    assert_eq!(rasters.columns, rasters.rows);
    for engine in ENGINES {
        let bytes = file(Form::Engine(engine), &map, Some(&rasters), Some(&picture));
        assert!(bytes == file(Form::Engine(engine), &map, Some(&rasters), Some(&picture)));
        let files = unpacked(&bytes);
        let readme = String::from_utf8(files["README.txt"].clone()).unwrap();
        assert!(readme.contains(&rasters.link) && readme.contains("UNCHECKED"), "{readme}");
        assert!(files.keys().all(|name| name == "README.txt" || readme.contains(name.as_str())), "{readme}");
        assert_eq!(files["heights.r16"].len() as u32, side * side * 2);
        for (name, bytes) in files.iter().filter(|(name, _)| name.ends_with(".png")) {
            let expected = if name == "map.png" { [120; 2] } else { [side; 2] };
            assert_eq!(image(bytes).0, expected, "{name}");
        }
    }
}

#[test]
fn masks_of_unreal_are_the_channels_of_the_splat_map_and_its_normals_are_upside_down() {
    let map = map(LINKS[2]);
    let (rasters, picture) = (squares(&map), picture(&map));
    let of = |engine| unpacked(&file(Form::Engine(engine), &map, Some(&rasters), Some(&picture)));
    let (unreal, unity, godot) = (of(Engine::Unreal), of(Engine::Unity), of(Engine::Godot));
    let (_, splat, _) = image(&unity["splat.png"]);
    for (channel, ground) in ["low", "steep", "shore", "high"].iter().enumerate() {
        let (_, mask, _) = image(&unreal[&format!("layers/{ground}.png")]);
        assert!(mask.iter().eq(splat.iter().skip(channel).step_by(4)), "{ground}");
    }
    assert!(unity["splat.png"] == godot["splat.png"] && unity["normals.png"] == godot["normals.png"]);
    let (_, up, _) = image(&unity["normals.png"]);
    let (_, down, _) = image(&unreal["normals.png"]);
    let green = |pixels: &[u8], i: usize| i32::from(pixels[i * 3 + 1]);
    assert!((0..up.len() / 3).all(|i| (green(&up, i) + green(&down, i) - 255).abs() <= 1));
}

/// Reads the number after some words in a text.
fn after(text: &str, words: &str) -> f64 {
    let rest = text.split_once(words).unwrap_or_else(|| panic!("'{words}' is not in {text}")).1.trim_start();
    let end = rest.find(|letter: char| !matches!(letter, '0'..='9' | '.' | '-')).unwrap_or(rest.len());
    rest[..end].trim_end_matches('.').parse().unwrap()
}

#[test]
fn numbers_of_the_recipes_give_back_the_heights_and_the_ground() {
    let map = map(LINKS[1]);
    let (rasters, picture) = (squares(&map), picture(&map));
    let readme = |engine| {
        let files = unpacked(&file(Form::Engine(engine), &map, Some(&rasters), Some(&picture)));
        String::from_utf8(files["README.txt"].clone()).unwrap()
    };
    let (unreal, unity, godot) = (readme(Engine::Unreal), readme(Engine::Unity), readme(Engine::Godot));
    let pixel = f64::from(rasters.cell_size) * map.scale().metres_a_unit;
    let side = pixel * (rasters.columns - 1) as f64;
    assert!((after(&unreal, "Scale: X") - pixel * 100.0).abs() < 0.01);
    assert!((after(&unity, "Terrain Size: X") - side).abs() < 0.1);
    assert!((after(&godot, "Vertex Spacing to") - pixel).abs() < 0.001);
    for step in [0u16, 1, rasters.scale.sea_level, 40_000, u16::MAX] {
        let (value, metres) = (f64::from(step), rasters.scale.metres(step));
        let in_unreal = (value - 32_768.0) / 128.0 * after(&unreal, ", Z") + after(&unreal, "Location: Z");
        let in_unity = value / 65_536.0 * after(&unity, ", Y") + after(&unity, "Position: Y");
        let least = after(&godot, "R16 Range:");
        let most = after(godot.split_once("R16 Range:").unwrap().1, " to");
        let in_godot = value / 65_535.0 * (most - least) + least;
        for (engine, found) in [("Unreal", in_unreal / 100.0), ("Unity", in_unity), ("Godot", in_godot)] {
            assert!((found - metres).abs() < 0.02, "{engine}: {step} is {metres}, not {found}");
        }
    }
}

/// Finds the axes whose numbers the step about rivers says to add.
fn added(readme: &str) -> Vec<&str> {
    let (_, step) = readme.split_once("7. Rivers:").unwrap();
    let (axes, _) = step.split_once("Add ").unwrap().1.split_once(" of ").unwrap();
    axes.split([',', ' ']).filter(|word| !matches!(*word, "" | "and")).collect()
}

/// A point of a river, in metres.
struct Afloat {
    /// How far the water is over the ground.
    over_ground: f64,
    /// The depth that the file gives.
    depth: f64,
}

/// Puts a landscape and the points of its rivers into an engine as a README says. Returns the points of each river.
fn afloat(engine: Engine, files: &BTreeMap<String, Vec<u8>>) -> Vec<Vec<Afloat>> {
    let readme = std::str::from_utf8(&files["README.txt"]).unwrap();
    let heights: Vec<f64> =
        files["heights.r16"].chunks(2).map(|bytes| f64::from(u16::from_le_bytes([bytes[0], bytes[1]]))).collect();
    let side = heights.len().isqrt();
    // Where the landscape's corner lies in this world, in the engine's own axes. Its height is that of the README.
    let (corner, pixel, unit) = match engine {
        Engine::Unreal => ([-120_000.0, 34_000.0, after(readme, "Location: Z")], after(readme, "Scale: X"), 0.01),
        Engine::Unity => {
            let pixel = after(readme, "Terrain Size: X") / (side - 1) as f64;
            ([-1200.0, after(readme, "Position: Y"), 340.0], pixel, 1.0)
        }
        Engine::Godot => ([-1200.0, 0.0, 340.0], after(readme, "Vertex Spacing to"), 1.0),
    };
    let steps = |value: f64| match engine {
        Engine::Unreal => (value - 32_768.0) / 128.0 * after(readme, ", Z") + corner[2],
        Engine::Unity => value / 65_536.0 * after(readme, ", Y") + corner[1],
        Engine::Godot => {
            let (least, range) = (after(readme, "R16 Range:"), readme.split_once("R16 Range:").unwrap().1);
            value / 65_535.0 * (after(range, " to") - least) + least
        }
    };
    let axes = added(readme);
    let place = |point: &[f64; 5]| -> [f64; 3] {
        std::array::from_fn(|i| point[i] + if axes.contains(&["X", "Y", "Z"][i]) { corner[i] } else { 0.0 })
    };
    let over_ground = |point: [f64; 5]| {
        let at = place(&point);
        let (column, row, up) = match engine {
            Engine::Unreal => (at[0] - corner[0], at[1] - corner[1], at[2]),
            Engine::Unity => (at[0] - corner[0], (side - 1) as f64 * pixel - (at[2] - corner[2]), at[1]),
            Engine::Godot => (at[0] - corner[0], at[2] - corner[2], at[1]),
        };
        let (column, row) = (column / pixel, row / pixel);
        let ground = |down: usize, right: usize| {
            let nearest = |place: f64, more: usize| (place as usize + more).min(side - 1);
            let share = |place: f64, more: usize| if more == 1 { place.fract() } else { 1.0 - place.fract() };
            let value = heights[nearest(row, down) * side + nearest(column, right)];
            steps(value) * share(row, down) * share(column, right)
        };
        (up - ground(0, 0) - ground(0, 1) - ground(1, 0) - ground(1, 1)) * unit
    };
    let lines = lines(&serde_json::from_slice(&files["splines.json"]).unwrap());
    let afloat = |point: &[f64; 5]| Afloat { over_ground: over_ground(*point), depth: point[4] * unit };
    lines.iter().map(|line| line.iter().map(afloat).collect()).collect()
}

#[test]
fn rivers_that_are_placed_as_the_recipes_say_lie_on_the_landscape() {
    for link in [LINKS[1], LINKS[4]] {
        let map = map(link);
        let (rasters, picture) = (squares(&map), picture(&map));
        for engine in ENGINES {
            let files = unpacked(&file(Form::Engine(engine), &map, Some(&rasters), Some(&picture)));
            // Mouths lie on the sea, wherever the ground is.
            let rivers = afloat(engine, &files);
            let points = rivers.iter().flat_map(|river| &river[..river.len() - 1]);
            let over_ground: Vec<f64> = points.map(|point| point.over_ground).collect();
            let least = over_ground.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(least > -1.0, "{engine:?}: a river is {} m below ground", -least);
            let on_ground = over_ground.iter().filter(|metres| metres.abs() < 1.0).count();
            assert!(
                on_ground * 10 > over_ground.len() * 6,
                "{engine:?}: {on_ground} of {} lie on it",
                over_ground.len()
            );
        }
    }
}

#[test]
fn beds_leave_room_for_half_the_water_at_nearly_all_points_of_rivers() {
    for link in LINKS {
        let map = map(link);
        let (rasters, picture) = (squares(&map), picture(&map));
        for engine in ENGINES {
            let share = |has_beds| {
                let pack = with_beds(Form::Engine(engine), &map, Some(&rasters), Some(&picture), has_beds);
                let points: Vec<Afloat> = afloat(engine, &unpacked(&pack)).into_iter().flatten().collect();
                let has_room = |point: &&Afloat| point.over_ground >= point.depth * 0.5;
                points.iter().filter(has_room).count() as f64 / points.len() as f64
            };
            let (without, with) = (share(false), share(true));
            assert!(with >= 0.95 && without < 0.5, "{link}, {engine:?}: {with}, without beds {without}");
        }
    }
}

/// Returns the place of the cell that a direction in ESRI's codes leads to.
fn next(cell: usize, direction: u8, side: usize) -> Option<usize> {
    let (east, south) = match direction {
        1 => (1, 0),
        2 => (1, 1),
        4 => (0, 1),
        8 => (-1, 1),
        16 => (-1, 0),
        32 => (-1, -1),
        64 => (0, -1),
        128 => (1, -1),
        _ => return None,
    };
    let within = |place: usize, way: isize| place.checked_add_signed(way).filter(|place| *place < side);
    Some(within(cell / side, south)? * side + within(cell % side, east)?)
}

#[test]
fn water_runs_down_over_beds_as_it_did_without_and_no_ground_rises() {
    for link in LINKS {
        let map = map(link);
        let rasters = squares(&map);
        let Values::Bytes(flow) = rasters.values(Layer::Flow) else { panic!() };
        let raw = |has_beds| -> Vec<u16> {
            let bytes = with_beds(Form::RawHeights, &map, Some(&rasters), None, has_beds);
            bytes.chunks(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect()
        };
        let (before, after) = (raw(false), raw(true));
        assert!(before != after && before.iter().zip(&after).all(|(before, after)| after <= before), "{link}");
        for (cell, &direction) in flow.iter().enumerate() {
            if let Some(next) = next(cell, direction, rasters.columns) {
                assert!(after[next] < after[cell], "{link}: water runs up from {cell}");
            }
        }
        // Beds are of rivers: most land is as high as before.
        let lowered = before.iter().zip(&after).filter(|(before, after)| before != after).count();
        assert!(lowered * 2 < flow.iter().filter(|direction| **direction != 0).count(), "{link}: {lowered}");
    }
}

#[test]
fn landscapes_have_the_sizes_of_their_engines() {
    let map = map("country=usual&seed=kauri&land=island&attractors=300&aspect=1");
    let threads = NonZero::<usize>::MIN;
    for (engine, size) in [(Engine::Unreal, 505), (Engine::Unity, 513), (Engine::Godot, 513)] {
        let rasters = engine::rasters(&map, engine, Some(size), threads).unwrap();
        assert_eq!([rasters.columns, rasters.rows], [size as usize; 2]);
        let refused = engine::rasters(&map, engine, Some(size + 1), threads).unwrap_err().to_string();
        assert!(refused.contains(engine::name(engine)) && refused.contains(&format!("{size}, ")), "{refused}");
    }
}
