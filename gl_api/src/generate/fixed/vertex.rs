//! The fixed-function vertex stage: GL 2.1, sections 2.11, 2.12 and 2.14.

use crate::base::clamp::Clamp;
use crate::base::vector::{clamped, dot, each, scale, transform, unit, words};
use crate::generate::fixed::light::{LightingKey, Lit, Vertex, light};
use crate::generate::fixed::word;
use crate::interface::*;
use crate::state::fog::FogSource;
use rasterizer::ir::{Builder, Input, Module, Op, Output, Stage, Value};

/// The generation of a texture coordinate. Eye planes are transformed to object coordinates once per draw, so that both
/// linear modes are the same code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Generated {
    Linear,
    SphereMap,
    ReflectionMap,
    NormalMap,
}

/// The treatment of normals in eye coordinates. Rescaling is part of their matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Normals {
    Unnormalized,
    Normalized,
}

/// The source of the point size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum PointSize {
    /// Pipeline state.
    Constant,
    /// Attenuated with the distance from the eye.
    Attenuated,
}

/// The state that the code depends on.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct VertexKey {
    /// First uniform word of the fixed function.
    pub base: u32,
    /// The units whose texture matrix is not the identity, bit by unit.
    pub matrices: u8,
    /// How each unit's s, t, r and q are generated.
    pub generated: [[Option<Generated>; 4]; MAX_TEXTURE_UNITS as usize],
    pub lighting: Option<LightingKey>,
    /// As they are where nothing reads them.
    pub normals: Normals,
    /// The user clip planes that are on, bit by plane.
    pub clip_planes: u8,
    pub fog: FogSource,
    pub point_size: PointSize,
    /// Whether colours are clamped.
    pub clamp: Clamp,
}

impl VertexKey {
    /// Whether normals are read.
    pub fn reads_normals(&self) -> bool {
        self.lighting.is_some()
            || self.generated.iter().flatten().flatten().any(|mode| *mode != Generated::Linear)
    }
}

/// The four components of a vertex attribute.
pub(crate) fn attribute(b: &mut Builder, location: u8) -> [Value; 4] {
    [0, 1, 2, 3].map(|component| b.input(Input::Attribute { location, component }))
}

fn write(b: &mut Builder, output: Output, value: Value) {
    let var = b.output(output);
    b.store(var, value);
}

fn write_varyings(b: &mut Builder, first: u16, values: [Value; 4]) {
    for (slot, value) in (first..).zip(values) {
        write(b, Output::Varying(slot), value);
    }
}

/// Generates the stage. It writes every varying of the fixed function; the driver leaves out what
/// the fragment stage does not read.
pub(crate) fn module(key: &VertexKey) -> Module {
    let mut b = Builder::new(Stage::Vertex);
    let position = attribute(&mut b, ATTRIB_VERTEX);
    let clip = transform(&mut b, key.base + word::MVP, position);
    for (component, value) in (0..).zip(clip) {
        write(&mut b, Output::Position(component), value);
    }
    for plane in (0..MAX_CLIP_PLANES).filter(|plane| key.clip_planes >> plane & 1 == 1) {
        let plane_words = words(&mut b, key.base + word::CLIP_PLANES + 4 * u32::from(plane));
        let distance = dot(&mut b, plane_words, position);
        write(&mut b, Output::ClipDistance(plane), distance);
    }
    let eye = eye(&mut b, key, position);
    let normal = normal(&mut b, key);
    colors(&mut b, key, eye, normal);
    let fog = match key.fog {
        FogSource::Depth => b.op(Op::Neg, &[eye[2]]),
        FogSource::Coordinate => attribute(&mut b, ATTRIB_FOG_COORD)[0],
    };
    write(&mut b, Output::Varying(VARYING_FOG), fog);
    tex_coords(&mut b, key, position, eye, normal);
    if key.point_size == PointSize::Attenuated {
        let size = point_size(&mut b, key, eye);
        write(&mut b, Output::PointSize, size);
    }
    b.finish()
}

/// The position in eye coordinates, w divided out.
fn eye(b: &mut Builder, key: &VertexKey, position: [Value; 4]) -> [Value; 3] {
    let [x, y, z, w] = transform(b, key.base + word::MODELVIEW, position);
    [x, y, z].map(|component| b.op(Op::Div, &[component, w]))
}

/// The normal in eye coordinates (section 2.11.3).
fn normal(b: &mut Builder, key: &VertexKey) -> [Value; 3] {
    let [x, y, z, _] = attribute(b, ATTRIB_NORMAL);
    let normal = transform(b, key.base + word::NORMAL, [x, y, z]);
    match key.normals {
        Normals::Unnormalized => normal,
        Normals::Normalized => unit(b, normal).0,
    }
}

/// Colours of both sides, clamped if the state says so (section 2.14.6).
fn colors(b: &mut Builder, key: &VertexKey, eye: [Value; 3], normal: [Value; 3]) {
    let (front, back) = match &key.lighting {
        Some(lighting) => light(b, lighting, key.base, &Vertex { eye, normal }),
        None => {
            let primary = attribute(b, ATTRIB_COLOR);
            let secondary = attribute(b, ATTRIB_SECONDARY_COLOR);
            (Lit { primary, secondary }, None)
        }
    };
    let sides = [
        (Some(&front), VARYING_COLOR, VARYING_SECONDARY_COLOR),
        (back.as_ref(), VARYING_BACK_COLOR, VARYING_BACK_COLOR + 4),
    ];
    for (lit, primary, secondary) in sides {
        let Some(lit) = lit else { continue };
        for (slot, values) in [(primary, lit.primary), (secondary, lit.secondary)] {
            let values = values.map(|value| clamped(b, key.clamp, value));
            write_varyings(b, slot, values);
        }
    }
}

/// The coordinates of every unit: generated (section 2.11.4), then transformed.
fn tex_coords(
    b: &mut Builder,
    key: &VertexKey,
    position: [Value; 4],
    eye: [Value; 3],
    normal: [Value; 3],
) {
    let modes = || key.generated.iter().flatten().flatten();
    let reflects =
        |mode: &Generated| matches!(mode, Generated::SphereMap | Generated::ReflectionMap);
    let reflection = modes().any(reflects).then(|| reflection(b, eye, normal));
    let sphere = reflection
        .filter(|_| modes().any(|mode| *mode == Generated::SphereMap))
        .map(|reflection| sphere(b, reflection));
    for unit in 0..MAX_TEXTURE_UNITS {
        let mut coords = attribute(b, ATTRIB_TEX_COORD + unit);
        for (at, mode) in key.generated[usize::from(unit)].iter().enumerate() {
            let of = |vector: Option<[Value; 3]>| vector.and_then(|v| v.get(at).copied());
            let generated = match mode {
                None => None,
                Some(Generated::Linear) => {
                    let number = 4 * u32::from(unit) + at as u32;
                    let plane = words(b, key.base + word::PLANES + 4 * number);
                    Some(dot(b, plane, position))
                }
                Some(Generated::SphereMap) => sphere.and_then(|v| v.get(at).copied()),
                Some(Generated::ReflectionMap) => of(reflection),
                Some(Generated::NormalMap) => of(Some(normal)),
            };
            coords[at] = generated.unwrap_or(coords[at]);
        }
        if key.matrices >> unit & 1 == 1 {
            let first = key.base + word::TEXTURE_MATRIX + 16 * u32::from(unit);
            coords = transform(b, first, coords);
        }
        write_varyings(b, VARYING_TEX_COORD + 4 * u16::from(unit), coords);
    }
}

/// `u - 2 n (n · u)`, `u` the unit vector from the eye to the vertex.
fn reflection(b: &mut Builder, eye: [Value; 3], normal: [Value; 3]) -> [Value; 3] {
    let (toward, _) = unit(b, eye);
    let cosine = dot(b, normal, toward);
    let two = b.float(2.0);
    let twice = b.op(Op::Mul, &[two, cosine]);
    let change = scale(b, normal, twice);
    each(b, Op::Sub, toward, change)
}

/// s and t of a sphere map.
fn sphere(b: &mut Builder, [x, y, z]: [Value; 3]) -> [Value; 2] {
    let one = b.float(1.0);
    let z = b.op(Op::Add, &[z, one]);
    let (unit, _) = unit(b, [x, y, z]);
    let half = b.float(0.5);
    [unit[0], unit[1]].map(|component| {
        let component = b.op(Op::Mul, &[component, half]);
        b.op(Op::Add, &[component, half])
    })
}

/// The size that falls with the distance (section 3.3).
fn point_size(b: &mut Builder, key: &VertexKey, eye: [Value; 3]) -> Value {
    let [size, least, most, constant, linear, quadratic] = words(b, key.base + word::POINT);
    let (_, distance) = unit(b, eye);
    let square = b.op(Op::Mul, &[quadratic, distance]);
    let slope = b.op(Op::Add, &[linear, square]);
    let rest = b.op(Op::Mul, &[slope, distance]);
    let sum = b.op(Op::Add, &[constant, rest]);
    let root = b.op(Op::Sqrt, &[sum]);
    let size = b.op(Op::Div, &[size, root]);
    let size = b.op(Op::Max, &[size, least]);
    b.op(Op::Min, &[size, most])
}
