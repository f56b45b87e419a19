//! Flow directions: each parcel drains to a neighbour or off the land.

/// Marks a missing parcel.
pub(super) const NONE: u32 = u32::MAX;

/// A forest of parcels, rooted at outlets.
#[derive(Clone, Debug, Default)]
pub(super) struct FlowDirections {
    /// The destination of each parcel: a neighbour, [`OUT`](Self::OUT), or [`NONE`] while it is not known.
    pub to: Vec<u32>,
    /// The parcels with a known destination, each after the one it drains to.
    pub order: Vec<u32>,
}

impl FlowDirections {
    /// Marks a parcel that drains through its own outlet.
    pub const OUT: u32 = u32::MAX - 1;

    /// Begins with no known destination.
    pub fn new(parcels: usize) -> Self {
        Self { to: vec![NONE; parcels], order: Vec::with_capacity(parcels) }
    }

    /// Returns the number of parcels that each parcel drains, itself included (flow accumulation); 0 where nothing is known.
    pub fn areas(&self) -> Vec<u32> {
        let mut areas = vec![0; self.to.len()];
        for &here in self.order.iter().rev() {
            let area = areas[here as usize] + 1;
            areas[here as usize] = area;
            if let Some(below) = areas.get_mut(self.to[here as usize] as usize) {
                *below += area;
            }
        }
        areas
    }
}
