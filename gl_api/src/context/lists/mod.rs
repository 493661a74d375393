//! Display lists: GL 2.1, section 5.4.
//!
//! While a list is compiled, an entry point records its call with copies of its arguments instead
//! of carrying it out; which calls are never compiled is in the table of entry points, and in `record/proxy.rs`.
//! The vertices between `glBegin` and `glEnd` become one buffer, and a draw of vertex arrays keeps the
//! buffers it would have read, so that calling a list costs what drawing from buffers costs.

pub(crate) mod primitives;

use crate::base::begin_end::BeginEnd;
use crate::base::error::Result;
use crate::base::types::*;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::context::lists::primitives::{ListPrimitives, OpenPrimitives};
use crate::context::recorder::elements::Elements;
use crate::pixel::store::PixelStore;
use rasterizer::driver::{Topology, VertexBinding};
use std::fmt;

/// A recorded call with its arguments.
pub(crate) type RecordedCall = Box<dyn Fn(&mut Context) -> Result<()> + Send + Sync>;

/// A draw of vertex arrays, with what it would have read. Constants are the current values of
/// when the list is called.
#[derive(Debug)]
pub(crate) struct ArrayDraw {
    pub topology: Topology,
    pub vertices: Vec<VertexBinding>,
    pub elements: Elements,
}

/// A step of a list.
pub(crate) enum Step {
    /// Any call. Pixels were taken when the list was compiled, and are unpacked as they lay then.
    Call {
        name: &'static str,
        begin_end: BeginEnd,
        unpack: Option<Box<PixelStore>>,
        run: RecordedCall,
    },
    /// An attribute on its own.
    Attribute(Slot, [f32; 4]),
    /// Everything from `glBegin` to `glEnd`.
    Primitives(ListPrimitives),
    /// A draw of vertex arrays.
    Arrays(ArrayDraw),
}

impl Step {
    /// The call that it is of, or one of several.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Call { name, .. } => name,
            Self::Attribute(..) => "glVertex",
            Self::Primitives(_) => "glEnd",
            Self::Arrays(_) => "glDrawArrays",
        }
    }
}

impl fmt::Debug for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Call { name, .. } => f.write_str(name),
            Self::Attribute(slot, value) => write!(f, "{slot:?} {value:?}"),
            Self::Primitives(shapes) => write!(f, "{shapes:?}"),
            Self::Arrays(draw) => write!(f, "{draw:?}"),
        }
    }
}

/// A compiled list.
#[derive(Debug, Default)]
pub(crate) struct List {
    pub steps: Vec<Step>,
    /// What a call of it costs, without the lists that it calls: its commands, and more for those that take longer.
    pub cost: u64,
}

impl List {
    /// A list of these steps.
    pub fn new(steps: Vec<Step>) -> Self {
        let cost = 1 + steps.iter().map(Step::cost).sum::<u64>();
        Self { steps, cost }
    }
}

impl Step {
    /// How many shapes it may draw, more or less.
    pub fn shapes(&self) -> u64 {
        match self {
            Self::Attribute(..) => 0,
            Self::Call { .. } => 1,
            Self::Primitives(primitives) => primitives.count as u64,
            Self::Arrays(draw) => {
                let (count, instances) = draw.elements.counts();
                u64::from(count) * instances.len() as u64
            }
        }
    }

    /// What it costs beside a command that sets state.
    fn cost(&self) -> u64 {
        const DRAW: u64 = 8;
        const VERTICES: u64 = 8;
        const PIXELS: u64 = 32;
        match self {
            Self::Attribute(..) | Self::Call { unpack: None, .. } => 1,
            Self::Call { unpack: Some(_), .. } => PIXELS,
            Self::Primitives(primitives) => DRAW + primitives.count as u64 / VERTICES,
            Self::Arrays(draw) => {
                let (count, instances) = draw.elements.counts();
                DRAW + u64::from(count) * instances.len() as u64 / VERTICES
            }
        }
    }
}

/// `GL_LIST_BASE`, and the nesting of the calls of lists that run.
#[derive(Debug, Default)]
pub(crate) struct Lists {
    pub base: GLuint,
    /// How deep calls of lists are nested now.
    pub depth: usize,
    /// What the lists that the outermost call calls may still cost ([`List::cost`]); `None` once one has cost more.
    pub budget: Option<u64>,
    /// How deep the calls are that are free: that of the list that `glCallList` names, none of `glCallLists`.
    pub free_depth: usize,
    /// Shapes of these lists that are drawn and may not be submitted yet.
    pub waiting_shapes: u64,
}

impl Lists {
    /// Whether a list runs that is charged to the budget of the outermost call.
    pub fn is_charged(&self) -> bool {
        self.depth > self.free_depth
    }

    /// Charges commands to the budget of the outermost call, where a list runs that is charged.
    pub fn charge(&mut self, commands: u64) {
        if self.is_charged() {
            self.budget = self.budget.and_then(|left| left.checked_sub(commands));
        }
    }

    /// Charges work on so many pixels or texels.
    pub fn charge_pixels(&mut self, pixels: u64) {
        const PIXELS_OF_A_COMMAND: u64 = 256;
        self.charge(pixels / PIXELS_OF_A_COMMAND);
    }

    /// Charges work on an image of this size, as it is asked for.
    pub fn charge_image(&mut self, size: [GLsizei; 3]) {
        let sides = size.map(|side| u64::try_from(side).unwrap_or(0));
        self.charge_pixels(sides.into_iter().fold(1, u64::saturating_mul));
    }

    /// Charges draws that so many batches of fragments may have been shaded for.
    pub fn charge_batches(&mut self, batches: u64) {
        const BATCHES_OF_A_COMMAND: u64 = 64;
        self.charge(batches / BATCHES_OF_A_COMMAND);
    }

    /// `GL_LIST_BASE`.
    pub fn base(&self) -> GLuint {
        self.base
    }

    /// Sets `GL_LIST_BASE`.
    pub fn set_base(&mut self, base: GLuint) {
        self.base = base;
    }
}

/// Whether a list is also carried out while it is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ListMode {
    Compile,
    CompileAndExecute,
}

/// The list between `glNewList` and `glEndList`.
#[derive(Debug)]
pub(crate) struct Compiling {
    pub name: GLuint,
    pub mode: ListMode,
    pub steps: Vec<Step>,
    /// The attributes since `glBegin`, as long as nothing else followed.
    pub open: Option<OpenPrimitives>,
    /// Whether a `glBegin` is recorded by itself: vertices after another, which is refused when the
    /// list is called, are the first one's (GL 2.1, section 2.5).
    pub begun: bool,
}
