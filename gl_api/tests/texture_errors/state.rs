//! What a refused call on textures must leave alone.

use gl_api::*;

/// What is known of the textures of the fixture, whatever a row binds on its way.
pub fn digest(c: &mut Context) -> Vec<f32> {
    c.active_texture(GL_TEXTURE0);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    let mut state = Vec::new();
    for (name, target, image) in [
        (1, GL_TEXTURE_2D, GL_TEXTURE_2D),
        (2, GL_TEXTURE_3D, GL_TEXTURE_3D),
        (3, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X),
    ] {
        c.bind_texture(target, name);
        for pname in [
            GL_TEXTURE_MIN_FILTER,
            GL_TEXTURE_MAG_FILTER,
            GL_TEXTURE_WRAP_S,
            GL_TEXTURE_WRAP_T,
            GL_TEXTURE_WRAP_R,
            GL_TEXTURE_MIN_LOD,
            GL_TEXTURE_MAX_LOD,
            GL_TEXTURE_BASE_LEVEL,
            GL_TEXTURE_MAX_LEVEL,
            GL_TEXTURE_COMPARE_MODE,
            GL_TEXTURE_COMPARE_FUNC,
            GL_TEXTURE_PRIORITY,
            GL_GENERATE_MIPMAP,
            GL_TEXTURE_BORDER_COLOR,
        ] {
            let mut value = [0.0; 4];
            c.get_tex_parameterfv(target, pname, &mut value);
            state.extend(value);
        }
        for level in 0..3 {
            for pname in
                [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_INTERNAL_FORMAT]
            {
                let mut value = [0.0];
                c.get_tex_level_parameterfv(image, level, pname, &mut value);
                state.extend(value);
            }
        }
    }
    let mut texels = [0; 64];
    let out = DataOut::Bytes(&mut texels);
    c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out);
    state.extend(texels.map(f32::from));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    state
}
