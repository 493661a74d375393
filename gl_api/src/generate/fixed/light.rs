//! Code of the lighting equation: GL 2.1, section 2.14.1.

use crate::base::vector::{at_least_zero, dot, each, scale, unit, words};
use crate::generate::fixed::vertex::attribute;
use crate::generate::fixed::word;
use crate::interface::{MAX_LIGHTS, Side};
use rasterizer::ir::{Builder, Op, Ty, Value};

/// The position of a light, and whether it is attenuated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum LightPosition {
    /// At infinity.
    Infinite,
    /// At a point, without attenuation.
    Local,
    /// At a point, attenuated with the distance.
    Attenuated,
}

/// Whether a light is a spotlight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Spot {
    /// No spotlight.
    Off,
    /// Constant intensity within the cone.
    Even,
    /// Intensity falls toward the edge of the cone.
    Focused,
}

/// The state of a light that the code depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct LightKey {
    pub position: LightPosition,
    pub spot: Spot,
    /// Whether its specular product with any material is not black.
    pub specular: bool,
}

/// The source of each parameter of a side's material: a vertex attribute by location, or uniform words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Varying {
    pub emission: Option<u8>,
    pub ambient: Option<u8>,
    pub diffuse: Option<u8>,
    pub specular: Option<u8>,
    pub shininess: Option<u8>,
}

/// The state of lighting that the code depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct LightingKey {
    /// The lights that are on.
    pub lights: [Option<LightKey>; MAX_LIGHTS as usize],
    /// Whether the eye's direction depends on the vertex.
    pub local_viewer: bool,
    pub two_sided: bool,
    /// Whether the specular term goes to the secondary colour.
    pub separate_specular: bool,
    /// Which parts of the materials of front and back are the vertex's own.
    pub materials: [Varying; 2],
}

impl LightingKey {
    /// Which parts of a side's material are the vertex's own.
    pub fn varying(&self, side: Side) -> Varying {
        match side {
            Side::Front => self.materials[0],
            Side::Back => self.materials[1],
        }
    }
}

/// The lit colours of a side, not yet clamped.
pub(crate) struct Lit {
    pub primary: [Value; 4],
    pub secondary: [Value; 4],
}

/// The vertex for which lighting is computed.
pub(crate) struct Vertex {
    /// In eye coordinates.
    pub eye: [Value; 3],
    pub normal: [Value; 3],
}

/// Terms of a light at a vertex that are independent of side and material.
struct Ray {
    /// `n · VP`, of the front.
    diffuse: Value,
    /// `n · h`, of the front; where the light has a specular term.
    specular: Option<Value>,
    /// Attenuation and spotlight together.
    intensity: Option<Value>,
}

/// The product of the factors that there are.
fn product(b: &mut Builder, left: Option<Value>, right: Option<Value>) -> Option<Value> {
    match (left, right) {
        (Some(left), Some(right)) => Some(b.op(Op::Mul, &[left, right])),
        (left, right) => left.or(right),
    }
}

fn ray(b: &mut Builder, key: &LightingKey, light: LightKey, at: u32, vertex: &Vertex) -> Ray {
    let position: [Value; 3] = words(b, at);
    let (toward, attenuation) = match light.position {
        LightPosition::Infinite => (position, None),
        LightPosition::Local | LightPosition::Attenuated => {
            let difference = each(b, Op::Sub, position, vertex.eye);
            let (toward, distance) = unit(b, difference);
            let attenuated = light.position == LightPosition::Attenuated;
            (toward, attenuated.then(|| attenuation(b, at + 11, distance)))
        }
    };
    let spot = match light.spot {
        Spot::Off => None,
        Spot::Even | Spot::Focused => Some(spot(b, light.spot, at + 6, toward)),
    };
    let specular = light.specular.then(|| {
        let half = if key.local_viewer {
            let opposite = vertex.eye.map(|component| b.op(Op::Neg, &[component]));
            let (viewer, _) = unit(b, opposite);
            let sum = each(b, Op::Add, toward, viewer);
            unit(b, sum).0
        } else if light.position == LightPosition::Infinite {
            words(b, at + 3)
        } else {
            let one = b.float(1.0);
            let z = b.op(Op::Add, &[toward[2], one]);
            unit(b, [toward[0], toward[1], z]).0
        };
        dot(b, vertex.normal, half)
    });
    Ray {
        diffuse: dot(b, vertex.normal, toward),
        specular,
        intensity: product(b, attenuation, spot),
    }
}

/// `1 / (k0 + k1 d + k2 d²)`.
fn attenuation(b: &mut Builder, at: u32, distance: Value) -> Value {
    let [constant, linear, quadratic] = words(b, at);
    let square = b.op(Op::Mul, &[quadratic, distance]);
    let slope = b.op(Op::Add, &[linear, square]);
    let rest = b.op(Op::Mul, &[slope, distance]);
    let sum = b.op(Op::Add, &[constant, rest]);
    let one = b.float(1.0);
    b.op(Op::Div, &[one, sum])
}

/// `(PV · s)` to the power of the exponent inside the cone, 0 outside.
fn spot(b: &mut Builder, spot: Spot, at: u32, toward: [Value; 3]) -> Value {
    let [x, y, z, cos_cutoff, exponent] = words(b, at);
    let opposite = dot(b, toward, [x, y, z]);
    let cosine = b.op(Op::Neg, &[opposite]);
    // Not clamped before it is compared: a cutoff of 90 degrees leaves out what is behind.
    let inside = b.op(Op::LessEqual, &[cos_cutoff, cosine]);
    let power = match spot {
        Spot::Focused => {
            let base = at_least_zero(b, cosine);
            b.op(Op::Pow, &[base, exponent])
        }
        Spot::Off | Spot::Even => b.float(1.0),
    };
    let zero = b.float(0.0);
    b.op(Op::SelectF, &[inside, power, zero])
}

/// A colour that is a product of light and material: of uniform words, or, where the material's
/// part is the vertex's, of the light's words and that attribute.
fn colored(b: &mut Builder, at: u32, color: Option<u8>) -> [Value; 3] {
    let product = words(b, at);
    match color {
        Some(location) => {
            let [red, green, blue, _] = attribute(b, location);
            each(b, Op::Mul, product, [red, green, blue])
        }
        None => product,
    }
}

/// The colours of a side.
fn side(b: &mut Builder, key: &LightingKey, base: u32, rays: &[(usize, Ray)], side: Side) -> Lit {
    let own = key.varying(side);
    let material = base + word::material(side);

    let mut primary: [Value; 3] = words(b, material);
    if let Some(location) = own.emission {
        let [red, green, blue, _] = attribute(b, location);
        primary = each(b, Op::Add, primary, [red, green, blue]);
    }
    if own.ambient.is_some() {
        let scene = colored(b, base + word::MODEL_AMBIENT, own.ambient);
        primary = each(b, Op::Add, primary, scene);
    }
    // What no vertex changes comes first, so that it is summed once a draw.
    let (everywhere, near): (Vec<_>, Vec<_>) =
        rays.iter().partition(|(_, ray)| ray.intensity.is_none());
    for (index, _) in &everywhere {
        let at = base + word::products(*index, side);
        let ambient = colored(b, at, own.ambient);
        primary = each(b, Op::Add, primary, ambient);
    }
    let mut secondary = [b.float(0.0); 3];
    for (index, ray) in everywhere.into_iter().chain(near) {
        let at = base + word::products(*index, side);
        let faced = |b: &mut Builder, cosine: Value| {
            let cosine = match side {
                Side::Front => cosine,
                Side::Back => b.op(Op::Neg, &[cosine]),
            };
            at_least_zero(b, cosine)
        };
        let cosine = faced(b, ray.diffuse);
        let diffuse = colored(b, at + 3, own.diffuse);
        let mut sum = scale(b, diffuse, cosine);
        if ray.intensity.is_some() {
            let ambient = colored(b, at, own.ambient);
            sum = each(b, Op::Add, ambient, sum);
        }
        let specular = ray.specular.map(|half| {
            let half = faced(b, half);
            let shininess = match own.shininess {
                Some(location) => attribute(b, location)[0],
                None => b.uniform(material + 4, Ty::F32),
            };
            let power = b.op(Op::Pow, &[half, shininess]);
            let zero = b.float(0.0);
            let lit = b.op(Op::Less, &[zero, cosine]);
            let power = b.op(Op::SelectF, &[lit, power, zero]);
            let specular = colored(b, at + 6, own.specular);
            scale(b, specular, power)
        });
        let intense = |b: &mut Builder, color: [Value; 3]| match ray.intensity {
            Some(intensity) => scale(b, color, intensity),
            None => color,
        };
        match specular {
            Some(specular) if key.separate_specular => {
                let specular = intense(b, specular);
                secondary = each(b, Op::Add, secondary, specular);
            }
            Some(specular) => sum = each(b, Op::Add, sum, specular),
            None => {}
        }
        let sum = intense(b, sum);
        primary = each(b, Op::Add, primary, sum);
    }
    let alpha = match own.diffuse {
        Some(location) => attribute(b, location)[3],
        None => b.uniform(material + 3, Ty::F32),
    };
    let [red, green, blue] = primary;
    let [red2, green2, blue2] = secondary;
    let none = b.float(0.0);
    Lit { primary: [red, green, blue, alpha], secondary: [red2, green2, blue2, none] }
}

/// The lit colours of the front, and of the back if both sides are lit.
pub(crate) fn light(
    b: &mut Builder,
    key: &LightingKey,
    base: u32,
    vertex: &Vertex,
) -> (Lit, Option<Lit>) {
    let mut rays = Vec::new();
    for (index, light) in key.lights.iter().enumerate() {
        if let Some(light) = light {
            rays.push((index, ray(b, key, *light, base + word::light(index), vertex)));
        }
    }
    let front = side(b, key, base, &rays, Side::Front);
    let back = key.two_sided.then(|| side(b, key, base, &rays, Side::Back));
    (front, back)
}
