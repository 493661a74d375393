//! Warnings of draws whose picture may not be what was meant: a table of mistakes, each with words of its warning, and
//! a table of programs that look like mistakes but are intended, which get no warning.

#[path = "../common/shading.rs"]
mod shading;

mod black;
mod intended;
mod invisible;
mod mistakes;
mod scene;

use gl_api::*;

/// The messages since the last call of this function.
fn texts(c: &mut Context) -> Vec<String> {
    c.messages().iter().map(ToString::to_string).collect()
}

#[test]
fn each_mistake_is_warned_of_once() {
    for (name, prepare, draw, words) in mistakes::ROWS {
        let mut c = scene::context();
        c.enable(GL_DEBUG_OUTPUT);
        prepare(&mut c);
        let mut given = texts(&mut c);
        for _ in 0..3 {
            draw(&mut c);
            given.extend(texts(&mut c));
        }
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {given:#?}");
        let times =
            given.iter().filter(|text| text.starts_with("warning: ") && text.contains(words));
        assert_eq!(times.count(), 1, "{name}: {words:?} in {given:#?}");
    }
}

#[test]
fn what_is_intended_gets_no_warning() {
    for (name, call) in intended::ROWS {
        let mut c = scene::context();
        c.enable(GL_DEBUG_OUTPUT);
        call(&mut c);
        let given = texts(&mut c);
        assert_eq!((c.get_error(), &given[..]), (GL_NO_ERROR, &[][..]), "{name}");
    }
}

#[test]
fn a_surface_without_depth_is_named() {
    let surface = SurfaceDesc { depth_bits: 0, stencil_bits: 0, ..SurfaceDesc::default() };
    let mut c = Context::new(ContextDesc { surface, ..ContextDesc::default() }).expect("a device");
    c.enable(GL_DEPTH_TEST);
    scene::triangle(&mut c);
    let given = texts(&mut c);
    assert!(given[0].contains("the default framebuffer has no depth buffer"), "{given:?}");
    assert!(given[0].contains("choose a config with EGL_DEPTH_SIZE"), "{given:?}");
}
