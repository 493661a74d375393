//! Clears; and of a fragment the primitive, and the interpolation of its inputs.

use crate::context::watched_pixel::DrawNote;
use crate::explain::page::{Page, number, numbers};
use crate::explain::{output, shader};
use rasterizer::ir::Input;
use rasterizer::trace::{Clear, Cleared, Facing, Fate, Fragment, InputSource, InputValue, When};

/// A clear.
pub fn clear(page: &mut Page, clear: &Clear) {
    let what = match clear.target {
        Cleared::Color(_) => format!("colour {}", numbers(&clear.after.color)),
        Cleared::Depth => format!("depth {}", number(clear.after.color[0])),
        Cleared::Stencil => format!("stencil {}", clear.after.words[1]),
    };
    page.line(0, &format!("cleared to {what}"), "GL 2.1, section 4.2.3");
}

/// A fragment, from its primitive to what is stored.
pub fn fragment(page: &mut Page, fragment: &Fragment, note: Option<&DrawNote>) {
    let unknown = DrawNote::default();
    let note = note.unwrap_or(&unknown);
    page.line(0, &format!("draw {}: {}", fragment.label, note.title), "");
    primitive(page, fragment);
    output::tests(page, fragment, When::Early);
    if !fragment.inputs.is_empty() {
        inputs(page, fragment, note);
    }
    shader::steps(page, fragment, note);
    output::tests(page, fragment, When::Late);
    output::writes(page, fragment);
    let fate = match fragment.fate {
        Fate::Written => return,
        Fate::TestFailed => "nothing is written: the tests failed",
        Fate::Discarded => "nothing is written: the fragment was discarded",
        Fate::NoColor => "no colour is written by this draw",
        Fate::OverBudget => "nothing is written: the shader ran too long, and its draw was dropped",
    };
    page.line(1, fate, "");
}

fn primitive(page: &mut Page, fragment: &Fragment) {
    let shape = match fragment.vertices.len() {
        3 => "triangle",
        2 => "line",
        _ => "point",
    };
    let side = match fragment.facing {
        Facing::Front => "front",
        Facing::Back => "back",
    };
    let (covered, of) = fragment.samples;
    let samples = match of {
        1 => "the pixel's centre is inside".to_owned(),
        _ => format!("{} of {of} samples are inside", covered.count_ones()),
    };
    let text =
        format!("{shape} {} of those that are filled, its {side}: {samples}", fragment.shape);
    let section = match fragment.vertices.len() {
        3 => "GL 2.1, section 3.5.1",
        2 => "GL 2.1, section 3.4.1",
        _ => "GL 2.1, section 3.3.1",
    };
    page.line(1, &text, section);
    let mut rows =
        vec![["vertex", "window x", "window y", "clip x, y, z, w"].map(String::from).to_vec()];
    for (at, vertex) in fragment.vertices.iter().enumerate() {
        let window = vertex.window.map(|v| {
            if vertex.clip[3] > 0.0 { format!("{v:.4}") } else { "behind the eye".into() }
        });
        let [x, y] = window;
        rows.push(vec![at.to_string(), x, y, numbers(&vertex.clip)]);
    }
    page.table(2, &rows);
}

/// A value as its type prints it.
fn value(input: Input, bits: u32) -> String {
    match input {
        Input::FrontFacing => (bits != 0).to_string(),
        Input::VertexId | Input::InstanceId | Input::PrimitiveId | Input::SampleId => {
            (bits as i32).to_string()
        }
        Input::Attribute { .. }
        | Input::OfVertex { .. }
        | Input::Varying(_)
        | Input::Gradient { .. }
        | Input::FragCoord(_)
        | Input::PointCoord(_)
        | Input::Coverage
        | Input::SamplePosition(_)
        | Input::LineDirection(_) => number(f32::from_bits(bits)),
    }
}

fn inputs(page: &mut Page, fragment: &Fragment, note: &DrawNote) {
    let section = match fragment.vertices.len() {
        3 => "GL 2.1, section 3.5.1, equation 3.8",
        2 => "GL 2.1, section 3.4.1, equation 3.6",
        _ => "GL 2.1, section 3.3.1",
    };
    page.line(1, "interpolation: f = (Σ a f/w) / (Σ a 1/w)", section);
    let rows: Vec<Vec<String>> = fragment
        .inputs
        .iter()
        .map(|input| {
            let how = match &input.source {
                InputSource::Perspective { vertices, numerator, denominator } => format!(
                    "{} / {}, from {} at the vertices",
                    number(*numerator),
                    number(*denominator),
                    numbers(vertices)
                ),
                InputSource::Linear(vertices) if vertices.is_empty() => "linear".into(),
                InputSource::Linear(vertices) => {
                    format!("linear, from {} at the vertices", numbers(vertices))
                }
                InputSource::Flat => "the same all over the primitive".into(),
                InputSource::Gradient => "exact, from the planes of the primitive".into(),
                InputSource::Pixel if matches!(input.input, Input::Gradient { .. }) => {
                    "left out: no texture of this draw needs λ".into()
                }
                InputSource::Pixel => String::new(),
            };
            vec![note.input(input.input), format!("= {}", value(input.input, input.bits)), how]
        })
        .collect();
    page.table(2, &rows);
    operations(page, fragment);
}

/// How much interpolation that was, counted as the lecture counts: Ax + By + C is two multiply-adds.
fn operations(page: &mut Page, fragment: &Fragment) {
    let count = |of: fn(&InputSource) -> bool| {
        fragment.inputs.iter().filter(|input| of(&input.source)).count()
    };
    let divided = count(|source| matches!(source, InputSource::Perspective { .. }));
    let linear = count(|source| matches!(source, InputSource::Linear(of) if !of.is_empty()));
    let slopes = count(|source| matches!(source, InputSource::Gradient));
    let is_left_out = |input: &&InputValue| {
        matches!((&input.source, input.input), (InputSource::Pixel, Input::Gradient { .. }))
    };
    let left_out = fragment.inputs.iter().filter(is_left_out).count();
    let mut of_w = fragment.vertices.iter().map(|vertex| vertex.clip[3]);
    let first = of_w.next();
    let has_perspective = divided > 0 && of_w.any(|w| Some(w) != first);
    let mut parts = Vec::new();
    match (divided + linear, has_perspective) {
        (0, _) => {}
        (planes, true) => parts.push(format!(
            "{} MADs, {divided} MULs, 1 RCP for {planes} planes and 1/w",
            2 * (planes + 1)
        )),
        (planes, false) => {
            parts.push(format!("{} MADs for {planes} planes: all w are equal", 2 * planes))
        }
    }
    if slopes > 0 {
        parts.push(format!("{slopes} slopes for λ"));
    }
    if left_out > 0 {
        parts.push(format!("{left_out} slopes left out"));
    }
    if !parts.is_empty() {
        let section = "slide \"Interpolation Operations\"";
        page.line(2, &format!("operations: {}", parts.join("; ")), section);
    }
}
