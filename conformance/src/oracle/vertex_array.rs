//! Which element of an array a vertex has, and which vertices a draw has (GL 3.3, sections 2.8.1, 2.8.2 and 2.8.3).

use crate::mutation::{Mutation, Variant};

/// The element of an array with a divisor: the vertex's for 0, else `floor(instance / divisor)`.
pub fn element(divisor: usize, vertex: usize, instance: usize, variant: Variant) -> usize {
    match divisor {
        0 => vertex,
        _ if variant.has(Mutation::DivisorIgnored) => instance,
        d if variant.has(Mutation::DivisorRounds) => (2 * instance + d) / (2 * d),
        d => instance / d,
    }
}

/// What an index of a draw stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// A vertex: its number in the arrays, which `gl_VertexID` is, too.
    Vertex(i64),
    /// The next strip begins.
    Restart,
}

/// The index is compared with the restart index before the base is added to it.
pub fn index(word: u32, base: i64, restart: Option<u32>, variant: Variant) -> Index {
    let shown =
        if variant.has(Mutation::RestartAfterBase) { i64::from(word) + base } else { word.into() };
    if restart.is_some_and(|restart| shown == i64::from(restart)) {
        return Index::Restart;
    }
    let base = if variant.has(Mutation::BaseVertexIgnored) { 0 } else { base };
    Index::Vertex(i64::from(word) + base)
}

/// The lines of line strips with restarts.
pub fn lines(indices: &[Index], variant: Variant) -> Vec<[i64; 2]> {
    let mut lines = Vec::new();
    let mut before = None;
    for index in indices {
        match *index {
            Index::Restart if variant.has(Mutation::RestartIgnored) => {}
            Index::Restart => before = None,
            Index::Vertex(vertex) => {
                if let Some(before) = before {
                    lines.push([before, vertex]);
                }
                before = Some(vertex);
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn instances_share_elements() {
        let elements = [0, 1, 2, 3, 4, 5].map(|instance| element(3, 9, instance, TRUE));
        assert_eq!(elements, [0, 0, 0, 1, 1, 1]);
        assert_eq!(element(0, 9, 4, TRUE), 9);
    }

    #[test]
    fn restarts_by_hand() {
        let indices = [1, 2, 255, 3, 4, 5].map(|word| index(word, 10, Some(255), TRUE));
        assert_eq!(lines(&indices, TRUE), [[11, 12], [13, 14], [14, 15]]);
        assert_eq!(index(245, 10, Some(255), TRUE), Index::Vertex(255));
    }
}
