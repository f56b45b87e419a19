//! The names of all that is on a finished map.

use riverseed::Map;
use riverseed::annotate::names::Names;
use riverseed::land::Region;

/// The names of a map, with the regions of its places.
pub(super) struct Named {
    /// Marks with their names.
    pub names: Vec<(String, String)>,
    pub of: Names,
    pub regions: Vec<Region>,
}

impl Named {
    /// Names all that is on a finished map.
    pub fn of(map: &Map) -> Self {
        let (of, regions) = Names::with_regions(map);
        let marked = of.marked(map.network()).into_iter();
        let names = marked.map(|(mark, name)| (mark.to_string(), name.into())).collect();
        Self { names, of, regions }
    }

    /// Returns the marks of the last `count` things: meanders and places come last, in their order.
    pub fn last_marks(&self, count: usize) -> impl Iterator<Item = &str> {
        self.names[self.names.len() - count..].iter().map(|(mark, _)| mark.as_str())
    }
}
