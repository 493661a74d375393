//! A texture access: coordinates, λ, levels, texels with their weights.

use crate::base::compare::COMPARE;
use crate::base::constants::enum_name;
use crate::context::watched_pixel::DrawNote;
use crate::explain::page::{Page, number, numbers};
use crate::explain::plan_names::in_gl_names;
use crate::explain::shader::{operand, value};
use rasterizer::ir::{Access, Ty};
use rasterizer::trace::Lookup;
use texunit::sampler::Filter;
use texunit::trace::{SampleStep, SampleTrace, TexelSource};

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
    page.line(3, &in_gl_names(&lookup.texture), "");
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

/// The names of the faces of a cube.
const FACES: [&str; 6] = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"];

fn filter_name(filter: Filter) -> &'static str {
    match filter {
        Filter::Nearest => "GL_NEAREST",
        Filter::Linear => "GL_LINEAR",
    }
}

fn steps(page: &mut Page, trace: &SampleTrace) {
    // The weights of the texels to come, and their table so far.
    let mut weights = Vec::new();
    let mut texels: Vec<Vec<String>> = Vec::new();
    for step in &trace.steps {
        if let SampleStep::Texel { .. } = step {
            texel(step, &mut weights, &mut texels);
            continue;
        }
        if let SampleStep::Row { weights: of, .. } = step {
            // All rows of a level are one table.
            weights.extend(of);
            continue;
        }
        if !texels.is_empty() {
            page.table(5, &std::mem::take(&mut texels));
        }
        one(page, step, &mut weights);
    }
    page.line(3, &format!("= {}", numbers(&trace.result)), "GL 2.1, section 3.8.13, table 3.21");
}

/// A row of the table of texels.
fn texel(step: &SampleStep, weights: &mut Vec<f32>, texels: &mut Vec<Vec<String>>) {
    let SampleStep::Texel { face, at, source, value, compare } = step else { return };
    if texels.is_empty() {
        texels.push(["texel", "weight", "stored channels", ""].map(String::from).to_vec());
    }
    let weight = if weights.is_empty() { 1.0 } else { weights.remove(0) };
    let [i, j, k] = at;
    let note = match (source, compare) {
        (TexelSource::Border, _) => "the border colour".to_owned(),
        (TexelSource::Corner, _) => "beyond the cube's corner: the mean of the others".to_owned(),
        (TexelSource::Stored, Some((op, reference, passes))) => {
            format!("r = {} {}: {passes}", number(*reference), enum_name(COMPARE.encode(*op)))
        }
        (TexelSource::Stored, None) if *face > 0 => format!("face {}", FACES[*face as usize % 6]),
        (TexelSource::Stored, None) => String::new(),
    };
    texels.push(vec![format!("({i}, {j}, {k})"), number(weight), numbers(value), note]);
}

/// The weights of a linear filter's texels, lower before upper along s, then t, then r.
fn linear_weights([alpha, beta, gamma]: [f32; 3], axes: usize) -> Vec<f32> {
    let pair = |t: f32| [1.0 - t, t];
    let mut weights = pair(alpha).to_vec();
    for t in [beta, gamma].into_iter().take(axes.saturating_sub(1)) {
        weights = pair(t).iter().flat_map(|w| weights.iter().map(move |v| v * w)).collect();
    }
    weights
}

fn one(page: &mut Page, step: &SampleStep, weights: &mut Vec<f32>) {
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
            let depth = if depth > 1 { format!("×{depth}") } else { String::new() };
            page.line(3, &format!("level {level}, {width}×{height}{depth}"), "");
        }
        SampleStep::Rows { rows, length } => {
            weights.clear();
            let text =
                format!("{rows} of its rows or columns, {} in the footprint", number(length));
            page.line(4, &text, "EXT_texture_filter_anisotropic");
        }
        SampleStep::Row { .. } => {}
        SampleStep::Nearest { u } => {
            weights.clear();
            let text = format!("(u, v, w) = {}: the texel is its floor", numbers(&u));
            page.line(4, &text, "GL 2.1, section 3.8.8");
        }
        SampleStep::Linear { u, weights: abc, axes } => {
            *weights = linear_weights(abc, axes);
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
