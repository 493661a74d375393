//! `glRasterPos` and `glWindowPos`: GL 2.1, section 2.13.

use crate::base::convert::unit;
use crate::base::error::{Result, invalid_operation};
use crate::base::limits;
use crate::context::Context;
use crate::context::feedback::RenderMode;
use crate::context::recorder::stages::Stages;
use crate::context::recorder::vertex_stage::{
    Outputs, PreparedStage, RasterPositionStage, Shaded, Vertices,
};
use crate::draw::draw_reuse::allows_reuse;
use crate::draw::feedback::clip::DepthPlanes;
use crate::draw::pipeline::{depth_clip, window_transform};
use crate::interface::*;
use crate::state::fog::FogSource;
use crate::state::raster_position::RasterPosition;
use rasterizer::driver::{Antialiasing, VertexBinding, VertexSource};
use rasterizer::ir::{Input, Output};
use texunit::lanes::U32s;

const SECTION: &str = "GL 2.1, section 2.13";

impl Default for RasterPosition {
    fn default() -> Self {
        Self {
            window: [0.0, 0.0, 0.0, 1.0],
            valid: true,
            distance: 0.0,
            color: [1.0; 4],
            secondary_color: [0.0, 0.0, 0.0, 1.0],
            index: 1.0,
            tex_coords: [[0.0, 0.0, 0.0, 1.0]; MAX_TEXTURE_UNITS as usize],
        }
    }
}

/// Whether a shaded point is outside of the view volume or behind a plane of the user.
fn is_clipped(shaded: Shaded<'_>, depth_planes: DepthPlanes) -> bool {
    let [x, y, z, w] = shaded.position();
    let inside = [x, y].iter().all(|c| -w <= *c && *c <= w)
        && match depth_planes {
            DepthPlanes::NegativeOneToOne => -w <= z && z <= w,
            DepthPlanes::ZeroToOne => 0.0 <= z && z <= w,
            // Behind the eye is outside of something whatever z is.
            DepthPlanes::Clamp => w >= 0.0,
        };
    !inside || shaded.clip_distances().any(|distance| distance < 0.0)
}

impl RasterPositionStage {
    fn new(context: &mut Context, position: [f32; 4]) -> Result<Self> {
        let vertices: Vec<VertexBinding> = (0..)
            .zip(&context.state.current)
            .map(|(location, current)| {
                let value = if is_position(location) { position } else { *current };
                VertexBinding { location, source: VertexSource::Constant(value) }
            })
            .collect();
        let stages = crate::draw::stages::choose(context, &vertices, Antialiasing::Aliased)?;
        let outputs = Outputs::Units(moved_units(&stages));
        let ready = PreparedStage::new(context, stages, outputs);
        Ok(Self { at: context.state_changes.calls, ready })
    }

    /// That of the raster position before, if nothing but numbers has changed since.
    fn again(context: &mut Context) -> Option<Self> {
        let Self { at, ready } = context.feedback.raster_position_stage.take()?;
        let changes = &context.state_changes;
        let changed = changes.last_decision_change().max(changes.last_plain_change);
        if changed > at || !allows_reuse(context) {
            return None;
        }
        Some(Self { at, ready: ready.again(context)? })
    }
}

fn is_position(location: u8) -> bool {
    location == 0 || location == ATTRIB_VERTEX
}

/// The units whose texture coordinates may be others than the current ones, bit by unit.
fn moved_units(stages: &Stages) -> u8 {
    let key = stages.reads.keys.as_ref().and_then(|keys| keys.vertex.as_ref());
    key.map_or(u8::MAX, |key| {
        let generated = (0..).zip(&key.generated);
        generated.fold(key.matrices, |units, (unit, generated)| {
            units | u8::from(generated.iter().any(Option::is_some)) << unit
        })
    })
}

/// Runs the vertex stage of the state for one vertex.
pub(crate) fn shade(context: &mut Context, position: [f32; 4]) -> Result<Vertices> {
    let stage = match RasterPositionStage::again(context) {
        Some(stage) => stage,
        None => RasterPositionStage::new(context, position)?,
    };
    let current = &context.state.current;
    let machine = (context.recorder.isa(), &mut context.feedback.machine);
    let vertices = stage.ready.run(machine, 1, |wanted, _, out| {
        let number = match wanted {
            Input::Attribute { location, component } => {
                let of_vertex = is_position(location).then_some(&position);
                let value = of_vertex.or_else(|| current.get(usize::from(location)));
                value.map_or(0.0, |value| value[usize::from(component)])
            }
            Input::VertexId
            | Input::InstanceId
            | Input::OfVertex { .. }
            | Input::PrimitiveId
            | Input::Varying(_)
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_)
            | Input::Gradient { .. }
            | Input::Coverage
            | Input::SampleId
            | Input::SamplePosition(_)
            | Input::LineDirection(_) => 0.0,
        };
        *out = U32s::splat(number.to_bits());
    });
    context.feedback.raster_position_stage = Some(stage);
    vertices
}

/// The distance that goes with a raster position: a depth without its sign, or else what the
/// coordinate is.
pub(crate) fn distance(context: &Context, depth: f32, coordinate: f32) -> f32 {
    match context.state.fog.source {
        FogSource::Depth => depth.abs(),
        FogSource::Coordinate => coordinate,
    }
}

/// A valid raster position is a hit (GL 2.1, section 5.2).
fn select(context: &mut Context) {
    if context.feedback.mode == RenderMode::Select {
        context.feedback.select.hit(context.state.raster_position.window[2]);
    }
}

/// `glRasterPos`: the position goes through the vertex stage.
pub(crate) fn raster(context: &mut Context, position: [f64; 4]) -> Result<()> {
    // Draws do not depend on raster positions.
    context.state_changes.no_change();
    let vertices = shade(context, position.map(|c| c as f32))?;
    let shaded = vertices.vertex(0);
    let depth_planes = DepthPlanes::of(depth_clip(context), context.state.clip.control.depth);
    if is_clipped(shaded, depth_planes) {
        context.state.raster_position.valid = false;
        return Ok(());
    }
    let position = shaded.position();
    let [x, y, depth] = window_transform(context).window(position);
    let window = [x, y, unit(depth), position[3]];
    let clamp = crate::draw::color_clamp::of_vertices(context);
    let current = |location: u8| context.state.current[usize::from(location)];
    let mut tex_coords = [[0.0; 4]; MAX_TEXTURE_UNITS as usize];
    for (unit, coords) in (0..).zip(&mut tex_coords) {
        let first = VARYING_TEX_COORD + 4 * u16::from(unit);
        *coords = shaded.varyings(first, current(ATTRIB_TEX_COORD + unit));
    }
    let fog = shaded.get(Output::Varying(VARYING_FOG)).unwrap_or(0.0);
    context.state.raster_position = RasterPosition {
        window,
        valid: true,
        distance: distance(context, fog, fog),
        color: clamp.color(shaded.varyings(VARYING_COLOR, current(ATTRIB_COLOR))),
        secondary_color: clamp
            .color(shaded.varyings(VARYING_SECONDARY_COLOR, current(ATTRIB_SECONDARY_COLOR))),
        index: current(ATTRIB_INDEX)[0],
        tex_coords,
    };
    select(context);
    Ok(())
}

/// `glWindowPos`: the position is one of the window, and nothing is transformed or lit. Only `MESA_window_pos` has a `w`
/// other than 1, which nobody but a query reads.
pub(crate) fn window(context: &mut Context, position: [f64; 4]) -> Result<()> {
    context.state_changes.no_change();
    let [x, y, z, w] = position;
    let [near, far] = context.state.viewport.first.depth;
    let depth = near + unit(z) * (far - near);
    let clamp = crate::draw::color_clamp::of_vertices(context);
    let current = |location: u8| context.state.current[usize::from(location)];
    let mut tex_coords = [[0.0; 4]; MAX_TEXTURE_UNITS as usize];
    for (unit, coords) in (0..).zip(&mut tex_coords) {
        *coords = current(ATTRIB_TEX_COORD + unit);
    }
    context.state.raster_position = RasterPosition {
        window: [x, y, depth, w],
        valid: true,
        distance: distance(context, 0.0, current(ATTRIB_FOG_COORD)[0]),
        color: clamp.color(current(ATTRIB_COLOR)),
        secondary_color: clamp.color(current(ATTRIB_SECONDARY_COLOR)),
        index: current(ATTRIB_INDEX)[0],
        tex_coords,
    };
    select(context);
    Ok(())
}

/// Moves the raster position, as `glBitmap` does.
pub(crate) fn advance(context: &mut Context, by: [f32; 2]) {
    let position = &mut context.state.raster_position;
    // Far beyond any window; keeps the sums finite.
    let limit = f64::from(limits::MAX_VIEWPORT_DIMS) * 1e6;
    for (at, by) in position.window.iter_mut().zip(by) {
        *at = (*at + f64::from(by)).clamp(-limit, limit);
    }
}

/// As many components as a call has; missing ones are 0, 0, 0, 1.
fn filled<const N: usize>(components: [f64; N]) -> [f64; 4] {
    let mut value = [0.0, 0.0, 0.0, 1.0];
    value[..N].copy_from_slice(&components);
    value
}

/// The first components of a vector form's slice.
fn first<const N: usize, T: Copy>(v: &[T]) -> Result<[T; N]> {
    match v.first_chunk() {
        Some(components) => Ok(*components),
        None => invalid_operation(SECTION, format!("v has {} of {N} numbers", v.len())),
    }
}

macro_rules! positions {
    ($($set_position:ident { $($name:ident, $vector:ident, $ty:ty, ($($c:ident),+);)* })*) => {$($(
        pub(crate) fn $name(context: &mut Context $(, $c: $ty)+) -> Result<()> {
            $set_position(context, filled([$(f64::from($c)),+]))
        }

        pub(crate) fn $vector(context: &mut Context, v: &[$ty]) -> Result<()> {
            let [$($c),+] = first(v)?;
            $set_position(context, filled([$(f64::from($c)),+]))
        }
    )*)*};
}

positions! {
    raster {
        raster_pos_2s, raster_pos_2sv, i16, (x, y);
        raster_pos_2i, raster_pos_2iv, i32, (x, y);
        raster_pos_2f, raster_pos_2fv, f32, (x, y);
        raster_pos_2d, raster_pos_2dv, f64, (x, y);
        raster_pos_3s, raster_pos_3sv, i16, (x, y, z);
        raster_pos_3i, raster_pos_3iv, i32, (x, y, z);
        raster_pos_3f, raster_pos_3fv, f32, (x, y, z);
        raster_pos_3d, raster_pos_3dv, f64, (x, y, z);
        raster_pos_4s, raster_pos_4sv, i16, (x, y, z, w);
        raster_pos_4i, raster_pos_4iv, i32, (x, y, z, w);
        raster_pos_4f, raster_pos_4fv, f32, (x, y, z, w);
        raster_pos_4d, raster_pos_4dv, f64, (x, y, z, w);
    }
    window {
        window_pos_2s, window_pos_2sv, i16, (x, y);
        window_pos_2i, window_pos_2iv, i32, (x, y);
        window_pos_2f, window_pos_2fv, f32, (x, y);
        window_pos_2d, window_pos_2dv, f64, (x, y);
        window_pos_3s, window_pos_3sv, i16, (x, y, z);
        window_pos_3i, window_pos_3iv, i32, (x, y, z);
        window_pos_3f, window_pos_3fv, f32, (x, y, z);
        window_pos_3d, window_pos_3dv, f64, (x, y, z);
        window_pos_4s, window_pos_4sv, i16, (x, y, z, w);
        window_pos_4i, window_pos_4iv, i32, (x, y, z, w);
        window_pos_4f, window_pos_4fv, f32, (x, y, z, w);
        window_pos_4d, window_pos_4dv, f64, (x, y, z, w);
    }
}
