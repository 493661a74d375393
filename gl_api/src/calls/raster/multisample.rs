//! `glSampleCoverage`, `glSampleMaski` and `glGetMultisamplefv`: GL 2.1, sections 3.2.1 and 4.1.3;
//! `ARB_texture_multisample`, sections 3.3.1 and 4.1.3. `glMinSampleShading`: `ARB_sample_shading`.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::draw::completeness::samples;
use crate::state::multisample::{MAX_SAMPLE_MASK_WORDS, Multisample};
use rasterizer::driver::sample_positions;

pub(crate) fn sample_coverage(context: &mut Context, value: GLclampf, invert: bool) -> Result<()> {
    let value = texunit::lanes::math::clamp(value, 0.0, 1.0);
    let state = &mut context.state.raster.multisample;
    *state = Multisample { value, invert, ..*state };
    Ok(())
}

pub(crate) fn min_sample_shading(context: &mut Context, value: GLfloat) -> Result<()> {
    context.state.raster.multisample.shaded = texunit::lanes::math::clamp(value, 0.0, 1.0);
    Ok(())
}

/// A word of the sample mask.
pub(crate) fn checked_word(argument: &str, index: GLuint) -> Result<()> {
    if index < MAX_SAMPLE_MASK_WORDS {
        return Ok(());
    }
    invalid_value(
        "ARB_texture_multisample, section 4.1.3",
        format!(
            "{argument} = {index} must be below GL_MAX_SAMPLE_MASK_WORDS, {MAX_SAMPLE_MASK_WORDS}"
        ),
    )
}

pub(crate) fn sample_maski(
    context: &mut Context,
    mask_number: GLuint,
    mask: GLbitfield,
) -> Result<()> {
    checked_word("maskNumber", mask_number)?;
    context.state.raster.multisample.mask = mask;
    Ok(())
}

/// Where the samples of the draw framebuffer lie in their pixel.
pub(crate) fn get_multisamplefv(
    context: &mut Context,
    pname: GLenum,
    index: GLuint,
    val: &mut [GLfloat],
) -> Result<()> {
    const SECTION: &str = "ARB_texture_multisample, section 3.3.1";
    const PROPERTY: Table<()> = Table { section: SECTION, rows: &[(GL_SAMPLE_POSITION, ())] };
    PROPERTY.decode("pname", pname)?;
    let count = samples(context, context.state.bindings.draw_framebuffer);
    match sample_positions(count).get(index as usize) {
        Some(position) if count > 0 => put(val, position),
        Some(_) | None => invalid_value(
            SECTION,
            format!("index = {index} must be below GL_SAMPLES of the draw framebuffer, {count}"),
        ),
    }
}
