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
//! | [`comparison`] | whole pictures of driver and formula side by side |
//! | [`selftest`] | each mistake built in, one at a time |
//! | [`reference`] | slow reference samplers: the exact area integral, supersampling, ꟻLIP |
//! | [`tradeoff`] | error against run time |
//! | [`sweep`] | stiff and extreme cases, each a sweep over a parameter |
//! | [`peers`] | the same scenes on DetGL's shared library and on the machine's other GL drivers |
//! | [`plot`], [`report`] | tables, JSON, plots and pages |
//! | [`rng`] | the numbers that cases are made of |
//!
//! **Invariant: the oracles are independent.** Nothing here calls `texunit` or `rasterizer`; the
//! driver is reached through GL's own functions only.

pub mod check;
pub mod comparison;
pub mod drive;
pub mod mutation;
pub mod oracle;
pub mod peers;
pub mod plot;
pub mod reference;
pub mod report;
pub mod rng;
pub mod selftest;
pub mod sweep;
pub mod tradeoff;
