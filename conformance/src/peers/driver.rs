//! The drivers of the machine, and the processes they run in.

use super::child::{self, Measured};
use super::scene::Scene;
use super::{Options, PeersError};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A driver that answered.
#[derive(Clone, Debug, Serialize)]
pub struct Driver {
    /// For tables.
    pub name: &'static str,
    /// `GL_RENDERER`.
    pub renderer: String,
    /// `GL_VERSION`.
    pub version: String,
    /// Its libEGL.
    #[serde(skip)]
    library: PathBuf,
    #[serde(skip)]
    environment: &'static [(&'static str, &'static str)],
}

/// What the system's libEGL is called.
const SYSTEM: &str = "libEGL.so.1";

/// How the system's drivers are chosen: all draw without a window system, and none may take a
/// shader from the disk that an earlier run compiled.
const CHOICES: [(&str, &[(&str, &str)]); 3] = [
    ("llvmpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "llvmpipe")]),
    ("softpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "softpipe")]),
    ("hardware", &[]),
];

/// For every process.
const ALWAYS: [(&str, &str); 2] =
    [("EGL_PLATFORM", "surfaceless"), ("MESA_SHADER_CACHE_DISABLE", "true")];

/// DetGL's library: what the options say, or what cargo built beside this program.
fn detgl(options: &Options) -> Result<PathBuf, PeersError> {
    if let Some(path) = &options.lib {
        return Ok(path.clone());
    }
    const BUILT: &str = "libdetgl.so";
    let program = std::env::current_exe().map_err(PeersError::Process)?;
    let folder = program.parent().unwrap_or(Path::new("."));
    // What is built along with this program is in deps/; a folder above may have an older one.
    [folder.join("deps").join(BUILT), folder.join(BUILT)]
        .into_iter()
        .find(|path| path.is_file())
        .ok_or_else(|| PeersError::NoLibrary(folder.to_owned()))
}

/// DetGL first, then whatever else the machine has.
///
/// # Errors
/// When DetGL's library is not there or does not answer.
pub fn find(options: &Options) -> Result<Vec<Driver>, PeersError> {
    let ours = Driver::new("DetGL", detgl(options)?, &[]).probed()?;
    let mut drivers = vec![ours];
    for (name, environment) in CHOICES {
        let Ok(driver) = Driver::new(name, SYSTEM.into(), environment).probed() else { continue };
        // Without hardware Mesa answers with one of those that are there already.
        if drivers.iter().all(|other| other.renderer != driver.renderer) {
            drivers.push(driver);
        }
    }
    Ok(drivers)
}

impl Driver {
    fn new(
        name: &'static str,
        library: PathBuf,
        environment: &'static [(&'static str, &'static str)],
    ) -> Self {
        Self { name, renderer: String::new(), version: String::new(), library, environment }
    }

    fn probed(mut self) -> Result<Self, PeersError> {
        let answer = child::ask(&mut self.command(&["--probe"]))?;
        let strings: child::Strings = serde_json::from_slice(&answer)?;
        (self.renderer, self.version) = (strings.renderer, strings.version);
        Ok(self)
    }

    /// Draws a scene in a process of its own.
    ///
    /// # Errors
    /// When the process fails.
    pub fn measure(&self, scene: &Scene, size: usize) -> Result<Measured, PeersError> {
        let size = size.to_string();
        let answer =
            child::ask(&mut self.command(&["--scene", scene.name, "--size", size.as_str()]))?;
        Measured::from_bytes(&answer)
    }

    /// This program once more, as the driver's client.
    fn command(&self, arguments: &[&str]) -> Command {
        let program = std::env::current_exe().unwrap_or_else(|_| "conformance".into());
        let mut command = Command::new(program);
        command.arg("peer").arg("--lib").arg(&self.library).args(arguments);
        command.envs(ALWAYS).envs(self.environment.iter().copied());
        command
    }
}
