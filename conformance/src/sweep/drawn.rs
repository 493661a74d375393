//! What sweeps draw: framebuffers of any size and format, shaders, counted triangles.

use crate::gl::*;
use crate::probe::{ProbeError, Session, Stages};
use gl_api::constants::*;

/// A framebuffer's size and samples.
#[derive(Clone, Copy, Debug)]
pub struct Canvas {
    /// Width and height.
    pub size: [usize; 2],
    /// Samples a pixel; 0 for one without multisampling.
    pub samples: usize,
}

/// How often each pixel of a canvas is drawn by triangles, whose corners are in clip coordinates; with samples, their
/// mean.
pub fn counted(
    session: &Session,
    canvas: Canvas,
    corners: &[[f32; 4]],
) -> Result<Vec<f64>, ProbeError> {
    let Canvas { size: [width, height], samples } = canvas;
    session.frame(GL_RGBA32F, canvas.size, samples)?;
    glUseProgram(0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor4f(1, 0, 0, 0);
    glBegin(GL_TRIANGLES);
    for &[x, y, z, w] in corners {
        glVertex4f(x, y, z, w);
    }
    glEnd();
    glDisable(GL_BLEND);
    if samples > 0 {
        let mut drawn = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, std::slice::from_mut(&mut drawn));
        session.frame(GL_RGBA32F, canvas.size, 0)?;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn as u32);
        let (w, h) = (width as i32, height as i32);
        glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        let mut resolved = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, std::slice::from_mut(&mut resolved));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved as u32);
    }
    Ok(session.read_floats(canvas.size)?.into_iter().map(|pixel| pixel[0]).collect())
}

/// The clip coordinates of a point in pixels of a canvas.
pub fn clip_of([x, y]: [f64; 2], [width, height]: [usize; 2]) -> [f32; 4] {
    [(2.0 * x / width as f64 - 1.0) as f32, (2.0 * y / height as f64 - 1.0) as f32, 0.0, 1.0]
}

/// Uses a program whose fragments are what `fragment` says, and whose vertices are `gl_Vertex`, with
/// `texture_coordinates` of unit 0.
///
/// # Errors
/// With the info log, when it is rejected.
pub fn painted(session: &Session, fragment: &str) -> Result<u32, ProbeError> {
    let vertex = "
        out vec4 texture_coordinates;
        void main() {
            gl_Position = gl_Vertex;
            texture_coordinates = gl_MultiTexCoord0;
        }";
    let fragment = format!("in vec4 texture_coordinates; out vec4 color; {fragment}");
    session.stages(&Stages { vertex, geometry: "", fragment: &fragment })
}

/// Draws a square over the whole viewport, with these texture coordinates at its corners, counter-clockwise.
pub fn square(coordinates: [[f32; 4]; 4]) {
    glBegin(GL_QUADS);
    for ([x, y], [s, t, r, q]) in [[-1, -1], [1, -1], [1, 1], [-1, 1]].into_iter().zip(coordinates)
    {
        glTexCoord4f(s, t, r, q);
        glVertex2f(x, y);
    }
    glEnd();
}

/// The unit square of texture coordinates.
pub const UNIT_SQUARE: [[f32; 4]; 4] =
    [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0]];

/// Makes a texture of floats without mipmap, of nearest filters, bound to the active unit.
///
/// # Errors
/// When a call sets the error flag.
pub fn float_texture(
    session: &Session,
    internal: u32,
    [width, height]: [usize; 2],
    texels: &[[f32; 4]],
) -> Result<u32, ProbeError> {
    let mut name = 0u32;
    let target = GL_TEXTURE_2D;
    glGenTextures(1, &mut name);
    glBindTexture(target, name);
    for parameter in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        glTexParameteri(target, parameter, GL_NEAREST);
    }
    let texels = texels.as_flattened();
    glTexImage2D(target, 0, internal, width, height, 0, GL_RGBA, GL_FLOAT, texels);
    session.check("making a texture of floats")?;
    Ok(name)
}

/// A framebuffer that draws into a texture; its viewport is all of it.
///
/// # Errors
/// When a call sets the error flag.
pub fn draw_into(session: &Session, texture: u32, size: [usize; 2]) -> Result<u32, ProbeError> {
    let mut framebuffer = 0u32;
    glGenFramebuffers(1, &mut framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, size[0], size[1]);
    session.check("drawing into a texture")?;
    Ok(framebuffer)
}
