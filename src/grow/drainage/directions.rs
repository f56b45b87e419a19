//! Flow directions: where each parcel drains to, a neighbour or out.

/// No parcel.
pub(super) const NONE: u32 = u32::MAX;

/// A forest of parcels, rooted at outlets.
#[derive(Clone, Debug, Default)]
pub(super) struct FlowDirections {
    /// Where each parcel drains to: a neighbour, [`OUT`](Self::OUT), or [`NONE`] as long as that is not known.
    pub to: Vec<u32>,
    /// The parcels that are known, each after the one it drains to.
    pub order: Vec<u32>,
}

impl FlowDirections {
    /// Through the parcel's own outlet.
    pub const OUT: u32 = u32::MAX - 1;

    /// None of these parcels is known yet.
    pub fn new(parcels: usize) -> Self {
        Self { to: vec![NONE; parcels], order: Vec::with_capacity(parcels) }
    }

    /// How many parcels each drains, itself included (flow accumulation); 0 where nothing is known.
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
