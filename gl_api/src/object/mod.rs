//! Objects and their names: GL 2.1, sections 2.9, 2.15 and 3.8.12; framebuffer objects.

pub(crate) mod assemblies;
pub(crate) mod buffer_map;
pub(crate) mod buffers;
pub(crate) mod compiler;
pub(crate) mod conditional;
pub(crate) mod framebuffers;
pub(crate) mod indexed_buffers;
pub(crate) mod programs;
pub(crate) mod queries;
pub(crate) mod renderbuffers;
pub(crate) mod samplers;
pub(crate) mod shaders;
pub(crate) mod sharing;
pub(crate) mod syncs;
pub(crate) mod textures;
pub(crate) mod vertex_arrays;

use crate::assembly::Target;
use crate::error::{Result, invalid_operation, not_negative};
use crate::list::List;
use crate::texture::sampler::SamplerState;
use crate::texture::{Texture, TextureTarget};
use crate::types::*;
use assemblies::Assembly;
use rasterizer::driver::{Buffer, Image};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The names of one kind of object.
#[derive(Debug)]
pub(crate) struct Names<T> {
    /// `None` is a name that was made but never bound.
    objects: BTreeMap<GLuint, Option<T>>,
}

impl<T> Default for Names<T> {
    fn default() -> Self {
        Self { objects: BTreeMap::new() }
    }
}

impl<T> Names<T> {
    /// The smallest unused name above `after`.
    fn unused(&self, after: GLuint) -> GLuint {
        let mut name = after + 1;
        for &used in self.objects.range(name..).map(|(used, _)| used) {
            if used != name {
                break;
            }
            name += 1;
        }
        name
    }

    /// `glGen…`: reserves `n` names.
    fn reserve(&mut self, section: &'static str, n: GLsizei, names: &mut [GLuint]) -> Result<()> {
        let n = not_negative(section, "n", n.into())?;
        if names.len() < n {
            let has = names.len();
            return invalid_operation(
                section,
                format!("n = {n}, but the memory has {has} elements"),
            );
        }
        let mut last = 0;
        for name in &mut names[..n] {
            last = self.unused(last);
            self.objects.insert(last, None);
            *name = last;
        }
        Ok(())
    }

    /// Adds an object under an unused name.
    fn add(&mut self, object: T) -> GLuint {
        let name = self.unused(0);
        self.objects.insert(name, Some(object));
        name
    }

    /// Makes sure that a name other than 0 has an object: binding creates it.
    fn create(&mut self, name: GLuint, new: impl FnOnce() -> T) {
        if name != 0 {
            self.objects.entry(name).or_insert(None).get_or_insert_with(new);
        }
    }

    /// Whether a name was made, with an object or without.
    fn is_reserved(&self, name: GLuint) -> bool {
        self.objects.contains_key(&name)
    }

    /// The object of a name.
    pub fn get(&self, name: GLuint) -> Option<&T> {
        self.objects.get(&name)?.as_ref()
    }

    /// The object of a name, to be changed.
    pub fn get_mut(&mut self, name: GLuint) -> Option<&mut T> {
        self.objects.get_mut(&name)?.as_mut()
    }

    /// Every object.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.objects.values().flatten()
    }

    /// Every object, to be changed.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.objects.values_mut().flatten()
    }

    /// Forgets a name.
    fn remove(&mut self, name: GLuint) -> Option<T> {
        self.objects.remove(&name)?
    }
}

/// The names that a `glDelete…` call names.
fn doomed<'a>(section: &'static str, n: GLsizei, names: &'a [GLuint]) -> Result<&'a [GLuint]> {
    let n = not_negative(section, "n", n.into())?;
    match names.get(..n) {
        Some(names) => Ok(names),
        None => {
            let has = names.len();
            invalid_operation(section, format!("n = {n}, but the memory has {has} elements"))
        }
    }
}

/// All objects of a context.
#[derive(Debug)]
pub(crate) struct Objects {
    pub textures: Names<Texture>,
    /// The textures named 0, by target.
    pub default_textures: [Texture; TextureTarget::COUNT],
    pub samplers: Names<SamplerState>,
    pub buffers: Names<buffers::BufferObject>,
    pub framebuffers: Names<framebuffers::Framebuffer>,
    pub renderbuffers: Names<renderbuffers::Renderbuffer>,
    /// Shaders and programs share one space of names.
    pub programs: Names<programs::ShaderOrProgram>,
    /// Assembly programs, and those of name 0 by target.
    pub assemblies: Names<Assembly>,
    pub default_assemblies: [Assembly; 2],
    /// Vertex array objects; that of name 0 has a place of its own while another is bound.
    pub vertex_arrays: Names<vertex_arrays::VertexArray>,
    pub default_vertex_array: vertex_arrays::VertexArray,
    pub queries: Names<queries::Query>,
    pub syncs: syncs::Syncs,
    /// Display lists.
    pub lists: BTreeMap<GLuint, Arc<List>>,
}

impl Default for Objects {
    fn default() -> Self {
        Self {
            textures: Names::default(),
            default_textures: TextureTarget::ALL.map(Texture::new),
            samplers: Names::default(),
            buffers: Names::default(),
            framebuffers: Names::default(),
            renderbuffers: Names::default(),
            programs: Names::default(),
            assemblies: Names::default(),
            default_assemblies: [Target::Vertex, Target::Fragment].map(Assembly::new),
            vertex_arrays: Names::default(),
            default_vertex_array: vertex_arrays::VertexArray::default(),
            queries: Names::default(),
            syncs: syncs::Syncs::default(),
            lists: BTreeMap::new(),
        }
    }
}

impl Objects {
    /// The name, or 0 if there is no such buffer any more.
    pub fn existing_buffer(&self, name: GLuint) -> GLuint {
        if self.buffers.get(name).is_some() { name } else { 0 }
    }

    /// Forgets a buffer; textures that are made of it keep its bytes.
    fn remove_buffer(&mut self, name: GLuint) {
        let Some(object) = self.buffers.remove(name) else { return };
        let buffer = object.map.map_or(object.buffer, |map| Buffer::new(map.bytes));
        for texture in self.textures.values_mut().chain(&mut self.default_textures) {
            texture.store.keep(name, &buffer);
        }
    }

    /// The texture of a name; 0 is the default texture of the target.
    pub fn texture(&self, target: TextureTarget, name: GLuint) -> &Texture {
        self.textures.get(name).unwrap_or(&self.default_textures[target as usize])
    }

    /// The texture of a name, to be changed.
    pub fn texture_mut(&mut self, target: TextureTarget, name: GLuint) -> &mut Texture {
        self.textures.get_mut(name).unwrap_or(&mut self.default_textures[target as usize])
    }

    /// Lets the textures know whose images the driver has drawn to.
    pub fn images_changed(&mut self, changed: impl Fn(&Image) -> bool) {
        for texture in self.textures.values_mut().chain(&mut self.default_textures) {
            if changed(&texture.image) {
                texture.texels_changed();
            }
        }
    }
}
