//! The table of state that `glGet` reads: GL 2.1, tables 6.5 to 6.37.

use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum};
use crate::base::limits;
use crate::base::query_value::{QueryValue, flag, float, floats, int, symbol, unit};
use crate::base::types::*;
use crate::calls::evaluate::grid;
use crate::calls::framebuffer::buffers::drawn_format;
use crate::calls::index;
use crate::context::Context;
use crate::context::log::{MAX_GROUPS, MAX_LABEL, MAX_LENGTH, MAX_LOGGED};
use crate::glsl::{GATHER_OFFSETS, TEXEL_OFFSETS};
use crate::interface::*;
use crate::objects::queries;
use crate::objects::target::TextureTarget;
use crate::pixel::component_bits::{Component, component_bits};
use crate::pixel::formats::general_purpose_formats;
use crate::pixel::map::MAX_PIXEL_MAP_TABLE;
use crate::pixel::store::PixelStore;
use crate::pixel::transfer;
use crate::query::arrays;
use crate::record::lists::{MAX_LIST_NESTING, MODE};
use crate::record::render_mode as modes;
use crate::state::attrib::MAX_ATTRIB_STACK_DEPTH;
use crate::state::draw_buffers::LOGIC_OP;
use crate::state::enable::is_capability;
use crate::state::material::{FACES, TRACKED};
use crate::state::matrix::{MATRIX_MODE, MAX_MODELVIEW_STACK_DEPTH, MAX_STACK_DEPTH};
use crate::state::multisample::MAX_SAMPLE_MASK_WORDS;
use crate::state::points::ORIGIN;
use crate::state::polygon::POLYGON_MODE;
use crate::state::raster::{FACE, FRONT_FACE, HINTS, PROVOKING, SHADE_MODEL};
use crate::state::stencil::{ACTIVE_FACE, Face, STENCIL_OP, Side};
use crate::state::texture_units::Unit;
use crate::state::uniform_buffers as uniform_buffer;
use glam::DMat4;
use rasterizer::driver::{DepthWrite, MAX_LINE_WIDTH, MAX_POINT_SIZE};

fn ints(values: &[i32]) -> Result<QueryValue> {
    Ok(QueryValue::Ints(values.to_vec()))
}

pub(crate) fn matrix(matrix: DMat4) -> Result<QueryValue> {
    Ok(QueryValue::Floats(matrix.to_cols_array().to_vec()))
}

pub(crate) fn pixel_store(
    store: &PixelStore,
    [swap, lsb, length, rows, pixels, height, images, _]: [GLenum; 8],
    pname: GLenum,
) -> Result<QueryValue> {
    match pname {
        _ if pname == swap => flag(store.swap_bytes),
        _ if pname == lsb => flag(store.lsb_first),
        _ if pname == length => int(store.row_length),
        _ if pname == rows => int(store.skip_rows),
        _ if pname == pixels => int(store.skip_pixels),
        _ if pname == height => int(store.image_height),
        _ if pname == images => int(store.skip_images),
        _ => int(store.alignment),
    }
}

/// State by its name.
///
/// # Errors
/// `GL_INVALID_ENUM` where there is none of that name.
pub(crate) fn state_value(context: &Context, pname: GLenum) -> Result<QueryValue> {
    if is_capability(pname) {
        return flag(crate::calls::enable::is_on(context, pname)?);
    }
    if let Some(place) = HINTS.get(pname) {
        return symbol(context.state.raster.hints[place]);
    }
    let chapters = [
        limit,
        transform,
        crate::calls::lighting::light::state_value,
        material,
        crate::calls::fragment::clamp::state_value,
        crate::calls::lighting::fog::state_value,
        current,
        raster,
        fragment,
        stencil,
        raster_position,
        pixels,
        texture,
        framebuffer,
        bindings,
        crate::calls::program::assembly_query::state_value,
        lists,
        debug,
        arrays::state_value,
        index::state_value,
        crate::calls::framebuffer::accumulate::state_value,
        modes::state_value,
        grid::state_value,
    ];
    for chapter in chapters {
        if let Some(value) = chapter(context, pname) {
            return value;
        }
    }
    invalid_enum(
        "GL 2.1, section 6.1.1",
        format!("pname = {} names no state that DetGL has", enum_name(pname)),
    )
}

type Answer = Option<Result<QueryValue>>;

fn limit(_: &Context, pname: GLenum) -> Answer {
    let attachments = limits::MAX_COLOR_ATTACHMENTS as i32;
    let sizes = limits::MAX_VIEWPORT_DIMS as i32;
    Some(match pname {
        GL_MAX_TEXTURE_SIZE
        | GL_MAX_CUBE_MAP_TEXTURE_SIZE
        | GL_MAX_RECTANGLE_TEXTURE_SIZE
        | GL_MAX_RENDERBUFFER_SIZE => int(limits::MAX_TEXTURE_SIZE),
        GL_MAX_TEXTURE_BUFFER_SIZE => int(limits::MAX_TEXTURE_BUFFER_SIZE),
        GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT => int(limits::TEXTURE_BUFFER_OFFSET_ALIGNMENT as i32),
        GL_MAX_3D_TEXTURE_SIZE => int(limits::MAX_3D_TEXTURE_SIZE),
        GL_MAX_ARRAY_TEXTURE_LAYERS => int(limits::MAX_ARRAY_TEXTURE_LAYERS),
        GL_MAX_VIEWPORT_DIMS => ints(&[sizes; 2]),
        GL_MAX_TEXTURE_UNITS | GL_MAX_TEXTURE_COORDS => int(MAX_TEXTURE_UNITS),
        GL_MAX_TEXTURE_IMAGE_UNITS | GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS => {
            int(MAX_TEXTURE_IMAGE_UNITS)
        }
        GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS => int(MAX_COMBINED_TEXTURE_IMAGE_UNITS),
        GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT => float(texunit::sampler::MAX_ANISOTROPY),
        GL_MAX_TEXTURE_LOD_BIAS => float(limits::MAX_TEXTURE_LOD_BIAS),
        GL_MAX_VERTEX_ATTRIBS => int(MAX_VERTEX_ATTRIBS),
        GL_MAX_VERTEX_UNIFORM_COMPONENTS | GL_MAX_FRAGMENT_UNIFORM_COMPONENTS => {
            int(limits::MAX_UNIFORM_COMPONENTS)
        }
        GL_MAX_VERTEX_UNIFORM_VECTORS | GL_MAX_FRAGMENT_UNIFORM_VECTORS => {
            int(limits::MAX_UNIFORM_COMPONENTS / 4)
        }
        GL_MAX_VARYING_FLOATS => int(limits::MAX_VARYING_FLOATS),
        GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS => {
            int(limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS)
        }
        GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS => {
            int(limits::MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS)
        }
        GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS => {
            int(limits::MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS)
        }
        GL_MAX_VARYING_VECTORS => int(limits::MAX_VARYING_FLOATS / 4),
        GL_SHADER_COMPILER => flag(true),
        GL_NUM_SHADER_BINARY_FORMATS => int(0),
        GL_SHADER_BINARY_FORMATS => ints(&[]),
        GL_MIN_PROGRAM_TEXEL_OFFSET => int(*TEXEL_OFFSETS.start()),
        GL_MAX_PROGRAM_TEXEL_OFFSET => int(*TEXEL_OFFSETS.end()),
        GL_MIN_PROGRAM_TEXTURE_GATHER_OFFSET_ARB => int(*GATHER_OFFSETS.start()),
        GL_MAX_PROGRAM_TEXTURE_GATHER_OFFSET_ARB => int(*GATHER_OFFSETS.end()),
        // A texture of so many components has a first one, which is what is gathered.
        GL_MAX_PROGRAM_TEXTURE_GATHER_COMPONENTS_ARB => int(4),
        GL_MAX_COLOR_ATTACHMENTS | GL_MAX_DRAW_BUFFERS => int(attachments),
        GL_MAX_MODELVIEW_STACK_DEPTH => int(MAX_MODELVIEW_STACK_DEPTH),
        GL_MAX_PROJECTION_STACK_DEPTH | GL_MAX_TEXTURE_STACK_DEPTH => int(MAX_STACK_DEPTH),
        GL_MAX_ELEMENTS_VERTICES | GL_MAX_ELEMENTS_INDICES => int(1 << 20),
        GL_SUBPIXEL_BITS => int(8),
        GL_MAX_LIGHTS => int(MAX_LIGHTS),
        GL_MAX_CLIP_PLANES => int(MAX_CLIP_PLANES),
        GL_POINT_SIZE_RANGE | GL_ALIASED_POINT_SIZE_RANGE => floats(&[1.0, MAX_POINT_SIZE]),
        GL_LINE_WIDTH_RANGE | GL_ALIASED_LINE_WIDTH_RANGE => floats(&[1.0, MAX_LINE_WIDTH]),
        GL_POINT_SIZE_GRANULARITY | GL_LINE_WIDTH_GRANULARITY => float(1.0 / 256.0),
        GL_NUM_COMPRESSED_TEXTURE_FORMATS => int(general_purpose_formats().len()),
        GL_COMPRESSED_TEXTURE_FORMATS => Ok(QueryValue::Ints(
            general_purpose_formats().iter().map(|&format| format as i32).collect(),
        )),
        GL_MAJOR_VERSION => int(limits::VERSION.0),
        GL_MINOR_VERSION => int(limits::VERSION.1),
        GL_NUM_EXTENSIONS => int(crate::query::extensions::EXTENSIONS.len()),
        GL_STEREO => flag(false),
        GL_AUX_BUFFERS => int(0),
        GL_MAX_SAMPLES
        | GL_MAX_COLOR_TEXTURE_SAMPLES
        | GL_MAX_DEPTH_TEXTURE_SAMPLES
        | GL_MAX_INTEGER_SAMPLES => int(limits::MAX_SAMPLES),
        GL_MAX_SAMPLE_MASK_WORDS => int(MAX_SAMPLE_MASK_WORDS),
        GL_DOUBLEBUFFER => flag(false),
        GL_RGBA_MODE => flag(true),
        _ => return uniform_buffer::limit(pname).map(int),
    })
}

fn transform(context: &Context, pname: GLenum) -> Answer {
    let state = &context.state;
    let matrices = &state.matrices;
    let texture = || {
        let unit = state.units.active_coordinates("GL 2.1, section 2.11.2")?;
        Ok(&matrices.texture[unit])
    };
    Some(match pname {
        GL_MATRIX_MODE => symbol(MATRIX_MODE.encode(matrices.mode)),
        GL_MODELVIEW_MATRIX => matrix(matrices.modelview.top),
        GL_PROJECTION_MATRIX => matrix(matrices.projection.top),
        GL_TEXTURE_MATRIX => texture().and_then(|texture| matrix(texture.top)),
        GL_TRANSPOSE_MODELVIEW_MATRIX => matrix(matrices.modelview.top.transpose()),
        GL_TRANSPOSE_PROJECTION_MATRIX => matrix(matrices.projection.top.transpose()),
        GL_TRANSPOSE_TEXTURE_MATRIX => {
            texture().and_then(|texture| matrix(texture.top.transpose()))
        }
        GL_MODELVIEW_STACK_DEPTH => int(matrices.modelview.depth()),
        GL_PROJECTION_STACK_DEPTH => int(matrices.projection.depth()),
        GL_TEXTURE_STACK_DEPTH => texture().and_then(|texture| int(texture.depth())),
        GL_VIEWPORT => {
            let viewport = &state.viewport;
            ints(&[viewport.x, viewport.y, viewport.width, viewport.height])
        }
        GL_DEPTH_RANGE => Ok(QueryValue::Unit(state.viewport.depth.to_vec())),
        _ => return None,
    })
}

fn current(context: &Context, pname: GLenum) -> Answer {
    let state = &context.state;
    let at = |location: u8| &state.current[usize::from(location)];
    Some(match pname {
        GL_CURRENT_COLOR => unit(at(ATTRIB_COLOR)),
        GL_CURRENT_SECONDARY_COLOR => unit(at(ATTRIB_SECONDARY_COLOR)),
        GL_CURRENT_NORMAL => unit(&at(ATTRIB_NORMAL)[..3]),
        GL_EDGE_FLAG => flag(at(ATTRIB_EDGE_FLAG)[0] != 0.0),
        GL_CURRENT_FOG_COORD => float(at(ATTRIB_FOG_COORD)[0]),
        GL_CURRENT_TEXTURE_COORDS => {
            let unit = state.units.active_coordinates("GL 2.1, section 2.7");
            unit.and_then(|unit| floats(at(ATTRIB_TEX_COORD + unit as u8)))
        }
        GL_CURRENT_RASTER_TEXTURE_COORDS => {
            let unit = state.units.active_coordinates("GL 2.1, section 2.13");
            unit.and_then(|unit| floats(&state.raster_position.tex_coords[unit]))
        }
        _ => return None,
    })
}

pub(crate) fn material(context: &Context, pname: GLenum) -> Answer {
    let materials = &context.state.materials;
    Some(match pname {
        GL_COLOR_MATERIAL_FACE => symbol(FACES.encode(materials.faces)),
        GL_COLOR_MATERIAL_PARAMETER => symbol(TRACKED.encode(materials.tracked)),
        _ => return None,
    })
}

pub(crate) fn raster(context: &Context, pname: GLenum) -> Answer {
    let raster = &context.state.raster;
    Some(match pname {
        GL_CULL_FACE_MODE => symbol(FACE.encode(raster.cull)),
        GL_FRONT_FACE => symbol(FRONT_FACE.encode(raster.front_face)),
        GL_SHADE_MODEL => symbol(SHADE_MODEL.encode(raster.shade_model)),
        GL_PROVOKING_VERTEX => symbol(PROVOKING.encode(raster.provoking)),
        GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION => flag(true),
        GL_POLYGON_MODE => ints(&raster.polygons.mode.map(|mode| POLYGON_MODE.encode(mode) as i32)),
        GL_POLYGON_OFFSET_FACTOR => float(raster.polygons.offset_factor),
        GL_POLYGON_OFFSET_UNITS => float(raster.polygons.offset_units),
        GL_LINE_WIDTH => float(raster.line_width),
        GL_LINE_STIPPLE_REPEAT => int(raster.stipple_factor),
        GL_LINE_STIPPLE_PATTERN => int(raster.stipple_pattern),
        GL_SAMPLE_COVERAGE_VALUE => float(raster.multisample.value),
        GL_SAMPLE_COVERAGE_INVERT => flag(raster.multisample.invert),
        GL_POINT_SIZE => float(raster.points.size),
        GL_POINT_SIZE_MIN => float(raster.points.size_min),
        GL_POINT_SIZE_MAX => float(raster.points.size_max),
        GL_POINT_FADE_THRESHOLD_SIZE => float(raster.points.fade),
        GL_POINT_DISTANCE_ATTENUATION => floats(&raster.points.attenuation),
        GL_POINT_SPRITE_COORD_ORIGIN => symbol(ORIGIN.encode(raster.points.origin)),
        _ => return None,
    })
}

pub(crate) fn fragment(context: &Context, pname: GLenum) -> Answer {
    let fragment = &context.state.fragment;
    let clear = &context.state.clear;
    let clamp = crate::draw::color_clamp::of_fragments(context);
    Some(match pname {
        GL_SCISSOR_BOX => {
            let area = fragment.scissor;
            ints(&[area.x, area.y, area.width as i32, area.height as i32])
        }
        GL_ALPHA_TEST_FUNC => symbol(COMPARE.encode(fragment.alpha_func)),
        GL_ALPHA_TEST_REF => unit(&[clamp.component(fragment.alpha_ref)]),
        GL_DEPTH_FUNC => symbol(COMPARE.encode(fragment.depth_func)),
        GL_DEPTH_WRITEMASK => flag(fragment.depth_write == DepthWrite::On),
        GL_COLOR_WRITEMASK => Ok(QueryValue::Bools(fragment.buffers[0].mask.to_vec())),
        GL_LOGIC_OP_MODE => symbol(LOGIC_OP.encode(fragment.logic_op)),
        GL_BLEND_COLOR => unit(&clamp.color(fragment.blend_color)),
        GL_COLOR_CLEAR_VALUE => unit(&clamp.color(clear.color.floats())),
        GL_DEPTH_CLEAR_VALUE => Ok(QueryValue::Unit(vec![clear.depth])),
        GL_STENCIL_CLEAR_VALUE => int(clear.stencil),
        _ => symbol(fragment.buffers[0].formula.get(pname)?),
    })
}

fn raster_position(context: &Context, pname: GLenum) -> Answer {
    use crate::calls::pixels::position::state_value;
    use crate::state::raster_position::Answer;
    state_value(context, pname).map(|value| match value {
        Answer::Floats(values) => Ok(QueryValue::Floats(values)),
        Answer::Color(color) => unit(&color),
        Answer::Flag(value) => flag(value),
    })
}

pub(crate) fn stencil(context: &Context, pname: GLenum) -> Answer {
    let stencil = &context.state.fragment.stencil;
    let (front, back) = (stencil.active(), &stencil.faces[Side::Back as usize]);
    // Section 4.1.4: kept as given, and clamped to the buffer's bits where it counts and here.
    let reference = |face: &Face| {
        let format = drawn_format(context, Component::Stencil);
        let bits = format.map_or(0, |format| component_bits(format, Component::Stencil));
        int(face.reference.clamp(0, (1 << bits) - 1))
    };
    Some(match pname {
        GL_STENCIL_FUNC => symbol(COMPARE.encode(front.func)),
        GL_STENCIL_REF => reference(front),
        GL_STENCIL_VALUE_MASK => symbol(front.value_mask),
        GL_STENCIL_WRITEMASK => symbol(front.write_mask),
        GL_STENCIL_FAIL => symbol(STENCIL_OP.encode(front.fail)),
        GL_STENCIL_PASS_DEPTH_FAIL => symbol(STENCIL_OP.encode(front.depth_fail)),
        GL_STENCIL_PASS_DEPTH_PASS => symbol(STENCIL_OP.encode(front.pass)),
        GL_STENCIL_BACK_FUNC => symbol(COMPARE.encode(back.func)),
        GL_STENCIL_BACK_REF => reference(back),
        GL_STENCIL_BACK_VALUE_MASK => symbol(back.value_mask),
        GL_STENCIL_BACK_WRITEMASK => symbol(back.write_mask),
        GL_STENCIL_BACK_FAIL => symbol(STENCIL_OP.encode(back.fail)),
        GL_STENCIL_BACK_PASS_DEPTH_FAIL => symbol(STENCIL_OP.encode(back.depth_fail)),
        GL_STENCIL_BACK_PASS_DEPTH_PASS => symbol(STENCIL_OP.encode(back.pass)),
        GL_ACTIVE_STENCIL_FACE_EXT => symbol(ACTIVE_FACE.encode(stencil.active)),
        _ => return None,
    })
}

fn pixels(context: &Context, pname: GLenum) -> Answer {
    let unpack = [
        GL_UNPACK_SWAP_BYTES,
        GL_UNPACK_LSB_FIRST,
        GL_UNPACK_ROW_LENGTH,
        GL_UNPACK_SKIP_ROWS,
        GL_UNPACK_SKIP_PIXELS,
        GL_UNPACK_IMAGE_HEIGHT,
        GL_UNPACK_SKIP_IMAGES,
        GL_UNPACK_ALIGNMENT,
    ];
    let pack = [
        GL_PACK_SWAP_BYTES,
        GL_PACK_LSB_FIRST,
        GL_PACK_ROW_LENGTH,
        GL_PACK_SKIP_ROWS,
        GL_PACK_SKIP_PIXELS,
        GL_PACK_IMAGE_HEIGHT,
        GL_PACK_SKIP_IMAGES,
        GL_PACK_ALIGNMENT,
    ];
    match pname {
        _ if unpack.contains(&pname) => Some(pixel_store(&context.state.unpack, unpack, pname)),
        _ if pack.contains(&pname) => Some(pixel_store(&context.state.pack, pack, pname)),
        GL_MAX_PIXEL_MAP_TABLE => Some(int(MAX_PIXEL_MAP_TABLE)),
        GL_MAP_COLOR => Some(flag(context.state.transfer.map_color)),
        GL_MAP_STENCIL => Some(flag(context.state.transfer.map_stencil)),
        GL_INDEX_SHIFT => Some(int(context.state.transfer.index_shift)),
        GL_INDEX_OFFSET => Some(int(context.state.transfer.index_offset)),
        _ => match transfer::PARAMETER.get(pname) {
            Some(which) => Some(float(context.state.transfer.get(which))),
            None => context.state.transfer.maps.size(pname).map(int),
        },
    }
}

/// The queries of what is bound to a target.
const BINDING: Table<TextureTarget> = Table {
    section: "GL 2.1, table 6.16",
    rows: &[
        (GL_TEXTURE_BINDING_1D, TextureTarget::D1),
        (GL_TEXTURE_BINDING_2D, TextureTarget::D2),
        (GL_TEXTURE_BINDING_3D, TextureTarget::D3),
        (GL_TEXTURE_BINDING_CUBE_MAP, TextureTarget::Cube),
        (GL_TEXTURE_BINDING_RECTANGLE, TextureTarget::Rect),
        (GL_TEXTURE_BINDING_1D_ARRAY, TextureTarget::D1Array),
        (GL_TEXTURE_BINDING_2D_ARRAY, TextureTarget::D2Array),
        (GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, TextureTarget::CubeArray),
        (GL_TEXTURE_BINDING_2D_MULTISAMPLE, TextureTarget::D2Multisample),
        (GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY, TextureTarget::D2MultisampleArray),
        (GL_TEXTURE_BINDING_BUFFER, TextureTarget::Buffer),
    ],
};

pub(crate) fn texture(context: &Context, pname: GLenum) -> Answer {
    let units = &context.state.units;
    let Unit { bound, .. } = units.active();
    Some(match pname {
        GL_ACTIVE_TEXTURE => symbol(GL_TEXTURE0 + u32::from(units.active)),
        GL_CLIENT_ACTIVE_TEXTURE => symbol(GL_TEXTURE0 + u32::from(units.client_active)),
        GL_SAMPLER_BINDING => symbol(units.active().sampler.name()),
        GL_TEXTURE_BUFFER_FORMAT_ARB => symbol(
            crate::calls::texture::bound::bound(context, TextureTarget::Buffer).store.internal,
        ),
        GL_TEXTURE_BUFFER_DATA_STORE_BINDING => symbol(
            crate::calls::texture::bound::bound(context, TextureTarget::Buffer).store.buffer.name(),
        ),
        _ => symbol(bound[BINDING.get(pname)? as usize].name()),
    })
}

pub(crate) fn framebuffer(context: &Context, pname: GLenum) -> Answer {
    crate::calls::framebuffer::buffers::state_value(context, pname).map(|value| match value {
        crate::objects::color_buffers::Answer::Symbol(value) => symbol(value),
        crate::objects::color_buffers::Answer::Number(value) => int(value),
        crate::objects::color_buffers::Answer::Flag(value) => flag(value),
    })
}

fn debug(context: &Context, pname: GLenum) -> Answer {
    let log = &context.debug.log;
    Some(match pname {
        GL_DEBUG_LOGGED_MESSAGES => int(log.len() as i32),
        GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH => {
            int(log.first().map_or(0, |first| first.text.len() as i32 + 1))
        }
        GL_DEBUG_GROUP_STACK_DEPTH => int(log.depth() as i32),
        GL_MAX_DEBUG_LOGGED_MESSAGES => int(MAX_LOGGED as i32),
        GL_MAX_DEBUG_MESSAGE_LENGTH => int(MAX_LENGTH as i32),
        GL_MAX_DEBUG_GROUP_STACK_DEPTH => int(MAX_GROUPS as i32),
        GL_MAX_LABEL_LENGTH => int(MAX_LABEL as i32),
        GL_CONTEXT_FLAGS => symbol(context.debug.context_flags()),
        GL_MAX_SERVER_WAIT_TIMEOUT => int(0),
        // Exact for a hundred days.
        GL_TIMESTAMP => Ok(QueryValue::Floats(vec![queries::timestamp() as f64])),
        _ => return None,
    })
}

fn lists(context: &Context, pname: GLenum) -> Answer {
    let compiling = context.compiling.as_ref();
    Some(match pname {
        GL_LIST_BASE => symbol(context.lists.base()),
        GL_LIST_INDEX => symbol(compiling.map_or(0, |list| list.name)),
        GL_LIST_MODE => symbol(compiling.map_or(0, |list| MODE.encode(list.mode))),
        GL_ATTRIB_STACK_DEPTH => int(context.attribs.depths()[0] as i32),
        GL_CLIENT_ATTRIB_STACK_DEPTH => int(context.attribs.depths()[1] as i32),
        GL_MAX_ATTRIB_STACK_DEPTH | GL_MAX_CLIENT_ATTRIB_STACK_DEPTH => {
            int(MAX_ATTRIB_STACK_DEPTH as i32)
        }
        GL_MAX_LIST_NESTING => int(MAX_LIST_NESTING as i32),
        _ => return None,
    })
}

fn bindings(context: &Context, pname: GLenum) -> Answer {
    let bindings = &context.state.bindings;
    Some(match pname {
        GL_ARRAY_ELEMENT_LOCK_FIRST_EXT => int(context.state.locked.first),
        GL_ARRAY_ELEMENT_LOCK_COUNT_EXT => int(context.state.locked.count),
        GL_ARRAY_BUFFER_BINDING => symbol(bindings.array_buffer.name()),
        GL_ELEMENT_ARRAY_BUFFER_BINDING => symbol(bindings.element_array_buffer.name()),
        GL_PIXEL_PACK_BUFFER_BINDING => symbol(bindings.pixel_pack_buffer.name()),
        GL_PIXEL_UNPACK_BUFFER_BINDING => symbol(bindings.pixel_unpack_buffer.name()),
        GL_COPY_READ_BUFFER => symbol(bindings.copy_read_buffer.name()),
        GL_COPY_WRITE_BUFFER => symbol(bindings.copy_write_buffer.name()),
        GL_TRANSFORM_FEEDBACK_BUFFER_BINDING => symbol(bindings.transform_feedback_buffer.name()),
        GL_UNIFORM_BUFFER_BINDING => symbol(bindings.uniform_buffer.name()),
        GL_TEXTURE_BUFFER => symbol(bindings.texture_buffer.name()),
        GL_VERTEX_ARRAY_BINDING => symbol(bindings.vertex_array),
        GL_FRAMEBUFFER_BINDING => symbol(bindings.draw_framebuffer),
        GL_READ_FRAMEBUFFER_BINDING => symbol(bindings.read_framebuffer),
        GL_RENDERBUFFER_BINDING => symbol(bindings.renderbuffer.name()),
        GL_CURRENT_PROGRAM => symbol(bindings.program.name()),
        _ => return None,
    })
}
