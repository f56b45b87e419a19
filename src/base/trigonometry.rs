//! Sines and cosines.

/// Returns the sine and cosine of an angle of up to π, either way, by power series, as exactly as numbers allow. A general
/// function carries a table of π's digits, a hundredth of the page's module.
pub(crate) fn sine_and_cosine(angle: f32) -> (f32, f32) {
    /// The reciprocals of the factorials of 1, 3, 5 … and of 0, 2, 4 …, with alternating signs.
    const SINE: [f64; 12] = series(1);
    const COSINE: [f64; 12] = series(0);
    let (angle, squared) = (f64::from(angle), f64::from(angle) * f64::from(angle));
    let sum = |series: &[f64; 12]| series.iter().rev().fold(0.0, |sum, factor| sum * squared + factor);
    ((angle * sum(&SINE)) as f32, sum(&COSINE) as f32)
}

const fn series(first: u32) -> [f64; 12] {
    let (mut factors, mut i, mut factor) = ([0.0; 12], 0, 1.0);
    while i < 12 {
        factors[i] = factor;
        let next = first + 2 * i as u32;
        factor /= -(((next + 1) * (next + 2)) as f64);
        i += 1;
    }
    factors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_are_those_of_libm() {
        for i in -3141..=3141 {
            let angle = i as f32 / 1000.0;
            let (sine, cosine) = sine_and_cosine(angle);
            assert!((sine - libm::sinf(angle)).abs() < 2e-7 && (cosine - libm::cosf(angle)).abs() < 2e-7, "{angle}");
        }
    }
}
