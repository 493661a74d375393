//! Fragments, depths and queries.

use crate::{Use, draw, pixel};
use gl_api::*;

pub const USES: &[Use] = &[
    ("EXT_blend_minmax", |c| {
        c.enable(GL_BLEND);
        for (equation, wanted) in
            [(GL_MAX_EXT, [204, 204, 51, 255]), (GL_MIN_EXT, [102, 102, 0, 0])]
        {
            c.clear_color(0.4, 0.8, 0.0, 1.0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.blend_equation(equation);
            assert_eq!(draw(c, "vec4(0.8, 0.4, 0.2, 0.0)"), wanted);
        }
    }),
    ("EXT_clip_control", |c| {
        let half = "vec4(step(0.5, place.y))";
        draw(c, half);
        assert_eq!([pixel(c, 0, 0)[0], pixel(c, 0, 7)[0]], [0, 255]);
        c.clip_control(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
        draw(c, half);
        assert_eq!([pixel(c, 0, 0)[0], pixel(c, 0, 7)[0]], [255, 0]);
        let mut values = [0; 2];
        c.get_integerv(GL_CLIP_ORIGIN, &mut values[..1]);
        c.get_integerv(GL_CLIP_DEPTH_MODE, &mut values[1..]);
        assert_eq!(values.map(|value| value as GLenum), [GL_UPPER_LEFT, GL_ZERO_TO_ONE]);
    }),
    ("EXT_occlusion_query_boolean", |c| {
        let mut name = [0];
        c.gen_queries(1, &mut name);
        for target in [GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE] {
            for (side, wanted) in [(8, 1), (0, 0)] {
                c.enable(GL_SCISSOR_TEST);
                c.scissor(0, 0, side, side);
                c.begin_query(target, name[0]);
                draw(c, "vec4(1.0)");
                c.end_query(target);
                let mut passed = [9];
                c.get_query_objectuiv(name[0], GL_QUERY_RESULT, &mut passed);
                assert_eq!(passed, [wanted], "{target:#x}, {side}");
            }
            c.delete_queries(1, &name);
            c.gen_queries(1, &mut name);
        }
    }),
    // The draw has the depth 0.5, and is moved by 0.25 instead of 1,000,000 steps.
    ("EXT_polygon_offset_clamp", |c| {
        c.enable(GL_DEPTH_TEST);
        c.enable(GL_POLYGON_OFFSET_FILL);
        c.polygon_offset_clamp(0.0, 1e9, 0.25);
        for (depth, wanted) in [(0.7, 0), (0.8, 255)] {
            c.clear_depthf(depth);
            c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            assert_eq!(draw(c, "vec4(1.0)"), [wanted; 4], "{depth}");
        }
        let mut clamp = [0.0];
        c.get_floatv(GL_POLYGON_OFFSET_CLAMP_EXT, &mut clamp);
        assert_eq!(clamp, [0.25]);
    }),
    ("OES_element_index_uint", |c| {
        draw(c, "vec4(0.2)");
        c.clear(GL_COLOR_BUFFER_BIT);
        let indices: &[u32] = &[0, 1, 2];
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, indices.arg());
        assert_eq!(pixel(c, 0, 0), [51; 4]);
    }),
];
