//! The state that programs read: each binding against what was set.

use super::{PASS, context, drawn, load, near};
use gl_api::*;

/// Which programs have it.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Both,
    Vertex,
    Fragment,
}
use Of::{Both, Fragment, Vertex};

/// State with a different value everywhere.
fn set(c: &mut Context) {
    for (face, base) in [(GL_FRONT, 0.0), (GL_BACK, 10.0)] {
        c.materialfv(face, GL_AMBIENT, &[base + 1.0, base + 2.0, base + 3.0, base + 4.0]);
        c.materialfv(face, GL_DIFFUSE, &[base + 2.0, base + 4.0, base + 6.0, base + 8.0]);
        c.materialfv(face, GL_SPECULAR, &[base + 3.0, base + 6.0, base + 9.0, base + 12.0]);
        c.materialfv(face, GL_EMISSION, &[base + 5.0, base + 5.5, base + 6.0, base + 6.5]);
        c.materialf(face, GL_SHININESS, base + 7.0);
    }
    let light = GL_LIGHT3;
    c.lightfv(light, GL_AMBIENT, &[0.5, 0.25, 0.125, 1.0]);
    c.lightfv(light, GL_DIFFUSE, &[2.0, 3.0, 4.0, 5.0]);
    c.lightfv(light, GL_SPECULAR, &[6.0, 7.0, 8.0, 9.0]);
    c.lightfv(light, GL_POSITION, &[0.0, 0.0, 4.0, 0.0]);
    c.lightfv(light, GL_SPOT_DIRECTION, &[0.0, 1.0, 2.0]);
    c.lightf(light, GL_SPOT_EXPONENT, 11.0);
    c.lightf(light, GL_SPOT_CUTOFF, 60.0);
    c.lightf(light, GL_CONSTANT_ATTENUATION, 1.5);
    c.lightf(light, GL_LINEAR_ATTENUATION, 2.5);
    c.lightf(light, GL_QUADRATIC_ATTENUATION, 3.5);
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.5, 0.5, 0.25, 1.0]);
    c.fogfv(GL_FOG_COLOR, &[0.1, 0.2, 0.3, 0.4]);
    c.fogf(GL_FOG_DENSITY, 0.75);
    c.fogf(GL_FOG_START, 2.0);
    c.fogf(GL_FOG_END, 10.0);
    c.clip_plane(GL_CLIP_PLANE2, &[1.0, 2.0, 3.0, 4.0]);
    c.point_size(3.0);
    c.point_parameterf(GL_POINT_SIZE_MIN, 2.0);
    c.point_parameterf(GL_POINT_SIZE_MAX, 9.0);
    c.point_parameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4.0);
    c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[0.5, 0.25, 0.125]);
    c.active_texture(GL_TEXTURE1);
    c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.6, 0.7, 0.8, 0.9]);
    c.tex_genfv(GL_T, GL_EYE_PLANE, &[5.0, 6.0, 7.0, 8.0]);
    c.tex_genfv(GL_R, GL_OBJECT_PLANE, &[8.0, 7.0, 6.0, 5.0]);
    c.matrix_mode(GL_TEXTURE);
    c.load_matrixf(&MATRIX);
    c.active_texture(GL_TEXTURE0);
    for number in [0, 7] {
        c.matrix_mode(GL_MATRIX0_ARB + number);
        c.load_matrixf(&MATRIX);
        c.scalef(1.0, 1.0, number as f32);
    }
    c.depth_range(0.25, 0.75);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// Columns (2, 0, 0, 0), (0, 4, 0, 0), (0, 0, 1, 0), (5, 6, 7, 1).
const MATRIX: [f32; 16] =
    [2.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 5.0, 6.0, 7.0, 1.0];

/// What a program reads, and what that is.
const ROWS: &[(Of, &str, [f32; 4])] = &[
    (Both, "state.material.ambient", [1.0, 2.0, 3.0, 4.0]),
    (Both, "state.material.front.diffuse", [2.0, 4.0, 6.0, 8.0]),
    (Both, "state.material.back.specular", [13.0, 16.0, 19.0, 22.0]),
    (Both, "state.material.back.emission", [15.0, 15.5, 16.0, 16.5]),
    (Both, "state.material.shininess", [7.0, 0.0, 0.0, 1.0]),
    (Both, "state.light[3].ambient", [0.5, 0.25, 0.125, 1.0]),
    (Both, "state.light[3].diffuse", [2.0, 3.0, 4.0, 5.0]),
    (Both, "state.light[3].specular", [6.0, 7.0, 8.0, 9.0]),
    (Both, "state.light[3].position", [0.0, 0.0, 4.0, 0.0]),
    (Both, "state.light[3].half", [0.0, 0.0, 1.0, 1.0]),
    (Both, "state.light[3].attenuation", [1.5, 2.5, 3.5, 11.0]),
    (Both, "state.light[3].spot.direction", [0.0, 1.0, 2.0, 0.5]),
    (Both, "state.lightmodel.ambient", [0.5, 0.5, 0.25, 1.0]),
    (Both, "state.lightmodel.scenecolor", [5.5, 6.5, 6.75, 8.0]),
    (Both, "state.lightmodel.back.scenecolor", [20.5, 21.5, 19.25, 18.0]),
    (Both, "state.lightprod[3].ambient", [0.5, 0.5, 0.375, 4.0]),
    (Both, "state.lightprod[3].front.diffuse", [4.0, 12.0, 24.0, 8.0]),
    (Both, "state.lightprod[3].back.specular", [78.0, 112.0, 152.0, 22.0]),
    (Both, "state.fog.color", [0.1, 0.2, 0.3, 0.4]),
    (Both, "state.fog.params", [0.75, 2.0, 10.0, 0.125]),
    (Vertex, "state.clip[2].plane", [1.0, 2.0, 3.0, 4.0]),
    (Vertex, "state.point.size", [3.0, 2.0, 9.0, 4.0]),
    (Vertex, "state.point.attenuation", [0.5, 0.25, 0.125, 1.0]),
    (Vertex, "state.texgen[1].eye.t", [5.0, 6.0, 7.0, 8.0]),
    (Vertex, "state.texgen[1].object.r", [8.0, 7.0, 6.0, 5.0]),
    (Fragment, "state.texenv[1].color", [0.6, 0.7, 0.8, 0.9]),
    (Fragment, "state.depth.range", [0.25, 0.75, 0.5, 1.0]),
    (Both, "state.matrix.modelview.row[1]", [0.0, 1.0, 0.0, 0.0]),
    (Both, "state.matrix.modelview[0].row[3]", [0.0, 0.0, 0.0, 1.0]),
    (Both, "state.matrix.projection.row[2]", [0.0, 0.0, 1.0, 0.0]),
    (Both, "state.matrix.mvp.row[0]", [1.0, 0.0, 0.0, 0.0]),
    (Both, "state.matrix.texture[1].row[0]", [2.0, 0.0, 0.0, 5.0]),
    (Both, "state.matrix.texture[1].inverse.row[1]", [0.0, 0.25, 0.0, -1.5]),
    (Both, "state.matrix.texture[1].transpose.row[3]", [5.0, 6.0, 7.0, 1.0]),
    (Both, "state.matrix.texture[1].invtrans.row[3]", [-2.5, -1.5, -7.0, 1.0]),
    (Both, "state.matrix.program[7].row[2]", [0.0, 0.0, 7.0, 7.0]),
    (Both, "state.matrix.program[1].row[2]", [0.0, 0.0, 1.0, 0.0]),
];

#[test]
fn each_binding_reads_its_state_in_both_stages() {
    for &(of, binding, expected) in ROWS {
        let forms = [
            format!("MOV r, {binding};"),
            format!("PARAM p = {binding}; MOV r, p;"),
            format!("PARAM p[] = {{ 1, {binding} }}; MOV r, p[1];"),
        ];
        for statements in &forms {
            let mut programs = Vec::new();
            if of != Fragment {
                programs.push(format!(
                    "!!ARBvp1.0\nOPTION ARB_position_invariant;\nTEMP r;\n{statements}\n\
                     MOV result.texcoord[0], r;\nEND"
                ));
            }
            if of != Vertex {
                programs
                    .push(format!("!!ARBfp1.0\nTEMP r;\n{statements}\nMOV result.color, r;\nEND"));
            }
            for text in programs {
                let mut c = context();
                set(&mut c);
                load(&mut c, PASS);
                load(&mut c, &text);
                let found = drawn(&mut c);
                assert!(near(found, expected), "{text}: {found:?} {expected:?}");
            }
        }
    }
}

#[test]
fn an_indexed_array_has_state_parameters_and_constants_side_by_side() {
    let text = "!!ARBvp1.0\nOPTION ARB_position_invariant;\nADDRESS A;\n\
        PARAM p[] = { {9, 8, 7, 6}, program.local[2..3], state.matrix.texture[1],\
        state.light[3].half, program.env[5] };\n\
        ARL A.x, program.local[0].x;\nMOV result.texcoord[0], p[A.x - 1];\nEND";
    let mut c = context();
    set(&mut c);
    load(&mut c, PASS);
    load(&mut c, text);
    let target = GL_VERTEX_PROGRAM_ARB;
    c.program_local_parameters_4fv(target, 2, 2, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    c.program_env_parameter_4dv(target, 5, &[0.5, 1.5, 2.5, 3.5]);
    let elements = [
        [9.0, 8.0, 7.0, 6.0],
        [1.0, 2.0, 3.0, 4.0],
        [5.0, 6.0, 7.0, 8.0],
        [2.0, 0.0, 0.0, 5.0],
        [0.0, 4.0, 0.0, 6.0],
        [0.0, 0.0, 1.0, 7.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0, 1.0],
        [0.5, 1.5, 2.5, 3.5],
    ];
    for (at, expected) in elements.into_iter().enumerate() {
        c.program_local_parameter_4d(target, 0, at as f64 + 1.5, 0.0, 0.0, 0.0);
        assert_eq!(drawn(&mut c), expected, "{at}");
    }
}

#[test]
fn vertices_bring_their_attributes() {
    for (attribute, expected) in [
        ("vertex.color", [0.5, 0.25, 0.125, 1.0]),
        ("vertex.color.secondary", [0.25, 0.5, 0.75, 1.0]),
        ("vertex.normal", [3.0, 4.0, 5.0, 1.0]),
        ("vertex.fogcoord", [6.0, 0.0, 0.0, 1.0]),
        ("vertex.texcoord", [1.0, 2.0, 3.0, 4.0]),
        ("vertex.texcoord[7]", [5.0, 6.0, 7.0, 8.0]),
        ("vertex.attrib[5]", [7.0, 8.0, 9.0, 10.0]),
        ("vertex.attrib[15]", [11.0, 0.0, 0.0, 1.0]),
    ] {
        let mut c = context();
        load(&mut c, PASS);
        load(
            &mut c,
            &format!(
                "!!ARBvp1.0\nMOV result.position, vertex.attrib[0];\n\
                 MOV result.texcoord[0], {attribute};\nEND"
            ),
        );
        c.color_4f(0.5, 0.25, 0.125, 1.0);
        c.secondary_color_3f(0.25, 0.5, 0.75);
        c.normal_3f(3.0, 4.0, 5.0);
        c.fog_coordf(6.0);
        c.multi_tex_coord_4f(GL_TEXTURE0, 1.0, 2.0, 3.0, 4.0);
        c.multi_tex_coord_4f(GL_TEXTURE7, 5.0, 6.0, 7.0, 8.0);
        c.vertex_attrib_4f(5, 7.0, 8.0, 9.0, 10.0);
        c.vertex_attrib_1f(15, 11.0);
        assert_eq!(drawn(&mut c), expected, "{attribute}");
    }
}
