//! Meshes: planes, boxes, spheres, tori and others.

use crate::matrix::{DMat4, DVec3, dvec3, rotate};
use bytemuck::{Pod, Zeroable};
use gl_api::constants::*;
use gl_api::glu::angle::sin_cos_degrees;
use gl_api::types::{GLint, GLuint};
use gl_api::*;
use std::mem::{offset_of, size_of};

/// A vertex; the attribute names are those of [`Model::draw`].
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Vertex {
    /// `aVertex`.
    pub position: [f32; 3],
    /// `aNormal`, of length 1.
    pub normal: [f32; 3],
    /// `aTexCoord`.
    pub tex_coord: [f32; 2],
    /// `aColor`.
    pub color: [f32; 3],
}

/// Triangles, counterclockwise from outside.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<Vertex>,
    /// Indices of vertices, three a triangle.
    pub indices: Vec<GLuint>,
}

/// A point of a surface: position, normal.
type Point = (DVec3, DVec3);

impl Mesh {
    /// A surface over the unit square of texture coordinates, in `columns` × `rows` cells.
    pub fn surface(columns: u32, rows: u32, point: impl Fn(f64, f64) -> Point) -> Self {
        let mut mesh = Self::default();
        for row in 0..=rows {
            for column in 0..=columns {
                let (s, t) =
                    (f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
                let (position, normal) = point(s, t);
                mesh.vertices.push(Vertex {
                    position: position.as_vec3().to_array(),
                    normal: normal.as_vec3().to_array(),
                    tex_coord: [s as f32, t as f32],
                    color: [1.0; 3],
                });
            }
        }
        for row in 0..rows {
            for column in 0..columns {
                let a = row * (columns + 1) + column;
                let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
                mesh.indices.extend([a, b, d, a, d, c]);
            }
        }
        mesh
    }

    /// The square from -1 to 1 in x and y, facing +z.
    pub fn plane() -> Self {
        Self::surface(1, 1, |s, t| (dvec3(2.0 * s - 1.0, 2.0 * t - 1.0, 0.0), DVec3::Z))
    }

    /// A sphere of radius 1.
    pub fn sphere() -> Self {
        Self::surface(96, 48, |s, t| {
            let (sin_s, cos_s) = sin_cos_degrees(360.0 * s);
            let (sin_t, cos_t) = sin_cos_degrees(180.0 * t);
            let out = dvec3(sin_t * sin_s, -cos_t, sin_t * cos_s);
            (out, out)
        })
    }

    /// A torus around the y axis: a tube of radius `tube` around a circle of radius 1.
    pub fn torus(tube: f64) -> Self {
        Self::surface(128, 64, |s, t| {
            let (sin_s, cos_s) = sin_cos_degrees(360.0 * s);
            let (sin_t, cos_t) = sin_cos_degrees(360.0 * t);
            let around = dvec3(sin_s, 0.0, cos_s);
            let out = around * -cos_t + DVec3::Y * -sin_t;
            (around + out * tube, out)
        })
    }

    /// A vase around the y axis, from -1 to 1: a cubic profile of two bulges, turned.
    pub fn vase() -> Self {
        let radius = |y: f64| 0.42 + 0.30 * y * (y - 1.05) * (y + 0.85) - 0.12 * y;
        Self::surface(96, 64, |s, t| {
            let (sin, cos) = sin_cos_degrees(360.0 * s);
            let (around, y) = (dvec3(sin, 0.0, cos), 2.0 * t - 1.0);
            let slope = (radius(y + 1e-4) - radius(y - 1e-4)) / 2e-4;
            (around * radius(y) + DVec3::Y * y, (around - DVec3::Y * slope).normalize())
        })
    }

    /// A cylinder of radius 1 around the y axis from -1 to 1, with its caps.
    pub fn cylinder() -> Self {
        let around = |s: f64| {
            let (sin, cos) = sin_cos_degrees(360.0 * s);
            dvec3(sin, 0.0, cos)
        };
        let mut mesh =
            Self::surface(96, 1, |s, t| (around(s) + DVec3::Y * (2.0 * t - 1.0), around(s)));
        let cap = Self::surface(96, 1, |s, t| (around(s) * (1.0 - t) + DVec3::Y, DVec3::Y));
        mesh.append(cap.clone().moved(rotate(180.0, DVec3::X)));
        mesh.append(cap);
        mesh
    }

    /// The cube from -1 to 1.
    pub fn cube() -> Self {
        let mut mesh = Self::default();
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for out in [axis, -axis] {
                // Any two directions that form a right-handed frame with the normal.
                let side = if axis == DVec3::Y { DVec3::X } else { DVec3::Y.cross(out) };
                let up = out.cross(side);
                mesh.append(Self::surface(1, 1, |s, t| {
                    (out + side * (2.0 * s - 1.0) + up * (2.0 * t - 1.0), out)
                }));
            }
        }
        mesh
    }

    /// A triangle with one normal; its texture coordinates are its x and y.
    pub fn triangle(corners: [DVec3; 3], normal: DVec3) -> Self {
        let vertex = |corner: DVec3| Vertex {
            position: corner.as_vec3().to_array(),
            normal: normal.as_vec3().to_array(),
            tex_coord: corner.truncate().as_vec2().to_array(),
            color: [1.0; 3],
        };
        Self { vertices: corners.map(vertex).to_vec(), indices: vec![0, 1, 2] }
    }

    /// Appends another mesh.
    pub fn append(&mut self, other: Self) {
        let base = self.vertices.len() as GLuint;
        self.vertices.extend(other.vertices);
        self.indices.extend(other.indices.into_iter().map(|index| base + index));
    }

    /// The mesh transformed by a matrix that preserves angles.
    #[must_use]
    pub fn moved(mut self, by: DMat4) -> Self {
        for vertex in &mut self.vertices {
            let position = DVec3::from_array(vertex.position.map(f64::from));
            let normal = DVec3::from_array(vertex.normal.map(f64::from));
            vertex.position = by.transform_point3(position).as_vec3().to_array();
            vertex.normal = by.transform_vector3(normal).normalize().as_vec3().to_array();
        }
        self
    }

    /// The mesh in one colour.
    #[must_use]
    pub fn colored(mut self, color: [f32; 3]) -> Self {
        self.vertices.iter_mut().for_each(|vertex| vertex.color = color);
        self
    }

    /// The mesh with its texture coordinates multiplied by a factor.
    #[must_use]
    pub fn tiled(mut self, s: f32, t: f32) -> Self {
        for vertex in &mut self.vertices {
            vertex.tex_coord = [vertex.tex_coord[0] * s, vertex.tex_coord[1] * t];
        }
        self
    }

    /// Copies the mesh to buffer objects of the current context.
    pub fn upload(&self) -> Model {
        let mut buffers: [GLuint; 2] = [0; 2];
        glGenBuffers(2, &mut buffers);
        let [vertices, indices] = buffers;
        let (vertex_bytes, index_bytes): (&[u8], &[u8]) =
            (bytemuck::cast_slice(&self.vertices), bytemuck::cast_slice(&self.indices));
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, vertex_bytes.len(), vertex_bytes, GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes.len(), index_bytes, GL_STATIC_DRAW);
        Model { vertices, indices, count: self.indices.len() }
    }
}

/// A mesh in buffer objects.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    vertices: GLuint,
    indices: GLuint,
    count: usize,
}

impl Model {
    /// Draws the mesh with the program in use, which reads any of the attributes `aVertex`, `aNormal`,
    /// `aTexCoord` and `aColor`.
    pub fn draw(&self, program: GLuint) {
        glBindBuffer(GL_ARRAY_BUFFER, self.vertices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, self.indices);
        for (name, size, offset) in [
            ("aVertex", 3, offset_of!(Vertex, position)),
            ("aNormal", 3, offset_of!(Vertex, normal)),
            ("aTexCoord", 2, offset_of!(Vertex, tex_coord)),
            ("aColor", 3, offset_of!(Vertex, color)),
        ] {
            let location: GLint = glGetAttribLocation(program, name);
            if location >= 0 {
                let (stride, offset) = (size_of::<Vertex>(), BUFFER_OFFSET(offset));
                glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride, offset);
                glEnableVertexAttribArray(location);
            }
        }
        glDrawElements(GL_TRIANGLES, self.count, GL_UNSIGNED_INT, BUFFER_OFFSET(0));
    }

    /// Draws the mesh with the fixed function; its texture coordinates are those of unit 0.
    pub fn draw_fixed(&self) {
        glBindBuffer(GL_ARRAY_BUFFER, self.vertices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, self.indices);
        let stride = size_of::<Vertex>();
        glVertexPointer(3, GL_FLOAT, stride, BUFFER_OFFSET(offset_of!(Vertex, position)));
        glNormalPointer(GL_FLOAT, stride, BUFFER_OFFSET(offset_of!(Vertex, normal)));
        glTexCoordPointer(2, GL_FLOAT, stride, BUFFER_OFFSET(offset_of!(Vertex, tex_coord)));
        for array in [GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY] {
            glEnableClientState(array);
        }
        glDrawElements(GL_TRIANGLES, self.count, GL_UNSIGNED_INT, BUFFER_OFFSET(0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_face_outward() {
        for mesh in [Mesh::plane(), Mesh::sphere(), Mesh::torus(0.4), Mesh::cube()] {
            let corner = |index: GLuint| {
                let vertex = mesh.vertices[index as usize];
                let position = DVec3::from_array(vertex.position.map(f64::from));
                (position, DVec3::from_array(vertex.normal.map(f64::from)))
            };
            for triangle in mesh.indices.chunks_exact(3) {
                let [a, b, c] = [0, 1, 2].map(|at| corner(triangle[at]));
                let face = (b.0 - a.0).cross(c.0 - a.0);
                // The triangles at a sphere's pole have no area.
                assert!(face.dot(a.1 + b.1 + c.1) > -1e-9, "{a:?} {b:?} {c:?}");
            }
        }
    }
}
