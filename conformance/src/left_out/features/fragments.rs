//! State of fragments and of the framebuffer.

use crate::gl::*;
use crate::left_out::feature::{Feature, Reason};
use crate::left_out::scene::*;
use gl_api::constants::*;

/// Colours whose alpha is a uniform that is 1.
fn opaque_uniform() {
    program("    gl_FragColor = vec4(texel.rgb * color.rgb, one);");
}

pub(super) const LIST: &[Feature] = &[
    Feature::state(
        "blend-replace",
        "blending with GL_ONE, GL_ZERO",
        gouraud,
        || {
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ZERO);
        },
        draw_quad,
    ),
    Feature::state(
        "blend-opaque",
        "blending \"over\" of a texture without alpha",
        textured_opaque,
        || {
            textured_opaque();
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        },
        draw_quad,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "blend-opaque-uniform",
        "blending \"over\" of colours whose alpha is a uniform that is 1",
        opaque_uniform,
        || {
            opaque_uniform();
            glEnable(GL_BLEND);
            glBlendFuncSeparate(
                GL_SRC_ALPHA,
                GL_ONE_MINUS_SRC_ALPHA,
                GL_ONE,
                GL_ONE_MINUS_SRC_ALPHA,
            );
        },
        draw_quad,
    ),
    Feature::state(
        "blend-opaque-material",
        "blending \"over\" of materials whose alpha is 1",
        lit,
        || {
            lit();
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        },
        draw_mesh,
    ),
    Feature::state(
        "blend-factors",
        "blend factors while blending is off",
        gouraud,
        || {
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            glBlendColor(0.5, 0.5, 0.5, 0.5);
        },
        draw_quad,
    ),
    Feature::state(
        "alpha-always",
        "an alpha test with GL_ALWAYS",
        textured,
        || {
            textured();
            glEnable(GL_ALPHA_TEST);
        },
        draw_quad,
    ),
    Feature::state(
        "alpha-from-zero",
        "an alpha test with GL_GEQUAL, 0",
        textured,
        || {
            textured();
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GEQUAL, 0.0);
        },
        draw_quad,
    ),
    Feature::state(
        "alpha-opaque",
        "an alpha test with GL_GREATER, 0.5 of a texture without alpha",
        textured_opaque,
        || {
            textured_opaque();
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GREATER, 0.5);
        },
        draw_quad,
    ),
    Feature::state(
        "alpha-opaque-depth",
        "an alpha test of a texture without alpha, with a depth test",
        || {
            textured_opaque();
            gouraud_with_depth();
        },
        || {
            textured_opaque();
            gouraud_with_depth();
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GREATER, 0.5);
        },
        draw_quad,
    ),
    Feature::state(
        "alpha-material",
        "an alpha test of materials whose alpha is 1",
        lit,
        || {
            lit();
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GREATER, 0.1);
        },
        draw_mesh,
    ),
    Feature::state(
        "alpha-reference",
        "a reference of an alpha test that is off",
        textured,
        || {
            textured();
            glAlphaFunc(GL_LESS, 0.5);
        },
        draw_quad,
    ),
    Feature::state(
        "logic-copy",
        "a logical operation with GL_COPY",
        gouraud,
        || glEnable(GL_COLOR_LOGIC_OP),
        draw_quad,
    ),
    Feature::state(
        "fog-density-zero",
        "exponential fog of density 0",
        textured,
        || {
            textured();
            glEnable(GL_FOG);
            glFogf(GL_FOG_DENSITY, 0.0);
        },
        draw_quad,
    ),
    Feature::state(
        "fog-beyond",
        "linear fog that begins behind all geometry",
        textured,
        || {
            textured();
            glEnable(GL_FOG);
            glFogi(GL_FOG_MODE, GL_LINEAR as i32);
            glFogf(GL_FOG_START, 10.0);
            glFogf(GL_FOG_END, 20.0);
        },
        draw_quad,
    ),
    Feature::state(
        "color-sum",
        "the sum with a secondary colour that is black",
        textured,
        || {
            textured();
            glEnable(GL_COLOR_SUM);
        },
        draw_quad,
    ),
    Feature::state(
        "stencil-keep",
        "a stencil test that always passes and keeps",
        gouraud,
        || glEnable(GL_STENCIL_TEST),
        draw_quad,
    ),
    Feature::state(
        "stencil-replace",
        "a stencil test that writes what nothing reads",
        gouraud,
        || {
            glEnable(GL_STENCIL_TEST);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        },
        draw_quad,
    )
    .because(Reason::Visible),
    Feature::state(
        "stencil-masked",
        "a stencil test that writes with a mask of 0",
        gouraud,
        || {
            glEnable(GL_STENCIL_TEST);
            glStencilMask(0);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        },
        draw_quad,
    ),
    Feature::state(
        "depth-written",
        "depths that nothing reads",
        gouraud,
        || {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
        },
        draw_quad,
    )
    .because(Reason::Visible),
    Feature::state(
        "depth-always",
        "a depth test that always passes and does not write",
        gouraud,
        || {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            glDepthMask(GL_FALSE);
        },
        draw_quad,
    ),
    Feature::state(
        "scissor-whole",
        "a scissor rectangle of the whole picture",
        textured,
        || {
            textured();
            glEnable(GL_SCISSOR_TEST);
            glScissor(0, 0, SIDE, SIDE);
        },
        draw_quad,
    ),
    Feature::state("dither", "dithering", || glDisable(GL_DITHER), gouraud, draw_quad),
    Feature::state(
        "mask-all",
        "a colour mask that is all on, and an index mask",
        gouraud,
        || {
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            glIndexMask(0);
        },
        draw_quad,
    ),
    Feature::state(
        "srgb-linear",
        "sRGB encoding of a framebuffer that is linear",
        gouraud,
        || glEnable(GL_FRAMEBUFFER_SRGB),
        draw_quad,
    ),
    Feature::state(
        "sample-coverage",
        "multisample state of a framebuffer with one sample",
        gouraud,
        || {
            glEnable(GL_SAMPLE_COVERAGE);
            glSampleCoverage(0.5, GL_FALSE);
            glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        },
        draw_quad,
    ),
    Feature::calls(
        "hidden-behind",
        "a quad behind the last",
        textured,
        draw_quad,
        draw_over_hidden,
    )
    .because(Reason::NotLeftOut),
    Feature::calls(
        "hidden-front-to-back",
        "a quad that the depth test rejects whole",
        || {
            textured();
            gouraud_with_depth();
        },
        draw_quad,
        draw_front_to_back,
    )
    .because(Reason::DecidedPerBlock),
    Feature::calls("cleared-twice", "a second clear", gouraud, draw_quad, draw_cleared_twice),
    Feature::calls(
        "masked-draw",
        "a draw whose colour mask is off",
        gouraud,
        draw_quad,
        draw_after_masked,
    ),
];
