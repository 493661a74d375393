//! `glGetTexLevelParameter`: GL 2.1, section 6.1.3.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::level_request::Destination;
use crate::context::Context;
use crate::draw::texture_buffer::length;
use crate::objects::target::{ImageTarget, TextureTarget, any_known, checked_level};
use crate::objects::texture::Samples;
use crate::objects::texture_buffer::DataStore;
use crate::pixel::component_bits::{Component, component_bits};
use crate::pixel::formats;
use std::ops::Range;
use texunit::format::{Block, Encoding, Format};
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 6.1.3";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Width,
    Height,
    DepthOfVolume,
    Border,
    InternalFormat,
    Compressed,
    CompressedBytes,
    Bits(Component),
    /// Bits of the exponent that all components share (`EXT_texture_shared_exponent`).
    SharedBits,
    Samples,
    FixedLocations,
    /// Of a buffer texture: the buffer's name and which of its bytes are texels.
    Buffer,
    BufferOffset,
    BufferSize,
    /// What kind of numbers a component is (`ARB_texture_float`).
    Kind(Component),
}

const PROPERTY: Table<Property> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_WIDTH, Property::Width),
        (GL_TEXTURE_HEIGHT, Property::Height),
        (GL_TEXTURE_DEPTH, Property::DepthOfVolume),
        (GL_TEXTURE_BORDER, Property::Border),
        (GL_TEXTURE_INTERNAL_FORMAT, Property::InternalFormat),
        (GL_TEXTURE_COMPRESSED, Property::Compressed),
        (GL_TEXTURE_RED_SIZE, Property::Bits(Component::Red)),
        (GL_TEXTURE_GREEN_SIZE, Property::Bits(Component::Green)),
        (GL_TEXTURE_BLUE_SIZE, Property::Bits(Component::Blue)),
        (GL_TEXTURE_ALPHA_SIZE, Property::Bits(Component::Alpha)),
        (GL_TEXTURE_LUMINANCE_SIZE, Property::Bits(Component::Luminance)),
        (GL_TEXTURE_INTENSITY_SIZE, Property::Bits(Component::Intensity)),
        (GL_TEXTURE_RED_TYPE, Property::Kind(Component::Red)),
        (GL_TEXTURE_GREEN_TYPE, Property::Kind(Component::Green)),
        (GL_TEXTURE_BLUE_TYPE, Property::Kind(Component::Blue)),
        (GL_TEXTURE_ALPHA_TYPE, Property::Kind(Component::Alpha)),
        (GL_TEXTURE_LUMINANCE_TYPE, Property::Kind(Component::Luminance)),
        (GL_TEXTURE_INTENSITY_TYPE, Property::Kind(Component::Intensity)),
        (GL_TEXTURE_DEPTH_TYPE, Property::Kind(Component::Depth)),
        (GL_TEXTURE_COMPRESSED_IMAGE_SIZE, Property::CompressedBytes),
        (GL_TEXTURE_STENCIL_SIZE, Property::Bits(Component::Stencil)),
        (GL_TEXTURE_DEPTH_SIZE, Property::Bits(Component::Depth)),
        (GL_TEXTURE_SHARED_SIZE, Property::SharedBits),
        (GL_TEXTURE_SAMPLES, Property::Samples),
        (GL_TEXTURE_FIXED_SAMPLE_LOCATIONS, Property::FixedLocations),
        (GL_TEXTURE_BUFFER_DATA_STORE_BINDING, Property::Buffer),
        (GL_TEXTURE_BUFFER_OFFSET, Property::BufferOffset),
        (GL_TEXTURE_BUFFER_SIZE, Property::BufferSize),
    ],
};

/// What a level is, or what a proxy said that it could be.
struct Known {
    /// Width, height and depth as a call has them, border included.
    given: [u32; 3],
    border: u32,
    internal: GLenum,
    format: Format,
    samples: Option<Samples>,
    /// Of a buffer texture: the buffer's name and which of its bytes are texels.
    buffer: (GLuint, Range<usize>),
}

impl Known {
    /// Bits of a component. Depths beside stencils are none of the texture's.
    fn bits(&self, component: Component) -> GLint {
        match component {
            Component::Depth if formats::is_of_stencils(self.internal) => 0,
            component => component_bits(self.format, component),
        }
    }
}

/// What is known of a buffer texture.
fn known_buffer(context: &Context, store: &DataStore) -> Known {
    let range = store.range_of(length(context, store));
    Known {
        given: [store.texels(range.len()), 1, 1],
        border: 0,
        internal: store.internal,
        format: store.format,
        samples: None,
        buffer: (store.buffer.name(), range),
    }
}

fn known(context: &Context, (of, face): (&Destination, u8), level: usize) -> Option<Known> {
    let target = of.image().target();
    let (size, border, internal, format, samples) = match of {
        Destination::Texture(texture) if target == TextureTarget::Buffer => {
            return Some(known_buffer(context, &texture.get(context).store));
        }
        Destination::Texture(texture) => {
            let texture = texture.get(context);
            let number = usize::from(face);
            let found = texture.image.level(number, level)?;
            let requested = texture.requested[number][level];
            (found.size, found.border[0], requested, found.format, texture.samples)
        }
        Destination::Proxy(_) => {
            let proxy = context.state.proxies[target as usize][level]?;
            (proxy.size, proxy.border, proxy.internal, proxy.format, proxy.samples)
        }
    };
    let borders = target.shape().border(border);
    let given = target.level_box([0, 1, 2].map(|axis| size[axis] + 2 * borders[axis]));
    Some(Known { given, border, internal, format, samples, buffer: (0, 0..0) })
}

/// What kind of numbers a format's components are.
pub(super) fn kind(format: Format) -> GLenum {
    match format.info().encoding {
        Encoding::Snorm | Encoding::Block(Block::Rgtc1Snorm | Block::Rgtc2Snorm) => {
            GL_SIGNED_NORMALIZED
        }
        Encoding::Block(Block::BptcUnsignedFloat | Block::BptcSignedFloat) => GL_FLOAT,
        Encoding::Unorm | Encoding::Srgb | Encoding::Block(_) | Encoding::SrgbBlock(_) => {
            GL_UNSIGNED_NORMALIZED
        }
        Encoding::Float | Encoding::SharedExponent => GL_FLOAT,
        Encoding::Uint => GL_UNSIGNED_INT,
        Encoding::Sint => GL_INT,
    }
}

fn property(context: &Context, target: GLenum, level: GLint, pname: GLenum) -> Result<GLint> {
    let image = any_known(target)?;
    let face = match image {
        ImageTarget::Bound(face) => face.face,
        ImageTarget::Proxy(_) => 0,
    };
    property_of(context, (&Destination::new(context, image), face), level, pname)
}

/// A property of a level of a texture or of a proxy.
fn property_of(
    context: &Context,
    (of, face): (&Destination, u8),
    level: GLint,
    pname: GLenum,
) -> Result<GLint> {
    let image = of.image();
    let level = checked_level(SECTION, image.target(), level)?;
    let property = PROPERTY.decode("pname", pname)?;
    let known = known(context, (of, face), level);
    let is_bound = matches!(image, ImageTarget::Bound(_));
    let is_compressed = known.as_ref().is_some_and(|known| known.format.block().is_some());
    if property == Property::CompressedBytes && !(is_bound && is_compressed) {
        return invalid_operation(SECTION, "there is no image that is compressed");
    }
    let Some(known) = known else {
        // GL 2.1, table 6.17, and ARB_texture_multisample: the initial value; of a proxy, that the
        // image does not fit.
        let is_one = matches!(property, Property::InternalFormat | Property::FixedLocations);
        return Ok(i32::from(is_one && is_bound));
    };
    let [width, height, depth] = known.given.map(|side| side as GLint);
    Ok(match property {
        Property::InternalFormat => formats::reported(known.internal) as GLint,
        Property::Width => width,
        Property::Height => height,
        Property::DepthOfVolume => depth,
        Property::Border => known.border as GLint,
        Property::Compressed => i32::from(is_compressed),
        Property::Bits(component) => known.bits(component),
        Property::CompressedBytes => {
            let [width, height, depth] = known.given;
            let bytes = Level::required_bytes(known.format, width, height, depth);
            bytes.map_or(0, |bytes| bytes as GLint)
        }
        Property::SharedBits => match known.format.info().encoding {
            Encoding::SharedExponent => 5,
            Encoding::Unorm
            | Encoding::Srgb
            | Encoding::Snorm
            | Encoding::Float
            | Encoding::Uint
            | Encoding::Sint
            | Encoding::Block(_)
            | Encoding::SrgbBlock(_) => 0,
        },
        Property::Samples => known.samples.map_or(0, |samples| samples.count.into()),
        Property::FixedLocations => {
            known.samples.is_none_or(|samples| samples.fixed_locations).into()
        }
        Property::Buffer => known.buffer.0 as GLint,
        Property::BufferOffset => known.buffer.1.start as GLint,
        Property::BufferSize => known.buffer.1.len() as GLint,
        Property::Kind(component) if known.bits(component) == 0 => 0,
        Property::Kind(_) => kind(known.format) as GLint,
    })
}

/// A property of a level of a texture; of a cube map, of its first face (`ARB_direct_state_access`, section 8.11.3).
pub(crate) fn property_of_texture(
    context: &Context,
    texture: ChosenTexture,
    level: GLint,
    pname: GLenum,
) -> Result<GLint> {
    property_of(context, (&Destination::Texture(texture), 0), level, pname)
}

pub(crate) fn get_tex_level_parameteriv(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &[property(context, target, level, pname)?])
}

pub(crate) fn get_tex_level_parameterfv(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &[property(context, target, level, pname)? as GLfloat])
}
