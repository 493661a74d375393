//! # conformance: every formula of the texture pipeline, checked
//!
//! Each formula stands here a second time, in `f64`, written from the specification, and DetGL is
//! held against it. The modules in the order in which a number passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`oracle`] | the formulas, one file a chapter; the only truth, and none of the driver's code |
//! | [`mutation`] | the list of mistakes that can be built into them, to prove that a check can fail |
//! | [`drive`] | the other side: GL contexts, draws of many cases at once, exact read-back |
//! | [`check`] | what is compared with what: cases, tolerance and its reason |
//! | [`report`] | the table and the JSON |
//! | [`rng`] | the numbers that cases are made of |
//!
//! **Invariant: the oracles are independent.** Nothing here calls `texunit` or `rasterizer`; the
//! driver is reached through GL's own functions only.

pub mod check;
pub mod drive;
pub mod mutation;
pub mod oracle;
pub mod report;
pub mod rng;
