//! The package `steer`: `make`, and what the page adds to it: drafts while a slider moves, moments back and forth, layers
//! over growth, parts of a map, drawn land, fresh seeds.

mod drafts;
mod growing;
mod outline;
mod picture;
mod seed;
mod timeline;
