//! Quadrics: `gluSphere`, `gluCylinder`, `gluDisk`, `gluPartialDisk` (GLU 1.3, chapter 6).
//!
//! Each is a surface of revolution about the z axis: slices around it, counted from +y toward +x,
//! and stacks along it, or loops around the centre of a disk. [`super::revolve`] draws them.

use super::error::{GLU_INVALID_ENUM, GLU_INVALID_VALUE};
use super::revolve::{Bend, Ring, Surface, draw};
use crate::base::angle::sin_cos_degrees;
use crate::base::types::{GLboolean, GLenum, GLint};
use crate::entry::Arg;
use texunit::lanes::FloatEnv;

/// Normals of each point.
pub const GLU_SMOOTH: GLenum = 100_000;
/// Normals of each face.
pub const GLU_FLAT: GLenum = 100_001;
/// No normals.
pub const GLU_NONE: GLenum = 100_002;
/// The corners as points.
pub const GLU_POINT: GLenum = 100_010;
/// The edges of all faces.
pub const GLU_LINE: GLenum = 100_011;
/// Filled faces.
pub const GLU_FILL: GLenum = 100_012;
/// The edges, but those between faces that lie in one plane.
pub const GLU_SILHOUETTE: GLenum = 100_013;
/// Normals point outward, away from the axis or along +z.
pub const GLU_OUTSIDE: GLenum = 100_020;
/// Normals point inward.
pub const GLU_INSIDE: GLenum = 100_021;
/// The callback of [`gluQuadricCallback`].
pub const GLU_ERROR: GLenum = 100_103;

/// What is told of errors.
pub type GLUquadricCallback = Option<extern "C" fn(GLenum)>;

/// How quadrics are drawn. Laid out as libGLU's own object, whose functions may be handed one of
/// these in a process that has both libraries, and the other way round.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct GLUquadric {
    normals: GLenum,
    texture: GLboolean,
    orientation: GLenum,
    style: GLenum,
    error: GLUquadricCallback,
}

/// A new quadric: filled, smooth, outside, without texture coordinates.
pub fn gluNewQuadric() -> GLUquadric {
    GLUquadric {
        normals: GLU_SMOOTH,
        texture: 0,
        orientation: GLU_OUTSIDE,
        style: GLU_FILL,
        error: None,
    }
}

impl GLUquadric {
    /// Sets one of several values; where it is none of them, who is to be told.
    fn set(
        &mut self,
        value: GLenum,
        known: &[GLenum],
        place: impl FnOnce(&mut Self),
    ) -> GLUquadricCallback {
        if known.contains(&value) {
            place(self);
            return None;
        }
        self.error
    }

    /// [`gluQuadricNormals`] up to the callback, which may delete the quadric.
    pub(crate) fn set_normals(&mut self, normal: GLenum) -> GLUquadricCallback {
        self.set(normal, &[GLU_SMOOTH, GLU_FLAT, GLU_NONE], |quad| quad.normals = normal)
    }

    /// [`gluQuadricOrientation`] up to the callback.
    pub(crate) fn set_orientation(&mut self, orientation: GLenum) -> GLUquadricCallback {
        self.set(orientation, &[GLU_OUTSIDE, GLU_INSIDE], |quad| quad.orientation = orientation)
    }

    /// [`gluQuadricDrawStyle`] up to the callback.
    pub(crate) fn set_style(&mut self, draw: GLenum) -> GLUquadricCallback {
        let known = [GLU_FILL, GLU_LINE, GLU_SILHOUETTE, GLU_POINT];
        self.set(draw, &known, |quad| quad.style = draw)
    }

    /// [`gluQuadricCallback`] up to the callback that there was.
    pub(crate) fn set_callback(
        &mut self,
        which: GLenum,
        callback: GLUquadricCallback,
    ) -> GLUquadricCallback {
        self.set(which, &[GLU_ERROR], |quad| quad.error = callback)
    }

    fn refuse(&self, error: GLenum) {
        if let Some(callback) = self.error {
            FloatEnv::in_host(|| callback(error));
        }
    }
}

/// Tells of a value that is none of those that there are.
pub(crate) fn tell(refused: GLUquadricCallback) {
    if let Some(callback) = refused {
        FloatEnv::in_host(|| callback(GLU_INVALID_ENUM));
    }
}

/// Whether and of what there are normals: [`GLU_SMOOTH`], [`GLU_FLAT`] or [`GLU_NONE`].
pub fn gluQuadricNormals(quad: &mut GLUquadric, normal: GLenum) {
    tell(quad.set_normals(normal));
}

/// Whether there are texture coordinates.
pub fn gluQuadricTexture(quad: &mut GLUquadric, texture: impl Arg<bool>) {
    quad.texture = texture.arg().into();
}

/// Which side is the front: [`GLU_OUTSIDE`] or [`GLU_INSIDE`].
pub fn gluQuadricOrientation(quad: &mut GLUquadric, orientation: GLenum) {
    tell(quad.set_orientation(orientation));
}

/// What is drawn: [`GLU_FILL`], [`GLU_LINE`], [`GLU_SILHOUETTE`] or [`GLU_POINT`].
pub fn gluQuadricDrawStyle(quad: &mut GLUquadric, draw: GLenum) {
    tell(quad.set_style(draw));
}

/// What is called with the code of an error; `which` must be [`GLU_ERROR`].
pub fn gluQuadricCallback(quad: &mut GLUquadric, which: GLenum, callback: GLUquadricCallback) {
    tell(quad.set_callback(which, callback));
}

impl GLUquadric {
    /// Draws, or tells of sizes that give no surface.
    fn revolve(&self, surface: Option<Surface>) {
        match surface {
            Some(surface) => draw(&surface, self),
            None => self.refuse(GLU_INVALID_VALUE),
        }
    }

    /// Whether points have normals of their own, faces have, or none do.
    pub(super) fn normals(&self) -> GLenum {
        self.normals
    }

    pub(super) fn is_textured(&self) -> bool {
        self.texture != 0
    }

    pub(super) fn is_inside(&self) -> bool {
        self.orientation == GLU_INSIDE
    }

    pub(super) fn style(&self) -> GLenum {
        self.style
    }
}

/// The number of slices or stacks, at most as many as libGLU draws.
fn count(value: GLint) -> u32 {
    const MOST: u32 = 239;
    u32::try_from(value).unwrap_or(0).min(MOST)
}

/// Draws a sphere about the origin; texture coordinate `t` goes from 0 at -z to 1 at +z.
///
/// `GLU_INVALID_VALUE` for a radius below 0, less than 2 slices or less than 1 stack.
pub fn gluSphere(
    quad: &GLUquadric,
    radius: impl Arg<f64>,
    slices: impl Arg<GLint>,
    stacks: impl Arg<GLint>,
) {
    let _float_env = FloatEnv::enter();
    let (radius, slices, stacks) = (radius.arg(), count(slices.arg()), count(stacks.arg()));
    let possible = radius >= 0.0 && slices >= 2 && stacks >= 1;
    quad.revolve(possible.then(|| {
        let ring = |at: f64| {
            let (sin, cos) = sin_cos_degrees(180.0 * at / f64::from(stacks));
            let t = 1.0 - at / f64::from(stacks);
            Ring { radius: radius * sin, z: radius * cos, out: sin, up: cos, t }
        };
        Surface::new(slices, (0.0, 360.0), Bend::Round, stacks, ring)
    }));
}

/// Draws a cylinder or cone without ends along z, from radius `base` at 0 to `top` at `height`;
/// texture coordinate `t` goes from 0 to 1 with z.
///
/// `GLU_INVALID_VALUE` for a length below 0, less than 2 slices or less than 1 stack.
pub fn gluCylinder(
    quad: &GLUquadric,
    base: impl Arg<f64>,
    top: impl Arg<f64>,
    height: impl Arg<f64>,
    slices: impl Arg<GLint>,
    stacks: impl Arg<GLint>,
) {
    let _float_env = FloatEnv::enter();
    let (base, top, height) = (base.arg(), top.arg(), height.arg());
    let (slices, stacks) = (count(slices.arg()), count(stacks.arg()));
    let possible = base >= 0.0 && top >= 0.0 && height >= 0.0 && slices >= 2 && stacks >= 1;
    // The slope's direction, which a cylinder of nothing does not have.
    let length = ((base - top) * (base - top) + height * height).sqrt();
    let possible = possible && length > 0.0;
    quad.revolve(possible.then(|| {
        let ring = |at: f64| {
            // From the top down, as the stacks of a sphere.
            let t = 1.0 - at / f64::from(stacks);
            let radius = base + (top - base) * t;
            Ring { radius, z: height * t, out: height / length, up: (base - top) / length, t }
        };
        Surface::new(slices, (0.0, 360.0), Bend::Straight, stacks, ring)
    }));
}

/// Draws a disk in the plane of z = 0 with a hole of radius `inner`; texture coordinates are those
/// of a picture that the outer circle touches.
///
/// `GLU_INVALID_VALUE` for radii that are not `0 <= inner <= outer`, an `outer` of 0, less than 2
/// slices or less than 1 loop.
pub fn gluDisk(
    quad: &GLUquadric,
    inner: impl Arg<f64>,
    outer: impl Arg<f64>,
    slices: impl Arg<GLint>,
    loops: impl Arg<GLint>,
) {
    gluPartialDisk(quad, inner, outer, slices, loops, 0.0, 360.0);
}

/// Draws a part of a [`gluDisk`]: `sweep` degrees on from `start`, where 0 is +y and 90 is +x.
pub fn gluPartialDisk(
    quad: &GLUquadric,
    inner: impl Arg<f64>,
    outer: impl Arg<f64>,
    slices: impl Arg<GLint>,
    loops: impl Arg<GLint>,
    start: impl Arg<f64>,
    sweep: impl Arg<f64>,
) {
    let _float_env = FloatEnv::enter();
    let (inner, outer) = (inner.arg(), outer.arg());
    let (slices, loops) = (count(slices.arg()), count(loops.arg()));
    let (start, sweep) = (start.arg(), sweep.arg().clamp(-360.0, 360.0));
    let (start, sweep) = if sweep < 0.0 { (start + sweep, -sweep) } else { (start, sweep) };
    let possible = inner >= 0.0 && outer > 0.0 && inner <= outer && slices >= 2 && loops >= 1;
    let possible = possible && start.is_finite() && sweep.is_finite();
    quad.revolve(possible.then(|| {
        let ring = |at: f64| {
            let radius = inner + (outer - inner) * at / f64::from(loops);
            Ring { radius, z: 0.0, out: 0.0, up: 1.0, t: radius / outer }
        };
        Surface::new(slices, (start, sweep), Bend::Flat, loops, ring)
    }));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::constants::*;
    use crate::context::{Context, ContextDesc};
    use crate::entry::*;

    const SIDE: u32 = 128;

    /// The share of a picture from -1 to 1 that is drawn to, back faces left out.
    fn covered(draw: impl FnOnce(&mut GLUquadric)) -> f64 {
        let desc = ContextDesc { width: SIDE, height: SIDE, ..ContextDesc::default() };
        let _current = Context::new(desc).expect("a device").make_current();
        glEnable(GL_CULL_FACE);
        let mut quad = gluNewQuadric();
        draw(&mut quad);
        let mut pixels = vec![0_u8; (SIDE * SIDE * 4) as usize];
        glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixels);
        assert_eq!(glGetError(), GL_NO_ERROR);
        let lit = pixels.chunks_exact(4).filter(|pixel| pixel[0] > 0).count();
        lit as f64 / f64::from(SIDE * SIDE)
    }

    fn near(share: f64, area: f64) {
        assert!((share - area / 4.0).abs() < 0.01, "{share} of 1, not {}", area / 4.0);
    }

    const PI: f64 = std::f64::consts::PI;

    #[test]
    fn a_sphere_is_seen_from_outside_and_from_inside() {
        near(covered(|quad| gluSphere(quad, 0.8, 64, 32)), PI * 0.64);
        let inside = covered(|quad| {
            gluQuadricOrientation(quad, GLU_INSIDE);
            gluSphere(quad, 0.8, 64, 32);
        });
        near(inside, PI * 0.64);
    }

    #[test]
    fn a_disk_has_a_hole_a_front_and_parts() {
        near(covered(|quad| gluDisk(quad, 0.4, 0.8, 64, 3)), PI * (0.64 - 0.16));
        // Clockwise from +y: an eighth, and the same one the other way round.
        for (start, sweep) in [(0.0, 45.0), (45.0, -45.0)] {
            near(covered(|quad| gluPartialDisk(quad, 0.0, 0.8, 32, 2, start, sweep)), PI * 0.08);
        }
        let back = covered(|quad| {
            gluQuadricOrientation(quad, GLU_INSIDE);
            gluDisk(quad, 0.0, 0.8, 32, 1);
        });
        assert_eq!(back, 0.0);
    }

    #[test]
    fn a_cone_seen_from_the_side_is_a_trapezium() {
        let share = covered(|quad| {
            glRotatef(-90, 1, 0, 0);
            gluCylinder(quad, 0.8, 0.4, 0.9, 64, 5);
        });
        near(share, 0.9 * 1.2);
    }

    #[test]
    fn a_silhouette_has_fewer_lines_and_corners_are_points() {
        let disk = |style: GLenum| {
            covered(move |quad| {
                gluQuadricDrawStyle(quad, style);
                gluDisk(quad, 0.3, 0.8, 12, 4);
            })
        };
        let [fill, line, silhouette, point] =
            [GLU_FILL, GLU_LINE, GLU_SILHOUETTE, GLU_POINT].map(disk);
        assert!(fill > line && line > silhouette && silhouette > point, "{line} {silhouette}");
        assert_eq!(point * f64::from(SIDE * SIDE), 60.0);
    }
}
