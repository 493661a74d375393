//! Texture objects: their images, sampler state and sample plan (GL 2.1, section 3.8).

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;
use crate::objects::egl_images::{Siblings, Specified};
use crate::objects::framebuffers::Planes;
use crate::objects::sampler::SamplerState;
pub(crate) use crate::objects::target::TextureTarget;
use crate::objects::texture_buffer::DataStore;
use crate::pixel::formats::{self, format_name};
use crate::pixel::formats::{ComponentType, FormatClass};
use crate::pixel::stencil_texels::stencil_texels;
use rasterizer::driver::{Device, Image, LevelInfo};
use std::num::NonZeroU64;
use std::sync::Arc;
use texunit::format::{Encoding, Format};
use texunit::image::{Image as Texels, Incomplete, Level};
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler, Wrap};

/// A texture object.
#[derive(Debug)]
pub(crate) struct Texture {
    pub target: TextureTarget,
    pub image: Image,
    pub state: SamplerState,
    /// `GL_GENERATE_MIPMAP`: whether a change of the base level generates the others.
    pub generate_mipmap: bool,
    pub priority: f32,
    /// Which of depth and stencil is sampled, of images that have both.
    pub depth_stencil: DepthStencilMode,
    /// Which part of its storage it shows, if that is immutable (`ARB_texture_storage`).
    pub immutable: Option<Shown>,
    /// The requested samples of a multisample texture.
    pub samples: Option<Samples>,
    /// The buffer range of a buffer texture.
    pub store: DataStore,
    /// The internal format that was asked for, by face and level.
    pub requested: Vec<[GLenum; limits::MAX_TEXTURE_LEVELS]>,
    /// The EGL images that have its storage too.
    pub siblings: Siblings,
    /// The sample plan of the last draw, until something changes.
    plan: Option<Planned>,
    /// Whether no draw has used its texels yet.
    is_new: bool,
}

/// Which part of immutable storage a texture shows: all, or that of a view (GL 4.3, section 8.18).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Shown {
    /// How many levels the storage was made with.
    pub storage_levels: u32,
    /// The level of the storage that is level 0 here.
    pub first_level: u32,
    pub levels: u32,
    /// The layer of the storage that is layer 0 here; faces of a cube are layers.
    pub first_layer: u32,
    pub layers: u32,
}

/// `GL_DEPTH_STENCIL_TEXTURE_MODE` (`ARB_stencil_texturing`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DepthStencilMode {
    Depth,
    /// Stencil values as unsigned integers.
    Stencil,
}

/// The sample plan for one sampler state.
#[derive(Debug)]
struct Planned {
    sampler: Sampler,
    /// That of the texels, where views share them.
    version: Option<NonZeroU64>,
    plan: Arc<SamplePlan>,
    draws: Draws,
}

/// How many draws had the same plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Draws {
    One,
    Several,
}

impl Planned {
    /// The plan for one more draw. With the second draw, texels are searched for alpha other than 1, once, as opaque
    /// textures are drawn faster.
    fn again(&mut self) -> Arc<SamplePlan> {
        if std::mem::replace(&mut self.draws, Draws::Several) == Draws::One
            && let Some(opaque) = self.plan.without_alpha()
        {
            self.plan = Arc::new(opaque);
        }
        Arc::clone(&self.plan)
    }
}

/// The sampler state of a new texture (GL 2.1, table 6.16; `ARB_texture_rectangle`).
fn default_sampler(target: TextureTarget) -> Sampler {
    match target {
        TextureTarget::Rect | TextureTarget::External => Sampler {
            wrap: [Wrap::ClampToEdge; 3],
            min: Filter::Linear,
            mipmap: Mipmap::None,
            ..Sampler::default()
        },
        // Texels are fetched, never filtered, so integers need no other defaults.
        TextureTarget::D2Multisample
        | TextureTarget::D2MultisampleArray
        | TextureTarget::Buffer => Sampler {
            wrap: [Wrap::ClampToEdge; 3],
            min: Filter::Nearest,
            mag: Filter::Nearest,
            mipmap: Mipmap::None,
            ..Sampler::default()
        },
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::D3
        | TextureTarget::Cube
        | TextureTarget::D1Array
        | TextureTarget::D2Array
        | TextureTarget::CubeArray => Sampler::default(),
    }
}

/// The samples of an image that has several a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Samples {
    /// How many there are.
    pub count: u8,
    /// Whether fixed sample locations were requested; they always are fixed.
    pub fixed_locations: bool,
}

/// The image of a successful proxy request (GL 2.1, section 3.8.11).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Proxy {
    /// Width, height and depth of the level, without border.
    pub size: [u32; 3],
    pub border: u32,
    pub internal: GLenum,
    pub format: Format,
    pub samples: Option<Samples>,
}

/// The last request of each target's proxy, by level.
pub(crate) type Proxies = [[Option<Proxy>; limits::MAX_TEXTURE_LEVELS]; TextureTarget::COUNT];

impl Texture {
    pub fn new(target: TextureTarget) -> Self {
        let shape = target.shape();
        Self {
            target,
            image: Image::new(Texels::new(shape)),
            state: SamplerState { sampler: default_sampler(target), ..SamplerState::default() },
            generate_mipmap: false,
            priority: 1.0,
            depth_stencil: DepthStencilMode::Depth,
            immutable: None,
            samples: None,
            store: DataStore::default(),
            requested: vec![[GL_NONE; limits::MAX_TEXTURE_LEVELS]; shape.faces()],
            siblings: Siblings::default(),
            plan: None,
            is_new: true,
        }
    }

    /// The sampler state, with base and maximum level clamped to the levels of immutable storage.
    pub fn sampler(&self) -> Sampler {
        let mut sampler = self.state.sampler.clone();
        if let Some(Shown { levels, .. }) = self.immutable {
            sampler.base_level = sampler.base_level.min(levels - 1);
            sampler.max_level = sampler.max_level.clamp(sampler.base_level, levels - 1);
        }
        sampler
    }

    /// The internal format of a level; `GL_NONE` of one that there is not.
    pub fn internal(&self, face: usize, level: usize) -> GLenum {
        let levels = self.requested.get(face);
        levels.and_then(|levels| levels.get(level)).copied().unwrap_or(GL_NONE)
    }

    /// Whether it is of stencils alone (`ARB_texture_stencil8`).
    pub fn is_of_stencils(&self) -> bool {
        formats::is_of_stencils(self.internal(0, self.sampler().base_level as usize))
    }

    /// Which of depth and stencil it has as an attachment.
    pub fn planes(&self) -> Planes {
        if self.is_of_stencils() { Planes::STENCIL } else { Planes::BOTH }
    }

    /// Notes that it has its storage for good, with so many levels.
    pub fn make_immutable(&mut self, levels: u32) {
        let depth = self.image.level(0, 0).map_or(0, |level| level.size[2]);
        let layers = match self.target {
            TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D2MultisampleArray => depth,
            TextureTarget::Cube => self.target.shape().faces() as u32,
            TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::Rect
            | TextureTarget::External
            | TextureTarget::D3
            | TextureTarget::D2Multisample
            | TextureTarget::Buffer => 1,
        };
        let (storage_levels, first_level, first_layer) = (levels, 0, 0);
        self.immutable = Some(Shown { storage_levels, first_level, levels, first_layer, layers });
    }

    /// To be called before levels are specified: siblings keep the storage as it is.
    pub fn specify(&mut self, levels: Specified) {
        self.siblings.specify(&self.image, levels);
    }

    /// To be called after every change except of parameters, which the plan is compared with.
    pub fn changed(&mut self) {
        self.plan = None;
    }

    /// To be called after every change of texels.
    pub fn texels_changed(&mut self) {
        self.changed();
        self.is_new = true;
    }

    /// The number of bytes of its texels if no draw has used them before, else 0.
    pub fn new_bytes(&mut self) -> usize {
        if !std::mem::take(&mut self.is_new) {
            return 0;
        }
        let faces = 0..self.target.shape().faces();
        let levels = |face| (0..limits::MAX_TEXTURE_LEVELS).map(move |level| (face, level));
        let all = faces.flat_map(levels).filter_map(|(face, level)| self.image.level(face, level));
        all.map(|LevelInfo { format, size, .. }| {
            let [width, height, depth] = size;
            Level::required_bytes(format, width, height, depth).unwrap_or(0)
        })
        .sum()
    }

    /// Whether it was sampled since it was changed.
    pub fn is_planned(&self) -> bool {
        self.plan.is_some()
    }

    /// The sample plan with this state. The device's threads update its texels first.
    pub fn plan(&mut self, device: &Device, sampler: &Sampler) -> Arc<SamplePlan> {
        let version = self.image.shared_version();
        let is_right =
            |planned: &&mut Planned| planned.sampler == *sampler && planned.version == version;
        if let Some(planned) = self.plan.as_mut().filter(is_right) {
            return planned.again();
        }
        let reads_one_level = sampler.mipmap == Mipmap::None && sampler.max_anisotropy <= 1.0;
        let texels = match (sampler.compare, self.depth_stencil) {
            (Some(_), DepthStencilMode::Depth) if reads_one_level => {
                device.compared_texels(&self.image)
            }
            (Some(_) | None, DepthStencilMode::Depth | DepthStencilMode::Stencil) => {
                device.texels(&self.image)
            }
        };
        let plan = match self.depth_stencil {
            DepthStencilMode::Depth if !self.is_of_stencils() => SamplePlan::new(&texels, sampler),
            DepthStencilMode::Depth | DepthStencilMode::Stencil => {
                SamplePlan::new(&stencil_texels(&texels), sampler)
            }
        };
        let plan = Arc::new(plan);
        let first = Planned { sampler: sampler.clone(), version, plan, draws: Draws::One };
        Arc::clone(&self.plan.insert(first).plan)
    }

    /// Whether the base level's format is of fractions from 0 to 1 that are stored as floats, as those of
    /// `GL_DEPTH_COMPONENT32` are.
    pub fn stores_fractions_as_floats(&self) -> bool {
        let base = self.sampler().base_level as usize;
        let stored = self.image.level(0, base).map(|level| level.format);
        let is_float_depth =
            |format: Format| format.is_depth() && matches!(format.info().encoding, Encoding::Float);
        stored.is_some_and(is_float_depth)
            && formats::find(self.requested[0][base])
                .is_some_and(|row| row.components == ComponentType::Unorm)
    }

    /// Whether the base level was asked for as a sized format of depth.
    pub fn is_of_sized_depth(&self) -> bool {
        let level = (self.sampler().base_level as usize).min(limits::MAX_TEXTURE_LEVELS - 1);
        let internal = self.requested.first().and_then(|levels| formats::find(levels[level]));
        internal.is_some_and(|row| row.class == FormatClass::Sized && row.stored.is_depth())
    }

    /// Why it cannot be sampled, if so.
    pub fn incomplete_reason(&self, sampler: &Sampler) -> Option<String> {
        if let Some(planned) = &self.plan
            && planned.sampler == *sampler
            && planned.plan.incomplete().is_none()
        {
            return None;
        }
        if self.target == TextureTarget::Buffer {
            return self.store.incomplete_reason();
        }
        if self.target.is_multisample() && self.image.level(0, 0).is_none() {
            return Some("it has no image: give it one with glTexImage2DMultisample or 3D".into());
        }
        let reason = self.image.completeness(sampler).err()?;
        Some(match reason {
            Incomplete::MixedFormats { got, expected, .. } => {
                format!("{reason}: {} is not {}", format_name(got), format_name(expected))
            }
            Incomplete::FilteredIntegers { format, .. } => {
                format!("{reason} (they are of {})", format_name(format))
            }
            Incomplete::NoBase { .. }
            | Incomplete::Empty { .. }
            | Incomplete::NoLevels { .. }
            | Incomplete::FilteredDepths { .. }
            | Incomplete::Missing { .. }
            | Incomplete::WrongSize { .. }
            | Incomplete::MixedBorders { .. }
            | Incomplete::NotSquare { .. }
            | Incomplete::UnequalFaces { .. } => reason.to_string(),
        })
    }
}
