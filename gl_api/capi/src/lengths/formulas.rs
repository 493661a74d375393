//! Lengths that follow from the arguments and the state of the context.

use gl_api::constants::*;
use gl_api::host::limits::MAX_EVAL_ORDER;
use gl_api::{GLenum, host, with_current};

/// How many values the state or parameter `pname` has. GL never gives two meanings of one name
/// different lengths. A missing row makes the call an error, as its slice is then too short.
pub(crate) fn values(pname: GLenum) -> usize {
    match pname {
        GL_MODELVIEW_MATRIX
        | GL_PROJECTION_MATRIX
        | GL_TEXTURE_MATRIX
        | GL_COLOR_MATRIX
        | GL_TRANSPOSE_MODELVIEW_MATRIX
        | GL_TRANSPOSE_PROJECTION_MATRIX
        | GL_TRANSPOSE_TEXTURE_MATRIX
        | GL_TRANSPOSE_COLOR_MATRIX
        | GL_CURRENT_MATRIX_ARB
        | GL_TRANSPOSE_CURRENT_MATRIX_ARB => 16,
        GL_VIEWPORT
        | GL_SCISSOR_BOX
        | GL_COLOR_WRITEMASK
        | GL_RGBA_SIGNED_COMPONENTS_EXT
        | GL_BLEND_COLOR
        | GL_COLOR_CLEAR_VALUE
        | GL_ACCUM_CLEAR_VALUE
        | GL_CURRENT_COLOR
        | GL_CURRENT_SECONDARY_COLOR
        | GL_CURRENT_TEXTURE_COORDS
        | GL_CURRENT_VERTEX_ATTRIB
        | GL_CURRENT_RASTER_COLOR
        | GL_CURRENT_RASTER_SECONDARY_COLOR
        | GL_CURRENT_RASTER_POSITION
        | GL_CURRENT_RASTER_TEXTURE_COORDS
        | GL_FOG_COLOR
        | GL_LIGHT_MODEL_AMBIENT
        | GL_AMBIENT
        | GL_DIFFUSE
        | GL_SPECULAR
        | GL_EMISSION
        | GL_AMBIENT_AND_DIFFUSE
        | GL_POSITION
        | GL_TEXTURE_BORDER_COLOR
        | GL_TEXTURE_SWIZZLE_RGBA
        | GL_TEXTURE_ENV_COLOR
        | GL_OBJECT_PLANE
        | GL_EYE_PLANE
        | GL_MAP2_GRID_DOMAIN => 4,
        GL_SPOT_DIRECTION
        | GL_CURRENT_NORMAL
        | GL_COLOR_INDEXES
        | GL_POINT_DISTANCE_ATTENUATION => 3,
        GL_MAX_VIEWPORT_DIMS
        | GL_DEPTH_RANGE
        | GL_VIEWPORT_BOUNDS_RANGE
        | GL_POLYGON_MODE
        | GL_POINT_SIZE_RANGE
        | GL_ALIASED_POINT_SIZE_RANGE
        | GL_LINE_WIDTH_RANGE
        | GL_ALIASED_LINE_WIDTH_RANGE
        | GL_MAP1_GRID_DOMAIN
        | GL_MAP2_GRID_SEGMENTS => 2,
        GL_COMPRESSED_TEXTURE_FORMATS => {
            with_current(|context| host::compressed_formats(context)).unwrap_or(0)
        }
        GL_SHADER_BINARY_FORMATS => 0,
        _ => 1,
    }
}

/// `glGetUniform`: (program, location, params).
pub(super) fn uniform(arguments: &[isize]) -> usize {
    let (program, location) = (arguments[0] as u32, arguments[1] as i32);
    with_current(|context| host::uniform_values(context, program, location)).unwrap_or(0)
}

/// `glGetActiveUniformBlockiv`: (program, index, pname, params).
pub(super) fn block(arguments: &[isize]) -> usize {
    let [program, index, pname] = [0, 1, 2].map(|at| arguments[at] as u32);
    with_current(|context| host::block_values(context, program, index, pname)).unwrap_or(0)
}

/// `glGetAttachedShaders`: (program, maxCount, …). No more is written than shaders are attached.
pub(super) fn attached_shaders(arguments: &[isize]) -> usize {
    let (program, most) = (arguments[0] as u32, usize::try_from(arguments[1]).unwrap_or(0));
    with_current(|context| host::attached_shaders(context, program)).unwrap_or(0).min(most)
}

/// `glGetActiveUniformsiv`: (program, count, …). Of what is no program nothing is read.
pub(super) fn of_program(arguments: &[isize]) -> usize {
    let [program, count] = [arguments[0] as u32, arguments[1] as u32];
    match with_current(|context| context.is_program(program)) {
        Some(true) => i32::try_from(count).map_or(0, |count| count as usize),
        Some(false) | None => 0,
    }
}

/// `glClearBuffer`: (buffer, drawbuffer, value).
pub(super) fn buffer(arguments: &[isize]) -> usize {
    if arguments[0] as GLenum == GL_COLOR { 4 } else { 1 }
}

/// Components of a control point of an evaluator (GL 2.1, table 5.1).
fn map_components(target: GLenum) -> usize {
    match target {
        GL_MAP1_INDEX | GL_MAP1_TEXTURE_COORD_1 | GL_MAP2_INDEX | GL_MAP2_TEXTURE_COORD_1 => 1,
        GL_MAP1_TEXTURE_COORD_2 | GL_MAP2_TEXTURE_COORD_2 => 2,
        GL_MAP1_VERTEX_3
        | GL_MAP1_NORMAL
        | GL_MAP1_TEXTURE_COORD_3
        | GL_MAP2_VERTEX_3
        | GL_MAP2_NORMAL
        | GL_MAP2_TEXTURE_COORD_3 => 3,
        GL_MAP1_VERTEX_4
        | GL_MAP1_COLOR_4
        | GL_MAP1_TEXTURE_COORD_4
        | GL_MAP2_VERTEX_4
        | GL_MAP2_COLOR_4
        | GL_MAP2_TEXTURE_COORD_4 => 4,
        _ => 0,
    }
}

/// Numbers between the first and the last point; an order that the call refuses reads nothing.
fn steps(stride: isize, order: isize) -> usize {
    let (stride, order) = (usize::try_from(stride), usize::try_from(order));
    let order = order.ok().filter(|order| *order <= MAX_EVAL_ORDER);
    stride.unwrap_or(0).saturating_mul(order.unwrap_or(0).saturating_sub(1))
}

/// `glMap1`: (target, u1, u2, stride, order, points).
pub(super) fn map1(arguments: &[isize]) -> usize {
    steps(arguments[3], arguments[4]).saturating_add(map_components(arguments[0] as GLenum))
}

/// `glMap2`: (target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points).
pub(super) fn map2(arguments: &[isize]) -> usize {
    map1(arguments).saturating_add(steps(arguments[7], arguments[8]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the first point to the last, and the last itself; not round the end of what is counted,
    /// where memory has fewer addresses than these arguments numbers.
    #[test]
    fn maps_reach_to_their_last_point() {
        let (line, plane) = (GL_MAP1_VERTEX_3 as isize, GL_MAP2_VERTEX_4 as isize);
        assert_eq!(map1(&[line, 0, 1, 5, 4]), 3 * 5 + 3);
        assert_eq!(map2(&[plane, 0, 1, 20, 3, 0, 1, 5, 4]), 2 * 20 + 3 * 5 + 4);
        assert_eq!(map1(&[line, 0, 1, isize::MAX, 30]), usize::MAX);
        assert_eq!(map2(&[plane, 0, 1, isize::MAX, 30, 0, 1, isize::MAX, 30]), usize::MAX);
    }
}
