//! What the vertices of a draw make without effect: an alpha test that all pass, fog behind them. Vertices are read only
//! where state asks for one of these, and up to the first that contradicts.

use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::vertex_facts::VertexFacts;
use crate::draw::color_clamp::draws_fractions;
use crate::draw::completeness::samples;
use crate::draw::fixed_function::keys::varying;
use crate::draw::material::material;
use crate::draw::no_effect;
use crate::interface::{ATTRIB_COLOR, ATTRIB_VERTEX, Side};
use crate::state::enable::Flag;
use crate::state::fog::{FogMode, FogSource};
use glam::DVec4;
use rasterizer::driver::{VertexBinding, VertexFormat, VertexSource, VertexType};
use texunit::sampler::Compare;

/// The vertices of larger draws are not looked at.
const MAX_VERTICES: u32 = 1 << 18;

/// How far what is interpolated may lie outside of the values at the vertices, relative to the largest of them.
const ROUNDING: f64 = 1e-3;

/// The rounding of a sum of four products of `f32`s, relative to the sum of their magnitudes.
const SINGLE: f64 = 4e-7;

/// Alpha above this is not looked at: sums with it round by more.
const LARGE: f32 = 1e3;

impl VertexFacts {
    /// Those that state asks for.
    pub fn of(context: &Context, vertices: &[VertexBinding], elements: &Elements) -> Self {
        let enables = &context.state.enables;
        let blends = context.state.fragment.buffers.iter().any(|buffer| buffer.blend);
        let scans = enables.has(Flag::AlphaTest) || enables.has(Flag::Fog);
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
}
