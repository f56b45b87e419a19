//! Statistics of a network: Horton's ratio of bifurcation, sinuosity and drainage density: `cargo run --example
//! statistics`.

use std::error::Error;

use riverseed::network::{Network, River};
use riverseed::{Recipe, Session};

/// Statistics of a network.
#[derive(Debug)]
pub struct Statistics {
    /// The number of rivers that end with each of Strahler's orders, from order 1.
    pub rivers: Vec<usize>,
    /// The mean ratio of the number of rivers of an order to that of the next (Horton 1945); 3 to 5 in nature.
    pub bifurcation: f64,
    /// The mean ratio of a river's length to the distance between its ends.
    pub sinuosity: f64,
    /// The length of all rivers divided by the area of the map, in units per square unit.
    pub density: f64,
}

impl Statistics {
    /// Computes the statistics of a network on land of an area, in square units.
    pub fn of(network: &Network, area: f64) -> Self {
        let highest = network.rivers.iter().map(|river| river.order).max().unwrap_or(0);
        let of_order = |order: u8| network.rivers.iter().filter(|river| river.order == order).count();
        let rivers: Vec<usize> = (1..=highest).map(of_order).collect();
        let ratios: Vec<f64> = rivers.windows(2).map(|pair| pair[0] as f64 / pair[1].max(1) as f64).collect();
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len().max(1) as f64;
        let each = |measure: &dyn Fn(&River) -> f32| -> Vec<f64> {
            network.rivers.iter().map(|river| f64::from(measure(river))).collect()
        };
        Self {
            bifurcation: mean(&ratios),
            sinuosity: mean(&each(&|river| network.sinuosity(river))),
            density: each(&|river| network.length(river)).iter().sum::<f64>() / area,
            rivers,
        }
    }
}

/// Computes the statistics of a recipe's rivers.
pub fn statistics(link: &str) -> Result<Statistics, Box<dyn Error>> {
    let recipe: Recipe = link.parse()?;
    let mut session = Session::new(recipe)?;
    let area = session.domain().size;
    Ok(Statistics::of(session.finish()?, f64::from(area.x * area.y)))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{:#?}", statistics("seed=kauri&growth=drainage&land=rectangle")?);
    Ok(())
}
