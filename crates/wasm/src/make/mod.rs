//! The package `make`: takes a recipe to its pixels, for page and element alike.

mod drafts;
mod growing;
mod link;
mod outline;
mod river;
mod timeline;
