//! Triangles in buffer objects.

use super::gl::Gl;
use bytemuck::{Pod, Zeroable};
use gl_api::constants::*;
use std::ffi::c_void;
use std::mem::offset_of;

/// A vertex with the attributes that the scenes use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Vertex {
    /// Object coordinates.
    pub position: [f32; 3],
    /// Normal.
    pub normal: [f32; 3],
    /// Texture coordinates.
    pub st: [f32; 2],
    /// Colour.
    pub color: [f32; 4],
}

/// Triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub vertices: Vec<Vertex>,
    /// Three a triangle, each less than the number of vertices.
    pub indices: Vec<u32>,
}

/// A mesh in a driver's buffer objects.
#[derive(Clone, Copy, Debug)]
pub struct MeshName {
    buffers: [u32; 2],
    count: i32,
}

impl Gl {
    /// Keeps a mesh in buffer objects.
    ///
    /// # Panics
    /// When an index is out of range.
    pub fn mesh(&self, mesh: &Mesh) -> MeshName {
        let last = mesh.indices.iter().max().map_or(0, |&index| index as usize + 1);
        assert!(last <= mesh.vertices.len(), "an index of {last} - 1");
        let mut buffers = [0; 2];
        // SAFETY: there is room for two names.
        unsafe { self.raw.GenBuffers(2, buffers.as_mut_ptr()) };
        let data: [(u32, &[u8]); 2] = [
            (GL_ARRAY_BUFFER, bytemuck::cast_slice(&mesh.vertices)),
            (GL_ELEMENT_ARRAY_BUFFER, bytemuck::cast_slice(&mesh.indices)),
        ];
        for ((target, bytes), name) in data.into_iter().zip(buffers) {
            // SAFETY: GL copies as many bytes as the slice has.
            unsafe {
                self.raw.BindBuffer(target, name);
                self.raw.BufferData(
                    target,
                    bytes.len() as isize,
                    bytes.as_ptr().cast(),
                    GL_STATIC_DRAW,
                );
            }
        }
        MeshName { buffers, count: mesh.indices.len() as i32 }
    }

    /// Draws a mesh through the fixed vertex arrays.
    pub fn draw(&self, mesh: MeshName) {
        let stride = size_of::<Vertex>() as i32;
        let at = |offset: usize| offset as *const c_void;
        // SAFETY: while a buffer is bound the pointers are offsets into it, and every index was
        // held against the number of its vertices when it was made.
        unsafe {
            let gl = &self.raw;
            gl.BindBuffer(GL_ARRAY_BUFFER, mesh.buffers[0]);
            gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.buffers[1]);
            gl.VertexPointer(3, GL_FLOAT, stride, at(offset_of!(Vertex, position)));
            gl.NormalPointer(GL_FLOAT, stride, at(offset_of!(Vertex, normal)));
            gl.ColorPointer(4, GL_FLOAT, stride, at(offset_of!(Vertex, color)));
            gl.ClientActiveTexture(GL_TEXTURE1);
            gl.TexCoordPointer(2, GL_FLOAT, stride, at(offset_of!(Vertex, st)));
            gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
            gl.ClientActiveTexture(GL_TEXTURE0);
            gl.TexCoordPointer(2, GL_FLOAT, stride, at(offset_of!(Vertex, st)));
            for array in [GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY]
            {
                gl.EnableClientState(array);
            }
            gl.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, at(0));
        }
    }
}
