//! # conformance: every formula of the texture pipeline, checked
//!
//! Each formula is implemented here a second time, in `f64`, from the text of the specification, and
//! DetGL's results are compared with it. The layers, from below:
//!
//! | module | is |
//! |---|---|
//! | [`rng`] | random numbers for cases, the same in every run |
//! | [`plot`] | plots as SVG |
//! | [`gl`] | GL's functions: DetGL's, or another library's |
//! | [`mutation`] | known mistakes that can be built into a formula, to prove that its check can fail |
//! | [`oracle`] | the formulas, one file a chapter; no code of the driver |
//! | [`probe`] | GL contexts, and draws that compute many values at once and read them back exactly |
//! | [`check`] | what a check is: cases, tolerance and its reason, harness, outcome |
//! | [`chapters`] | the checks, one file a chapter |
//! | [`self_test`] | every mistake, built into its formula, must make its check fail |
//! | [`sweep`] | extreme cases: the error over the whole range of a parameter |
//! | [`mod@reference`] | slow reference samplers: exact area integral, supersampling, ꟻLIP |
//! | [`tradeoff`] | error and run time of each way to sample a texture |
//! | [`left_out`] | what scenes ask for without effect: plans, pictures and cost |
//! | [`filter_pictures`] | pictures by driver and formula, one for each minification filter |
//! | [`report`] | tables, JSON and pages |
//! | [`judge`] | the checks through the C functions of other libraries |
//! | [`peers`] | the same scenes on DetGL's shared library and on the machine's other GL drivers |
//!
//! **Invariant: the oracles are independent.** Nothing here calls `texunit` or `rasterizer`; the
//! driver is reached through GL's own functions only ([`gl`]). But [`left_out`] takes plans from a `rasterizer::driver::Device`.

pub mod chapters;
pub mod check;
pub mod filter_pictures;
pub mod gl;
pub mod judge;
pub mod left_out;
pub mod mutation;
pub mod oracle;
pub mod peers;
pub mod plot;
pub mod probe;
pub mod reference;
pub mod report;
pub mod rng;
pub mod self_test;
pub mod sweep;
pub mod tradeoff;
