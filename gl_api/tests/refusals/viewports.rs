//! What the calls of ARB_viewport_array refuse.

use super::Case;
use gl_api::*;

const VALUE: GLenum = GL_INVALID_VALUE;
const ENUM: GLenum = GL_INVALID_ENUM;

const CASES: &[Case] = &[
    (|c| c.viewport_arrayv(16, 1, &[0.0; 4]), VALUE, "GL_MAX_VIEWPORTS, 16"),
    (|c| c.viewport_arrayv(1, 16, &[0.0; 64]), VALUE, "first = 1 and count = 16"),
    (|c| c.viewport_arrayv(u32::MAX, 1, &[0.0; 4]), VALUE, "GL_MAX_VIEWPORTS"),
    (|c| c.viewport_arrayv(0, -1, &[]), VALUE, "count = -1 must not be negative"),
    // None is set if one is wrong.
    (
        |c| c.viewport_arrayv(0, 2, &[1.0, 1.0, 1.0, 1.0, 0.0, 0.0, -1.0, 0.0]),
        VALUE,
        "width = -1 must not be negative",
    ),
    (|c| c.viewport_arrayv(0, 2, &[0.0; 7]), VALUE, "v has 7 values, of 8"),
    (|c| c.viewport_indexedf(16, 0.0, 0.0, 1.0, 1.0), VALUE, "index = 16 must be below"),
    (|c| c.viewport_indexedf(0, 0.0, 0.0, 1.0, -0.5), VALUE, "height = -0.5"),
    (|c| c.viewport_indexedfv(16, &[0.0; 4]), VALUE, "index = 16"),
    (|c| c.viewport_indexedfv(3, &[0.0, 0.0, -1.0, 0.0]), VALUE, "width = -1"),
    (|c| c.scissor_arrayv(15, 2, &[0; 8]), VALUE, "first = 15 and count = 2"),
    (|c| c.scissor_arrayv(0, -3, &[]), VALUE, "count = -3"),
    (|c| c.scissor_arrayv(0, 2, &[1, 1, 1, 1, 0, 0, 0, -1]), VALUE, "height = -1"),
    (|c| c.scissor_indexed(16, 0, 0, 1, 1), VALUE, "index = 16"),
    (|c| c.scissor_indexed(2, 0, 0, -1, 1), VALUE, "width = -1"),
    (|c| c.scissor_indexedv(16, &[0; 4]), VALUE, "index = 16"),
    (|c| c.scissor_indexedv(1, &[0, 0, 0, -7]), VALUE, "height = -7"),
    (|c| c.depth_range_arrayv(16, 1, &[0.0; 2]), VALUE, "GL_MAX_VIEWPORTS"),
    (|c| c.depth_range_arrayv(0, -1, &[]), VALUE, "count = -1"),
    (|c| c.depth_range_indexed(16, 0.0, 1.0), VALUE, "index = 16"),
    (|c| c.get_floati_v(GL_VIEWPORT, 16, &mut [0.0; 4]), VALUE, "index = 16"),
    (|c| c.get_floati_v(GL_DEPTH_TEST, 0, &mut [0.0; 4]), ENUM, "GL_DEPTH_TEST"),
    (|c| c.get_doublei_v(GL_DEPTH_RANGE, 16, &mut [0.0; 2]), VALUE, "index = 16"),
    (|c| c.get_doublei_v(GL_MATRIX_MODE, 0, &mut [0.0; 2]), ENUM, "GL_MATRIX_MODE"),
    (|c| c.enablei(GL_SCISSOR_TEST, 16), VALUE, "index = 16"),
    (|c| c.disablei(GL_SCISSOR_TEST, 16), VALUE, "index = 16"),
    (|c| assert!(!c.is_enabledi(GL_SCISSOR_TEST, 16)), VALUE, "index = 16"),
];

/// Runs the rows.
pub fn run() {
    let rows = CASES.iter().map(|(call, flag, words)| (call, *flag, *words));
    super::table("viewports", super::context, rows);
}
