//! Putting things in order, all by one kind of key: every kind of sort adds four kilobytes to the wasm file, and most of
//! what there is to sort here is short.

/// The positions of keys in ascending order of the keys; of equal ones, the earlier first.
pub(crate) fn ascending(keys: impl IntoIterator<Item = u32>) -> Vec<usize> {
    let mut keyed: Vec<u64> = (0..).zip(keys).map(|(i, key)| u64::from(key) << 32 | i).collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|key| (key & u64::from(u32::MAX)) as usize).collect()
}

/// The same of values that are copied out in ascending order.
pub(crate) fn sorted(values: &[f32]) -> Vec<f32> {
    ascending(values.iter().map(|&value| key(value))).into_iter().map(|i| values[i]).collect()
}

/// A number's key: as `f32::total_cmp` orders numbers.
pub(crate) fn key(value: f32) -> u32 {
    let bits = value.to_bits();
    if bits >> 31 == 1 { !bits } else { bits | 1 << 31 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
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
            prop_assert_eq!(ascending(keys), expected);
        }
    }
}
