//! The formulas of the lectures: map shapes, bump mapping, the bounce vector, the
//! checker, perspective along an edge, multitexturing.

use super::builtin::Inputs;
use crate::mutation::{Mutation, Variant};
use crate::rng::Rng;
use std::f64::consts::PI;

/// A formula of a lecture, and the same as GLSL.
#[derive(Clone, Copy, Debug)]
pub struct Formula {
    /// The name of the formula.
    pub what: &'static str,
    /// The lecture.
    pub lecture: &'static str,
    /// The GLSL that defines `value()`.
    pub glsl: &'static str,
    /// A random case.
    pub case: fn(&mut Rng) -> [[f32; 4]; 3],
    /// The formula.
    pub value: fn(&Inputs, Variant) -> [f64; 4],
}

type V3 = [f64; 3];

fn xyz(v: [f64; 4]) -> V3 {
    [v[0], v[1], v[2]]
}

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn four(v: V3) -> [f64; 4] {
    [v[0], v[1], v[2], 0.0]
}

fn vectors(rng: &mut Rng) -> [[f32; 4]; 3] {
    [0; 3].map(|_: i32| [0; 4].map(|_: i32| rng.real(-1.0, 1.0)))
}

/// Away from the y axis, where the longitude is undefined, and from its seam.
fn point(rng: &mut Rng) -> [[f32; 4]; 3] {
    loop {
        let p = [0; 3].map(|_: i32| rng.real(-1.0, 1.0));
        if p[0].abs() + p[2].abs() > 0.1 && p[2].abs() > 1e-3 {
            return [[p[0], p[1], p[2], 0.0], [0.0; 4], [0.0; 4]];
        }
    }
}

fn depths(rng: &mut Rng) -> [[f32; 4]; 3] {
    let [t, z1, z2] = [rng.real(0.0, 1.0), rng.real(1.0, 64.0), rng.real(1.0, 64.0)];
    [[t, z1, z2, 0.0], [0.0; 4], [0.0; 4]]
}

/// s, t, r; w and q.
fn projected(rng: &mut Rng) -> [[f32; 4]; 3] {
    let [str, _, _] = vectors(rng);
    [str, [rng.real(1.0, 64.0), rng.real(0.5, 4.0), 0.0, 0.0], [0.0; 4]]
}

/// Away from the edges of the checks.
fn surface(rng: &mut Rng) -> [[f32; 4]; 3] {
    loop {
        let st = [0; 2].map(|_: i32| rng.real(0.0, 4.0));
        let inside = |c: f32| (0.001..0.999).contains(&(20.0 * f64::from(c)).fract());
        if st.into_iter().all(inside) {
            return [[st[0], st[1], 0.0, 0.0], [0.0; 4], [0.0; 4]];
        }
    }
}

fn longitude(x: f64, z: f64, variant: Variant) -> f64 {
    let theta = if variant.has(Mutation::LongitudeOfXZ) { x.atan2(z) } else { z.atan2(x) };
    0.5 + theta / (2.0 * PI)
}

/// (u, v) of a point on a sphere about the origin, of any radius.
fn spherical(inputs: &Inputs, variant: Variant) -> [f64; 4] {
    let [x, y, z] = xyz(inputs[0]);
    let phi = (y / dot([x, y, z], [x, y, z]).sqrt()).acos();
    [longitude(x, z, variant), 1.0 - phi / PI, 0.0, 0.0]
}

/// Every formula.
pub const FORMULAS: &[Formula] = &[
    Formula {
        what: "bounce vector 2(w·n)n - w",
        lecture: "CS380, materials",
        glsl: "vec3 bounce(vec3 w, vec3 n) { return n * (dot(w, n) * 2.0) - w; }
               vec4 value() { return vec4(bounce(a.xyz, b.xyz), 0.0); }",
        case: vectors,
        value: |i, variant| {
            let (w, n) = (xyz(i[0]), xyz(i[1]));
            let sign = if variant.has(Mutation::BounceReversed) { 1.0 } else { -1.0 };
            four(std::array::from_fn(|c| 2.0 * dot(w, n) * n[c] + sign * w[c]))
        },
    },
    Formula {
        what: "normal of a normal map, 2R - 1",
        lecture: "CS380, normal mapping",
        glsl: "vec4 value() { return vec4(2.0 * abs(a.xyz) - 1.0, 0.0); }",
        case: vectors,
        value: |i, variant| {
            let half = if variant.has(Mutation::NormalUndecoded) { 0.0 } else { 1.0 };
            four(xyz(i[0]).map(|c| 2.0 * c.abs() - half))
        },
    },
    Formula {
        what: "displaced point P + h·N, N = S × T",
        lecture: "1st lecture, displacement (Blinn 1976)",
        glsl: "vec4 value() { return vec4(a.xyz + a.w * cross(b.xyz, c.xyz), 0.0); }",
        case: vectors,
        value: |i, variant| {
            let n = if variant.has(Mutation::CrossReversed) {
                cross(xyz(i[2]), xyz(i[1]))
            } else {
                cross(xyz(i[1]), xyz(i[2]))
            };
            four(std::array::from_fn(|c| i[0][c] + i[0][3] * n[c]))
        },
    },
    Formula {
        what: "perturbed normal N + hu(T × N) + hv(S × N)",
        lecture: "1st lecture, bump mapping (Blinn 1976)",
        glsl: "vec4 value() {
                   vec3 s = b.xyz, t = c.xyz;
                   vec3 n = cross(s, t);
                   return vec4(n + b.w * cross(t, n) + c.w * cross(s, n), 0.0);
               }",
        case: vectors,
        value: |i, variant| {
            let (s, t) = (xyz(i[1]), xyz(i[2]));
            let n = cross(s, t);
            let (tn, sn) = (cross(t, n), cross(s, n));
            let (hu, hv) = if variant.has(Mutation::BumpAxesSwapped) {
                (i[2][3], i[1][3])
            } else {
                (i[1][3], i[2][3])
            };
            four(std::array::from_fn(|c| n[c] + hu * tn[c] + hv * sn[c]))
        },
    },
    Formula {
        what: "perturbed normal as the product it stands for, P'u × P'v = N + hu(N × T) + hv(S × N)",
        lecture: "1st lecture, bump mapping: the slide prints T × N for N × T",
        glsl: "vec4 value() {
                   vec3 s = b.xyz, t = c.xyz;
                   vec3 n = cross(s, t);
                   return vec4(cross(s + b.w * n, t + c.w * n), 0.0);
               }",
        case: vectors,
        value: |i, variant| {
            let (s, t) = (xyz(i[1]), xyz(i[2]));
            let n = cross(s, t);
            let is_as_printed = variant.has(Mutation::CrossReversed);
            let first = if is_as_printed { cross(t, n) } else { cross(n, t) };
            let second = cross(s, n);
            four(std::array::from_fn(|c| n[c] + i[1][3] * first[c] + i[2][3] * second[c]))
        },
    },
    Formula {
        what: "projective short cut: (s/w) · (w/q) = s/q, one reciprocal of q/w",
        lecture: "1st lecture, interpolation in OpenGL",
        glsl: "vec4 value() {
                   vec3 over_w = a.xyz / b.x;
                   float w_over_q = 1.0 / (b.y / b.x);
                   return vec4(over_w * w_over_q, 0.0);
               }",
        case: projected,
        value: |i, variant| {
            let q = if variant.has(Mutation::Affine) { 1.0 } else { i[1][1] };
            four(xyz(i[0]).map(|c| c / q))
        },
    },
    Formula {
        what: "the lecture's ρ: the larger gradient of u and of v",
        lecture: "1st lecture, mipmap LOD selection (OpenGL's is over x and y)",
        glsl: "vec4 value() { // a: du/dx, du/dy; b: dv/dx, dv/dy
                   return vec4(max(length(a.xy), length(b.xy)), 0.0, 0.0, 0.0);
               }",
        case: vectors,
        value: |i, variant| {
            let [du, dv] = [0, 1].map(|at| [i[at][0], i[at][1]]);
            let is_opengl = variant.has(Mutation::BumpAxesSwapped);
            let pair = if is_opengl { [[du[0], dv[0]], [du[1], dv[1]]] } else { [du, dv] };
            let [first, second] = pair.map(|[x, y]| (x * x + y * y).sqrt());
            [first.max(second), 0.0, 0.0, 0.0]
        },
    },
    Formula {
        what: "planar mapping (x/w, z/h)",
        lecture: "TA 6, planar mapping",
        glsl: "vec4 value() { return vec4(a.x / 3.0, a.z / 5.0, 0.0, 0.0); }",
        case: point,
        value: |i, variant| {
            let v = if variant.has(Mutation::PlanarOfXY) { i[0][1] } else { i[0][2] };
            [i[0][0] / 3.0, v / 5.0, 0.0, 0.0]
        },
    },
    Formula {
        what: "spherical mapping: θ = atan2(z, x), φ = acos(y/r); u = 1/2 + θ/2π, v = 1 - φ/π",
        lecture: "TA 6, spherical mapping",
        glsl: "const float PI = 3.14159265358979;
               vec4 value() {
                   float r = sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
                   float theta = atan(a.z, a.x);
                   float phi = acos(a.y / r);
                   return vec4(0.5 + theta / (2.0 * PI), 1.0 - phi / PI, 0.0, 0.0);
               }",
        case: point,
        value: spherical,
    },
    Formula {
        what: "spherical mapping of a point that is eight times as far: the same (u, v)",
        lecture: "TA 6, spherical mapping: independent of scale",
        glsl: "const float PI = 3.14159265358979;
               vec4 value() {
                   vec3 p = 8.0 * a.xyz;
                   float phi = acos(p.y / sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
                   return vec4(0.5 + atan(p.z, p.x) / (2.0 * PI), 1.0 - phi / PI, 0.0, 0.0);
               }",
        case: point,
        value: spherical,
    },
    Formula {
        what: "u = au·s + bu·t + cu, v = av·s + bv·t + cv",
        lecture: "2nd lecture, slide 7",
        glsl: "vec4 value() {
                   mat3 m = mat3(a.x, b.x, 0.0, a.y, b.y, 0.0, a.z, b.z, 1.0);
                   return vec4((m * vec3(c.xy, 1.0)).xy, 0.0, 0.0);
               }",
        case: vectors,
        value: |[a, b, st], _| {
            let row = |m: &[f64; 4]| m[0] * st[0] + m[1] * st[1] + m[2];
            [row(a), row(b), 0.0, 0.0]
        },
    },
    Formula {
        what: "cylindrical mapping: θ = atan2(z, x); u = 1/2 + θ/2π, v = y/h",
        lecture: "TA 6, cylindrical mapping",
        glsl: "const float PI = 3.14159265358979;
               vec4 value() {
                   return vec4(0.5 + atan(a.z, a.x) / (2.0 * PI), a.y / 2.0, 0.0, 0.0);
               }",
        case: point,
        value: |i, variant| [longitude(i[0][0], i[0][2], variant), i[0][1] / 2.0, 0.0, 0.0],
    },
    Formula {
        what: "RenderMan checker: mod(10s, 1) < 1/2 differs from mod(10t, 1) < 1/2",
        lecture: "1st lecture, surface shader",
        glsl: "vec4 value() {
                   float smod = mod(10.0 * a.x, 1.0), tmod = mod(10.0 * a.y, 1.0);
                   bool same = smod < 0.5 ? tmod < 0.5 : !(tmod < 0.5);
                   return vec4(same ? 1.0 : 0.0);
               }",
        case: surface,
        value: |i, variant| {
            let low = |c: f64| (10.0 * c).rem_euclid(1.0) < 0.5;
            let same = low(i[0][0]) == low(i[0][1]);
            [f64::from(u8::from(same != variant.has(Mutation::CheckerInverted))); 4]
        },
    },
    Formula {
        what: "place on an edge in space of a place on the screen: s = t·z1 / (z2 + t(z1 - z2))",
        lecture: "eScience, perspective correction, slide 21",
        glsl: "vec4 value() {
                   float t = a.x, w1 = 1.0 / a.y, w2 = 1.0 / a.z;
                   return vec4(t * w2 / (w1 + t * (w2 - w1)), 0.0, 0.0, 0.0);
               }",
        case: depths,
        value: |i, variant| {
            let [t, z1, z2, _] = i[0];
            let s = if variant.has(Mutation::Affine) { t } else { t * z1 / (z2 + t * (z1 - z2)) };
            [s, 0.0, 0.0, 0.0]
        },
    },
    Formula {
        what: "(diffuse × decal) + (specular × gloss)",
        lecture: "1st lecture, multitexturing",
        glsl: "vec4 value() { return a * b + c * a.wzyx; }",
        case: vectors,
        value: |i, variant| {
            std::array::from_fn(|c| {
                let gloss = if variant.has(Mutation::GlossIgnored) { 1.0 } else { i[0][3 - c] };
                i[0][c] * i[1][c] + i[2][c] * gloss
            })
        },
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halfway_on_the_screen_is_nearer_the_near_end() {
        let edge = FORMULAS.iter().find(|f| f.what.starts_with("place")).map(|f| f.value);
        let s = edge.map(|f| f(&[[0.5, 1.0, 3.0, 0.0], [0.0; 4], [0.0; 4]], Variant::CORRECT)[0]);
        assert_eq!(s, Some(0.25));
    }
}
