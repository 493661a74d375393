//! What is known of the vertices of a draw: `draw/vertex_facts.rs` finds it.

/// What is known of the vertices of a draw of the fixed function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct VertexFacts {
    /// Whether the alpha of vertices passes the alpha test, wherever it is interpolated.
    pub alpha_passes: bool,
    /// Whether alpha is 1 at all of them, by state: it is interpolated to the bit.
    pub alpha_is_one: bool,
    /// Whether all lie before the start of linear fog.
    pub is_before_fog: bool,
}

impl VertexFacts {
    /// Whether anything is known that vertices of a later draw of the same state may not have.
    pub fn is_of_contents(self) -> bool {
        self.alpha_passes || self.is_before_fog
    }
}
