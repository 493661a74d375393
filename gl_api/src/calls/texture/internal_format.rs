//! `glGetInternalformativ`: the numbers of samples that images of a format can have (`ARB_internalformat_query`; OpenGL ES
//! 3.0, section 6.1.15), and in OpenGL all else that it can be used for with a target (`ARB_internalformat_query2`).

use crate::base::constants::*;
use crate::base::error::{Result, Table, not_a_choice, not_negative};
use crate::base::limits::MAX_SAMPLES;
use crate::base::types::*;
use crate::calls::texture::format_properties::{Resource, Supported};
use crate::context::Context;
use crate::objects::target::TextureTarget;
use crate::pixel::component_bits::Component;
use crate::pixel::formats::{FormatSet, InternalFormat, Renderable};

const SECTION: &str = "ARB_internalformat_query2, section 6.1.X";

const TARGET: Table<Resource> = Table {
    section: SECTION,
    rows: &[
        (GL_RENDERBUFFER, Resource::Renderbuffer),
        (GL_TEXTURE_1D, Resource::Texture(TextureTarget::D1)),
        (GL_TEXTURE_1D_ARRAY, Resource::Texture(TextureTarget::D1Array)),
        (GL_TEXTURE_2D, Resource::Texture(TextureTarget::D2)),
        (GL_TEXTURE_2D_ARRAY, Resource::Texture(TextureTarget::D2Array)),
        (GL_TEXTURE_3D, Resource::Texture(TextureTarget::D3)),
        (GL_TEXTURE_CUBE_MAP, Resource::Texture(TextureTarget::Cube)),
        (GL_TEXTURE_CUBE_MAP_ARRAY, Resource::Texture(TextureTarget::CubeArray)),
        (GL_TEXTURE_RECTANGLE, Resource::Texture(TextureTarget::Rect)),
        (GL_TEXTURE_BUFFER, Resource::Texture(TextureTarget::Buffer)),
        (GL_TEXTURE_2D_MULTISAMPLE, Resource::Texture(TextureTarget::D2Multisample)),
        (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, Resource::Texture(TextureTarget::D2MultisampleArray)),
    ],
};

/// What is asked for.
#[derive(Clone, Copy)]
enum Property {
    /// The numbers of samples themselves.
    Samples,
    /// A number; of what is not supported it is 0, which is also `GL_NONE` and `GL_FALSE`.
    Number(fn(&Supported) -> i64),
}

use Property::{Number, Samples};

const fn full(is_there: bool) -> i64 {
    (if is_there { GL_FULL_SUPPORT } else { GL_NONE }) as i64
}

/// Format or type of pixels.
fn pixels(of: Option<[GLenum; 2]>, which: usize) -> i64 {
    of.map_or(GL_NONE, |pixels| pixels[which]).into()
}

/// What this version has not: stages, images and views.
fn absent(_: &Supported) -> i64 {
    0
}

const PROPERTIES: &[(GLenum, Property)] = &[
    (GL_NUM_SAMPLE_COUNTS, Number(|of| of.samples().len() as i64)),
    (GL_SAMPLES, Samples),
    (GL_INTERNALFORMAT_SUPPORTED, Number(|_| GL_TRUE.into())),
    (GL_INTERNALFORMAT_PREFERRED, Number(|of| of.preferred().into())),
    (GL_INTERNALFORMAT_RED_SIZE, Number(|of| of.bits(Component::Red).into())),
    (GL_INTERNALFORMAT_GREEN_SIZE, Number(|of| of.bits(Component::Green).into())),
    (GL_INTERNALFORMAT_BLUE_SIZE, Number(|of| of.bits(Component::Blue).into())),
    (GL_INTERNALFORMAT_ALPHA_SIZE, Number(|of| of.bits(Component::Alpha).into())),
    (GL_INTERNALFORMAT_DEPTH_SIZE, Number(|of| of.bits(Component::Depth).into())),
    (GL_INTERNALFORMAT_STENCIL_SIZE, Number(|of| of.bits(Component::Stencil).into())),
    (GL_INTERNALFORMAT_SHARED_SIZE, Number(|of| of.shared_bits().into())),
    (GL_INTERNALFORMAT_RED_TYPE, Number(|of| of.kind(Component::Red).into())),
    (GL_INTERNALFORMAT_GREEN_TYPE, Number(|of| of.kind(Component::Green).into())),
    (GL_INTERNALFORMAT_BLUE_TYPE, Number(|of| of.kind(Component::Blue).into())),
    (GL_INTERNALFORMAT_ALPHA_TYPE, Number(|of| of.kind(Component::Alpha).into())),
    (GL_INTERNALFORMAT_DEPTH_TYPE, Number(|of| of.kind(Component::Depth).into())),
    (GL_INTERNALFORMAT_STENCIL_TYPE, Number(|of| of.kind(Component::Stencil).into())),
    (GL_MAX_WIDTH, Number(|of| of.largest()[0].into())),
    (GL_MAX_HEIGHT, Number(|of| of.largest()[1].into())),
    (GL_MAX_DEPTH, Number(|of| of.largest()[2].into())),
    (GL_MAX_LAYERS, Number(|of| of.layers().into())),
    (GL_MAX_COMBINED_DIMENSIONS, Number(Supported::combined)),
    (GL_COLOR_COMPONENTS, Number(|of| of.is_color().into())),
    (GL_DEPTH_COMPONENTS, Number(|of| of.has_depth().into())),
    (GL_STENCIL_COMPONENTS, Number(|of| of.has_stencil().into())),
    (GL_COLOR_RENDERABLE, Number(|of| of.is_rendered_as(Component::Red).into())),
    (GL_DEPTH_RENDERABLE, Number(|of| of.is_rendered_as(Component::Depth).into())),
    (GL_STENCIL_RENDERABLE, Number(|of| of.is_rendered_as(Component::Stencil).into())),
    (GL_FRAMEBUFFER_RENDERABLE, Number(|of| full(of.is_rendered()))),
    (GL_FRAMEBUFFER_RENDERABLE_LAYERED, Number(|of| full(of.is_rendered_layered()))),
    (GL_FRAMEBUFFER_BLEND, Number(|of| full(of.is_blended()))),
    (GL_READ_PIXELS, Number(|of| full(of.is_rendered()))),
    (GL_READ_PIXELS_FORMAT, Number(|of| pixels(of.read_pixels(), 0))),
    (GL_READ_PIXELS_TYPE, Number(|of| pixels(of.read_pixels(), 1))),
    (GL_TEXTURE_IMAGE_FORMAT, Number(|of| pixels(of.texel_pixels(), 0))),
    (GL_TEXTURE_IMAGE_TYPE, Number(|of| pixels(of.texel_pixels(), 1))),
    (GL_GET_TEXTURE_IMAGE_FORMAT, Number(|of| pixels(of.texel_pixels(), 0))),
    (GL_GET_TEXTURE_IMAGE_TYPE, Number(|of| pixels(of.texel_pixels(), 1))),
    (GL_MIPMAP, Number(|of| of.has_levels().into())),
    (GL_MANUAL_GENERATE_MIPMAP, Number(|of| full(of.has_made_levels()))),
    (GL_AUTO_GENERATE_MIPMAP, Number(|of| full(of.has_automatic_levels()))),
    (GL_COLOR_ENCODING, Number(|of| of.encoding().into())),
    (GL_SRGB_READ, Number(|of| full(of.is_srgb_read()))),
    (GL_SRGB_WRITE, Number(|of| full(of.is_srgb_written()))),
    (GL_SRGB_DECODE_ARB, Number(|of| full(of.is_srgb_read()))),
    (GL_FILTER, Number(|of| full(of.is_filtered()))),
    (GL_VERTEX_TEXTURE, Number(|of| full(of.is_sampled()))),
    (GL_GEOMETRY_TEXTURE, Number(|of| full(of.is_sampled()))),
    (GL_FRAGMENT_TEXTURE, Number(|of| full(of.is_sampled()))),
    (GL_TESS_CONTROL_TEXTURE, Number(absent)),
    (GL_TESS_EVALUATION_TEXTURE, Number(absent)),
    (GL_COMPUTE_TEXTURE, Number(absent)),
    (GL_TEXTURE_SHADOW, Number(|of| full(of.is_compared()))),
    (GL_TEXTURE_GATHER, Number(|of| full(of.is_gathered()))),
    // textureGather compares with ARB_gpu_shader5.
    (GL_TEXTURE_GATHER_SHADOW, Number(absent)),
    (GL_SHADER_IMAGE_LOAD, Number(absent)),
    (GL_SHADER_IMAGE_STORE, Number(absent)),
    (GL_SHADER_IMAGE_ATOMIC, Number(absent)),
    (GL_IMAGE_TEXEL_SIZE, Number(absent)),
    (GL_IMAGE_COMPATIBILITY_CLASS, Number(absent)),
    (GL_IMAGE_PIXEL_FORMAT, Number(absent)),
    (GL_IMAGE_PIXEL_TYPE, Number(absent)),
    (GL_IMAGE_FORMAT_COMPATIBILITY_TYPE, Number(absent)),
    (
        GL_SIMULTANEOUS_TEXTURE_AND_DEPTH_TEST,
        Number(|of| full(of.is_sampled_while_tested(Component::Depth))),
    ),
    (
        GL_SIMULTANEOUS_TEXTURE_AND_STENCIL_TEST,
        Number(|of| full(of.is_sampled_while_tested(Component::Stencil))),
    ),
    (GL_SIMULTANEOUS_TEXTURE_AND_DEPTH_WRITE, Number(absent)),
    (GL_SIMULTANEOUS_TEXTURE_AND_STENCIL_WRITE, Number(absent)),
    (GL_TEXTURE_COMPRESSED, Number(|of| of.is_compressed().into())),
    (GL_TEXTURE_COMPRESSED_BLOCK_WIDTH, Number(|of| of.block().map_or(0, |[side, _]| side.into()))),
    (
        GL_TEXTURE_COMPRESSED_BLOCK_HEIGHT,
        Number(|of| of.block().map_or(0, |[side, _]| side.into())),
    ),
    (
        GL_TEXTURE_COMPRESSED_BLOCK_SIZE,
        Number(|of| of.block().map_or(0, |[_, bytes]| bytes.into())),
    ),
    (GL_CLEAR_BUFFER, Number(|of| full(of.is_cleared()))),
    (GL_TEXTURE_VIEW, Number(|of| full(of.is_viewed()))),
    (GL_VIEW_COMPATIBILITY_CLASS, Number(|of| of.view_class().into())),
];

const TARGET_IN_ES: Table<()> = Table { section: SECTION, rows: &[(GL_RENDERBUFFER, ())] };

/// The unsized formats are drawn to as well, though no renderbuffer has them (OpenGL ES 3.0, section 4.4.4).
const DRAWN_TO_IN_ES: FormatSet = FormatSet::new("OpenGL ES 3.0, section 4.4.4", |format| {
    matches!(format.name, GL_RGB | GL_RGBA)
        || format.is_for_renderbuffers_in_es() && is_drawn_to(format)
});

fn is_drawn_to(format: &InternalFormat) -> bool {
    format.renderable != Renderable::No && !format.is_compressed()
}

fn property(pname: GLenum) -> Result<Property> {
    match PROPERTIES.iter().find(|row| row.0 == pname) {
        Some(row) => Ok(row.1),
        None => {
            let names: Vec<GLenum> = PROPERTIES.iter().map(|row| row.0).collect();
            Err(not_a_choice(SECTION, "pname", pname, &names))
        }
    }
}

/// The values that are asked for.
fn values(
    context: &Context,
    target: GLenum,
    internalformat: GLenum,
    pname: GLenum,
) -> Result<Vec<i64>> {
    if context.profile.is_es() {
        return values_in_es(target, internalformat, pname);
    }
    let resource = TARGET.decode("target", target)?;
    let property = property(pname)?;
    let supported = Supported::new(resource, internalformat, context.profile);
    Ok(match property {
        Samples => {
            let samples = supported.iter().flat_map(Supported::samples);
            samples.map(|&samples| samples.into()).collect()
        }
        Number(read) => vec![supported.as_ref().map_or(0, read)],
    })
}

/// The numbers of samples of renderbuffers.
fn values_in_es(target: GLenum, internalformat: GLenum, pname: GLenum) -> Result<Vec<i64>> {
    const ASKED: Table<GLenum> = Table {
        section: SECTION,
        rows: &[(GL_NUM_SAMPLE_COUNTS, GL_NUM_SAMPLE_COUNTS), (GL_SAMPLES, GL_SAMPLES)],
    };
    TARGET_IN_ES.decode("target", target)?;
    let format = DRAWN_TO_IN_ES.decode("internalformat", internalformat)?;
    let asked = ASKED.decode("pname", pname)?;
    // Integers have none in renderbuffers of OpenGL ES 3.0 (section 4.4.2.1).
    let samples = if format.stored.is_integer() { vec![] } else { vec![MAX_SAMPLES as i64] };
    Ok(if asked == GL_SAMPLES { samples } else { vec![samples.len() as i64] })
}

/// Writes as many values as there is room for; 32 bits hold the largest number for larger ones.
pub(crate) fn get_internalformativ(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    pname: GLenum,
    bufsize: GLsizei,
    params: &mut [GLint],
) -> Result<()> {
    let values = values(context, target, internalformat, pname)?;
    let room = not_negative(SECTION, "bufSize", bufsize.into())?;
    for (to, value) in params.iter_mut().take(room).zip(values) {
        *to = value.try_into().unwrap_or(GLint::MAX);
    }
    Ok(())
}

pub(crate) fn get_internalformati64v(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    pname: GLenum,
    bufsize: GLsizei,
    params: &mut [GLint64],
) -> Result<()> {
    let values = values(context, target, internalformat, pname)?;
    let room = not_negative(SECTION, "bufSize", bufsize.into())?;
    for (to, value) in params.iter_mut().take(room).zip(values) {
        *to = value;
    }
    Ok(())
}
