//! Selection and feedback: GL 2.1, sections 5.2 and 5.3.
//!
//! In these modes a draw makes no fragments. `draw/feedback` runs its vertices through the same vertex stage, clips and
//! culls the primitives, and gives them to [`Feedback`]: they are hits of the names on the stack ([`select`]) or numbers
//! in the client's buffer ([`record`]).

use crate::base::client_memory::ClientPointer;
use crate::context::Context;
use crate::context::feedback::record::Record;
use crate::context::feedback::select::Select;
use crate::context::recorder::vertex_stage::RasterPositionStage;
use rasterizer::shader::Machine;

pub(crate) mod record;
pub(crate) mod select;

/// `GL_RENDER_MODE`: what becomes of primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum RenderMode {
    /// They make fragments.
    #[default]
    Render,
    /// They are hits of the names on the stack.
    Select,
    /// Their corners are written to the feedback buffer.
    Feedback,
}

/// The selection or feedback buffer.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target {
    /// The context keeps them for [`crate::Context::selection`] or [`crate::Context::feedback`].
    Own,
    /// The memory of a C program, too.
    Client(ClientPointer<'static>),
}

/// The render mode, and the results of selection and feedback.
#[derive(Debug, Default)]
pub(crate) struct Feedback {
    pub mode: RenderMode,
    pub select: Select,
    pub record: Record,
    /// The registers that the vertex stage runs in.
    pub machine: Machine,
    /// The vertex stage of the raster position before.
    pub raster_position_stage: Option<RasterPositionStage>,
}

/// A vertex of a primitive in window coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    /// x, y, z.
    pub window: [f64; 3],
    /// w of the clip coordinates.
    pub clip_w: f64,
    pub color: [f64; 4],
    pub tex_coords: [f64; 4],
}

impl Feedback {
    /// Adds a primitive.
    pub fn primitive(&mut self, kind: record::PrimitiveToken, corners: &[Corner]) {
        match self.mode {
            RenderMode::Render => {}
            RenderMode::Select => {
                corners.iter().for_each(|corner| self.select.hit(corner.window[2]))
            }
            RenderMode::Feedback => self.record.primitive(kind, corners),
        }
    }
}

/// Adds a bitmap or a rectangle of pixels at the raster position, in feedback mode; gives the mode.
pub(crate) fn pixels(context: &mut Context, kind: record::PrimitiveToken) -> RenderMode {
    let mode = context.feedback.mode;
    let position = &context.state.raster_position;
    if mode == RenderMode::Feedback && position.valid {
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
