//! Reading of files that recipes are made from.

pub mod png;
