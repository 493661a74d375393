//! Locked arrays: `EXT_compiled_vertex_array`.
//!
//! A client promises not to change some vertices until it unlocks them, so that a driver may keep what
//! it computed of them. A draw computes them anew here, which nobody can tell from outside.

use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::context::Context;
use crate::state::locked_arrays::LockedArrays;

const SECTION: &str = "EXT_compiled_vertex_array";

pub(crate) fn lock_arrays(context: &mut Context, first: GLint, count: GLsizei) -> Result<()> {
    if first < 0 || count <= 0 {
        let rule = format!("first = {first} must be 0 or more, count = {count} 1 or more");
        return invalid_value(SECTION, rule);
    }
    if context.state.locked != LockedArrays::default() {
        return invalid_operation(SECTION, "arrays are locked already: call glUnlockArraysEXT");
    }
    context.state.locked = LockedArrays { first, count };
    Ok(())
}

pub(crate) fn unlock_arrays(context: &mut Context) -> Result<()> {
    if context.state.locked == LockedArrays::default() {
        return invalid_operation(SECTION, "no arrays are locked: call glLockArraysEXT first");
    }
    context.state.locked = LockedArrays::default();
    Ok(())
}
