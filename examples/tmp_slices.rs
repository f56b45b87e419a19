use riverseed::{Picture, Session};
fn main() {
    for link in std::env::args().skip(1) {
        let grown = |ticks: u32| {
            let mut s = Session::new(link.parse().unwrap()).unwrap();
            let mut p = Picture::new(200, 200).unwrap();
            while s.advance(ticks).unwrap() {
                p.paint(&s);
            }
            p.paint(&s);
            p.pixmap().data().to_vec()
        };
        let a = grown(u32::MAX);
        for t in [1, 7] {
            let b = grown(t);
            let diff: Vec<usize> =
                a.chunks(4).zip(b.chunks(4)).enumerate().filter(|(_, (x, y))| x != y).map(|(i, _)| i).collect();
            println!(
                "{link} {t}: {} differ, first {:?}",
                diff.len(),
                diff.iter()
                    .take(5)
                    .map(|i| (i % 200, i / 200, &a[4 * i..4 * i + 3], &b[4 * i..4 * i + 3]))
                    .collect::<Vec<_>>()
            );
        }
    }
}
