//! The built-in functions and variables of the language (GLSL 1.30 chapters 7 and 8).
//!
//! [`table`] is the data: a row for each variable and for each signature pattern of a function, with
//! the versions, profiles, extensions and stages that have it, and what it is lowered to. The
//! checker looks names up in it, the lowering reads its last column, and a test compiles every row
//! in the least version that has it. [`expand`] are the functions that are more than one operation.

pub mod expand;
pub mod function;
mod table;
pub mod texture_lookup;
pub mod variable;
