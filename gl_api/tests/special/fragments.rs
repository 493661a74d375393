//! What happens to fragments: logical operations, blend equations, draw buffers, depth range, polygon
//! offset; and the arrays that are seldom enabled.

use super::shading::use_program;
use super::{ALL, context, draw, fine, pixel};
use gl_api::*;

/// A logical operation and what it does (GL 2.1, table 4.3).
type Operation = (GLenum, fn(u8, u8) -> u8);

const OPERATIONS: [Operation; 16] = [
    (GL_CLEAR, |_, _| 0),
    (GL_AND, |s, d| s & d),
    (GL_AND_REVERSE, |s, d| s & !d),
    (GL_COPY, |s, _| s),
    (GL_AND_INVERTED, |s, d| !s & d),
    (GL_NOOP, |_, d| d),
    (GL_XOR, |s, d| s ^ d),
    (GL_OR, |s, d| s | d),
    (GL_NOR, |s, d| !(s | d)),
    (GL_EQUIV, |s, d| !(s ^ d)),
    (GL_INVERT, |_, d| !d),
    (GL_OR_REVERSE, |s, d| s | !d),
    (GL_COPY_INVERTED, |s, _| !s),
    (GL_OR_INVERTED, |s, d| !s | d),
    (GL_NAND, |s, d| !(s & d)),
    (GL_SET, |_, _| 0xFF),
];

/// Clears to bytes.
fn clear(c: &mut Context, color: [u8; 4]) {
    let [r, g, b, a] = color.map(|byte| f32::from(byte) / 255.0);
    c.clear_color(r, g, b, a);
    c.clear(GL_COLOR_BUFFER_BIT);
}

/// The distance of a raster position is what fog takes it for (GL 2.1, section 2.13).
#[test]
fn the_distance_of_a_raster_position_is_that_of_the_fog() {
    let mut c = context(4, 4);
    c.fog_coordf(-9.0);
    let distance = |c: &mut Context| {
        let mut distance = [f32::NAN];
        c.get_floatv(GL_CURRENT_RASTER_DISTANCE, &mut distance);
        distance[0]
    };
    for (source, of_window, of_depth) in
        [(GL_FRAGMENT_DEPTH, 0.0, 0.75), (GL_FOG_COORD, -9.0, -9.0)]
    {
        c.fogi(GL_FOG_COORD_SRC, source as i32);
        for z in [-0.75, 0.75] {
            c.raster_pos_3f(0.0, 0.0, z);
            assert_eq!(distance(&mut c), of_depth, "{z}, {}", enum_name(source));
            c.window_pos_3f(0.0, 0.0, z);
            assert_eq!(distance(&mut c), of_window, "{z}, {}", enum_name(source));
        }
    }
    // Pixels at no distance are in no fog.
    c.enable(GL_FOG);
    c.fogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH as i32);
    c.window_pos_2i(1, 1);
    c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[255; 4]));
    assert_eq!(pixel(&mut c, 1, 1), [255; 4]);
}

#[test]
fn every_logical_operation_does_to_bits_what_its_table_says() {
    let (source, stored) = ([0x0F, 0x33, 0xFF, 0xA5], [0x3C, 0x55, 0x00, 0x99]);
    let mut c = context(1, 1);
    c.enable(GL_COLOR_LOGIC_OP);
    // Blending is off then.
    c.enable(GL_BLEND);
    c.blend_func(GL_ZERO, GL_ZERO);
    for (name, operation) in OPERATIONS {
        clear(&mut c, stored);
        c.logic_op(name);
        c.color_4ubv(&source);
        draw(&mut c, GL_QUADS, &ALL);
        let want: [u8; 4] = std::array::from_fn(|i| operation(source[i], stored[i]));
        assert_eq!(pixel(&mut c, 0, 0), want, "{}", enum_name(name));
    }
}

/// A blend equation, and what it makes of source and stored value with the factors of the test.
type Equation = (GLenum, fn(f64, f64) -> f64);

#[test]
fn colour_and_alpha_have_blend_equations_of_their_own() {
    let (source, stored) = ([0.25, 0.5, 0.75, 0.5], [0.5, 0.5, 0.25, 0.25]);
    let equations: [Equation; 5] = [
        (GL_FUNC_ADD, |s, d| s * 0.5 + d),
        (GL_FUNC_SUBTRACT, |s, d| s * 0.5 - d),
        (GL_FUNC_REVERSE_SUBTRACT, |s, d| d - s * 0.5),
        (GL_MIN, f64::min),
        (GL_MAX, f64::max),
    ];
    let mut c = context(1, 1);
    c.enable(GL_BLEND);
    c.blend_color(0.5, 0.5, 0.5, 0.5);
    c.blend_func(GL_CONSTANT_COLOR, GL_ONE);
    for (color_name, color) in equations {
        for (alpha_name, alpha) in equations {
            let byte = |value: f64| (value.clamp(0.0, 1.0) * 255.0).round();
            clear(&mut c, stored.map(|value| byte(value) as u8));
            c.blend_equation_separate(color_name, alpha_name);
            c.color_4dv(&source);
            draw(&mut c, GL_QUADS, &ALL);
            for (i, got) in pixel(&mut c, 0, 0).into_iter().enumerate() {
                let equation = if i < 3 { color } else { alpha };
                let want = byte(equation(source[i], byte(stored[i]) / 255.0));
                let name = format!("{} {}", enum_name(color_name), enum_name(alpha_name));
                assert!((f64::from(got) - want).abs() <= 1.0, "{name}: {got}, not {want}");
            }
        }
    }
}

#[test]
fn draw_buffers_take_the_fragment_data_of_their_number() {
    let mut c = context(1, 1);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    for at in 0..3 {
        c.bind_renderbuffer(GL_RENDERBUFFER, at + 1);
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
        let point = GL_COLOR_ATTACHMENT0 + at;
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, at + 1);
    }
    c.draw_buffers(3, &[GL_COLOR_ATTACHMENT2, GL_NONE, GL_COLOR_ATTACHMENT0]);
    let fragment = "void main() {
        gl_FragData[0] = vec4(1.0, 0.0, 0.0, 1.0);
        gl_FragData[1] = vec4(0.0, 1.0, 0.0, 1.0);
        gl_FragData[2] = vec4(0.0, 0.0, 1.0, 1.0);
        gl_FragDepth = 0.5; }";
    use_program(&mut c, "", fragment);
    draw(&mut c, GL_QUADS, &ALL);
    for (at, want) in [(0, [0, 0, 255, 255]), (1, [0; 4]), (2, [255, 0, 0, 255])] {
        c.read_buffer(GL_COLOR_ATTACHMENT0 + at);
        assert_eq!(pixel(&mut c, 0, 0), want, "{at}");
    }
}

/// The depth of a pixel.
fn depth(c: &mut Context) -> f32 {
    let mut depth = [0.0_f32];
    let out = DataOut::Bytes(bytemuck::cast_slice_mut(&mut depth));
    c.read_pixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, out);
    fine(c);
    depth[0]
}

#[test]
fn depths_are_mapped_to_their_range_and_moved_by_the_offset_of_their_mode() {
    // So many smallest differences of 2^-23 are an eighth.
    const UNITS: f32 = 1_048_576.0;
    let modes = [
        (GL_FILL, GL_POLYGON_OFFSET_FILL),
        (GL_LINE, GL_POLYGON_OFFSET_LINE),
        (GL_POINT, GL_POLYGON_OFFSET_POINT),
    ];
    for (mode, own) in modes {
        for (_, enabled) in modes {
            let mut c = context(1, 1);
            c.enable(GL_DEPTH_TEST);
            c.polygon_mode(GL_FRONT_AND_BACK, mode);
            c.point_size(8.0);
            c.line_width(8.0);
            c.enable(enabled);
            c.polygon_offset(0.0, UNITS);
            c.depth_range(0.25, 0.75);
            c.clear(GL_DEPTH_BUFFER_BIT);
            draw(&mut c, GL_QUADS, &ALL);
            let want = if own == enabled { 0.625 } else { 0.5 };
            let name = format!("{} {}", enum_name(mode), enum_name(enabled));
            assert!((depth(&mut c) - want).abs() < 1e-6, "{name}: {}", depth(&mut c));
        }
    }
    // The slope counts as often as the factor says.
    let mut c = context(1, 1);
    c.enable(GL_DEPTH_TEST);
    c.enable(GL_POLYGON_OFFSET_FILL);
    c.polygon_offset(0.5, 0.0);
    c.clear(GL_DEPTH_BUFFER_BIT);
    draw(&mut c, GL_TRIANGLES, &[[-1.0, -1.0, -0.25], [3.0, -1.0, 0.75], [-1.0, 3.0, -0.25]]);
    // z/w from -1/4 to 1/4 over the pixel: 0.5 in the middle, 0.25 a pixel.
    assert!((depth(&mut c) - (0.5 + 0.5 * 0.25)).abs() < 1e-6, "{}", depth(&mut c));
}

#[test]
fn fog_coordinates_and_secondary_colours_come_from_arrays() {
    let corners: [f32; 8] = [-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0];
    let mut c = context(1, 1);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, 0, corners.as_slice().arg());
    c.enable_client_state(GL_SECONDARY_COLOR_ARRAY);
    c.secondary_color_pointer(3, GL_UNSIGNED_BYTE, 0, [0_u8, 51, 0].repeat(4).as_slice().arg());
    c.enable(GL_COLOR_SUM);
    c.color_3f(1.0, 0.0, 0.0);
    let indices = Data::Bytes(&[0, 1, 2, 3]);
    c.draw_range_elements(GL_QUADS, 0, 3, 4, GL_UNSIGNED_BYTE, indices);
    assert_eq!(pixel(&mut c, 0, 0), [255, 51, 0, 255]);
    c.enable(GL_FOG);
    c.fogi(GL_FOG_COORD_SRC, GL_FOG_COORD as GLint);
    c.fogi(GL_FOG_MODE, GL_LINEAR as GLint);
    c.fogfv(GL_FOG_COLOR, &[0.0, 0.0, 1.0, 0.0]);
    c.enable_client_state(GL_FOG_COORD_ARRAY);
    for (distance, want) in [(0.0_f32, [255, 51, 0, 255]), (1.0, [0, 0, 255, 255])] {
        c.fog_coord_pointer(GL_FLOAT, 0, [distance; 4].as_slice().arg());
        c.draw_arrays(GL_QUADS, 0, 4);
        assert_eq!(pixel(&mut c, 0, 0), want);
    }
}

#[test]
fn interleaved_arrays_have_colours_of_bytes_too() {
    for (format, tex_coord, position) in
        [(GL_C4UB_V2F, 0, 2), (GL_C4UB_V3F, 0, 3), (GL_T2F_C4UB_V3F, 2, 3)]
    {
        let mut bytes = Vec::new();
        for [x, y, z] in ALL {
            bytes.extend([0.5_f32, 0.5].iter().take(tex_coord).flat_map(|t| t.to_ne_bytes()));
            bytes.extend([10_u8, 20, 30, 40]);
            bytes.extend([x, y, z].iter().take(position).flat_map(|p| p.to_ne_bytes()));
        }
        let mut c = context(1, 1);
        c.interleaved_arrays(format, 0, Data::Bytes(&bytes));
        c.draw_arrays(GL_QUADS, 0, 4);
        assert_eq!(pixel(&mut c, 0, 0), [10, 20, 30, 40], "{}", enum_name(format));
        assert_eq!(c.is_enabled(GL_TEXTURE_COORD_ARRAY), tex_coord > 0);
    }
}

/// Its name, and what sets it.
type State = (&'static str, fn(&mut Context));

/// State that changes nothing changes no pixel either where the shader's colour is no number or infinite.
#[test]
fn tests_and_blending_without_effect_keep_fragments_of_any_colour() {
    let states: [State; 4] = [
        ("nothing", |_| {}),
        ("blending with GL_ONE, GL_ZERO", |c| c.enable(GL_BLEND)),
        ("the logical operation GL_COPY", |c| c.enable(GL_COLOR_LOGIC_OP)),
        ("alpha >= 0", |c| {
            c.enable(GL_ALPHA_TEST);
            c.alpha_func(GL_GEQUAL, 0.0);
        }),
    ];
    for color in
        ["0.0 / z, 0.5, 1.0, 0.0 / z", "1.0 / z, -1.0 / z, -0.0, -1.0", "0.3, 0.6, 7.0, 0.25"]
    {
        let source = format!("uniform float z; void main() {{ gl_FragColor = vec4({color}); }}");
        let pictures = states.map(|(_, state)| {
            let mut c = context(4, 4);
            clear(&mut c, [9, 80, 200, 77]);
            use_program(&mut c, "void main() { gl_Position = gl_Vertex; }", &source);
            state(&mut c);
            draw(&mut c, GL_QUADS, &ALL);
            pixel(&mut c, 1, 1)
        });
        for (picture, (name, _)) in pictures.iter().zip(states) {
            assert_eq!(picture, &pictures[0], "{color}: {name}");
        }
        assert_ne!(pictures[0], [9, 80, 200, 77], "{color}");
    }
}
