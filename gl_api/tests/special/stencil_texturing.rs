//! Stencil values that a shader samples (`ARB_stencil_texturing`).

use super::{context, fine, pixel, shading};
use gl_api::*;

const FRAGMENT: &str = "#version 130
    uniform usampler2D image;
    void main() { gl_FragColor = vec4(vec3(texture(image, gl_TexCoord[0].st).rgb) / 255.0, 1.0); }";

#[test]
fn a_shader_reads_stencil_or_depth() {
    for internal in [GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8] {
        let mut c = context(4, 4);
        c.bind_texture(GL_TEXTURE_2D, 1);
        c.tex_storage_2d(GL_TEXTURE_2D, 1, internal, 4, 4);
        for name in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
            c.tex_parameteri(GL_TEXTURE_2D, name, GL_NEAREST as GLint);
        }
        // Stencil values are drawn to it: 3 × column + 1, at depth 0.5.
        let mut framebuffer = [0];
        c.gen_framebuffers(1, &mut framebuffer);
        c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
        let attachment = GL_DEPTH_STENCIL_ATTACHMENT;
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, 1, 0);
        c.draw_buffer(GL_NONE);
        c.read_buffer(GL_NONE);
        c.enable(GL_SCISSOR_TEST);
        c.clear_depth(0.5);
        for column in 0..4 {
            c.scissor(column, 0, 1, 4);
            c.clear_stencil(3 * column + 1);
            c.clear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        }
        c.disable(GL_SCISSOR_TEST);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        fine(&mut c);
        let name = GL_DEPTH_STENCIL_TEXTURE_MODE;
        let mut mode = [0];
        c.get_tex_parameteriv(GL_TEXTURE_2D, name, &mut mode);
        assert_eq!(mode, [GL_DEPTH_COMPONENT as GLint]);
        c.tex_parameteri(GL_TEXTURE_2D, name, GL_STENCIL_INDEX as GLint);
        c.get_tex_parameteriv(GL_TEXTURE_2D, name, &mut mode);
        assert_eq!(mode, [GL_STENCIL_INDEX as GLint]);
        let program = shading::use_program(&mut c, "", FRAGMENT);
        let quad = |c: &mut Context| {
            c.begin(GL_QUADS);
            for (s, t) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
                c.tex_coord_2f(s, t);
                c.vertex_2f(2.0 * s - 1.0, 2.0 * t - 1.0);
            }
            c.end();
        };
        quad(&mut c);
        for column in 0..4 {
            assert_eq!(pixel(&mut c, column, 2), [3 * column as u8 + 1, 0, 0, 255]);
        }
        // And depth again, by the fixed function.
        c.tex_parameteri(GL_TEXTURE_2D, name, GL_DEPTH_COMPONENT as GLint);
        c.use_program(0);
        c.delete_program(program);
        c.enable(GL_TEXTURE_2D);
        quad(&mut c);
        assert_eq!(pixel(&mut c, 1, 1), [128, 128, 128, 255]);
        c.tex_parameteri(GL_TEXTURE_2D, name, GL_RED as GLint);
        assert_eq!(c.get_error(), GL_INVALID_ENUM);
    }
}
