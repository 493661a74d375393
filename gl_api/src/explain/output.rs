//! The tests and the blending of a fragment, and what is stored.

use crate::base::constants::enum_name;
use crate::explain::explanation::Explanation;
use crate::explain::page::{Page, number, numbers};
use crate::pixel::formats::format_name;
use crate::state::blend::FACTOR;
use crate::state::draw_buffers::LOGIC_OP;
use rasterizer::driver::{BlendEquation, BlendFactor, DepthWrite};
use rasterizer::trace::{Blending, Fragment, Test, When, Write};
use texunit::sampler::Compare;

/// The operator of a comparison.
fn sign(compare: Compare) -> &'static str {
    match compare {
        Compare::Never => "GL_NEVER",
        Compare::Less => "<",
        Compare::Equal => "==",
        Compare::LessEqual => "<=",
        Compare::Greater => ">",
        Compare::NotEqual => "!=",
        Compare::GreaterEqual => ">=",
        Compare::Always => "GL_ALWAYS",
    }
}

/// The tests made before or after shading.
pub fn tests(page: &mut Page, fragment: &Fragment, when: When) {
    for test in fragment.tests.iter().filter(|test| test.when == when) {
        one(page, test, fragment.samples.1);
    }
}

fn one(page: &mut Page, test: &Test, samples: usize) {
    let when = match test.when {
        When::Early => "before shading",
        When::Late => "after shading",
    };
    let sample = if samples > 1 { format!(" of sample {}", test.sample) } else { String::new() };
    let verdict = if test.passed { "passes" } else { "fails" };
    if let Some(face) = &test.stencil {
        let text = format!(
            "stencil test{sample}, {when}: {} {} {}, then {} is stored",
            u32::from(face.reference & face.read_mask),
            sign(face.test),
            test.before.words[1] & u32::from(face.read_mask),
            test.after.words[1],
        );
        page.line(1, &text, "GL 2.1, section 4.1.5");
    }
    if let Some((compare, write)) = test.depth_test {
        let stored = match (write, test.passed) {
            (DepthWrite::On, true) => {
                format!("{verdict}, {} is stored", number(test.after.color[0]))
            }
            (DepthWrite::On, false) | (DepthWrite::Off, _) => verdict.to_owned(),
        };
        let text = format!(
            "depth test{sample}, {when}: {} {} {} (stored): {stored}",
            number(test.depth),
            sign(compare),
            number(test.before.color[0]),
        );
        page.line(1, &text, "GL 2.1, section 4.1.6");
    }
}

/// What is written.
pub fn writes(page: &mut Page, fragment: &Fragment) {
    for write in &fragment.writes {
        let sample = match fragment.samples.1 {
            1 => String::new(),
            _ => format!(", sample {}", write.sample),
        };
        if write.target > 0 || fragment.samples.1 > 1 {
            page.line(1, &format!("colour buffer {}{sample}:", write.target), "");
        }
        if let Some(blending) = &write.blend {
            blend(page, blending);
        }
        if let Some(op) = write.logic_op {
            page.line(
                1,
                &format!("logical operation {}", enum_name(LOGIC_OP.encode(op))),
                "GL 2.1, section 4.1.10",
            );
        }
        stored(page, write);
    }
}

fn blend(page: &mut Page, blending: &Blending) {
    let state = &blending.state;
    let factor = |factors: [BlendFactor; 2]| {
        factors.map(|factor| enum_name(FACTOR.encode(factor))).join(", ")
    };
    let formula = |equation: BlendEquation| match equation {
        BlendEquation::Add => "C = C_s S + C_d D",
        BlendEquation::Subtract => "C = C_s S - C_d D",
        BlendEquation::ReverseSubtract => "C = C_d D - C_s S",
        BlendEquation::Min => "C = min(C_s, C_d)",
        BlendEquation::Max => "C = max(C_s, C_d)",
    };
    let [color, alpha] = state.equation.map(formula);
    let text = match color == alpha {
        true => format!("blending: {color}"),
        false => format!("blending: {color}; of alpha, {alpha}"),
    };
    page.line(1, &text, "GL 2.1, section 4.1.8, tables 4.1, 4.2");
    let row =
        |name: &str, values: &[f32; 4], what: String| vec![name.to_owned(), numbers(values), what];
    let mut rows =
        vec![row("C_s", &blending.source, "the shader's colour, in the buffer's range".into())];
    if let Some(second) = &blending.second {
        rows.push(row("C_s1", second, "its second colour, in the buffer's range".into()));
    }
    rows.extend([
        row("S", &blending.source_factor, factor(state.src)),
        row("C_d", &blending.destination, "what was stored".into()),
        row("D", &blending.destination_factor, factor(state.dst)),
        row("C", &blending.result, String::new()),
    ]);
    page.table(2, &rows);
}

fn stored(page: &mut Page, write: &Write) {
    let words: Vec<String> = write.after.words[..write.format.words()]
        .iter()
        .map(|word| format!("{word:08x}"))
        .collect();
    let text = format!(
        "stored as {}: {}, word {}; before, {}",
        format_name(write.format),
        numbers(&write.after.color),
        words.join(" "),
        numbers(&write.before.color)
    );
    page.line(1, &text, "GL 2.1, section 2.14.9");
}

/// The last line: what the pixel holds.
pub fn value(page: &mut Page, explanation: &Explanation) {
    let value = explanation.value;
    let bytes = value.map(|component| (component.clamp(0.0, 1.0) * 255.0 + 0.5) as u8);
    let alone = match explanation.last_write() {
        Some(texel) if texel.color == value => "",
        Some(_) => {
            " (resolved from the samples, or written by glCopyPixels, glBlitFramebuffer or the like)"
        }
        None => " (nothing that was watched wrote it)",
    };
    let [r, g, b, a] = bytes;
    page.line(
        0,
        &format!("the pixel is {} = {r}, {g}, {b}, {a} of 255{alone}", numbers(&value)),
        "",
    );
}
