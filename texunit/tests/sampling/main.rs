//! What a sample returns: against the formulas, over instruction sets, at the extremes.

mod access;
mod against_oracle;
mod anisotropy;
mod completeness;
mod extremes;
mod instruction_sets;
mod oracle;
mod oracle_cube;
mod oracle_gather;
mod oracle_scan;
mod plans;
mod scene;
mod traces;
