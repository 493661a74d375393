//! What the vertices of a draw make without effect: an alpha test that all pass, fog behind them, back faces that there
//! are none of. Vertices are read only where state asks for one of these, and up to the first that contradicts.

use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::vertex_facts::VertexFacts;
use crate::draw::color_clamp::draws_fractions;
use crate::draw::completeness::samples;
use crate::draw::fixed_function::keys::varying;
use crate::draw::material::material;
use crate::draw::no_effect;
use crate::draw::pipeline::{front_face, viewport};
use crate::interface::{ATTRIB_COLOR, ATTRIB_VERTEX, Side};
use crate::state::enable::Flag;
use crate::state::fog::{FogMode, FogSource};
use glam::{DMat4, DVec4};
use rasterizer::driver::{
    FrontFace, Topology, VertexBinding, VertexFormat, VertexSource, VertexType,
};
use texunit::sampler::Compare;

/// The vertices of larger draws are not looked at.
const MAX_VERTICES: u32 = 1 << 18;

/// How far what is interpolated may lie outside of the values at the vertices, relative to the largest of them.
const ROUNDING: f64 = 1e-3;

/// The rounding of a sum of four products of `f32`s, relative to the sum of their magnitudes.
const SINGLE: f64 = 4e-7;

/// Alpha above this is not looked at: sums with it round by more.
const LARGE: f32 = 1e3;

/// So many pixels from the viewport's centre, and farther, triangles may be cut.
const FAR: f64 = 4096.0;

impl VertexFacts {
    /// Those that state asks for.
    pub fn of(
        context: &Context,
        topology: Topology,
        vertices: &[VertexBinding],
        elements: &Elements,
    ) -> Self {
        let enables = &context.state.enables;
        let is_two_sided = enables.has(Flag::Lighting) && context.state.lights.model.two_side;
        let blends = context.state.fragment.buffers.iter().any(|buffer| buffer.blend);
        let scans = enables.has(Flag::AlphaTest) || enables.has(Flag::Fog) || is_two_sided;
        let (count, _) = elements.counts();
        if !(blends || scans)
            || !no_effect::leaves_out(context)
            || context.has_program()
            || enables.has(Flag::VertexProgram)
            || enables.has(Flag::FragmentProgram)
        {
            return Self::default();
        }
        let draw = Draw { context, vertices, elements, count };
        let of_state = Self { alpha_is_one: blends && draw.alpha_is_one(), ..Self::default() };
        // Samples may lie outside of a triangle whose values they take.
        let has_samples = samples(context, context.state.bindings.draw_framebuffer) != 0;
        if !scans || has_samples || count > MAX_VERTICES {
            return of_state;
        }
        Self {
            alpha_is_one: of_state.alpha_is_one,
            alpha_passes: enables.has(Flag::AlphaTest) && draw.alpha_passes(),
            is_before_fog: enables.has(Flag::Fog) && draw.is_before_fog(),
            all_front: is_two_sided
                && no_effect::shows_back_faces(context)
                && draw.all_front(topology),
        }
    }
}

/// Numbers of an attribute in memory.
struct Floats<'a> {
    bytes: &'a [u8],
    offset: usize,
    stride: usize,
    components: usize,
}

impl Floats<'_> {
    /// An element, with (0, 0, 0, 1) for what it lacks; `None` past the end.
    fn get(&self, number: u32) -> Option<[f32; 4]> {
        let start = self.stride.checked_mul(number as usize)?.checked_add(self.offset)?;
        let bytes = self.bytes.get(start..start.checked_add(4 * self.components)?)?;
        let mut value = [0.0, 0.0, 0.0, 1.0];
        for (component, bytes) in value.iter_mut().zip(bytes.as_chunks().0) {
            *component = f32::from_le_bytes(*bytes);
        }
        Some(value)
    }
}

/// A draw whose vertices are looked at.
struct Draw<'a> {
    context: &'a Context,
    vertices: &'a [VertexBinding],
    elements: &'a Elements,
    count: u32,
}

impl Draw<'_> {
    fn binding(&self, location: u8) -> Option<&VertexSource> {
        let mut bindings = self.vertices.iter();
        bindings.find(|binding| binding.location == location).map(|binding| &binding.source)
    }

    /// An attribute that has floats for each vertex.
    fn floats(source: &VertexSource) -> Option<Floats<'_>> {
        match source {
            VertexSource::Array {
                buffer,
                first: 0,
                offset,
                stride,
                ty: VertexType::F32,
                components,
                format: VertexFormat::Plain,
                divisor: 0,
            } => {
                let (offset, stride) = (*offset, *stride);
                let components = usize::from(*components);
                Some(Floats { bytes: buffer.bytes(), offset, stride, components })
            }
            VertexSource::Array { .. } | VertexSource::Constant(_) => None,
        }
    }

    /// Whether something holds for all vertices.
    fn all(&self, floats: &Floats<'_>, holds: impl Fn([f32; 4]) -> bool) -> bool {
        let mut numbers = (0..self.count).map(|at| self.elements.number(at));
        numbers.all(|number| floats.get(number).is_some_and(&holds))
    }

    /// The alpha test of every fragment, if its alpha is that of the vertices.
    fn alpha_passes(&self) -> bool {
        let fragment = &self.context.state.fragment;
        let reference = f64::from(fragment.alpha_ref);
        match fragment.alpha_func {
            Compare::Greater | Compare::GreaterEqual | Compare::NotEqual => {}
            Compare::Never
            | Compare::Less
            | Compare::Equal
            | Compare::LessEqual
            | Compare::Always => return false,
        }
        let is_above = |alpha: f32| alpha < LARGE && f64::from(alpha) - ROUNDING > reference;
        // Then clamping keeps what is above the reference there.
        1.0 - ROUNDING > reference && self.is_aliased() && self.alpha(is_above)
    }

    /// Whether state alone makes alpha 1.
    fn alpha_is_one(&self) -> bool {
        let is_of_state = |location| match self.binding(location) {
            Some(VertexSource::Array { components, .. }) => *components <= 3,
            Some(VertexSource::Constant(_)) | None => true,
        };
        let is_lit = self.context.state.enables.has(Flag::Lighting);
        let sides = [Side::Front, Side::Back];
        let are_of_state = match is_lit {
            true => sides.into_iter().all(|side| {
                let location = varying(self.context, self.vertices, side).diffuse;
                location.is_none_or(is_of_state)
            }),
            false => is_of_state(ATTRIB_COLOR),
        };
        are_of_state && self.is_aliased() && self.alpha(|alpha| alpha == 1.0)
    }

    /// Whether coverage has no part in alpha.
    fn is_aliased(&self) -> bool {
        let smooth = [Flag::PointSmooth, Flag::LineSmooth, Flag::PolygonSmooth];
        !smooth.into_iter().any(|flag| self.context.state.enables.has(flag))
    }

    /// Whether something holds for the alpha of all vertices.
    fn alpha(&self, holds: impl Fn(f32) -> bool) -> bool {
        let context = self.context;
        if !context.state.enables.has(Flag::Lighting) {
            return self.alpha_of(ATTRIB_COLOR, holds);
        }
        let of_side = |side| match varying(context, self.vertices, side).diffuse {
            Some(location) => self.alpha_of(location, &holds),
            None => holds(material(context, side).diffuse[3]),
        };
        of_side(Side::Front) && (!context.state.lights.model.two_side || of_side(Side::Back))
    }

    fn alpha_of(&self, location: u8, holds: impl Fn(f32) -> bool) -> bool {
        match self.binding(location) {
            Some(VertexSource::Constant([.., alpha])) => holds(*alpha),
            Some(VertexSource::Array { components: ..=3, .. }) => holds(1.0),
            Some(source) => Self::floats(source)
                .is_some_and(|floats| self.all(&floats, |[.., alpha]| holds(alpha))),
            None => {
                let current = self.context.state.current.get(usize::from(location));
                current.is_some_and(|[.., alpha]| holds(*alpha))
            }
        }
    }

    fn positions(&self) -> Option<Floats<'_>> {
        let own = self.binding(ATTRIB_VERTEX).or_else(|| self.binding(0));
        own.and_then(Self::floats)
    }

    /// Whether linear fog begins behind all vertices. The fog's factor is then 1, also where it is rounded.
    fn is_before_fog(&self) -> bool {
        let fog = &self.context.state.fog;
        let [start, end] = [fog.start, fog.end].map(f64::from);
        let modelview = self.context.state.matrices.modelview.top;
        // Buffers of floats show the sum with nothing of the fog's colour: it is no negative zero.
        let is_asked = fog.mode == FogMode::Linear
            && fog.source == FogSource::Depth
            && draws_fractions(self.context)
            && 0.0 < start
            && start < end
            && modelview.row(3) == DVec4::W;
        let limit = start - ROUNDING * end;
        let row = modelview.row(2);
        let is_before = |position: [f32; 4]| {
            let position = DVec4::from_array(position.map(f64::from));
            let terms = (row * position).abs().element_sum();
            position.w == 1.0 && row.dot(position).abs() + SINGLE * terms < limit
        };
        is_asked && self.positions().is_some_and(|floats| self.all(&floats, is_before))
    }

    /// Whether all triangles lie before the eye and show their front, so that no rounding of their corners turns one.
    fn all_front(&self, topology: Topology) -> bool {
        let is_asked = matches!(topology, Topology::Triangles)
            && self.count >= 3
            && self.context.state.clip.enabled == 0;
        let Some(floats) = self.positions().filter(|_| is_asked) else { return false };
        let transform = Transform::of(self.context);
        let window = |number: u32| floats.get(number).map_or(NOWHERE, |at| transform.to_window(at));
        // A few show most meshes that have back faces.
        let triangles = self.count / 3;
        let is_front = |triangle: u32| {
            let corners = [0, 1, 2].map(|at| window(self.elements.number(3 * triangle + at)));
            transform.is_front(corners)
        };
        if !(0..triangles).step_by((triangles / PROBES).max(1) as usize).all(is_front) {
            return false;
        }
        // Each vertex is of about six triangles of a mesh.
        let numbers: Vec<u32> = (0..3 * triangles).map(|at| self.elements.number(at)).collect();
        let first = numbers.iter().copied().min().unwrap_or(0);
        let last = numbers.iter().copied().max().unwrap_or(0);
        if last - first > MAX_VERTICES {
            return false;
        }
        let windows: Vec<[f64; 2]> = (first..=last).map(window).collect();
        let corner = |number: u32| windows[(number - first) as usize];
        numbers.as_chunks().0.iter().all(|triangle| transform.is_front(triangle.map(corner)))
    }
}

/// So many triangles are looked at before all are.
const PROBES: u32 = 32;

/// Where no triangle shows its front.
const NOWHERE: [f64; 2] = [f64::NAN; 2];

/// From object coordinates to pixels about the viewport's centre.
struct Transform {
    matrix: DMat4,
    /// The largest magnitude in it.
    largest: f64,
    size: [f64; 2],
    /// That of the area of front faces.
    sign: f64,
}

impl Transform {
    fn of(context: &Context) -> Self {
        let (matrices, viewport) = (&context.state.matrices, viewport(context));
        let matrix = matrices.projection.top * matrices.modelview.top;
        let entries = matrix.to_cols_array().map(f64::abs);
        Self {
            matrix,
            largest: entries.into_iter().fold(0.0, f64::max),
            size: [viewport.width, viewport.height].map(|size| 0.5 * f64::from(size)),
            sign: match front_face(context) {
                FrontFace::Ccw => 1.0,
                FrontFace::Cw => -1.0,
            },
        }
    }

    /// [`NOWHERE`] where the vertex is not surely between the near and the far plane, is far outside, or is rounded by
    /// more than a thirty-second of a pixel.
    fn to_window(&self, position: [f32; 4]) -> [f64; 2] {
        let position = DVec4::from_array(position.map(f64::from));
        let clip = self.matrix * position;
        let rounding = 4.0 * SINGLE * self.largest * position.abs().max_element();
        let inverse = clip.w.recip();
        let window = [clip.x * inverse * self.size[0], clip.y * inverse * self.size[1]];
        let far = FAR.max(self.size[0]).max(self.size[1]);
        let is_sure = (clip.w > 0.0)
            & (clip.z.abs() + rounding < clip.w - rounding)
            & (window[0].abs() < far)
            & (window[1].abs() < far)
            & (32.0 * rounding * far < clip.w);
        if is_sure { window } else { NOWHERE }
    }

    /// Whether the area has the sign of front faces also where corners move by a sixteenth of a pixel.
    fn is_front(&self, [a, b, c]: [[f64; 2]; 3]) -> bool {
        let [u, v] = [b, c].map(|point| [point[0] - a[0], point[1] - a[1]]);
        let area = (u[0] * v[1] - u[1] * v[0]) * self.sign;
        let around = u[0].abs() + u[1].abs() + v[0].abs() + v[1].abs();
        area > 0.125 * (around + 0.125)
    }
}
