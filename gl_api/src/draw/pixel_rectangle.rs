//! Draws rectangles of pixels: fragments whose colour or depth comes from an image, and everything else from the
//! current raster position; and the pixels of bitmaps, which take everything from it.
//!
//! The fragment stage is that of any other draw (GL 2.1, section 3.6.4: fragments are textured, fogged and tested),
//! with the value that the image replaces read from it.

use crate::base::error::{ErrorCode, GlError, Result};
use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::pixel_rectangle::{
    Key, PixelRectangle, RectangleContent, RectangleSamples, ReplacedValue,
};
use crate::context::recorder::stages::Stages;
use crate::draw::completeness::{draw_pass, samples};
use crate::draw::pass::drawn_area;
use crate::draw::pixel_zoom::{CENTRE, Zoomed};
use crate::draw::record::draw_rectangle;
use crate::generate::fixed::cached;
use crate::interface::*;
use crate::state::enable::Flag;
use crate::state::raster_position::RasterPosition;
use rasterizer::driver::{
    Buffer, PassDesc, PixelMask, Rect, ShaderModule, VertexBinding, VertexFormat, VertexSource,
    VertexType, sample_positions,
};
use rasterizer::ir::{
    Builder, Expr, Input, IrError, Lod, Module, Op, Output, Stage, Stmt, TextureDecl, Ty, Value,
    Var, Variable,
};
use std::borrow::Cow;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, ImageError, Level, Shape};
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler, Wrap};

/// Draws a rectangle of texels of a format at the raster position; `row` gives those of a row.
///
/// # Errors
/// As a draw, and where there is no memory for it.
pub(crate) fn draw<'a>(
    context: &mut Context,
    size: [usize; 2],
    (replaces, format): (ReplacedValue, Format),
    row: &dyn Fn(usize) -> Cow<'a, [u8]>,
) -> Result<()> {
    let pass = draw_pass(context)?;
    if !context.state.raster_position.valid {
        return Ok(());
    }
    let area = drawn_area(context, &pass);
    let offsets = sample_offsets(context);
    let shown = |offset: &[f64; 2]| Zoomed::new(context, size, area, *offset);
    let zoomed: Vec<Option<Zoomed>> = offsets.iter().map(shown).collect();
    if zoomed.iter().all(|of_sample| *of_sample == zoomed[0]) {
        let of = (&pass, RectangleSamples::All);
        return zoomed[0]
            .iter()
            .try_for_each(|of_all| draw_zoomed(context, of, of_all, (replaces, format), row));
    }
    (0..).zip(&zoomed).try_for_each(|(sample, of_sample)| {
        let of = (&pass, RectangleSamples::One(sample));
        of_sample
            .iter()
            .try_for_each(|of_sample| draw_zoomed(context, of, of_sample, (replaces, format), row))
    })
}

/// The points of a pixel that show pixels of rectangles, each by itself: its samples, or its centre.
fn sample_offsets(context: &Context) -> Vec<[f64; 2]> {
    let count = samples(context, context.state.bindings.draw_framebuffer);
    if count <= 1 || !context.state.enables.has(Flag::Multisample) {
        return vec![CENTRE];
    }
    sample_positions(count).iter().map(|position| position.map(f64::from)).collect()
}

/// Draws what some samples show of a rectangle.
fn draw_zoomed<'a>(
    context: &mut Context,
    (pass, samples): (&PassDesc, RectangleSamples),
    zoomed: &Zoomed,
    (replaces, format): (ReplacedValue, Format),
    row: &dyn Fn(usize) -> Cow<'a, [u8]>,
) -> Result<()> {
    let plan = image(zoomed, format, row).map_err(|error| {
        GlError::new(ErrorCode::OutOfMemory, "GL 2.1, section 3.6.4", error.to_string())
    })?;
    context.recorder.hold(zoomed.columns.len() * zoomed.rows.len() * format.bytes());
    let position = &context.state.raster_position;
    let [x, y] = zoomed.origin;
    let rectangle = PixelRectangle {
        content: RectangleContent::Image { replaces, plan: Arc::new(plan), origin: [x, y] },
        depth: position.window[2] as f32,
        samples,
    };
    let (width, height) = (zoomed.columns.len() as u32, zoomed.rows.len() as u32);
    let area = std::iter::once(Rect { x, y, width, height });
    let vertices = vertices(position, area, [pass.width, pass.height]);
    let elements = Elements::Range { first: 0, count: 4, instances: 0..1 };
    draw_rectangle(context, vertices, &elements, &rectangle)
}

/// Draws the pixels of a mask with the values of a raster position.
///
/// # Errors
/// As a draw.
pub(crate) fn draw_mask(
    context: &mut Context,
    position: &RasterPosition,
    mask: &Arc<PixelMask>,
) -> Result<()> {
    let pass = draw_pass(context)?;
    let count = 4 * mask.areas().count() as u32;
    if count == 0 {
        return Ok(());
    }
    context.recorder.hold(mask.bytes());
    let vertices = vertices(position, mask.areas(), [pass.width, pass.height]);
    let elements = Elements::Range { first: 0, count, instances: 0..1 };
    let content = RectangleContent::Mask(Arc::clone(mask));
    let depth = position.window[2] as f32;
    let rectangle = PixelRectangle { content, depth, samples: RectangleSamples::All };
    draw_rectangle(context, vertices, &elements, &rectangle)
}

/// How the image of a rectangle is sampled.
pub(crate) fn image<'a>(
    zoomed: &Zoomed,
    format: Format,
    row: &dyn Fn(usize) -> Cow<'a, [u8]>,
) -> std::result::Result<SamplePlan, ImageError> {
    let (width, height) = (zoomed.columns.len() as u32, zoomed.rows.len() as u32);
    let mut level = Level::new(format, width, height)?;
    let size = format.bytes();
    let rows = level.texels.chunks_exact_mut(zoomed.columns.len() * size);
    for (&y, mut texels) in zoomed.rows.iter().zip(rows) {
        let row = row(y);
        for run in zoomed.columns.chunk_by(|a, b| a + 1 == *b) {
            let (to, rest) = texels.split_at_mut(run.len() * size);
            to.copy_from_slice(&row[run[0] * size..][..to.len()]);
            texels = rest;
        }
    }
    let mut texels = Texels::new(Shape::Rect);
    texels.set_level(0, 0, level)?;
    let sampler = Sampler {
        wrap: [Wrap::ClampToEdge; 3],
        min: Filter::Nearest,
        mag: Filter::Nearest,
        mipmap: Mipmap::None,
        ..Sampler::default()
    };
    Ok(SamplePlan::new(&texels, &sampler))
}

/// The corners of rectangles in a framebuffer of a size, in clip coordinates, and the values of a raster position as
/// constants.
fn vertices(
    raster: &RasterPosition,
    areas: impl Iterator<Item = Rect>,
    size: [u32; 2],
) -> Vec<VertexBinding> {
    let corners = |area: Rect| {
        let ends = [(area.x, area.width), (area.y, area.height)];
        let [x, y] = [0, 1].map(|axis| {
            let (start, length) = ends[axis];
            let end = (f64::from(start) + f64::from(length)).min(size[axis].into());
            [f64::from(start), end].map(|at| (at * 2.0 / f64::from(size[axis]) - 1.0) as f32)
        });
        [x[0], y[0], x[1], y[0], x[1], y[1], x[0], y[1]]
    };
    let bytes = areas.flat_map(corners).flat_map(f32::to_le_bytes).collect();
    let position = VertexSource::Array {
        buffer: Buffer::new(bytes),
        first: 0,
        offset: 0,
        stride: 8,
        ty: VertexType::F32,
        components: 2,
        format: VertexFormat::Plain,
        divisor: 0,
    };
    let constant =
        |location, value| VertexBinding { location, source: VertexSource::Constant(value) };
    let mut bindings = vec![
        VertexBinding { location: ATTRIB_VERTEX, source: position },
        constant(ATTRIB_COLOR, raster.color),
        constant(ATTRIB_SECONDARY_COLOR, raster.secondary_color),
        constant(ATTRIB_FOG_COORD, [raster.distance, 0.0, 0.0, 1.0]),
    ];
    for (unit, coords) in (0..).zip(raster.tex_coords) {
        bindings.push(constant(ATTRIB_TEX_COORD + unit, coords));
    }
    bindings
}

/// The vertex stage: positions are clip coordinates, everything else is passed through.
fn vertex_module() -> Module {
    let mut b = Builder::new(Stage::Vertex);
    let mut pass = |location: u8, component: u8, output: Output| {
        let value = b.input(Input::Attribute { location, component });
        let var = b.output(output);
        b.store(var, value);
    };
    for component in 0..4 {
        pass(ATTRIB_VERTEX, component, Output::Position(component));
        let slot = u16::from(component);
        pass(ATTRIB_COLOR, component, Output::Varying(VARYING_COLOR + slot));
        let secondary = Output::Varying(VARYING_SECONDARY_COLOR + slot);
        pass(ATTRIB_SECONDARY_COLOR, component, secondary);
        for unit in 0..MAX_TEXTURE_UNITS {
            let first = VARYING_TEX_COORD + 4 * u16::from(unit);
            pass(ATTRIB_TEX_COORD + unit, component, Output::Varying(first + slot));
        }
    }
    pass(ATTRIB_FOG_COORD, 0, Output::Varying(VARYING_FOG));
    b.finish()
}

/// A fragment stage that reads the image at its pixel before all else.
fn fragment_module(key: &Key) -> Module {
    let of = key.module.module();
    let mut b = Builder::new(Stage::Fragment);
    *b.module_mut() = Module { body: Vec::new(), ..of.clone() };
    let texture = b.texture(TextureDecl::color(Shape::Rect));
    let [x, y] = [0, 1].map(|axis| {
        let at = b.input(Input::FragCoord(axis));
        let origin = b.uniform(key.word + u32::from(axis), Ty::F32);
        b.op(Op::Sub, &[at, origin])
    });
    let zero = b.float(0.0);
    let texel = b.sample(texture, [x, y, zero], None, Lod::Implicit { bias: None });
    let mut after = Vec::new();
    match key.replaces {
        ReplacedValue::Color => {}
        ReplacedValue::Depth => {
            let written = of.outputs.iter().any(|(output, _)| *output == Output::Depth);
            if !written {
                let var = b.output(Output::Depth);
                after.push(Stmt::Store { var, value: texel[0] });
            }
        }
    }
    let mut module = b.finish();
    if key.replaces == ReplacedValue::Color {
        replace_color(&mut module, of.values.len(), texel);
    }
    module.body.extend(of.body.iter().cloned());
    module.body.extend(after);
    module
}

/// Makes a stage's first `count` values read the primary colour from variables that hold `texel`.
fn replace_color(module: &mut Module, count: usize, texel: [Value; 4]) {
    let vars = texel.map(|value| {
        module.variables.push(Variable { ty: Ty::F32, len: 1, name: "pixel".into() });
        let var = Var(module.variables.len() as u32 - 1);
        module.body.push(Stmt::Store { var, value });
        var
    });
    for index in 0..count {
        let Expr::Input(Input::Varying(slot)) = module.values[index] else { continue };
        let component = slot.wrapping_sub(VARYING_COLOR);
        if let Some(&var) = vars.get(usize::from(component)) {
            module.values[index] = Expr::Load(var);
            // Unlike an input, it has to be read before it is used.
            module.body.push(Stmt::Eval(Value(index as u32)));
        }
    }
}

impl PixelRectangle {
    /// Replaces the stages of a draw by those of the rectangle.
    ///
    /// # Errors
    /// Where a generated module breaks a rule of the IR, which would be a bug.
    pub fn apply(
        &self,
        context: &mut Context,
        stages: &mut Stages,
    ) -> std::result::Result<(), IrError> {
        let modules = &mut context.recorder.rectangles;
        stages.vertex = match &modules.vertex {
            Some(module) => module.clone(),
            None => modules.vertex.insert(ShaderModule::new(vertex_module())?).clone(),
        };
        stages.reads.vertex_textures = Arc::from([]);
        let RectangleContent::Image { replaces, plan, origin } = &self.content else {
            return Ok(());
        };
        let word = stages.reads.words.len() as u32;
        stages.reads.words.extend(origin.map(|corner| (corner as f32).to_bits()));
        let key = Key { module: stages.fragment.clone(), replaces: *replaces, word };
        stages.fragment = cached(&mut modules.fragment, &key, fragment_module)?;
        let textures = stages.reads.fragment_textures.iter().cloned();
        stages.reads.fragment_textures = textures.chain([Some(Arc::clone(plan))]).collect();
        Ok(())
    }
}
