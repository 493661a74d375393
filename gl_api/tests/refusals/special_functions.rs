//! What the special functions (GL 2.1, chapter 5) refuse: lists, selection, feedback, evaluators; and pixel maps, stacks,
//! accumulation, conditional rendering, locked arrays.

use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const ENUM: GLenum = GL_INVALID_ENUM;

fn selecting(c: &mut Context) {
    c.select_buffer(16, DataOut::Null);
    assert_eq!(c.render_mode(GL_SELECT), 0);
}

fn feeding_back(c: &mut Context) {
    c.feedback_buffer(16, GL_2D, DataOut::Null);
    assert_eq!(c.render_mode(GL_FEEDBACK), 0);
}

/// Query 1 has counted no samples, query 2 time.
fn counted(c: &mut Context) {
    c.gen_queries(3, &mut [0; 3]);
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.end_query(GL_SAMPLES_PASSED);
    c.begin_query(GL_TIME_ELAPSED, 2);
    c.end_query(GL_TIME_ELAPSED);
}

const CASES: &[Case] = &[
    (nothing, |c| c.lock_arrays(-1, 3), GL_INVALID_VALUE, "first = -1"),
    (nothing, |c| c.lock_arrays(0, 0), GL_INVALID_VALUE, "count = 0"),
    (|c| c.lock_arrays(0, 3), |c| c.lock_arrays(0, 3), GL_INVALID_OPERATION, "locked already"),
    (nothing, |c| c.unlock_arrays(), GL_INVALID_OPERATION, "glLockArraysEXT first"),
    // Pixel maps.
    (nothing, |c| c.pixel_mapfv(GL_RGBA, 1, (&[0.0_f32]).arg()), ENUM, "map = GL_RGBA"),
    (nothing, |c| c.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 0, (&[0.0_f32]).arg()), VALUE, "mapsize = 0"),
    (
        nothing,
        |c| c.pixel_mapusv(GL_PIXEL_MAP_I_TO_R, 3, (&[0_u16; 3]).arg()),
        VALUE,
        "mapsize = 3",
    ),
    (
        nothing,
        |c| c.pixel_mapuiv(GL_PIXEL_MAP_S_TO_S, 6, (&[0_u32; 6]).arg()),
        VALUE,
        "mapsize = 6",
    ),
    (
        nothing,
        |c| c.pixel_mapuiv(GL_PIXEL_MAP_R_TO_R, 6, (&[0_u32; 5]).arg()),
        OPERATION,
        "values has fewer",
    ),
    (nothing, |c| c.get_pixel_mapfv(GL_MAP_COLOR, (&mut [0.0_f32]).arg()), ENUM, "GL_MAP_COLOR"),
    (nothing, |c| c.get_pixel_mapuiv(GL_MAP_COLOR, (&mut [0_u32]).arg()), ENUM, "GL_MAP_COLOR"),
    (nothing, |c| c.get_pixel_mapusv(GL_MAP_COLOR, (&mut [0_u16]).arg()), ENUM, "GL_MAP_COLOR"),
    // Lists and stacks.
    (nothing, |c| c.new_list(0, GL_COMPILE), VALUE, "list = 0"),
    (nothing, |c| c.new_list(1, GL_RENDER), ENUM, "mode = GL_RENDER"),
    (|c| c.new_list(1, GL_COMPILE), |c| c.new_list(2, GL_COMPILE), OPERATION, "list 1 is being"),
    (nothing, |c| c.end_list(), OPERATION, "glNewList is missing"),
    (nothing, |c| assert_eq!(c.gen_lists(-1), 0), VALUE, "range = -1"),
    (nothing, |c| c.delete_lists(1, -1), VALUE, "range = -1"),
    (nothing, |c| c.call_lists(-1, GL_BYTE, Data::Null), VALUE, "n = -1"),
    (nothing, |c| c.call_lists(1, GL_DOUBLE, Data::Null), ENUM, "type = GL_DOUBLE"),
    (nothing, |c| c.call_lists(2, GL_BYTE, Data::Bytes(&[1])), OPERATION, "lists has 1 bytes"),
    (nothing, |c| c.pop_attrib(), GL_STACK_UNDERFLOW, "glPushAttrib is missing"),
    (nothing, |c| c.pop_client_attrib(), GL_STACK_UNDERFLOW, "glPushClientAttrib is missing"),
    (|c| (0..16).for_each(|_| c.push_attrib(0)), |c| c.push_attrib(0), GL_STACK_OVERFLOW, "16"),
    (
        |c| (0..16).for_each(|_| c.push_client_attrib(0)),
        |c| c.push_client_attrib(0),
        GL_STACK_OVERFLOW,
        "16",
    ),
    (|c| (1..32).for_each(|_| c.push_matrix()), |c| c.push_matrix(), GL_STACK_OVERFLOW, "32"),
    // Selection and feedback.
    (nothing, |c| assert_eq!(c.render_mode(GL_LINE), 0), ENUM, "mode = GL_LINE must be GL_RENDER"),
    (nothing, |c| assert_eq!(c.render_mode(GL_SELECT), 0), OPERATION, "call glSelectBuffer first"),
    (nothing, |c| assert_eq!(c.render_mode(GL_FEEDBACK), 0), OPERATION, "glFeedbackBuffer first"),
    (nothing, |c| c.select_buffer(-1, DataOut::Null), VALUE, "size = -1"),
    (selecting, |c| c.select_buffer(1, DataOut::Null), OPERATION, "the mode is GL_SELECT"),
    (
        nothing,
        |c| c.select_buffer(4, DataOut::Bytes(&mut [0; 16])),
        OPERATION,
        "cannot be memory that is borrowed",
    ),
    (nothing, |c| c.feedback_buffer(-1, GL_2D, DataOut::Null), VALUE, "size = -1"),
    (nothing, |c| c.feedback_buffer(1, GL_RGBA, DataOut::Null), ENUM, "type = GL_RGBA"),
    (feeding_back, |c| c.feedback_buffer(1, GL_2D, DataOut::Null), OPERATION, "GL_FEEDBACK"),
    (
        nothing,
        |c| c.feedback_buffer(1, GL_2D, DataOut::Offset(4)),
        OPERATION,
        "cannot be memory that is borrowed",
    ),
    (selecting, |c| c.load_name(1), OPERATION, "call glPushName"),
    (selecting, |c| c.pop_name(), GL_STACK_UNDERFLOW, "glPushName is missing"),
    (
        |c| {
            selecting(c);
            (0..64).for_each(|name| c.push_name(name));
        },
        |c| c.push_name(1),
        GL_STACK_OVERFLOW,
        "64 names",
    ),
    // Accumulation and conditional rendering.
    (nothing, |c| c.accum(GL_REPLACE, 1.0), ENUM, "op = GL_REPLACE must be GL_ACCUM"),
    (
        |c| {
            c.bind_framebuffer(GL_FRAMEBUFFER, 1);
            c.bind_renderbuffer(GL_RENDERBUFFER, 1);
            c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 2, 2);
            c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
        },
        |c| c.accum(GL_LOAD, 1.0),
        OPERATION,
        "have no accumulation buffer",
    ),
    (
        |c| c.bind_framebuffer(GL_FRAMEBUFFER, 1),
        |c| c.accum(GL_LOAD, 1.0),
        GL_INVALID_FRAMEBUFFER_OPERATION,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (counted, |c| c.begin_conditional_render(1, GL_LINE), ENUM, "mode = GL_LINE"),
    (nothing, |c| c.begin_conditional_render(7, GL_QUERY_WAIT), VALUE, "id = 7 is no query"),
    (counted, |c| c.begin_conditional_render(2, GL_QUERY_WAIT), OPERATION, "counts no samples"),
    (
        |c| {
            counted(c);
            c.begin_query(GL_SAMPLES_PASSED, 1);
        },
        |c| c.begin_conditional_render(1, GL_QUERY_WAIT),
        OPERATION,
        "query 1 is active",
    ),
    (
        |c| {
            counted(c);
            c.begin_conditional_render(1, GL_QUERY_NO_WAIT);
        },
        |c| c.begin_conditional_render(1, GL_QUERY_WAIT),
        OPERATION,
        "glEndConditionalRender is missing",
    ),
    (nothing, |c| c.end_conditional_render(), OPERATION, "glBeginConditionalRender is missing"),
    // Evaluators.
    (nothing, |c| c.map1f(GL_MAP2_INDEX, 0.0, 1.0, 1, 1, &[0.0]), ENUM, "target = GL_MAP2_INDEX"),
    (nothing, |c| c.map1d(GL_MAP1_INDEX, 1.0, 1.0, 1, 1, &[0.0]), VALUE, "u1 = 1 and u2 = 1"),
    (nothing, |c| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 2, 1, &[0.0; 3]), VALUE, "ustride = 2"),
    (nothing, |c| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 0, &[0.0; 3]), VALUE, "uorder = 0"),
    (nothing, |c| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 31, &[0.0; 3]), VALUE, "uorder = 31"),
    (
        nothing,
        |c| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 2, &[0.0; 5]),
        OPERATION,
        "take 6 numbers",
    ),
    (
        |c| c.active_texture(GL_TEXTURE1),
        |c| c.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 1, &[0.0; 3]),
        OPERATION,
        "call glActiveTexture(GL_TEXTURE0)",
    ),
    (
        nothing,
        |c| c.map2f(GL_MAP1_INDEX, 0.0, 1.0, 1, 1, 0.0, 1.0, 1, 1, &[0.0]),
        ENUM,
        "target = GL_MAP1_INDEX",
    ),
    (
        nothing,
        |c| c.map2f(GL_MAP2_INDEX, 0.0, 1.0, 1, 1, 2.0, 2.0, 1, 1, &[0.0]),
        VALUE,
        "v1 = 2 and v2 = 2",
    ),
    (
        nothing,
        |c| c.map2d(GL_MAP2_NORMAL, 0.0, 1.0, 3, 1, 0.0, 1.0, 2, 1, &[0.0; 3]),
        VALUE,
        "vstride = 2",
    ),
    (
        nothing,
        |c| c.map2d(GL_MAP2_NORMAL, 0.0, 1.0, 3, 1, 0.0, 1.0, 3, 99, &[0.0; 3]),
        VALUE,
        "vorder = 99",
    ),
    (nothing, |c| c.get_mapfv(GL_COEFF, GL_ORDER, (&mut [0.0_f32]).arg()), ENUM, "target"),
    (nothing, |c| c.get_mapdv(GL_MAP1_INDEX, GL_LINE, (&mut [0.0]).arg()), ENUM, "query = GL_LINE"),
    (
        nothing,
        |c| c.get_mapiv(GL_MAP2_INDEX, GL_DOMAIN, (&mut [0; 3]).arg()),
        OPERATION,
        "4 values, v has room for 3",
    ),
    (nothing, |c| c.map_grid1f(0, 0.0, 1.0), VALUE, "un = 0 must be positive"),
    (nothing, |c| c.map_grid1d(-1, 0.0, 1.0), VALUE, "un = -1"),
    (nothing, |c| c.map_grid2f(1, 0.0, 1.0, 0, 0.0, 1.0), VALUE, "vn = 0"),
    (nothing, |c| c.map_grid2d(0, 0.0, 1.0, 1, 0.0, 1.0), VALUE, "un = 0"),
    (nothing, |c| c.eval_mesh1(GL_FILL, 0, 1), ENUM, "mode = GL_FILL must be GL_POINT or GL_LINE"),
    (nothing, |c| c.eval_mesh2(GL_POINTS, 0, 1, 0, 1), ENUM, "mode"),
    (nothing, |c| c.eval_mesh1(GL_LINE, i32::MIN, i32::MAX), GL_OUT_OF_MEMORY, "4294967296 points"),
    (nothing, |c| c.eval_mesh2(GL_LINE, 0, 9999, 0, 9999), GL_OUT_OF_MEMORY, "100000000 points"),
    (nothing, |c| c.eval_coord1fv(&[]), OPERATION, "0 of 1 numbers"),
    (nothing, |c| c.eval_coord1dv(&[]), OPERATION, "0 of 1 numbers"),
    (nothing, |c| c.eval_coord2fv(&[0.0]), OPERATION, "1 of 2 numbers"),
    (nothing, |c| c.eval_coord2dv(&[0.0]), OPERATION, "1 of 2 numbers"),
    // Colour indices.
    (nothing, |c| c.index_pointer(GL_UNSIGNED_INT, 0, Data::Null), ENUM, "type = GL_UNSIGNED_INT"),
    (nothing, |c| c.index_pointer(GL_FLOAT, -1, Data::Null), VALUE, "stride = -1"),
    (nothing, |c| c.materialf(GL_FRONT, GL_COLOR_INDEXES, 1.0), ENUM, "3 values"),
    (nothing, |c| c.draw_pixels(1, 1, GL_COLOR_INDEX, GL_RGBA, Data::Null), ENUM, "type = GL_RGBA"),
    (
        nothing,
        |c| c.draw_pixels(9, 1, GL_COLOR_INDEX, GL_BITMAP, Data::Bytes(&[0])),
        OPERATION,
        "take 2 bytes; the memory has 1",
    ),
];

/// Runs the rows.
pub fn run() {
    for (number, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("special functions {number}"), call, *flag, words);
    }
}
