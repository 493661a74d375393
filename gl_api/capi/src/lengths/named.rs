//! The rows of `ARB_direct_state_access`, of whose pointers the registry says little.

use super::{Rule, buffer};
use gl_api::host::limits::{MAX_DRAW_BUFFERS, MAX_VERTEX_BUFFERS};

/// An element for each vertex buffer, of which there are no more than the limit; none behind NULL.
const PER_VERTEX_BUFFER: Rule =
    Rule::TimesWithin { argument: 2, factor: 1, limit: MAX_VERTEX_BUFFERS };

/// The values of a colour, a depth or a stencil: as of the calls on the bound framebuffer, whose arguments begin one later
/// here.
fn cleared(arguments: &[isize]) -> usize {
    buffer(&arguments[1..])
}

pub(super) const OVERRIDES: &[(&str, usize, Rule)] = &[
    ("glGetTextureLevelParameterfv", 3, Rule::Named(2)),
    ("glGetTextureLevelParameteriv", 3, Rule::Named(2)),
    ("glTextureParameterfv", 2, Rule::Named(1)),
    ("glTextureParameterIiv", 2, Rule::Named(1)),
    ("glTextureParameterIuiv", 2, Rule::Named(1)),
    ("glTextureParameteriv", 2, Rule::Named(1)),
    ("glGetTextureParameterfv", 2, Rule::Named(1)),
    ("glGetTextureParameterIiv", 2, Rule::Named(1)),
    ("glGetTextureParameterIuiv", 2, Rule::Named(1)),
    ("glGetTextureParameteriv", 2, Rule::Named(1)),
    ("glGetTransformFeedbackiv", 2, Rule::Fixed(1)),
    ("glGetTransformFeedbacki_v", 3, Rule::Fixed(1)),
    ("glGetTransformFeedbacki64_v", 3, Rule::Fixed(1)),
    ("glGetNamedBufferParameteriv", 2, Rule::Named(1)),
    ("glGetNamedBufferParameteri64v", 2, Rule::Named(1)),
    ("glGetNamedBufferPointerv", 2, Rule::Fixed(1)),
    (
        "glNamedFramebufferDrawBuffers",
        2,
        Rule::TimesWithin { argument: 1, factor: 1, limit: MAX_DRAW_BUFFERS },
    ),
    ("glInvalidateNamedFramebufferData", 2, Rule::Times(1, 1)),
    ("glInvalidateNamedFramebufferSubData", 2, Rule::Times(1, 1)),
    ("glClearNamedFramebufferiv", 3, Rule::Computed(cleared)),
    ("glClearNamedFramebufferuiv", 3, Rule::Computed(cleared)),
    ("glClearNamedFramebufferfv", 3, Rule::Computed(cleared)),
    ("glGetNamedFramebufferParameteriv", 2, Rule::Fixed(1)),
    ("glGetNamedFramebufferAttachmentParameteriv", 3, Rule::Named(2)),
    ("glGetNamedRenderbufferParameteriv", 2, Rule::Named(1)),
    ("glVertexArrayVertexBuffers", 3, PER_VERTEX_BUFFER),
    ("glVertexArrayVertexBuffers", 4, PER_VERTEX_BUFFER),
    ("glVertexArrayVertexBuffers", 5, PER_VERTEX_BUFFER),
    ("glGetVertexArrayiv", 2, Rule::Fixed(1)),
    ("glGetVertexArrayIndexediv", 3, Rule::Fixed(1)),
    ("glGetVertexArrayIndexed64iv", 3, Rule::Fixed(1)),
];
