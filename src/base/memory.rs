//! Memory is requested before it is used, so that a shortage is an error instead of an abort.
//!
//! Tests can limit the size of lists to see each refusal: `testing::with_lists_up_to`.

/// A request for memory that was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Refused;

/// Returns `true` if this many bytes can be allocated. They are freed at once, for the next allocation.
pub(crate) fn can_allocate(bytes: usize) -> bool {
    is_allowed(bytes) && Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}

/// Checks that memory is available for lists of the standard library that are made soon after.
pub(crate) fn ask(bytes: usize) -> Result<(), Refused> {
    if can_allocate(bytes) { Ok(()) } else { Err(Refused) }
}

/// Reserves room for `more` items or, so that many small requests are cheap, for a larger number.
#[inline(never)] // one copy for each kind of list
pub(crate) fn reserve<T>(list: &mut Vec<T>, more: usize) -> Result<(), Refused> {
    if !is_allowed((list.len() + more).saturating_mul(size_of::<T>())) {
        return Err(Refused);
    }
    list.try_reserve(more).map_err(|_| Refused)
}

/// Extends a list to a length with copies of an item, and leaves no spare room.
#[inline(never)] // one copy for each kind of list
pub(crate) fn lengthen<T: Clone>(list: &mut Vec<T>, length: usize, item: T) -> Result<(), Refused> {
    if !is_allowed(length.saturating_mul(size_of::<T>())) {
        return Err(Refused);
    }
    list.try_reserve_exact(length.saturating_sub(list.len())).map_err(|_| Refused)?;
    list.resize(length, item);
    Ok(())
}

#[cfg(not(test))]
fn is_allowed(_: usize) -> bool {
    true
}

#[cfg(test)]
use testing::is_allowed;

#[cfg(test)]
pub(crate) mod testing {
    use std::cell::Cell;

    thread_local! {
        /// The greatest number of bytes that this thread may request at once.
        static MOST: Cell<usize> = const { Cell::new(usize::MAX) };
    }

    pub(super) fn is_allowed(bytes: usize) -> bool {
        bytes <= MOST.get()
    }

    /// Runs some work on this thread with lists limited to a number of bytes.
    pub(crate) fn with_lists_up_to<Done>(bytes: usize, work: impl FnOnce() -> Done) -> Done {
        let before = MOST.replace(bytes);
        let done = work();
        MOST.set(before);
        done
    }
}

#[cfg(test)]
mod tests {
    use super::testing::with_lists_up_to;
    use super::*;

    #[test]
    fn more_than_there_can_be_is_refused_and_less_is_given() {
        assert!(can_allocate(1000) && !can_allocate(usize::MAX) && !can_allocate(isize::MAX as usize));
        let mut list = vec![1u64];
        assert_eq!(reserve(&mut list, usize::MAX / 2), Err(Refused));
        assert_eq!(lengthen(&mut list, isize::MAX as usize, 2), Err(Refused));
        assert_eq!((lengthen(&mut list, 3, 2), &list[..]), (Ok(()), &[1, 2, 2][..]));
    }

    #[test]
    fn limit_of_a_test_counts_what_a_list_has_already() {
        let mut list = vec![0u64; 10];
        with_lists_up_to(100, || {
            assert!(can_allocate(100) && !can_allocate(101));
            assert_eq!((reserve(&mut list, 2), reserve(&mut list, 3)), (Ok(()), Err(Refused)));
        });
        assert_eq!(reserve(&mut list, 3), Ok(()));
    }
}
