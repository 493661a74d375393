//! What the calls for blending of single draw buffers refuse: `ARB_draw_buffers_blend`.

use super::Case;
use gl_api::*;

const CASES: &[Case] = &[
    (|c| c.blend_funci(8, GL_ONE, GL_ONE), GL_INVALID_VALUE, "buf = 8 must be 0 to 7"),
    (|c| c.blend_funci(7, GL_ONE, GL_MIN), GL_INVALID_ENUM, "destination factor = GL_MIN"),
    (|c| c.blend_func_separatei(8, GL_ONE, GL_ONE, GL_ONE, GL_ONE), GL_INVALID_VALUE, "buf = 8"),
    (
        |c| c.blend_func_separatei(1, GL_ONE, GL_ONE, GL_MIN, GL_ONE),
        GL_INVALID_ENUM,
        "source alpha factor = GL_MIN",
    ),
    (|c| c.blend_equationi(9, GL_MIN), GL_INVALID_VALUE, "buf = 9"),
    (|c| c.blend_equationi(0, GL_SRC_COLOR), GL_INVALID_ENUM, "mode = GL_SRC_COLOR"),
    (|c| c.blend_equation_separatei(8, GL_MIN, GL_MIN), GL_INVALID_VALUE, "buf = 8"),
    (|c| c.blend_equation_separatei(0, GL_MIN, GL_LEFT), GL_INVALID_ENUM, "alpha mode = GL_LEFT"),
    (|c| c.get_integeri_v(GL_BLEND_SRC_RGB, 8, &mut [0]), GL_INVALID_VALUE, "index = 8"),
];

/// Runs the rows.
pub fn run() {
    let rows = CASES.iter().map(|(call, flag, words)| (call, *flag, *words));
    super::table("blends", super::context, rows);
}
