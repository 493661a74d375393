//! Commands that make much of few bytes, other than draws of too many vertices (`endless_draws.rs`): shapes as large or as
//! slow as they can be, evaluators, pixels with a huge zoom, lists that call lists. They end soon: by the budget of the
//! draw, as a refused call, by the budget of lists, or because no more pixels are touched than there are.

#[path = "common/cpu_time.rs"]
mod cpu_time;
#[path = "common/shading.rs"]
mod shading;

use cpu_time::CpuTime;
use gl_api::*;
use shading::{use_program, use_stages};
use std::time::Duration;

/// Processor time: half a second where it is compiled for speed and nothing else runs.
const SOON: Duration = Duration::from_secs(20);

const SIZE: u32 = 512;
const STOPPED: &str = "so long that the rest of its draw was left out";
const LISTS_STOPPED: &str = "2097152 commands";
const MANY: GLsizei = GLsizei::MAX;
/// Fewer than what no scene has ([`MANY`]), where each takes little.
const FEWER: GLsizei = 80_000_000;
/// A triangle that covers the window.
const LARGE: [f32; 6] = [-1.0, -1.0, 3.0, -1.0, -1.0, 3.0];
const FRAGMENT: &str = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }";

/// How a command ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// The rest of a draw is left out.
    Stopped,
    /// `GL_OUT_OF_MEMORY`.
    Refused,
    /// The rest of the lists is left out.
    ListsStopped,
    /// By itself.
    Whole,
}

fn corners(c: &mut Context, corners: &[f32]) {
    let bytes = corners.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, bytes.len() as GLsizeiptr, Data::Bytes(&bytes), GL_STATIC_DRAW);
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    c.enable_client_state(GL_VERTEX_ARRAY);
}

fn context(samples: u8, draw_budget: Option<u64>) -> Context {
    let surface = SurfaceDesc { samples, ..SurfaceDesc::default() };
    let desc =
        ContextDesc { width: SIZE, height: SIZE, surface, draw_budget, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a context");
    corners(&mut c, &LARGE);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.finish();
    c
}

fn instances(c: &mut Context, mode: GLenum, count: GLsizei) {
    c.draw_arrays_instanced(mode, 0, 3, count);
}

fn geometry(c: &mut Context, output: &str, body: &str) {
    let geometry = format!(
        "#version 150 compatibility\nlayout(points) in; layout({output}, max_vertices = 200) out;
         void main() {{ for (int i = 0; i < 200; i++) {{ {body} EmitVertex(); }} }}"
    );
    let vertex = "#version 150 compatibility\nvoid main() { gl_Position = vec4(2.0); }";
    let stages = [
        (GL_VERTEX_SHADER, vertex),
        (GL_GEOMETRY_SHADER, &geometry),
        (GL_FRAGMENT_SHADER, FRAGMENT),
    ];
    use_stages(c, &stages);
    c.disable_client_state(GL_VERTEX_ARRAY);
    c.enable(GL_PROGRAM_POINT_SIZE);
}

/// Evaluators of this order, and a grid of 4096² points.
fn evaluators(c: &mut Context, targets: &[GLenum], order: GLint) {
    let stride = 4 * order;
    let points = vec![0.5_f32; (stride * order) as usize];
    for &target in targets {
        c.map2f(target, 0.0, 1.0, 4, order, 0.0, 1.0, stride, order, &points);
        c.enable(target);
    }
    c.map_grid2f(4096, 0.0, 1.0, 4096, 0.0, 1.0);
}

/// A list that calls eight times one that calls eight times … one of these commands.
fn nested(c: &mut Context, commands: fn(&mut Context)) {
    const LEVELS: GLuint = 12;
    for level in 1..LEVELS {
        c.new_list(level, GL_COMPILE);
        (0..8).for_each(|_| c.call_list(level + 1));
        c.end_list();
    }
    c.new_list(LEVELS, GL_COMPILE);
    commands(c);
    c.end_list();
    c.call_list(1);
}

fn triangle(c: &mut Context) {
    c.begin(GL_TRIANGLES);
    LARGE.chunks(2).for_each(|at| c.vertex_2f(at[0], at[1]));
    c.end();
}

fn one_pixel(c: &mut Context) {
    c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[1, 2, 3, 4]));
}

/// Of a texture level without texels.
fn texture(c: &mut Context, width: GLsizei, height: GLsizei) {
    let (rgba, ty) = (GL_RGBA8 as GLint, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, width, height, 0, GL_RGBA, ty, Data::Null);
}

/// The name, the samples of a pixel, what runs, how it ends.
type Row = (&'static str, u8, fn(&mut Context), End);

/// Draws of a number of instances that is not out of this world: what each takes must count.
const SHAPES: &[Row] = &[
    ("small points", 1, |c| instances(c, GL_POINTS, FEWER), End::Stopped),
    ("small points of samples", 4, |c| instances(c, GL_POINTS, FEWER), End::Stopped),
    (
        "points of a size of 10^9",
        1,
        |c| {
            c.point_size(1e9);
            instances(c, GL_POINTS, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "smooth points",
        1,
        |c| {
            c.enable(GL_POINT_SMOOTH);
            c.enable(GL_BLEND);
            c.point_size(64.0);
            instances(c, GL_POINTS, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "sprites of samples",
        4,
        |c| {
            c.enable(GL_POINT_SPRITE);
            c.point_size(64.0);
            instances(c, GL_POINTS, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "wide lines",
        1,
        |c| {
            c.line_width(64.0);
            instances(c, GL_LINE_LOOP, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "smooth lines",
        1,
        |c| {
            c.enable(GL_LINE_SMOOTH);
            c.enable(GL_BLEND);
            instances(c, GL_LINE_LOOP, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "stippled lines",
        1,
        |c| {
            c.enable(GL_LINE_STIPPLE);
            c.line_stipple(1, 0x5555);
            instances(c, GL_LINE_LOOP, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "outlines",
        1,
        |c| {
            c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
            instances(c, GL_TRIANGLES, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "outlines out of the window",
        1,
        |c| {
            c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
            corners(c, &[3.0, 3.0, 4.0, 3.0, 3.0, 4.0]);
            instances(c, GL_TRIANGLES, FEWER / 4);
        },
        End::Stopped,
    ),
    (
        "six clip planes",
        1,
        |c| {
            for plane in 0..6 {
                let angle = f64::from(plane);
                let equation = [angle.cos(), angle.sin(), 0.0, 0.1];
                c.clip_plane(GL_CLIP_PLANE0 + plane, &equation);
                c.enable(GL_CLIP_PLANE0 + plane);
            }
            corners(c, &[-9.0, -9.0, 9.0, -9.0, 0.0, 30.0]);
            instances(c, GL_TRIANGLES, FEWER);
        },
        End::Stopped,
    ),
    (
        "samples that are shaded",
        4,
        |c| {
            c.enable(GL_SAMPLE_SHADING);
            c.min_sample_shading(1.0);
            corners(c, &[0.0, 0.0, 0.01, 0.0, 0.0, 0.01]);
            instances(c, GL_TRIANGLES, FEWER);
        },
        End::Stopped,
    ),
    (
        "long and thin",
        1,
        |c| {
            corners(c, &[-1.0, -1.0, 1.0, 1.0, 1.0, 0.999]);
            instances(c, GL_TRIANGLES, FEWER);
        },
        End::Stopped,
    ),
    (
        "hidden, counted by a query",
        1,
        |c| {
            c.enable(GL_DEPTH_TEST);
            c.depth_func(GL_NEVER);
            c.begin_query(GL_SAMPLES_PASSED, 5);
            corners(c, &[0.0, 0.0, 0.1, 0.0, 0.0, 0.1]);
            instances(c, GL_TRIANGLES, FEWER);
            c.end_query(GL_SAMPLES_PASSED);
        },
        End::Stopped,
    ),
    (
        "eight lights on two sides",
        1,
        |c| {
            c.enable(GL_LIGHTING);
            (0..8).for_each(|light| c.enable(GL_LIGHT0 + light));
            c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
            instances(c, GL_TRIANGLES, FEWER);
        },
        End::Stopped,
    ),
    (
        "lookups in a vertex shader",
        1,
        |c| {
            texture(c, 64, 64);
            let vertex = "#version 130\nuniform sampler2D t;
                void main() { gl_Position = gl_Vertex + texture(t, gl_Vertex.xy) + texture(t, gl_Vertex.yx); }";
            use_program(c, vertex, FRAGMENT);
            instances(c, GL_TRIANGLES, FEWER);
        },
        End::Stopped,
    ),
    (
        "points that a geometry shader makes",
        1,
        |c| {
            geometry(c, "points", "gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 64.0;");
            c.draw_arrays(GL_POINTS, 0, 1 << 22);
        },
        End::Stopped,
    ),
    (
        "whole windows that a geometry shader makes",
        1,
        |c| {
            let body = "gl_Position = vec4((i & 1) * 4 - 1, (i & 2) * 2 - 1, 0.0, 1.0);";
            geometry(c, "triangle_strip", body);
            c.draw_arrays(GL_POINTS, 0, 1 << 18);
        },
        End::Stopped,
    ),
];

const COMMANDS: &[Row] = &[
    (
        "selection",
        1,
        |c| {
            c.select_buffer(1 << 20, DataOut::Null);
            c.render_mode(GL_SELECT);
            c.push_name(1);
            instances(c, GL_TRIANGLES, MANY);
            c.render_mode(GL_RENDER);
        },
        End::Refused,
    ),
    (
        "feedback",
        1,
        |c| {
            c.feedback_buffer(1 << 20, GL_2D, DataOut::Null);
            c.render_mode(GL_FEEDBACK);
            instances(c, GL_TRIANGLES, MANY);
            c.render_mode(GL_RENDER);
        },
        End::Refused,
    ),
    (
        "transform feedback",
        1,
        |c| {
            let (program, shader) = (c.create_program(), c.create_shader(GL_VERTEX_SHADER));
            let source = "#version 130\nout vec4 o; void main() { gl_Position = vec4(2.0); o = vec4(gl_VertexID); }";
            c.shader_source(shader, 1, Strings(vec![source]), &[]);
            c.compile_shader(shader);
            c.attach_shader(program, shader);
            c.transform_feedback_varyings(program, 1, Names(vec!["o"]), GL_INTERLEAVED_ATTRIBS);
            c.link_program(program);
            c.use_program(program);
            c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 9);
            c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 20, Data::Null, GL_STATIC_DRAW);
            c.disable_client_state(GL_VERTEX_ARRAY);
            c.begin_transform_feedback(GL_POINTS);
            c.draw_arrays(GL_POINTS, 0, MANY);
            c.end_transform_feedback();
        },
        End::Stopped,
    ),
    (
        "a mesh of 2^24 points",
        1,
        |c| {
            evaluators(c, &[GL_MAP2_VERTEX_4], 2);
            c.eval_mesh2(GL_FILL, 0, 4094, 0, 4094);
        },
        End::Refused,
    ),
    (
        "a mesh of the highest order",
        1,
        |c| {
            let maps = [GL_MAP2_VERTEX_4, GL_MAP2_COLOR_4, GL_MAP2_NORMAL, GL_MAP2_TEXTURE_COORD_4];
            evaluators(c, &maps, 30);
            c.eval_mesh2(GL_LINE, 0, 255, 0, 255);
        },
        End::Refused,
    ),
    (
        "a mesh that is drawn",
        1,
        |c| {
            evaluators(c, &[GL_MAP2_VERTEX_4, GL_MAP2_NORMAL], 4);
            c.eval_mesh2(GL_FILL, 0, 700, 0, 700);
        },
        End::Whole,
    ),
    ("a mesh of all integers", 1, |c| c.eval_mesh1(GL_LINE, i32::MIN, i32::MAX), End::Refused),
    (
        "a pixel zoomed by 10^30",
        1,
        |c| {
            c.pixel_zoom(1e30, 1e30);
            one_pixel(c);
        },
        End::Whole,
    ),
    ("copied pixels", 1, |c| c.copy_pixels(i32::MIN, i32::MIN, MANY, MANY, GL_COLOR), End::Refused),
    (
        "a blit between all integers",
        1,
        |c| {
            let (least, most) = (i32::MIN, i32::MAX);
            let mask = GL_COLOR_BUFFER_BIT;
            c.blit_framebuffer(
                least, least, most, most, most, most, least, least, mask, GL_NEAREST,
            );
        },
        End::Whole,
    ),
    (
        "a bitmap that moves far",
        1,
        |c| c.bitmap(8, 1, 1e30, -1e30, 1e30, 1e30, Data::Bytes(&[255])),
        End::Whole,
    ),
    (
        "all levels of 8192 × 2048 texels",
        1,
        |c| {
            texture(c, 8192, 2048);
            c.generate_mipmap(GL_TEXTURE_2D);
        },
        End::Whole,
    ),
    ("lists of glAccum", 1, |c| nested(c, |c| c.accum(GL_ACCUM, 0.5)), End::ListsStopped),
    ("lists of glClear", 1, |c| nested(c, |c| c.clear(GL_COLOR_BUFFER_BIT)), End::ListsStopped),
    ("lists of triangles", 1, |c| nested(c, triangle), End::ListsStopped),
    ("lists of glRectf", 1, |c| nested(c, |c| c.rectf(-1.0, -1.0, 1.0, 1.0)), End::ListsStopped),
    (
        "lists of glCopyPixels",
        1,
        |c| nested(c, |c| c.copy_pixels(0, 0, SIZE as i32, SIZE as i32, GL_COLOR)),
        End::ListsStopped,
    ),
    (
        "lists of a zoomed pixel",
        1,
        |c| {
            c.pixel_zoom(1e9, 1e9);
            nested(c, one_pixel);
        },
        End::ListsStopped,
    ),
    (
        "lists of glCopyTexImage2D",
        1,
        |c| {
            nested(c, |c| {
                c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, SIZE as i32, SIZE as i32, 0);
            });
        },
        End::ListsStopped,
    ),
    ("lists of glTexImage2D", 1, |c| nested(c, |c| texture(c, 2048, 2048)), End::ListsStopped),
    (
        "lists of meshes",
        1,
        |c| {
            evaluators(c, &[GL_MAP2_VERTEX_4], 2);
            nested(c, |c| c.eval_mesh2(GL_FILL, 0, 255, 0, 255));
        },
        End::ListsStopped,
    ),
    (
        "names of lists",
        1,
        |c| {
            c.new_list(1, GL_COMPILE);
            c.accum(GL_ACCUM, 0.5);
            c.end_list();
            c.call_lists(1 << 20, GL_UNSIGNED_BYTE, Data::Bytes(&[1; 1 << 20]));
        },
        End::ListsStopped,
    ),
];

fn run(rows: &[Row], draw_budget: Option<u64>) {
    for (name, samples, command, end) in rows {
        let mut c = context(*samples, draw_budget);
        let start = CpuTime::begin();
        command(&mut c);
        c.finish();
        let elapsed = start.elapsed();
        println!("{name}: {elapsed:?}");
        assert!(elapsed < SOON, "{name}: {elapsed:?}");
        let messages = c.messages();
        let said = |text: &str| messages.iter().any(|message| message.text.contains(text));
        let has_ended = match (said(STOPPED), said(LISTS_STOPPED), c.get_error()) {
            (true, false, GL_NO_ERROR) => Some(End::Stopped),
            (false, false, GL_OUT_OF_MEMORY) => Some(End::Refused),
            (false, true, GL_NO_ERROR) => Some(End::ListsStopped),
            (false, false, GL_NO_ERROR) => Some(End::Whole),
            _ => None,
        };
        assert_eq!(has_ended, Some(*end), "{name}: {messages:?}");
    }
}

/// With a budget that is a 64th of what is set: so is the time.
#[test]
fn shapes_end_by_what_they_take() {
    run(SHAPES, Some(1 << 20));
}

#[test]
fn commands_end_soon() {
    run(COMMANDS, None);
}
