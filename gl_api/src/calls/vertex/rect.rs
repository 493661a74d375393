//! `glRect`: GL 2.1, section 2.10.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::{attribute, begin, end};
use crate::context::Context;
use crate::context::immediate::Slot;

/// A polygon from one corner to the opposite one.
fn rectangle(context: &mut Context, [x1, y1]: [f32; 2], [x2, y2]: [f32; 2]) -> Result<()> {
    begin(context, GL_POLYGON)?;
    for [x, y] in [[x1, y1], [x2, y1], [x2, y2], [x1, y2]] {
        attribute(context, Slot::Vertex, [x, y, 0.0, 1.0])?;
    }
    end(context)
}

macro_rules! rectangles {
    ($($name:ident $vector:ident $ty:ty;)*) => { $(
        pub(crate) fn $name(
            context: &mut Context,
            x1: $ty,
            y1: $ty,
            x2: $ty,
            y2: $ty,
        ) -> Result<()> {
            rectangle(context, [x1 as f32, y1 as f32], [x2 as f32, y2 as f32])
        }

        pub(crate) fn $vector(context: &mut Context, v1: &[$ty], v2: &[$ty]) -> Result<()> {
            match (v1.first_chunk::<2>(), v2.first_chunk::<2>()) {
                (Some(v1), Some(v2)) => {
                    rectangle(context, v1.map(|v| v as f32), v2.map(|v| v as f32))
                }
                (None, _) | (_, None) => {
                    invalid_operation("GL 2.1, section 2.10", "v1 and v2 must have two numbers")
                }
            }
        }
    )* };
}

rectangles! {
    rects rectsv GLshort;
    recti rectiv GLint;
    rectf rectfv GLfloat;
    rectd rectdv GLdouble;
}
