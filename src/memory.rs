//! Asking for memory before it is taken, so that too little of it is an error and not the end.
//!
//! A test of this crate says how large a list may become, and so sees each refusal: `testing::with_lists_up_to`.

/// There was not enough memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Refused;

/// Whether this many bytes can be allocated. They are freed at once, for the next allocation.
pub(crate) fn can_allocate(bytes: usize) -> bool {
    is_allowed(bytes) && Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}

/// Asks for bytes that lists of the standard library take soon after.
pub(crate) fn ask(bytes: usize) -> Result<(), Refused> {
    if can_allocate(bytes) { Ok(()) } else { Err(Refused) }
}

/// Makes room for at least this many more items, and for more at once, so that many small requests cost little.
pub(crate) fn reserve<T>(list: &mut Vec<T>, more: usize) -> Result<(), Refused> {
    if !is_allowed((list.len() + more).saturating_mul(size_of::<T>())) {
        return Err(Refused);
    }
    list.try_reserve(more).map_err(|_| Refused)
}

/// Makes a list as long as this, of one item, with no room for more.
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
        /// The most bytes that this thread may ask for at once.
        static MOST: Cell<usize> = const { Cell::new(usize::MAX) };
    }

    pub(super) fn is_allowed(bytes: usize) -> bool {
        bytes <= MOST.get()
    }

    /// Does some work on this thread where no list may have more bytes than this.
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
