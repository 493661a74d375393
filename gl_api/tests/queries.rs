//! Queries: samples that pass, time, and the errors of each call.

use gl_api::*;

fn context() -> Context {
    let desc = ContextDesc { width: 8, height: 8, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let mut names = [0; 3];
    c.gen_queries(3, &mut names);
    assert_eq!(names, [1, 2, 3]);
    c
}

/// A rectangle in pixels, at a depth of -1 (near) to 1.
fn rectangle(c: &mut Context, [x0, y0, x1, y1]: [f32; 4], z: f32) {
    let at = |pixel: f32| pixel / 4.0 - 1.0;
    c.begin(GL_QUADS);
    c.vertex_3f(at(x0), at(y0), z);
    c.vertex_3f(at(x1), at(y0), z);
    c.vertex_3f(at(x1), at(y1), z);
    c.vertex_3f(at(x0), at(y1), z);
    c.end();
}

fn result(c: &mut Context, id: GLuint) -> GLuint {
    let mut value = [0];
    c.get_query_objectuiv(id, GL_QUERY_RESULT, &mut value);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    value[0]
}

fn count(c: &mut Context, target: GLenum, draw: impl FnOnce(&mut Context)) -> GLuint {
    let id = if target == GL_SAMPLES_PASSED { 1 } else { 2 };
    c.begin_query(target, id);
    draw(c);
    c.end_query(target);
    result(c, id)
}

#[test]
fn samples_that_pass_are_counted() {
    let mut c = context();
    let whole = [0.0, 0.0, 8.0, 8.0];
    assert_eq!(count(&mut c, GL_SAMPLES_PASSED, |c| rectangle(c, whole, 0.0)), 64);
    assert_eq!(count(&mut c, GL_SAMPLES_PASSED, |_| {}), 0);
    let part = [1.0, 2.0, 4.0, 7.0];
    assert_eq!(count(&mut c, GL_SAMPLES_PASSED, |c| rectangle(c, part, 0.0)), 15);
    // Hidden ones do not count, whatever is written.
    c.enable(GL_DEPTH_TEST);
    rectangle(&mut c, part, -0.5);
    c.color_mask(false, false, false, false);
    c.depth_mask(false);
    assert_eq!(count(&mut c, GL_SAMPLES_PASSED, |c| rectangle(c, whole, 0.5)), 49);
    assert_eq!(count(&mut c, GL_ANY_SAMPLES_PASSED, |c| rectangle(c, whole, 0.5)), 1);
    assert_eq!(count(&mut c, GL_ANY_SAMPLES_PASSED, |c| rectangle(c, part, 0.5)), 0);
    // Nor do those that the alpha test takes away.
    c.disable(GL_DEPTH_TEST);
    c.enable(GL_ALPHA_TEST);
    c.alpha_func(GL_LESS, 0.5);
    assert_eq!(count(&mut c, GL_SAMPLES_PASSED, |c| rectangle(c, whole, 0.0)), 0);
}

#[test]
fn time_goes_on() {
    let mut c = context();
    c.query_counter(3, GL_TIMESTAMP);
    c.begin_query(GL_TIME_ELAPSED, 1);
    rectangle(&mut c, [0.0, 0.0, 8.0, 8.0], 0.0);
    c.end_query(GL_TIME_ELAPSED);
    c.query_counter(2, GL_TIMESTAMP);
    let mut times = [0u64; 3];
    for (id, time) in (1..).zip(&mut times) {
        let mut value = [0];
        c.get_query_objectui64v(id, GL_QUERY_RESULT, &mut value);
        *time = value[0];
    }
    let [elapsed, after, before] = times;
    assert!(elapsed > 0 && after >= before + elapsed, "{times:?}");
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn what_is_known_of_queries() {
    let mut c = context();
    let mut value = [7];
    c.get_queryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &mut value);
    assert_eq!(value[0], 0);
    assert!(!c.is_query(1));
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.get_queryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &mut value);
    assert_eq!(value[0], 1);
    assert!(c.is_query(1));
    c.delete_queries(1, &[1]);
    assert!(!c.is_query(1));
    c.get_queryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &mut value);
    assert_eq!(value[0], 0);
    c.get_queryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &mut value);
    // The clock can be read by every kind of number.
    let (mut first, mut then, mut last) = ([0], [0.0], [0]);
    c.get_integer64v(GL_TIMESTAMP, &mut first);
    c.get_doublev(GL_TIMESTAMP, &mut then);
    c.get_integer64v(GL_TIMESTAMP, &mut last);
    assert!((first[0] as f64..=last[0] as f64).contains(&then[0]), "{first:?} {then:?} {last:?}");
    assert_eq!(c.get_error(), GL_NO_ERROR);
    assert_eq!(value[0], 64);
}
