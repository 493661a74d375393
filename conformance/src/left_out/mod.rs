//! What a scene asks for without effect, and what it costs: each feature's frame beside the same frame without it.
//!
//! A feature is judged twice. Its *plan* (what `DETGL_EXPLAIN` prints) says, without a clock, whether the same work is
//! done as without the feature; and both frames are timed in turns. Both pictures have to be equal to the bit. Other
//! libraries are asked for their times, in processes of their own.

mod feature;
mod features;
mod measure;
mod peer;
mod plan;
mod scene;
mod small_draws;
mod timing;

pub use feature::{Feature, Reason, Rule};
pub use features::features;
pub use measure::{Row, measure, pictures};
pub use peer::{FeatureScene, frame_ms};
pub use plan::PlanFound;
pub use rasterizer::driver::LeaveOut;
pub use timing::Timing;
