//! Framebuffer objects and their attachments (`ARB_framebuffer_object`, sections 4.4.1 and 4.4.2), and the accumulation
//! buffer of the default framebuffer (GL 2.1, section 4.2.4).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum};
use crate::base::limits;
use crate::base::types::*;
use crate::objects::color_buffers::{Selection, attachment_index};
use crate::objects::target::FaceTarget;
use rasterizer::driver::{AttachmentSamples, Image};

const SECTION: &str = "ARB_framebuffer_object, section 4.4.1";

/// The texture level or renderbuffer that is attached to an attachment point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// A slice of a level of a texture.
    Texture {
        name: GLuint,
        target: FaceTarget,
        level: usize,
        slice: u16,
        layers: AttachedLayers,
    },
    Renderbuffer(GLuint),
}

/// Which layers of a level are attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AttachedLayers {
    /// The one that its slice or face says.
    One,
    /// All: the attachment is layered (GL 3.2, section 4.4.7).
    All,
}

/// An attached image. It outlives the name that it had when it was attached
/// (`ARB_framebuffer_object`, section 4.4.2.2).
#[derive(Clone, Debug)]
pub(crate) struct Attached {
    pub source: Source,
    pub image: Image,
    /// Which of its planes can be drawn to.
    pub planes: Planes,
    /// Those that a pixel has while it is drawn to.
    pub samples: AttachmentSamples,
}

impl Attached {
    /// Whether both are the same slice of the same image.
    pub fn same(&self, other: &Self) -> bool {
        self.source == other.source && self.image.is_same_image(&other.image)
    }
}

/// Which of depth and stencil an image has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Planes {
    pub depth: bool,
    pub stencil: bool,
}

impl Planes {
    /// Of most textures, whose stored formats say what there is.
    pub const BOTH: Self = Self { depth: true, stencil: true };
    /// Of textures of stencils alone, which are stored beside depths.
    pub const STENCIL: Self = Self { depth: false, stencil: true };
}

/// A framebuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Framebuffer {
    pub colors: [Option<Attached>; limits::MAX_COLOR_ATTACHMENTS],
    pub depth: Option<Attached>,
    pub stencil: Option<Attached>,
    pub selection: Selection,
    pub without_attachments: WithoutAttachments,
}

/// What a framebuffer object draws to where nothing is attached (`ARB_framebuffer_no_attachments`); the sizes are 0 at
/// first, with which it is incomplete.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WithoutAttachments {
    pub width: u32,
    pub height: u32,
    pub layers: u16,
    pub samples: u8,
    pub fixed_locations: bool,
}

impl Framebuffer {
    pub(crate) fn new() -> Self {
        Self {
            colors: [const { None }; limits::MAX_COLOR_ATTACHMENTS],
            depth: None,
            stencil: None,
            selection: Selection::object(),
            without_attachments: WithoutAttachments::default(),
        }
    }

    /// Every attachment point.
    pub fn points_mut(&mut self) -> impl Iterator<Item = &mut Option<Attached>> {
        self.colors.iter_mut().chain([&mut self.depth, &mut self.stencil])
    }

    /// Everything that is attached.
    pub fn attached(&self) -> impl Iterator<Item = &Attached> {
        self.colors.iter().chain([&self.depth, &self.stencil]).flatten()
    }
}

/// The framebuffer bindings that a target names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binding {
    Draw,
    Read,
    Both,
}

pub(crate) const FRAMEBUFFER_TARGET: Table<Binding> = Table {
    section: SECTION,
    rows: &[
        (GL_FRAMEBUFFER, Binding::Both),
        (GL_DRAW_FRAMEBUFFER, Binding::Draw),
        (GL_READ_FRAMEBUFFER, Binding::Read),
    ],
};

/// The accumulation buffer: red, green, blue and alpha of each pixel, row by row; empty before its first use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Accumulation(pub(crate) Vec<[f32; 4]>);

const ATTACHMENT_SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

/// An attachment point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AttachmentPoint {
    Color(usize),
    Depth,
    Stencil,
    /// Both at once.
    DepthStencil,
}

pub(crate) fn attachment_point(attachment: GLenum) -> Result<AttachmentPoint> {
    match attachment {
        GL_DEPTH_ATTACHMENT => Ok(AttachmentPoint::Depth),
        GL_STENCIL_ATTACHMENT => Ok(AttachmentPoint::Stencil),
        GL_DEPTH_STENCIL_ATTACHMENT => Ok(AttachmentPoint::DepthStencil),
        _ => match attachment_index(attachment) {
            Some(index) => Ok(AttachmentPoint::Color(index)),
            None => invalid_enum(
                ATTACHMENT_SECTION,
                format!(
                    "attachment = {} must be GL_COLOR_ATTACHMENT0 to {}, GL_DEPTH_ATTACHMENT, \
                     GL_STENCIL_ATTACHMENT or GL_DEPTH_STENCIL_ATTACHMENT",
                    enum_name(attachment),
                    limits::MAX_COLOR_ATTACHMENTS - 1
                ),
            ),
        },
    }
}
