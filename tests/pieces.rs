//! Pieces of maps beside pieces of real rivers.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use riverseed::analyse::statistics::Look;
use riverseed::import::png;
use riverseed::recipe::link;
use riverseed::session::Session;

/// The pieces of the world's maps.
fn real() -> Vec<Look> {
    const COLUMNS: usize = 12;
    let file = include_bytes!("real-rivers/snippets.png");
    let image = png::read(std::io::Cursor::new(file)).unwrap();
    let pixel = |x: usize, y: usize| u8::from(image.rgba[4 * (y * image.width as usize + x)] > 127);
    let piece = |tile: usize| -> Vec<u8> {
        let (left, top) = (tile % COLUMNS * 100, tile / COLUMNS * 100);
        (0..10_000).map(|i| pixel(left + i % 100, top + i / 100)).collect()
    };
    (0..96).filter_map(|tile| Look::of_piece(&piece(tile))).collect()
}

#[test]
fn probe() {
    let real = real();
    println!("real {} {:?}", real.len(), Look::typical(&real));
    for dozen in real.chunks(12) {
        println!("  {:?}", Look::typical(dozen));
    }
    println!("interleaved");
    for i in 0..8 {
        println!("  {:?}", Look::typical(&real.iter().skip(i).step_by(8).copied().collect::<Vec<_>>()));
    }
    let mut old = Vec::new();
    let mut session = Session::new(link::read("attractors=500").unwrap()).unwrap();
    session.finish().unwrap();
    let sample = session.network().unwrap().rivers[0].clone();
    for seed in 0..12 {
        let text = std::fs::read_to_string(format!("/tmp/meas/o/t{seed}.net")).unwrap();
        let mut network = riverseed::network::Network::default();
        for line in text.lines().skip(1) {
            let words: Vec<&str> = line.split(' ').collect();
            let start = network.vertices.len() as u32;
            for p in words[4..].chunks(3) {
                let at = glam::Vec2::new(p[0].parse().unwrap(), p[1].parse().unwrap());
                let mut vertex = riverseed::network::Vertex::default();
                vertex.at = at;
                network.vertices.push(vertex);
            }
            let end = network.vertices.len() as u32;
            let none = riverseed::network::NONE;
            let mut river = sample.clone();
            (river.start, river.end, river.junction, river.parent) = (start, end, none, none);
            network.rivers.push(river);
        }
        let size = glam::Vec2::new(1264.9111, 790.5694);
        let length = riverseed::analyse::statistics::total_length(&network);
        old.extend(Look::all(&network, size, (length / f64::from(size.x * size.y)) as f32));
    }
    println!("old {} {:?}", old.len(), Look::typical(&old));
    let mut all = Vec::new();
    for seed in 0..12 {
        let mut session = Session::new(link::read(&format!("land=rectangle&sides=s&seed=s{seed}")).unwrap()).unwrap();
        session.finish().unwrap();
        let map = session.map().unwrap();
        let size = map.domain().size;
        let length = riverseed::analyse::statistics::total_length(map.network());
        let start = std::time::Instant::now();
        let own = Look::all(map.network(), size, (length / f64::from(size.x * size.y)) as f32);
        println!("{} {:?} {:?}", own.len(), start.elapsed(), Look::typical(&own));
        all.extend(own);
    }
    println!("today {} {:?}", all.len(), Look::typical(&all));
}
