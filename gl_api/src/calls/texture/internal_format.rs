//! `glGetInternalformativ` (`ARB_internalformat_query`; OpenGL ES 3.0, section 6.1.15): the numbers of samples that images
//! of a format can have.

use crate::base::constants::*;
use crate::base::error::{Result, Table, not_negative};
use crate::base::limits::MAX_SAMPLES;
use crate::base::types::*;
use crate::context::Context;
use crate::pixel::formats::{FormatSet, InternalFormat, Renderable};

const SECTION: &str = "ARB_internalformat_query";

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    SampleCounts,
    Samples,
}

const PROPERTY: Table<Property> = Table {
    section: SECTION,
    rows: &[(GL_NUM_SAMPLE_COUNTS, Property::SampleCounts), (GL_SAMPLES, Property::Samples)],
};

const TARGET: Table<()> = Table {
    section: SECTION,
    rows: &[
        (GL_RENDERBUFFER, ()),
        (GL_TEXTURE_2D_MULTISAMPLE, ()),
        (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, ()),
    ],
};

const DRAWN_TO: FormatSet =
    FormatSet::new(SECTION, |format| format.is_for_renderbuffers() && is_drawn_to(format));
const DRAWN_TO_IN_ES: FormatSet = FormatSet::new("OpenGL ES 3.0, table 3.13", |format| {
    format.is_for_renderbuffers_in_es() && is_drawn_to(format)
});

fn is_drawn_to(format: &InternalFormat) -> bool {
    format.renderable != Renderable::No && !format.is_compressed()
}

pub(crate) fn get_internalformativ(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    pname: GLenum,
    bufsize: GLsizei,
    params: &mut [GLint],
) -> Result<()> {
    TARGET.decode("target", target)?;
    let is_es = context.profile.is_es();
    let formats = if is_es { DRAWN_TO_IN_ES } else { DRAWN_TO };
    let format = formats.decode("internalformat", internalformat)?;
    let property = PROPERTY.decode("pname", pname)?;
    let room = not_negative(SECTION, "bufSize", bufsize.into())?;
    // Integers have none in renderbuffers of OpenGL ES 3.0 (section 4.4.2.1).
    let counts: &[GLint] = match is_es && format.stored.is_integer() {
        true => &[],
        false => &[MAX_SAMPLES as GLint],
    };
    let number = [counts.len() as GLint];
    let values = match property {
        Property::SampleCounts => &number[..],
        Property::Samples => counts,
    };
    for (to, value) in params.iter_mut().take(room).zip(values) {
        *to = *value;
    }
    Ok(())
}
