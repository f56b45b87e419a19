//! Asking for memory before it is taken, so that too little of it is an error and not the end.

/// Whether so many bytes are to be had. They are given back at once: what asks for them next finds them there.
pub(crate) fn is_to_be_had(bytes: usize) -> bool {
    Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}
