//! Selection and feedback: GL 2.1, sections 5.2 and 5.3.
//!
//! In these modes a draw makes no fragments. Its vertices run through the same vertex stage, here,
//! one batch after the other ([`shade`]); the primitives are clipped ([`clip`]), culled and turned
//! into what the polygon mode says ([`primitives`]), and then are hits of the names on the stack
//! ([`select`]) or numbers in the client's buffer ([`record`]).

pub(crate) mod record;
pub(crate) mod select;

use crate::base::client_memory::ClientPointer;
use crate::context::feedback::record::Record;
use crate::context::feedback::select::Select;
use crate::context::raster_passed::Passed;
use rasterizer::shader::Machine;

/// What becomes of primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Fragments.
    #[default]
    Render,
    /// Hits of names.
    Select,
    /// Numbers.
    Feedback,
}

/// Where the numbers of a mode go when it ends.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target {
    /// The context keeps them for [`crate::Context::selection`] or [`crate::Context::feedback`].
    Own,
    /// The memory of a C program, too.
    Client(ClientPointer<'static>),
}

/// The mode, and what selection and feedback have gathered.
#[derive(Debug, Default)]
pub(crate) struct Feedback {
    pub mode: Mode,
    pub select: Select,
    pub record: Record,
    /// What the vertex stage runs in.
    pub machine: Machine,
    /// What the raster position before went through.
    pub passed: Option<Passed>,
}

/// A corner of a primitive in window coordinates.
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
    /// Takes a primitive.
    pub fn primitive(&mut self, kind: record::Kind, corners: &[Corner]) {
        match self.mode {
            Mode::Render => {}
            Mode::Select => corners.iter().for_each(|corner| self.select.hit(corner.window[2])),
            Mode::Feedback => self.record.primitive(kind, corners),
        }
    }
}
