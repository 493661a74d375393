//! What the calls for stencil, logical operations, masks and clears of single buffers refuse.

use super::Case;
use gl_api::*;

const CASES: &[Case] = &[
    (|c| c.stencil_func(GL_ZERO, 0, 0), GL_INVALID_ENUM, "func = "),
    (|c| c.stencil_func_separate(GL_LEFT, GL_LESS, 0, 0), GL_INVALID_ENUM, "face = GL_LEFT"),
    (|c| c.stencil_func_separate(GL_BACK, GL_KEEP, 0, 0), GL_INVALID_ENUM, "func = GL_KEEP"),
    (
        |c| c.stencil_func_separate_ati(GL_KEEP, GL_LESS, 0, 0),
        GL_INVALID_ENUM,
        "frontfunc = GL_KEEP",
    ),
    (
        |c| c.stencil_func_separate_ati(GL_LESS, GL_KEEP, 0, 0),
        GL_INVALID_ENUM,
        "backfunc = GL_KEEP",
    ),
    (|c| c.stencil_op(GL_LESS, GL_KEEP, GL_KEEP), GL_INVALID_ENUM, "sfail = GL_LESS"),
    (|c| c.stencil_op(GL_KEEP, GL_LESS, GL_KEEP), GL_INVALID_ENUM, "dpfail = GL_LESS"),
    (|c| c.stencil_op(GL_KEEP, GL_KEEP, GL_LESS), GL_INVALID_ENUM, "dppass = GL_LESS"),
    (
        |c| c.stencil_op_separate(GL_AUX0, GL_KEEP, GL_KEEP, GL_KEEP),
        GL_INVALID_ENUM,
        "face = GL_AUX0",
    ),
    (|c| c.stencil_mask_separate(GL_RIGHT, 0), GL_INVALID_ENUM, "face = GL_RIGHT"),
    (|c| c.active_stencil_face_ext(GL_FRONT_AND_BACK), GL_INVALID_ENUM, "GL_FRONT or GL_BACK"),
    (|c| c.logic_op(GL_KEEP), GL_INVALID_ENUM, "opcode = GL_KEEP"),
    (|c| c.color_maski(8, true, true, true, true), GL_INVALID_VALUE, "buf = 8 must be 0 to 7"),
    (|c| c.enablei(GL_DEPTH_TEST, 0), GL_INVALID_ENUM, "must be GL_BLEND"),
    (|c| c.disablei(GL_BLEND, 8), GL_INVALID_VALUE, "index = 8"),
    (|c| assert!(!c.is_enabledi(GL_BLEND, 99)), GL_INVALID_VALUE, "index = 99"),
    (|c| c.get_booleani_v(GL_BLEND, 8, &mut [0]), GL_INVALID_VALUE, "index = 8"),
    (|c| c.get_booleani_v(GL_LINEAR, 0, &mut [0]), GL_INVALID_ENUM, "GL_COLOR_WRITEMASK"),
    (|c| c.get_integeri_v(GL_COLOR_WRITEMASK, 0, &mut [0]), GL_INVALID_OPERATION, "4 values"),
    (|c| c.clear_bufferiv(GL_DEPTH, 0, &[0]), GL_INVALID_ENUM, "GL_COLOR or GL_STENCIL"),
    (|c| c.clear_bufferiv(GL_STENCIL, 1, &[0]), GL_INVALID_VALUE, "drawbuffer = 1 must be 0"),
    (|c| c.clear_bufferiv(GL_COLOR, 0, &[0; 3]), GL_INVALID_OPERATION, "3 numbers of 4"),
    (|c| c.clear_bufferuiv(GL_STENCIL, 0, &[0; 4]), GL_INVALID_ENUM, "must be GL_COLOR"),
    (|c| c.clear_bufferuiv(GL_COLOR, -1, &[0; 4]), GL_INVALID_VALUE, "drawbuffer = -1"),
    (|c| c.clear_bufferfv(GL_STENCIL, 0, &[0.0]), GL_INVALID_ENUM, "GL_COLOR or GL_DEPTH"),
    (|c| c.clear_bufferfv(GL_COLOR, 8, &[0.0; 4]), GL_INVALID_VALUE, "must be 0 to 7"),
    (|c| c.clear_bufferfi(GL_DEPTH, 0, 0.0, 0), GL_INVALID_ENUM, "GL_DEPTH_STENCIL"),
    (|c| c.clear_bufferfi(GL_DEPTH_STENCIL, 2, 0.0, 0), GL_INVALID_VALUE, "drawbuffer = 2"),
];

/// Runs the rows.
pub fn run() {
    let rows = CASES.iter().map(|(call, flag, words)| (call, *flag, *words));
    super::table("fragments", super::context, rows);
}
