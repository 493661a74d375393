//! What `glTextureView` refuses (GL 4.3, section 8.18).

use gl_api::*;

/// The arguments of a call: `texture`, `target`, `origtexture`, `internalformat`, levels and layers.
type Arguments = (GLuint, GLenum, GLuint, GLenum, [GLuint; 2], [GLuint; 2]);
type Case = (Arguments, GLenum, &'static str);

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const D2: GLenum = GL_TEXTURE_2D;
const ARRAY: GLenum = GL_TEXTURE_2D_ARRAY;
const CUBE: GLenum = GL_TEXTURE_CUBE_MAP;
const CUBES: GLenum = GL_TEXTURE_CUBE_MAP_ARRAY;
const RGBA8: GLenum = GL_RGBA8;
/// Names of the textures that `prepared` makes.
const PLAIN: GLuint = 1;
const LAYERS: GLuint = 2;
const WIDE: GLuint = 3;
const BLOCKS: GLuint = 4;
const DEPTHS: GLuint = 5;
const VIEW: GLuint = 6;
/// A name without a texture.
const NEW: GLuint = 7;

/// A texture that may change; 8 layers of 4×4 and of 4×2 with 3 and 2 levels; blocks; depths; a view of the levels 1 and 2,
/// and the layers 4 to 7.
fn prepared() -> Context {
    let mut c = super::context();
    c.gen_textures(7, &mut [0; 7]);
    c.bind_texture(D2, PLAIN);
    c.tex_image_2d(D2, 0, RGBA8 as GLint, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
    c.bind_texture(ARRAY, LAYERS);
    c.tex_storage_3d(ARRAY, 3, RGBA8, 4, 4, 8);
    c.bind_texture(ARRAY, WIDE);
    c.tex_storage_3d(ARRAY, 2, RGBA8, 4, 2, 8);
    c.bind_texture(D2, BLOCKS);
    c.tex_storage_2d(D2, 1, GL_COMPRESSED_RED_RGTC1, 4, 4);
    c.bind_texture(D2, DEPTHS);
    c.tex_storage_2d(D2, 1, GL_DEPTH_COMPONENT24, 4, 4);
    c.texture_view(VIEW, ARRAY, LAYERS, RGBA8, 1, 2, 4, 4);
    c
}

const CASES: &[Case] = &[
    ((0, D2, LAYERS, RGBA8, [0, 1], [0, 1]), VALUE, "texture = 0"),
    ((99, D2, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "texture = 99 must be a name"),
    ((PLAIN, D2, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "texture = 1 is a GL_TEXTURE_2D"),
    ((VIEW, D2, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "texture = 6 is a"),
    ((NEW, D2, 99, RGBA8, [0, 1], [0, 1]), VALUE, "origtexture = 99"),
    ((NEW, D2, NEW, RGBA8, [0, 1], [0, 1]), VALUE, "origtexture = 7"),
    ((NEW, D2, 0, RGBA8, [0, 1], [0, 1]), VALUE, "origtexture = 0"),
    ((NEW, D2, PLAIN, RGBA8, [0, 1], [0, 1]), OPERATION, "glTexStorage2D"),
    ((NEW, GL_TEXTURE_3D, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "target = GL_TEXTURE_3D"),
    ((NEW, GL_TEXTURE_BUFFER, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "views of a GL_TEXTURE"),
    ((NEW, GL_LINEAR, LAYERS, RGBA8, [0, 1], [0, 1]), OPERATION, "target = GL_LINEAR"),
    ((NEW, CUBE, DEPTHS, GL_DEPTH_COMPONENT24, [0, 1], [0, 6]), OPERATION, "GL_TEXTURE_2D_ARRAY"),
    ((NEW, D2, LAYERS, RGBA8, [3, 1], [0, 1]), VALUE, "minlevel = 3 must be below 3"),
    ((NEW, D2, VIEW, RGBA8, [2, 1], [0, 1]), VALUE, "minlevel = 2 must be below 2"),
    ((NEW, D2, LAYERS, RGBA8, [0, 0], [0, 1]), VALUE, "numlevels = 0"),
    ((NEW, D2, LAYERS, RGBA8, [0, 1], [8, 1]), VALUE, "minlayer = 8 must be below 8"),
    ((NEW, D2, VIEW, RGBA8, [0, 1], [4, 1]), VALUE, "minlayer = 4 must be below 4"),
    ((NEW, D2, LAYERS, RGBA8, [0, 1], [0, 0]), VALUE, "numlayers = 0"),
    ((NEW, D2, LAYERS, RGBA8, [0, 1], [0, 2]), VALUE, "numlayers = 2 of a GL_TEXTURE_2D"),
    ((NEW, CUBE, LAYERS, RGBA8, [0, 1], [0, 5]), VALUE, "numlayers = 5"),
    ((NEW, CUBE, LAYERS, RGBA8, [0, 1], [3, 6]), VALUE, "which are 5 here"),
    ((NEW, CUBES, LAYERS, RGBA8, [0, 1], [0, 8]), VALUE, "a multiple of 6"),
    ((NEW, CUBE, WIDE, RGBA8, [0, 1], [0, 6]), OPERATION, "4×2, not square"),
    ((NEW, CUBES, WIDE, RGBA8, [0, 1], [2, 6]), OPERATION, "4×2, not square"),
    ((NEW, D2, LAYERS, GL_RGBA16F, [0, 1], [0, 1]), OPERATION, "GL_RGBA8_SNORM"),
    ((NEW, D2, LAYERS, GL_RGBA, [0, 1], [0, 1]), OPERATION, "internalformat = GL_RGBA,"),
    ((NEW, D2, LAYERS, GL_LINEAR, [0, 1], [0, 1]), OPERATION, "internalformat = GL_LINEAR"),
    ((NEW, D2, BLOCKS, GL_RGBA16F, [0, 1], [0, 1]), OPERATION, "GL_COMPRESSED_SIGNED_RED_RGTC1"),
    ((NEW, D2, DEPTHS, GL_R32UI, [0, 1], [0, 1]), OPERATION, "GL_DEPTH_COMPONENT24"),
];

/// Runs the rows, and what textures refuse because they are views.
pub fn run() {
    for (number, (arguments, flag, words)) in CASES.iter().enumerate() {
        let &(texture, target, origin, internal, [level, levels], [layer, layers]) = arguments;
        let call = |c: &mut Context| {
            c.texture_view(texture, target, origin, internal, level, levels, layer, layers);
        };
        super::row(&mut prepared(), format!("texture views {number}"), &call, *flag, words);
    }
    let name = || "storage of a view".to_owned();
    let storage: &dyn Fn(&mut Context) = &|c| c.texture_storage_3d(VIEW, 1, RGBA8, 1, 1, 1);
    super::row(&mut prepared(), name(), storage, OPERATION, "has storage for good already");
    let level: &dyn Fn(&mut Context) = &|c| {
        c.bind_texture(ARRAY, VIEW);
        let (internal, format) = (RGBA8 as GLint, GL_RGBA);
        c.tex_image_3d(ARRAY, 0, internal, 1, 1, 1, 0, format, GL_UNSIGNED_BYTE, Data::Null);
    };
    let mut c = prepared();
    c.bind_texture(ARRAY, VIEW);
    super::row(&mut c, name(), level, OPERATION, "given for good by glTexStorage");
}
