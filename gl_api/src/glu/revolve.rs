//! Draws a surface of revolution as a quadric asks: filled, as lines or points, with normals and
//! texture coordinates.

use super::quadric::{
    GLU_FLAT, GLU_LINE, GLU_NONE, GLU_POINT, GLU_SILHOUETTE, GLU_SMOOTH, GLUquadric,
};
use crate::base::angle::sin_cos_degrees;
use crate::base::constants::{GL_LINE_STRIP, GL_POINTS, GL_QUAD_STRIP};
use crate::entry::{glBegin, glEnd, glNormal3d, glTexCoord2d, glVertex3d};

/// A circle of the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ring {
    pub radius: f64,
    pub z: f64,
    /// The normal's parts away from the axis and along it.
    pub out: f64,
    pub up: f64,
    /// The texture coordinate along the axis; of a disk the radius, where 1 is the outer circle.
    pub t: f64,
}

/// In which directions a surface is straight, so that faces lie in one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// In none.
    Round,
    /// From ring to ring.
    Straight,
    /// In all: it is a disk.
    Flat,
}

/// Which edges are lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edges {
    All,
    /// Not those between faces that lie in one plane.
    Silhouette,
}

/// A surface of revolution.
#[derive(Debug)]
pub(super) struct Surface {
    slices: u32,
    /// Where the first slice begins, and degrees from there to the end of the last.
    angles: (f64, f64),
    bend: Bend,
    /// From the top down, or from the inside out.
    rings: Vec<Ring>,
    /// Halfway to the next.
    between: Vec<Ring>,
}

impl Surface {
    /// A surface of `stacks` from ring 0 to ring `stacks`.
    pub fn new(
        slices: u32,
        angles: (f64, f64),
        bend: Bend,
        stacks: u32,
        ring: impl Fn(f64) -> Ring,
    ) -> Self {
        let rings = (0..=stacks).map(|at| ring(at.into())).collect();
        let between = (0..stacks).map(|at| ring(f64::from(at) + 0.5)).collect();
        Self { slices, angles, bend, rings, between }
    }

    /// Sine and cosine of the angle at which a slice begins.
    fn direction(&self, slice: f64) -> (f64, f64) {
        let (start, sweep) = self.angles;
        sin_cos_degrees(start + sweep * slice / f64::from(self.slices))
    }

    fn is_closed(&self) -> bool {
        self.angles.1 == 360.0
    }

    /// The rings that are lines: all, or those where the surface ends or bends.
    fn ring_lines(&self, edges: Edges) -> impl Iterator<Item = &Ring> {
        let last = self.rings.len() - 1;
        let inner = edges == Edges::All || self.bend == Bend::Round;
        let lines = self.rings.iter().enumerate();
        lines.filter(move |(at, _)| inner || *at == 0 || *at == last).map(|(_, ring)| ring)
    }
}

/// What is given with each point.
struct Pen<'a> {
    surface: &'a Surface,
    quad: &'a GLUquadric,
}

impl Pen<'_> {
    fn normal(&self, ring: &Ring, slice: f64) {
        let (sin, cos) = self.surface.direction(slice);
        let sign = if self.quad.is_inside() { -1.0 } else { 1.0 };
        glNormal3d(sign * ring.out * sin, sign * ring.out * cos, sign * ring.up);
    }

    fn vertex(&self, ring: &Ring, slice: u32) {
        let (sin, cos) = self.surface.direction(slice.into());
        if self.quad.is_textured() {
            if self.surface.bend == Bend::Flat {
                glTexCoord2d(0.5 + ring.t * sin / 2.0, 0.5 + ring.t * cos / 2.0);
            } else {
                let around = f64::from(slice) / f64::from(self.surface.slices);
                glTexCoord2d(1.0 - around, ring.t);
            }
        }
        glVertex3d(ring.radius * sin, ring.radius * cos, ring.z);
    }

    /// A point with its own normal.
    fn point(&self, ring: &Ring, slice: u32) {
        if self.quad.normals() != GLU_NONE {
            self.normal(ring, slice.into());
        }
        self.vertex(ring, slice);
    }

    fn fill(&self) {
        let Surface { slices, rings, between, .. } = self.surface;
        for (pair, middle) in rings.windows(2).zip(between) {
            // Counterclockwise as seen from the front.
            let pair = if self.quad.is_inside() { [pair[0], pair[1]] } else { [pair[1], pair[0]] };
            glBegin(GL_QUAD_STRIP);
            for slice in 0..=*slices {
                // The last corner of a face gives its normal: it is that of the face before.
                if self.quad.normals() == GLU_FLAT {
                    self.normal(middle, f64::from(slice) - 0.5);
                }
                for ring in &pair {
                    if self.quad.normals() == GLU_SMOOTH {
                        self.normal(ring, slice.into());
                    }
                    self.vertex(ring, slice);
                }
            }
            glEnd();
        }
    }

    fn lines(&self, edges: Edges) {
        let surface = self.surface;
        for ring in surface.ring_lines(edges).filter(|ring| ring.radius > 0.0) {
            glBegin(GL_LINE_STRIP);
            (0..=surface.slices).for_each(|slice| self.point(ring, slice));
            glEnd();
        }
        let ends = !surface.is_closed();
        let last = if ends { surface.slices } else { surface.slices - 1 };
        for slice in 0..=last {
            let at_end = ends && (slice == 0 || slice == last);
            if edges == Edges::Silhouette && surface.bend == Bend::Flat && !at_end {
                continue;
            }
            glBegin(GL_LINE_STRIP);
            surface.rings.iter().for_each(|ring| self.point(ring, slice));
            glEnd();
        }
    }

    fn points(&self) {
        let surface = self.surface;
        let end = surface.slices + u32::from(!surface.is_closed());
        glBegin(GL_POINTS);
        for ring in &surface.rings {
            // What comes to a point is one.
            let end = if ring.radius > 0.0 { end } else { 1 };
            (0..end).for_each(|slice| self.point(ring, slice));
        }
        glEnd();
    }
}

/// Draws it.
pub(super) fn draw(surface: &Surface, quad: &GLUquadric) {
    let pen = Pen { surface, quad };
    match quad.style() {
        GLU_POINT => pen.points(),
        GLU_LINE => pen.lines(Edges::All),
        GLU_SILHOUETTE => pen.lines(Edges::Silhouette),
        _ => pen.fill(),
    }
}
