//! Assembly programs beside the fixed function, beside GLSL, and beside one another.

use super::{context, drawn, load, near, pixel};
use gl_api::*;

const VERTEX: &str = "!!ARBvp1.0\nMOV result.position, vertex.position;\n";
const TWICE: &str = "!!ARBfp1.0\nADD result.color, fragment.color, fragment.color;\nEND";

fn linked(c: &mut Context, stages: &[(GLenum, &str)]) -> GLuint {
    let program = c.create_program();
    for &(stage, text) in stages {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![text]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    program
}

#[test]
fn each_stage_is_the_fixed_function_until_it_is_enabled() {
    let mut c = context();
    c.color_4f(0.25, 0.5, 0.125, 1.0);
    load(&mut c, TWICE);
    load(&mut c, &format!("{VERTEX}MOV result.color, vertex.color.yxzw;\nEND"));
    assert_eq!(drawn(&mut c), [1.0, 0.5, 0.25, 2.0]);
    c.disable(GL_VERTEX_PROGRAM_ARB);
    assert_eq!(drawn(&mut c), [0.5, 1.0, 0.25, 2.0]);
    c.disable(GL_FRAGMENT_PROGRAM_ARB);
    assert_eq!(drawn(&mut c), [0.25, 0.5, 0.125, 1.0]);
    c.enable(GL_VERTEX_PROGRAM_ARB);
    assert_eq!(drawn(&mut c), [0.5, 0.25, 0.125, 1.0]);
}

#[test]
fn stages_of_the_program_in_use_come_first() {
    let mut c = context();
    let vertex = "uniform vec4 u;\n\
        void main() { gl_Position = gl_Vertex; gl_FrontColor = u; }";
    let fragment = "uniform vec4 u;\nvoid main() { gl_FragColor = gl_Color + u; }";
    let both = linked(&mut c, &[(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)]);
    let first = linked(&mut c, &[(GL_VERTEX_SHADER, vertex)]);
    let second = linked(&mut c, &[(GL_FRAGMENT_SHADER, fragment)]);
    for program in [both, first, second] {
        c.use_program(program);
        c.uniform_4f(0, 0.5, 0.25, 0.0, 1.0);
    }
    // Each has parameters, whose words lie beside those of the uniforms.
    load(&mut c, &format!("{VERTEX}ADD result.color, program.local[0], {{0, 0, 0, 1}};\nEND"));
    load(&mut c, "!!ARBfp1.0\nADD result.color, fragment.color, program.env[0];\nEND");
    c.program_local_parameter_4f(GL_VERTEX_PROGRAM_ARB, 0, 0.125, 0.0, 0.0, 0.0);
    c.program_env_parameter_4f(GL_FRAGMENT_PROGRAM_ARB, 0, 0.0, 0.0, 3.0, 0.0);
    for (program, expected) in [
        (both, [1.0, 0.5, 0.0, 2.0]),
        (first, [0.5, 0.25, 3.0, 1.0]),
        (second, [0.625, 0.25, 0.0, 2.0]),
        (0, [0.125, 0.0, 3.0, 1.0]),
    ] {
        c.use_program(program);
        assert_eq!(drawn(&mut c), expected, "{program}");
    }
}

#[test]
fn a_program_without_a_text_draws_nothing_and_is_an_error() {
    for target in [GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB] {
        let mut c = context();
        c.bind_program(target, 7);
        let text = "!!ARBvp1.0 MOV;";
        c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, text);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        c.enable(target);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        c.begin(GL_TRIANGLES);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        c.end();
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "glBegin was refused");
        // A text that does not load leaves the one before.
        load(&mut c, if target == GL_VERTEX_PROGRAM_ARB { "!!ARBvp1.0 END" } else { TWICE });
        c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, text);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        assert_eq!(c.get_error(), GL_NO_ERROR);
    }
}

#[test]
fn an_invariant_position_is_the_fixed_functions_to_the_bit() {
    let mut c = Context::new(ContextDesc { width: 64, height: 64, ..ContextDesc::default() })
        .expect("a device");
    c.matrix_mode(GL_PROJECTION);
    c.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 20.0);
    c.matrix_mode(GL_MODELVIEW);
    c.translatef(0.0, 0.0, -5.0);
    c.rotatef(37.0, 1.0, 0.3, 0.7);
    c.enable(GL_DEPTH_TEST);
    c.clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    c.color_3f(1.0, 0.0, 0.0);
    c.rectf(-4.0, -4.0, 4.0, 4.0);
    c.depth_func(GL_EQUAL);
    load(
        &mut c,
        "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, {0, 1, 0, 1};\nEND",
    );
    c.rectf(-4.0, -4.0, 4.0, 4.0);
    let mut pixels = vec![[0_u8; 4]; 64 * 64];
    c.read_pixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.as_mut_slice().arg());
    assert!(pixels.iter().all(|pixel| pixel[0] == 0));
    assert!(pixels.iter().filter(|pixel| pixel[1] == 255).count() > 1000);
}

#[test]
fn clip_planes_cut_invariant_positions_alone() {
    for (option, kept) in [("OPTION ARB_position_invariant;", false), ("", true)] {
        let mut c = context();
        c.matrix_mode(GL_PROJECTION);
        c.scalef(1.0, 1.0, 0.5);
        c.clip_plane(GL_CLIP_PLANE1, &[1.0, 0.0, 0.0, -0.25]);
        c.enable(GL_CLIP_PLANE1);
        let position = if kept { "MOV result.position, vertex.position;" } else { "" };
        load(&mut c, &format!("!!ARBvp1.0\n{option}\n{position}\nMOV result.color, 1;\nEND"));
        let left = drawn(&mut c);
        assert_eq!(left == [1.0; 4], kept, "{option}");
        let mut right = [0.0_f32; 4];
        c.read_pixels(3, 0, 1, 1, GL_RGBA, GL_FLOAT, (&mut right).arg());
        assert_eq!(right, [1.0; 4], "{option}");
    }
}

#[test]
fn fog_comes_as_the_option_says() {
    let exp = |x: f32| (-f64::from(x)).exp() as f32;
    for (option, clear) in
        [("ARB_fog_linear", 0.75), ("ARB_fog_exp", exp(0.5 * 4.0)), ("ARB_fog_exp2", exp(4.0))]
    {
        let mut c = context();
        c.fogfv(GL_FOG_COLOR, &[0.0, 1.0, 0.5, 0.0]);
        c.fogf(GL_FOG_DENSITY, 0.5);
        c.fogf(GL_FOG_START, 2.0);
        c.fogf(GL_FOG_END, 10.0);
        c.fogi(GL_FOG_COORD_SRC, GL_FOG_COORD as GLint);
        c.fog_coordf(4.0);
        load(
            &mut c,
            &format!("!!ARBfp1.0\nOPTION {option};\nMOV result.color, {{3, -1, 1, 0.5}};\nEND"),
        );
        // What is in fog is held in [0, 1] before.
        let expected = [clear, 1.0 - clear, 0.5 + 0.5 * clear, 0.5];
        let found = drawn(&mut c);
        assert!(near(found, expected), "{option}: {found:?} {expected:?}");
    }
}

#[test]
fn colours_have_two_sides_where_that_is_enabled() {
    let mut c = context();
    load(
        &mut c,
        &format!(
            "{VERTEX}MOV result.color, {{1, 0, 0, 1}};\n\
             MOV result.color.back.primary, {{0, 1, 0, 1}};\nEND"
        ),
    );
    c.front_face(GL_CW);
    assert_eq!(drawn(&mut c), [1.0, 0.0, 0.0, 1.0]);
    c.enable(GL_VERTEX_PROGRAM_TWO_SIDE);
    assert_eq!(drawn(&mut c), [0.0, 1.0, 0.0, 1.0]);
    c.front_face(GL_CCW);
    assert_eq!(drawn(&mut c), [1.0, 0.0, 0.0, 1.0]);
}

#[test]
fn points_are_as_large_as_the_program_says_where_that_is_enabled() {
    let mut c = context();
    load(&mut c, &format!("{VERTEX}MOV result.pointsize.x, 8;\nMOV result.color, 1;\nEND"));
    for (large, expected) in [(false, [0.0; 4]), (true, [1.0; 4])] {
        c.clear(GL_COLOR_BUFFER_BIT);
        if large {
            c.enable(GL_VERTEX_PROGRAM_POINT_SIZE);
        }
        c.begin(GL_POINTS);
        c.vertex_2f(0.0, 0.0);
        c.end();
        assert_eq!(pixel(&mut c), expected);
    }
}

#[test]
fn the_depth_is_z_of_its_result_and_the_alpha_test_comes_after() {
    let mut c = Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() })
        .expect("a device");
    c.enable(GL_DEPTH_TEST);
    c.clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    load(&mut c, "!!ARBfp1.0\nMOV result.color, 1;\nMOV result.depth, {0, 1, 0.25, 0};\nEND");
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    let mut depth = [0.0_f32];
    c.read_pixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, (&mut depth).arg());
    assert!((depth[0] - 0.25).abs() < 1e-6, "{depth:?}");
    c.disable(GL_DEPTH_TEST);
    c.enable(GL_ALPHA_TEST);
    c.alpha_func(GL_LESS, 0.5);
    load(&mut c, "!!ARBfp1.0\nMOV result.color, {0, 0, 0, 0.75};\nEND");
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    let mut color = [0_u8; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, (&mut color).arg());
    assert_eq!(color[0], 255);
}

#[test]
fn fragments_know_where_they_are() {
    for (option, expected) in [
        ("", [0.5, 0.5, 0.5, 1.0]),
        ("OPTION ARB_fragment_coord_origin_upper_left;", [0.5, 3.5, 0.5, 1.0]),
        ("OPTION ARB_fragment_coord_pixel_center_integer;", [0.0, 0.0, 0.5, 1.0]),
    ] {
        let mut c = context();
        load(&mut c, &format!("!!ARBfp1.0\n{option}\nMOV result.color, fragment.position;\nEND"));
        assert_eq!(drawn(&mut c), expected, "{option}");
    }
}

#[test]
fn each_draw_buffer_has_a_colour_of_its_own_or_all_have_one() {
    let options = [
        ("OPTION ARB_draw_buffers;", "MOV result.color[1], 3;", [2.0, 3.0]),
        ("OPTION ATI_draw_buffers;", "MOV result.color[1], 3;", [2.0, 3.0]),
        ("", "", [2.0, 2.0]),
    ];
    for (option, second, expected) in options {
        let mut c = context();
        c.bind_renderbuffer(GL_RENDERBUFFER, 2);
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA32F, 4, 4);
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_RENDERBUFFER, 2);
        c.draw_buffers(2, &[GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1]);
        load(&mut c, &format!("!!ARBfp1.0\n{option}\nMOV result.color, 2;\n{second}\nEND"));
        let first = drawn(&mut c)[0];
        c.read_buffer(GL_COLOR_ATTACHMENT1);
        assert_eq!([first, pixel(&mut c)[0]], expected, "{option}");
    }
}

/// A texture of four texels in a row on unit 3: red is 0, 1/4, 1/2, 3/4.
fn textured(c: &mut Context, format: GLenum, data: GLenum) {
    c.active_texture(GL_TEXTURE3);
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    let texels = [0.0_f32, 0.25, 0.5, 0.75];
    let target = GL_TEXTURE_2D;
    c.tex_image_2d(target, 0, format as GLint, 4, 1, 0, data, GL_FLOAT, (&texels).arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn textures_are_looked_up_on_their_units() {
    for (lookup, expected) in [
        ("TEX r, {0.3, 0.5, 0, 9}, texture[3], 2D;", 0.25),
        ("TXP r, {1.8, 1, 0, 2}, texture[3], 2D;", 0.75),
        ("TXB r, {0.6, 0.5, 0, 1}, texture[3], 2D;", 0.5),
        ("TEX r, {0.6, 0.5, 0, 1}, texture[2], 2D;", 0.0),
    ] {
        let mut c = context();
        textured(&mut c, GL_R32F, GL_RED);
        load(&mut c, &format!("!!ARBfp1.0\nTEMP r;\n{lookup}\nMOV result.color, r;\nEND"));
        assert_eq!(drawn(&mut c)[0], expected, "{lookup}");
    }
}

#[test]
fn shadows_compare_with_r_where_the_program_says_so() {
    for (option, lookup, expected) in [
        (
            "OPTION ARB_fragment_program_shadow;",
            "TEX r, {0.6, 0.5, 0.4, 1}, texture[3], SHADOW2D;",
            1.0,
        ),
        (
            "OPTION ARB_fragment_program_shadow;",
            "TEX r, {0.6, 0.5, 0.6, 1}, texture[3], SHADOW2D;",
            0.0,
        ),
        (
            "OPTION ARB_fragment_program_shadow;",
            "TXP r, {1.2, 1, 0.8, 2}, texture[3], SHADOW2D;",
            1.0,
        ),
        // Without it the mode of comparison does not count.
        ("", "TEX r, {0.6, 0.5, 0.6, 1}, texture[3], 2D;", 0.5),
    ] {
        let mut c = context();
        textured(&mut c, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
        let mode = GL_COMPARE_REF_TO_TEXTURE as GLint;
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, mode);
        load(
            &mut c,
            &format!("!!ARBfp1.0\n{option}\nTEMP r;\n{lookup}\nMOV result.color, r;\nEND"),
        );
        assert_eq!(drawn(&mut c)[0], expected, "{lookup}");
    }
}

#[test]
fn raster_positions_and_rectangles_of_pixels_go_through_programs() {
    let mut c = context();
    load(
        &mut c,
        "!!ARBvp1.0\nADD result.position, vertex.position, {-1, -1, 0, 0};\n\
        MOV result.color, {0, 0, 0, 0};\nEND",
    );
    load(&mut c, "!!ARBfp1.0\nADD result.color, fragment.color, {0, 2, 0, 0};\nEND");
    c.raster_pos_2f(0.0, 0.0);
    let texel = [0.5_f32, 0.25, 0.0, 1.0];
    c.draw_pixels(1, 1, GL_RGBA, GL_FLOAT, (&texel).arg());
    assert_eq!(pixel(&mut c), [0.5, 2.25, 0.0, 1.0]);
}
