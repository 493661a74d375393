//! `glClampColor` (`ARB_color_buffer_float`).
//!
//! Colours of the state (fog, environments, the alpha reference, blending, clearing, borders) are kept as they are given,
//! and clamped where they are used or queried.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum};
use crate::base::types::*;
use crate::context::Context;
use crate::state::clamp::When;
use texunit::format::{BaseFormat, Encoding, Format};

const SECTION: &str = "ARB_color_buffer_float, section 2.14.6";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    Vertex,
    Fragment,
    Read,
}

const TARGET: Table<Target> = Table {
    section: SECTION,
    rows: &[
        (GL_CLAMP_VERTEX_COLOR, Target::Vertex),
        (GL_CLAMP_FRAGMENT_COLOR, Target::Fragment),
        (GL_CLAMP_READ_COLOR, Target::Read),
    ],
};

pub(crate) const WHEN: Table<When> = Table {
    section: SECTION,
    rows: &[(GL_TRUE, When::Always), (GL_FALSE, When::Never), (GL_FIXED_ONLY, When::Fixed)],
};

pub(crate) fn clamp_color(context: &mut Context, target: GLenum, clamp: GLenum) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    let Some(when) = WHEN.get(clamp) else {
        return invalid_enum(
            SECTION,
            format!("clamp = {clamp:#x} must be GL_TRUE, GL_FALSE or GL_FIXED_ONLY"),
        );
    };
    let state = &mut context.state.clamp;
    match target {
        Target::Vertex => state.vertex = when,
        Target::Fragment => state.fragment = when,
        Target::Read => state.read = when,
    }
    Ok(())
}

/// Which of red, green, blue and alpha can be negative (`EXT_packed_float`, table 6.33).
pub(crate) fn signed_components(format: Format) -> [bool; 4] {
    let info = format.info();
    let is_signed = match info.encoding {
        Encoding::Snorm | Encoding::Sint => true,
        // Floats of fewer bits have no sign.
        Encoding::Float => info.fields[0].bits >= 16,
        Encoding::Unorm
        | Encoding::Srgb
        | Encoding::SharedExponent
        | Encoding::Uint
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => false,
    };
    let there = match format.base() {
        BaseFormat::Red => [true, false, false, false],
        BaseFormat::Rg => [true, true, false, false],
        BaseFormat::Rgb | BaseFormat::Luminance => [true, true, true, false],
        BaseFormat::Rgba | BaseFormat::LuminanceAlpha | BaseFormat::Intensity => [true; 4],
        BaseFormat::Alpha => [false, false, false, true],
        BaseFormat::Depth => [false; 4],
    };
    there.map(|there| is_signed && there)
}
