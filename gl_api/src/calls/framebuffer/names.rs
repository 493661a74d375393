//! The names and bindings of framebuffer objects: `ARB_framebuffer_object`, section 4.4.1.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::objects::framebuffers::{Binding, FRAMEBUFFER_TARGET, Framebuffer};
use crate::objects::name_table::listed;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.1";

/// The name that is bound to a target; `GL_FRAMEBUFFER` is the one that is drawn to.
pub(crate) fn bound(context: &Context, binding: Binding) -> GLuint {
    match binding {
        Binding::Draw | Binding::Both => context.state.bindings.draw_framebuffer,
        Binding::Read => context.state.bindings.read_framebuffer,
    }
}

/// Refuses names other than those of framebuffer objects (`ARB_direct_state_access`, section 9.2).
pub(crate) fn check_object(context: &Context, argument: &str, name: GLuint) -> Result<()> {
    if context.objects.framebuffers.get(name).is_some() {
        return Ok(());
    }
    invalid_operation(
        "ARB_direct_state_access, section 9.2",
        format!(
            "{argument} = {name} is no framebuffer object: glCreateFramebuffers makes some, and so does binding a \
             name once"
        ),
    )
}

/// The same where 0 is the default framebuffer.
pub(crate) fn check_framebuffer(context: &Context, argument: &str, name: GLuint) -> Result<()> {
    if name == 0 { Ok(()) } else { check_object(context, argument, name) }
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
    if context.profile.is_core() {
        context.objects.framebuffers.check_given(
            "framebuffer",
            framebuffer,
            "glGenFramebuffers",
        )?;
    }
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
