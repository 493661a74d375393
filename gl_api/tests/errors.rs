//! How errors are told: the flag, the messages, and calls without a context.

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 16, height: 8, ..ContextDesc::default() }).expect("a device")
}

#[test]
fn the_first_error_stays_until_it_is_asked_for() {
    let mut context = context();
    context.viewport(0, 0, -1, 1);
    context.enable(GL_FRONT);
    assert_eq!(context.get_error(), GL_INVALID_VALUE);
    assert_eq!(context.get_error(), GL_NO_ERROR);
    let text = context.messages()[0].to_string();
    assert_eq!(
        text,
        "error: glViewport: width = -1 must not be negative (GL 2.1, section 2.11.1); \
         GL_INVALID_VALUE"
    );
}

#[test]
fn an_incomplete_framebuffer_says_what_is_missing() {
    let mut context = context();
    context.bind_framebuffer(GL_FRAMEBUFFER, 3);
    let status = context.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    context.clear(GL_COLOR_BUFFER_BIT);
    assert_eq!(context.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION);
    context.bind_texture(GL_TEXTURE_2D, 5);
    context.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 5, 0);
    let status = context.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    let depth = GL_DEPTH_COMPONENT;
    context.tex_image_2d(GL_TEXTURE_2D, 0, depth as i32, 4, 4, 0, depth, GL_FLOAT, Data::Null);
    // Complete without colours; that one is selected is worth a warning.
    assert_eq!(context.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    context.draw_buffer(GL_NONE);
    context.read_buffer(GL_NONE);
    assert_eq!(context.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    let texts: Vec<String> = context.messages().iter().map(ToString::to_string).collect();
    for words in [
        "framebuffer 3 is incomplete: nothing is attached",
        "call glTexImage2D",
        "glDrawBuffer(GL_NONE)",
    ] {
        assert!(texts.iter().any(|text| text.contains(words)), "{words}: {texts:?}");
    }
}

#[test]
fn a_draw_of_nothing_needs_a_complete_framebuffer_too() {
    let draws: [fn(&mut Context); 4] = [
        |c| {
            c.begin(GL_TRIANGLES);
            c.end();
        },
        |c| c.draw_arrays(GL_TRIANGLES, 0, 0),
        |c| c.draw_arrays(GL_TRIANGLES, 0, 3),
        |c| c.draw_elements(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, Data::Null),
    ];
    for (index, draw) in draws.into_iter().enumerate() {
        let mut c = context();
        draw(&mut c);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{index}");
        c.bind_framebuffer(GL_FRAMEBUFFER, 3);
        draw(&mut c);
        assert_eq!(c.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION, "{index}");
        // In a list it is an error where the list is called; of an empty glBegin nothing is kept.
        if index == 0 {
            continue;
        }
        c.new_list(1, GL_COMPILE);
        draw(&mut c);
        c.end_list();
        assert_eq!(c.get_error(), GL_NO_ERROR, "{index}");
        c.call_list(1);
        assert_eq!(c.get_error(), GL_INVALID_FRAMEBUFFER_OPERATION, "{index}");
    }
}

#[test]
fn values_are_called_what_programs_call_them() {
    for (value, name) in [
        (GL_ABGR_EXT, "GL_ABGR_EXT"),
        (GL_DOT3_RGBA_EXT, "GL_DOT3_RGBA_EXT"),
        (GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, "GL_COMPRESSED_RGBA_S3TC_DXT3_EXT"),
        (GL_TEXTURE_CUBE_MAP_ARRAY, "GL_TEXTURE_CUBE_MAP_ARRAY"),
        (GL_VERTEX_PROGRAM_POINT_SIZE, "GL_PROGRAM_POINT_SIZE"),
        (GL_DEPTH_BUFFER_BIT, "GL_ACCUM"),
        (1, "1"),
    ] {
        assert_eq!(enum_name(value), name);
    }
}

#[test]
fn without_a_context_calls_are_ignored() {
    glBindTexture(GL_TEXTURE_2D, 1);
    assert_eq!(glGetError(), 0);
    assert_eq!(glGetUniformLocation(1, "a"), -1);
    assert!(!glIsTexture(1));
    assert_eq!(glGetString(GL_VERSION), "");
}
