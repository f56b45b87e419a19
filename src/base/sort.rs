//! Sorting by one kind of key, digit by digit. Each kind of sort in the standard library would add four kilobytes to
//! the wasm file, and most lists sorted here are short.

/// Returns the positions of keys in ascending order of the keys. Equal keys keep their order.
pub(crate) fn argsort(keys: impl IntoIterator<Item = u32>) -> Vec<usize> {
    order_of(&keys.into_iter().collect::<Vec<u32>>())
}

#[inline(never)] // one copy, whatever the keys come from
fn order_of(keys: &[u32]) -> Vec<usize> {
    // Each key is stored with its position, so that a long list is read in sequence and not looked up all over memory.
    let items = (0..).zip(keys).map(|(i, &key): (u64, _)| u64::from(key) << 32 | i).collect();
    sorted_from(items).into_iter().map(|item| item as u32 as usize).collect()
}

/// Returns items in ascending order of their keys. Equal ones keep their order.
pub(crate) fn sorted_by<T: Copy>(items: &[T], key: impl FnMut(&T) -> u32) -> Vec<T> {
    argsort(items.iter().map(key)).into_iter().map(|i| items[i]).collect()
}

/// Returns items in ascending order of their upper halves. Items that are equal in these keep their order.
#[inline(never)] // one copy
fn sorted_from(mut items: Vec<u64>) -> Vec<u64> {
    /// The most items that are sooner sorted one by one than digit by digit.
    const FEW: usize = 24;
    if items.len() <= FEW {
        insert_each(&mut items);
        return items;
    }
    let mut sorted = items.clone();
    let differing = items.iter().fold(0, |differing, item| differing | (item ^ items[0]));
    // Digits are sorted from the lowest to the highest. Each pass keeps the order of the previous ones among equal
    // digits.
    for shift in (u32::BITS..u64::BITS).step_by(8).filter(|shift| (differing >> shift) as u8 != 0) {
        by_digit(&items, &mut sorted, shift);
        std::mem::swap(&mut items, &mut sorted);
    }
    items
}

/// Sorts items by moving each before those whose upper halves are greater, keeping the order of equal ones.
fn insert_each(items: &mut [u64]) {
    for next in 1..items.len() {
        let item = items[next];
        let is_greater = |other: &u64| other >> u32::BITS > item >> u32::BITS;
        let place = items[..next].iter().rposition(|other| !is_greater(other)).map_or(0, |before| before + 1);
        items.copy_within(place..next, place + 1);
        items[place] = item;
    }
}

/// Sorts items by one byte, keeping the order of equal ones (counting sort).
fn by_digit(items: &[u64], sorted: &mut [u64], shift: u32) {
    const DIGITS: usize = 256;
    let digit = |item: u64| (item >> shift) as usize % DIGITS;
    let mut places = [0; DIGITS];
    items.iter().for_each(|&item| places[digit(item)] += 1);
    let mut first = 0;
    for place in &mut places {
        first += std::mem::replace(place, first);
    }
    for &item in items {
        let place = &mut places[digit(item)];
        sorted[*place] = item;
        *place += 1;
    }
}

/// Returns a copy of the values in ascending order.
pub(crate) fn sorted(values: &[f32]) -> Vec<f32> {
    argsort(values.iter().map(|&value| key(value))).into_iter().map(|i| values[i]).collect()
}

/// Returns the quantile of values: the least for a share of 0, the greatest for 1; 0 if there are none.
pub(crate) fn quantile(values: &[f32], share: f32) -> f32 {
    let index = (share * values.len().saturating_sub(1) as f32) as usize;
    sorted(values).get(index).copied().unwrap_or(0.0)
}

/// Returns a whole number that stands for a number in sorts: they are ordered as by `f32::total_cmp`.
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
