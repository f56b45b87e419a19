//! Rasters: water runs down from every cell of land to the sea, along rivers, and files hold what was computed.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::io::Cursor;

use crate::common::lands::every_land;
use crate::common::property::cases;
use crate::common::random_link;
use crate::common::tier::{first, one_in, pairs, tiers};
use glam::Vec2;
use png::{BitDepth, ColorType, Decoder};
use proptest::prelude::*;
use riverseed::export::rasters::{LINK_KEYWORD, Layer, Rasters, Values};
use riverseed::export::{ExportError, pack, png as to_png};
use riverseed::network::NONE;
use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::relief::{CELL_SIZE, Grid};
use riverseed::scale::USUAL_METRES;
use riverseed::session::Session;

fn finished(text: &str) -> Session {
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

/// The cell that water runs to; `None` off the map, and at sea.
fn next(rasters: &Rasters, cell: usize) -> Option<usize> {
    rasters.flow().next(&rasters.relief().grid(), cell)
}

/// The cells around one that lie on the map.
fn around(rasters: &Rasters, cell: usize) -> Vec<usize> {
    let (row, column) = (cell / rasters.columns, cell % rasters.columns);
    let rows = row.saturating_sub(1)..(row + 2).min(rasters.rows);
    let columns = column.saturating_sub(1)..(column + 2).min(rasters.columns);
    rows.flat_map(|row| columns.clone().map(move |column| row * rasters.columns + column)).collect()
}

fn heights_of_16_bits(rasters: &Rasters) -> Vec<u16> {
    match rasters.values(Layer::Heights) {
        Values::Words(words) => words,
        Values::Bytes(_) => panic!("no 16 bits"),
    }
}

/// Water runs down from everywhere, and all that meets is of one basin.
fn check_flow(session: &Session, rasters: &Rasters) {
    let (flow, heights) = (rasters.flow(), rasters.relief().heights());
    let mouths = session.network().unwrap().rivers.iter().filter(|river| river.parent == NONE).count();
    assert_eq!(flow.mouths.len(), mouths);
    let words = heights_of_16_bits(rasters);
    let is_own = rasters.cell_size == CELL_SIZE;
    let has_sea = heights.iter().any(|height| *height <= 0.0);
    for cell in 0..heights.len() {
        if heights[cell] <= 0.0 {
            assert_eq!((flow.directions[cell], flow.basins[cell]), (0, 0), "sea");
            continue;
        }
        assert_eq!(flow.directions[cell].count_ones(), 1, "water stays on land at {cell}");
        // Lower at every step, it reaches the sea.
        if let Some(next) = next(rasters, cell) {
            // In a lake it runs along the bed, and on finer grids also where the shore cuts a corner.
            let lake = |cell: usize| rasters.lakes().get(cell).filter(|lake| **lake != NONE);
            let is_level = lake(cell).is_some() && (lake(next) == lake(cell) || !is_own);
            assert!(is_level || heights[next] < heights[cell], "water runs uphill");
            assert!(is_level || words[next] < words[cell], "water runs on the level in 16 bits, from {cell} to {next}");
            let stays = heights[next] > 0.0;
            assert!(!stays || flow.basins[next] == flow.basins[cell], "a basin leaks");
            assert!(!stays || flow.rivers[cell] == NONE || flow.rivers[next] != NONE, "a river ends on land");
        } else if has_sea {
            let lower = around(rasters, cell).into_iter().find(|&beside| heights[beside] < heights[cell]);
            assert_eq!(lower, None, "water leaves the map above land, at {cell}");
        }
        assert!(flow.basins[cell] as usize <= mouths);
    }
}

/// A PNG as grey values, with its texts.
fn read(file: &[u8]) -> (usize, usize, Values, Vec<(String, String)>) {
    let mut reader = Decoder::new(Cursor::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    let info = reader.info();
    assert_eq!(info.color_type, ColorType::Grayscale);
    let values = match info.bit_depth {
        BitDepth::Sixteen => {
            Values::Words(bytes.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect())
        }
        _ => Values::Bytes(bytes),
    };
    let texts = info.uncompressed_latin1_text.iter().map(|chunk| (chunk.keyword.clone(), chunk.text.clone())).collect();
    (info.width as usize, info.height as usize, values, texts)
}

fn file(rasters: &Rasters, layer: Layer) -> Vec<u8> {
    let mut file = Vec::new();
    to_png::write_raster(&mut file, rasters, layer).unwrap();
    file
}

/// A file holds each height to half a step, by what it says of itself, but where a cell has to stand a step above the next.
fn check_heights(rasters: &Rasters) {
    let (columns, rows, values, texts) = read(&file(rasters, Layer::Heights));
    let text = |keyword: &str| &texts.iter().find(|(own, _)| own == keyword).unwrap().1;
    assert_eq!((columns, rows, text(LINK_KEYWORD)), (rasters.columns, rasters.rows, &rasters.link));
    let (step, sea) = (text("metres-a-step").parse::<f64>().unwrap(), text("sea-level").parse::<f64>().unwrap());
    let Values::Words(values) = values else { panic!("no 16 bits") };
    let mut levels = BTreeMap::new();
    for (cell, &height) in rasters.relief().heights().iter().enumerate() {
        let (value, rounded) = (values[cell], rasters.scale.step(height));
        let lake = rasters.lakes().get(cell).filter(|lake| **lake != NONE);
        let is_raised = || lake.is_some() || next(rasters, cell).is_some_and(|next| value == values[next] + 1);
        assert!(value == rounded || (value > rounded && is_raised()), "{value} for {rounded} at {cell}");
        if let Some(lake) = lake {
            let level = levels.entry(lake).or_insert(value);
            assert_eq!(*level, value, "a lake slopes at {cell}");
        }
        let (value, metres) = (rounded, (f64::from(rounded) - sea) * step);
        let off = (metres - f64::from(height * rasters.map_scale.metres_up)).abs();
        // The step is written with six decimals.
        assert!(off <= 0.5 * step + 0.04 || (f64::from(value) == sea + 1.0 && off <= step), "{metres} for {height}");
        assert_eq!(f64::from(value) > sea, height > 0.0, "land and sea");
    }
}

/// The height in metres by which a river's cell stands above the lowest bank that water would leave it over: one that
/// does not touch its next cell.
fn dam(rasters: &Rasters, cell: usize) -> f32 {
    let heights = rasters.relief().heights();
    let place = |cell: usize| Vec2::new((cell % rasters.columns) as f32, (cell / rasters.columns) as f32);
    let touch = |one: usize, other: usize| (place(one) - place(other)).abs().max_element() < 1.5;
    let Some(next) = next(rasters, cell) else { return 0.0 };
    let is_bank = |&bank: &usize| {
        let is_dry = rasters.flow().rivers.get(bank) == Some(&NONE) && heights[bank] > 0.0;
        is_dry && touch(bank, cell) && !touch(bank, next)
    };
    around(rasters, cell)
        .into_iter()
        .filter(is_bank)
        .map(|bank| (heights[cell] - heights[bank]) * USUAL_METRES)
        .fold(0.0, f32::max)
}

fn no_river_of_finer_grids_stands_on_a_dam() {
    let maps = [("land=basin", 700), ("land=island", 2049), ("land=archipelago", 1025), ("growth=colonize", 1025)];
    for (text, size) in one_in(4, maps) {
        let session = finished(&format!("country=usual&seed=kea&{text}&attractors=3000"));
        let rasters = Rasters::with_size(&session.map().unwrap(), size).unwrap();
        let rivers = (0..rasters.columns * rasters.rows).filter(|&cell| rasters.flow().rivers[cell] != NONE);
        let dams: Vec<f32> = rivers.map(|cell| dam(&rasters, cell)).collect();
        // Without a measure against it 2 to 12 in 100, and 20 metres high.
        let dams_of = |metres: f32| dams.iter().filter(|&&dam| dam > metres).count();
        eprintln!(
            "{text}, {size}: {} of {}, {} {:?}",
            dams_of(0.1),
            dams.len(),
            dams_of(1.0),
            dams.iter().max_by(|a, b| a.total_cmp(b))
        );
        assert!(dams.len() > 2000 && dams_of(0.1) * 200 < dams.len() && dams_of(4.0) == 0, "{text}, {size}");
    }
}

tiers!(no_river_of_finer_grids_stands_on_a_dam);

proptest! {
    #![proptest_config(first(4, cases(24)))]

    fn water_runs_to_the_sea_from_everywhere(text in random_link(2500)) {
        let session = finished(&text);
        let rasters = Rasters::new(&session.map().unwrap()).unwrap();
        check_flow(&session, &rasters);
        check_heights(&rasters);
    }
}

tiers!(water_runs_to_the_sea_from_everywhere);

fn water_runs_to_the_sea_on_usual_maps() {
    for (land, growth) in one_in(7, pairs(every_land(), ["drainage", "colonize", "brownian&sensitivity=24"])) {
        let session = finished(&format!("country=usual&seed=kea&{land}&growth={growth}&attractors=3000"));
        let rasters = Rasters::new(&session.map().unwrap()).unwrap();
        check_flow(&session, &rasters);
        let flow = rasters.flow();
        assert!(!flow.mouths.is_empty() && flow.basins.iter().any(|&basin| basin > 0), "{land}, {growth}");
    }
}

tiers!(water_runs_to_the_sea_on_usual_maps);

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    #[ignore = "second tier"]
    fn water_runs_to_the_sea_from_everywhere_on_rasters_of_any_size(text in random_link(1200), share in 0.0f32..0.3) {
        let session = finished(&text);
        let sizes = Grid::sizes(&session.domain());
        let size = sizes.start() + ((sizes.end() - sizes.start()) as f32 * share) as u32;
        let rasters = Rasters::with_size(&session.map().unwrap(), size).unwrap();
        check_flow(&session, &rasters);
        check_heights(&rasters);
    }
}

#[test]
#[ignore = "second tier"]
fn water_runs_to_the_sea_on_rasters_of_several_sizes_of_every_land() {
    for land in every_land() {
        let session = finished(&format!("country=usual&seed=tui&{land}&attractors=1200"));
        for size in [800, 1400] {
            let rasters = Rasters::with_size(&session.map().unwrap(), size).unwrap();
            check_flow(&session, &rasters);
            check_heights(&rasters);
        }
    }
}

fn mouths_at_the_border_without_a_cell_of_sea_beside_them_lead_off_the_map() {
    for (seed, size) in one_in(4, pairs(["a", "d", "g", "k", "m", "t"], [None, Some(800), Some(1025), Some(1400)])) {
        let session = finished(&format!(
            "country=usual&seed={seed}&land=valley&sea=0.1767&sides=nsw&growth=brownian&sensitivity=10&meander=flow\
             &meander-rounds=40&great-rivers=16"
        ));
        let map = session.map().unwrap();
        let rasters = size.map_or_else(|| Rasters::new(&map), |size| Rasters::with_size(&map, size)).unwrap();
        check_flow(&session, &rasters);
        check_heights(&rasters);
        let leaves = |cell: usize| rasters.relief().heights()[cell] > 0.0 && next(&rasters, cell).is_none();
        let leaving: Vec<_> = (0..rasters.columns * rasters.rows).filter(|&cell| leaves(cell)).collect();
        assert!(leaving.iter().all(|&cell| rasters.flow().basins[cell] > 0), "{size:?}: all are rivers' mouths");
    }
}

tiers!(mouths_at_the_border_without_a_cell_of_sea_beside_them_lead_off_the_map);

/// The distance of a point from a segment.
fn distance(point: Vec2, from: Vec2, to: Vec2) -> f32 {
    let way = to - from;
    let share = (point - from).dot(way) / way.length_squared().max(f32::MIN_POSITIVE);
    (from + way * share.clamp(0.0, 1.0)).distance(point)
}

#[test]
fn water_follows_rivers() {
    // Within a cell's diagonal: a path may take a corner.
    const NEAR: f32 = 3.0;
    for text in [
        "country=usual&seed=kea&attractors=3000",
        "country=usual&seed=rimu&attractors=3000&growth=colonize&land=rectangle",
    ] {
        let session = finished(text);
        let (rasters, network) = (Rasters::new(&session.map().unwrap()).unwrap(), session.network().unwrap());
        let (mut steps, mut astray) = (0, 0);
        for river in network.rivers.iter().filter(|river| river.order > 1) {
            let source = network.vertices[river.start as usize].at / 2.0;
            let mut cell = Some(source.y as usize * rasters.columns + source.x as usize);
            while let Some(at) = cell.filter(|&cell| rasters.relief().heights()[cell] > 0.0) {
                let own = rasters.flow().rivers[at];
                let here = Vec2::new((at % rasters.columns) as f32 + 0.5, (at / rasters.columns) as f32 + 0.5) * 2.0;
                let far = network.rivers.get(own as usize).map_or(f32::INFINITY, |own| {
                    let course: Vec<_> = network.course(own).map(|vertex| vertex.at).collect();
                    course.windows(2).map(|pair| distance(here, pair[0], pair[1])).fold(f32::INFINITY, f32::min)
                });
                steps += 1;
                astray += usize::from(far > NEAR);
                cell = next(&rasters, at);
            }
        }
        assert!(steps > 1000 && astray * 50 < steps, "{text}: {astray} of {steps}");
    }
}

#[test]
fn any_style_has_the_same_rasters_and_the_highest_land_of_default_maps_is_a_mountain() {
    for seed in ["kauri", "rimu", "kea"] {
        let rasters = Rasters::new(&finished(&format!("country=usual&seed={seed}")).map().unwrap()).unwrap();
        let highest = rasters.scale.metres(u16::MAX);
        assert!((600.0..3000.0).contains(&highest), "{seed}: {highest} m");
    }
    let with = |style: &str| {
        Rasters::new(&finished(&format!("country=usual&seed=kea&attractors=800&style={style}")).map().unwrap()).unwrap()
    };
    for layer in Layer::ALL {
        assert_eq!(with("ink").values(layer), with("atlas").values(layer), "{layer:?}");
    }
}

#[test]
fn every_raster_is_read_back_as_it_was() {
    let session = finished("country=usual&seed=kea&attractors=800&land=valley");
    let rasters = Rasters::new(&session.map().unwrap()).unwrap();
    for layer in Layer::ALL {
        let (columns, rows, values, texts) = read(&file(&rasters, layer));
        assert_eq!((columns, rows), (rasters.columns, rasters.rows));
        assert!(values == rasters.values(layer), "{layer:?}");
        assert!(texts.contains(&("Description".into(), rasters.meaning(layer))));
    }
    let Values::Words(widths) = rasters.values(Layer::Rivers) else { panic!() };
    let widest = session.network().unwrap().vertices.iter().map(|vertex| vertex.width()).fold(0.0, f32::max);
    let most = f32::from(*widths.iter().max().unwrap());
    assert!(most <= (widest * 1000.0).ceil() && most > widest * 500.0, "{most} of {widest}");
}

#[test]
fn branches_of_deltas_are_rivers_of_the_raster() {
    let session = finished("country=usual&seed=kauri&land=island&attractors=700&deltas=0.7");
    let map = session.map().unwrap();
    let rasters = Rasters::with_size(&map, 1500).unwrap();
    let Values::Words(widths) = rasters.values(Layer::Rivers) else { panic!() };
    let Values::Bytes(land) = rasters.values(Layer::Land) else { panic!() };
    let branches = &map.deltas().distributaries;
    assert!(branches.len() > 10, "{}", branches.len());
    for place in branches.iter().flat_map(|branch| &branch.line) {
        let [column, row] = (place.at / rasters.cell_size).to_array().map(|along| along as usize);
        let cell = row * rasters.columns + column;
        // Tips lie in the sea.
        let least = if land[cell] > 0 { (2000.0 * place.half) as u16 } else { 0 };
        assert!(widths[cell] >= least, "{} at {}: {} of {least}", column, row, widths[cell]);
    }
}

fn finer_rasters_are_true_to_their_scale_and_water_runs_to_the_sea_on_them() {
    let maps = [
        ("country=usual&seed=kea&attractors=1500", 1025),
        ("country=usual&seed=rimu&attractors=1500&land=rectangle&growth=colonize&aspect=0.7", 1500),
        ("country=usual&seed=matai&land=valley&growth=brownian&sensitivity=24", 2048),
    ];
    for (text, size) in one_in(3, maps) {
        let session = finished(text);
        let rasters = Rasters::with_size(&session.map().unwrap(), size).unwrap();
        let (own, map) = (Rasters::new(&session.map().unwrap()).unwrap(), session.domain().size);
        assert_eq!(rasters.columns.max(rasters.rows), size as usize);
        check_flow(&session, &rasters);
        check_heights(&rasters);
        let (_, _, _, texts) = read(&file(&rasters, Layer::Land));
        let text = |keyword: &str| texts.iter().find(|(own, _)| own == keyword).unwrap().1.clone();
        let [units, metres] = ["units-a-pixel", "metres-a-pixel"].map(|keyword| text(keyword).parse::<f32>().unwrap());
        let longer = units * size as f32;
        assert!((longer - map.max_element()).abs() < 0.01, "{longer}");
        // The usual map is 200 km wide, whatever its shape.
        assert!((metres / units - 200_000.0 / map.x).abs() < 0.1, "{metres} m, {units} units");
        assert!(pack::readme(&rasters).contains(&format!("{} x {} pixels", rasters.columns, rasters.rows)));
        let wide = format!("A pixel is {metres:.2} m wide ({} units of the map)", text("units-a-pixel"));
        assert!(pack::readme(&rasters).contains(&wide), "{wide}");
        // The same land, as a share of the map, and the same rivers.
        let share = |rasters: &Rasters, layer| {
            let Values::Bytes(values) = rasters.values(layer) else { panic!("no bytes") };
            values.iter().filter(|value| **value > 0).count() as f32 * rasters.cell_size * rasters.cell_size / 1e6
        };
        assert!((share(&rasters, Layer::Land) - share(&own, Layer::Land)).abs() < 0.005);
        assert_eq!(rasters.flow().mouths, own.flow().mouths);
        let widest = |rasters: &Rasters| match rasters.values(Layer::Rivers) {
            Values::Words(widths) => widths.into_iter().max(),
            Values::Bytes(_) => None,
        };
        assert_eq!(widest(&rasters), widest(&own), "in thousandths of a unit, however large cells are");
    }
}

tiers!(finer_rasters_are_true_to_their_scale_and_water_runs_to_the_sea_on_them);

#[test]
fn rasters_of_the_map_s_own_size_are_the_usual_ones_and_none_are_coarser_or_too_large() {
    for (aspect, own) in [("1", 500), ("1.5", 613), ("0.25", 1000)] {
        let session = finished(&format!("country=usual&seed=kea&attractors=800&aspect={aspect}"));
        let usual = Rasters::new(&session.map().unwrap()).unwrap();
        let asked = Rasters::with_size(&session.map().unwrap(), own).unwrap();
        assert!(asked == usual, "{aspect}");
        assert!(Layer::ALL.into_iter().all(|layer| file(&asked, layer) == file(&usual, layer)), "{aspect}");
        for size in [0, own - 1, 4098, u32::MAX] {
            let refused = Rasters::with_size(&session.map().unwrap(), size).unwrap_err();
            assert_eq!(refused, ExportError::RasterSize { size, least: own, most: 4097 });
            let text = format!("rasters of this map are from {own} to 4097 pixels long, not {size}");
            assert_eq!(refused.to_string(), text);
        }
    }
}

#[test]
fn square_rasters_hold_the_map_in_their_middle_and_sea_around_it() {
    for (aspect, part) in [("2", [0..708, 177..531]), ("0.5", [177..531, 0..708])] {
        // Land runs to the map's edges.
        let session = finished(&format!("country=usual&seed=kea&attractors=300&land=rectangle&aspect={aspect}"));
        let own = Rasters::new(&session.map().unwrap()).unwrap();
        let square = own.clone().into_squares().unwrap();
        assert_eq!((square.columns, square.rows, own.part()), (708, 708, None), "{aspect}");
        assert_eq!(square.part(), Some(part.clone()), "{aspect}");
        let [columns, rows] = part;
        let numbers = |rasters: &Rasters, layer| match rasters.values(layer) {
            Values::Bytes(bytes) => bytes.into_iter().map(u16::from).collect(),
            Values::Words(words) => words,
        };
        let heights = numbers(&square, Layer::Heights);
        for layer in Layer::ALL {
            let (small, large) = (numbers(&own, layer), numbers(&square, layer));
            assert_eq!(large.len(), 708 * 708);
            for (i, &value) in large.iter().enumerate() {
                let (column, row) = (i % 708, i / 708);
                if columns.contains(&column) && rows.contains(&row) {
                    assert_eq!(value, small[(row - rows.start) * own.columns + column - columns.start]);
                } else if layer == Layer::Water {
                    assert_eq!(value, 255);
                } else if layer == Layer::Depth {
                    // As deep as the floor of the sea says, which goes on: a cell of height and one of depth add up.
                    assert_eq!(u32::from(value) + u32::from(heights[i]), u32::from(own.scale.sea_level));
                } else if layer == Layer::Heights {
                    assert!(value <= own.scale.sea_level, "no land beyond the map: {value}");
                } else {
                    assert_eq!(value, 0, "{layer:?}");
                }
            }
        }
        let readme = pack::readme(&square);
        let from = format!("from column {} and row {}", columns.start, rows.start);
        assert!(readme.contains("A raster has 708 x 708 pixels") && readme.contains(&from), "{readme}");
        assert!(!pack::readme(&own).contains("from column"));
        let texts = square.texts(Layer::Land);
        let place = format!("{} x {} from {}, {}", own.columns, own.rows, columns.start, rows.start);
        assert!(texts.contains(&("map-pixels", place)), "{texts:?}");
    }
    let square = finished("country=usual&seed=kea&attractors=300&aspect=1");
    let own = Rasters::new(&square.map().unwrap()).unwrap();
    assert!(own.clone().into_squares().unwrap() == own, "a square map stays as it is");
}

#[test]
fn pack_holds_every_file() {
    let session = finished("country=usual&seed=kea&attractors=300");
    let mut picture = Picture::new(64, 64).unwrap();
    picture.paint(&session);
    let rasters = Rasters::new(&session.map().unwrap()).unwrap();
    let written = || {
        let mut file = Vec::new();
        pack::write(&mut file, &session.map().unwrap(), &rasters, picture.pixmap()).unwrap();
        file
    };
    let file = written();
    assert_eq!(file, written(), "the same bytes each time");
    let archive = rawzip::ZipArchive::from_slice(&file).unwrap();
    let mut names = Vec::new();
    let mut entries = archive.entries();
    while let Some(entry) = entries.next_entry().unwrap() {
        names.push(entry.file_path().try_normalize().unwrap().as_ref().to_owned());
        let moment = entry.last_modified();
        assert_eq!((moment.year(), moment.month(), moment.day()), (1980, 1, 1), "a date that there is");
    }
    let rasters_of_pack = ["heights.png", "land.png", "rivers.png", "flow.png", "basins.png", "water.png", "depth.png"];
    let wanted = [&["README.txt"], &rasters_of_pack[..], &["map.geojson", "map.png"]].concat();
    assert_eq!(names, wanted);
    let readme = pack::readme(&rasters);
    for name in &wanted[1..] {
        assert!(readme.contains(&format!("\n{name}\n")), "{name}");
    }
}

#[test]
fn rivers_that_a_cutoff_gave_to_another_fall_into_it() {
    let session = finished(
        "country=usual&seed=f&growth=colonize&valleys=0&land=rectangle&aspect=0.25&mouths=3&sides=n&attractors=1233&kill=0.5&step=0.2\
         &momentum=0&trim=0&tributary-spacing=0&width=3&simplify=0&bank-variation=0&meander-rounds=150&meander-strength=1\
         &meander-mix=1&meander-elsewhere=0&great-rivers=9&flat-share=0.9&neck=4&clearance=0&taper=1",
    );
    let rivers = &session.network().unwrap().rivers;
    assert!((0..).zip(rivers).any(|(id, river)| river.parent != NONE && river.parent > id));
    check_flow(&session, &Rasters::new(&session.map().unwrap()).unwrap());
}
