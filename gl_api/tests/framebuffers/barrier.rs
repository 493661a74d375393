//! A texture that is looked up while it is drawn to (`NV_texture_barrier`): each draw sees its texel
//! as the draw before left it.

use super::*;

const SIZE: i32 = 80;

#[test]
fn each_draw_sees_what_the_one_before_left() {
    let mut c = context(8, 8);
    let mut texture = [0];
    c.gen_textures(1, &mut texture);
    c.bind_texture(GL_TEXTURE_2D, texture[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
    // More than a tile, each texel another start.
    let start: Vec<u8> = (0..SIZE * SIZE).flat_map(|i| [i as u8, (i / 7) as u8, 3, 255]).collect();
    let data = Data::Bytes(&start);
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGBA8 as i32,
        SIZE,
        SIZE,
        0,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        data,
    );
    framebuffer(&mut c);
    let (point, target) = (GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, target, texture[0], 0);
    c.viewport(0, 0, SIZE, SIZE);
    // x becomes 255 - x, exactly.
    let fragment = "uniform sampler2D unit0; void main() {\n\
        vec4 old = texture2D(unit0, gl_FragCoord.xy / 80.0);\n\
        gl_FragColor = vec4(1.0 - old.rgb, 1.0); }";
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    shading::use_program(&mut c, vertex, fragment);
    for draws in 1..=3 {
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        c.texture_barrier();
        let found = bytes(&mut c, [0, 0, SIZE, SIZE], GL_RGBA, 4);
        let flip = |(at, byte): (usize, &u8)| {
            if at % 4 < 3 && draws % 2 == 1 { 255 - *byte } else { *byte }
        };
        let expected: Vec<u8> = start.iter().enumerate().map(flip).collect();
        assert!(found == expected, "after {draws} draws");
    }
}
