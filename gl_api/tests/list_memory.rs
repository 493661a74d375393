//! What display lists copy: never more than a call could use, and no allocation ends the process.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 8, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// A call's name, and the call with pixels.
type Call = (&'static str, fn(&mut Context, Data<'_>));

/// A size that the call refuses is refused when the list is called, and nothing is copied before.
#[test]
fn images_of_impossible_sizes_are_not_copied() {
    const HUGE: GLsizei = 0x7FFF_FFFF;
    let mut c = context();
    let data = Data::Bytes(&[0; 64]);
    let calls: &[Call] = &[
        ("glTexImage1D", |c, data| {
            c.tex_image_1d(GL_TEXTURE_1D, 0, 4, HUGE, 0, GL_RGBA, GL_FLOAT, data);
        }),
        ("glTexImage2D", |c, data| {
            c.tex_image_2d(GL_TEXTURE_2D, 0, 4, HUGE, HUGE, 0, GL_RGBA, GL_FLOAT, data);
        }),
        ("glTexImage3D", |c, data| {
            c.tex_image_3d(GL_TEXTURE_3D, 0, 4, HUGE, 2, 2, 0, GL_RGBA, GL_FLOAT, data);
        }),
        ("glTexSubImage2D", |c, data| {
            c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, HUGE, 1, GL_RGBA, GL_FLOAT, data);
        }),
        ("glPixelMapfv", |c, data| c.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, HUGE, data)),
    ];
    for (name, call) in calls {
        c.new_list(1, GL_COMPILE);
        call(&mut c, data);
        c.end_list();
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {:?}", c.messages());
        c.call_list(1);
        let error = c.get_error();
        assert!(matches!(error, GL_INVALID_VALUE | GL_INVALID_OPERATION), "{name}: {error:#x}");
        c.messages();
    }
}

/// An array of uniforms takes what it has room for, and looks at no more.
#[test]
fn elements_past_the_end_of_an_array_of_uniforms_need_not_be_there() {
    let mut c = context();
    let source = "uniform vec4 u[2]; void main() { gl_FragColor = u[0] + u[1]; }";
    let program = shading::use_program(&mut c, "", source);
    let location = c.get_uniform_location(program, "u");
    let values = [0.25, 0.5, 0.0, 0.5, 0.25, 0.0, 0.5, 0.5];
    c.new_list(1, GL_COMPILE);
    c.uniform_4fv(location, 0x7FFF_FFFF, &values);
    c.end_list();
    c.call_list(1);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    let mut pixel = [0; 4];
    c.read_pixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [128, 128, 128, 255]);
}
