//! The lighting equation, fog and generated coordinates in `f64`, from the formulas of GL 2.1.

pub type Vec3 = [f64; 3];

pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn normalize(v: Vec3) -> Vec3 {
    let length = dot(v, v).sqrt();
    if length == 0.0 { v } else { v.map(|x| x / length) }
}

pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [0, 1, 2].map(|i| a[i] - b[i])
}

pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// A light in eye coordinates.
#[derive(Clone, Debug)]
pub struct Light {
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub position: [f64; 4],
    pub spot_direction: Vec3,
    pub spot_exponent: f64,
    pub spot_cutoff: f64,
    pub attenuation: [f64; 3],
}

#[derive(Clone, Debug)]
pub struct Material {
    pub emission: [f32; 4],
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub shininess: f64,
}

#[derive(Clone, Debug)]
pub struct Model {
    pub ambient: [f32; 4],
    pub local_viewer: bool,
    pub separate: bool,
}

/// Section 2.14.1: the primary and the secondary colour, clamped.
pub fn lit(
    eye: Vec3,
    normal: Vec3,
    material: &Material,
    model: &Model,
    lights: &[Light],
) -> ([f64; 4], [f64; 4]) {
    let product = |a: [f32; 4], b: [f32; 4], i: usize| f64::from(a[i]) * f64::from(b[i]);
    let mut primary = [0, 1, 2]
        .map(|i| f64::from(material.emission[i]) + product(material.ambient, model.ambient, i));
    let mut secondary = [0.0; 3];
    for light in lights {
        let [x, y, z, w] = light.position;
        let local = w != 0.0;
        let difference = if local { sub([x / w, y / w, z / w], eye) } else { [x, y, z] };
        let distance = dot(difference, difference).sqrt();
        let toward = normalize(difference);
        let [k0, k1, k2] = light.attenuation;
        let mut intensity =
            if local { 1.0 / (k0 + k1 * distance + k2 * distance * distance) } else { 1.0 };
        if light.spot_cutoff != 180.0 {
            let cosine = dot(toward.map(|x| -x), normalize(light.spot_direction));
            let inside = cosine >= light.spot_cutoff.to_radians().cos();
            intensity *= if inside { cosine.max(0.0).powf(light.spot_exponent) } else { 0.0 };
        }
        let viewer = if model.local_viewer { normalize(eye.map(|x| -x)) } else { [0.0, 0.0, 1.0] };
        let half = normalize(add(toward, viewer));
        let facing = dot(normal, toward).max(0.0);
        let shine =
            if facing > 0.0 { dot(normal, half).max(0.0).powf(material.shininess) } else { 0.0 };
        for i in 0..3 {
            let ambient = product(material.ambient, light.ambient, i);
            let diffuse = facing * product(material.diffuse, light.diffuse, i);
            let specular = shine * product(material.specular, light.specular, i);
            primary[i] += intensity * (ambient + diffuse);
            *(if model.separate { &mut secondary } else { &mut primary }).get_mut(i).unwrap() +=
                intensity * specular;
        }
    }
    let [r, g, b] = primary;
    let [r2, g2, b2] = secondary;
    let clamp = |x: f64| x.clamp(0.0, 1.0);
    ([r, g, b, material.diffuse[3].into()].map(clamp), [r2, g2, b2, 0.0].map(clamp))
}

/// Section 2.11.4: s, t and r of a sphere map, a reflection map.
pub fn reflect(eye: Vec3, normal: Vec3) -> (Vec3, Vec3) {
    let toward = normalize(eye);
    let cosine = dot(normal, toward);
    let [x, y, z] = [0, 1, 2].map(|i| toward[i] - 2.0 * normal[i] * cosine);
    let m = 2.0 * (x * x + y * y + (z + 1.0) * (z + 1.0)).sqrt();
    ([x / m + 0.5, y / m + 0.5, 0.0], [x, y, z])
}
