//! What is said of a picture that may not be what was meant: a table of mistakes, each with the words
//! of its message, and a table of programs that mean what they do, of which nothing is said.

#[path = "../common/shading.rs"]
mod shading;

mod mistakes;
mod right;
mod scene;
mod unseen;

use gl_api::*;

/// The messages since the last time.
fn texts(c: &mut Context) -> Vec<String> {
    c.messages().iter().map(ToString::to_string).collect()
}

#[test]
fn each_mistake_is_said_once() {
    for (name, prepare, draw, words) in mistakes::ROWS {
        let mut c = scene::context();
        c.enable(GL_DEBUG_OUTPUT);
        prepare(&mut c);
        let mut said = texts(&mut c);
        for _ in 0..3 {
            draw(&mut c);
            said.extend(texts(&mut c));
        }
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {said:#?}");
        let times =
            said.iter().filter(|text| text.starts_with("warning: ") && text.contains(words));
        assert_eq!(times.count(), 1, "{name}: {words:?} in {said:#?}");
    }
}

#[test]
fn nothing_is_said_of_what_is_right() {
    for (name, call) in right::ROWS {
        let mut c = scene::context();
        c.enable(GL_DEBUG_OUTPUT);
        call(&mut c);
        let said = texts(&mut c);
        assert_eq!((c.get_error(), &said[..]), (GL_NO_ERROR, &[][..]), "{name}");
    }
}

#[test]
fn a_surface_without_depth_is_named() {
    let surface = SurfaceDesc { depth_bits: 0, stencil_bits: 0, ..SurfaceDesc::default() };
    let mut c = Context::new(ContextDesc { surface, ..ContextDesc::default() }).expect("a device");
    c.enable(GL_DEPTH_TEST);
    scene::triangle(&mut c);
    let said = texts(&mut c);
    assert!(said[0].contains("the default framebuffer has no depth buffer"), "{said:?}");
    assert!(said[0].contains("choose a config with EGL_DEPTH_SIZE"), "{said:?}");
}
