//! `textureQueryLevels` (ARB_texture_query_levels), and locations of uniforms that are not active.

use super::{context, fine, pixel, shading};
use gl_api::*;

/// The number that the shader writes, as red of 255.
fn levels(c: &mut Context) -> u8 {
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    pixel(c, 0, 0)[0]
}

const FRAGMENT: &str = "#version 330 compatibility
    #extension GL_ARB_texture_query_levels : require
    #extension GL_ARB_explicit_uniform_location : require
    layout(location = 7) uniform vec4 unused;
    uniform sampler2D image;
    void main() { gl_FragColor = vec4(float(textureQueryLevels(image)) / 255.0); }";

#[test]
fn a_shader_reads_how_many_levels_there_are() {
    let mut c = context(1, 1);
    shading::use_program(&mut c, "", FRAGMENT);
    assert_eq!(levels(&mut c), 0, "without a texture");
    c.bind_texture(GL_TEXTURE_2D, 1);
    let data = Data::Null;
    for level in 0..6 {
        let (side, internal) = (32 >> level, GL_RGBA8 as GLint);
        let (target, format, ty) = (GL_TEXTURE_2D, GL_RGBA, GL_UNSIGNED_BYTE);
        c.tex_image_2d(target, level, internal, side, side, 0, format, ty, data);
    }
    let set = |c: &mut Context, name, value: GLint| c.tex_parameteri(GL_TEXTURE_2D, name, value);
    for filter in [GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR] {
        set(&mut c, GL_TEXTURE_MIN_FILTER, filter as GLint);
        for (base, max, wanted) in [(0, 1000, 6), (0, 3, 4), (2, 1000, 4), (2, 4, 3), (5, 5, 1)] {
            set(&mut c, GL_TEXTURE_BASE_LEVEL, base);
            set(&mut c, GL_TEXTURE_MAX_LEVEL, max);
            assert_eq!(levels(&mut c), wanted, "{filter:#x} {base} {max}");
        }
    }
    fine(&mut c);
    // A uniform that is not active keeps its location: values for it are ignored.
    c.uniform_4f(7, 1.0, 2.0, 3.0, 4.0);
    fine(&mut c);
    c.uniform_4f(8, 1.0, 2.0, 3.0, 4.0);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}
