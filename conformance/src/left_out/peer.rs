//! What features cost in another library, in processes that are started for it.

use super::feature::Feature;
use super::scene::SIDE;
use crate::gl::library::Library;
use crate::gl::{glFinish, glGetError};
use cpu_time::ProcessTime;
use gl_api::constants::GL_NO_ERROR;
use gl_api::context::ContextDesc;
use std::time::{Duration, Instant};

/// One of the two scenes of a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum FeatureScene {
    /// Without the feature.
    Plain,
    /// With it.
    Asked,
}

/// How long frames are drawn before one is timed, for shaders to be compiled, and how long they are timed.
const PERIODS: [Duration; 2] = [Duration::from_millis(40), Duration::from_millis(60)];

/// The least time of the processor that a frame takes in the library that was chosen for this process, in milliseconds.
/// A process times one scene: of two contexts of llvmpipe, the second takes up to 1.45 of the time of the first for the
/// same frame.
///
/// # Errors
/// When there is no context, or a call sets the error flag.
pub fn frame_ms(
    library: &'static Library,
    feature: &Feature,
    scene: FeatureScene,
) -> Result<f64, String> {
    let side = SIDE as u32;
    let desc = ContextDesc { width: side, height: side, ..ContextDesc::default() };
    let _context = library.context(&desc).map_err(|error| error.to_string())?;
    let (setup, frame) = match scene {
        FeatureScene::Plain => (feature.plain, feature.plain_frame),
        FeatureScene::Asked => (feature.asked, feature.asked_frame),
    };
    setup();
    let mut least = f64::INFINITY;
    for period in PERIODS {
        least = f64::INFINITY;
        let end = Instant::now() + period;
        while Instant::now() < end || least.is_infinite() {
            let start = ProcessTime::now();
            frame();
            glFinish();
            least = least.min(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    match glGetError() {
        GL_NO_ERROR => Ok(least),
        code => Err(format!("error {code:#06x}")),
    }
}
