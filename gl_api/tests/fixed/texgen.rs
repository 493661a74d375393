//! Generated coordinates (section 2.11.4), texture matrices and user clip planes (section 2.12).

use crate::oracle::reflect;
use crate::{Random, assert_close, context, pixel, point, probe, probed, times, transform};
use gl_api::*;
use glam::{DMat3, DMat4, DVec3, DVec4};

const COORDS: [GLenum; 4] = [GL_S, GL_T, GL_R, GL_Q];
const ENABLES: [GLenum; 4] =
    [GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q];

/// A program that sees coordinates from -16 to 16 of a unit.
fn coordinates(c: &mut Context, unit: usize) -> GLint {
    probe(c, &format!("(gl_TexCoord[{unit}] / 32.0 + 0.5)"))
}

#[test]
fn coordinates_follow_the_formulas() {
    for unit in [0_u32, 7] {
        let mut c = context();
        let mask = coordinates(&mut c, unit as usize);
        c.active_texture(GL_TEXTURE0 + unit);
        for seed in 0..120 {
            let mut random = Random::new(seed + 1000 * u64::from(unit));
            let (at_planes, at_draw) = (random.modelview(), random.modelview());
            let z = random.between(-1.0, 1.0);
            let normal = [0; 3].map(|_| random.between(-1.0, 1.0));
            let given = [0; 4].map(|_| random.between(-3.0, 3.0));
            let matrix = if random.chance(50) { random.modelview() } else { DMat4::IDENTITY };
            let normalize = random.chance(60);

            let eye = times(&at_draw, [0.0, 0.0, z, 1.0]);
            let eye = [0, 1, 2].map(|i| eye[i] / eye[3]);
            let mut n = DMat3::from_mat4(at_draw).inverse().transpose() * DVec3::from(normal);
            if normalize {
                n = n.normalize();
            }
            let (sphere, reflection) = reflect(eye, n.to_array());

            c.load_matrixd(&at_planes.to_cols_array());
            let mut expected = given;
            for i in 0..4 {
                let mut modes = vec![GL_OBJECT_LINEAR, GL_EYE_LINEAR];
                if i < 3 {
                    modes.extend([GL_REFLECTION_MAP, GL_NORMAL_MAP]);
                }
                if i < 2 {
                    modes.push(GL_SPHERE_MAP);
                }
                let mode = random.of(&modes);
                let plane = [0; 4].map(|_| random.between(-0.5, 0.5));
                let on = random.chance(80);
                c.tex_geni(COORDS[i], GL_TEXTURE_GEN_MODE, mode as GLint);
                c.tex_gendv(COORDS[i], GL_OBJECT_PLANE, &plane);
                c.tex_gendv(COORDS[i], GL_EYE_PLANE, &plane);
                if !on {
                    c.disable(ENABLES[i]);
                    continue;
                }
                c.enable(ENABLES[i]);
                let plane = DVec4::from(plane);
                expected[i] = match mode {
                    GL_OBJECT_LINEAR => plane.dot(DVec4::new(0.0, 0.0, z, 1.0)),
                    GL_EYE_LINEAR => {
                        let row = at_planes.inverse().transpose() * plane;
                        row.dot(at_draw * DVec4::new(0.0, 0.0, z, 1.0))
                    }
                    GL_REFLECTION_MAP => reflection[i],
                    GL_NORMAL_MAP => n[i],
                    _ => sphere[i],
                };
            }
            c.matrix_mode(GL_TEXTURE);
            c.load_matrixd(&matrix.to_cols_array());
            transform(&mut c, at_draw);
            if normalize {
                c.enable(GL_NORMALIZE)
            } else {
                c.disable(GL_NORMALIZE)
            }
            c.normal_3fv(&normal.map(|x| x as f32));
            let target = GL_TEXTURE0 + unit;
            c.multi_tex_coord_4d(target, given[0], given[1], given[2], given[3]);
            let expected = times(&matrix, expected).map(|x| (x / 32.0 + 0.5).clamp(0.0, 1.0));
            let found = probed(&mut c, mask, |c| point(c, z));
            // Of a range of 32: coordinates are within 5e-5.
            assert_close(found, expected, 1.5e-6, &(seed, at_draw, normal, given));
        }
    }
}

#[test]
fn eye_planes_go_through_the_inverse_of_the_matrix() {
    let mut c = context();
    let modelview = Random::new(4).modelview();
    c.load_matrixd(&modelview.to_cols_array());
    let plane = [1.0, -2.0, 0.5, 3.0];
    c.tex_gendv(GL_T, GL_EYE_PLANE, &plane);
    c.clip_plane(GL_CLIP_PLANE3, &plane);
    c.load_identity();
    let expected = (modelview.inverse().transpose() * DVec4::from(plane)).to_array();
    let mut found = [0.0; 4];
    c.get_tex_gendv(GL_T, GL_EYE_PLANE, &mut found);
    assert_close(found, expected, 1e-12, &"eye plane");
    c.get_clip_plane(GL_CLIP_PLANE3, &mut found);
    assert_close(found, expected, 1e-12, &"clip plane");
}

/// A shadow map as MuJoCo's renderer has it: eye-linear coordinates through a texture matrix.
#[test]
fn projected_coordinates_divide_by_q() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as GLint);
    let texels: Vec<u8> = (0..16_u8).flat_map(|i| [16 * i, 255, 0, 255]).collect();
    let pixels = Data::Bytes(&texels);
    c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    c.enable(GL_TEXTURE_2D);
    c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE as GLint);
    for (coord, plane) in COORDS.into_iter().zip([
        [1.0, 0.0, 0.0, 2.5],
        [0.0, 1.0, 0.0, 1.5],
        [0.0; 4],
        [0.0, 0.0, 0.0, 4.0],
    ]) {
        c.tex_geni(coord, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR as GLint);
        c.tex_genfv(coord, GL_EYE_PLANE, &plane);
    }
    for cap in ENABLES {
        c.enable(cap);
    }
    point(&mut c, 0.0);
    // (2.5 / 4, 1.5 / 4) of 4 texels: column 2, row 1.
    assert_eq!(pixel(&mut c), [96, 255, 0, 255]);
}
