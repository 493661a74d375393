//! Framebuffer objects: names and bindings (`ARB_framebuffer_object`, section 4.4.1).

use super::listed;
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, Table};
use crate::framebuffer::buffers::Selection;
use crate::texture::FaceTarget;
use crate::types::*;
use rasterizer::driver::Image;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.1";

/// What is attached to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// A slice of a level of a texture.
    Texture {
        name: GLuint,
        target: FaceTarget,
        level: usize,
        slice: u16,
    },
    Renderbuffer(GLuint),
}

/// An attached image. It outlives the name that it had when it was attached
/// (`ARB_framebuffer_object`, section 4.4.2.2).
#[derive(Clone, Debug)]
pub(crate) struct Attached {
    pub source: Source,
    pub image: Image,
    /// Which planes of it can be drawn to.
    pub planes: Planes,
}

impl Attached {
    /// Whether both are the same slice of the same image.
    pub fn same(&self, other: &Self) -> bool {
        self.source == other.source && self.image.same(&other.image)
    }
}

/// What of depth and stencil there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Planes {
    pub depth: bool,
    pub stencil: bool,
}

/// A framebuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Framebuffer {
    pub colors: [Option<Attached>; limits::MAX_COLOR_ATTACHMENTS],
    pub depth: Option<Attached>,
    pub stencil: Option<Attached>,
    pub selection: Selection,
}

impl Framebuffer {
    fn new() -> Self {
        Self {
            colors: [const { None }; limits::MAX_COLOR_ATTACHMENTS],
            depth: None,
            stencil: None,
            selection: Selection::object(),
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

/// Which binding a call works on.
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

/// The name that is bound to a target; `GL_FRAMEBUFFER` is the one that is drawn to.
pub(crate) fn bound(context: &Context, binding: Binding) -> GLuint {
    match binding {
        Binding::Draw | Binding::Both => context.state.bindings.draw_framebuffer,
        Binding::Read => context.state.bindings.read_framebuffer,
    }
}

pub(crate) fn gen_framebuffers(
    context: &mut Context,
    n: GLsizei,
    framebuffers: &mut [GLuint],
) -> Result<()> {
    context.objects.framebuffers.reserve(SECTION, n, framebuffers)
}

pub(crate) fn delete_framebuffers(
    context: &mut Context,
    n: GLsizei,
    framebuffers: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, framebuffers)?.iter().filter(|&&name| name != 0) {
        let bindings = &mut context.state.bindings;
        for bound in [&mut bindings.draw_framebuffer, &mut bindings.read_framebuffer] {
            if *bound == name {
                *bound = 0;
            }
        }
        context.objects.framebuffers.remove(name);
    }
    Ok(())
}

pub(crate) fn bind_framebuffer(
    context: &mut Context,
    target: GLenum,
    framebuffer: GLuint,
) -> Result<()> {
    let binding = FRAMEBUFFER_TARGET.decode("target", target)?;
    context.objects.framebuffers.create(framebuffer, Framebuffer::new);
    let bindings = &mut context.state.bindings;
    if binding != Binding::Read {
        bindings.draw_framebuffer = framebuffer;
    }
    if binding != Binding::Draw {
        bindings.read_framebuffer = framebuffer;
    }
    Ok(())
}

pub(crate) fn is_framebuffer(context: &mut Context, framebuffer: GLuint) -> Result<bool> {
    Ok(context.objects.framebuffers.get(framebuffer).is_some())
}
