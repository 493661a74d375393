//! Framebuffer objects: `ARB_framebuffer_object` and `EXT_framebuffer_object`; draw and read
//! buffers: GL 2.1, sections 4.2.1 and 4.3.2.

use crate::base::types::*;
use crate::calls::framebuffer::{
    attach, blit, buffers, inspect, invalidate, names as framebuffers, parameters, renderbuffers,
};
use crate::calls::texture::internal_format;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_framebuffers {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in framebuffers {
        /// Makes `n` unused framebuffer names.
        gen_framebuffers: glGenFramebuffers | glGenFramebuffersEXT
            (n: GLsizei, framebuffers: &'a mut [GLuint]);
        /// Deletes framebuffers; a bound one is replaced by the default one.
        delete_framebuffers: glDeleteFramebuffers | glDeleteFramebuffersEXT
            (n: GLsizei, framebuffers: &'a [GLuint]), not_compiled;
        /// Makes a framebuffer the one that is drawn to, read from, or both.
        bind_framebuffer: glBindFramebuffer | glBindFramebufferEXT
            (target: GLenum, framebuffer: GLuint), not_compiled;
        /// Whether a name is a framebuffer that has been bound.
        is_framebuffer: glIsFramebuffer | glIsFramebufferEXT (framebuffer: GLuint) -> bool;
    }
    Refused in renderbuffers {
        /// Makes `n` unused renderbuffer names.
        gen_renderbuffers: glGenRenderbuffers | glGenRenderbuffersEXT
            (n: GLsizei, renderbuffers: &'a mut [GLuint]);
        /// Deletes renderbuffers, and detaches them from the bound framebuffer.
        delete_renderbuffers: glDeleteRenderbuffers | glDeleteRenderbuffersEXT
            (n: GLsizei, renderbuffers: &'a [GLuint]), not_compiled;
        /// Makes a renderbuffer the current one.
        bind_renderbuffer: glBindRenderbuffer | glBindRenderbufferEXT
            (target: GLenum, renderbuffer: GLuint), not_compiled;
        /// Whether a name is a renderbuffer that has been bound.
        is_renderbuffer: glIsRenderbuffer | glIsRenderbufferEXT (renderbuffer: GLuint) -> bool;
        /// Gives the current renderbuffer a format and a size.
        renderbuffer_storage: glRenderbufferStorage | glRenderbufferStorageEXT
            (target: GLenum, internalformat: GLenum, width: GLsizei, height: GLsizei), not_compiled;
        /// Gives the current renderbuffer a format, a size and a number of samples.
        renderbuffer_storage_multisample: glRenderbufferStorageMultisample (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei
        ), not_compiled;
        /// Gives the current renderbuffer a format, a size and samples that OpenGL ES resolves where they are read.
        renderbuffer_storage_multisample_ext: glRenderbufferStorageMultisampleEXT (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei
        ), not_compiled;
        /// Reads what is known of the current renderbuffer.
        get_renderbuffer_parameteriv:
            glGetRenderbufferParameteriv | glGetRenderbufferParameterivEXT
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in invalidate {
        /// Says that the contents of attachments will not be used.
        invalidate_framebuffer: glInvalidateFramebuffer | glDiscardFramebufferEXT
            (target: GLenum, numattachments: GLsizei, attachments: &'a [GLenum]), not_compiled;
        /// Says that a part of the contents of attachments will not be used.
        invalidate_sub_framebuffer: glInvalidateSubFramebuffer (
            target: GLenum, numattachments: GLsizei, attachments: &'a [GLenum], x: GLint, y: GLint,
            width: GLsizei, height: GLsizei
        ), not_compiled;
    }
    Refused in internal_format {
        /// Reads what a format can be used for with a target.
        get_internalformativ: glGetInternalformativ (
            target: GLenum, internalformat: GLenum, pname: GLenum, bufsize: GLsizei, params: &'a mut [GLint]
        );
        /// Reads the same as integers of 64 bits.
        get_internalformati64v: glGetInternalformati64v (
            target: GLenum, internalformat: GLenum, pname: GLenum, bufsize: GLsizei, params: &'a mut [GLint64]
        );
    }
    Refused in attach {
        /// Attaches a level of a one-dimensional texture to the bound framebuffer.
        framebuffer_texture_1d: glFramebufferTexture1D | glFramebufferTexture1DEXT (
            target: GLenum, attachment: GLenum, textarget: GLenum, texture: GLuint, level: GLint
        ), not_compiled;
        /// Attaches a slice of a level of a volume to the bound framebuffer.
        framebuffer_texture_3d: glFramebufferTexture3D | glFramebufferTexture3DEXT (
            target: GLenum, attachment: GLenum, textarget: GLenum, texture: GLuint, level: GLint,
            zoffset: GLint
        ), not_compiled;
        /// Attaches a slice of a volume or a layer of an array to the bound framebuffer.
        framebuffer_texture_layer: glFramebufferTextureLayer | glFramebufferTextureLayerEXT (
            target: GLenum, attachment: GLenum, texture: GLuint, level: GLint, layer: GLint
        ), not_compiled;
        /// Attaches all layers of a level of a texture to the bound framebuffer.
        framebuffer_texture: glFramebufferTexture | glFramebufferTextureARB (
            target: GLenum, attachment: GLenum, texture: GLuint, level: GLint
        ), not_compiled;
        /// Attaches a level of a texture, or of a face of a cube map, to the bound framebuffer.
        framebuffer_texture_2d: glFramebufferTexture2D | glFramebufferTexture2DEXT (
            target: GLenum, attachment: GLenum, textarget: GLenum, texture: GLuint, level: GLint
        ), not_compiled;
        /// Attaches a level of a texture, which has several samples while it is drawn to: OpenGL ES resolves them where
        /// they are read.
        framebuffer_texture_2d_multisample: glFramebufferTexture2DMultisampleEXT (
            target: GLenum, attachment: GLenum, textarget: GLenum, texture: GLuint, level: GLint,
            samples: GLsizei
        ), not_compiled;
        /// Attaches a renderbuffer to the bound framebuffer.
        framebuffer_renderbuffer: glFramebufferRenderbuffer | glFramebufferRenderbufferEXT (
            target: GLenum, attachment: GLenum, renderbuffertarget: GLenum, renderbuffer: GLuint
        ), not_compiled;
        /// Whether the bound framebuffer can be drawn to: `GL_FRAMEBUFFER_COMPLETE`, or why not.
        check_framebuffer_status: glCheckFramebufferStatus | glCheckFramebufferStatusEXT
            (target: GLenum) -> GLenum;
    }
    Refused in blit {
        /// Copies a rectangle of the read framebuffer to the draw framebuffer, scaled or mirrored.
        blit_framebuffer: glBlitFramebuffer | glBlitFramebufferEXT (
            src_x0: GLint, src_y0: GLint, src_x1: GLint, src_y1: GLint, dst_x0: GLint,
            dst_y0: GLint, dst_x1: GLint, dst_y1: GLint, mask: GLbitfield, filter: GLenum
        );
    }
    Refused in inspect {
        /// Reads what is known of an attachment.
        get_framebuffer_attachment_parameteriv:
            glGetFramebufferAttachmentParameteriv | glGetFramebufferAttachmentParameterivEXT
            (target: GLenum, attachment: GLenum, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in parameters {
        /// Sets what a framebuffer object without attachments draws to.
        framebuffer_parameteri: glFramebufferParameteri
            (target: GLenum, pname: GLenum, param: GLint), not_compiled;
        /// Reads what is known of a framebuffer.
        get_framebuffer_parameteriv: glGetFramebufferParameteriv
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in buffers {
        /// Sets which colour buffer is drawn to.
        draw_buffer: glDrawBuffer (buf: GLenum);
        /// Sets which colour buffer each fragment colour is drawn to.
        draw_buffers: glDrawBuffers | glDrawBuffersARB | glDrawBuffersATI | glDrawBuffersEXT (n: GLsizei, bufs: &'a [GLenum]);
        /// Sets which colour buffer is read from.
        read_buffer: glReadBuffer (src: GLenum);
    }
    } };
}
entry_points_framebuffers!(implement);
