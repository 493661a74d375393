//! Textures by their names: `ARB_direct_state_access`, chapter 8.

use crate::base::args::{Data, DataOut};
use crate::base::types::*;
use crate::calls::texture::{named, named_parameters, named_storage, samplers};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_named_textures {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in named {
        /// Makes `n` textures of a target.
        create_textures: glCreateTextures
            (target: GLenum, n: GLsizei, textures: &'a mut [GLuint]);
        /// Binds a texture to its target of a unit; 0 unbinds what is bound to any target.
        bind_texture_unit: glBindTextureUnit (unit: GLuint, texture: GLuint), not_compiled;
        /// Replaces a run of a level.
        texture_sub_image_1d: glTextureSubImage1D (
            texture: GLuint, level: GLint, xoffset: GLint, width: GLsizei, format: GLenum,
            ty: GLenum, pixels: Data<'a>
        ), not_compiled;
        /// Replaces a rectangle of a level.
        texture_sub_image_2d: glTextureSubImage2D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, width: GLsizei,
            height: GLsizei, format: GLenum, ty: GLenum, pixels: Data<'a>
        ), not_compiled;
        /// Replaces a box of a level; the faces of a cube map are layers.
        texture_sub_image_3d: glTextureSubImage3D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, ty: GLenum,
            pixels: Data<'a>
        ), not_compiled;
        /// Replaces blocks of a level; no format takes one dimension.
        compressed_texture_sub_image_1d: glCompressedTextureSubImage1D (
            texture: GLuint, level: GLint, xoffset: GLint, width: GLsizei, format: GLenum,
            image_size: GLsizei, data: Data<'a>
        ), not_compiled;
        /// Replaces blocks of a level.
        compressed_texture_sub_image_2d: glCompressedTextureSubImage2D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, width: GLsizei,
            height: GLsizei, format: GLenum, image_size: GLsizei, data: Data<'a>
        ), not_compiled;
        /// Replaces blocks of a level; the faces of a cube map are layers.
        compressed_texture_sub_image_3d: glCompressedTextureSubImage3D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint,
            width: GLsizei, height: GLsizei, depth: GLsizei, format: GLenum, image_size: GLsizei,
            data: Data<'a>
        ), not_compiled;
        /// Replaces a run of a level by one of the read framebuffer.
        copy_texture_sub_image_1d: glCopyTextureSubImage1D (
            texture: GLuint, level: GLint, xoffset: GLint, x: GLint, y: GLint, width: GLsizei
        ), not_compiled;
        /// Replaces a rectangle of a level by one of the read framebuffer.
        copy_texture_sub_image_2d: glCopyTextureSubImage2D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, x: GLint, y: GLint,
            width: GLsizei, height: GLsizei
        ), not_compiled;
        /// Replaces a rectangle of a slice or of a face by one of the read framebuffer.
        copy_texture_sub_image_3d: glCopyTextureSubImage3D (
            texture: GLuint, level: GLint, xoffset: GLint, yoffset: GLint, zoffset: GLint, x: GLint,
            y: GLint, width: GLsizei, height: GLsizei
        ), not_compiled;
        /// Makes the smaller levels of a texture.
        generate_texture_mipmap: glGenerateTextureMipmap (texture: GLuint), not_compiled;
        /// Reads a level; the faces of a cube map are layers.
        get_texture_image: glGetTextureImage (
            texture: GLuint, level: GLint, format: GLenum, ty: GLenum, buf_size: GLsizei,
            pixels: DataOut<'a>
        );
        /// Reads the blocks of a compressed level; the faces of a cube map are layers.
        get_compressed_texture_image: glGetCompressedTextureImage
            (texture: GLuint, level: GLint, buf_size: GLsizei, pixels: DataOut<'a>);
        /// Reads what is known of a level; of a cube map, of its first face.
        get_texture_level_parameterfv: glGetTextureLevelParameterfv
            (texture: GLuint, level: GLint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads what is known of a level; of a cube map, of its first face.
        get_texture_level_parameteriv: glGetTextureLevelParameteriv
            (texture: GLuint, level: GLint, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in named_storage {
        /// Gives a 1D texture all its levels for good.
        texture_storage_1d: glTextureStorage1D
            (texture: GLuint, levels: GLsizei, internalformat: GLenum, width: GLsizei), not_compiled;
        /// Gives a 2D, rectangle, cube map or 1D array texture all its levels for good.
        texture_storage_2d: glTextureStorage2D (
            texture: GLuint, levels: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei
        ), not_compiled;
        /// Gives a 3D or 2D array texture all its levels for good.
        texture_storage_3d: glTextureStorage3D (
            texture: GLuint, levels: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, depth: GLsizei
        ), not_compiled;
        /// Gives a texture an image with several samples a texel for good.
        texture_storage_2d_multisample: glTextureStorage2DMultisample (
            texture: GLuint, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, fixedsamplelocations: bool
        ), not_compiled;
        /// Gives a texture layers with several samples a texel for good.
        texture_storage_3d_multisample: glTextureStorage3DMultisample (
            texture: GLuint, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei, depth: GLsizei, fixedsamplelocations: bool
        ), not_compiled;
        /// Takes the texels of a texture from a buffer.
        texture_buffer: glTextureBuffer
            (texture: GLuint, internalformat: GLenum, buffer: GLuint), not_compiled;
        /// Takes the texels of a texture from a part of a buffer.
        texture_buffer_range: glTextureBufferRange (
            texture: GLuint, internalformat: GLenum, buffer: GLuint, offset: GLintptr,
            size: GLsizeiptr
        ), not_compiled;
    }
    Refused in named_parameters {
        /// Sets a parameter of a texture.
        texture_parameterf: glTextureParameterf
            (texture: GLuint, pname: GLenum, param: GLfloat), not_compiled;
        /// Sets a parameter of a texture.
        texture_parameterfv: glTextureParameterfv
            (texture: GLuint, pname: GLenum, params: &'a [GLfloat]), not_compiled;
        /// Sets a parameter of a texture.
        texture_parameteri: glTextureParameteri
            (texture: GLuint, pname: GLenum, param: GLint), not_compiled;
        /// Sets a parameter of a texture; a border colour is of integers as they are.
        texture_parameter_i_iv: glTextureParameterIiv
            (texture: GLuint, pname: GLenum, params: &'a [GLint]), not_compiled;
        /// Sets a parameter of a texture; a border colour is of integers as they are.
        texture_parameter_i_uiv: glTextureParameterIuiv
            (texture: GLuint, pname: GLenum, params: &'a [GLuint]), not_compiled;
        /// Sets a parameter of a texture; a border colour is scaled from the whole `i32` range.
        texture_parameteriv: glTextureParameteriv
            (texture: GLuint, pname: GLenum, params: &'a [GLint]), not_compiled;
        /// Reads a parameter of a texture.
        get_texture_parameterfv: glGetTextureParameterfv
            (texture: GLuint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads a parameter of a texture; a border colour as integers, not scaled.
        get_texture_parameter_i_iv: glGetTextureParameterIiv
            (texture: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads a parameter of a texture; a border colour as integers, not scaled.
        get_texture_parameter_i_uiv: glGetTextureParameterIuiv
            (texture: GLuint, pname: GLenum, params: &'a mut [GLuint]);
        /// Reads a parameter of a texture.
        get_texture_parameteriv: glGetTextureParameteriv
            (texture: GLuint, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in samplers {
        /// Makes `n` sampler objects.
        create_samplers: glCreateSamplers (n: GLsizei, samplers: &'a mut [GLuint]);
    }
    } };
}
entry_points_named_textures!(implement);
