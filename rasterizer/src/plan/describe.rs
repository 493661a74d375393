//! A plan in words, for `DETGL_EXPLAIN`.

use super::{DrawPlan, ShaderTestOutputs, Shading, TestTiming};
use crate::output::{ColorPlan, OpaqueBlocks};
use std::fmt::Write;
use texunit::sampler::Compare;

impl DrawPlan {
    /// What runs, what is left out, and why (`DETGL_EXPLAIN`).
    pub fn describe(&self) -> String {
        let compiled = self.pipeline.compiled();
        let desc = &compiled.desc;
        let mut text = String::new();
        let mut line = |name: &str, what: String| {
            let _ = writeln!(text, "  {name:<12} {what}");
        };
        if self.has_no_effect() {
            line(
                "draw",
                "left out: it writes no colour, depth or stencil, and counts nothing".into(),
            );
            return text;
        }
        line("vertex", compiled.vertex.describe());
        line("varyings", self.describe_varyings());
        line(
            "depth",
            match (self.tests.depth, desc.depth) {
                (None, None) => "left out: no depth test".into(),
                (None, Some(_)) => {
                    "left out: no depth attachment, or always passes and never writes".into()
                }
                (Some(plan), _) => self.timing.describe(plan.test, plan.write),
            },
        );
        if let Some(plan) = self.tests.stencil {
            line("stencil", self.timing.describe(plan.front.test, plan.front.pass));
        }
        match self.shading {
            Shading::On => {
                line("fragment", compiled.fragment.describe());
                if !compiled.facts.is_empty() {
                    line("facts", compiled.facts.describe());
                }
                for note in &desc.fragment.module().notes {
                    line("", note.clone());
                }
            }
            Shading::Off => line("fragment", "left out: no colour is written".into()),
        }
        if self.product.is_some() {
            line("", "blocks: texels are multiplied as they come, without registers".into());
        }
        for (slot, texture) in self.textures.iter().enumerate() {
            let used = compiled.fragment.texture_slots().contains(&(slot as u32));
            line(
                &format!("texture {slot}"),
                match texture {
                    _ if !used => "left out: not sampled".into(),
                    Some(plan) if plan.incomplete().is_some() => plan.describe(),
                    Some(plan) => format!("{}; {}", plan.describe(), plan.describe_kernel()),
                    None => "no texture: samples as (0, 0, 0, 1)".into(),
                },
            );
        }
        for color in &self.colors {
            line(&format!("colour {}", color.target), describe_color(color));
        }
        if self.samples.count > 1 {
            let how =
                if self.samples.is_each() { "each covered by itself" } else { "all as the centre" };
            let each = if self.samples.is_shaded_each() { ", shaded at each" } else { "" };
            line("samples", format!("{} a pixel, {how}{each}", self.samples.count));
        }
        line("planes", format!("{} evaluated a pixel", self.planes.len()));
        text
    }

    /// The varyings, in words.
    fn describe_varyings(&self) -> String {
        let compiled = self.pipeline.compiled();
        let (all, sides) = (compiled.varyings.len(), compiled.sides.len());
        let mut text = format!("{} scalars interpolated", all - sides);
        if sides > 0 {
            let _ = write!(text, "; left out: {sides} of the side that is not seen");
        }
        if compiled.hoisted > 0 {
            let _ = write!(text, ", of them {} made of others at the vertices", compiled.hoisted);
        }
        let dropped = compiled.written_varyings.saturating_sub(compiled.varyings.len());
        if dropped > 0 {
            let _ = write!(text, "; left out: {dropped} that the fragment stage does not read");
        }
        if self.denominator_plane.is_none() {
            text += "; left out: perspective division (nothing smooth is read)";
        }
        text
    }
}

impl TestTiming {
    /// The timing of a test, in words.
    fn describe(self, test: Compare, write: impl std::fmt::Debug) -> String {
        match self {
            Self::Never => "left out".into(),
            Self::Early => format!("early, {test:?}, write {write:?}"),
            Self::Late(written) => format!(
                "late, {test:?}, write {write:?}: the shader {}",
                match written {
                    ShaderTestOutputs { depth: Some(_), .. } => "writes depth",
                    ShaderTestOutputs { reference: Some(_), .. } =>
                        "writes the stencil's reference",
                    ShaderTestOutputs { depth: None, reference: None } => "throws fragments away",
                },
            ),
        }
    }
}

/// The operations on an attachment, in words.
fn describe_color(color: &ColorPlan) -> String {
    let how = match (color.logic_op, color.blend) {
        (Some(op), _) => format!("logical operation, {op:?}"),
        (None, Some(blend)) => match color.opaque {
            OpaqueBlocks::Blended => format!("blended, {:?}", blend.equation),
            OpaqueBlocks::Replaced => {
                format!("blended but where a block is opaque, {:?}", blend.equation)
            }
        },
        (None, None) => "left out: blending (the old colour is not read)".into(),
    };
    let mut text = format!("{how}, written bits");
    for word in &color.write[..color.format.words()] {
        let _ = write!(text, " {word:08x}");
    }
    text
}
