//! Draws that make much of little memory: 2^31 instances, vertices without arrays, geometry shaders. They end soon, the
//! same pixels on every machine, and the context goes on. Scenes, however large, are drawn whole.

#[path = "common/cpu_time.rs"]
mod cpu_time;
#[path = "common/shading.rs"]
mod shading;

use cpu_time::CpuTime;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use shading::{use_program, use_stages};
use std::sync::Arc;
use std::time::Duration;
use texunit::lanes::Isa;

/// Processor time. A draw takes half a second of one core where it is compiled for speed; here, other tests run at the same
/// time. What ends draws is a number of operations, not a clock.
const SOON: Duration = Duration::from_secs(30);

const MANY: GLsizei = GLsizei::MAX;
const STOPPED: &str = "so long that the rest of its draw was left out";
const SIZE: u32 = 128;

/// With a triangle in a buffer.
fn context(threads: usize, isa: Isa) -> Context {
    let desc = DeviceDesc::new(isa, threads);
    let device = Some(Arc::new(Device::new(desc).expect("a device")));
    let desc = ContextDesc { width: SIZE, height: SIZE, device, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a context");
    let corners = [-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0];
    buffer(&mut c, 1, &corners.map(f32::to_le_bytes).concat());
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.clear_color(0.0, 0.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.finish();
    c
}

fn buffer(c: &mut Context, name: GLuint, bytes: &[u8]) {
    c.bind_buffer(GL_ARRAY_BUFFER, name);
    c.buffer_data(GL_ARRAY_BUFFER, bytes.len() as GLsizeiptr, Data::Bytes(bytes), GL_STATIC_DRAW);
}

fn picture(c: &mut Context) -> Vec<u8> {
    let (mut pixels, side) = (vec![0; (SIZE * SIZE * 4) as usize], SIZE as GLsizei);
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    pixels
}

const FRAGMENT: &str = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }";

/// Vertices by their number, without an array.
fn use_numbers(c: &mut Context, expression: &str) {
    c.disable_client_state(GL_VERTEX_ARRAY);
    let vertex = format!(
        "#version 130\nvoid main() {{ float n = float(gl_VertexID); gl_Position = vec4({expression}, 0.0, 1.0); }}"
    );
    use_program(c, &vertex, FRAGMENT);
}

/// The name, and what draws.
type Case = (&'static str, fn(&mut Context));

const ENDLESS: &[Case] = &[
    ("instances", |c| c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, MANY)),
    ("instances of indices", |c| {
        let indices = Data::Bytes(&[0, 1, 2]);
        c.draw_elements_instanced(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices, MANY);
    }),
    ("instances that are culled", |c| {
        c.enable(GL_CULL_FACE);
        c.cull_face(GL_FRONT_AND_BACK);
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, MANY);
        c.disable(GL_CULL_FACE);
    }),
    ("instances of a strip of lines", |c| c.draw_arrays_instanced(GL_LINE_STRIP, 0, 3, MANY)),
    ("instances whose vertex shader loops", |c| {
        use_program(
            c,
            "#version 130\nvoid main() { gl_Position = gl_Vertex;
             for (int i = 0; i < 100000; i++) gl_Position.x = fract(gl_Position.x + 0.37); }",
            FRAGMENT,
        );
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, MANY);
    }),
    ("instances whose fragment shader loops", |c| {
        use_program(
            c,
            "void main() { gl_Position = gl_Vertex; }",
            "void main() { float s = 0.0; for (int i = 0; i < 10000; i++) s = fract(s + gl_FragCoord.x * 0.37);
             gl_FragColor = vec4(s); }",
        );
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, MANY);
    }),
    ("instances of strips that restart", |c| {
        c.enable(GL_PRIMITIVE_RESTART);
        c.primitive_restart_index(7);
        let indices = Data::Bytes(&[0, 1, 2, 7, 0, 2, 1]);
        c.draw_elements_instanced(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, indices, MANY);
    }),
    ("indirect instances", |c| {
        c.bind_buffer(GL_DRAW_INDIRECT_BUFFER, 9);
        let command = [3, MANY as u32, 0, 0].map(u32::to_le_bytes).concat();
        c.buffer_data(GL_DRAW_INDIRECT_BUFFER, 16, Data::Bytes(&command), GL_STATIC_DRAW);
        c.draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0));
    }),
    ("instances of a divisor that holds one element", |c| {
        c.vertex_attrib_pointer(5, 2, GL_FLOAT, false, 0, Data::Offset(0));
        c.vertex_attrib_divisor(5, MANY as u32);
        c.enable_vertex_attrib_array(5);
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, MANY);
        c.disable_vertex_attrib_array(5);
    }),
    ("points without arrays", |c| {
        use_numbers(c, "fract(n * 0.001), 0.0");
        c.draw_arrays(GL_POINTS, 0, MANY);
    }),
    ("a strip without arrays, out of the window", |c| {
        use_numbers(c, "2.0, 2.0 + fract(n * 0.001)");
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, MANY);
    }),
    ("a loop of lines without arrays", |c| {
        use_numbers(c, "fract(n * 0.001), fract(n * 0.0017)");
        c.draw_arrays(GL_LINE_LOOP, 0, MANY);
    }),
    ("instances of points without arrays", |c| {
        use_numbers(c, "fract(n * 0.001), 0.0");
        c.draw_arrays_instanced(GL_POINTS, 0, MANY, MANY);
    }),
    ("runs without arrays", |c| {
        use_numbers(c, "fract(n * 0.001), 0.0");
        c.multi_draw_arrays(GL_POINTS, &[0; 1000], &[MANY; 1000], 1000);
    }),
    ("a display list of vertices without arrays", |c| {
        use_numbers(c, "fract(n * 0.001), 0.0");
        c.new_list(7, GL_COMPILE);
        c.draw_arrays(GL_POINTS, 0, MANY);
        c.end_list();
        c.call_list(7);
    }),
];

/// Draws that memory holds, whose shapes take longer than their vertices account for.
const HELD: &[Case] = &[
    ("smooth lines across the window", |c| {
        c.enable(GL_LINE_SMOOTH);
        c.line_width(10.0);
        held(c, GL_LINE_STRIP, 500_000);
        c.disable(GL_LINE_SMOOTH);
    }),
    ("smooth points of 64 pixels", |c| {
        c.enable(GL_POINT_SMOOTH);
        c.point_size(64.0);
        held(c, GL_POINTS, 500_000);
        c.disable(GL_POINT_SMOOTH);
    }),
    ("outlines across the window", |c| {
        c.line_width(10.0);
        c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
        held(c, GL_TRIANGLE_STRIP, 500_000);
        c.polygon_mode(GL_FRONT_AND_BACK, GL_FILL);
    }),
    ("what a geometry shader makes of few points", |c| {
        c.disable_client_state(GL_VERTEX_ARRAY);
        let sources = [
            (GL_VERTEX_SHADER, "#version 150 compatibility\nvoid main() { gl_Position = vec4(0.0); }"),
            (
                GL_GEOMETRY_SHADER,
                "#version 150 compatibility\nlayout(points) in; layout(triangle_strip, max_vertices = 128) out;
                 void main() { for (int i = 0; i < 128; i++) {
                   gl_Position = vec4((i & 1) * 2 - 1, (i & 2) - 1, 0.0, 1.0); EmitVertex(); } }",
            ),
            (GL_FRAGMENT_SHADER, "void main() { gl_FragColor = vec4(0.001); }"),
        ];
        use_stages(c, &sources);
        c.draw_arrays(GL_POINTS, 0, 60_000);
    }),
];

/// Draws vertices of a buffer, anywhere in the window, onto each other.
fn held(c: &mut Context, mode: GLenum, count: GLsizei) {
    let places = (0..2 * count as u32).map(|at| at.wrapping_mul(2_654_435_761) as i32);
    buffer(c, 2, &places.flat_map(i32::to_le_bytes).collect::<Vec<_>>());
    use_program(
        c,
        "attribute vec2 p; void main() { gl_Position = vec4(p, 0.0, 1.0); }",
        "void main() { gl_FragColor = vec4(0.001); }",
    );
    c.vertex_attrib_pointer(0, 2, GL_INT, true, 0, Data::Offset(0));
    c.enable_vertex_attrib_array(0);
    c.draw_arrays(mode, 0, count);
}

/// With a hundredth of the budget, so that the test does not take as long as such a draw may.
#[test]
fn draws_that_memory_holds_end_and_the_context_goes_on() {
    for (name, draw) in HELD {
        let desc = DeviceDesc { budget: 1 << 20, ..DeviceDesc::new(Isa::best(), 2) };
        let device = Some(Arc::new(Device::new(desc).expect("a device")));
        let desc = ContextDesc { width: 512, height: 512, device, ..ContextDesc::default() };
        let mut c = Context::new(desc).expect("a context");
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        stops_soon(name, &mut c, draw);
    }
}

/// Draws, which takes no longer than it may and is stopped once.
fn stops_soon(name: &str, c: &mut Context, draw: impl Fn(&mut Context)) {
    let start = CpuTime::begin();
    draw(c);
    c.finish();
    let elapsed = start.elapsed();
    println!("{name}: {elapsed:?}");
    assert!(elapsed < SOON, "{name}: {elapsed:?}");
    assert_eq!((stops(c), c.get_error()), (1, GL_NO_ERROR), "{name}: {:?}", c.messages());
}

fn stops(c: &mut Context) -> usize {
    c.messages().iter().filter(|message| message.text.contains(STOPPED)).count()
}

#[test]
fn they_end_soon_and_the_context_goes_on() {
    for (name, draw) in ENDLESS {
        let mut c = context(2, Isa::best());
        stops_soon(name, &mut c, draw);
        c.use_program(0);
        c.color_3f(0.0, 1.0, 0.0);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        assert!(picture(&mut c).chunks(4).all(|pixel| pixel == [0, 255, 0, 255]), "{name}");
    }
}

/// A context with `GL_LOSE_CONTEXT_ON_RESET` (`ARB_robustness`).
fn robust_context() -> Context {
    let desc = ContextDesc {
        width: SIZE,
        height: SIZE,
        reset_notification: ResetNotification::LoseContextOnReset,
        ..ContextDesc::default()
    };
    Context::new(desc).expect("a context")
}

#[test]
fn a_robust_context_reports_a_stopped_draw_as_a_reset() {
    let mut c = robust_context();
    use_numbers(&mut c, "2.0, 2.0");
    c.draw_arrays(GL_POINTS, 0, 1 << 20);
    c.finish();
    assert_eq!(c.get_graphics_reset_status(), GL_NO_ERROR);
    c.draw_arrays(GL_POINTS, 0, MANY);
    c.finish();
    assert_eq!(c.get_graphics_reset_status(), GL_GUILTY_CONTEXT_RESET);
    assert_eq!(c.get_graphics_reset_status(), GL_NO_ERROR);
}

/// Instances that scenes may have, of fragments that are shaded at each sample: the draw ends by what these take.
#[test]
fn instances_that_shade_each_sample_end() {
    for (name, corners) in [
        ("large", [-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0]),
        ("small", [0.0, 0.0, 0.05, 0.0, 0.0, 0.05]),
    ] {
        let surface = SurfaceDesc { samples: 4, ..SurfaceDesc::default() };
        let desc = ContextDesc { width: SIZE, height: SIZE, surface, ..ContextDesc::default() };
        let mut c = Context::new(desc).expect("a context");
        buffer(&mut c, 1, &corners.map(f32::to_le_bytes).concat());
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.enable(GL_SAMPLE_SHADING);
        c.min_sample_shading(1.0);
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        c.color_3f(0.01, 0.0, 0.0);
        let start = CpuTime::begin();
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, 20_000_000);
        c.finish();
        println!("{name}: {:?}", start.elapsed());
        assert_eq!(stops(&mut c), 1, "{name}");
    }
}

/// A geometry shader makes 256 vertices of each, which nobody sees.
#[test]
fn what_a_geometry_shader_makes_of_many_ends_soon() {
    let mut c = context(2, Isa::best());
    let sources = [
        (GL_VERTEX_SHADER, "#version 150 compatibility\nvoid main() { gl_Position = vec4(2.0); }"),
        (
            GL_GEOMETRY_SHADER,
            "#version 150 compatibility\nlayout(points) in; layout(points, max_vertices = 256) out;
             void main() { for (int i = 0; i < 256; i++) { gl_Position = vec4(2.0); EmitVertex(); } }",
        ),
        (GL_FRAGMENT_SHADER, FRAGMENT),
    ];
    use_stages(&mut c, &sources);
    c.disable_client_state(GL_VERTEX_ARRAY);
    let start = CpuTime::begin();
    c.draw_arrays(GL_POINTS, 0, MANY);
    c.finish();
    println!("{:?}", start.elapsed());
    assert!(start.elapsed() < SOON);
    assert_eq!((stops(&mut c), c.get_error()), (1, GL_NO_ERROR), "{:?}", c.messages());
    // To count what it makes, every primitive would have to be run one after the other.
    c.begin_query(GL_PRIMITIVES_GENERATED, 1);
    c.draw_arrays(GL_POINTS, 0, MANY);
    c.end_query(GL_PRIMITIVES_GENERATED);
    assert_eq!(c.get_error(), GL_OUT_OF_MEMORY, "{:?}", c.messages());
}

/// What is left of a draw depends on neither threads nor instruction set.
#[test]
fn what_is_left_of_a_draw_is_the_same_everywhere() {
    let ways = Isa::available().into_iter().flat_map(|isa| [1, 2, 8].map(|threads| (isa, threads)));
    let mut all = ways.map(|(isa, threads)| {
        let mut c = context(threads, isa);
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        use_numbers(&mut c, "fract(n * 1e-4), 1e-7 * n");
        c.draw_arrays(GL_POINTS, 0, MANY);
        let left = picture(&mut c);
        assert_eq!(stops(&mut c), 1);
        left
    });
    let first = all.next().expect("an instruction set");
    assert!(first.chunks(4).any(|pixel| pixel[0] == 255));
    assert!(all.all(|other| other == first));
}

/// Points along a line, as many as the budget lets them, in red on blue.
fn draw_endless_points(c: &mut Context) {
    c.enable(GL_BLEND);
    c.blend_func(GL_ONE, GL_ONE);
    use_numbers(c, "fract(n * 1e-4), 1e-7 * n");
    c.draw_arrays(GL_POINTS, 0, MANY);
    c.disable(GL_BLEND);
}

/// A loop of some 200,000 operations, which alone is free.
fn draw_long_loop(c: &mut Context) {
    use_program(
        c,
        "void main() { gl_Position = gl_Vertex; }",
        "void main() { float s = gl_FragCoord.x; for (int i = 0; i < 20000; i++) s = fract(s * 1.7 + 0.3);
         gl_FragColor = vec4(1.0, 0.001 * s, 0.0, 1.0); }",
    );
    c.rectf(-1.0, -1.0, 1.0, 1.0);
}

/// A loop that does not end.
fn draw_endless_loop(c: &mut Context) {
    use_program(
        c,
        "void main() { gl_Position = gl_Vertex; }",
        "uniform float n; void main() { float s = n; while (s >= 0.0) s = fract(s + 0.3); gl_FragColor = vec4(s); }",
    );
    c.rectf(-1.0, -1.0, 1.0, 1.0);
}

fn clear(c: &mut Context) {
    c.clear(GL_COLOR_BUFFER_BIT);
}

/// How many pixels of the picture are red. Reading it ends the frame.
fn red_pixels(c: &mut Context) -> usize {
    picture(c).chunks(4).filter(|pixel| pixel[0] == 255).count()
}

/// A flush gives no draw a new budget; the end of a frame does.
#[test]
fn draws_of_a_frame_share_a_budget_across_flushes() {
    for hostile in [draw_endless_points, draw_endless_loop] {
        let mut c = context(2, Isa::best());
        draw_endless_points(&mut c);
        let alone = red_pixels(&mut c);
        assert!(alone > 0);
        clear(&mut c);
        hostile(&mut c);
        c.flush();
        clear(&mut c);
        for _ in 0..3 {
            draw_endless_points(&mut c);
            c.flush();
        }
        assert!(red_pixels(&mut c) < alone / 8, "there was no budget left");
        // The picture was read, so that the next frame has begun.
        clear(&mut c);
        draw_endless_points(&mut c);
        assert_eq!(red_pixels(&mut c), alone);
    }
}

/// Loops that are free in other frames are stopped in one that has spent its budget, in the pass and after it.
#[test]
fn a_frame_that_has_spent_its_budget_has_little_for_loops() {
    let whole = (SIZE * SIZE) as usize;
    for threads in [1, 4] {
        let mut c = context(threads, Isa::best());
        draw_long_loop(&mut c);
        assert_eq!((red_pixels(&mut c), stops(&mut c)), (whole, 0));
        clear(&mut c);
        for _ in 0..8 {
            draw_endless_loop(&mut c);
        }
        draw_long_loop(&mut c);
        c.flush();
        draw_long_loop(&mut c);
        assert_eq!(red_pixels(&mut c), 0);
        // What takes no loop is drawn, and short loops are.
        c.use_program(0);
        c.color_3f(1.0, 0.0, 0.0);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        assert_eq!(red_pixels(&mut c), whole);
        clear(&mut c);
        c.finish();
        draw_long_loop(&mut c);
        assert_eq!(red_pixels(&mut c), whole);
    }
}

/// 200 draws that do not end, each with a flush, take little more than one.
#[test]
fn many_endless_draws_end_soon() {
    for hostile in [draw_endless_points, draw_endless_loop] {
        let mut c = context(2, Isa::best());
        let start = CpuTime::begin();
        for _ in 0..200 {
            hostile(&mut c);
            c.flush();
        }
        println!("{:?}", start.elapsed());
        assert!(start.elapsed() < SOON);
    }
}

/// After a stopped draw, the end of a frame gives no budget until `glGetGraphicsResetStatus` was called.
#[test]
fn a_robust_context_has_no_budget_until_it_has_asked() {
    let mut c = robust_context();
    draw_endless_points(&mut c);
    let alone = red_pixels(&mut c);
    for _ in 0..3 {
        clear(&mut c);
        c.finish();
        draw_endless_points(&mut c);
        assert!(red_pixels(&mut c) < alone / 8);
    }
    assert_eq!(c.get_graphics_reset_status(), GL_GUILTY_CONTEXT_RESET);
    clear(&mut c);
    draw_endless_points(&mut c);
    assert_eq!(red_pixels(&mut c), alone);
}

/// The picture of a frame of hostile draws depends on neither threads nor instruction set.
#[test]
fn what_is_left_of_a_frame_is_the_same_everywhere() {
    let ways = Isa::available().into_iter().flat_map(|isa| [1, 2, 8].map(|threads| (isa, threads)));
    let mut all = ways.map(|(isa, threads)| {
        let mut c = context(threads, isa);
        // Ends at the right only, after a number of iterations that depends on the pixel.
        use_program(
            &mut c,
            "void main() { gl_Position = gl_Vertex; }",
            "void main() { float s = gl_FragCoord.x * gl_FragCoord.y * 100.0; float t = 0.1;
             while (s > 0.0) { s -= 1.0; t = fract(t * 1.7 + 0.3); }
             gl_FragColor = vec4(1.0, t, 0.0, 1.0); }",
        );
        for _ in 0..3 {
            c.rectf(-1.0, -1.0, 0.9, 1.0);
            c.rectf(-0.9, -1.0, 1.0, 0.9);
            c.flush();
        }
        draw_endless_points(&mut c);
        let left = picture(&mut c);
        assert!(stops(&mut c) > 0);
        left
    });
    let first = all.next().expect("an instruction set");
    assert!(first.chunks(4).any(|pixel| pixel[0] == 255));
    assert!(all.all(|other| other == first));
}

/// What scenes have.
const SCENES: &[Case] = &[
    ("a mesh of 500 triangles, 10,000 times", |c| {
        let corners = (0..3000).map(|at| (at * 37 % 101) as f32 * 0.01);
        buffer(c, 1, &corners.map(f32::to_le_bytes).collect::<Vec<_>>().concat());
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 1500, 10_000);
    }),
    ("20,000 instances with an array", |c| {
        let (count, step) = (20_000, 1.0 / 20_000.0);
        let places = (0..count).map(|at| (at as f32 * step).to_le_bytes());
        let program = use_program(
            c,
            "#version 130\nin float place; void main() {
             gl_Position = vec4(0.01 * gl_Vertex.xy + 2.0 * place - 1.0, 0.0, 1.0); }",
            FRAGMENT,
        );
        let location = c.get_attrib_location(program, "place") as GLuint;
        buffer(c, 2, &places.collect::<Vec<_>>().concat());
        c.vertex_attrib_pointer(location, 1, GL_FLOAT, false, 0, Data::Offset(0));
        c.vertex_attrib_divisor(location, 1);
        c.enable_vertex_attrib_array(location);
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, count);
    }),
    ("4000 instances of the whole window", |c| c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, 4000)),
    ("16 million points by number", |c| {
        use_numbers(c, "fract(n * 0.001), 0.0");
        c.draw_arrays(GL_POINTS, 0, 1 << 24);
    }),
    ("100 million vertices of a buffer", |c| {
        let bytes = vec![0; 200 << 20];
        buffer(c, 1, &bytes);
        c.disable_client_state(GL_VERTEX_ARRAY);
        c.vertex_attrib_pointer(0, 2, GL_BYTE, false, 0, Data::Offset(0));
        c.enable_vertex_attrib_array(0);
        c.draw_arrays(GL_TRIANGLES, 0, 100 << 20);
        c.rectf(0.0, 0.0, 1.0, 1.0);
    }),
    ("a loop in a fragment shader, by instances", |c| {
        use_program(
            c,
            "#version 130\nvoid main() { gl_Position = gl_Vertex; }",
            "void main() { float s = gl_FragCoord.x; for (int i = 0; i < 500; i++) s = fract(s * 1.7);
             gl_FragColor = vec4(1.0, 0.0 * s, 0.0, 1.0); }",
        );
        c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, 200);
    }),
];

#[test]
fn scenes_are_drawn_whole() {
    for (name, draw) in SCENES {
        let mut c = context(2, Isa::best());
        c.color_3f(1.0, 0.0, 0.0);
        let start = CpuTime::begin();
        draw(&mut c);
        c.finish();
        println!("{name}: {:?}", start.elapsed());
        assert_eq!((stops(&mut c), c.get_error()), (0, GL_NO_ERROR), "{name}: {:?}", c.messages());
        let drawn = picture(&mut c).chunks(4).any(|pixel| pixel == [255, 0, 0, 255]);
        assert!(drawn, "{name}");
    }
}
