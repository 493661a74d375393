//! What an internal format can be used for with a target (`ARB_internalformat_query2`).

use crate::base::constants::*;
use crate::base::limits;
use crate::base::types::*;
use crate::context::profile::Profile;
use crate::objects::target::TextureTarget;
use crate::pixel::component_bits::{Component, component_bits};
use crate::pixel::formats::{self, FormatClass, InternalFormat, Renderable};
use rasterizer::driver::MAX_SAMPLES;
use texunit::format::{BaseFormat, Block, Encoding, Format};
use texunit::image::FACES;

/// What images are made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Resource {
    Renderbuffer,
    Texture(TextureTarget),
}

/// A format of a resource that can have it.
#[derive(Clone, Copy)]
pub(super) struct Supported {
    resource: Resource,
    pub format: &'static InternalFormat,
    profile: Profile,
}

impl Supported {
    /// `None` where there is no such format, or the resource cannot have it.
    pub fn new(resource: Resource, internal: GLenum, profile: Profile) -> Option<Self> {
        let format = formats::find(internal)?;
        let is_supported = match resource {
            Resource::Renderbuffer => format.is_for_renderbuffers(),
            Resource::Texture(TextureTarget::Buffer) => format.is_for_texel_buffers(),
            Resource::Texture(target) => format.is_for_textures() && fits(format, target),
        };
        is_supported.then_some(Self { resource, format, profile })
    }

    /// The numbers of samples, the largest first; none where there is but one.
    pub fn samples(&self) -> &'static [GLint] {
        let is_drawn_to =
            self.format.renderable != Renderable::No && self.format.is_for_multisampling();
        let has_samples = match self.resource {
            Resource::Renderbuffer => true,
            Resource::Texture(target) => target.is_multisample(),
        };
        if has_samples && is_drawn_to && !self.format.is_compressed() {
            &[MAX_SAMPLES as GLint]
        } else {
            &[]
        }
    }

    fn stored(&self) -> Format {
        self.format.stored
    }

    /// Textures, without those whose texels are a buffer's.
    pub fn texture(&self) -> Option<TextureTarget> {
        match self.resource {
            Resource::Renderbuffer | Resource::Texture(TextureTarget::Buffer) => None,
            Resource::Texture(target) => Some(target),
        }
    }

    /// Whether shaders sample it.
    pub fn is_sampled(&self) -> bool {
        matches!(self.resource, Resource::Texture(_))
    }

    /// Textures that `glTexImage` gives their texels.
    fn is_given(&self) -> bool {
        self.texture().is_some_and(|target| !target.is_multisample())
    }

    pub fn has_depth(&self) -> bool {
        self.stored().is_depth() && !self.is_stencil()
    }

    fn is_stencil(&self) -> bool {
        formats::is_of_stencils(self.format.name)
    }

    pub fn has_stencil(&self) -> bool {
        self.stored().has_stencil()
    }

    pub fn is_color(&self) -> bool {
        !self.stored().is_depth()
    }

    /// The sized format that is stored for it.
    pub fn preferred(&self) -> GLenum {
        let of = self.format;
        let is_same = |other: &&InternalFormat| {
            other.class == FormatClass::Sized
                && (other.base, other.stored, other.components)
                    == (of.base, of.stored, of.components)
        };
        match of.class {
            FormatClass::Unsized => {
                formats::FORMATS.iter().find(is_same).map_or(of.name, |other| other.name)
            }
            FormatClass::Sized
            | FormatClass::GenericCompressed
            | FormatClass::GeneralCompressed
            | FormatClass::SpecialCompressed => of.name,
        }
    }

    /// Bits of a component; depths beside stencils alone are none of the format's.
    pub fn bits(&self, component: Component) -> GLint {
        match component {
            Component::Depth if self.is_stencil() => 0,
            component => component_bits(self.stored(), component),
        }
    }

    /// Bits of the exponent that components share.
    pub fn shared_bits(&self) -> GLint {
        if self.stored().info().encoding == Encoding::SharedExponent { 5 } else { 0 }
    }

    /// What the numbers of a component are.
    pub fn kind(&self, component: Component) -> GLenum {
        if self.bits(component) == 0 {
            return GL_NONE;
        }
        if component == Component::Stencil {
            return GL_UNSIGNED_INT;
        }
        super::query::kind(self.stored())
    }

    /// Width, height and depth or layers; 0 for what the resource has not.
    pub fn largest(&self) -> [u32; 3] {
        match self.resource {
            Resource::Renderbuffer => [limits::MAX_TEXTURE_SIZE, limits::MAX_TEXTURE_SIZE, 0],
            Resource::Texture(target) => {
                let count = match target {
                    TextureTarget::D1 | TextureTarget::Buffer => 1,
                    TextureTarget::D2
                    | TextureTarget::Rect
                    | TextureTarget::External
                    | TextureTarget::Cube
                    | TextureTarget::D1Array
                    | TextureTarget::D2Multisample => 2,
                    TextureTarget::D3
                    | TextureTarget::D2Array
                    | TextureTarget::CubeArray
                    | TextureTarget::D2MultisampleArray => 3,
                };
                let all = target.limits();
                [0, 1, 2].map(|axis| if axis < count { all[axis] } else { 0 })
            }
        }
    }

    /// The most layers, if the resource has any.
    pub fn layers(&self) -> u32 {
        match self.resource {
            Resource::Texture(
                TextureTarget::D1Array
                | TextureTarget::D2Array
                | TextureTarget::CubeArray
                | TextureTarget::D2MultisampleArray,
            ) => limits::MAX_ARRAY_TEXTURE_LAYERS,
            Resource::Renderbuffer | Resource::Texture(_) => 0,
        }
    }

    /// The product of all sides, of the faces of cube maps, and of the samples of textures.
    pub fn combined(&self) -> i64 {
        let sides = self.largest().into_iter().filter(|side| *side > 0).map(i64::from);
        let faces = match self.resource {
            Resource::Texture(TextureTarget::Cube | TextureTarget::CubeArray) => FACES as i64,
            Resource::Renderbuffer | Resource::Texture(_) => 1,
        };
        let samples = self.samples().first().filter(|_| self.resource != Resource::Renderbuffer);
        sides.product::<i64>() * faces * i64::from(samples.copied().unwrap_or(1))
    }

    /// Whether it is drawn to as an attachment.
    pub fn is_rendered(&self) -> bool {
        self.format.renderable != Renderable::No
            && !self.format.is_compressed()
            && self.format.class != FormatClass::GenericCompressed
            && self.resource != Resource::Texture(TextureTarget::Buffer)
    }

    pub fn is_rendered_as(&self, component: Component) -> bool {
        let is_one = match component {
            Component::Depth => self.has_depth(),
            Component::Stencil => self.has_stencil(),
            Component::Red
            | Component::Green
            | Component::Blue
            | Component::Alpha
            | Component::Luminance
            | Component::Intensity => self.is_color(),
        };
        is_one && self.is_rendered()
    }

    /// Whether all layers are drawn to at once.
    pub fn is_rendered_layered(&self) -> bool {
        let has_layers = match self.resource {
            Resource::Renderbuffer => false,
            Resource::Texture(target) => match target {
                TextureTarget::D3
                | TextureTarget::Cube
                | TextureTarget::D1Array
                | TextureTarget::D2Array
                | TextureTarget::CubeArray
                | TextureTarget::D2MultisampleArray => true,
                TextureTarget::D1
                | TextureTarget::D2
                | TextureTarget::Rect
                | TextureTarget::External
                | TextureTarget::D2Multisample
                | TextureTarget::Buffer => false,
            },
        };
        has_layers && self.is_rendered()
    }

    pub fn is_blended(&self) -> bool {
        self.is_color() && !self.stored().is_integer() && self.is_rendered()
    }

    /// Format and type in which its texels are given and read fastest; `None` of textures that are not given texels.
    pub fn texel_pixels(&self) -> Option<[GLenum; 2]> {
        self.is_given().then(|| self.pixels())
    }

    /// The same of what is drawn to.
    pub fn read_pixels(&self) -> Option<[GLenum; 2]> {
        self.is_rendered().then(|| self.pixels())
    }

    fn pixels(&self) -> [GLenum; 2] {
        let stored = self.stored();
        let is_integer = stored.is_integer();
        let format = match (stored.base(), is_integer) {
            (BaseFormat::Red, false) => GL_RED,
            (BaseFormat::Red, true) => GL_RED_INTEGER,
            (BaseFormat::Rg, false) => GL_RG,
            (BaseFormat::Rg, true) => GL_RG_INTEGER,
            (BaseFormat::Rgb, false) => GL_RGB,
            (BaseFormat::Rgb, true) => GL_RGB_INTEGER,
            (BaseFormat::Rgba, false) => GL_RGBA,
            (BaseFormat::Rgba, true) => GL_RGBA_INTEGER,
            (BaseFormat::Alpha, false) => GL_ALPHA,
            (BaseFormat::Alpha, true) => GL_ALPHA_INTEGER,
            (BaseFormat::Luminance | BaseFormat::Intensity, false) => GL_LUMINANCE,
            (BaseFormat::Luminance | BaseFormat::Intensity, true) => GL_LUMINANCE_INTEGER_EXT,
            (BaseFormat::LuminanceAlpha, false) => GL_LUMINANCE_ALPHA,
            (BaseFormat::LuminanceAlpha, true) => GL_LUMINANCE_ALPHA_INTEGER_EXT,
            (BaseFormat::Depth, _) if self.is_stencil() => GL_STENCIL_INDEX,
            (BaseFormat::Depth, _) if self.has_stencil() => GL_DEPTH_STENCIL,
            (BaseFormat::Depth, _) => GL_DEPTH_COMPONENT,
        };
        [format, self.pixel_type()]
    }

    fn pixel_type(&self) -> GLenum {
        let stored = self.stored();
        let bits = stored.channel_bits(0);
        match (stored, stored.info().encoding) {
            _ if self.is_stencil() => GL_UNSIGNED_BYTE,
            (Format::D24S8, _) => GL_UNSIGNED_INT_24_8,
            (Format::D32FS8, _) => GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
            (Format::R11G11B10F, _) => GL_UNSIGNED_INT_10F_11F_11F_REV,
            (Format::R5G6B5, _) => GL_UNSIGNED_SHORT_5_6_5,
            (Format::Rgb10A2 | Format::Rgb10A2UI, _) => GL_UNSIGNED_INT_2_10_10_10_REV,
            (_, Encoding::SharedExponent) => GL_UNSIGNED_INT_5_9_9_9_REV,
            (_, Encoding::Float) if bits <= 16 => GL_HALF_FLOAT,
            (_, Encoding::Float) => GL_FLOAT,
            (_, Encoding::Snorm | Encoding::Sint) if bits <= 8 => GL_BYTE,
            (_, Encoding::Snorm | Encoding::Sint) if bits <= 16 => GL_SHORT,
            (_, Encoding::Snorm | Encoding::Sint) => GL_INT,
            (_, Encoding::Block(Block::Rgtc1Snorm | Block::Rgtc2Snorm)) => GL_BYTE,
            (_, Encoding::Block(Block::BptcUnsignedFloat | Block::BptcSignedFloat)) => {
                GL_HALF_FLOAT
            }
            (_, Encoding::Block(_) | Encoding::SrgbBlock(_)) => GL_UNSIGNED_BYTE,
            (_, Encoding::Unorm | Encoding::Srgb | Encoding::Uint) if bits <= 8 => GL_UNSIGNED_BYTE,
            (_, Encoding::Unorm | Encoding::Srgb | Encoding::Uint) if bits <= 16 => {
                GL_UNSIGNED_SHORT
            }
            (_, Encoding::Unorm | Encoding::Srgb | Encoding::Uint) => GL_UNSIGNED_INT,
        }
    }

    /// Whether textures have several levels.
    pub fn has_levels(&self) -> bool {
        self.texture().is_some_and(|target| target.levels() > 1)
    }

    /// Whether `glGenerateMipmap` makes its levels.
    pub fn has_made_levels(&self) -> bool {
        self.has_levels() && self.stored().has_mean()
    }

    /// Whether `GL_GENERATE_MIPMAP` does, which core profiles have not.
    pub fn has_automatic_levels(&self) -> bool {
        self.has_made_levels() && self.profile.is_compatibility()
    }

    pub fn encoding(&self) -> GLenum {
        match (self.is_color(), self.stored().is_srgb()) {
            (false, _) => GL_NONE,
            (true, false) => GL_LINEAR,
            (true, true) => GL_SRGB,
        }
    }

    pub fn is_srgb_read(&self) -> bool {
        self.stored().is_srgb() && self.is_sampled()
    }

    pub fn is_srgb_written(&self) -> bool {
        self.stored().is_srgb() && self.is_rendered()
    }

    /// Whether filters other than `GL_NEAREST` take it.
    pub fn is_filtered(&self) -> bool {
        self.is_given() && !self.stored().is_integer() && !self.is_stencil()
    }

    /// Whether lookups compare with a reference.
    pub fn is_compared(&self) -> bool {
        self.is_given() && self.has_depth()
    }

    pub fn is_gathered(&self) -> bool {
        let has = |target| match target {
            TextureTarget::D2
            | TextureTarget::D2Array
            | TextureTarget::Cube
            | TextureTarget::CubeArray => true,
            TextureTarget::D1
            | TextureTarget::D3
            | TextureTarget::Rect
            | TextureTarget::External
            | TextureTarget::D1Array
            | TextureTarget::D2Multisample
            | TextureTarget::D2MultisampleArray
            | TextureTarget::Buffer => false,
        };
        self.texture().is_some_and(has)
    }

    /// Whether it may be sampled while the test of its depths or stencils runs, without writing.
    pub fn is_sampled_while_tested(&self, component: Component) -> bool {
        self.is_sampled() && self.is_rendered_as(component)
    }

    pub fn is_compressed(&self) -> bool {
        self.stored().block().is_some()
    }

    /// How many texels wide and high a block is, and how many bytes it has.
    pub fn block(&self) -> Option<[GLint; 2]> {
        let stored = self.stored();
        let has_blocks = stored.block().is_some();
        has_blocks.then(|| [stored.block_side() as GLint, stored.bytes() as GLint])
    }

    /// Whether `glClearBufferData` fills buffers with it.
    pub fn is_cleared(&self) -> bool {
        self.resource == Resource::Texture(TextureTarget::Buffer)
    }
}

/// Whether textures of a target, which are no buffers', have a format that textures may have.
fn fits(format: &InternalFormat, target: TextureTarget) -> bool {
    let (has_blocks, is_depth) = (format.stored.block().is_some(), format.stored.is_depth());
    match target {
        TextureTarget::D1 | TextureTarget::D1Array | TextureTarget::Rect => !has_blocks,
        TextureTarget::D3 => format.stored.has_volumes() && !is_depth,
        TextureTarget::D2Multisample | TextureTarget::D2MultisampleArray => {
            format.is_for_multisampling()
        }
        TextureTarget::D2
        | TextureTarget::Cube
        | TextureTarget::D2Array
        | TextureTarget::CubeArray
        | TextureTarget::Buffer
        | TextureTarget::External => true,
    }
}
