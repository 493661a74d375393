//! Several textures at one point, as the colours, normals and gloss of a surface: what the second lookup takes over
//! from the first changes no pixel.

use super::program;
use gl_api::*;

/// Pixels across and up: whole blocks, and parts of some.
const SIDE: usize = 92;

/// A texture of its own colours with all levels.
fn texture(seed: usize, [internal, filter, wrap]: [GLenum; 3], [width, height]: [usize; 2]) -> u32 {
    let mut name = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter as i32);
    let mag = if filter == GL_NEAREST_MIPMAP_NEAREST { GL_NEAREST } else { GL_LINEAR };
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag as i32);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap as i32);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap as i32);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE as i32);
    let texels: Vec<u8> =
        (0..4 * width * height).map(|i| ((i * (2 * seed + 37)) % 251) as u8).collect();
    let (width, height, ty) = (width as i32, height as i32, GL_UNSIGNED_BYTE);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, GL_RGBA, ty, &texels);
    name
}

/// A floor in perspective: levels from the first to the last, and whole batches of one.
fn picture(textures: [u32; 3]) -> Vec<u8> {
    for (unit, name) in (0..).zip(textures) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, name);
    }
    glBegin(GL_QUADS);
    for (x, y, w, s, t) in [
        (-1.0, -1.0, 1.0, -0.2, 0.1),
        (1.0, -1.0, 1.0, 1.4, -0.3),
        (5.0, 5.0, 5.0, 7.0, 6.0),
        (-5.0, 5.0, 5.0, -3.0, 8.0),
    ] {
        glTexCoord2f(s, t);
        glVertex4f(x, y, 0.0, w);
    }
    glEnd();
    let mut bytes = vec![0_u8; SIDE * SIDE * 4];
    glReadPixels(0, 0, SIDE as i32, SIDE as i32, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes[..]);
    assert_eq!(glGetError(), GL_NO_ERROR);
    bytes
}

#[test]
fn lookups_at_one_point_are_those_that_each_makes_alone() {
    let side = SIDE as u32;
    let desc = ContextDesc { width: side, height: side, ..ContextDesc::default() };
    let _current = Context::new(desc).expect("a device").make_current();
    let program = program(
        "varying vec2 at; void main() { at = gl_MultiTexCoord0.st; gl_Position = gl_Vertex; }",
        "uniform sampler2D a, b, c; varying vec2 at;
         void main() {
             vec4 x = texture2D(a, at), y = texture2D(b, at), z = texture2D(c, at);
             gl_FragColor = 0.4 * x.brga + 0.3 * y * z + 0.2 * y.gbra + 0.1 * z;
         }",
    )
    .expect("a program");
    glUseProgram(program);
    for (unit, name) in (0..).zip(["a", "b", "c"]) {
        glUniform1i(glGetUniformLocation(program, name), unit);
    }
    let filters =
        [GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR];
    for filter in filters {
        for wrap in [GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER] {
            for [a, b] in [[GL_RGBA8, GL_RGBA8], [GL_RGB8, GL_RGB8], [GL_RGB8, GL_RGBA8]] {
                for sizes in [[[64, 32]; 2], [[64, 32], [32, 64]]] {
                    let first = texture(1, [a, filter, wrap], sizes[0]);
                    let others = [2, 3].map(|seed| texture(seed, [b, filter, wrap], sizes[1]));
                    let together = picture([first, others[0], others[1]]);
                    // A largest level of detail that is never reached makes no difference, but then nothing is
                    // known to be alike.
                    for (name, largest) in others.into_iter().zip([900.0, 800.0]) {
                        glBindTexture(GL_TEXTURE_2D, name);
                        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, largest);
                    }
                    let apart = picture([first, others[0], others[1]]);
                    let what = format!("{filter:#x} {wrap:#x} {a:#x} {b:#x} {sizes:?}");
                    let differ = together.iter().zip(&apart).filter(|(a, b)| a != b).count();
                    assert_eq!(differ, 0, "{what}");
                    // A texture that is not there.
                    assert!(picture([first, 0, others[1]]) != together, "{what}");
                    assert!(picture([0, others[0], others[1]]) != together, "{what}");
                }
            }
        }
    }
}
