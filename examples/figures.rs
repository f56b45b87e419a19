//! Draws the figures of `docs/algorithms.md` into its folder: `cargo run --example figures`.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use glam::Vec2;
use riverseed::network::Network;
use riverseed::{Phase, Recipe, Session, Vertex, glam};

/// A figure's file name and its drawing.
type Figure = (&'static str, fn() -> Result<String, Box<dyn Error>>);

/// All figures.
pub const FIGURES: [Figure; 2] = [("growth.svg", growth), ("meanders.svg", meanders)];

/// The gap between two panels, in units.
const GAP: f32 = 40.0;

/// Space colonization at three moments: attractors with lines to the nodes that they pull, and the tree.
fn growth() -> Result<String, Box<dyn Error>> {
    let recipe: Recipe = "seed=rata&growth=colonize&valleys=0&land=rectangle&sides=s&aspect=1&mouths=2&attractors=160&scatter=random&reach=2.3&kill=1.1&\
                          step=0.38&momentum=0&curl=0"
        .parse()?;
    let mut session = Session::new(recipe)?;
    let mut panels = Vec::new();
    for share in [0.08, 0.45, 1.0] {
        while session.phase() == Phase::Growing && session.progress() < share {
            session.advance(1)?;
        }
        panels.push(colonized(&session)?);
    }
    Ok(side_by_side(&panels, session.domain().size)?)
}

fn colonized(session: &Session) -> Result<String, std::fmt::Error> {
    let (mut panel, tree) = (String::new(), session.tree());
    let (reach, kill) = (session.growth().settings().reach, session.growth().settings().kill);
    let (mut pulls, mut live, mut removed) = (Vec::new(), Vec::new(), Vec::new());
    for attractor in session.growth().scattered() {
        let distance = |node: &Vec2| node.distance(attractor);
        let nearest = tree.at.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = nearest.filter(|node| distance(node) <= reach);
        match nearest {
            Some(node) if distance(node) < kill => removed.push([attractor; 2]),
            Some(node) => {
                pulls.push([attractor, *node]);
                live.push([attractor; 2]);
            }
            None => live.push([attractor; 2]),
        }
    }
    let steps = (0..tree.len()).filter_map(|node| Some([tree.at[tree.parent_of(node)?], tree.at[node]]));
    let steps: Vec<_> = steps.collect();
    // A line from a point to itself with round ends is a dot.
    for (lines, colour, width) in
        [(&removed, "#e0d6c0", 14.0), (&pulls, "#d9a441", 2.0), (&live, "#b3541e", 14.0), (&steps, "#1d4e89", 6.0)]
    {
        draw_lines(&mut panel, lines.iter().map(|line| line.as_slice()), colour, width)?;
    }
    Ok(panel)
}

/// The same rivers after 0, 50 and 150 rounds of meandering, with their oxbow lakes.
fn meanders() -> Result<String, Box<dyn Error>> {
    let recipe: Recipe =
        "seed=weka&growth=drainage&land=rectangle&sides=s&aspect=1&mouths=1&attractors=160&valleys=0.2&captures=5&\
                          channel-area=6&trim=22&simplify=80&width=22&flat-share=0.6&\
                          meander=flow&meander-rounds=150&meander-strength=0.8"
            .parse()?;
    let mut session = Session::new(recipe)?;
    let mut panels = Vec::new();
    for rounds in [0, 50, 150] {
        while session.rounds().is_none_or(|made| made < rounds) {
            session.advance(1)?;
        }
        panels.push(session.network().map(courses).transpose()?.unwrap_or_default());
    }
    Ok(side_by_side(&panels, session.domain().size)?)
}

fn courses(network: &Network) -> Result<String, std::fmt::Error> {
    let mut panel = String::new();
    for oxbow in &network.oxbows {
        draw(&mut panel, &oxbow.vertices, "#8fb8d8")?;
    }
    for river in network.rivers.iter().rev() {
        draw(&mut panel, &network.course(river).copied().collect::<Vec<_>>(), "#1d4e89")?;
    }
    Ok(panel)
}

/// A river or a lake along its centerline, in stretches of even width.
fn draw(panel: &mut String, course: &[Vertex], colour: &str) -> std::fmt::Result {
    const STRETCH: usize = 12;
    for start in (0..course.len().saturating_sub(1)).step_by(STRETCH) {
        let stretch = &course[start..course.len().min(start + STRETCH + 1)];
        let width = stretch.iter().map(Vertex::width).sum::<f32>() / stretch.len() as f32;
        let line: Vec<Vec2> = stretch.iter().map(|vertex| vertex.at).collect();
        draw_lines(panel, [line.as_slice()].into_iter(), colour, width + 2.0)?;
    }
    Ok(())
}

fn draw_lines<'a>(
    panel: &mut String,
    lines: impl Iterator<Item = &'a [Vec2]>,
    colour: &str,
    width: f32,
) -> std::fmt::Result {
    write!(panel, r#"<path stroke="{colour}" stroke-width="{width:.1}" d=""#)?;
    for line in lines {
        let mut points = line.iter().map(|point| point.round().as_ivec2());
        let Some(mut last) = points.next() else { continue };
        write!(panel, "M{} {}", last.x, last.y)?;
        for point in points {
            write!(panel, "l{} {}", point.x - last.x, point.y - last.y)?;
            last = point;
        }
    }
    writeln!(panel, "\"/>")
}

/// Panels of one size in a row, on a white ground.
fn side_by_side(panels: &[String], size: Vec2) -> Result<String, std::fmt::Error> {
    let width = (size.x + GAP) * panels.len() as f32 + GAP;
    let height = size.y + 2.0 * GAP;
    let mut out = String::new();
    writeln!(out, r#"<svg xmlns="http://www.w3.org/2000/svg" width="900" viewBox="0 0 {width:.0} {height:.0}">"#)?;
    writeln!(out, r##"<rect width="{width:.0}" height="{height:.0}" fill="#fff"/>"##)?;
    for (panel, number) in panels.iter().zip(0..) {
        let left = GAP + (size.x + GAP) * number as f32;
        writeln!(out, r#"<svg x="{left:.0}" y="{GAP:.0}" width="{:.0}" height="{:.0}">"#, size.x, size.y)?;
        writeln!(out, r##"<rect width="100%" height="100%" fill="#fbf8f1" stroke="#c9bfa8" stroke-width="4"/>"##)?;
        writeln!(out, r#"<g fill="none" stroke-linecap="round" stroke-linejoin="round">"#)?;
        writeln!(out, "{panel}</g>\n</svg>")?;
    }
    writeln!(out, "</svg>")?;
    Ok(out)
}

/// Writes the figures into a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    for (name, draw) in FIGURES {
        std::fs::write(folder.join(name), draw()?)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    write(Path::new("docs/figures"))
}
