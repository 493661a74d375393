//! The fixed-function vertex stage: GL 2.1, sections 2.11 and 2.14, without lighting.

use super::{clamp, word};
use crate::interface::*;
use rasterizer::ir::{Builder, Input, Module, Op, Output, Stage, Ty, Value};

/// The state that changes the code.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct VertexKey {
    /// First uniform word of the fixed function.
    pub base: u32,
    /// The units whose texture matrix is not the identity, bit by unit.
    pub matrices: u8,
}

fn attribute(b: &mut Builder, location: u8) -> [Value; 4] {
    [0, 1, 2, 3].map(|component| b.input(Input::Attribute { location, component }))
}

/// A matrix, whose words are column by column, times a vector: columns summed from the left.
fn transform(b: &mut Builder, first: u32, vector: [Value; 4]) -> [Value; 4] {
    [0, 1, 2, 3].map(|row| {
        let mut products = [0, 1, 2, 3].map(|column| {
            let element = b.uniform(first + 4 * column + row, Ty::F32);
            b.op(Op::Mul, &[element, vector[column as usize]])
        });
        for column in 1..4 {
            products[column] = b.op(Op::Add, &[products[column - 1], products[column]]);
        }
        products[3]
    })
}

fn write(b: &mut Builder, output: Output, value: Value) {
    let var = b.output(output);
    b.store(var, value);
}

/// Generates the stage. It writes every varying of the fixed function; the driver leaves out what
/// the fragment stage does not read.
pub(super) fn module(key: &VertexKey) -> Module {
    let mut b = Builder::new(Stage::Vertex);
    let position = attribute(&mut b, ATTRIB_VERTEX);
    let clip = transform(&mut b, key.base + word::MVP, position);
    for (component, value) in (0..).zip(clip) {
        write(&mut b, Output::Position(component), value);
    }
    // Section 2.14.6: colours are clamped.
    for (location, slot) in
        [(ATTRIB_COLOR, VARYING_COLOR), (ATTRIB_SECONDARY_COLOR, VARYING_SECONDARY_COLOR)]
    {
        for (slot, value) in (slot..).zip(attribute(&mut b, location)) {
            let value = clamp(&mut b, value);
            write(&mut b, Output::Varying(slot), value);
        }
    }
    for unit in 0..MAX_TEXTURE_UNITS {
        let mut coords = attribute(&mut b, ATTRIB_TEX_COORD + unit);
        if key.matrices >> unit & 1 == 1 {
            let first = key.base + word::TEXTURE_MATRIX + 16 * u32::from(unit);
            coords = transform(&mut b, first, coords);
        }
        let first = VARYING_TEX_COORD + 4 * u16::from(unit);
        for (slot, value) in (first..).zip(coords) {
            write(&mut b, Output::Varying(slot), value);
        }
    }
    b.finish()
}
