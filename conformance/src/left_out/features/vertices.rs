//! State of vertices, lights and primitives.

use crate::gl::*;
use crate::left_out::feature::{Feature, Reason};
use crate::left_out::scene::*;
use gl_api::constants::*;

pub(super) const LIST: &[Feature] = &[
    Feature::state(
        "normalize",
        "normalization of normals that have unit length",
        lit,
        || {
            lit();
            glEnable(GL_RESCALE_NORMAL);
        },
        draw_mesh,
    ),
    Feature::state(
        "black-light",
        "a second light that is black",
        lit,
        || {
            lit();
            glEnable(GL_LIGHT2);
            glLightfv(GL_LIGHT2, GL_DIFFUSE, &[0.0f32, 0.0, 0.0, 1.0]);
            glLightfv(GL_LIGHT2, GL_SPECULAR, &[0.0f32, 0.0, 0.0, 1.0]);
        },
        draw_mesh,
    ),
    Feature::state(
        "light-off",
        "parameters of lights that are off",
        lit,
        || {
            lit();
            glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, 20.0);
            glLightf(GL_LIGHT3, GL_QUADRATIC_ATTENUATION, 0.5);
        },
        draw_mesh,
    ),
    Feature::state(
        "attenuation-directional",
        "attenuation of a light that is infinitely far",
        lit,
        || {
            lit();
            glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.5);
        },
        draw_mesh,
    ),
    Feature::state(
        "two-side",
        "two-sided light where all faces are front",
        lit,
        || {
            lit();
            glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
            glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &[0.8f32, 0.5, 0.3, 1.0]);
        },
        draw_mesh,
    )
    .because(Reason::NotLeftOut),
    Feature::state(
        "two-side-culled",
        "two-sided light where back faces are culled",
        || {
            lit();
            glEnable(GL_CULL_FACE);
        },
        || {
            lit();
            glEnable(GL_CULL_FACE);
            glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        },
        draw_mesh,
    ),
    Feature::state(
        "material-back",
        "a material of back faces with light of one side",
        lit,
        || {
            lit();
            glMaterialfv(GL_BACK, GL_DIFFUSE, &[0.1f32, 0.9, 0.3, 1.0]);
        },
        draw_mesh,
    ),
    Feature::state(
        "shininess-unused",
        "a shininess where nothing is specular",
        || {
            lit();
            glMaterialfv(GL_FRONT, GL_SPECULAR, &[0.0f32, 0.0, 0.0, 1.0]);
            glMaterialf(GL_FRONT, GL_SHININESS, 0);
        },
        || {
            lit();
            glMaterialfv(GL_FRONT, GL_SPECULAR, &[0.0f32, 0.0, 0.0, 1.0]);
        },
        draw_mesh,
    ),
    Feature::state(
        "lighting-unused",
        "lights and materials without lighting",
        || {
            lit();
            glDisable(GL_LIGHTING);
            glDisable(GL_LIGHT0);
        },
        || {
            lit();
            glEnable(GL_COLOR_MATERIAL);
            glDisable(GL_LIGHTING);
        },
        draw_mesh,
    ),
    Feature::state(
        "clip-plane",
        "a clip plane that cuts nothing",
        lit,
        || {
            lit();
            glClipPlane(GL_CLIP_PLANE0, &[0.0f64, 0.0, 0.0, 1.0]);
            glEnable(GL_CLIP_PLANE0);
        },
        draw_mesh,
    )
    .because(Reason::NotLeftOut),
    Feature::state(
        "cull-nothing",
        "culling of back faces where all are front",
        lit,
        || {
            lit();
            glEnable(GL_CULL_FACE);
        },
        draw_mesh,
    ),
    Feature::state(
        "texture-array",
        "an array of texture coordinates without a texture",
        lit,
        || {
            lit();
            glTexCoordPointer(2, GL_FLOAT, 24, BUFFER_OFFSET(0));
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        },
        draw_mesh,
    ),
    Feature::state(
        "color-array",
        "an array of colours where materials are lit",
        lit,
        || {
            lit();
            glColorPointer(3, GL_FLOAT, 24, BUFFER_OFFSET(0));
            glEnableClientState(GL_COLOR_ARRAY);
        },
        draw_mesh,
    ),
    Feature::state(
        "fog-coordinate-array",
        "an array of fog coordinates without fog",
        lit,
        || {
            lit();
            glFogCoordPointer(GL_FLOAT, 24, BUFFER_OFFSET(0));
            glEnableClientState(GL_FOG_COORD_ARRAY);
        },
        draw_mesh,
    ),
    Feature::state(
        "polygon-offset-zero",
        "a polygon offset of 0 with a depth test",
        gouraud_with_depth,
        || {
            gouraud_with_depth();
            glEnable(GL_POLYGON_OFFSET_FILL);
        },
        draw_quad,
    ),
    Feature::state(
        "point-and-line",
        "state of points and lines while triangles are drawn",
        lit,
        || {
            lit();
            glPointSize(9.0);
            glLineWidth(5.0);
            glEnable(GL_POINT_SMOOTH);
            glEnable(GL_LINE_SMOOTH);
            glEnable(GL_LINE_STIPPLE);
            glLineStipple(3, 0x0f0f);
        },
        draw_mesh,
    ),
    Feature::state(
        "stipple-all",
        "a polygon stipple of ones",
        lit,
        || {
            lit();
            glPolygonStipple(&[0xffu8; 128]);
            glEnable(GL_POLYGON_STIPPLE);
        },
        draw_mesh,
    ),
    Feature::state(
        "flat-one-color",
        "smooth shading of one colour",
        || {
            mesh();
            glShadeModel(GL_FLAT);
        },
        mesh,
        draw_mesh,
    ),
];
