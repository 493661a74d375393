//! Display lists and shared objects: a list draws what its calls draw, whatever was compiled into
//! it; contexts of a group see each other's objects, on any thread.

#[path = "common/cpu_time.rs"]
mod cpu_time;

use cpu_time::CpuTime;
use gl_api::*;

const SIZE: u32 = 16;

fn context() -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

fn picture(c: &mut Context) -> Vec<u8> {
    let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
    let size = SIZE as GLsizei;
    c.read_pixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixels
}

/// The same calls at once, in a list that is called, and in a list that is compiled and carried
/// out; each with the current colour it starts from.
fn same_in_a_list(name: &str, calls: fn(&mut Context)) {
    let draw = |how: fn(&mut Context, fn(&mut Context))| {
        let mut c = context();
        c.clear_color(0.1, 0.2, 0.3, 1.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.color_3f(1.0, 0.5, 0.25);
        how(&mut c, calls);
        let mut color = [0.0; 4];
        c.get_floatv(GL_CURRENT_COLOR, &mut color);
        (picture(&mut c), color)
    };
    let direct = draw(|c, calls| calls(c));
    let compiled = draw(|c, calls| {
        c.color_3f(0.0, 1.0, 0.0);
        c.new_list(7, GL_COMPILE);
        calls(c);
        c.end_list();
        // What is current, and what is in memory, is taken when the list is called.
        c.color_3f(1.0, 0.5, 0.25);
        c.call_list(7);
    });
    let executed = draw(|c, calls| {
        c.new_list(7, GL_COMPILE_AND_EXECUTE);
        calls(c);
        c.end_list();
    });
    assert!(direct.0.chunks(4).any(|p| p != &direct.0[..4]), "{name}: nothing was drawn");
    assert!(direct == compiled, "{name}: compiled");
    assert!(direct == executed, "{name}: compiled and executed");
}

fn triangle(c: &mut Context) {
    c.vertex_2f(-0.8, -0.8);
    c.vertex_2f(0.8, -0.8);
    c.vertex_2f(0.0, 0.8);
}

#[test]
fn a_list_draws_what_its_calls_draw() {
    same_in_a_list("the colour from before", |c| {
        c.begin(GL_TRIANGLES);
        triangle(c);
        c.end();
    });
    same_in_a_list("a colour from the second vertex on", |c| {
        c.begin(GL_TRIANGLES);
        c.vertex_2f(-0.8, -0.8);
        c.color_3f(0.0, 0.0, 1.0);
        c.vertex_2f(0.8, -0.8);
        c.vertex_2f(0.0, 0.8);
        c.end();
    });
    same_in_a_list("matrices and attributes outside glBegin", |c| {
        c.matrix_mode(GL_MODELVIEW);
        c.load_matrixf(&[0.5, 0., 0., 0., 0., 0.5, 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.]);
        c.color_4ub(9, 200, 30, 255);
        c.begin(GL_TRIANGLES);
        triangle(c);
        c.end();
    });
    same_in_a_list("a texture from the client's memory", |c| {
        let mut texels: Vec<u8> = (0..27).map(|i| 200 - 7 * i).collect();
        c.enable(GL_TEXTURE_2D);
        c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        let pixels = Data::Bytes(&texels);
        let ty = GL_UNSIGNED_BYTE;
        c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB as GLint, 3, 3, 0, GL_RGB, ty, pixels);
        c.pixel_storei(GL_UNPACK_ALIGNMENT, 8);
        texels.fill(0);
        c.begin(GL_TRIANGLES);
        for (x, y) in [(-0.8, -0.8), (0.8, -0.8), (0.0, 0.8)] {
            c.tex_coord_2f(x, y);
            c.vertex_2f(x, y);
        }
        c.end();
    });
    same_in_a_list("arrays and indices", |c| {
        let corners = [-0.8f32, -0.8, 0.8, -0.8, 0.0, 0.8];
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(2, GL_FLOAT, 0, corners.as_slice().arg());
        c.draw_arrays(GL_LINE_LOOP, 0, 3);
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[2, 0, 1]));
        c.vertex_pointer(2, GL_FLOAT, 0, [0.0f32; 6].as_slice().arg());
        c.disable_client_state(GL_VERTEX_ARRAY);
    });
    same_in_a_list("vertices in a list of their own", |c| {
        c.begin(GL_TRIANGLES);
        c.color_3f(0.0, 1.0, 1.0);
        c.call_list(99);
        triangle(c);
        c.end();
    });
}

/// Names cost nothing until they are used.
#[test]
fn there_are_as_many_names_as_numbers() {
    let mut c = context();
    assert_eq!(c.gen_lists(GLsizei::MAX), 1);
    assert_eq!(c.gen_lists(GLsizei::MAX), 1 << 31);
    assert_eq!(c.gen_lists(2), 0, "one is left");
    assert_eq!(c.gen_lists(1), GLuint::MAX);
    assert!(c.is_list(1 << 31) && c.is_list(GLuint::MAX) && !c.is_list(0));
    c.delete_lists(1000, 2);
    assert_eq!([999, 1000, 1001, 1002].map(|name| c.is_list(name)), [true, false, false, true]);
    assert_eq!((c.gen_lists(3), c.gen_lists(2)), (0, 1000));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn lists_call_lists_by_names_of_every_type() {
    let mut c = context();
    let base = c.gen_lists(600);
    assert_eq!((base, c.gen_lists(2)), (1, 601));
    assert!(c.is_list(1) && c.is_list(602) && !c.is_list(603));
    for (name, red) in [(base + 3, 0.25), (base + 258, 0.5)] {
        c.new_list(name, GL_COMPILE);
        c.color_3f(red, 0.0, 0.0);
        c.end_list();
    }
    c.list_base(base);
    let red = |c: &mut Context| {
        let mut color = [0.0; 4];
        c.get_floatv(GL_CURRENT_COLOR, &mut color);
        c.color_3f(1.0, 1.0, 1.0);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        color[0]
    };
    let (three, many) = (3i32.to_ne_bytes(), 258i32.to_ne_bytes());
    let as_float = 258f32.to_ne_bytes();
    let rows: &[(GLenum, &[u8], f32)] = &[
        (GL_BYTE, &[3], 0.25),
        (GL_UNSIGNED_BYTE, &[3], 0.25),
        (GL_SHORT, &many[..2], 0.5),
        (GL_UNSIGNED_SHORT, &many[..2], 0.5),
        (GL_INT, &three, 0.25),
        (GL_UNSIGNED_INT, &many, 0.5),
        (GL_FLOAT, &as_float, 0.5),
        (GL_2_BYTES, &[1, 2], 0.5),
        (GL_3_BYTES, &[0, 1, 2], 0.5),
        (GL_4_BYTES, &[0, 0, 1, 2], 0.5),
    ];
    for &(ty, bytes, expected) in rows {
        c.call_lists(1, ty, Data::Bytes(bytes));
        assert_eq!(red(&mut c), expected, "{}", enum_name(ty));
    }
    c.delete_lists(base, 300);
    assert!(!c.is_list(base + 3) && c.is_list(base + 300));
    c.call_lists(1, GL_UNSIGNED_BYTE, Data::Bytes(&[3]));
    assert_eq!(red(&mut c), 1.0);
}

#[test]
fn what_answers_or_is_the_clients_is_not_compiled() {
    let mut c = context();
    c.new_list(1, GL_COMPILE);
    let mut value = [0];
    c.get_integerv(GL_LIST_INDEX, &mut value);
    assert_eq!(value[0], 1);
    c.get_integerv(GL_LIST_MODE, &mut value);
    assert_eq!(value[0] as GLenum, GL_COMPILE);
    c.pixel_storei(GL_PACK_ALIGNMENT, 2);
    c.shade_model(GL_FLAT);
    c.end_list();
    c.get_integerv(GL_PACK_ALIGNMENT, &mut value);
    assert_eq!(value[0], 2);
    c.get_integerv(GL_SHADE_MODEL, &mut value);
    assert_eq!(value[0] as GLenum, GL_SMOOTH);
    // An error in a list comes when the list is called.
    c.new_list(2, GL_COMPILE);
    c.matrix_mode(GL_BLEND);
    c.end_list();
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.call_list(2);
    assert_eq!(c.get_error(), GL_INVALID_ENUM);
    assert!(c.messages().iter().any(|message| message.text.starts_with("glMatrixMode: mode")));
}

#[test]
fn errors_of_the_calls() {
    let mut c = context();
    type Row = (&'static str, GLenum, fn(&mut Context));
    let rows: &[Row] = &[
        ("list 0", GL_INVALID_VALUE, |c| c.new_list(0, GL_COMPILE)),
        ("mode", GL_INVALID_ENUM, |c| c.new_list(1, GL_RENDER)),
        ("no list", GL_INVALID_OPERATION, |c| c.end_list()),
        ("range", GL_INVALID_VALUE, |c| {
            c.gen_lists(-1);
        }),
        ("range", GL_INVALID_VALUE, |c| c.delete_lists(1, -1)),
        ("n", GL_INVALID_VALUE, |c| c.call_lists(-1, GL_BYTE, Data::Null)),
        ("type", GL_INVALID_ENUM, |c| c.call_lists(1, GL_DOUBLE, Data::Null)),
        ("memory", GL_INVALID_OPERATION, |c| c.call_lists(2, GL_INT, Data::Bytes(&[0; 7]))),
        ("twice", GL_INVALID_OPERATION, |c| {
            c.new_list(1, GL_COMPILE);
            c.new_list(2, GL_COMPILE);
            let error = c.get_error();
            c.end_list();
            assert_eq!(error, GL_INVALID_OPERATION);
            c.end_list();
        }),
    ];
    for (name, error, call) in rows {
        call(&mut c);
        assert_eq!(c.get_error(), *error, "{name}: {:?}", c.messages());
    }
}

#[test]
fn lists_that_call_each_other_come_to_an_end() {
    let mut c = context();
    for name in 1..=2 {
        c.new_list(name, GL_COMPILE);
        c.call_list(3 - name);
        c.end_list();
    }
    c.call_list(1);
    for name in 10..60 {
        c.new_list(name, GL_COMPILE);
        c.call_list(name + 1);
        c.call_list(name + 1);
        c.end_list();
    }
    c.call_list(10);
    assert!(c.messages().iter().any(|message| message.text.contains("left out")));
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

#[test]
fn contexts_of_a_group_share_objects_over_threads() {
    let mut c = context();
    let texel = |c: &mut Context, texture: GLuint, pixel: [u8; 4]| {
        c.bind_texture(GL_TEXTURE_2D, texture);
        let pixels = Data::Bytes(&pixel);
        let ty = GL_UNSIGNED_BYTE;
        c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as GLint, 1, 1, 0, GL_RGBA, ty, pixels);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    };
    texel(&mut c, 5, [1, 2, 3, 255]);
    c.new_list(4, GL_COMPILE);
    c.begin(GL_TRIANGLES);
    c.vertex_2f(-1.0, -1.0);
    c.vertex_2f(3.0, -1.0);
    c.vertex_2f(-1.0, 3.0);
    c.end();
    c.end_list();
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let workers: Vec<Context> =
        (0..3).map(|_| c.new_shared(desc.clone()).expect("a context")).collect();
    std::thread::scope(|scope| {
        for (index, mut worker) in workers.into_iter().enumerate() {
            scope.spawn(move || {
                for round in 0..20u8 {
                    let value = [10 * index as u8, round, 7, 255];
                    texel(&mut worker, 100 + index as GLuint, value);
                    worker.enable(GL_TEXTURE_2D);
                    worker.call_list(4);
                    assert!(picture(&mut worker).chunks(4).all(|pixel| pixel == value));
                }
                worker.bind_texture(GL_TEXTURE_2D, 5);
                worker.call_list(4);
                assert!(picture(&mut worker).chunks(4).all(|pixel| pixel == [1, 2, 3, 255]));
            });
        }
    });
    // What the others made is here; what is bound is each one's own.
    assert!(c.is_texture(100) && c.is_texture(102));
    let mut bound = [0];
    c.get_integerv(GL_TEXTURE_BINDING_2D, &mut bound);
    assert_eq!(bound[0], 5);
    c.bind_texture(GL_TEXTURE_2D, 102);
    c.enable(GL_TEXTURE_2D);
    c.call_list(4);
    assert_eq!(&picture(&mut c)[..4], [20, 19, 7, 255]);
}

/// Lists that call the next list several times: 64 deep, more commands than any machine carries out.
#[test]
fn lists_that_call_each_other_end_soon() {
    for commands in [0, 100] {
        for calls in [2, 1 << 12] {
            let mut c = context();
            for list in 1..=64 {
                c.new_list(list, GL_COMPILE);
                for _ in 0..commands {
                    c.enable(GL_DITHER);
                    c.color_4f(1.0, 0.5, 0.25, 1.0);
                }
                for _ in 0..calls {
                    c.call_list(list + 1);
                }
                c.end_list();
            }
            c.new_list(65, GL_COMPILE);
            c.enable(GL_BLEND);
            c.end_list();
            let start = CpuTime::begin();
            c.call_list(1);
            let elapsed = start.elapsed();
            // Half a second where it is compiled for speed.
            assert!(elapsed < std::time::Duration::from_secs(5), "{elapsed:?}");
            let messages = c.messages();
            let warned = messages.iter().filter(|m| m.text.contains("2097152 commands")).count();
            assert_eq!(warned, 1, "{messages:?}");
            // The next call has a budget of its own.
            c.disable(GL_BLEND);
            c.call_list(65);
            assert!(c.is_enabled(GL_BLEND));
        }
    }
}

/// The commands of the list itself are as many as the application recorded.
#[test]
fn a_long_list_is_carried_out() {
    let mut c = context();
    c.new_list(1, GL_COMPILE);
    for _ in 0..(1 << 21) + 1 {
        c.enable(GL_DITHER);
    }
    c.enable(GL_BLEND);
    c.end_list();
    c.call_list(1);
    assert!(c.is_enabled(GL_BLEND) && c.messages().is_empty());
}
