//! The fixed function with exact results: a case is a point of one pixel in a float framebuffer.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use crate::oracle::combine::{Combiner, Fog, Function, Operand, Source, Unit};
use crate::oracle::vertex::{Light, Surface};
use gl_api::constants::*;

/// Points in a row of the framebuffer.
const ROW: usize = 64;

/// Normalized device coordinates of the pixel of point `k`.
pub fn place(k: usize) -> [f32; 2] {
    [k % ROW, k / ROW].map(|c| (2.0 * c as f32 + 1.0) / ROW as f32 - 1.0)
}

/// A mode of texture coordinate generation: the enum, and the planes of s, t, r, q.
#[derive(Clone, Copy, Debug)]
pub struct GlTexGen {
    /// `GL_TEXTURE_GEN_MODE`.
    pub mode: u32,
    /// Coordinates that are generated.
    pub coordinates: usize,
    /// Planes of the linear modes: the name and one for each coordinate.
    pub planes: Option<(u32, [[f32; 4]; 4])>,
}

impl Session {
    /// Binds a float framebuffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn float_target(&self) -> Result<(), ProbeError> {
        let (mut framebuffer, mut renderbuffer) = (0u32, 0u32);
        glGenFramebuffers(1, &mut framebuffer);
        glGenRenderbuffers(1, &mut renderbuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, ROW, ROW);
        let point = GL_COLOR_ATTACHMENT0;
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
        glViewport(0, 0, ROW, ROW);
        self.check("making a framebuffer of floats")
    }

    /// The colours of `count` points. `draw` sets the state of a point and calls `glVertex`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn points(&self, count: usize, draw: impl Fn(usize)) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = Vec::with_capacity(count);
        for first in (0..count).step_by(ROW * ROW) {
            glClear(GL_COLOR_BUFFER_BIT);
            let here = (count - first).min(ROW * ROW);
            for k in 0..here {
                // This projection maps every vertex with w = 1 to the point's pixel.
                let [x, y] = place(k);
                let mut matrix = [0.0f32; 16];
                (matrix[12], matrix[13], matrix[15]) = (x, y, 1.0);
                glMatrixMode(GL_PROJECTION);
                glLoadMatrixf(&matrix);
                glMatrixMode(GL_MODELVIEW);
                glBegin(GL_POINTS);
                draw(first + k);
                glEnd();
            }
            let mut texels = vec![[0.0f32; 4]; ROW * ROW];
            glReadPixels(0, 0, ROW, ROW, GL_RGBA, GL_FLOAT, texels.as_flattened_mut());
            self.check("drawing points")?;
            values.extend(texels.into_iter().take(here).map(|texel| texel.map(f64::from)));
        }
        Ok(values)
    }

    /// Uses a fragment shader that outputs the first texture coordinates.
    ///
    /// # Errors
    /// When it is rejected.
    pub fn show_coordinates(&self) -> Result<(), ProbeError> {
        self.fragment_only("void main() { gl_FragColor = gl_TexCoord[0]; }")
    }

    /// Enables texture coordinate generation.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn texgen(&self, of: &GlTexGen) -> Result<(), ProbeError> {
        let enables = [GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q];
        for (i, coordinate) in [GL_S, GL_T, GL_R, GL_Q].into_iter().enumerate().take(of.coordinates)
        {
            glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, of.mode);
            if let Some((name, planes)) = &of.planes {
                glTexGenfv(coordinate, *name, &planes[i]);
            }
            glEnable(enables[i]);
        }
        glEnable(GL_NORMALIZE);
        self.check("generating coordinates")
    }

    /// Enables lighting. The model-view matrix must be the identity.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn lighting(&self, lights: &[Light], of: &Surface) -> Result<(), ProbeError> {
        let single = |v: [f64; 4]| v.map(|c| c as f32);
        for (name, light) in (GL_LIGHT0..).zip(lights) {
            glLightfv(name, GL_AMBIENT, &single(light.ambient));
            glLightfv(name, GL_DIFFUSE, &single(light.diffuse));
            glLightfv(name, GL_SPECULAR, &single(light.specular));
            glLightfv(name, GL_POSITION, &single(light.position));
            glLightfv(name, GL_SPOT_DIRECTION, &light.spot_direction.map(|c| c as f32));
            glLightf(name, GL_SPOT_EXPONENT, light.spot_exponent);
            glLightf(name, GL_SPOT_CUTOFF, light.spot_cutoff);
            let names = [GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION];
            for (attenuation, value) in names.into_iter().zip(light.attenuation) {
                glLightf(name, attenuation, value);
            }
            glEnable(name);
        }
        glMaterialfv(GL_FRONT, GL_AMBIENT, &single(of.ambient));
        glMaterialfv(GL_FRONT, GL_DIFFUSE, &single(of.diffuse));
        glMaterialfv(GL_FRONT, GL_SPECULAR, &single(of.specular));
        glMaterialfv(GL_FRONT, GL_EMISSION, &single(of.emission));
        glMaterialf(GL_FRONT, GL_SHININESS, of.shininess);
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &single(of.scene_ambient));
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, i32::from(of.local_viewer));
        glEnable(GL_LIGHTING);
        glEnable(GL_NORMALIZE);
        self.check("setting up lighting")
    }

    /// Enables fog with `GL_FOG_COORD` as its source.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn fog(&self, fog: Fog, color: [f32; 4]) -> Result<(), ProbeError> {
        let mode = match fog {
            Fog::Linear([start, end]) => {
                glFogf(GL_FOG_START, start);
                glFogf(GL_FOG_END, end);
                GL_LINEAR
            }
            Fog::Exp(density) => {
                glFogf(GL_FOG_DENSITY, density);
                GL_EXP
            }
            Fog::Exp2(density) => {
                glFogf(GL_FOG_DENSITY, density);
                GL_EXP2
            }
        };
        glFogi(GL_FOG_MODE, mode);
        glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
        glFogfv(GL_FOG_COLOR, &color);
        glEnable(GL_FOG);
        self.check("setting up fog")
    }

    /// Binds a row of float texels to each unit, and sets the unit's combiners.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn combiners(&self, units: &[Unit], rows: &[Vec<[f32; 4]>]) -> Result<(), ProbeError> {
        // The framebuffer has floats, but a unit's result is clamped as for a window.
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
        for (number, (unit, row)) in units.iter().zip(rows).enumerate() {
            glActiveTexture(GL_TEXTURE0 + number as u32);
            let texels = row.as_flattened();
            let (target, width) = (GL_TEXTURE_2D, row.len());
            glBindTexture(target, number + 1);
            glTexImage2D(target, 0, GL_RGBA32F, width, 1, 0, GL_RGBA, GL_FLOAT, texels);
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glEnable(target);
            let env = GL_TEXTURE_ENV;
            glTexEnvi(env, GL_TEXTURE_ENV_MODE, GL_COMBINE);
            glTexEnvfv(env, GL_TEXTURE_ENV_COLOR, &unit.constant.map(|c| c as f32));
            glTexEnvi(env, GL_COMBINE_RGB, function_enum(unit.color.function));
            glTexEnvi(env, GL_COMBINE_ALPHA, function_enum(unit.alpha.function));
            glTexEnvf(env, GL_RGB_SCALE, unit.color.scale);
            glTexEnvf(env, GL_ALPHA_SCALE, unit.alpha.scale);
            set_arguments(&unit.color, GL_SOURCE0_RGB, GL_OPERAND0_RGB);
            set_arguments(&unit.alpha, GL_SOURCE0_ALPHA, GL_OPERAND0_ALPHA);
        }
        glActiveTexture(GL_TEXTURE0);
        self.check("setting up combiners")
    }
}

/// Sets the three arguments; their enums are consecutive.
fn set_arguments(combiner: &Combiner, source0: u32, operand0: u32) {
    for (number, (source, operand)) in (0..).zip(combiner.arguments) {
        let source = match source {
            Source::Texture => GL_TEXTURE,
            Source::TextureOf(unit) => GL_TEXTURE0 + unit as u32,
            Source::Constant => GL_CONSTANT,
            Source::Primary => GL_PRIMARY_COLOR,
            Source::Previous => GL_PREVIOUS,
        };
        let operand = match operand {
            Operand::Color => GL_SRC_COLOR,
            Operand::OneMinusColor => GL_ONE_MINUS_SRC_COLOR,
            Operand::Alpha => GL_SRC_ALPHA,
            Operand::OneMinusAlpha => GL_ONE_MINUS_SRC_ALPHA,
        };
        glTexEnvi(GL_TEXTURE_ENV, source0 + number, source);
        glTexEnvi(GL_TEXTURE_ENV, operand0 + number, operand);
    }
}

fn function_enum(function: Function) -> u32 {
    match function {
        Function::Replace => GL_REPLACE,
        Function::Modulate => GL_MODULATE,
        Function::Add => GL_ADD,
        Function::AddSigned => GL_ADD_SIGNED,
        Function::Interpolate => GL_INTERPOLATE,
        Function::Subtract => GL_SUBTRACT,
        Function::Dot3Rgb => GL_DOT3_RGB,
        Function::Dot3Rgba => GL_DOT3_RGBA,
    }
}
