//! The fixed vertex stage: texture coordinate generation (section 2.11.4), the texture matrix
//! (2.11.2), normals (2.11.3), and the lighting equation (2.14.1).

use super::matrix::{self, Matrix};
use crate::mutation::{Mutation, Variant};

type V3 = [f64; 3];

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: V3) -> V3 {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

fn xyz(v: [f64; 4]) -> V3 {
    [v[0], v[1], v[2]]
}

/// A vertex in eye coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Object coordinates.
    pub object: [f64; 4],
    /// `M · object`.
    pub position: [f64; 4],
    /// `n · M⁻¹`, of unit length (`GL_NORMALIZE`).
    pub normal: V3,
}

/// A vertex through the model-view matrix.
pub fn eye(model_view: &Matrix, object: [f64; 4], normal: V3, variant: Variant) -> Eye {
    let position = matrix::apply(model_view, object);
    let row = [normal[0], normal[1], normal[2], 0.0];
    let turned = if variant.has(Mutation::NormalByMatrix) {
        matrix::apply(model_view, row)
    } else {
        matrix::apply_row(row, &matrix::inverse(model_view))
    };
    let normal =
        if variant.has(Mutation::NormalNotNormalized) { xyz(turned) } else { unit(xyz(turned)) };
    Eye { object, position, normal }
}

/// `GL_TEXTURE_GEN_MODE`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TexGen {
    /// `GL_OBJECT_LINEAR` with a plane for each coordinate.
    ObjectLinear([[f64; 4]; 4]),
    /// `GL_EYE_LINEAR` with planes that were given under this model-view matrix.
    EyeLinear([[f64; 4]; 4], Matrix),
    /// `GL_SPHERE_MAP`, of s and t.
    SphereMap,
    /// `GL_REFLECTION_MAP`, of s, t and r.
    ReflectionMap,
    /// `GL_NORMAL_MAP`, of s, t and r.
    NormalMap,
}

impl TexGen {
    /// (s, t, r, q); what a mode does not generate stays `given`.
    pub fn coordinates(&self, vertex: &Eye, given: [f64; 4], variant: Variant) -> [f64; 4] {
        let linear = |plane: [f64; 4], at: [f64; 4]| -> f64 {
            plane.iter().zip(at).map(|(a, b)| a * b).sum()
        };
        let u = unit(xyz(vertex.position));
        let n = vertex.normal;
        let sign = if variant.has(Mutation::ReflectionReversed) { 1.0 } else { -1.0 };
        let r: V3 = std::array::from_fn(|c| u[c] + sign * 2.0 * n[c] * dot(n, u));
        match self {
            Self::ObjectLinear(planes) => {
                let eye = variant.has(Mutation::ObjectPlaneInEyeSpace);
                planes.map(|plane| linear(plane, if eye { vertex.position } else { vertex.object }))
            }
            Self::EyeLinear(planes, given_under) => {
                let inverse = matrix::inverse(given_under);
                let kept = variant.has(Mutation::EyePlaneNotMoved);
                planes.map(|plane| {
                    let moved = if kept { plane } else { matrix::apply_row(plane, &inverse) };
                    linear(moved, vertex.position)
                })
            }
            Self::SphereMap => {
                let one = if variant.has(Mutation::SphereMapWithoutOne) { 0.0 } else { 1.0 };
                let m = 2.0 * (r[0] * r[0] + r[1] * r[1] + (r[2] + one).powi(2)).sqrt();
                [r[0] / m + 0.5, r[1] / m + 0.5, given[2], given[3]]
            }
            Self::ReflectionMap => [r[0], r[1], r[2], given[3]],
            Self::NormalMap => [n[0], n[1], n[2], given[3]],
        }
    }
}

/// A light source (table 2.10).
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "GL's names")]
pub struct Light {
    pub ambient: [f64; 4],
    pub diffuse: [f64; 4],
    pub specular: [f64; 4],
    /// Eye coordinates; w = 0 is infinitely far.
    pub position: [f64; 4],
    pub spot_direction: V3,
    pub spot_exponent: f64,
    /// Degrees, up to 90, or 180.
    pub spot_cutoff: f64,
    /// Constant, linear, quadratic.
    pub attenuation: V3,
}

/// A material, and the light model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "GL's names")]
pub struct Surface {
    pub ambient: [f64; 4],
    pub diffuse: [f64; 4],
    pub specular: [f64; 4],
    pub emission: [f64; 4],
    pub shininess: f64,
    pub scene_ambient: [f64; 4],
    /// `GL_LIGHT_MODEL_LOCAL_VIEWER`.
    pub local_viewer: bool,
}

/// The colour of a lit vertex, clamped to [0, 1].
pub fn light(vertex: &Eye, lights: &[Light], of: &Surface, variant: Variant) -> [f64; 4] {
    let mut color: [f64; 4] =
        std::array::from_fn(|c| of.emission[c] + of.ambient[c] * of.scene_ambient[c]);
    let v = xyz(vertex.position);
    let n = vertex.normal;
    let positive = |x: f64| x.max(0.0);
    for light in lights {
        let local = light.position[3] != 0.0;
        let to: V3 = if local {
            std::array::from_fn(|c| light.position[c] / light.position[3] - v[c])
        } else {
            xyz(light.position)
        };
        let distance = dot(to, to).sqrt();
        let to = unit(to);
        let [k0, k1, k2] = light.attenuation;
        let attenuation = if local && !variant.has(Mutation::AttenuationIgnored) {
            1.0 / (k0 + k1 * distance + k2 * distance * distance)
        } else {
            1.0
        };
        let spot = if light.spot_cutoff == 180.0 || variant.has(Mutation::SpotIgnored) {
            1.0
        } else {
            let cosine = -dot(to, unit(light.spot_direction));
            if cosine < light.spot_cutoff.to_radians().cos() {
                0.0
            } else {
                positive(cosine).powf(light.spot_exponent)
            }
        };
        let toward_eye = if of.local_viewer != variant.has(Mutation::ViewerConfused) {
            unit(v.map(|c| -c))
        } else {
            [0.0, 0.0, 1.0]
        };
        let half = if variant.has(Mutation::HalfVectorIsReflection) {
            to
        } else {
            unit(std::array::from_fn(|c| to[c] + toward_eye[c]))
        };
        let facing = dot(n, to);
        let shine = if facing > 0.0 { positive(dot(n, half)).powf(of.shininess) } else { 0.0 };
        for (c, color) in color.iter_mut().enumerate().take(3) {
            *color += attenuation
                * spot
                * (of.ambient[c] * light.ambient[c]
                    + positive(facing) * of.diffuse[c] * light.diffuse[c]
                    + shine * of.specular[c] * light.specular[c]);
        }
    }
    color[3] = of.diffuse[3];
    color.map(|c| c.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_that_faces_the_eye_reflects_it() {
        let identity: Matrix =
            std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        let vertex = eye(&identity, [0.0, 0.0, -4.0, 1.0], [0.0, 0.0, 2.0], Variant::CORRECT);
        let given = [0.0, 0.0, 0.25, 1.0];
        assert_eq!(
            TexGen::ReflectionMap.coordinates(&vertex, given, Variant::CORRECT)[..3],
            [0.0, 0.0, 1.0]
        );
        assert_eq!(
            TexGen::SphereMap.coordinates(&vertex, given, Variant::CORRECT),
            [0.5, 0.5, 0.25, 1.0]
        );
    }
}
