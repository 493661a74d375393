//! Conditional rendering: `NV_conditional_render`; GL 3.0, section 2.14.
//!
//! The result is waited for in every mode, so that a picture never depends on how fast it comes.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::draw::pass::submit;
use crate::objects::queries::{ConditionalResult, QueryTarget};

const SECTION: &str = "NV_conditional_render, section 2.X";

pub(crate) fn begin_conditional_render(
    context: &mut Context,
    id: GLuint,
    mode: GLenum,
) -> Result<()> {
    const MODE: Table<()> = Table {
        section: SECTION,
        rows: &[
            (GL_QUERY_WAIT, ()),
            (GL_QUERY_NO_WAIT, ()),
            (GL_QUERY_BY_REGION_WAIT, ()),
            (GL_QUERY_BY_REGION_NO_WAIT, ()),
        ],
    };
    MODE.decode("mode", mode)?;
    if context.queries.conditional.is_some() {
        return invalid_operation(
            SECTION,
            "conditional rendering has begun: glEndConditionalRender is missing",
        );
    }
    let Some(query) = context.objects.queries.get(id) else {
        return invalid_value(SECTION, format!("id = {id} is no query that has begun"));
    };
    match query.target() {
        QueryTarget::SamplesPassed
        | QueryTarget::AnySamplesPassed
        | QueryTarget::AnySamplesPassedConservative => {}
        QueryTarget::PrimitivesGenerated
        | QueryTarget::TransformFeedbackPrimitivesWritten
        | QueryTarget::TimeElapsed
        | QueryTarget::Timestamp => {
            return invalid_operation(SECTION, format!("query {id} counts no samples"));
        }
    }
    if context.queries.is_active(id) {
        return invalid_operation(SECTION, format!("query {id} is active: call glEndQuery first"));
    }
    submit(context);
    let any_passed = context.objects.queries.get(id).is_some_and(|query| query.samples() > 0);
    context.queries.conditional =
        Some(if any_passed { ConditionalResult::Draw } else { ConditionalResult::Discard });
    Ok(())
}

pub(crate) fn end_conditional_render(context: &mut Context) -> Result<()> {
    match context.queries.conditional.take() {
        Some(_) => Ok(()),
        None => invalid_operation(
            SECTION,
            "conditional rendering has not begun: glBeginConditionalRender is missing",
        ),
    }
}
