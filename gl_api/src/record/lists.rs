//! `glNewList` to `glCallLists`: GL 2.1, section 5.4.

use crate::base::args::{Data, Located};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::context::lists::primitives::join;
use crate::context::lists::{Compiling, List, ListMode};
use crate::context::warnings::DrawWarning;
use crate::draw::pass::submit;
use std::sync::Arc;

const SECTION: &str = "GL 2.1, section 5.4";

/// Lists call lists to this depth; deeper calls are ignored (GL 2.1, table 6.35).
pub(crate) const MAX_LIST_NESTING: usize = 64;

/// The nested lists of a `glCallList` have this many commands at most: lists that call lists that call lists could
/// otherwise keep a program busy forever. The commands of the list that it names are free: there are as many as the
/// application recorded.
const BUDGET: u64 = 1 << 21;

pub(crate) const MODE: Table<ListMode> = Table {
    section: SECTION,
    rows: &[(GL_COMPILE, ListMode::Compile), (GL_COMPILE_AND_EXECUTE, ListMode::CompileAndExecute)],
};

/// How the names of `glCallLists` lie in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NameType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
    /// This many bytes, the largest first.
    BigEndian(usize),
}

pub(crate) const NAME_TYPE: Table<NameType> = Table {
    section: SECTION,
    rows: &[
        (GL_BYTE, NameType::I8),
        (GL_UNSIGNED_BYTE, NameType::U8),
        (GL_SHORT, NameType::I16),
        (GL_UNSIGNED_SHORT, NameType::U16),
        (GL_INT, NameType::U32),
        (GL_UNSIGNED_INT, NameType::U32),
        (GL_FLOAT, NameType::F32),
        (GL_2_BYTES, NameType::BigEndian(2)),
        (GL_3_BYTES, NameType::BigEndian(3)),
        (GL_4_BYTES, NameType::BigEndian(4)),
    ],
};

impl NameType {
    /// Bytes of a name.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
            Self::BigEndian(bytes) => bytes,
        }
    }

    /// A name from its bytes; negative ones count back from the base.
    fn read(self, bytes: &[u8]) -> GLuint {
        let mut native = [0; 4];
        native[..bytes.len()].copy_from_slice(bytes);
        let native = GLuint::from_le_bytes(native);
        match self {
            Self::I8 => native as i8 as GLuint,
            Self::I16 => native as i16 as GLuint,
            Self::U8 | Self::U16 | Self::U32 => native,
            Self::F32 => f32::from_bits(native) as i64 as GLuint,
            Self::BigEndian(_) => {
                bytes.iter().fold(0, |name, &byte| name << 8 | GLuint::from(byte))
            }
        }
    }
}

pub(crate) fn new_list(context: &mut Context, list: GLuint, mode: GLenum) -> Result<()> {
    if list == 0 {
        return invalid_value(SECTION, "list = 0 must be another number: no list is named 0");
    }
    let mode = MODE.decode("mode", mode)?;
    if let Some(compiling) = &context.compiling {
        let name = compiling.name;
        return invalid_operation(
            SECTION,
            format!("list {name} is being compiled: glEndList is missing"),
        );
    }
    context.compiling =
        Some(Compiling { name: list, mode, steps: Vec::new(), open: None, begun: false });
    Ok(())
}

pub(crate) fn end_list(context: &mut Context) -> Result<()> {
    context.finish_open();
    // Where the list is carried out, too, this stands between glBegin and glEnd.
    if context.immediate.is_some() {
        return invalid_operation("GL 2.1, section 2.6.3", "glEnd is missing");
    }
    let Some(compiling) = context.compiling.take() else {
        return invalid_operation(SECTION, "no list is being compiled: glNewList is missing");
    };
    let list = List::new(join(compiling.steps));
    context.objects.shared.lists.insert(compiling.name, Arc::new(list));
    Ok(())
}

pub(crate) fn gen_lists(context: &mut Context, range: GLsizei) -> Result<GLuint> {
    let range = not_negative(SECTION, "range", range.into())? as u64;
    if range == 0 {
        return Ok(0);
    }
    Ok(context.objects.shared.lists.take(range).unwrap_or(0))
}

pub(crate) fn delete_lists(context: &mut Context, list: GLuint, range: GLsizei) -> Result<()> {
    let range = not_negative(SECTION, "range", range.into())? as u64;
    context.objects.shared.lists.remove(list, range);
    Ok(())
}

pub(crate) fn is_list(context: &mut Context, list: GLuint) -> Result<bool> {
    Ok(context.objects.shared.lists.contains(list))
}

pub(crate) fn list_base(context: &mut Context, base: GLuint) -> Result<()> {
    context.lists.set_base(base);
    Ok(())
}

pub(crate) fn call_list(context: &mut Context, list: GLuint) -> Result<()> {
    // Of the names that glCallLists is given some may be none: letters that a font leaves out.
    if list != 0 && !context.objects.shared.lists.contains(list) {
        not_there(context, list);
    }
    let is_outermost = begin_outermost(context, 1);
    let charge = if is_outermost { Charge::Free } else { Charge::Cost };
    run_list(context, list, charge)?;
    if is_outermost {
        end_outermost(context);
    }
    Ok(())
}

/// Whether a list is charged to the budget of the outermost call.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Charge {
    /// The list that the outermost `glCallList` names.
    Free,
    /// Any other.
    Cost,
}

/// Gives an outermost call its budget; returns whether this is one.
fn begin_outermost(context: &mut Context, free_depth: usize) -> bool {
    let lists = &mut context.lists;
    if lists.depth == 0 {
        lists.budget = Some(BUDGET);
        lists.free_depth = free_depth;
    }
    lists.depth == 0
}

/// Says if the lists of an outermost call have spent its budget.
fn end_outermost(context: &mut Context) {
    if context.lists.budget.is_none() {
        context.debug.warn(format!(
            "glCallList: the outermost call has called lists of {BUDGET} commands, or draws, copies and uploads that \
             take as long: the rest is left out; do the lists call each other?"
        ));
    }
}

/// Submits what nested lists have drawn where it may cover very many pixels, so that it is charged before more is drawn.
fn submit_many(context: &mut Context, shapes: u64) {
    const PIXELS: u64 = 1 << 31;
    let lists = &mut context.lists;
    lists.waiting_shapes = lists.waiting_shapes.saturating_add(shapes);
    let Some(pass) = &context.recorder.pass else { return };
    let area = u64::from(pass.width) * u64::from(pass.height);
    if lists.waiting_shapes.saturating_mul(area) >= PIXELS && context.immediate.is_none() {
        lists.waiting_shapes = 0;
        submit(context);
    }
}

#[cold]
#[inline(never)]
fn not_there(context: &mut Context, list: GLuint) {
    if context.is_first_warning(DrawWarning::NoList, list) {
        context.debug.warn(format!(
            "glCallList: list {list} does not exist, so nothing is called: see glNewList ({SECTION})"
        ));
    }
}

/// Carries out a list, if there is one.
fn run_list(context: &mut Context, list: GLuint, charge: Charge) -> Result<()> {
    context.state_changes.count_call();
    let found = context
        .objects
        .shared
        .lists
        .get(list)
        .cloned()
        .and_then(|found| found.downcast::<List>().ok());
    let Some(found) = found else { return Ok(()) };
    let lists = &mut context.lists;
    if lists.depth >= MAX_LIST_NESTING {
        return Ok(());
    }
    if charge == Charge::Cost
        && let Some(left) = lists.budget
    {
        lists.budget = left.checked_sub(found.cost);
    }
    if lists.budget.is_none() {
        return Ok(());
    }
    lists.depth += 1;
    // A list that is carried out while another is compiled is not recorded.
    let compiling = context.compiling.take();
    for step in &found.steps {
        context.run_step(step);
        if context.lists.is_charged() {
            submit_many(context, step.shapes());
        }
        if context.lists.budget.is_none() {
            break;
        }
    }
    context.compiling = compiling;
    context.lists.depth -= 1;
    Ok(())
}

pub(crate) fn call_lists(
    context: &mut Context,
    n: GLsizei,
    ty: GLenum,
    lists: Data<'_>,
) -> Result<()> {
    let n = not_negative(SECTION, "n", n.into())?;
    let ty = NAME_TYPE.decode("type", ty)?;
    let size = ty.size();
    let needed = n.saturating_mul(size);
    let bytes = match lists.locate(0, needed) {
        Located::Bytes(bytes) => bytes,
        Located::Null | Located::Offset(_) => &[],
    };
    let Some(bytes) = bytes.get(..needed) else {
        return invalid_operation(
            SECTION,
            format!("n = {n} names of {size} bytes each, but lists has {} bytes", bytes.len()),
        );
    };
    let is_outermost = begin_outermost(context, 0);
    for name in bytes.chunks_exact(size) {
        let name = context.lists.base.wrapping_add(ty.read(name));
        run_list(context, name, Charge::Cost)?;
    }
    if is_outermost {
        end_outermost(context);
    }
    Ok(())
}
