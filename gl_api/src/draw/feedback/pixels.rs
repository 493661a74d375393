//! What feedback writes: GL 2.1, section 5.3 and figure 5.1.

use crate::context::Context;
use crate::context::feedback::record::Kind;
use crate::context::feedback::{Corner, Mode};

/// Takes a bitmap or a rectangle of pixels at the raster position, unless fragments are made.
pub(crate) fn pixels(context: &mut Context, kind: Kind) -> Mode {
    let mode = context.feedback.mode;
    let position = &context.state.raster_position;
    if mode == Mode::Feedback && position.valid {
        let [x, y, z, clip_w] = position.window;
        let corner = Corner {
            window: [x, y, z],
            clip_w,
            color: position.color.map(f64::from),
            tex_coords: position.tex_coords[0].map(f64::from),
        };
        context.feedback.record.primitive(kind, &[corner]);
    }
    mode
}
