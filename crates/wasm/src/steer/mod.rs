//! The package `steer`: `make`, and what a page adds by which people steer a map: drafts while a slider moves, moments
//! back and forth, layers over growth, parts of a map, drawn land, fresh seeds.

mod drafts;
mod growing;
mod outline;
mod picture;
mod timeline;
