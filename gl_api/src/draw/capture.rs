//! Transform feedback: what a draw writes to the buffers, by running its vertex and its geometry stage once more; and the
//! counts of primitives for queries.

use crate::base::error::{ErrorCode, GlError, Result, invalid_operation};
use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::vertex_stage::{Outputs, PreparedStage, VertexInstance, Vertices};
use crate::draw::stages::choose;
use crate::draw::vertex_stage::{shade, shade_with};
use crate::glsl::CapturedScalar;
use crate::objects::buffers::BufferObject;
use crate::objects::programs::Linked;
use crate::objects::queries::{GENERATED, WRITTEN};
use crate::state::transform_feedback::{Active, CapturedPrimitive, SECTION};
use rasterizer::driver::{
    Antialiasing, Primitive, Primitives, Topology, VertexBinding, primitives,
};
use rasterizer::ir::GeometryInterface;
use texunit::lanes::{LANES, math};

/// The number of primitives that are shaded and written at once.
const CHUNK: usize = 1 << 12;

/// The most primitives that a geometry shader gets while what it emits is counted or captured, and the most vertices that
/// it may make of them.
const MAX_PRIMITIVES: u64 = 1 << 24;
const MAX_EMITTED: u64 = 1 << 28;

/// Whether a query counts what a geometry shader emits.
pub(crate) fn counts_emitted(context: &Context) -> bool {
    context.queries.names[GENERATED] != 0 && interface(context).is_some()
}

/// The interface of the geometry stage of the program in use.
fn interface(context: &Context) -> Option<&GeometryInterface> {
    context.executable().and_then(Linked::geometry_interface)
}

/// Whether the buffers have room for the whole primitives of so many vertices more.
pub(crate) fn has_room(context: &Context, active: &Active, vertices: u64) -> bool {
    let primitives = vertices / active.kind.corners() as u64;
    Layout::of(context)
        .is_none_or(|layout| primitives <= layout.free_primitives(context, active) as u64)
}

/// Counts the primitives of a draw, and captures them if transform feedback is active. The second topology is that of
/// what is drawn, which a geometry shader may make of others.
///
/// # Errors
/// `GL_INVALID_OPERATION` if they are not what is captured, or a buffer is mapped; as a draw.
pub(crate) fn draw(
    context: &mut Context,
    (topology, drawn): (Topology, Topology),
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Result<()> {
    let (count, instances) = elements.counts();
    let all = primitives(topology, context.state.raster.provoking, count)
        .numbered_from(context.recorder.first_primitive);
    let made = u64::from(all.len) * instances.len() as u64;
    if let Some(interface) = interface(context) {
        if context.transform_feedback.is_active() || counts_emitted(context) {
            let interface = interface.clone();
            return emitted(context, (&all, drawn), &interface, vertices, elements);
        }
        return Ok(());
    }
    let Some(mut active) = context.transform_feedback.active else {
        context.count_primitives(made, 0);
        return Ok(());
    };
    check_kind(drawn, &active)?;
    let Some(layout) = Layout::of(context) else { return Ok(()) };
    layout.check(context)?;
    // Captured without a value, none has to be shaded.
    if layout.buffers.iter().all(Vec::is_empty) {
        active.vertices = active
            .vertices
            .saturating_add((made * active.kind.corners() as u64).try_into().unwrap_or(u32::MAX));
        context.transform_feedback.active = Some(active);
        context.count_primitives(made, made);
        return Ok(());
    }
    let mut written = 0;
    // Instances of nothing may be any number.
    'full: for instance in if all.len == 0 { 0..0 } else { instances } {
        for first in (0..all.len).step_by(CHUNK) {
            let chunk = first..all.len.min(first.saturating_add(CHUNK as u32));
            let asked = u64::from(chunk.end - chunk.start);
            let id = |at| VertexInstance { vertex: elements.number(at), instance };
            let mut ids: Vec<VertexInstance> = Vec::new();
            for at in chunk {
                match all.get(at) {
                    Primitive::Point(ordinal) => ids.push(id(ordinal)),
                    Primitive::Line(ordinals, _) => ids.extend(ordinals.map(id)),
                    Primitive::Triangle(ordinals, _, _) => ids.extend(ordinals.map(id)),
                }
            }
            let shaded = shade(context, vertices, &ids, Outputs::All)?;
            let fit = layout.write(context, &shaded, &mut active)?;
            written += fit;
            if fit < asked {
                break 'full;
            }
        }
    }
    context.transform_feedback.active = Some(active);
    context.count_primitives(made, written);
    Ok(())
}

/// Refuses primitives that are not what is captured.
fn check_kind(drawn: Topology, active: &Active) -> Result<()> {
    let kind = CapturedPrimitive::of(drawn);
    if kind != active.kind {
        return invalid_operation(
            SECTION,
            format!(
                "mode draws {}, but glBeginTransformFeedback was called for {}",
                kind.noun(),
                active.kind.noun()
            ),
        );
    }
    Ok(())
}

/// Counts what the geometry stage makes of the primitives of a draw, and captures it if transform feedback is active.
fn emitted(
    context: &mut Context,
    (all, drawn): (&Primitives, Topology),
    interface: &GeometryInterface,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Result<()> {
    let (_, instances) = elements.counts();
    let total = u64::from(all.len) * instances.len() as u64;
    let each = u64::from(interface.max_vertices.max(1));
    let most = MAX_PRIMITIVES.min(MAX_EMITTED / each);
    if total > most {
        return Err(GlError::new(
            ErrorCode::OutOfMemory,
            SECTION,
            format!(
                "a draw of {total} primitives: at most {most} while what a geometry shader emits, at most {each} \
                 vertices of each, is counted or captured: draw fewer at once"
            ),
        ));
    }
    let mut active = context.transform_feedback.active;
    let mut layout = None;
    if let Some(active) = &active {
        check_kind(drawn, active)?;
        layout = Layout::of(context);
        if let Some(layout) = &layout {
            layout.check(context)?;
        }
    }
    let each = usize::from(interface.input.vertices());
    let corners = CapturedPrimitive::of(drawn).corners();
    let most = (CHUNK as u32 / interface.max_vertices.max(1)).max(LANES as u32);
    let provoking = context.state.raster.provoking;
    let (mut made, mut written, mut is_full) = (0, 0, false);
    // Instances of nothing may be any number.
    for instance in if all.len == 0 { 0..0 } else { instances } {
        for first in (0..all.len).step_by(most as usize) {
            let chunk = first..all.len.min(first.saturating_add(most));
            let numbers: Vec<u32> = chunk.clone().map(|at| all.number(at)).collect();
            let ids = chunk.flat_map(|at| {
                let own = all.with_adjacency(at).into_iter().take(each);
                own.map(|at| VertexInstance { vertex: elements.number(at), instance })
            });
            let ids: Vec<VertexInstance> = ids.collect();
            let stages = choose(context, vertices, Antialiasing::Aliased)?;
            let Some(geometry) = PreparedStage::of_geometry(context, &stages) else {
                return Ok(());
            };
            let shaded = shade_with(context, stages, vertices, &ids, Outputs::All)?;
            let machine = (context.recorder.isa(), &mut context.feedback.machine);
            let emitted = geometry.emit(machine, interface, (&shaded, &numbers), provoking)?;
            let asked = (emitted.len() / corners) as u64;
            made += asked;
            if let (Some(active), Some(layout), false) = (&mut active, &layout, is_full) {
                let fit = layout.write(context, &emitted, active)?;
                written += fit;
                is_full = fit < asked;
            }
        }
    }
    context.transform_feedback.active = active;
    context.count_primitives(made, written);
    Ok(())
}

/// What is written for a vertex: for each buffer the scalars in order.
struct Layout {
    buffers: Vec<Vec<CapturedScalar>>,
}

impl Layout {
    /// What the program in use captures.
    fn of(context: &Context) -> Option<Self> {
        let linked = context.executable()?;
        Some(Self { buffers: linked.program.captured_by_buffer() })
    }

    /// Checks that the buffers can be written to.
    fn check(&self, context: &Context) -> Result<()> {
        for range in context.transform_feedback.buffers.iter().take(self.buffers.len()) {
            let object = context.objects.shared.buffers.bound(&range.buffer);
            if object.is_some_and(BufferObject::is_mapped_alone) {
                return invalid_operation(
                    SECTION,
                    format!("buffer {} is mapped: call glUnmapBuffer", range.buffer.name()),
                );
            }
        }
        Ok(())
    }

    /// How many more primitives fit into all buffers.
    fn free_primitives(&self, context: &Context, active: &Active) -> usize {
        let ranges = &context.transform_feedback.buffers;
        let each_buffer = ranges.iter().zip(&self.buffers).zip(active.written);
        // Nothing is written to a buffer of no scalars, nor need it be bound.
        let used = each_buffer.filter(|((_, scalars), _)| !scalars.is_empty());
        let free = used.map(|((range, scalars), written)| {
            let buffer = context.objects.shared.buffers.bound(&range.buffer);
            let bytes = buffer.map_or(0, |object| object.buffer().bytes().len());
            let available =
                bytes.saturating_sub(range.offset).min(range.size.unwrap_or(usize::MAX));
            let each = active.kind.corners() * scalars.len() * 4;
            available.saturating_sub(written) / each.max(1)
        });
        free.min().unwrap_or(usize::MAX)
    }

    /// Writes as many whole primitives as all buffers have room for: how many.
    ///
    /// # Errors
    /// If recorded draws keep what a buffer holds, and there is no memory for a copy.
    fn write(
        &self,
        context: &mut Context,
        vertices: &Vertices,
        active: &mut Active,
    ) -> Result<u64> {
        let corners = active.kind.corners();
        let fit = self.free_primitives(context, active).min(vertices.len() / corners);
        let ranges = &context.transform_feedback.buffers;
        for ((range, scalars), written) in ranges.iter().zip(&self.buffers).zip(&mut active.written)
        {
            let Some(object) = context.objects.shared.buffers.bound_mut(&range.buffer) else {
                continue;
            };
            let indices = scalars.iter().map(|scalar| CapturedIndex::of(vertices, *scalar));
            let indices: Vec<CapturedIndex> = indices.collect();
            let first = range.offset + *written;
            let bytes = fit * corners * scalars.len() * 4;
            if first + bytes > object.len() {
                continue;
            }
            let words = (0..fit * corners)
                .flat_map(|at| indices.iter().map(move |place| place.word(vertices, at)));
            object.write(&mut context.recorder, first..first + bytes, |out| {
                for (out, word) in out.chunks_exact_mut(4).zip(words) {
                    if let Some(word) = word {
                        out.copy_from_slice(&word.to_le_bytes());
                    }
                }
            })?;
            *written += bytes;
        }
        active.vertices = active.vertices.saturating_add((fit * corners) as u32);
        Ok(fit as u64)
    }
}

/// The indices of a captured scalar's outputs; an output that the stage does not have is 0.
#[derive(Clone, Copy)]
enum CapturedIndex {
    Gap,
    Float(Option<usize>),
    Word([Option<usize>; 2]),
}

impl CapturedIndex {
    fn of(vertices: &Vertices, scalar: CapturedScalar) -> Self {
        match scalar {
            CapturedScalar::Gap => Self::Gap,
            CapturedScalar::Float(output) => Self::Float(vertices.output_index(output)),
            CapturedScalar::Word { low, high } => {
                Self::Word([low, high].map(|output| vertices.output_index(output)))
            }
        }
    }

    /// The bits of the scalar at a vertex; none of a gap.
    fn word(self, vertices: &Vertices, at: usize) -> Option<u32> {
        let value = |place: Option<usize>| place.map_or(0.0, |place| vertices.value(at, place));
        match self {
            Self::Gap => None,
            Self::Float(place) => Some(math::bits(value(place))),
            Self::Word(indices) => {
                let [low, high] = indices.map(|place| value(place) as u32);
                Some(high << 16 | low)
            }
        }
    }
}

impl Context {
    /// Counts primitives of a draw, and those of them that transform feedback wrote.
    pub(crate) fn count_primitives(&mut self, generated: u64, written: u64) {
        for (place, count) in [(GENERATED, generated), (WRITTEN, written)] {
            if let Some(query) = self.objects.queries.get_mut(self.queries.names[place]) {
                query.primitives = query.primitives.saturating_add(count);
            }
        }
    }
}
