//! Per-fragment operations: GL 2.1, chapter 4.

use crate::base::types::*;
use crate::calls::color_index;
use crate::calls::fragment::{blend, clamp, masks, stencil, tests as fragment};
use crate::calls::framebuffer::{accumulate, clear};
use crate::query::indexed;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_fragments {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Setter in fragment {
        /// Sets the alpha test.
        alpha_func: glAlphaFunc (func: GLenum, reference: GLclampf);
        /// Sets the depth test.
        depth_func: glDepthFunc (func: GLenum);
        /// Sets whether depth is written.
        depth_mask: glDepthMask (flag: bool);
        /// Sets the scissor rectangle.
        scissor: glScissor (x: GLint, y: GLint, width: GLsizei, height: GLsizei);
        /// Sets the colour that `glClear` writes.
        clear_color: glClearColor
            (red: GLclampf, green: GLclampf, blue: GLclampf, alpha: GLclampf);
        /// Sets the colour that `glClear` writes to buffers of integers.
        clear_color_iui_ext: glClearColorIuiEXT
            (red: GLuint, green: GLuint, blue: GLuint, alpha: GLuint);
        /// Sets the colour that `glClear` writes to buffers of integers.
        clear_color_ii_ext: glClearColorIiEXT
            (red: GLint, green: GLint, blue: GLint, alpha: GLint);
        /// Sets the depth that `glClear` writes.
        clear_depth: glClearDepth (depth: GLclampd);
        /// Sets the depth that `glClear` writes.
        clear_depthf: glClearDepthf (depth: GLclampf);
        /// Sets the stencil value that `glClear` writes.
        clear_stencil: glClearStencil (s: GLint);
    }
    Setter in blend {
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
        /// Sets the factors of both blend equations of a draw buffer.
        blend_funci: glBlendFunci | glBlendFunciARB | glBlendFuncIndexedAMD
            (buf: GLuint, src: GLenum, dst: GLenum);
        /// Sets the factors of the blend equations of colour and alpha of a draw buffer.
        blend_func_separatei: glBlendFuncSeparatei | glBlendFuncSeparateiARB
            | glBlendFuncSeparateIndexedAMD
            (buf: GLuint, src_rgb: GLenum, dst_rgb: GLenum, src_alpha: GLenum, dst_alpha: GLenum);
        /// Sets both blend equations of a draw buffer.
        blend_equationi: glBlendEquationi | glBlendEquationiARB | glBlendEquationIndexedAMD
            (buf: GLuint, mode: GLenum);
        /// Sets the blend equations of colour and alpha of a draw buffer.
        blend_equation_separatei: glBlendEquationSeparatei | glBlendEquationSeparateiARB
            | glBlendEquationSeparateIndexedAMD
            (buf: GLuint, mode_rgb: GLenum, mode_alpha: GLenum);
    }
    Refused in clamp {
        /// Sets when colours are clamped to [0, 1].
        clamp_color: glClampColor | glClampColorARB (target: GLenum, clamp: GLenum);
    }
    Setter in masks {
        /// Sets which colour components are written.
        color_mask: glColorMask (red: bool, green: bool, blue: bool, alpha: bool);
        /// Sets which components of a draw buffer are written.
        color_maski: glColorMaski | glColorMaskIndexedEXT
            (buf: GLuint, red: bool, green: bool, blue: bool, alpha: bool);
        /// Sets the logical operation between fragments and what is stored.
        logic_op: glLogicOp (opcode: GLenum);
        /// Switches a capability of one draw buffer on.
        enablei: glEnablei | glEnableIndexedEXT (target: GLenum, index: GLuint);
        /// Switches a capability of one draw buffer off.
        disablei: glDisablei | glDisableIndexedEXT (target: GLenum, index: GLuint);
    }
    Refused in indexed {
        /// Whether a capability of one draw buffer is on.
        is_enabledi: glIsEnabledi | glIsEnabledIndexedEXT (target: GLenum, index: GLuint) -> bool;
        /// Reads state of one draw buffer as truth values.
        get_booleani_v: glGetBooleani_v | glGetBooleanIndexedvEXT
            (target: GLenum, index: GLuint, data: &'a mut [GLboolean]);
        /// Reads state of one draw buffer as integers.
        get_integeri_v: glGetIntegeri_v | glGetIntegerIndexedvEXT
            (target: GLenum, index: GLuint, data: &'a mut [GLint]);
        /// Reads state of one draw buffer or binding as integers of 64 bits.
        get_integer64i_v: glGetInteger64i_v
            (target: GLenum, index: GLuint, data: &'a mut [GLint64]);
    }
    Setter in stencil {
        /// Sets the stencil test of both faces.
        stencil_func: glStencilFunc (func: GLenum, reference: GLint, mask: GLuint);
        /// Sets the stencil test of one face, or of both.
        stencil_func_separate: glStencilFuncSeparate
            (face: GLenum, func: GLenum, reference: GLint, mask: GLuint);
        /// Sets the comparisons of the stencil tests of front and back faces.
        stencil_func_separate_ati: glStencilFuncSeparateATI
            (frontfunc: GLenum, backfunc: GLenum, reference: GLint, mask: GLuint);
        /// Sets what happens to stencils, for both faces.
        stencil_op: glStencilOp (fail: GLenum, zfail: GLenum, zpass: GLenum);
        /// Sets what happens to stencils, for one face or for both.
        stencil_op_separate: glStencilOpSeparate | glStencilOpSeparateATI
            (face: GLenum, sfail: GLenum, dpfail: GLenum, dppass: GLenum);
        /// Sets which bits of stencils are written, for both faces.
        stencil_mask: glStencilMask (mask: GLuint);
        /// Sets which bits of stencils are written, for one face or for both.
        stencil_mask_separate: glStencilMaskSeparate (face: GLenum, mask: GLuint);
        /// Sets the face that calls without a face are about.
        active_stencil_face_ext: glActiveStencilFaceEXT (face: GLenum);
    }
    Refused in color_index {
        /// Sets which bits of colour indices are written; kept, not used.
        index_mask: glIndexMask (mask: GLuint);
        /// Sets the colour index that `glClear` writes; kept, not used.
        clear_index: glClearIndex (c: GLfloat);
    }
    Refused in accumulate {
        /// Sets the colour that `glClear` writes to the accumulation buffer.
        clear_accum: glClearAccum
            (red: GLfloat, green: GLfloat, blue: GLfloat, alpha: GLfloat);
        /// Adds colours to the accumulation buffer, scales it, or writes it back.
        accum: glAccum (op: GLenum, value: GLfloat);
    }
    Refused in clear {
        /// Fills one buffer with integers, through scissor and masks.
        clear_bufferiv: glClearBufferiv
            (buffer: GLenum, drawbuffer: GLint, value: &'a [GLint]);
        /// Fills one buffer with unsigned integers, through scissor and masks.
        clear_bufferuiv: glClearBufferuiv
            (buffer: GLenum, drawbuffer: GLint, value: &'a [GLuint]);
        /// Fills one buffer with floats, through scissor and masks.
        clear_bufferfv: glClearBufferfv
            (buffer: GLenum, drawbuffer: GLint, value: &'a [GLfloat]);
        /// Fills depth and stencil, through scissor and masks.
        clear_bufferfi: glClearBufferfi
            (buffer: GLenum, drawbuffer: GLint, depth: GLfloat, stencil: GLint);
        /// Fills buffers of the draw framebuffer, through scissor and masks.
        clear: glClear (mask: GLbitfield);
    }
    } };
}
entry_points_fragments!(implement);
