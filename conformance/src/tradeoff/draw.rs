//! Draws a scene in a mode.

use super::mode::Mode;
use super::scene::{Scene, Surface};
use super::stage::{Clock, Frame, Stage, Times, use_program};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;
use rasterizer::driver::Device;
use std::sync::Arc;

/// What draws a scene in a mode.
pub enum Drawer {
    /// The driver, with the square of this many samples a pixel.
    Gl(Box<Stage>, usize),
    /// The integral, in so many seconds.
    Exact(Vec<[f64; 4]>, f64),
}

impl Drawer {
    /// For a picture of `side` × `side` pixels; the integral is the reference, which took so many seconds.
    ///
    /// # Errors
    /// When there is no context, or a call sets the error flag.
    pub fn new(
        device: &Arc<Device>,
        scene: &Scene,
        mode: Mode,
        side: usize,
        (reference, seconds): (&[[f64; 4]], f64),
    ) -> Result<Self, ProbeError> {
        match mode {
            Mode::Filter(_, filter, anisotropy) => {
                Ok(Self::Gl(Box::new(stage(device, scene, (filter, anisotropy), side)?), 1))
            }
            Mode::Supersampled(n) => {
                Ok(Self::Gl(Box::new(stage(device, scene, (GL_LINEAR, 1), side * n)?), n))
            }
            // Rounded to bytes as a framebuffer would.
            Mode::ExactArea => {
                let rounded = reference.iter().map(|p| p.map(|c| (c * 255.0).round() / 255.0));
                Ok(Self::Exact(rounded.collect(), seconds))
            }
        }
    }

    /// The picture.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn picture(&mut self) -> Result<Vec<[f64; 4]>, ProbeError> {
        match self {
            Self::Gl(stage, samples) => stage.picture(*samples),
            Self::Exact(pixels, _) => Ok(pixels.clone()),
        }
    }

    /// The stage, if it is timed with others.
    pub fn stage(&mut self) -> Option<&mut Stage> {
        match self {
            Self::Gl(stage, _) => Some(stage.as_mut()),
            Self::Exact(..) => None,
        }
    }

    /// The times of what is not timed with others.
    pub fn own_times(&self) -> Option<Times> {
        match self {
            Self::Gl(..) => None,
            Self::Exact(_, seconds) => Some(Times { fastest: *seconds, quartiles: [*seconds; 3] }),
        }
    }
}

/// A stage that draws a scene with this filter and anisotropy.
///
/// # Errors
/// When there is no context, or a call sets the error flag.
fn stage(
    device: &Arc<Device>,
    scene: &Scene,
    (filter, anisotropy): (u32, u32),
    side: usize,
) -> Result<Stage, ProbeError> {
    Stage::new(device, Clock::Processor, side, || {
        set_texture(scene, filter, anisotropy);
        match scene.surface {
            Surface::Plane(_) => {
                glEnable(GL_TEXTURE_2D);
                glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            }
            Surface::Sphere => {
                use_program(None, SPHERE);
            }
        }
        let corners = corners(scene);
        Frame::new(move || {
            glClear(GL_COLOR_BUFFER_BIT);
            draw_corners(&corners);
        })
    })
}

/// A corner of a picture: clip x, y, w and (s, t).
pub type Corner = ([f32; 3], [f32; 2]);

/// Draws a quadrilateral.
pub fn draw_corners(corners: &[Corner; 4]) {
    glBegin(GL_QUADS);
    for ([x, y, w], [s, t]) in *corners {
        glTexCoord2f(s, t);
        glVertex4f(x, y, 0, w);
    }
    glEnd();
}

/// Makes the scene's texture with this filter and anisotropy, and with GL's mipmap where the filter needs one.
pub fn set_texture(scene: &Scene, filter: u32, anisotropy: u32) {
    let (target, image) = (GL_TEXTURE_2D, &scene.image);
    let texels = image.texels.as_flattened();
    let (width, height) = (image.width, image.height);
    glBindTexture(target, 1);
    glTexImage2D(target, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    let magnified = if filter == GL_NEAREST { GL_NEAREST } else { GL_LINEAR };
    if filter != magnified {
        glGenerateMipmap(target);
    }
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnified);
    glTexParameteri(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
}

/// The picture's corners. A plane's w is what its perspective makes it; the sphere's shader takes (s, t) for the place in
/// the picture.
pub fn corners(scene: &Scene) -> [Corner; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|at| corner(scene, at))
}

/// A point of the picture.
pub fn corner(scene: &Scene, [x, y]: [f64; 2]) -> Corner {
    match scene.surface {
        Surface::Sphere => ([x as f32, y as f32, 1.0], [x as f32, y as f32]),
        Surface::Plane(map) => {
            let [s, t, q] = map.homogeneous([x, y]);
            let size = [scene.image.width, scene.image.height].map(|n| n as f64);
            let st = [s / q / size[0], t / q / size[1]].map(|c| c as f32);
            ([x / q, y / q, 1.0 / q].map(|c| c as f32), st)
        }
    }
}

/// A sphere in the fragment shader.
const SPHERE: &str = "
    uniform sampler2D image;
    const float PI = 3.14159265358979;
    void main() {
        vec2 p = gl_TexCoord[0].xy;
        float z = sqrt(max(0.0, 1.0 - dot(p, p)));
        float s = 4.0 * atan(p.x, z) / (2.0 * PI);
        float t = 2.0 * asin(clamp(p.y, -1.0, 1.0)) / PI;
        gl_FragColor = texture2D(image, vec2(s, t));
    }";
