//! Seamless cube maps: by the capability, by a texture, by a sampler object (`ARB_seamless_cubemap_per_texture`).

use super::{context, program};
use gl_api::*;

const VERTEX: &str = "void main() { gl_Position = gl_Vertex; }";
/// Near the edge between the faces +X and +Y.
const FRAGMENT: &str = "uniform samplerCube s;
    void main() { gl_FragColor = textureCube(s, vec3(1.0, 0.95, 0.0)); }";

/// The red of a lookup near the edge of a red face and a black one.
fn looked_up() -> u8 {
    glRecti(-1, -1, 1, 1);
    let mut pixel = [0_u8; 4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
    assert_eq!(glGetError(), GL_NO_ERROR);
    pixel[0]
}

fn flag() -> GLint {
    let mut value = -1;
    glGetTexParameteriv(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_SEAMLESS, &mut value);
    value
}

#[test]
fn one_texture_or_sampler_can_be_seamless() {
    let _current = context();
    glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
    for face in 0..6 {
        let texel: [u8; 4] = if face == 0 { [255, 0, 0, 255] } else { [0, 0, 0, 255] };
        let (target, texels) = (GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, texel.repeat(16));
        glTexImage2D(target, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels[..]);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glUseProgram(program(VERTEX, FRAGMENT).expect("it links"));
    assert_eq!((flag(), looked_up()), (0, 255));
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    let seamless = looked_up();
    assert!((100..200).contains(&seamless), "{seamless}");
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_TRUE);
    assert_eq!((flag(), looked_up()), (1, seamless));
    // A sampler object has a flag of its own, which counts where it is bound.
    let mut sampler = 0;
    glGenSamplers(1, &mut sampler);
    glBindSampler(0, sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    assert_eq!(looked_up(), 255);
    glSamplerParameteri(sampler, GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_TRUE);
    assert_eq!(looked_up(), seamless);
    glBindSampler(0, 0);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_FALSE);
    assert_eq!((flag(), looked_up()), (0, 255));
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_SEAMLESS, 2);
    assert_eq!((glGetError(), flag()), (GL_INVALID_VALUE, 0));
}
