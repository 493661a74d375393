//! The formulas of a fixed-function fragment stage as the specification prints them, for
//! explanations.

use crate::base::clamp::Clamp;
use crate::base::compare::COMPARE;
use crate::base::constants::enum_name;
use crate::generate::fixed::combine::CombineKey;
use crate::generate::fixed::environment::Environment;
use crate::generate::fixed::fog::FogKey;
use crate::generate::fixed::fragment::{FragmentKey, UnitKey};
use crate::state::fog::FogMode;
use crate::state::texture_units::Standard;
use crate::state::texture_units::combine::{
    Argument, Arguments, Combiner, Function, Operand, Scale, Source,
};
use texunit::format::BaseFormat;

/// A formula and its section.
type Formula = (String, &'static str);

impl FragmentKey {
    /// What the stage computes after the texture lookups, in order.
    pub fn formulas(&self) -> Vec<Formula> {
        let mut formulas: Vec<Formula> =
            self.units.iter().flat_map(|unit| environment(unit, self.clamp)).collect();
        if self.color_sum {
            formulas.push(("colour sum: C = C + C_secondary".into(), "GL 2.1, section 3.9"));
        }
        formulas.extend(self.fog.map(fog));
        if let Some(compare) = self.alpha {
            let test = format!(
                "alpha test: {} of A and GL_ALPHA_TEST_REF",
                enum_name(COMPARE.encode(compare))
            );
            formulas.push((test, "GL 2.1, section 4.1.4"));
        }
        formulas
    }
}

/// GL's name of a base format.
fn base_name(base: BaseFormat) -> &'static str {
    match base {
        BaseFormat::Alpha => "GL_ALPHA",
        BaseFormat::Luminance => "GL_LUMINANCE",
        BaseFormat::LuminanceAlpha => "GL_LUMINANCE_ALPHA",
        BaseFormat::Intensity => "GL_INTENSITY",
        BaseFormat::Red => "GL_RED",
        BaseFormat::Rg => "GL_RG",
        BaseFormat::Rgb => "GL_RGB",
        BaseFormat::Rgba => "GL_RGBA",
        BaseFormat::Depth => "GL_DEPTH_COMPONENT",
    }
}

fn environment(unit: &UnitKey, clamp: Clamp) -> Vec<Formula> {
    let number = unit.unit;
    match unit.environment {
        Environment::Standard(mode) => {
            let (name, color) = standard(mode, unit.base);
            let base = base_name(unit.base);
            vec![(format!("unit {number}: {name} of {base}: {color}"), SECTION_STANDARD)]
        }
        Environment::Combine(CombineKey { color, alpha, arguments }) => {
            let line = |(name, of)| {
                let text = combiner(&of, arguments, clamp);
                (format!("unit {number}: GL_COMBINE_{name}: {text}"), SECTION_COMBINE)
            };
            [("RGB", color), ("ALPHA", alpha)].map(line).to_vec()
        }
    }
}

const SECTION_STANDARD: &str = "GL 2.1, section 3.8.13, tables 3.22, 3.23";
const SECTION_COMBINE: &str = "GL 2.1, section 3.8.13, tables 3.24, 3.25";

/// The rows of tables 3.22 and 3.23: `C_p`, `A_p` come from the unit before, `C_s`, `A_s` from the
/// texture, `C_c` is the environment's colour.
fn standard(mode: Standard, base: BaseFormat) -> (&'static str, &'static str) {
    let has_alpha = match base {
        BaseFormat::Alpha | BaseFormat::LuminanceAlpha | BaseFormat::Rgba => true,
        BaseFormat::Intensity
        | BaseFormat::Luminance
        | BaseFormat::Red
        | BaseFormat::Rg
        | BaseFormat::Rgb
        | BaseFormat::Depth => false,
    };
    let is_alpha = base == BaseFormat::Alpha;
    let intensity = base == BaseFormat::Intensity;
    match mode {
        Standard::Replace if is_alpha => ("GL_REPLACE", "C = C_p, A = A_s"),
        Standard::Replace if has_alpha || intensity => ("GL_REPLACE", "C = C_s, A = A_s"),
        Standard::Replace => ("GL_REPLACE", "C = C_s, A = A_p"),
        Standard::Modulate if is_alpha => ("GL_MODULATE", "C = C_p, A = A_p A_s"),
        Standard::Modulate if has_alpha || intensity => ("GL_MODULATE", "C = C_p C_s, A = A_p A_s"),
        Standard::Modulate => ("GL_MODULATE", "C = C_p C_s, A = A_p"),
        Standard::Decal => match base {
            BaseFormat::Rgba => ("GL_DECAL", "C = C_p (1 - A_s) + C_s A_s, A = A_p"),
            BaseFormat::Rgb | BaseFormat::Red | BaseFormat::Rg => ("GL_DECAL", "C = C_s, A = A_p"),
            BaseFormat::Alpha
            | BaseFormat::LuminanceAlpha
            | BaseFormat::Luminance
            | BaseFormat::Intensity
            | BaseFormat::Depth => ("GL_DECAL", "undefined; here C = C_p, A = A_p"),
        },
        Standard::Blend if is_alpha => ("GL_BLEND", "C = C_p, A = A_p A_s"),
        Standard::Blend if intensity => {
            ("GL_BLEND", "C = C_p (1 - C_s) + C_c C_s, A = A_p (1 - A_s) + A_c A_s")
        }
        Standard::Blend if has_alpha => ("GL_BLEND", "C = C_p (1 - C_s) + C_c C_s, A = A_p A_s"),
        Standard::Blend => ("GL_BLEND", "C = C_p (1 - C_s) + C_c C_s, A = A_p"),
        Standard::Add if is_alpha => ("GL_ADD", "C = C_p, A = A_p A_s"),
        Standard::Add if intensity => ("GL_ADD", "C = C_p + C_s, A = A_p + A_s"),
        Standard::Add if has_alpha => ("GL_ADD", "C = C_p + C_s, A = A_p A_s"),
        Standard::Add => ("GL_ADD", "C = C_p + C_s, A = A_p"),
    }
}

/// A row of table 3.24 with its arguments, scaled, and clamped where colours are.
fn combiner(combiner: &Combiner, arguments: Arguments, clamp: Clamp) -> String {
    let [a, b, c, d] = combiner.arguments.map(argument);
    let text = match (combiner.function, arguments) {
        (Function::Replace, _) => a,
        (Function::Modulate, _) => format!("{a} · {b}"),
        (Function::Add, Arguments::Two) => format!("{a} + {b}"),
        (Function::Add, Arguments::Four) => format!("{a} · {b} + {c} · {d}"),
        (Function::AddSigned, Arguments::Two) => format!("{a} + {b} - 1/2"),
        (Function::AddSigned, Arguments::Four) => format!("{a} · {b} + {c} · {d} - 1/2"),
        (Function::Interpolate, _) => format!("{a} · {c} + {b} · (1 - {c})"),
        (Function::Subtract, _) => format!("{a} - {b}"),
        (
            Function::Dot3Rgb
            | Function::Dot3Rgba
            | Function::Dot3RgbUnscaled
            | Function::Dot3RgbaUnscaled,
            _,
        ) => format!("4 Σ ({a} - 1/2) ({b} - 1/2) over r, g, b"),
    };
    let scale = match combiner.function {
        Function::Dot3RgbUnscaled | Function::Dot3RgbaUnscaled => Scale::One,
        Function::Replace
        | Function::Modulate
        | Function::Add
        | Function::AddSigned
        | Function::Interpolate
        | Function::Subtract
        | Function::Dot3Rgb
        | Function::Dot3Rgba => combiner.scale,
    };
    let text = match scale {
        Scale::One => text,
        Scale::Two => format!("2 ({text})"),
        Scale::Four => format!("4 ({text})"),
    };
    match clamp {
        Clamp::On => format!("clamp({text})"),
        Clamp::Off => text,
    }
}

fn argument(argument: Argument) -> String {
    let source = match argument.source {
        Source::Texture => "texture".into(),
        Source::Unit(unit) => format!("texture{unit}"),
        Source::Constant => "constant".into(),
        Source::PrimaryColor => "primary".into(),
        Source::Previous => "previous".into(),
        Source::Zero => "0".into(),
    };
    match argument.operand {
        Operand::Color => format!("{source}.C"),
        Operand::OneMinusColor => format!("(1 - {source}.C)"),
        Operand::Alpha => format!("{source}.A"),
        Operand::OneMinusAlpha => format!("(1 - {source}.A)"),
    }
}

fn fog(key: FogKey) -> Formula {
    let factor = match key.mode {
        FogMode::Linear => "f = (end - c) / (end - start)",
        FogMode::Exp => "f = exp(-density · c)",
        FogMode::Exp2 => "f = exp(-(density · c)²)",
    };
    (format!("fog: {factor}, clamped; C = f C + (1 - f) C_fog"), "GL 2.1, section 3.10")
}
