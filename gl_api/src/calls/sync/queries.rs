//! The calls of query objects: GL 2.1, section 4.1.7 (samples), GL 3.0, section 2.16 (primitives),
//! `ARB_occlusion_query2`, `ARB_timer_query`.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::transform_feedback::checked_stream;
use crate::context::Context;
use crate::draw::pass::submit;
use crate::objects::name_table::listed;
use crate::objects::queries::{Query, QueryTarget, TARGET, timestamp};
use rasterizer::driver::Counter;
use std::time::Instant;

const SECTION: &str = "GL 2.1, section 4.1.7";

pub(crate) fn gen_queries(context: &mut Context, n: GLsizei, ids: &mut [GLuint]) -> Result<()> {
    context.objects.queries.reserve(SECTION, n, ids)
}

pub(crate) fn delete_queries(context: &mut Context, n: GLsizei, ids: &[GLuint]) -> Result<()> {
    for &name in listed(SECTION, n, ids)?.iter().filter(|&&name| name != 0) {
        for active in &mut context.queries.names {
            if *active == name {
                *active = 0;
            }
        }
        context.objects.queries.remove(name);
    }
    count_with(context);
    Ok(())
}

pub(crate) fn is_query(context: &mut Context, id: GLuint) -> Result<bool> {
    Ok(context.objects.queries.get(id).is_some())
}

/// Lets the draws to come count for the query of samples that is active.
fn count_with(context: &mut Context) {
    let name = context.queries.names[0];
    context.recorder.counter = context.objects.queries.get(name).map(|query| query.counter.clone());
}

pub(crate) fn begin_query(context: &mut Context, target: GLenum, id: GLuint) -> Result<()> {
    let kind = TARGET.decode("target", target)?;
    if id == 0 {
        return invalid_operation(SECTION, "id = 0 is no query: call glGenQueries");
    }
    if !context.profile.is_compatibility() {
        context.objects.queries.check_given("id", id, "glGenQueries")?;
    }
    let active = *context.queries.slot(kind);
    if let Some(query) = context.objects.queries.get(active).filter(|_| active != 0) {
        let active = enum_name(query.target_name());
        let rule = format!("a query of {active} is active: glEndQuery is missing");
        return invalid_operation(SECTION, rule);
    }
    let before = context.objects.queries.get(id);
    if let Some(query) = before.filter(|_| context.queries.is_active(id)) {
        let active = enum_name(query.target_name());
        let rule = format!("query {id} is active as one of {active}: glEndQuery is missing");
        return invalid_operation(SECTION, rule);
    }
    if let Some(query) = before.filter(|query| query.target != kind) {
        let rule =
            format!("query {id} is one of {}: take another name", enum_name(query.target_name()));
        return invalid_operation(SECTION, rule);
    }
    if kind == QueryTarget::TimeElapsed {
        submit(context);
    }
    context.objects.queries.create(id, || Query::new(kind));
    if let Some(query) = context.objects.queries.get_mut(id) {
        query.counter = Counter::new();
        query.primitives = 0;
        query.began = Some(Instant::now());
        query.nanoseconds = 0;
    }
    *context.queries.slot(kind) = id;
    count_with(context);
    Ok(())
}

pub(crate) fn end_query(context: &mut Context, target: GLenum) -> Result<()> {
    let kind = TARGET.decode("target", target)?;
    let id = *context.queries.slot(kind);
    if context.objects.queries.get(id).is_none_or(|query| query.target != kind) {
        return invalid_operation(
            SECTION,
            format!("no query of {} is active: glBeginQuery is missing", enum_name(target)),
        );
    }
    if kind == QueryTarget::TimeElapsed {
        submit(context);
    }
    if let Some(query) = context.objects.queries.get_mut(id) {
        query.nanoseconds = query.began.map_or(0, |began| began.elapsed().as_nanos() as u64);
    }
    *context.queries.slot(kind) = 0;
    count_with(context);
    Ok(())
}

pub(crate) fn query_counter(context: &mut Context, id: GLuint, target: GLenum) -> Result<()> {
    const COUNTER: Table<QueryTarget> =
        Table { section: "ARB_timer_query", rows: &[(GL_TIMESTAMP, QueryTarget::Timestamp)] };
    let kind = COUNTER.decode("target", target)?;
    if id == 0 || !context.objects.queries.is_reserved(id) || context.queries.is_active(id) {
        return invalid_operation(
            COUNTER.section,
            format!("id = {id} must be a name that glGenQueries gave, and not be active"),
        );
    }
    if let Some(query) = context.objects.queries.get(id).filter(|query| query.target != kind) {
        let rule =
            format!("query {id} is one of {}: take another name", enum_name(query.target_name()));
        return invalid_operation(COUNTER.section, rule);
    }
    submit(context);
    let query = Query { nanoseconds: timestamp(), ..Query::new(kind) };
    context.objects.queries.create(id, || query.clone());
    if let Some(slot) = context.objects.queries.get_mut(id) {
        *slot = query;
    }
    Ok(())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Current,
    Bits,
}

pub(crate) fn get_queryiv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: "GL 2.1, section 6.1.12",
        rows: &[(GL_CURRENT_QUERY, Property::Current), (GL_QUERY_COUNTER_BITS, Property::Bits)],
    };
    let kind = match target {
        GL_TIMESTAMP => QueryTarget::Timestamp,
        _ => TARGET.decode("target", target)?,
    };
    let value = match PROPERTY.decode("pname", pname)? {
        Property::Current => {
            let id = *context.queries.slot(kind);
            let same = context.objects.queries.get(id).is_some_and(|query| query.target == kind);
            if same { id as GLint } else { 0 }
        }
        Property::Bits => match kind {
            QueryTarget::AnySamplesPassed | QueryTarget::AnySamplesPassedConservative => 1,
            QueryTarget::SamplesPassed
            | QueryTarget::PrimitivesGenerated
            | QueryTarget::TransformFeedbackPrimitivesWritten
            | QueryTarget::TimeElapsed
            | QueryTarget::Timestamp => 64,
        },
    };
    put(params, &[value])
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    Result,
    Available,
    Target,
}

/// What a query answers: its result, with everything carried out that it counts.
pub(crate) fn answer(context: &mut Context, id: GLuint, pname: GLenum) -> Result<u64> {
    const ANSWER: Table<Answer> = Table {
        section: "GL 2.1, section 6.1.12",
        rows: &[
            (GL_QUERY_RESULT, Answer::Result),
            (GL_QUERY_RESULT_AVAILABLE, Answer::Available),
            (GL_QUERY_TARGET, Answer::Target),
        ],
    };
    // A copy shares the counter.
    let Some(query) = context.objects.queries.get(id).cloned() else {
        return invalid_operation(ANSWER.section, format!("id = {id} is no query that has begun"));
    };
    if context.queries.is_active(id) {
        return invalid_operation(
            ANSWER.section,
            format!("query {id} is active: call glEndQuery first"),
        );
    }
    let wanted = ANSWER.decode("pname", pname)?;
    submit(context);
    Ok(match (wanted, query.target) {
        (Answer::Available, _) => 1,
        (Answer::Target, _) => query.target_name().into(),
        (Answer::Result, QueryTarget::SamplesPassed) => query.counter.samples(),
        (
            Answer::Result,
            QueryTarget::AnySamplesPassed | QueryTarget::AnySamplesPassedConservative,
        ) => u64::from(query.counter.samples() > 0),
        (
            Answer::Result,
            QueryTarget::PrimitivesGenerated | QueryTarget::TransformFeedbackPrimitivesWritten,
        ) => query.primitives,
        (Answer::Result, QueryTarget::TimeElapsed | QueryTarget::Timestamp) => query.nanoseconds,
    })
}

pub(crate) fn get_query_objectiv(
    context: &mut Context,
    id: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let value = answer(context, id, pname)?;
    put(params, &[GLint::try_from(value).unwrap_or(GLint::MAX)])
}

pub(crate) fn get_query_objectuiv(
    context: &mut Context,
    id: GLuint,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    let value = answer(context, id, pname)?;
    put(params, &[GLuint::try_from(value).unwrap_or(GLuint::MAX)])
}

pub(crate) fn get_query_objecti64v(
    context: &mut Context,
    id: GLuint,
    pname: GLenum,
    params: &mut [GLint64],
) -> Result<()> {
    let value = answer(context, id, pname)?;
    put(params, &[GLint64::try_from(value).unwrap_or(GLint64::MAX)])
}

pub(crate) fn get_query_objectui64v(
    context: &mut Context,
    id: GLuint,
    pname: GLenum,
    params: &mut [GLuint64],
) -> Result<()> {
    let value = answer(context, id, pname)?;
    put(params, &[value])
}

/// Checks the index of a query: a vertex stream of the queries that count primitives, 0 of others
/// (`ARB_transform_feedback3`).
fn check_index(target: GLenum, index: GLuint) -> Result<()> {
    let kind = TARGET.decode("target", target)?;
    // Every target has this one.
    if index == 0 {
        return Ok(());
    }
    match kind {
        QueryTarget::PrimitivesGenerated | QueryTarget::TransformFeedbackPrimitivesWritten => {
            checked_stream("index", index)
        }
        QueryTarget::AnySamplesPassed
        | QueryTarget::AnySamplesPassedConservative
        | QueryTarget::SamplesPassed
        | QueryTarget::TimeElapsed
        | QueryTarget::Timestamp => invalid_value(
            "ARB_transform_feedback3, section 2.14",
            format!("index = {index} must be 0 for {}", enum_name(target)),
        ),
    }
}

pub(crate) fn begin_query_indexed(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    id: GLuint,
) -> Result<()> {
    check_index(target, index)?;
    begin_query(context, target, id)
}

pub(crate) fn end_query_indexed(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
) -> Result<()> {
    check_index(target, index)?;
    end_query(context, target)
}

pub(crate) fn get_query_indexediv(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    if target != GL_TIMESTAMP {
        check_index(target, index)?;
    }
    get_queryiv(context, target, pname, params)
}
