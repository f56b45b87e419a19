//! Putting things in order, all by one kind of key, and digit by digit: every kind of sort of the standard library adds
//! four kilobytes to the wasm file, and most lists sorted here are short.

/// The positions of keys in ascending order of the keys; of equal ones, the earlier first.
pub(crate) fn argsort(keys: impl IntoIterator<Item = u32>) -> Vec<usize> {
    let keys: Vec<u32> = keys.into_iter().collect();
    let in_place = (0..keys.len()).collect();
    // From the least digit to the greatest: each leaves those equal in it as the lesser ones have put them.
    [0, 8, 16, 24].into_iter().fold(in_place, |order, shift| by_digit(&order, &keys, shift))
}

/// Positions in ascending order of one byte of their keys; of equal ones, the earlier first (counting sort).
fn by_digit(order: &[usize], keys: &[u32], shift: u32) -> Vec<usize> {
    const DIGITS: usize = 256;
    let digit = |i: usize| (keys[i] >> shift) as usize % DIGITS;
    let mut places = [0; DIGITS];
    order.iter().for_each(|&i| places[digit(i)] += 1);
    let mut first = 0;
    for place in &mut places {
        first += std::mem::replace(place, first);
    }
    let mut sorted = vec![0; order.len()];
    for &i in order {
        let place = &mut places[digit(i)];
        sorted[*place] = i;
        *place += 1;
    }
    sorted
}

/// The same of values that are copied out in ascending order.
pub(crate) fn sorted(values: &[f32]) -> Vec<f32> {
    argsort(values.iter().map(|&value| key(value))).into_iter().map(|i| values[i]).collect()
}

/// The value that this many others lie below; 0 if there are no more than that.
pub(crate) fn nth(values: &[f32], below: usize) -> f32 {
    sorted(values).get(below).copied().unwrap_or(0.0)
}

/// The value that a share of all values lies below; 0 of none.
pub(crate) fn quantile(values: &[f32], share: f32) -> f32 {
    nth(values, (values.len() as f32 * share) as usize)
}

/// A number's key: as `f32::total_cmp` orders numbers.
pub(crate) fn key(value: f32) -> u32 {
    let bits = value.to_bits();
    if bits >> 31 == 1 { !bits } else { bits | 1 << 31 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn numbers_come_in_the_order_of_total_cmp(values in proptest::collection::vec(proptest::num::f32::ANY, 0..50)) {
            let mut expected = values.clone();
            expected.sort_by(f32::total_cmp);
            let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&sorted(&values)), bits(&expected));
        }

        #[test]
        fn equal_keys_keep_their_order(keys in proptest::collection::vec(0u32..5, 0..50)) {
            let mut expected: Vec<usize> = (0..keys.len()).collect();
            expected.sort_by_key(|&i| keys[i]);
            prop_assert_eq!(argsort(keys), expected);
        }
    }
}
