//! `glRenderMode`, `glSelectBuffer` and `glFeedbackBuffer`, and the stack of names: GL 2.1, sections 5.2 and 5.3.

use crate::base::args::DataOut;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::context::feedback::record::{FeedbackType, Record};
use crate::context::feedback::{RenderMode, Target};

const SELECTION: &str = "GL 2.1, section 5.2";
const FEEDBACK: &str = "GL 2.1, section 5.3";

pub(crate) const MODE: Table<RenderMode> = Table {
    section: SELECTION,
    rows: &[
        (GL_RENDER, RenderMode::Render),
        (GL_SELECT, RenderMode::Select),
        (GL_FEEDBACK, RenderMode::Feedback),
    ],
};

/// What glRenderMode answers about the mode that ends: a count, or -1 where the buffer was too
/// small.
fn leave(context: &mut Context) -> GLint {
    let feedback = &mut context.feedback;
    match feedback.mode {
        RenderMode::Render => 0,
        RenderMode::Select => feedback.select.leave(),
        RenderMode::Feedback => feedback.record.leave(),
    }
}

fn checked(context: &Context, mode: GLenum) -> Result<RenderMode> {
    let mode = MODE.decode("mode", mode)?;
    let feedback = &context.feedback;
    let missing = match mode {
        RenderMode::Render => None,
        RenderMode::Select => feedback.select.target().is_none().then_some("glSelectBuffer"),
        RenderMode::Feedback => feedback.record.target().is_none().then_some("glFeedbackBuffer"),
    };
    match missing {
        None => Ok(mode),
        Some(call) => invalid_operation(
            SELECTION,
            format!(
                "there is no buffer for mode = {}: call {call} first",
                enum_name(MODE.encode(mode))
            ),
        ),
    }
}

/// A refused call answers 0.
pub(crate) fn render_mode(context: &mut Context, mode: GLenum) -> Result<GLint> {
    let mode = match checked(context, mode) {
        Ok(mode) => mode,
        Err(error) => {
            context.debug.error("glRenderMode", &error);
            return Ok(0);
        }
    };
    let answer = leave(context);
    context.feedback.mode = mode;
    context.feedback.select.enter();
    context.feedback.record.enter();
    Ok(answer)
}

/// Where a buffer is. A slice ends with its call, before there is anything to write to it.
fn target(section: &'static str, argument: &str, buffer: DataOut<'_>) -> Result<Target> {
    match buffer {
        DataOut::Null => Ok(Target::Own),
        DataOut::Client(pointer) if pointer.is_null() => Ok(Target::Own),
        DataOut::Client(pointer) => Ok(Target::Client(pointer.kept())),
        DataOut::Bytes(_) | DataOut::Offset(_) => invalid_operation(
            section,
            format!(
                "{argument} cannot be memory that is borrowed for the call alone: pass NULL, and read \
                 Context::selection or Context::feedback after glRenderMode"
            ),
        ),
    }
}

fn not_in(context: &Context, mode: RenderMode, section: &'static str) -> Result<()> {
    if context.feedback.mode == mode {
        let mode = enum_name(MODE.encode(mode));
        return invalid_operation(
            section,
            format!("the mode is {mode}, which fills the buffer: call glRenderMode first"),
        );
    }
    Ok(())
}

pub(crate) fn select_buffer(
    context: &mut Context,
    size: GLsizei,
    buffer: DataOut<'_>,
) -> Result<()> {
    let size = not_negative(SELECTION, "size", size.into())?;
    not_in(context, RenderMode::Select, SELECTION)?;
    let target = target(SELECTION, "buffer", buffer)?;
    context.feedback.select.set_target(size, target);
    Ok(())
}

pub(crate) fn feedback_buffer(
    context: &mut Context,
    size: GLsizei,
    ty: GLenum,
    buffer: DataOut<'_>,
) -> Result<()> {
    let size = not_negative(FEEDBACK, "size", size.into())?;
    let ty = FeedbackType::TABLE.decode("type", ty)?;
    not_in(context, RenderMode::Feedback, FEEDBACK)?;
    let target = target(FEEDBACK, "buffer", buffer)?;
    context.feedback.record = Record::new(size, ty, target);
    Ok(())
}

pub(crate) fn pass_through(context: &mut Context, token: GLfloat) -> Result<()> {
    if context.feedback.mode == RenderMode::Feedback {
        context.feedback.record.pass_through(token);
    }
    Ok(())
}

pub(crate) fn init_names(context: &mut Context) -> Result<()> {
    in_selection(context, |select| {
        select.init_names();
        Ok(())
    })
}

pub(crate) fn load_name(context: &mut Context, name: GLuint) -> Result<()> {
    in_selection(context, |select| select.load_name(name))
}

pub(crate) fn push_name(context: &mut Context, name: GLuint) -> Result<()> {
    in_selection(context, |select| select.push_name(name))
}

pub(crate) fn pop_name(context: &mut Context) -> Result<()> {
    in_selection(context, crate::context::feedback::select::Select::pop_name)
}

/// Changes the stack of names; in other modes such calls are ignored.
fn in_selection(
    context: &mut Context,
    change: impl FnOnce(&mut crate::context::feedback::select::Select) -> Result<()>,
) -> Result<()> {
    match context.feedback.mode {
        RenderMode::Select => change(&mut context.feedback.select),
        RenderMode::Render | RenderMode::Feedback => Ok(()),
    }
}

impl Context {
    /// The hit records of the selection that ended last: for each the number of names, the least and
    /// the largest depth (of 2³² - 1), and the names from the bottom of the stack.
    pub fn selection(&self) -> &[GLuint] {
        self.feedback.select.records()
    }

    /// The numbers of the feedback that ended last (GL 2.1, section 5.3).
    pub fn feedback(&self) -> &[GLfloat] {
        self.feedback.record.values()
    }
}

/// Where a buffer begins, by the name that `glGetPointerv` has for it.
pub(crate) fn pointer(context: &Context, pname: GLenum) -> Option<usize> {
    let target = match pname {
        GL_SELECTION_BUFFER_POINTER => context.feedback.select.target(),
        GL_FEEDBACK_BUFFER_POINTER => context.feedback.record.target(),
        _ => return None,
    };
    Some(match target {
        Some(Target::Client(pointer)) => pointer.offset(),
        Some(Target::Own) | None => 0,
    })
}
