//! Primitives that are batched into one draw though each has a `glBegin` and `glEnd` of its own: picture, current
//! values, samples passed, feedback, selection and errors are those of one draw for each.

#[path = "common/random.rs"]
mod random;
#[path = "common/shading.rs"]
mod shading;
#[path = "common/switches.rs"]
mod switches;

use gl_api::*;
use proptest::prelude::*;
use random::Random;
use switches::enable_some;

const SIZE: u32 = 32;

/// How primitives are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum DrawMethod {
    /// Each is finished before the next.
    Apart,
    Immediate,
    List,
    ListAtOnce,
    /// A list, while a pixel is watched.
    Watched,
}

fn context(random: &mut Random) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear_color(0.1, 0.2, 0.3, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_BLEND);
    c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    let switches = [GL_LIGHTING, GL_COLOR_MATERIAL, GL_LINE_STIPPLE, GL_DEPTH_TEST, GL_CULL_FACE];
    enable_some(&mut c, random, &switches, 3);
    c.enable(GL_LIGHT0);
    c.line_stipple(2, 0xA53C);
    let parts = [GL_AMBIENT_AND_DIFFUSE, GL_AMBIENT, GL_SPECULAR, GL_EMISSION];
    c.color_material(GL_FRONT_AND_BACK, random.pick(&parts));
    c.polygon_mode(GL_FRONT_AND_BACK, random.pick(&[GL_FILL, GL_FILL, GL_LINE, GL_POINT]));
    c.shade_model(random.pick(&[GL_SMOOTH, GL_FLAT]));
    c.point_size(3.0);
    c
}

/// Sets a value; few different ones, so that some are what they were.
fn attribute(c: &mut Context, random: &mut Random, among: u64) {
    let value = [random.float(), random.pick(&[0.0, 1.0]), 0.5];
    match random.below(among) {
        0 => c.normal_3f(value[0], value[1], 1.0),
        1 => c.color_4f(value[0].abs(), value[1], value[2], random.pick(&[0.25, 1.0])),
        2 => c.edge_flag(random.pick(&[true, false])),
        3 => c.fog_coordf(value[0]),
        _ => c.materialfv(GL_FRONT, GL_DIFFUSE, &[value[0].abs(), value[1], value[2], 0.5]),
    }
}

fn shape(c: &mut Context, random: &mut Random, modes: &[GLenum], set: &[u64]) {
    let (mode, among) = (random.pick(modes), random.pick(&[4, 4, 4, 5]));
    c.begin(mode);
    let each = match mode {
        GL_POINTS => 1,
        GL_LINES => 2,
        GL_TRIANGLES => 3,
        _ => 4,
    };
    let left_over = u64::from(random.below(12) == 0);
    let count = each * random.below(3) + left_over;
    for at in 0..count {
        if random.pick(set) == 0 || (at == 0 && random.below(4) > 0) {
            attribute(c, random, among);
        }
        c.vertex_3f(random.float(), random.float(), random.float());
    }
    c.end();
}

fn shapes(c: &mut Context, random: &mut Random, method: DrawMethod) {
    let modes: &[GLenum] = random.pick(&[
        &[GL_QUADS][..],
        &[GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_FAN],
        &[GL_LINES],
        &[GL_POINTS, GL_LINES, GL_TRIANGLES, GL_QUADS, GL_LINE_STRIP, GL_POLYGON],
    ]);
    let set = random.pick(&[&[0_u64][..], &[0, 1], &[0, 1, 1, 1, 1, 1]]);
    for _ in 0..random.below(12) + 2 {
        shape(c, random, modes, set);
        match random.below(12) {
            0 => attribute(c, random, 5),
            1 => c.translatef(0.1, 0.0, 0.0),
            2 => c.eval_coord1f(0.5),
            _ => {}
        }
        if method == DrawMethod::Apart {
            c.finish();
        }
    }
}

/// Draws shapes by a method.
fn draw_shapes(c: &mut Context, random: &mut Random, method: DrawMethod) {
    match method {
        DrawMethod::Apart | DrawMethod::Immediate => shapes(c, random, method),
        DrawMethod::List | DrawMethod::Watched => {
            c.new_list(1, GL_COMPILE);
            shapes(c, random, method);
            c.end_list();
            c.call_list(1);
        }
        DrawMethod::ListAtOnce => {
            c.new_list(1, GL_COMPILE_AND_EXECUTE);
            shapes(c, random, method);
            c.end_list();
        }
    }
}

/// The numbers of feedback, and the hits of a name.
fn gathered(seed: u64, method: DrawMethod) -> (Vec<f32>, Vec<GLuint>) {
    let gather = |mode| {
        let mut random = Random(seed);
        let mut c = context(&mut random);
        c.feedback_buffer(1 << 14, GL_3D_COLOR, DataOut::Null);
        c.select_buffer(16, DataOut::Null);
        c.render_mode(mode);
        c.init_names();
        c.push_name(7);
        draw_shapes(&mut c, &mut random, method);
        assert!(c.render_mode(GL_RENDER) >= 0);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        (c.feedback().to_vec(), c.selection().to_vec())
    };
    (gather(GL_FEEDBACK).0, gather(GL_SELECT).1)
}

/// The picture, the current colour, normal and edge flag, the samples that passed, and the error.
type Outcome = (Vec<u8>, [[f32; 4]; 3], GLuint, GLenum);

fn outcome(seed: u64, method: DrawMethod) -> Outcome {
    let mut random = Random(seed);
    let c = &mut context(&mut random);
    if method == DrawMethod::Watched {
        c.watch_pixel(SIZE / 2, SIZE / 2).expect("a pixel of the window");
    }
    c.begin_query(GL_SAMPLES_PASSED, 1);
    draw_shapes(c, &mut random, method);
    c.end_query(GL_SAMPLES_PASSED);
    let mut passed = [0];
    c.get_query_objectuiv(1, GL_QUERY_RESULT, &mut passed);
    let mut current = [[0.0; 4]; 3];
    let names = [GL_CURRENT_COLOR, GL_CURRENT_NORMAL, GL_EDGE_FLAG];
    for (name, values) in names.into_iter().zip(&mut current) {
        c.get_floatv(name, values);
    }
    let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
    let size = SIZE as GLsizei;
    c.read_pixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    (pixels, current, passed[0], c.get_error())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_method_gives_the_same_picture(seed: u64) {
        let apart = outcome(seed, DrawMethod::Apart);
        prop_assert_eq!(apart.3, GL_NO_ERROR);
        for method in [DrawMethod::Immediate, DrawMethod::List, DrawMethod::ListAtOnce, DrawMethod::Watched] {
            let other = outcome(seed, method);
            prop_assert_eq!(&other.1, &apart.1, "{:?}", method);
            prop_assert_eq!((other.2, other.3), (apart.2, apart.3), "{:?}", method);
            prop_assert!(other.0 == apart.0, "{:?}: the picture differs", method);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn every_method_gives_the_same_feedback_and_selection(seed: u64) {
        let apart = gathered(seed, DrawMethod::Apart);
        for method in [DrawMethod::Immediate, DrawMethod::List, DrawMethod::ListAtOnce] {
            prop_assert!(gathered(seed, method) == apart, "{:?}", method);
        }
    }
}

/// One quad.
fn quad(c: &mut Context, x: f32) {
    c.begin(GL_QUADS);
    for [x, y] in [[x, -0.5], [x + 0.4, -0.5], [x + 0.4, 0.5], [x, 0.5]] {
        c.vertex_2f(x, y);
    }
    c.end();
}

#[test]
fn primitives_are_not_batched_where_errors_or_numbers_tell() {
    let random = &mut Random(0);
    let c = &mut context(random);
    c.new_list(1, GL_COMPILE);
    (0..3).for_each(|at| quad(c, at as f32 / 2.0 - 1.0));
    c.end_list();
    // A framebuffer without anything attached: each draw is refused.
    c.bind_framebuffer(GL_FRAMEBUFFER, 9);
    let _ = c.messages();
    c.call_list(1);
    assert_eq!(c.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION);
    assert_eq!(c.messages().len(), 3);
    (0..3).for_each(|at| quad(c, at as f32 / 2.0 - 1.0));
    assert_eq!(c.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION);
    assert_eq!(c.messages().len(), 3);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    // A program sees the number of a primitive in its draw.
    for list in [false, true] {
        c.clear(GL_COLOR_BUFFER_BIT);
        let fragment = "#version 120\n#extension GL_EXT_gpu_shader4 : require\n\
            void main() { gl_FragColor = vec4(float(gl_PrimitiveID), 0.0, 0.0, 1.0); }";
        shading::use_program(c, "void main() { gl_Position = gl_Vertex; }", fragment);
        if list {
            c.call_list(1);
        } else {
            (0..3).for_each(|at| quad(c, at as f32 / 2.0 - 1.0));
        }
        for x in [2, 10, 18] {
            let mut pixel = [9; 4];
            c.read_pixels(x, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
            assert_eq!(pixel[0], 0, "a list {list}, at {x}");
        }
    }
}
