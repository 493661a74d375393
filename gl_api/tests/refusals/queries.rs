//! What the calls on queries, the log, fences, points, lines and polygons refuse.

use gl_api::*;

/// A name, what comes before, a call, the flag it must set, and words that its message must have.
type Case = (&'static str, fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

const OWN: GLenum = GL_DEBUG_SOURCE_APPLICATION;
const HIGH: GLenum = GL_DEBUG_SEVERITY_HIGH;

/// With names 1 to 4 of queries.
const QUERY_ROWS: &[Case] = &[
    (
        "begin: target",
        nothing,
        |c| c.begin_query(GL_TIMESTAMP, 1),
        GL_INVALID_ENUM,
        "target = GL_TIMESTAMP must be GL_SAMPLES_PASSED",
    ),
    (
        "begin: 0",
        nothing,
        |c| c.begin_query(GL_SAMPLES_PASSED, 0),
        GL_INVALID_OPERATION,
        "id = 0 is no query: call glGenQueries",
    ),
    (
        "begin: twice",
        |c| {
            c.begin_query(GL_SAMPLES_PASSED, 1);
        },
        |c| {
            c.begin_query(GL_SAMPLES_PASSED, 2);
        },
        GL_INVALID_OPERATION,
        "a query of GL_SAMPLES_PASSED is active: glEndQuery is missing",
    ),
    (
        "begin: active elsewhere",
        |c| {
            c.begin_query(GL_SAMPLES_PASSED, 1);
        },
        |c| {
            c.begin_query(GL_TIME_ELAPSED, 1);
        },
        GL_INVALID_OPERATION,
        "query 1 is active as one of GL_SAMPLES_PASSED",
    ),
    (
        "begin: another target's",
        |c| {
            c.begin_query(GL_SAMPLES_PASSED, 1);
            c.end_query(GL_SAMPLES_PASSED);
        },
        |c| {
            c.begin_query(GL_TIME_ELAPSED, 1);
        },
        GL_INVALID_OPERATION,
        "query 1 is one of GL_SAMPLES_PASSED: take another name",
    ),
    (
        "end: none",
        nothing,
        |c| c.end_query(GL_SAMPLES_PASSED),
        GL_INVALID_OPERATION,
        "no query of GL_SAMPLES_PASSED is active: glBeginQuery is missing",
    ),
    (
        "end: target",
        nothing,
        |c| c.end_query(GL_FLOAT),
        GL_INVALID_ENUM,
        "target = GL_FLOAT must be GL_SAMPLES_PASSED",
    ),
    (
        "counter: target",
        nothing,
        |c| c.query_counter(1, GL_SAMPLES_PASSED),
        GL_INVALID_ENUM,
        "target = GL_SAMPLES_PASSED must be GL_TIMESTAMP",
    ),
    (
        "counter: unknown",
        nothing,
        |c| c.query_counter(9, GL_TIMESTAMP),
        GL_INVALID_OPERATION,
        "id = 9 must be a name that glGenQueries gave, and not be active",
    ),
    (
        "gen",
        nothing,
        |c| c.gen_queries(-1, &mut []),
        GL_INVALID_VALUE,
        "n = -1 must not be negative",
    ),
    (
        "delete",
        nothing,
        |c| c.delete_queries(-1, &[]),
        GL_INVALID_VALUE,
        "n = -1 must not be negative",
    ),
    (
        "of a target: pname",
        nothing,
        |c| {
            c.get_queryiv(GL_SAMPLES_PASSED, GL_FLOAT, &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname = GL_FLOAT must be GL_CURRENT_QUERY",
    ),
    (
        "of an object: no query",
        nothing,
        |c| {
            c.get_query_objectiv(1, GL_QUERY_RESULT, &mut [0]);
        },
        GL_INVALID_OPERATION,
        "id = 1 is no query that has begun",
    ),
    (
        "of an object: active",
        |c| {
            c.begin_query(GL_SAMPLES_PASSED, 1);
        },
        |c| {
            c.get_query_objectiv(1, GL_QUERY_RESULT, &mut [0]);
        },
        GL_INVALID_OPERATION,
        "query 1 is active: call glEndQuery first",
    ),
    (
        "of an object: pname",
        |c| {
            c.query_counter(1, GL_TIMESTAMP);
        },
        |c| {
            c.get_query_objectiv(1, GL_FLOAT, &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname = GL_FLOAT must be GL_QUERY_RESULT",
    ),
];

/// The log, and fences.
const PLAIN_ROWS: &[Case] = &[
    (
        "control: source",
        nothing,
        |c| {
            c.debug_message_control(GL_FLOAT, GL_DONT_CARE, GL_DONT_CARE, 0, &[], true);
        },
        GL_INVALID_ENUM,
        "source = GL_FLOAT must be GL_DEBUG_SOURCE_API",
    ),
    (
        "control: type",
        nothing,
        |c| {
            c.debug_message_control(GL_DONT_CARE, GL_FLOAT, GL_DONT_CARE, 0, &[], true);
        },
        GL_INVALID_ENUM,
        "type = GL_FLOAT must be GL_DEBUG_TYPE_ERROR",
    ),
    (
        "control: severity",
        nothing,
        |c| {
            c.debug_message_control(GL_DONT_CARE, GL_DONT_CARE, GL_FLOAT, 0, &[], true);
        },
        GL_INVALID_ENUM,
        "severity = GL_FLOAT must be GL_DEBUG_SEVERITY_HIGH",
    ),
    (
        "control: count",
        nothing,
        |c| {
            c.debug_message_control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, -1, &[], true);
        },
        GL_INVALID_VALUE,
        "count = -1 must not be negative",
    ),
    (
        "control: ids of any source",
        nothing,
        |c| {
            c.debug_message_control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 1, &[1], true);
        },
        GL_INVALID_OPERATION,
        "source and type must not be GL_DONT_CARE",
    ),
    (
        "insert: source",
        nothing,
        |c| {
            let source = GL_DEBUG_SOURCE_API;
            c.debug_message_insert(source, GL_DEBUG_TYPE_OTHER, 1, HIGH, -1, "");
        },
        GL_INVALID_ENUM,
        "source = GL_DEBUG_SOURCE_API must be GL_DEBUG_SOURCE_APPLICATION",
    ),
    (
        "insert: length",
        nothing,
        |c| {
            let text = "x".repeat(4096);
            c.debug_message_insert(OWN, GL_DEBUG_TYPE_OTHER, 1, HIGH, -1, &text);
        },
        GL_INVALID_VALUE,
        "message has 4096 bytes; it must have fewer than 4096",
    ),
    (
        "log: room",
        nothing,
        |c| {
            let none = TextOut::Bytes(&mut []);
            let empty: &mut [GLsizei] = &mut [];
            c.get_debug_message_log(1, -1, &mut [], &mut [], &mut [], &mut [], empty, none);
        },
        GL_INVALID_VALUE,
        "bufSize = -1 must not be negative",
    ),
    (
        "push: source",
        nothing,
        |c| {
            c.push_debug_group(GL_DEBUG_SOURCE_OTHER, 1, -1, "");
        },
        GL_INVALID_ENUM,
        "source = GL_DEBUG_SOURCE_OTHER must be GL_DEBUG_SOURCE_APPLICATION",
    ),
    (
        "push: too many",
        |c| {
            for _ in 0..63 {
                c.push_debug_group(OWN, 1, -1, "");
            }
        },
        |c| c.push_debug_group(OWN, 1, -1, ""),
        GL_STACK_OVERFLOW,
        "64 groups are open, the most there may be: glPopDebugGroup is missing",
    ),
    (
        "pop: none",
        nothing,
        |c| c.pop_debug_group(),
        GL_STACK_UNDERFLOW,
        "no group is open: glPushDebugGroup is missing",
    ),
    (
        "label: identifier",
        nothing,
        |c| c.object_label(GL_FLOAT, 1, -1, ""),
        GL_INVALID_ENUM,
        "identifier = GL_FLOAT must be GL_BUFFER",
    ),
    (
        "label: name",
        nothing,
        |c| c.object_label(GL_BUFFER, 1, -1, ""),
        GL_INVALID_VALUE,
        "name = 1 is no object of GL_BUFFER",
    ),
    (
        "label: length",
        |c| {
            c.bind_buffer(GL_ARRAY_BUFFER, 1);
        },
        |c| {
            c.object_label(GL_BUFFER, 1, -1, &"x".repeat(256));
        },
        GL_INVALID_VALUE,
        "label has 256 bytes; it must have fewer than 256",
    ),
    (
        "label: sync",
        nothing,
        |c| c.object_ptr_label(5 as *const GLvoid, -1, ""),
        GL_INVALID_VALUE,
        "ptr is no handle that glFenceSync gave",
    ),
    (
        "pointer",
        nothing,
        |c| c.get_pointerv(GL_FLOAT, &mut [std::ptr::null_mut()]),
        GL_INVALID_ENUM,
        "pname = GL_FLOAT names no pointer",
    ),
    (
        "fence: condition",
        nothing,
        |c| {
            c.fence_sync(GL_FLOAT, 0);
        },
        GL_INVALID_ENUM,
        "condition = GL_FLOAT must be GL_SYNC_GPU_COMMANDS_COMPLETE",
    ),
    (
        "fence: flags",
        nothing,
        |c| {
            c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 1);
        },
        GL_INVALID_VALUE,
        "flags = 0x1 must be 0",
    ),
    (
        "fence: handle",
        nothing,
        |c| {
            c.client_wait_sync(5 as GLsync, 0, 0);
        },
        GL_INVALID_VALUE,
        "sync is no handle that glFenceSync gave",
    ),
    (
        "fence: deleting",
        nothing,
        |c| c.delete_sync(5 as GLsync),
        GL_INVALID_VALUE,
        "sync is no handle that glFenceSync gave",
    ),
    (
        "fence: waiting",
        nothing,
        |c| {
            let fence = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            c.wait_sync(fence, 0, 1);
        },
        GL_INVALID_VALUE,
        "timeout = 0x1 must be GL_TIMEOUT_IGNORED",
    ),
    (
        "fence: pname",
        nothing,
        |c| {
            let fence = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            c.get_synciv(fence, GL_FLOAT, 1, &mut [0], &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname = GL_FLOAT must be GL_OBJECT_TYPE",
    ),
];

/// Points, lines and polygons.
const PRIMITIVE_ROWS: &[Case] = &[
    (
        "primitives 0",
        nothing,
        |c| c.polygon_mode(GL_LEFT, GL_FILL),
        GL_INVALID_ENUM,
        "face = GL_LEFT must be GL_FRONT",
    ),
    (
        "primitives 1",
        nothing,
        |c| c.polygon_mode(GL_FRONT, GL_LINES),
        GL_INVALID_ENUM,
        "must be GL_POINT",
    ),
    (
        "primitives 2",
        nothing,
        |c| c.polygon_stipple(Data::Bytes(&[0; 127])),
        GL_INVALID_OPERATION,
        "127 of 128 bytes",
    ),
    ("primitives 3", nothing, |c| c.polygon_stipple(Data::Null), GL_INVALID_OPERATION, "not NULL"),
    (
        "primitives 4",
        nothing,
        |c| c.get_polygon_stipple(DataOut::Bytes(&mut [0; 4])),
        GL_INVALID_OPERATION,
        "128 bytes are needed; there are 4",
    ),
    ("primitives 5", nothing, |c| c.edge_flagv(&[]), GL_INVALID_OPERATION, "none of 1"),
    (
        "primitives 6",
        nothing,
        |c| c.edge_flag_pointer(-1, Data::Null),
        GL_INVALID_VALUE,
        "stride = -1",
    ),
    (
        "primitives 7",
        nothing,
        |c| c.line_width(-1.0),
        GL_INVALID_VALUE,
        "width = -1 must be positive",
    ),
    ("primitives 8", nothing, |c| c.point_size(0.0), GL_INVALID_VALUE, "size = 0 must be positive"),
    (
        "primitives 9",
        nothing,
        |c| c.point_parameterf(GL_POINT_SIZE, 1.0),
        GL_INVALID_ENUM,
        "GL_POINT_SIZE_MIN",
    ),
    (
        "primitives 10",
        nothing,
        |c| c.point_parameterf(GL_POINT_SIZE_MIN, -1.0),
        GL_INVALID_VALUE,
        "GL_POINT_SIZE_MIN = -1 must not be negative",
    ),
    (
        "primitives 11",
        nothing,
        |c| c.point_parameterf(GL_POINT_SIZE_MAX, f32::NAN),
        GL_INVALID_VALUE,
        "NaN must not",
    ),
    (
        "primitives 12",
        nothing,
        |c| c.point_parameterf(GL_POINT_DISTANCE_ATTENUATION, 1.0),
        GL_INVALID_ENUM,
        "use glPointParameterfv",
    ),
    (
        "primitives 13",
        nothing,
        |c| c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[1.0, 0.0]),
        GL_INVALID_OPERATION,
        "2 of 3 values",
    ),
    (
        "primitives 14",
        nothing,
        |c| c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[1.0, -0.5, 0.0]),
        GL_INVALID_VALUE,
        "-0.5 must not be negative",
    ),
    (
        "primitives 15",
        nothing,
        |c| c.point_parameteriv(GL_POINT_SIZE_MAX, &[]),
        GL_INVALID_OPERATION,
        "0 of 1 values",
    ),
    (
        "primitives 16",
        nothing,
        |c| c.point_parameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_FRONT as i32),
        GL_INVALID_ENUM,
        "GL_UPPER_LEFT",
    ),
    (
        "primitives 17",
        nothing,
        |c| c.tex_envi(GL_POINT_SPRITE, GL_TEXTURE_ENV_MODE, 0),
        GL_INVALID_ENUM,
        "must be GL_COORD_REPLACE",
    ),
];

/// Runs the rows.
pub fn run() {
    for (name, prepare, call, flag, words) in
        QUERY_ROWS.iter().chain(PLAIN_ROWS).chain(PRIMITIVE_ROWS)
    {
        let mut c = super::context();
        c.gen_queries(4, &mut [0; 4]);
        prepare(&mut c);
        super::row(&mut c, (*name).to_owned(), call, *flag, words);
    }
}
