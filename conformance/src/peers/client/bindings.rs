//! GL 2.1 as the Khronos registry declares it: `Gl`, a function pointer for each command.

#![allow(
    clippy::all,
    missing_docs,
    non_snake_case,
    non_upper_case_globals,
    unsafe_op_in_unsafe_fn,
    unused_imports,
    unused_qualifications,
    dead_code,
    clippy::undocumented_unsafe_blocks,
    reason = "generated"
)]

include!(concat!(env!("OUT_DIR"), "/gl.rs"));
