//! The plan of a draw (`DETGL_EXPLAIN`): what it leaves out because this draw does not need it.

use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc, Explain};
use std::sync::Arc;
use texunit::lanes::Isa;

/// The plans of what `draw` draws.
fn plans(draw: impl FnOnce()) -> Vec<String> {
    let explain = Explain::Keep;
    let desc = DeviceDesc { explain, ..DeviceDesc::new(Isa::best(), 1) };
    let device = Arc::new(Device::new(desc).expect("a thread starts"));
    let desc =
        ContextDesc { width: 16, height: 16, device: Some(device.clone()), ..Default::default() };
    let _current = Context::new(desc).expect("a small context").make_current();
    draw();
    glFinish();
    assert_eq!(glGetError(), GL_NO_ERROR);
    device.take_explanations()
}

fn triangle() {
    glBegin(GL_TRIANGLES);
    for (x, y) in [(-1, -1), (1, -1), (0, 1)] {
        glTexCoord2f(x, y);
        glVertex2f(x, y);
    }
    glEnd();
}

fn texture() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    let white = [255_u8; 4];
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    glEnable(GL_TEXTURE_2D);
}

#[test]
fn a_plain_draw_leaves_out_depth_blending_lod_and_the_other_units() {
    let plans = plans(|| {
        texture();
        triangle();
    });
    assert_eq!(plans.len(), 1, "{plans:?}");
    for part in [
        "depth        left out: no depth test",
        "left out: blending",
        "no LOD: both filters are alike",
        "kernel of uniform levels",
        "left out: texture units 1, 2, 3, 4, 5, 6, 7",
        "left out: the alpha test",
    ] {
        assert!(plans[0].contains(part), "`{part}` is not in\n{}", plans[0]);
    }
}

#[test]
fn a_draw_that_needs_them_has_them() {
    let plans = plans(|| {
        texture();
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glActiveTexture(GL_TEXTURE1);
        texture();
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glEnable(GL_ALPHA_TEST);
        glAlphaFunc(GL_GREATER, 0.5);
        triangle();
    });
    assert_eq!(plans.len(), 1, "{plans:?}");
    for part in [
        "late, Less, write On: the shader throws fragments away",
        "blended",
        "left out: texture units 2, 3, 4, 5, 6, 7",
        "texture 1",
    ] {
        assert!(plans[0].contains(part), "`{part}` is not in\n{}", plans[0]);
    }
    for part in ["left out: blending", "left out: the alpha test", "left out: no depth"] {
        assert!(!plans[0].contains(part), "`{part}` is in\n{}", plans[0]);
    }
}

#[test]
fn state_without_effect_changes_no_plan() {
    let plan_with = |state: fn()| {
        plans(|| {
            texture();
            state();
            triangle();
        })
    };
    let plain = plan_with(|| {});
    let without_effect: [(&str, fn()); 5] = [
        ("blending with GL_ONE, GL_ZERO", || glEnable(GL_BLEND)),
        ("the logical operation GL_COPY", || glEnable(GL_COLOR_LOGIC_OP)),
        ("GL_COPY, which switches blending off", || {
            glEnable(GL_COLOR_LOGIC_OP);
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        }),
        ("alpha >= 0", || {
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GEQUAL, 0.0);
        }),
        ("alpha <= 1", || {
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_LEQUAL, 1.0);
        }),
    ];
    for (name, state) in without_effect {
        assert_eq!(plan_with(state), plain, "{name}");
    }
    let with_effect: [(&str, fn()); 4] = [
        ("blending with GL_ONE, GL_ONE", || {
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
        }),
        ("the largest of both", || {
            glEnable(GL_BLEND);
            glBlendEquation(GL_MAX);
        }),
        ("alpha >= 0.01", || {
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GEQUAL, 0.01);
        }),
        ("alpha > 0", || {
            glEnable(GL_ALPHA_TEST);
            glAlphaFunc(GL_GREATER, 0.0);
        }),
    ];
    for (name, state) in with_effect {
        assert_ne!(plan_with(state), plain, "{name}");
    }
}

#[test]
fn alpha_that_is_1_everywhere_is_left_out_from_the_second_frame_on() {
    let plans = plans(|| {
        texture();
        for _ in 0..3 {
            triangle();
            glFinish();
        }
    });
    // The same plan is told once.
    let left_out: Vec<bool> = plans.iter().map(|plan| plan.contains("left out: alpha (")).collect();
    assert_eq!(left_out, [false, true], "{plans:?}");
}
