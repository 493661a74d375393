//! Bitmaps that are drawn together though each has a call of its own: the picture, the raster position, the
//! samples that passed, what feedback gathers and the errors are those of one draw for each.

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

const SIZE: u32 = 100;
/// The first list, and how many there are.
const LETTERS: (GLuint, GLsizei) = (40, 6);

/// How bitmaps follow one another.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// A call in between that changes nothing.
    Apart,
    Together,
    List,
    ListAtOnce,
    Watched,
}

fn bits(random: &mut Random) -> Vec<u8> {
    (0..700).map(|_| random.pick(&[0, 0xFF, 0xA5, 0x18, random.0 as u8])).collect()
}

fn bitmap(c: &mut Context, random: &mut Random, bits: &[u8]) {
    let [width, height] = [0, 1].map(|_| random.pick(&[0, 1, 8, 8, 9, 13, 31]));
    let [x, y] = [0, 1].map(|_| random.pick(&[0.0, 0.0, 2.0, -3.25, 40.0]));
    let move_x = random.pick(&[width as f32, width as f32 + 1.0, 0.5, -4.0]);
    let move_y = random.pick(&[0.0, 0.0, 0.0, 7.0, -0.75]);
    c.bitmap(width, height, x, y, move_x, move_y, Data::Bytes(bits));
}

fn unpack(c: &mut Context, random: &mut Random) {
    c.pixel_storei(GL_UNPACK_LSB_FIRST, random.below(2) as GLint);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, random.pick(&[1, 2, 4]));
    c.pixel_storei(GL_UNPACK_ROW_LENGTH, random.pick(&[0, 0, 50]));
    c.pixel_storei(GL_UNPACK_SKIP_PIXELS, random.pick(&[0, 0, 3, 9]));
    c.pixel_storei(GL_UNPACK_SKIP_ROWS, random.pick(&[0, 0, 2]));
}

fn context(random: &mut Random) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE - 7, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear_color(0.1, 0.2, 0.3, 1.0);
    c.clear_depth(0.5);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    let switches = [
        GL_BLEND,
        GL_DEPTH_TEST,
        GL_STENCIL_TEST,
        GL_COLOR_LOGIC_OP,
        GL_FOG,
        GL_LIGHTING,
        GL_SCISSOR_TEST,
        GL_ALPHA_TEST,
        GL_TEXTURE_2D,
        GL_COLOR_SUM,
        GL_POLYGON_STIPPLE,
        GL_CULL_FACE,
    ];
    enable_some(&mut c, random, &switches, 4);
    c.enable(GL_LIGHT0);
    c.enable(GL_COLOR_MATERIAL);
    c.blend_func(GL_SRC_ALPHA, random.pick(&[GL_ONE, GL_ONE_MINUS_SRC_ALPHA]));
    c.logic_op(random.pick(&[GL_XOR, GL_INVERT, GL_OR]));
    c.depth_func(random.pick(&[GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER]));
    c.stencil_func(random.pick(&[GL_ALWAYS, GL_EQUAL]), 1, !0);
    c.stencil_op(GL_INCR, GL_INVERT, random.pick(&[GL_INCR, GL_ZERO]));
    c.alpha_func(GL_GREATER, 0.3);
    c.scissor(5, 9, 70, 77);
    c.fogi(GL_FOG_COORDINATE_SOURCE, random.pick(&[GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH]) as GLint);
    let texels: Vec<u8> = (0..64).map(|_| random.0 as u8).collect();
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    let texels = Data::Bytes(&texels);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as GLint, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    for letter in 0..LETTERS.1 {
        let bits = bits(random);
        unpack(&mut c, random);
        c.new_list(LETTERS.0 + letter as GLuint, GL_COMPILE);
        bitmap(&mut c, random, &bits);
        c.end_list();
    }
    c.list_base(LETTERS.0);
    c
}

/// A call between bitmaps, most of which bitmaps wait through.
fn between(c: &mut Context, random: &mut Random) {
    match random.below(16) {
        0 => c.raster_pos_2f(random.float(), random.float()),
        1 => c.raster_pos_3f(random.float(), random.float(), random.pick(&[0.0, 0.25, 2.0])),
        2 => c.window_pos_2i(random.below(110) as GLint, random.below(110) as GLint),
        3 => c.window_pos_3f(random.float() * 100.0, 30.5, random.pick(&[0.0, 0.25])),
        4 => c.color_4f(1.0, random.pick(&[0.0, 0.5]), 0.25, random.pick(&[0.25, 1.0])),
        5 => c.secondary_color_3f(0.0, random.pick(&[0.0, 0.5]), 0.0),
        6 => c.tex_coord_2f(random.pick(&[0.1, 0.7]), 0.4),
        7 => c.fog_coordf(random.pick(&[0.0, 1.0])),
        8 => unpack(c, random),
        9 => c.push_attrib(random.pick(&[GL_LIST_BIT, GL_CURRENT_BIT, GL_ENABLE_BIT])),
        10 => c.pop_attrib(),
        11 => c.push_client_attrib(GL_CLIENT_PIXEL_STORE_BIT),
        12 => c.pop_client_attrib(),
        13 => match random.below(4) {
            0 => c.disable(GL_BLEND),
            1 => c.color_mask(true, random.below(2) == 0, true, true),
            2 => c.rectf(-0.5, -0.5, random.float(), 0.1),
            _ => c.clear(GL_DEPTH_BUFFER_BIT),
        },
        14 => {
            c.begin(GL_TRIANGLES);
            (0..3).for_each(|_| c.vertex_2f(random.float(), random.float()));
            c.end();
        }
        _ => {
            let mut position = [0.0; 4];
            c.get_floatv(GL_CURRENT_RASTER_POSITION, &mut position);
        }
    }
}

fn text(c: &mut Context, random: &mut Random, way: Way) {
    for _ in 0..random.below(20) + 2 {
        if random.below(2) == 0 {
            let bits = bits(random);
            bitmap(c, random, &bits);
        } else {
            let letters: Vec<u8> = (0..5).map(|_| random.below(6) as u8).collect();
            if way == Way::Apart {
                for letter in letters {
                    c.call_list(LETTERS.0 + GLuint::from(letter));
                    c.finish();
                }
            } else {
                c.call_lists(5, GL_UNSIGNED_BYTE, Data::Bytes(&letters));
            }
        }
        if way == Way::Apart {
            c.finish();
        }
        if random.below(2) == 0 {
            between(c, random);
        }
    }
}

fn play(c: &mut Context, random: &mut Random, way: Way) {
    match way {
        Way::Apart | Way::Together | Way::Watched => text(c, random, way),
        Way::List => {
            c.new_list(1, GL_COMPILE);
            text(c, random, way);
            c.end_list();
            c.call_list(1);
        }
        Way::ListAtOnce => {
            c.new_list(1, GL_COMPILE_AND_EXECUTE);
            text(c, random, way);
            c.end_list();
        }
    }
}

/// Colours, depths and stencils.
fn picture(c: &mut Context) -> [Vec<u8>; 3] {
    let (width, height) = (SIZE as GLsizei, SIZE as GLsizei - 7);
    let planes = [
        (GL_RGBA, GL_UNSIGNED_BYTE),
        (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
        (GL_STENCIL_INDEX, GL_UNSIGNED_INT),
    ];
    planes.map(|(format, ty)| {
        let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
        c.read_pixels(0, 0, width, height, format, ty, DataOut::Bytes(&mut pixels));
        pixels
    })
}

/// What is drawn, the raster position, the samples that passed, and the error.
fn outcome(seed: u64, way: Way) -> ([Vec<u8>; 3], [f32; 4], GLuint, GLenum) {
    let mut random = Random(seed);
    let c = &mut context(&mut random);
    if way == Way::Watched {
        c.watch_pixel(SIZE / 2, SIZE / 2).expect("a pixel of the window");
    }
    let mut passed = [0];
    if random.below(2) == 0 {
        c.begin_query(GL_SAMPLES_PASSED, 1);
        play(c, &mut random, way);
        c.end_query(GL_SAMPLES_PASSED);
        c.get_query_objectuiv(1, GL_QUERY_RESULT, &mut passed);
    } else {
        // Pixels that are drawn twice may be drawn together.
        play(c, &mut random, way);
    }
    let mut position = [0.0; 4];
    c.get_floatv(GL_CURRENT_RASTER_POSITION, &mut position);
    let error = c.get_error();
    (picture(c), position, passed[0], error)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn however_they_follow_each_other_the_picture_is_the_same(seed: u64) {
        let apart = outcome(seed, Way::Apart);
        for way in [Way::Together, Way::List, Way::ListAtOnce, Way::Watched] {
            let other = outcome(seed, way);
            prop_assert_eq!(&other.1, &apart.1, "{:?}", way);
            prop_assert_eq!((other.2, other.3), (apart.2, apart.3), "{:?}", way);
            prop_assert!(other.0 == apart.0, "{:?}: the picture differs", way);
        }
    }

    #[test]
    fn what_feedback_gathers_is_the_same(seed: u64) {
        let gather = |way| {
            let mut random = Random(seed);
            let mut c = context(&mut random);
            c.feedback_buffer(1 << 14, GL_3D_COLOR, DataOut::Null);
            c.render_mode(GL_FEEDBACK);
            play(&mut c, &mut random, way);
            c.render_mode(GL_RENDER);
            c.feedback().to_vec()
        };
        let apart = gather(Way::Apart);
        for way in [Way::Together, Way::List, Way::ListAtOnce] {
            prop_assert!(gather(way) == apart, "{:?}", way);
        }
    }
}

/// The pixels of a bitmap, one by one, as the specification has it.
#[test]
fn a_bitmap_is_the_pixels_of_its_bits() {
    for seed in 0..200 {
        let random = &mut Random(seed);
        let desc = ContextDesc { width: SIZE, height: SIZE - 7, ..ContextDesc::default() };
        let c = &mut Context::new(desc).expect("a device");
        let bits = bits(random);
        let [width, height] = [0, 1].map(|_| random.below(70) as GLsizei);
        let at = [0, 1].map(|_| random.below(150) as GLint - 30);
        c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        // A raster position is never set outside of the window, but moves there.
        c.window_pos_2i(0, 0);
        c.bitmap(0, 0, 0.0, 0.0, at[0] as f32, at[1] as f32, Data::Null);
        c.bitmap(width, height, 0.0, 0.0, 0.0, 0.0, Data::Bytes(&bits));
        let [colors, ..] = picture(c);
        let stride = (width as usize).div_ceil(8);
        for (pixel, color) in colors.chunks_exact(4).enumerate().take((SIZE * (SIZE - 7)) as usize)
        {
            let (x, y) = (pixel as GLint % SIZE as GLint, pixel as GLint / SIZE as GLint);
            let [column, row] = [x - at[0], y - at[1]];
            let inside = (0..width).contains(&column) && (0..height).contains(&row);
            let is_set = inside && {
                let byte = bits[row as usize * stride + column as usize / 8];
                byte >> (7 - column % 8) & 1 == 1
            };
            assert_eq!(color[0] == 255, is_set, "seed {seed}: {x}, {y}");
        }
    }
}

#[test]
fn each_is_told_apart_where_it_is_an_error_or_a_program_colours_it() {
    let c = &mut Context::new(ContextDesc::default()).expect("a device");
    let bits = [0xFF; 32];
    let draw = |c: &mut Context| {
        c.window_pos_2i(3, 3);
        (0..3).for_each(|_| c.bitmap(8, 8, 0.0, 0.0, 9.0, 0.0, Data::Bytes(&bits)));
    };
    c.bind_framebuffer(GL_FRAMEBUFFER, 9);
    let _ = c.messages();
    draw(c);
    assert_eq!(c.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION);
    assert_eq!(c.messages().len(), 3);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    // A program reads what may change anywhere.
    let fragment = "void main() { gl_FragColor = gl_FrontMaterial.emission; }";
    shading::use_program(c, "void main() { gl_Position = gl_Vertex; }", fragment);
    c.window_pos_2i(3, 3);
    for red in [1.0, 0.0] {
        c.materialfv(GL_FRONT, GL_EMISSION, &[red, 1.0, 0.0, 1.0]);
        c.bitmap(8, 8, 0.0, 0.0, 9.0, 0.0, Data::Bytes(&bits));
    }
    for (x, red) in [(5, 255), (14, 0)] {
        let mut pixel = [9; 4];
        c.read_pixels(x, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(pixel, [red, 255, 0, 255]);
    }
}
