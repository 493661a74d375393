//! Per-fragment operations: GL 2.1, chapter 4.

use crate::framebuffer::clear;
use crate::state::fragment;
use crate::types::*;

entry_points! {
    FRAGMENTS;
    Outside in fragment {
        /// Sets the alpha test.
        alpha_func: glAlphaFunc (func: GLenum, reference: GLclampf);
        /// Sets the factors of both blend equations.
        blend_func: glBlendFunc (sfactor: GLenum, dfactor: GLenum);
        /// Sets the factors of the blend equations of colour and alpha.
        blend_func_separate: glBlendFuncSeparate | glBlendFuncSeparateEXT
            (src_rgb: GLenum, dst_rgb: GLenum, src_alpha: GLenum, dst_alpha: GLenum);
        /// Sets both blend equations.
        blend_equation: glBlendEquation | glBlendEquationEXT (mode: GLenum);
        /// Sets the blend equations of colour and alpha.
        blend_equation_separate: glBlendEquationSeparate | glBlendEquationSeparateEXT
            (mode_rgb: GLenum, mode_alpha: GLenum);
        /// Sets the constant colour of blending.
        blend_color: glBlendColor | glBlendColorEXT
            (red: GLclampf, green: GLclampf, blue: GLclampf, alpha: GLclampf);
        /// Sets the depth test.
        depth_func: glDepthFunc (func: GLenum);
        /// Sets whether depth is written.
        depth_mask: glDepthMask (flag: bool);
        /// Sets which colour components are written.
        color_mask: glColorMask (red: bool, green: bool, blue: bool, alpha: bool);
        /// Sets the scissor rectangle.
        scissor: glScissor (x: GLint, y: GLint, width: GLsizei, height: GLsizei);
        /// Sets the colour that `glClear` writes.
        clear_color: glClearColor
            (red: GLclampf, green: GLclampf, blue: GLclampf, alpha: GLclampf);
        /// Sets the depth that `glClear` writes.
        clear_depth: glClearDepth (depth: GLclampd);
        /// Sets the depth that `glClear` writes.
        clear_depthf: glClearDepthf (depth: GLclampf);
        /// Sets the stencil value that `glClear` writes, once there are stencil buffers.
        clear_stencil: glClearStencil (s: GLint);
    }
    Outside in clear {
        /// Fills buffers of the draw framebuffer, through scissor and masks.
        clear: glClear (mask: GLbitfield);
    }
}
