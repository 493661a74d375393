//! The process that asks one library for one check, or for the time of one scene.

use super::driver::JudgeError;
use crate::chapters::checks;
use crate::check::{Effort, Harness, Subject, Verdict};
use crate::gl::{self, glGetString, library};
use crate::left_out::{self, FeatureScene};
use crate::mutation::Variant;
use gl_api::constants::{GL_RENDERER, GL_VERSION};
use gl_api::context::ContextDesc;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::Duration;

/// How long a check may take.
pub(super) const TIME_LIMIT: Duration = Duration::from_secs(120);

/// What a child is to do.
#[derive(Clone, Debug, clap::Args)]
pub struct Task {
    /// The library's libEGL.
    #[arg(long)]
    lib: PathBuf,
    /// The check; without one, what the library calls itself.
    #[arg(long)]
    check: Option<String>,
    /// A feature of `left-out`, in place of a check.
    #[arg(long, conflicts_with = "check")]
    feature: Option<String>,
    /// Which of the feature's scenes.
    #[arg(long, value_enum, default_value = "plain")]
    scene: FeatureScene,
    /// How many cases.
    #[arg(long, default_value = "full", value_parser = ["quick", "full", "thorough"])]
    effort: String,
}

/// What a library answers to a check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The largest error; `None` where it is infinite.
    pub largest_error: Option<f64>,
    /// Whether it passes.
    pub verdict: Verdict,
    /// The case with the largest error.
    pub worst: String,
}

impl Task {
    /// Asks, and prints the answer.
    ///
    /// # Errors
    /// When the library cannot be opened.
    pub fn run(&self) -> Result<(), JudgeError> {
        let silent =
            |said: String| JudgeError::Silent { name: self.lib.display().to_string(), said };
        let opened =
            library::Library::open(&self.lib).map_err(|error| silent(error.to_string()))?;
        library::choose(Some(opened));
        if let Some(name) = &self.feature {
            let feature = left_out::features().find(|feature| feature.name == name);
            let feature = feature.ok_or_else(|| silent(format!("there is no feature {name:?}")))?;
            let time = left_out::frame_ms(opened, feature, self.scene).map_err(silent)?;
            return print_json(&time).map_err(silent);
        }
        let Some(name) = &self.check else {
            let _current = gl::open(ContextDesc::default()).map_err(silent)?;
            println!("{}, {}", glGetString(GL_RENDERER), glGetString(GL_VERSION));
            return Ok(());
        };
        let check = checks().find(|check| check.name == name);
        let check = check.ok_or_else(|| silent(format!("there is no check {name:?}")))?;
        let effort = match self.effort.as_str() {
            "quick" => Effort::Quick,
            "thorough" => Effort::Thorough,
            _ => Effort::Full,
        };
        let harness = Harness { subject: Subject::Driver, effort, variant: Variant::CORRECT };
        let outcome = check.run(&harness);
        let answer = Answer {
            largest_error: outcome.largest_error.is_finite().then_some(outcome.largest_error),
            verdict: outcome.verdict,
            worst: outcome.worst,
        };
        print_json(&answer).map_err(silent)
    }
}

fn print_json(answer: &impl Serialize) -> Result<(), String> {
    println!("{}", serde_json::to_string(answer).map_err(|error| error.to_string())?);
    Ok(())
}
