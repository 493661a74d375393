//! A large depth texture that was drawn to is sampled from the tiles of the attachment: with the results of a texture that a
//! client gave the same depths.

use super::*;

/// Pixels along a side of the window.
const SIDE: i32 = 96;

/// The vertices of a triangle strip over the whole view volume: a plane of depth.
fn ground(slope: [f32; 2]) {
    glBegin(GL_TRIANGLE_STRIP);
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0_f32)] {
        glVertex3f(x, y, 0.2 + slope[0] * x + slope[1] * y);
    }
    glEnd();
}

/// Triangles of many sizes before and behind the ground.
fn triangles(count: usize, seed: &mut u32) {
    let mut number = || {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (*seed >> 8) as f32 / (1 << 23) as f32 - 1.0
    };
    glBegin(GL_TRIANGLES);
    for _ in 0..count {
        let (x, y, size) = (number(), number(), 0.01 + number().abs() * 0.3);
        for _ in 0..3 {
            glVertex3f(x + size * number(), y + size * number(), number());
        }
    }
    glEnd();
}

/// The window drawn with a depth comparison against the bound texture, which it shows from far and near, and beyond its
/// edges.
fn shadows(range: f32) -> Vec<u8> {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, SIDE, SIDE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (x, y, r) in [(-1.0, -1.0, 0.3), (1.0, -1.0, 0.9), (1.0, 1.0, 0.7), (-1.0, 1.0, 0.5_f32)] {
        glTexCoord3f(0.5 + range * (x + 0.2 * y), 0.5 + range * (y - 0.1 * x), r);
        glVertex2f(x, y);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    let mut out = vec![0; (SIDE * SIDE * 4) as usize];
    glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
    out
}

fn compare_with(filter: GLenum, wrap: GLenum) {
    for (name, value) in [
        (GL_TEXTURE_MIN_FILTER, filter),
        (GL_TEXTURE_MAG_FILTER, filter),
        (GL_TEXTURE_WRAP_S, wrap),
        (GL_TEXTURE_WRAP_T, wrap),
        (GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE),
        (GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL),
    ] {
        glTexParameteri(GL_TEXTURE_2D, name, value);
    }
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[0.6_f32, 0.0, 0.0, 0.0]);
}

#[test]
fn lookups_in_tiles_have_the_results_of_lookups_in_rows() {
    let side = SIDE as u32;
    let _current = context(side, side).make_current();
    let formats = [
        (GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
        (GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT),
        (GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
        (GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
    ];
    let (mut seed, mut pictures, mut changed) = (1, Vec::new(), 0);
    for (internal, format, ty) in formats {
        for [width, height] in [[2048, 2048], [2100, 2001], [200, 100_i32]] {
            let (mut textures, mut framebuffer) = ([0; 2], [0]);
            glGenTextures(2, &mut textures);
            glGenFramebuffers(1, &mut framebuffer);
            for texture in textures {
                glBindTexture(GL_TEXTURE_2D, texture);
                glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, ty, NULL);
            }
            let point = match format {
                GL_DEPTH_STENCIL => GL_DEPTH_STENCIL_ATTACHMENT,
                _ => GL_DEPTH_ATTACHMENT,
            };
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[0]);
            glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, textures[0], 0);
            glDrawBuffer(GL_NONE);
            glReadBuffer(GL_NONE);
            // Cleared only; a plane; a plane and triangles; triangles before a plane; a part of it cleared again.
            for scene in 0..5 {
                glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[0]);
                glViewport(0, 0, width, height);
                glEnable(GL_DEPTH_TEST);
                glClearDepth(if scene == 0 { 0.55 } else { 1.0 });
                glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
                match scene {
                    0 => {}
                    1 => ground([0.3, -0.1]),
                    2 => {
                        ground([0.0, 0.4]);
                        triangles(60, &mut seed);
                    }
                    3 => {
                        triangles(60, &mut seed);
                        ground([-0.2, 0.2]);
                    }
                    _ => {
                        ground([0.25, 0.25]);
                        glEnable(GL_SCISSOR_TEST);
                        glScissor(width / 3, height / 4, width / 2, height / 3);
                        glClear(GL_DEPTH_BUFFER_BIT);
                        glDisable(GL_SCISSOR_TEST);
                    }
                }
                let from = |texture: GLuint| -> Vec<Vec<u8>> {
                    glBindTexture(GL_TEXTURE_2D, texture);
                    let modes = [
                        (GL_LINEAR, GL_CLAMP_TO_EDGE),
                        (GL_NEAREST, GL_REPEAT),
                        (GL_LINEAR, GL_REPEAT),
                        (GL_LINEAR, GL_CLAMP_TO_BORDER),
                    ];
                    let all = modes.into_iter().flat_map(|(filter, wrap)| {
                        compare_with(filter, wrap);
                        [0.05, 0.4, 1.0].map(shadows)
                    });
                    all.collect()
                };
                let before = from(textures[0]);
                // Drawn to again while a lookup holds the tiles.
                glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[0]);
                glViewport(0, 0, width, height);
                triangles(10, &mut seed);
                let from_tiles = from(textures[0]);
                changed += usize::from(before != from_tiles);
                // Brought to rows by reading, and given to the other texture.
                let mut texels = vec![0_u32; (width * height) as usize];
                glGetTexImage(GL_TEXTURE_2D, 0, format, ty, &mut texels[..]);
                glBindTexture(GL_TEXTURE_2D, textures[1]);
                glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, ty, &texels[..]);
                let from_rows = from(textures[1]);
                for (number, (tiles, rows)) in from_tiles.iter().zip(&from_rows).enumerate() {
                    let what = (enum_name(internal), width, scene, number);
                    let first = (0..rows.len()).find(|at| tiles[*at] != rows[*at]);
                    assert_eq!(first.map(|at| at / 4), None, "{what:?} at this pixel");
                }
                pictures.extend(before.into_iter().chain(from_tiles));
            }
            glDeleteFramebuffers(1, &framebuffer);
            glDeleteTextures(2, &textures);
        }
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
    // Of 60 scenes.
    assert!(changed > 50, "triangles were seen in {changed} scenes");
    pictures.sort();
    pictures.dedup();
    assert!(pictures.len() > 300, "{} pictures differ", pictures.len());
}
