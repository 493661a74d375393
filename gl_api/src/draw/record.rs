//! The steps of a draw, in order: checks, transform feedback, other render modes, stages, pipeline, commands.

use crate::base::error::{Result, invalid_operation};
use crate::base::limits::MAX_DUAL_SOURCE_DRAW_BUFFERS;
use crate::context::Context;
use crate::context::feedback::RenderMode;
use crate::context::recorder::elements::{Elements, bit};
use crate::context::recorder::pixel_rectangle::PixelRectangle;
use crate::context::recorder::stages::{Reads, Stages, internal};
use crate::context::recorder::vertex_facts::VertexFacts;
use crate::context::watched_pixel::topology_name;
use crate::draw::completeness::{draw_pass, drawn_formats};
use crate::draw::draw_reuse::allows_reuse;
use crate::draw::emitted_state::{PreparedDraw, emit, emit_textures, emit_vertices, emit_words};
use crate::draw::pending_primitives::draw_pending;
use crate::draw::pipeline::{pipeline_desc, rectangle_viewport, viewport};
use crate::draw::raster_state::{multisample_state, raster_state, smoothness};
use crate::draw::{assembly_words, warnings};
use crate::interface::ATTRIB_EDGE_FLAG;
use crate::objects::programs::Linked;
use crate::state::enable::Flag;
use rasterizer::driver::{
    Antialiasing, Cull, DepthWrite, FrontFace, MultisampleState, PassDesc, PipelineDesc,
    PolygonState, PolygonSubject, Provoking, RasterState, SampleRule, Topology, VertexBinding,
    VertexSource,
};
use rasterizer::ir::{GeometryInput, GeometryOutput};
use texunit::format::Format;

/// The attributes whose current values a draw may read, bit by location. While a list is compiled that is all of them,
/// as it is drawn with whatever program is in use when it is called.
fn constants_read(context: &Context) -> u64 {
    let linked = context.executable();
    match linked.filter(|linked| linked.vertex.is_some() && context.compiling.is_none()) {
        Some(linked) => linked.attributes | 1 << ATTRIB_EDGE_FLAG,
        None => u64::MAX,
    }
}

/// The attributes whose current values a draw is to be given: those that the draw before read, where it may use its
/// decisions.
pub(crate) fn constants_needed(context: &Context) -> u64 {
    crate::draw::draw_reuse::attributes(context).unwrap_or_else(|| constants_read(context))
}

/// Adds the current values that a draw was not given, as it is decided anew.
fn add_constants(context: &Context, vertices: &mut Vec<VertexBinding>) {
    let given = vertices.iter().fold(0, |all, binding| all | bit(binding.location));
    let missing = constants_read(context) & !given;
    let before = vertices.len();
    for (location, value) in (0..).zip(&context.state.current) {
        if missing & bit(location) != 0 {
            vertices.push(VertexBinding { location, source: VertexSource::Constant(*value) });
        }
    }
    if vertices.len() > before {
        vertices.sort_unstable_by_key(|binding| binding.location);
    }
}

/// Records a draw.
///
/// # Errors
/// When the framebuffer is incomplete or the program in use is not linked.
pub(crate) fn draw(
    context: &mut Context,
    topology: Topology,
    mut vertices: Vec<VertexBinding>,
    elements: &Elements,
) -> Result<()> {
    draw_pending(context);
    context.recorder.picture.framebuffer = Some(context.state.bindings.draw_framebuffer);
    let facts = VertexFacts::of(context, &vertices, elements);
    // What was decided for other facts does not hold.
    if std::mem::replace(&mut context.recorder.facts, facts) != facts {
        context.recorder.emitted.decisions = None;
    }
    if let Some(values) = crate::draw::draw_reuse::values(context, topology, &vertices, elements) {
        warnings::picture::note_lights_again(context, &vertices);
        // Counts primitives; nothing is captured.
        crate::draw::capture::draw(context, (topology, topology), &[], elements)?;
        emit_words(&mut context.recorder, values.words);
        if let Some(textures) = values.textures {
            emit_textures(&mut context.recorder, textures);
        }
        emit_vertices(context, vertices, elements);
        return Ok(());
    }
    crate::draw::program_pipeline::prepare(context);
    add_constants(context, &mut vertices);
    let pass = checked_pass(context)?;
    if context.queries.discards() {
        warnings::picture::note_condition(context);
        return Ok(());
    }
    let drawn = drawn_topology(context, topology)?;
    crate::draw::capture::draw(context, (topology, drawn), &vertices, elements)?;
    if !is_rasterized(context, topology, &vertices, elements)? {
        return Ok(());
    }
    let antialiasing = smoothness(context, drawn);
    // This may submit what was recorded, if a texture of this draw was drawn to.
    let Stages { vertex, geometry, fragment, reads } =
        crate::draw::stages::choose(context, &vertices, antialiasing)?;
    let viewport = viewport(context);
    let mut raster = raster_state(context, drawn, &vertices);
    raster.multisample = multisample_state(context, SampleRule::Each);
    let desc = pipeline_desc(context, &pass, topology, (vertex, geometry, fragment));
    warnings::state::check(context, &pass, &desc, &reads, (&vertices, elements));
    let unset = warnings::inputs::unset_attributes(context, topology, &vertices);
    emit(context, PreparedDraw { pass, desc, raster, viewport, reads }, vertices, elements)?;
    warnings::inputs::without_arrays(context, unset);
    Ok(())
}

/// Records the draw of rectangles of pixels: four vertices of each in clip coordinates of the whole
/// framebuffer.
///
/// # Errors
/// As [`draw`].
pub(crate) fn draw_rectangle(
    context: &mut Context,
    vertices: Vec<VertexBinding>,
    elements: &Elements,
    rectangle: &PixelRectangle,
) -> Result<()> {
    let topology = Topology::Quads;
    draw_pending(context);
    context.recorder.facts = VertexFacts::default();
    crate::draw::program_pipeline::prepare(context);
    let pass = checked_pass(context)?;
    if context.queries.discards() || !is_rasterized(context, topology, &vertices, elements)? {
        return Ok(());
    }
    let mut stages = crate::draw::stages::choose(context, &vertices, Antialiasing::Aliased)?;
    rectangle.apply(context, &mut stages).map_err(|error| internal(&error))?;
    // Pixels are no primitives.
    let Stages { vertex, geometry: _, fragment, reads } = stages;
    let reads = Reads { keys: None, ..reads };
    let viewport = rectangle_viewport(&pass, rectangle.depth);
    let multisample = multisample_state(context, SampleRule::Center);
    let mask = rectangle.samples.masked(multisample.mask);
    let multisample = MultisampleState { mask, ..multisample };
    let polygon = PolygonState {
        subject: PolygonSubject::PixelRectangle,
        stipple: rectangle.stipple(),
        ..PolygonState::default()
    };
    let raster = RasterState { polygon, multisample, ..RasterState::default() };
    let desc = PipelineDesc {
        cull: Cull::None,
        front_face: FrontFace::Ccw,
        provoking: Provoking::Last,
        ..pipeline_desc(context, &pass, topology, (vertex, None, fragment))
    };
    if context.state.bindings.draw_framebuffer == 0
        && desc.depth.as_ref().is_some_and(|depth| depth.write == DepthWrite::On)
    {
        context.window.depths.copied();
    }
    emit(context, PreparedDraw { pass, desc, raster, viewport, reads }, vertices, elements)
}

/// The topology of what a draw rasterizes: that of the geometry shader's output, if there is one.
///
/// # Errors
/// When the geometry shader takes other primitives.
fn drawn_topology(context: &Context, topology: Topology) -> Result<Topology> {
    let Some(interface) = context.executable().and_then(Linked::geometry_interface) else {
        return Ok(topology);
    };
    if topology.geometry_input() != Some(interface.input) {
        return invalid_operation(
            "GL 3.2, section 2.12.1",
            format!(
                "mode = {} does not make the primitives that the geometry shader takes, which are \
                 {}",
                topology_name(topology),
                input_name(interface.input)
            ),
        );
    }
    Ok(match interface.output {
        GeometryOutput::Points => Topology::Points,
        GeometryOutput::LineStrip => Topology::LineStrip,
        GeometryOutput::TriangleStrip => Topology::TriangleStrip,
    })
}

/// The layout qualifier of primitives, for messages.
fn input_name(input: GeometryInput) -> &'static str {
    match input {
        GeometryInput::Points => "points",
        GeometryInput::Lines => "lines",
        GeometryInput::LinesAdjacency => "lines_adjacency",
        GeometryInput::Triangles => "triangles",
        GeometryInput::TrianglesAdjacency => "triangles_adjacency",
    }
}

/// The pass of the draw framebuffer, if a draw is valid with the state.
///
/// # Errors
/// As [`draw`].
fn checked_pass(context: &mut Context) -> Result<PassDesc> {
    let pass = match open_pass(context) {
        Some(open) => open,
        None => draw_pass(context)?,
    };
    let program = context.state.bindings.program.name();
    crate::draw::program_pipeline::check(context)?;
    let linked = context.executable();
    let is_shaded = linked.is_some_and(|linked| linked.fragment.is_some());
    if program != 0 && linked.is_none() {
        return invalid_operation(
            "GL 2.1, section 2.15.3",
            format!("program {program} is in use but not linked: see glGetProgramInfoLog"),
        );
    }
    assembly_words::check(context)?;
    if !is_shaded {
        no_integers(context)?;
    }
    second_color_of_few(context, &pass)?;
    Ok(pass)
}

/// The open pass, if a draw before was checked to be drawn in it, and the framebuffer cannot have changed since.
fn open_pass(context: &Context) -> Option<PassDesc> {
    let checked = context.recorder.emitted.pass_call?;
    let is_same = context.state_changes.last_state_change <= checked && allows_reuse(context);
    is_same.then(|| context.recorder.pass.clone()).flatten()
}

/// Refuses factors of the second colour where more buffers are drawn to than have one.
fn second_color_of_few(context: &Context, pass: &PassDesc) -> Result<()> {
    let limit = MAX_DUAL_SOURCE_DRAW_BUFFERS;
    let active = pass.colors.iter().flatten().count();
    if active <= limit {
        return Ok(());
    }
    let states = context.state.fragment.buffers.iter().zip(&pass.colors);
    let of_second = states
        .enumerate()
        .find(|(_, (state, color))| color.is_some() && state.formula.has_second_color());
    let Some((buffer, _)) = of_second else { return Ok(()) };
    invalid_operation(
        "GL 3.3, section 4.1.7",
        format!(
            "the blend function of draw buffer {buffer} is made of the second colour (GL_SRC1_COLOR and the like), and \
             {active} colour buffers are drawn to, above GL_MAX_DUAL_SOURCE_DRAW_BUFFERS, {limit}: call glDrawBuffer \
             with one, or glBlendFunc with other factors"
        ),
    )
}

/// Refuses to draw to integers without a fragment shader, which alone writes them.
fn no_integers(context: &Context) -> Result<()> {
    if drawn_formats(context).any(Format::is_integer) {
        return invalid_operation(
            "EXT_texture_integer, section 2.6",
            "a colour buffer that is drawn to holds integers, which only a fragment shader writes: \
             call glUseProgram with one",
        );
    }
    Ok(())
}

/// Whether a draw makes fragments. In selection and feedback it makes none, and is carried out here.
fn is_rasterized(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Result<bool> {
    if context.state.enables.has(Flag::RasterizerDiscard) {
        warnings::state::discarded(context);
        return Ok(false);
    }
    if context.feedback.mode != RenderMode::Render {
        crate::draw::feedback::draw(context, topology, vertices, elements)?;
        return Ok(false);
    }
    warnings::textures::nothing_enabled(context);
    Ok(true)
}
