//! Conditional rendering: `NV_conditional_render`.

use super::{ALL, context, draw, fine, pixel};
use gl_api::*;

/// Query 1 has counted samples if `visible`.
fn counted(c: &mut Context, visible: bool) {
    c.gen_queries(1, &mut [0]);
    c.color_mask(false, false, false, false);
    c.begin_query(GL_SAMPLES_PASSED, 1);
    if visible {
        draw(c, GL_QUADS, &ALL);
    }
    c.end_query(GL_SAMPLES_PASSED);
    c.color_mask(true, true, true, true);
}

#[test]
fn draws_and_clears_depend_on_the_query_in_every_mode() {
    for mode in
        [GL_QUERY_WAIT, GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_WAIT, GL_QUERY_BY_REGION_NO_WAIT]
    {
        for visible in [false, true] {
            let mut c = context(4, 4);
            counted(&mut c, visible);
            c.begin_conditional_render(1, mode);
            draw(&mut c, GL_QUADS, &ALL);
            c.end_conditional_render();
            let drawn = if visible { [255; 4] } else { [0; 4] };
            assert_eq!(pixel(&mut c, 1, 1), drawn);
            c.begin_conditional_render(1, mode);
            c.clear_color(0.0, 1.0, 0.0, 1.0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.end_conditional_render();
            let cleared = if visible { [0, 255, 0, 255] } else { [0; 4] };
            assert_eq!(pixel(&mut c, 1, 1), cleared);
            // Afterwards everything is drawn again.
            draw(&mut c, GL_QUADS, &ALL);
            assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
            fine(&mut c);
        }
    }
}
