//! What a sample returns: against the formulas, over instruction sets, at the extremes.

mod against_oracle;
mod completeness;
mod extremes;
mod instruction_sets;
mod oracle;
mod plans;
mod scene;
