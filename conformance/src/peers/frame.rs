//! The description of a frame, from which both a driver and the formulas draw a picture.

use super::client::Mesh;
use crate::oracle::lod::{Filter, Filters, Mipmap};
use crate::oracle::matrix::Matrix;
use crate::oracle::texture::Level;
use crate::oracle::vertex::{Light, Surface};

/// The textures of a scene and the steps of a frame.
#[derive(Clone, Debug, Default)]
pub struct FrameDescription {
    /// Texture `n` is bound to texture unit `n` all the time.
    pub textures: Vec<Texture>,
    /// The steps, in order.
    pub steps: Vec<Step>,
}

/// A two-dimensional texture that repeats, or a seamless cube map.
#[derive(Clone, Debug)]
pub struct Texture {
    /// Its texels.
    pub texels: Texels,
    /// Its filters.
    pub filters: Filters,
    /// `GL_TEXTURE_MAX_ANISOTROPY_EXT`.
    pub anisotropy: f64,
}

/// The source of a texture's texels.
#[derive(Clone, Debug)]
pub enum Texels {
    /// RGBA8, level by level.
    Given(Vec<Level>),
    /// RGBA8 of a cube map, face by face in the order of GL's enums, level by level; filters are linear.
    Cube(Vec<Vec<Level>>),
    /// 24 bits of depth that [`Step::ShadowMap`] draws, compared with `GL_LEQUAL`.
    ShadowMap,
}

/// A step of a frame.
#[derive(Clone, Debug)]
pub enum Step {
    /// `glClear` of colour and depth.
    Clear([f32; 4]),
    /// Draws.
    Draw(Draw),
    /// Draws depth only, into the texture of unit 0.
    ShadowMap(Draw),
    /// Specifies level 0 of unit 0 again (`glTexSubImage2D`).
    Upload(Level),
    /// `glGenerateMipmap` of unit 0.
    GenerateMipmaps,
    /// `glReadPixels` of the picture.
    ReadBack,
}

/// A draw and its state.
#[derive(Clone, Debug)]
pub struct Draw {
    /// Triangles, none of which reaches behind the eye.
    pub mesh: Mesh,
    /// Object to eye coordinates.
    pub model_view: Matrix,
    /// Eye to clip coordinates.
    pub projection: Matrix,
    /// The texture matrix of unit 0, for the programs that read it.
    pub texture_matrix: Matrix,
    /// Blending and the depth test.
    pub output: Output,
    /// How the colour of a fragment is computed.
    pub shading: Shading,
}

/// How a fragment is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Replaces the pixel.
    Replace,
    /// Blends: `As Cs + (1 - As) Cd`.
    Blend,
    /// Replaces the pixel if it is nearer (`GL_LESS`).
    DepthTest,
}

/// The source of colours.
#[derive(Clone, Copy, Debug)]
pub enum Shading {
    /// The vertices' colour, times the textures of this many units.
    Modulate(usize),
    /// The vertices' colour, times the cube map of unit 0 at the object coordinates (`GL_OBJECT_LINEAR`).
    CubeMapped,
    /// Lit vertices, in fog.
    Lit(&'static Lighting),
    /// A shader.
    Program(&'static Program),
}

/// Lights, material and `GL_EXP2` fog.
#[derive(Clone, Copy, Debug)]
pub struct Lighting {
    /// In eye coordinates.
    pub lights: &'static [Light],
    /// The material.
    pub surface: Surface,
    /// `GL_FOG_DENSITY`.
    pub density: f64,
    /// `GL_FOG_COLOR`.
    pub fog: [f64; 4],
}

/// A shader and what it computes. Its vertex shader is [`VERTEX`].
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// GLSL 1.10; the samplers `unit0` and `unit1` read the units of that number.
    pub fragment: &'static str,
    /// The same formula in `f64`.
    pub formula: fn(&Fragment<'_>) -> [f64; 4],
}

/// The vertex shader of every program.
pub const VERTEX: &str = "
varying vec3 normal;
varying vec3 object;
void main() {
    gl_Position = ftransform();
    gl_FrontColor = gl_Color;
    gl_TexCoord[0] = gl_MultiTexCoord0;
    normal = gl_NormalMatrix * gl_Normal;
    object = gl_Vertex.xyz;
}
";

/// The inputs of a program's formula.
pub struct Fragment<'a> {
    /// `gl_TexCoord[0].st`.
    pub st: [f64; 2],
    /// `normal`.
    pub normal: [f64; 3],
    /// `object`.
    pub object: [f64; 3],
    /// `gl_Color`.
    pub color: [f64; 4],
    /// `gl_TextureMatrix[0]`.
    pub texture_matrix: Matrix,
    /// `texture2D` of a unit at coordinates whose derivatives are those of `st`.
    pub texture: &'a dyn Fn(usize, [f64; 2]) -> [f64; 4],
    /// `textureCube` of level 0 of unit 0.
    pub cube: &'a dyn Fn([f64; 3]) -> [f64; 4],
    /// `shadow2D` of unit 0.
    pub shadow: &'a dyn Fn([f64; 3]) -> f64,
}

/// `GL_NEAREST`.
pub const NEAREST: Filters = Filters::only(Filter::Nearest);
/// `GL_LINEAR`.
pub const BILINEAR: Filters = Filters::only(Filter::Linear);
/// `GL_LINEAR_MIPMAP_LINEAR`.
pub const TRILINEAR: Filters =
    Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear };

/// The identity matrix.
pub const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

impl Draw {
    /// A mesh in clip coordinates.
    pub fn new(mesh: Mesh, shading: Shading) -> Self {
        Self {
            mesh,
            model_view: IDENTITY,
            projection: IDENTITY,
            texture_matrix: IDENTITY,
            output: Output::Replace,
            shading,
        }
    }

    /// Another projection.
    pub fn projection(mut self, projection: Matrix) -> Self {
        self.projection = single(projection);
        self
    }

    /// Another model-view matrix.
    pub fn model_view(mut self, model_view: Matrix) -> Self {
        self.model_view = single(model_view);
        self
    }

    /// Another texture matrix.
    pub fn texture_matrix(mut self, texture_matrix: Matrix) -> Self {
        self.texture_matrix = single(texture_matrix);
        self
    }

    /// Blending, or the depth test.
    pub fn output(mut self, output: Output) -> Self {
        self.output = output;
        self
    }
}

impl Texture {
    /// Texels with these filters.
    pub fn new(levels: Vec<Level>, filters: Filters) -> Self {
        Self { texels: Texels::Given(levels), filters, anisotropy: 1.0 }
    }

    /// The levels of six faces, with these filters.
    pub fn cube(faces: Vec<Vec<Level>>, filters: Filters) -> Self {
        Self { texels: Texels::Cube(faces), filters, anisotropy: 1.0 }
    }

    /// Anisotropic up to this ratio.
    pub fn anisotropic(mut self, limit: f64) -> Self {
        self.anisotropy = limit;
        self
    }
}

/// The matrix that a driver gets: its numbers are those of `f32`.
fn single(m: Matrix) -> Matrix {
    m.map(|row| row.map(|c| f64::from(c as f32)))
}
