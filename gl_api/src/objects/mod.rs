//! Objects: those of a share group ([`shared`]), and those that are a context's own.

pub(crate) mod arrays;
pub(crate) mod assemblies;
pub(crate) mod blocks;
pub(crate) mod bound;
pub(crate) mod buffers;
pub(crate) mod color_buffers;
pub(crate) mod egl_images;
pub(crate) mod framebuffers;
pub(crate) mod lists;
pub(crate) mod name_table;
pub(crate) mod pipelines;
pub(crate) mod programs;
pub(crate) mod queries;
pub(crate) mod renderbuffers;
pub(crate) mod sampler;
pub(crate) mod shaders;
pub(crate) mod shared;
pub(crate) mod syncs;
pub(crate) mod target;
pub(crate) mod texture;
pub(crate) mod texture_buffer;

use crate::assembly::Target;
use crate::objects::arrays::VertexArray;
use crate::objects::assemblies::Assembly;
use crate::objects::bound::Bound;
use crate::objects::framebuffers::Framebuffer;
use crate::objects::name_table::NameTable;
use crate::objects::pipelines::Pipelines;
use crate::objects::queries::Query;
use crate::objects::shared::{GroupAccess, ShareGroup};
use crate::objects::target::TextureTarget;
use crate::objects::texture::Texture;
use rasterizer::driver::Image;

/// The objects that a context can reach.
#[derive(Debug)]
pub(crate) struct Objects {
    /// Those of its share group; the first access of a call locks the group.
    pub shared: GroupAccess,
    /// The textures named 0, by target.
    pub default_textures: [Texture; TextureTarget::COUNT],
    pub framebuffers: NameTable<Framebuffer>,
    /// The assembly programs named 0, by target.
    pub default_assemblies: [Assembly; 2],
    /// Vertex array objects; the state of name 0 is kept apart while another is bound.
    pub vertex_arrays: NameTable<VertexArray>,
    pub default_vertex_array: VertexArray,
    /// A placeholder, with nothing in it.
    pub spare_vertex_array: VertexArray,
    pub queries: NameTable<Query>,
    pub pipelines: Pipelines,
}

impl Objects {
    /// The objects of a new context.
    pub fn new(group: ShareGroup) -> Self {
        Self {
            shared: GroupAccess::new(group),
            default_textures: TextureTarget::ALL.map(Texture::new),
            framebuffers: NameTable::default(),
            default_assemblies: [Target::Vertex, Target::Fragment].map(Assembly::new),
            vertex_arrays: NameTable::default(),
            default_vertex_array: VertexArray::default(),
            spare_vertex_array: VertexArray::default(),
            queries: NameTable::default(),
            pipelines: Pipelines::default(),
        }
    }

    /// The referenced texture; if none is, the default texture of the target.
    pub fn texture(&self, target: TextureTarget, bound: &Bound) -> &Texture {
        self.shared.textures.bound(bound).unwrap_or(&self.default_textures[target as usize])
    }

    /// The referenced texture, to be changed.
    pub fn texture_mut(&mut self, target: TextureTarget, bound: &Bound) -> &mut Texture {
        self.shared.textures.bound_mut(bound).unwrap_or(&mut self.default_textures[target as usize])
    }

    /// Notes the textures to whose images the driver has drawn.
    pub fn images_changed(&mut self, changed: impl Fn(&Image) -> bool) {
        for texture in self.shared.textures.values_mut().chain(&mut self.default_textures) {
            if changed(&texture.image) {
                texture.texels_changed();
            }
        }
    }
}
