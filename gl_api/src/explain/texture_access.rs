//! A texture access: coordinates, λ, levels, texels with their weights.

use crate::context::watched_pixel::DrawNote;
use crate::explain::page::{Page, number, numbers};
use crate::explain::plan_names::in_gl_names;
use crate::explain::shader::{operand, value};
use crate::explain::texel_table::{FACES, TexelTable};
use rasterizer::ir::{Access, Ty};
use rasterizer::trace::Lookup;
use texunit::sampler::Filter;
use texunit::trace::{SampleStep, SampleTrace};

/// The accessed texture, and how its value came about.
pub fn lookup(page: &mut Page, lookup: &Lookup, note: &DrawNote) {
    let texture = note.textures.get(lookup.slot as usize);
    let texture = texture.map_or_else(|| format!("texture slot {}", lookup.slot), Clone::clone);
    let (what, section) = match lookup.access {
        Access::Filter { offset: [0, 0, 0] } => ("sample".to_owned(), "GL 2.1, section 3.8"),
        Access::Filter { offset } => {
            (format!("sample, {offset:?} texels off"), "GLSL 1.30, section 8.7")
        }
        Access::Fetch { offset: [0, 0, 0] } => ("fetch".to_owned(), "GLSL 1.30, section 8.7"),
        Access::Fetch { offset } => {
            (format!("fetch, {offset:?} texels off"), "GLSL 1.30, section 8.7")
        }
        Access::Gather { offset: [0, 0] } => ("gather".to_owned(), "ARB_texture_gather"),
        Access::Gather { offset } => {
            (format!("gather, {offset:?} texels off"), "ARB_texture_gather")
        }
        Access::Size => ("size".to_owned(), "GLSL 1.30, section 8.7"),
        Access::Lod => ("level of detail".to_owned(), "ARB_texture_query_lod"),
    };
    page.line(2, &format!("lookup{}: {what} of {texture}", lookup.number), section);
    let sampled = in_gl_names(&lookup.texture);
    page.line(3, &sampled, "");
    if let Access::Filter { .. } = lookup.access {
        lecture_operations(page, sampled.split(' ').next().unwrap_or_default());
    }
    for (letter, coord) in ["s", "t", "r"].iter().zip(&lookup.coords) {
        page.line(3, &format!("{letter} = {}", operand(coord, note)), "");
    }
    match &lookup.trace {
        Some(trace) => steps(page, trace),
        None => {
            let ty = if lookup.access == Access::Size { Ty::I32 } else { Ty::F32 };
            let words = lookup.result.map(|word| word.map_or("-".into(), |word| value(ty, word)));
            page.line(3, &format!("= ({})", words.join(", ")), "GL 2.1, section 3.11.2");
        }
    }
}

fn filter_name(filter: Filter) -> &'static str {
    match filter {
        Filter::Nearest => "GL_NEAREST",
        Filter::Linear => "GL_LINEAR",
    }
}

fn steps(page: &mut Page, trace: &SampleTrace) {
    let mut texels = TexelTable::default();
    for step in &trace.steps {
        if let SampleStep::Texel { .. } = step {
            texels.texel(step);
            continue;
        }
        if let SampleStep::Row { weights, .. } = step {
            // All rows of a level are one table.
            texels.row(*weights);
            continue;
        }
        texels.print(page);
        one(page, step, &mut texels);
    }
    page.line(3, &format!("= {}", numbers(&trace.result)), "GL 2.1, section 3.8.13, table 3.21");
}

/// What the lecture's hardware does for the coordinates of a texture: two multiply-adds a plane, one reciprocal, one
/// product a coordinate.
fn lecture_operations(page: &mut Page, target: &str) {
    let coordinates = match target {
        "GL_TEXTURE_1D" => ["s"].as_slice(),
        "GL_TEXTURE_2D" | "GL_TEXTURE_RECTANGLE" => ["s", "t"].as_slice(),
        "GL_TEXTURE_3D" | "GL_TEXTURE_CUBE_MAP" => ["s", "t", "r"].as_slice(),
        _ => return,
    };
    let (count, names) = (coordinates.len(), coordinates.join(", "));
    let text = format!(
        "the lecture's hardware for ({names}): {} MADs, {count} MULs, 1 RCP (2 MADs more for 1/w or q/w)",
        2 * count
    );
    page.line(3, &text, "slide \"Interpolation Operations\"");
}

/// The lecture's ρ, which is of the other sums of the same four squares.
fn lecture_rho(page: &mut Page, dx: [f32; 3], dy: [f32; 3], scale: [f32; 3]) {
    let gradient = |axis: usize| scale[axis] * (dx[axis] * dx[axis] + dy[axis] * dy[axis]).sqrt();
    let text = format!(
        "the lecture's ρ = max(|(∂u/∂x, ∂u/∂y)|, |(∂v/∂x, ∂v/∂y)|) = {}, for comparison",
        number(gradient(0).max(gradient(1)))
    );
    page.line(3, &text, "slide \"Mipmap LOD Selection\"");
}

fn one(page: &mut Page, step: &SampleStep, texels: &mut TexelTable) {
    match *step {
        SampleStep::Face { face, st } => page.line(
            3,
            &format!("face {}: (s, t) = {}", FACES[face as usize % 6], numbers(&st)),
            "GL 2.1, section 3.8.6, table 3.19",
        ),
        SampleStep::Layer(layer) => {
            page.line(3, &format!("layer {layer}"), "GLSL 1.30, section 8.7");
        }
        SampleStep::Fixed { filter, level, why } => page.line(
            3,
            &format!("{} of level {level}, without λ: {why}", filter_name(filter)),
            "GL 2.1, section 3.8.9",
        ),
        SampleStep::Derivatives { dx, dy, scale } => {
            let section = "GL 2.1, section 3.8.8, equation 3.20";
            page.line(3, &format!("∂(s, t, r)/∂x = {}", numbers(&dx)), section);
            page.line(3, &format!("∂(s, t, r)/∂y = {}", numbers(&dy)), section);
            page.line(3, &format!("in texels: times {}", numbers(&scale)), "");
            lecture_rho(page, dx, dy, scale);
        }
        SampleStep::Isotropic { rho_squared, lambda } => page.line(
            3,
            &format!(
                "ρ = max(|∂u/∂x|, |∂u/∂y|) = √{} = {}, λ = log2 ρ = {}",
                number(rho_squared),
                number(rho_squared.sqrt()),
                number(lambda)
            ),
            "GL 2.1, section 3.8.8, equation 3.20",
        ),
        SampleStep::Anisotropic { major_squared, minor_squared, probes, step, lambda } => {
            let section = "EXT_texture_filter_anisotropic";
            let (major, minor) = (number(major_squared.sqrt()), number(minor_squared.sqrt()));
            page.line(3, &format!("footprint: {major} texels long, {minor} wide"), section);
            let text = format!(
                "{probes} probes, {} apart, each with λ = {}",
                numbers(&step),
                number(lambda)
            );
            page.line(3, &text, section);
        }
        SampleStep::Scan { major_squared, minor_squared, along, slope, lambda } => {
            let section = "EXT_texture_filter_anisotropic";
            let (major, minor) = (number(major_squared.sqrt()), number(minor_squared.sqrt()));
            page.line(3, &format!("footprint: {major} texels long, {minor} wide"), section);
            let lines = ["columns", "rows"][along % 2];
            let text = format!(
                "read in {lines}, each {} texels beside the last, λ = {}",
                number(slope),
                number(lambda)
            );
            page.line(3, &text, section);
        }
        SampleStep::Explicit(lambda) => {
            page.line(3, &format!("λ = {}, given", number(lambda)), "GLSL 1.30, section 8.7");
        }
        SampleStep::Lambda { base, bias, shader_bias, range: [low, high], lambda } => page.line(
            3,
            &format!(
                "λ = clamp({} + {} + {}, {}, {}) = {}",
                number(base),
                number(bias),
                number(shader_bias),
                number(low),
                number(high),
                number(lambda)
            ),
            "GL 2.1, section 3.8.8",
        ),
        SampleStep::Levels { magnified_to, filter, levels: [first, second], weight } => {
            let (filter, c) = (filter_name(filter), number(magnified_to));
            let text = match weight > 0.0 {
                true => format!(
                    "{filter} of levels {first} and {second}, the second weighs {} (c = {c})",
                    number(weight)
                ),
                false => format!("{filter} of level {first} (c = {c})"),
            };
            page.line(3, &text, "GL 2.1, sections 3.8.8, 3.8.9");
        }
        SampleStep::Probe { number, of, at } => {
            let text = format!("probe {} of {of} at {}", number + 1, numbers(&at));
            page.line(3, &text, "EXT_texture_filter_anisotropic");
        }
        SampleStep::Level { level, size: [width, height, depth], .. } => {
            texels.level([width, height, depth]);
            let depth = if depth > 1 { format!("×{depth}") } else { String::new() };
            page.line(3, &format!("level {level}, {width}×{height}{depth}"), "");
        }
        SampleStep::Rows { rows, length } => {
            texels.nearest();
            let text =
                format!("{rows} of its rows or columns, {} in the footprint", number(length));
            page.line(4, &text, "EXT_texture_filter_anisotropic");
        }
        SampleStep::Row { .. } => {}
        SampleStep::Nearest { u } => {
            texels.nearest();
            let text = format!("(u, v, w) = {}: the texel is its floor", numbers(&u));
            page.line(4, &text, "GL 2.1, section 3.8.8");
        }
        SampleStep::Linear { u, weights: abc, axes } => {
            texels.linear(abc, axes);
            let text = format!("(u, v, w) = {}, (α, β, γ) = {}", numbers(&u), numbers(&abc));
            page.line(4, &text, "GL 2.1, section 3.8.8");
        }
        SampleStep::Filtered(value) => page.line(4, &format!("τ = {}", numbers(&value)), ""),
        SampleStep::Mixed(value) => {
            page.line(3, &format!("the levels mixed: {}", numbers(&value)), "GL 2.1, section 3.8.8")
        }
        SampleStep::Mean(value) => {
            page.line(3, &format!("the mean of the probes so far: {}", numbers(&value)), "");
        }
        SampleStep::Texel { .. } => {}
    }
}
