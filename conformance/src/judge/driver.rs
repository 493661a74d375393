//! The libraries that are judged.

use super::process::{Answer, TIME_LIMIT};
use crate::check::Effort;
use crate::left_out::Timing;
use std::ffi::OsString;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use thiserror::Error;
use wait_timeout::ChildExt;

/// Why no library can be judged.
#[derive(Debug, Error)]
pub enum JudgeError {
    /// It does not answer.
    #[error("--driver {name}: {said}")]
    Silent {
        /// As it was given.
        name: String,
        /// What it says.
        said: String,
    },
}

/// A library that is judged.
#[derive(Clone, Debug)]
pub struct Driver {
    /// As it was given.
    pub name: String,
    /// `GL_RENDERER` and `GL_VERSION`.
    pub says: String,
    library: PathBuf,
    environment: &'static [(&'static str, &'static str)],
}

/// The file name of the system's libEGL.
const SYSTEM: &str = "libEGL.so.1";

/// Names that stand for the system's library with environment variables.
const NAMES: [(&str, &[(&str, &str)]); 3] = [
    ("system", &[]),
    ("llvmpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "llvmpipe")]),
    ("softpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "softpipe")]),
];

/// The environment in which llvmpipe draws on the thread that calls.
const LLVMPIPE_WITHOUT_THREADS: [(&str, &str); 1] = [("LP_NUM_THREADS", "0")];

impl Driver {
    /// `system`, `llvmpipe`, `softpipe`, or the path of a libEGL.
    ///
    /// # Errors
    /// When no context of it can be made.
    pub fn open(name: &str) -> Result<Self, JudgeError> {
        let known = NAMES.iter().find(|(known, _)| *known == name);
        let (library, environment) = match known {
            Some((_, environment)) => (PathBuf::from(SYSTEM), *environment),
            None => (PathBuf::from(name), &[] as &[_]),
        };
        let driver = Self { name: name.to_owned(), says: String::new(), library, environment };
        let said = driver.run(&[]);
        let silent = |said: String| JudgeError::Silent { name: name.to_owned(), said };
        let says = said.map_err(silent)?;
        Ok(Self { says: String::from_utf8_lossy(&says).trim().to_owned(), ..driver })
    }

    /// What it answers to a check.
    ///
    /// # Errors
    /// What happened instead.
    pub(super) fn ask(&self, check: &str, effort: Effort) -> Result<Answer, String> {
        let effort = match effort {
            Effort::Quick => "quick",
            Effort::Full => "full",
            Effort::Thorough => "thorough",
        };
        let bytes = self.run(&["--check", check, "--effort", effort])?;
        serde_json::from_slice(&bytes).map_err(|error| error.to_string())
    }

    /// The times of a feature of `left-out`, drawn by the thread that calls; each time is that of a new process, and
    /// there are `rounds` for each scene.
    ///
    /// # Errors
    /// What happened instead.
    pub fn time(&self, feature: &str, rounds: usize) -> Result<Timing, String> {
        let time = |scene: &str| -> Result<f64, String> {
            let arguments = ["--feature", feature, "--scene", scene];
            let bytes = self.run_with(&LLVMPIPE_WITHOUT_THREADS, &arguments)?;
            serde_json::from_slice(&bytes).map_err(|error| error.to_string())
        };
        Timing::of_processes(|| time("plain"), || time("asked"), rounds)
    }

    fn run(&self, arguments: &[&str]) -> Result<Vec<u8>, String> {
        self.run_with(&[], arguments)
    }

    fn run_with(
        &self,
        environment: &[(&str, &str)],
        arguments: &[&str],
    ) -> Result<Vec<u8>, String> {
        let program =
            std::env::current_exe().unwrap_or_else(|_| Path::new("conformance").to_owned());
        let mut command = Command::new(program);
        command.arg("judged").arg("--lib").arg(&self.library).args(arguments);
        command.env("MESA_SHADER_CACHE_DISABLE", "true").envs(self.environment.iter().copied());
        command.envs(environment.iter().copied());
        if std::env::var_os("EGL_PLATFORM").is_none() {
            command.env("EGL_PLATFORM", OsString::from("surfaceless"));
        }
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| error.to_string())?;
        let waited = child.wait_timeout(TIME_LIMIT).map_err(|error| error.to_string())?;
        let Some(status) = waited else {
            child.kill().and_then(|()| child.wait()).map_err(|error| error.to_string())?;
            return Err(format!("no answer in {} s", TIME_LIMIT.as_secs()));
        };
        let read = |from: Option<&mut dyn Read>| {
            let mut bytes = Vec::new();
            from.map_or(Ok(0), |from| from.read_to_end(&mut bytes)).map(|_| bytes)
        };
        let out = read(child.stdout.as_mut().map(|out| out as &mut dyn Read));
        let said = read(child.stderr.as_mut().map(|out| out as &mut dyn Read));
        if status.success() {
            return out.map_err(|error| error.to_string());
        }
        let said = said.unwrap_or_default();
        let said = String::from_utf8_lossy(&said);
        let last = said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
        Err(format!("it ends: {status} {last}").trim_end().to_owned())
    }
}
