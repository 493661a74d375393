//! The lighting equation: sections 2.14.1 to 2.14.6.

use crate::oracle::{Light, Material, Model, Vec3, lit};
use crate::shading::use_program;
use crate::{
    BYTE, Random, assert_close, color, context, point, probe, probed, times, transform, triangle,
};
use gl_api::*;
use glam::{DMat3, DMat4};

/// A random state of lighting.
#[derive(Clone, Debug)]
struct State {
    modelview: DMat4,
    z: f64,
    normal: Vec3,
    lights: Vec<Light>,
    /// Of front and back.
    materials: [Material; 2],
    model: Model,
    normalize: bool,
    rescale: bool,
    /// What `glColorMaterial` says.
    tracked: Option<(GLenum, GLenum)>,
    vertex_color: [f32; 4],
    /// Whether the colour is given at each vertex.
    varies: bool,
}

impl State {
    fn random(random: &mut Random) -> Self {
        let material = |random: &mut Random| Material {
            emission: if random.chance(30) { random.color().map(|c| c * 0.2) } else { [0.0; 4] },
            ambient: random.color().map(|c| c * 0.4),
            diffuse: random.color(),
            specular: if random.chance(70) { random.color() } else { [0.0; 4] },
            shininess: random.of(&[0.0, 1.0, 7.5, 64.0, 128.0]),
        };
        let light = |random: &mut Random| Light {
            ambient: random.color().map(|c| c * 0.3),
            diffuse: random.color().map(|c| c * 0.7),
            specular: if random.chance(80) { random.color() } else { [0.0; 4] },
            position: [
                random.between(-4.0, 4.0),
                random.between(-4.0, 4.0),
                random.between(-4.0, 4.0),
                random.of(&[0.0, 1.0, 2.0]),
            ],
            spot_direction: [0; 3].map(|_| random.between(-1.0, 1.0)),
            spot_exponent: random.of(&[0.0, 1.0, 10.0]),
            spot_cutoff: random.of(&[180.0, 180.0, 60.0, 90.0]),
            attenuation: random.of(&[[1.0, 0.0, 0.0], [0.5, 0.25, 0.0], [1.0, 0.0, 0.125]]),
        };
        let count = random.below(4);
        let faces = random.of(&[GL_FRONT, GL_BACK, GL_FRONT_AND_BACK]);
        let modes = [GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE];
        let mode = random.of(&modes);
        Self {
            modelview: random.modelview(),
            z: random.between(-1.0, 1.0),
            normal: [0; 3].map(|_| random.between(-1.0, 1.0)),
            lights: (0..count).map(|_| light(random)).collect(),
            materials: [material(random), material(random)],
            model: Model {
                ambient: random.color().map(|c| c * 0.5),
                local_viewer: random.chance(50),
                separate: random.chance(50),
            },
            normalize: random.chance(70),
            rescale: random.chance(30),
            tracked: random.chance(40).then_some((faces, mode)),
            vertex_color: random.color(),
            varies: random.chance(50),
        }
    }

    /// Sets it. Lights are given in eye coordinates; how they are transformed has a test of its own.
    fn set(&self, c: &mut Context) {
        c.load_identity();
        for index in 0..8 {
            c.disable(GL_LIGHT0 + index);
        }
        // Not the first lights only: a light's number must not matter.
        for (light, index) in self.lights.iter().zip([0, 3, 7]) {
            let name = GL_LIGHT0 + index;
            c.enable(name);
            c.lightfv(name, GL_AMBIENT, &light.ambient);
            c.lightfv(name, GL_DIFFUSE, &light.diffuse);
            c.lightfv(name, GL_SPECULAR, &light.specular);
            c.lightfv(name, GL_POSITION, &light.position.map(|x| x as f32));
            c.lightfv(name, GL_SPOT_DIRECTION, &light.spot_direction.map(|x| x as f32));
            c.lightf(name, GL_SPOT_EXPONENT, light.spot_exponent as f32);
            c.lightf(name, GL_SPOT_CUTOFF, light.spot_cutoff as f32);
            c.lightf(name, GL_CONSTANT_ATTENUATION, light.attenuation[0] as f32);
            c.lightf(name, GL_LINEAR_ATTENUATION, light.attenuation[1] as f32);
            c.lightf(name, GL_QUADRATIC_ATTENUATION, light.attenuation[2] as f32);
        }
        c.disable(GL_COLOR_MATERIAL);
        for (face, material) in [GL_FRONT, GL_BACK].into_iter().zip(&self.materials) {
            c.materialfv(face, GL_EMISSION, &material.emission);
            c.materialfv(face, GL_AMBIENT, &material.ambient);
            c.materialfv(face, GL_DIFFUSE, &material.diffuse);
            c.materialfv(face, GL_SPECULAR, &material.specular);
            c.materialf(face, GL_SHININESS, material.shininess as f32);
        }
        c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &self.model.ambient);
        c.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, self.model.local_viewer.into());
        let control =
            if self.model.separate { GL_SEPARATE_SPECULAR_COLOR } else { GL_SINGLE_COLOR };
        c.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, control as GLint);
        c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        c.enable(GL_LIGHTING);
        for (cap, on) in [(GL_NORMALIZE, self.normalize), (GL_RESCALE_NORMAL, self.rescale)] {
            if on { c.enable(cap) } else { c.disable(cap) }
        }
        if let Some((faces, mode)) = self.tracked {
            c.color_material(faces, mode);
            c.enable(GL_COLOR_MATERIAL);
        }
        c.color_4fv(&self.vertex_color);
        c.normal_3fv(&self.normal.map(|x| x as f32));
        transform(c, self.modelview);
    }

    /// The material of a side, with what follows the vertex's colour.
    fn material(&self, side: usize) -> Material {
        let mut material = self.materials[side].clone();
        let face = [GL_FRONT, GL_BACK][side];
        if let Some((faces, mode)) = self.tracked
            && (faces == face || faces == GL_FRONT_AND_BACK)
        {
            let color = self.vertex_color;
            match mode {
                GL_EMISSION => material.emission = color,
                GL_AMBIENT => material.ambient = color,
                GL_DIFFUSE => material.diffuse = color,
                GL_SPECULAR => material.specular = color,
                _ => (material.ambient, material.diffuse) = (color, color),
            }
        }
        material
    }

    /// Primary and secondary colour of a side at object coordinates.
    fn expected(&self, place: Vec3, side: usize) -> ([f64; 4], [f64; 4]) {
        let [x, y, z, w] = times(&self.modelview, [place[0], place[1], place[2], 1.0]);
        let inverse = DMat3::from_mat4(self.modelview).inverse();
        let mut normal = inverse.transpose() * glam::DVec3::from(self.normal);
        if self.rescale && !self.normalize {
            normal /= inverse.row(2).length();
        }
        if self.normalize {
            normal = normal.normalize();
        }
        if side == 1 {
            normal = -normal;
        }
        let eye = [x / w, y / w, z / w];
        lit(eye, normal.to_array(), &self.material(side), &self.model, &self.lights)
    }

    fn color_at_vertices(&self, c: &mut Context) {
        if self.varies {
            c.color_4fv(&self.vertex_color);
        }
    }
}

/// 24 bits of both colours of the front, through a program that reads them: within 4e-6 of the
/// equation, 1e-4 under an exponent of 128, which multiplies the error of its base.
#[test]
fn colors_follow_the_equation() {
    for value in ["gl_Color", "gl_SecondaryColor"] {
        let mut c = context();
        let mask = probe(&mut c, value);
        for seed in 0..150 {
            let state = State::random(&mut Random::new(seed));
            state.set(&mut c);
            let found = probed(&mut c, mask, |c| {
                c.begin(GL_POINTS);
                state.color_at_vertices(c);
                c.vertex_3d(0.0, 0.0, state.z);
                c.end();
            });
            let (primary, secondary) = state.expected([0.0, 0.0, state.z], 0);
            let expected = if value == "gl_Color" { primary } else { secondary };
            assert_close(found, expected, 2e-5, &state);
        }
    }
}

/// Through the fixed fragment stage, both sides; separate specular is added there.
#[test]
fn both_sides_are_lit() {
    let mut c = context();
    c.shade_model(GL_FLAT);
    for seed in 1000..1200 {
        let state = State::random(&mut Random::new(seed));
        state.set(&mut c);
        for side in [0, 1] {
            c.color_4fv(&state.vertex_color);
            triangle(&mut c, state.z, side == 0);
            let (primary, secondary) = state.expected([0.0, 4.0, state.z], side);
            let expected = [0, 1, 2, 3].map(|i| (primary[i] + secondary[i]).min(1.0));
            assert_close(color(&mut c), expected, BYTE, &(side, &state));
        }
    }
}

#[test]
fn one_sided_lighting_shows_the_front_on_both_sides() {
    let mut c = context();
    c.enable(GL_LIGHTING);
    c.materialfv(GL_FRONT, GL_EMISSION, &[1.0, 0.0, 0.0, 1.0]);
    c.materialfv(GL_BACK, GL_EMISSION, &[0.0, 1.0, 0.0, 1.0]);
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
    for (two_side, back) in [(0, [255, 0, 0, 255]), (1, [0, 255, 0, 255])] {
        c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, two_side);
        for (front, expected) in [(true, [255, 0, 0, 255]), (false, back)] {
            triangle(&mut c, 0.0, front);
            assert_eq!(color(&mut c), expected.map(|byte| f64::from(byte) / 255.0), "{two_side}");
        }
        c.front_face(GL_CW);
        triangle(&mut c, 0.0, true);
        assert_eq!(color(&mut c), back.map(|byte: u8| f64::from(byte) / 255.0), "{two_side}");
        c.front_face(GL_CCW);
    }
}

#[test]
fn positions_and_directions_are_brought_to_the_eye_when_they_are_given() {
    let mut c = context();
    let modelview = Random::new(9).modelview();
    c.load_matrixd(&modelview.to_cols_array());
    c.lightfv(GL_LIGHT2, GL_POSITION, &[1.0, 2.0, 3.0, 1.0]);
    c.lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, &[1.0, 0.5, -1.0]);
    c.load_identity();
    let (mut position, mut direction) = ([0.0; 4], [0.0; 3]);
    c.get_lightfv(GL_LIGHT2, GL_POSITION, &mut position);
    c.get_lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, &mut direction);
    let expected = times(&modelview, [1.0, 2.0, 3.0, 1.0]).map(|x| x as f32);
    assert_eq!(position, expected);
    let expected = DMat3::from_mat4(modelview) * glam::DVec3::new(1.0, 0.5, -1.0);
    assert_eq!(direction, expected.to_array().map(|x| x as f32));
}

#[test]
fn a_flattening_matrix_and_a_normal_of_length_zero_are_harmless() {
    let mut c = context();
    c.enable(GL_LIGHTING);
    c.enable(GL_LIGHT0);
    c.enable(GL_NORMALIZE);
    c.materialfv(GL_FRONT, GL_SPECULAR, &[1.0; 4]);
    // The identity stands in for the inverse that is not there: the normal stays as it is.
    c.scalef(1.0, 1.0, 0.0);
    point(&mut c, 0.0);
    assert_close(color(&mut c), [1.0; 4], BYTE, &"flattened");
    c.load_identity();
    c.normal_3f(0.0, 0.0, 0.0);
    point(&mut c, 0.0);
    assert_close(color(&mut c), [0.04, 0.04, 0.04, 1.0], BYTE, &"no normal");
}

#[test]
fn tracked_colours_stay_when_tracking_ends() {
    let mut c = context();
    c.enable(GL_COLOR_MATERIAL);
    c.color_4f(0.25, 0.5, 0.75, 1.0);
    let mut diffuse = [0.0; 4];
    c.get_materialfv(GL_BACK, GL_DIFFUSE, &mut diffuse);
    assert_eq!(diffuse, [0.25, 0.5, 0.75, 1.0]);
    c.materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &[1.0; 4]);
    c.disable(GL_COLOR_MATERIAL);
    c.color_4f(0.0, 0.0, 0.0, 0.0);
    c.get_materialfv(GL_FRONT, GL_DIFFUSE, &mut diffuse);
    assert_eq!(diffuse, [0.25, 0.5, 0.75, 1.0]);
}

#[test]
fn a_material_may_change_between_primitives() {
    let mut c = context();
    c.enable(GL_LIGHTING);
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
    let corners = |c: &mut Context, x: f64| {
        c.vertex_3d(x - 8.0, -8.0, 0.0);
        c.vertex_3d(x + 8.0, -8.0, 0.0);
        c.vertex_3d(x, 8.0, 0.0);
    };
    c.begin(GL_TRIANGLES);
    c.materialfv(GL_FRONT, GL_EMISSION, &[0.0, 1.0, 0.0, 1.0]);
    corners(&mut c, 0.0);
    c.materialfv(GL_FRONT, GL_EMISSION, &[1.0, 0.0, 0.0, 1.0]);
    corners(&mut c, 100.0);
    c.end();
    assert_eq!(color(&mut c), [0.0, 1.0, 0.0, 1.0]);
}

/// Section 2.14.6: a colour above one is clamped at its vertex, not in the fragment.
#[test]
fn colours_of_programs_are_clamped_at_vertices() {
    let mut c = context();
    let source = "void main() { gl_Position = gl_Vertex; gl_FrontColor = gl_Vertex.xxxx * 0.5; }";
    use_program(&mut c, source, "");
    // 2 and -2 at the sides are clamped to 1 and 0: in the middle 1/2, not 0.
    c.begin(GL_QUADS);
    for (x, y) in [(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)] {
        c.vertex_3d(x, y, 0.0);
    }
    c.end();
    assert_close(color(&mut c), [0.5; 4], BYTE, &"clamped");
}
