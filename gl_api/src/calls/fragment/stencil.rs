//! The calls of the stencil test: GL 2.1, section 4.1.5, and `EXT_stencil_two_side`.

use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::base::error::{Result, Table};
use crate::base::types::*;
use crate::context::Context;
use crate::state::stencil::{ACTIVE_FACE, Face, STENCIL_OP, Stencil};
use rasterizer::driver::StencilOp;

const SECTION: &str = "GL 2.1, section 4.1.5";

/// Which of the faces [front, back] a call names.
const NAMED: Table<[bool; 2]> = Table {
    section: SECTION,
    rows: &[(GL_FRONT, [true, false]), (GL_BACK, [false, true]), (GL_FRONT_AND_BACK, [true, true])],
};

fn named(context: &mut Context, face: GLenum) -> Result<impl Iterator<Item = &mut Face>> {
    let named = NAMED.decode("face", face)?;
    let faces = context.state.fragment.stencil.faces.iter_mut().zip(named);
    Ok(faces.filter(|(_, named)| *named).map(|(face, _)| face))
}

/// Changes the faces that calls without a face are about.
fn set_unnamed(context: &mut Context, change: impl Fn(Face) -> Face) {
    let set = |stencil: &mut Stencil| {
        for face in stencil.unnamed() {
            *face = change(*face);
        }
    };
    context.change_plain(|state| &mut state.fragment.stencil, set);
}

pub(crate) fn stencil_func(
    context: &mut Context,
    func: GLenum,
    reference: GLint,
    mask: GLuint,
) -> Result<()> {
    let func = COMPARE.decode("func", func)?;
    set_unnamed(context, |face| Face { func, reference, value_mask: mask, ..face });
    Ok(())
}

pub(crate) fn stencil_func_separate(
    context: &mut Context,
    face: GLenum,
    func: GLenum,
    reference: GLint,
    mask: GLuint,
) -> Result<()> {
    let func = COMPARE.decode("func", func)?;
    for face in named(context, face)? {
        *face = Face { func, reference, value_mask: mask, ..*face };
    }
    Ok(())
}

/// As [`stencil_func_separate`] of either face (`ATI_separate_stencil`).
pub(crate) fn stencil_func_separate_ati(
    context: &mut Context,
    frontfunc: GLenum,
    backfunc: GLenum,
    reference: GLint,
    mask: GLuint,
) -> Result<()> {
    let funcs = [COMPARE.decode("frontfunc", frontfunc)?, COMPARE.decode("backfunc", backfunc)?];
    for (face, func) in context.state.fragment.stencil.faces.iter_mut().zip(funcs) {
        *face = Face { func, reference, value_mask: mask, ..*face };
    }
    Ok(())
}

/// `sfail`, `dpfail` and `dppass` of a call.
fn operations(ops: [GLenum; 3]) -> Result<[StencilOp; 3]> {
    let [fail, depth_fail, pass] = ops;
    Ok([
        STENCIL_OP.decode("sfail", fail)?,
        STENCIL_OP.decode("dpfail", depth_fail)?,
        STENCIL_OP.decode("dppass", pass)?,
    ])
}

pub(crate) fn stencil_op(
    context: &mut Context,
    fail: GLenum,
    zfail: GLenum,
    zpass: GLenum,
) -> Result<()> {
    let [fail, depth_fail, pass] = operations([fail, zfail, zpass])?;
    set_unnamed(context, |face| Face { fail, depth_fail, pass, ..face });
    Ok(())
}

pub(crate) fn stencil_op_separate(
    context: &mut Context,
    face: GLenum,
    sfail: GLenum,
    dpfail: GLenum,
    dppass: GLenum,
) -> Result<()> {
    let [fail, depth_fail, pass] = operations([sfail, dpfail, dppass])?;
    for face in named(context, face)? {
        *face = Face { fail, depth_fail, pass, ..*face };
    }
    Ok(())
}

pub(crate) fn stencil_mask(context: &mut Context, mask: GLuint) -> Result<()> {
    set_unnamed(context, |face| Face { write_mask: mask, ..face });
    Ok(())
}

pub(crate) fn stencil_mask_separate(
    context: &mut Context,
    face: GLenum,
    mask: GLuint,
) -> Result<()> {
    for face in named(context, face)? {
        face.write_mask = mask;
    }
    Ok(())
}

pub(crate) fn active_stencil_face_ext(context: &mut Context, face: GLenum) -> Result<()> {
    context.state.fragment.stencil.active = ACTIVE_FACE.decode("face", face)?;
    Ok(())
}
