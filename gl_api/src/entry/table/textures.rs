//! Textures: GL 2.1, section 3.8 (and 6.1.3, 6.1.4 for queries).

use crate::base::args::{Data, DataOut};
use crate::base::types::*;
use crate::calls::texture::{
    buffer, clear_image, compressed, copy, copy_image, egl_image, environment as env, get, get_sub,
    invalidate, mipmap, multisample, names as textures, parameter, query, samplers, specify,
    storage, sub, view,
};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_textures {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in textures {
        /// Makes `n` unused texture names.
        gen_textures: glGenTextures | glGenTexturesEXT (n: GLsizei, textures: &'a mut [GLuint]);
        /// Deletes textures; bound ones are unbound, unknown names ignored.
        delete_textures: glDeleteTextures | glDeleteTexturesEXT (n: GLsizei, textures: &'a [GLuint]), not_compiled;
    }
    Setter in textures {
        /// Makes a texture the current one of a target of the active unit. Any name will do: an
        /// unknown one is created.
        bind_texture: glBindTexture | glBindTextureEXT (target: GLenum, texture: GLuint);
        /// Selects the texture unit that texture calls and matrices work on.
        active_texture: glActiveTexture | glActiveTextureARB (texture: GLenum);
    }
    Refused in textures {
        /// Whether a name is a texture that has been bound.
        is_texture: glIsTexture | glIsTextureEXT (texture: GLuint) -> bool;
        /// Sets what `GL_TEXTURE_PRIORITY` answers; every texture is resident.
        prioritize_textures: glPrioritizeTextures | glPrioritizeTexturesEXT
            (n: GLsizei, textures: &'a [GLuint], priorities: &'a [GLfloat]);
        /// Whether all are resident: they are.
        are_textures_resident: glAreTexturesResident | glAreTexturesResidentEXT
            (n: GLsizei, textures: &'a [GLuint], residences: &'a mut [GLboolean]) -> bool;
        /// Selects the texture unit that `glTexCoordPointer` works on.
        client_active_texture: glClientActiveTexture | glClientActiveTextureARB (texture: GLenum), not_compiled;
    }
    Refused in specify {
        /// Specifies a level of a 1D texture, in the client's format. The slice must be long enough
        /// for the unpack state; so for all calls that take pixels.
        tex_image_1d: glTexImage1D (
            target: GLenum, level: GLint, internalformat: GLint, width: GLsizei, border: GLint,
            format: GLenum, ty: GLenum, pixels: Data<'a>
        );
        /// Specifies a level of a 2D, rectangle or 1D array texture or of a face of a cube map.
        tex_image_2d: glTexImage2D (
            target: GLenum, level: GLint, internalformat: GLint, width: GLsizei, height: GLsizei,
            border: GLint, format: GLenum, ty: GLenum, pixels: Data<'a>
        );
        /// Specifies a level of a 3D or 2D array texture.
        tex_image_3d: glTexImage3D | glTexImage3DEXT (
            target: GLenum, level: GLint, internalformat: GLint, width: GLsizei, height: GLsizei,
            depth: GLsizei, border: GLint, format: GLenum, ty: GLenum, pixels: Data<'a>
        );
    }
    Refused in storage {
        /// Gives a 1D texture all its levels for good.
        tex_storage_1d: glTexStorage1D
            (target: GLenum, levels: GLsizei, internalformat: GLenum, width: GLsizei), not_compiled;
        /// Gives a 2D, rectangle, cube map or 1D array texture all its levels for good.
        tex_storage_2d: glTexStorage2D (
            target: GLenum, levels: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei
        ), not_compiled;
        /// Gives a 3D or 2D array texture all its levels for good.
        tex_storage_3d: glTexStorage3D (
            target: GLenum, levels: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, depth: GLsizei
        ), not_compiled;
    }
    Refused in multisample {
        /// Gives a texture an image with several samples a texel.
        tex_image_2d_multisample: glTexImage2DMultisample (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, fixedsamplelocations: bool
        );
        /// Gives a texture layers with several samples a texel.
        tex_image_3d_multisample: glTexImage3DMultisample (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, depth: GLsizei, fixedsamplelocations: bool
        );
        /// Gives a texture an image with several samples a texel for good.
        tex_storage_2d_multisample: glTexStorage2DMultisample (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, fixedsamplelocations: bool
        ), not_compiled;
        /// Gives a texture layers with several samples a texel for good.
        tex_storage_3d_multisample: glTexStorage3DMultisample (
            target: GLenum, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, depth: GLsizei, fixedsamplelocations: bool
        ), not_compiled;
    }
    Refused in view {
        /// Makes a name a texture that shows levels and layers of another one's immutable storage.
        texture_view: glTextureView (
            texture: GLuint, target: GLenum, origtexture: GLuint, internalformat: GLenum,
            minlevel: GLuint, numlevels: GLuint, minlayer: GLuint, numlayers: GLuint
        ), not_compiled;
    }
    Refused in egl_image {
        /// Makes an EGL image the only level of a 2D texture: both have the same texels, in all contexts.
        egl_image_target_texture_2d: glEGLImageTargetTexture2DOES
            (target: GLenum, image: GLeglImageOES), not_compiled;
        /// Makes an EGL image the storage of a renderbuffer.
        egl_image_target_renderbuffer_storage: glEGLImageTargetRenderbufferStorageOES
            (target: GLenum, image: GLeglImageOES), not_compiled;
    }
    Refused in sub {
        /// Replaces a run of a level.
        tex_sub_image_1d: glTexSubImage1D | glTexSubImage1DEXT (
            target: GLenum, level: GLint, xoffset: GLint, width: GLsizei, format: GLenum,
            ty: GLenum, pixels: Data<'a>
        );
        /// Replaces a rectangle of a level.
        tex_sub_image_2d: glTexSubImage2D | glTexSubImage2DEXT (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, width: GLsizei,
            height: GLsizei, format: GLenum, ty: GLenum, pixels: Data<'a>
        );
        /// Replaces a box of a level.
        tex_sub_image_3d: glTexSubImage3D | glTexSubImage3DEXT (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, ty: GLenum,
            pixels: Data<'a>
        );
    }
    Refused in compressed {
        /// Specifies a level from compressed texels; no format takes one dimension.
        compressed_tex_image_1d: glCompressedTexImage1D | glCompressedTexImage1DARB (
            target: GLenum, level: GLint, internalformat: GLenum, width: GLsizei, border: GLint,
            image_size: GLsizei, data: Data<'a>
        );
        /// Specifies a level from compressed texels.
        compressed_tex_image_2d: glCompressedTexImage2D | glCompressedTexImage2DARB (
            target: GLenum, level: GLint, internalformat: GLenum, width: GLsizei, height: GLsizei,
            border: GLint, image_size: GLsizei, data: Data<'a>
        );
        /// Specifies a level of a 2D array from compressed texels.
        compressed_tex_image_3d: glCompressedTexImage3D | glCompressedTexImage3DARB (
            target: GLenum, level: GLint, internalformat: GLenum, width: GLsizei, height: GLsizei,
            depth: GLsizei, border: GLint, image_size: GLsizei, data: Data<'a>
        );
        /// Replaces blocks of a level; no format takes one dimension.
        compressed_tex_sub_image_1d: glCompressedTexSubImage1D | glCompressedTexSubImage1DARB (
            target: GLenum, level: GLint, xoffset: GLint, width: GLsizei, format: GLenum,
            image_size: GLsizei, data: Data<'a>
        );
        /// Replaces blocks of a level.
        compressed_tex_sub_image_2d: glCompressedTexSubImage2D | glCompressedTexSubImage2DARB (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, width: GLsizei,
            height: GLsizei, format: GLenum, image_size: GLsizei, data: Data<'a>
        );
        /// Replaces blocks of a level of a 2D array.
        compressed_tex_sub_image_3d: glCompressedTexSubImage3D | glCompressedTexSubImage3DARB (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, image_size: GLsizei,
            data: Data<'a>
        );
        /// Reads the blocks of a compressed level.
        get_compressed_tex_image: glGetCompressedTexImage | glGetCompressedTexImageARB
            (target: GLenum, level: GLint, img: DataOut<'a>);
    }
    Refused in copy_image {
        /// Copies texels as they are stored from one image to another.
        copy_image_sub_data: glCopyImageSubData (
            src_name: GLuint, src_target: GLenum, src_level: GLint, src_x: GLint, src_y: GLint, src_z: GLint,
            dst_name: GLuint, dst_target: GLenum, dst_level: GLint, dst_x: GLint, dst_y: GLint, dst_z: GLint,
            src_width: GLsizei, src_height: GLsizei, src_depth: GLsizei
        ), not_compiled;
    }
    Refused in clear_image {
        /// Gives every texel of a level the same value; zeros where `data` is null.
        clear_tex_image: glClearTexImage (
            texture: GLuint, level: GLint, format: GLenum, ty: GLenum, data: Data<'a>
        ), not_compiled;
        /// Gives every texel of a box of a level the same value; zeros where `data` is null.
        clear_tex_sub_image: glClearTexSubImage (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, ty: GLenum,
            data: Data<'a>
        ), not_compiled;
    }
    Refused in invalidate {
        /// Says that the texels of a level will not be used.
        invalidate_tex_image: glInvalidateTexImage (texture: GLuint, level: GLint), not_compiled;
        /// Says that the texels of a box of a level will not be used.
        invalidate_tex_sub_image: glInvalidateTexSubImage (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei
        ), not_compiled;
    }
    Refused in get_sub {
        /// Reads a part of a level of a texture.
        get_texture_sub_image: glGetTextureSubImage (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, ty: GLenum,
            buf_size: GLsizei, pixels: DataOut<'a>
        );
        /// Reads blocks of a compressed level of a texture.
        get_compressed_texture_sub_image: glGetCompressedTextureSubImage (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, buf_size: GLsizei,
            pixels: DataOut<'a>
        );
    }
    Refused in copy {
        /// Specifies a level from a row of the read framebuffer.
        copy_tex_image_1d: glCopyTexImage1D | glCopyTexImage1DEXT (
            target: GLenum, level: GLint, internalformat: GLenum, x: GLint, y: GLint,
            width: GLsizei, border: GLint
        );
        /// Specifies a level from a rectangle of the read framebuffer.
        copy_tex_image_2d: glCopyTexImage2D | glCopyTexImage2DEXT (
            target: GLenum, level: GLint, internalformat: GLenum, x: GLint, y: GLint,
            width: GLsizei, height: GLsizei, border: GLint
        );
        /// Replaces a run of a level by one of the read framebuffer.
        copy_tex_sub_image_1d: glCopyTexSubImage1D | glCopyTexSubImage1DEXT (
            target: GLenum, level: GLint, xoffset: GLint, x: GLint, y: GLint, width: GLsizei
        );
        /// Replaces a rectangle of a level by one of the read framebuffer.
        copy_tex_sub_image_2d: glCopyTexSubImage2D | glCopyTexSubImage2DEXT (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, x: GLint, y: GLint,
            width: GLsizei, height: GLsizei
        );
        /// Replaces a rectangle of a slice by one of the read framebuffer.
        copy_tex_sub_image_3d: glCopyTexSubImage3D | glCopyTexSubImage3DEXT (
            target: GLenum, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint, x: GLint,
            y: GLint, width: GLsizei, height: GLsizei
        );
    }
    Setter in parameter {
        /// Sets a parameter of a texture.
        tex_parameteri: glTexParameteri (target: GLenum, pname: GLenum, param: GLint);
        /// Sets a parameter of a texture.
        tex_parameterf: glTexParameterf (target: GLenum, pname: GLenum, param: GLfloat);
        /// Sets a parameter of a texture; a border colour is scaled from the whole `i32` range.
        tex_parameteriv: glTexParameteriv (target: GLenum, pname: GLenum, params: &'a [GLint]);
        /// Sets a parameter of a texture.
        tex_parameterfv: glTexParameterfv (target: GLenum, pname: GLenum, params: &'a [GLfloat]);
    }
    Refused in parameter {
        /// Reads a parameter of a texture.
        get_tex_parameteriv: glGetTexParameteriv
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of a texture.
        get_tex_parameterfv: glGetTexParameterfv
            (target: GLenum, pname: GLenum, params: &'a mut [GLfloat]);
    }
    Refused in parameter {
        /// Sets a parameter of a texture; a border colour is of integers as they are.
        tex_parameter_i_iv: glTexParameterIiv | glTexParameterIivEXT
            (target: GLenum, pname: GLenum, params: &'a [GLint]);
        /// Sets a parameter of a texture; a border colour is of integers as they are.
        tex_parameter_i_uiv: glTexParameterIuiv | glTexParameterIuivEXT
            (target: GLenum, pname: GLenum, params: &'a [GLuint]);
        /// Reads a parameter of a texture; a border colour as integers, not scaled.
        get_tex_parameter_i_iv: glGetTexParameterIiv | glGetTexParameterIivEXT
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of a texture; a border colour as integers, not scaled.
        get_tex_parameter_i_uiv: glGetTexParameterIuiv | glGetTexParameterIuivEXT
            (target: GLenum, pname: GLenum, params: &'a mut [GLuint]);
    }
    Refused in samplers {
        /// Makes `n` sampler objects.
        gen_samplers: glGenSamplers (n: GLsizei, samplers: &'a mut [GLuint]);
        /// Deletes sampler objects; bound ones are unbound.
        delete_samplers: glDeleteSamplers (n: GLsizei, samplers: &'a [GLuint]), not_compiled;
        /// Whether a name is a sampler object.
        is_sampler: glIsSampler (sampler: GLuint) -> bool;
        /// Makes a sampler object stand for the sampler state of a unit's textures; 0 for none.
        bind_sampler: glBindSampler (unit: GLuint, sampler: GLuint), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameteri: glSamplerParameteri (sampler: GLuint, pname: GLenum, param: GLint), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameterf: glSamplerParameterf (sampler: GLuint, pname: GLenum, param: GLfloat), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameteriv: glSamplerParameteriv
            (sampler: GLuint, pname: GLenum, params: &'a [GLint]), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameterfv: glSamplerParameterfv
            (sampler: GLuint, pname: GLenum, params: &'a [GLfloat]), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameter_i_iv: glSamplerParameterIiv | glSamplerParameterIivEXT
            (sampler: GLuint, pname: GLenum, params: &'a [GLint]), not_compiled;
        /// Sets a parameter of a sampler object.
        sampler_parameter_i_uiv: glSamplerParameterIuiv | glSamplerParameterIuivEXT
            (sampler: GLuint, pname: GLenum, params: &'a [GLuint]), not_compiled;
        /// Reads a parameter of a sampler object.
        get_sampler_parameteriv: glGetSamplerParameteriv
            (sampler: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of a sampler object.
        get_sampler_parameterfv: glGetSamplerParameterfv
            (sampler: GLuint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads a parameter of a sampler object.
        get_sampler_parameter_i_iv: glGetSamplerParameterIiv | glGetSamplerParameterIivEXT
            (sampler: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of a sampler object.
        get_sampler_parameter_i_uiv: glGetSamplerParameterIuiv | glGetSamplerParameterIuivEXT
            (sampler: GLuint, pname: GLenum, params: &'a mut [GLuint]);
    }
    Refused in buffer {
        /// Makes the bytes of a buffer object the texels of the bound buffer texture; 0 for none.
        tex_buffer: glTexBuffer | glTexBufferARB | glTexBufferEXT
            (target: GLenum, internalformat: GLenum, buffer: GLuint), not_compiled;
        /// Makes a part of a buffer object's bytes the texels of the bound buffer texture.
        tex_buffer_range: glTexBufferRange (
            target: GLenum, internalformat: GLenum, buffer: GLuint, offset: GLintptr,
            size: GLsizeiptr
        ), not_compiled;
    }
    Refused in mipmap {
        /// Makes all levels above the base from the base level.
        generate_mipmap: glGenerateMipmap | glGenerateMipmapEXT (target: GLenum), not_compiled;
    }
    Refused in query {
        /// Reads what is known of a level.
        get_tex_level_parameteriv: glGetTexLevelParameteriv
            (target: GLenum, level: GLint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of a level.
        get_tex_level_parameterfv: glGetTexLevelParameterfv
            (target: GLenum, level: GLint, pname: GLenum, params: &'a mut [GLfloat]);
    }
    Refused in get {
        /// Reads the texels of a level.
        get_tex_image: glGetTexImage
            (target: GLenum, level: GLint, format: GLenum, ty: GLenum, pixels: DataOut<'a>);
    }
    Setter in env {
        /// Sets a parameter of the active unit's texture environment.
        tex_envi: glTexEnvi (target: GLenum, pname: GLenum, param: GLint);
        /// Sets a parameter of the active unit's texture environment.
        tex_envf: glTexEnvf (target: GLenum, pname: GLenum, param: GLfloat);
        /// Sets a parameter of the active unit's texture environment.
        tex_enviv: glTexEnviv (target: GLenum, pname: GLenum, params: &'a [GLint]);
        /// Sets a parameter of the active unit's texture environment.
        tex_envfv: glTexEnvfv (target: GLenum, pname: GLenum, params: &'a [GLfloat]);
    }
    Refused in env {
        /// Reads a parameter of the active unit's texture environment.
        get_tex_enviv: glGetTexEnviv (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of the active unit's texture environment.
        get_tex_envfv: glGetTexEnvfv (target: GLenum, pname: GLenum, params: &'a mut [GLfloat]);
    }
    } };
}
entry_points_textures!(implement);
