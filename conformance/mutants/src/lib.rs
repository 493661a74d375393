//! # mutants: mistakes in the driver, and whether conformance notices them
//!
//! A copy of the workspace receives many small mistakes at once, each behind a number that the environment variable
//! `DETGL_MUTANT` chooses when a process begins; so one build holds all of them. The steps, in order:
//!
//! | module | is |
//! |---|---|
//! | [`replacements`] | finds the expressions of a file that a mistake fits, and what each becomes |
//! | [`choice`] | a random choice of them, the same for the same seed |
//! | [`rewrite`] | the file's text with the chosen mistakes, and which bytes of it belong to which |
//! | [`tree`] | the copy of the workspace |
//! | [`build`] | builds it; a mistake that does not compile is taken out again |
//! | [`trial`] | runs the checks that reach a mistake, until one fails |
//! | [`report`] | tables |
//!
//! Nothing of it is in the libraries: the switch that the copy calls stands in `templates`.

pub mod build;
pub mod choice;
pub mod error;
pub mod replacements;
pub mod report;
pub mod rewrite;
pub mod tree;
pub mod trial;
