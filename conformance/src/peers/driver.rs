//! The drivers of the machine, and the processes that run them.

use super::error::PeersError;
use super::options::Options;
use super::process::{self, Measurement};
use super::scene::Scene;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A driver of the machine.
#[derive(Clone, Debug, Serialize)]
pub struct Driver {
    /// The name in tables.
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

/// The file name of the system's libEGL.
const SYSTEM: &str = "libEGL.so.1";

/// Environment variables that select the system's drivers, without a window system and without a shader cache on disk.
const CHOICES: [(&str, &[(&str, &str)]); 3] = [
    ("llvmpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "llvmpipe")]),
    ("softpipe", &[("LIBGL_ALWAYS_SOFTWARE", "1"), ("GALLIUM_DRIVER", "softpipe")]),
    ("hardware", &[]),
];

/// Environment variables of every process.
const ALWAYS: [(&str, &str); 2] =
    [("EGL_PLATFORM", "surfaceless"), ("MESA_SHADER_CACHE_DISABLE", "true")];

/// The path of DetGL's library: that of the options, or the one that cargo built beside this program.
fn detgl(options: &Options) -> Result<PathBuf, PeersError> {
    if let Some(path) = &options.lib {
        return Ok(path.clone());
    }
    const BUILT: &str = "libdetgl.so";
    let program = std::env::current_exe().map_err(PeersError::Process)?;
    let folder = program.parent().unwrap_or(Path::new("."));
    // The library that is built with this program is in deps/; the folder above may have an older one.
    [folder.join("deps").join(BUILT), folder.join(BUILT)]
        .into_iter()
        .find(|path| path.is_file())
        .ok_or_else(|| PeersError::NoLibrary(folder.to_owned()))
}

/// DetGL, then the other drivers of the machine.
///
/// # Errors
/// When DetGL's library is not there or does not answer.
pub fn find(options: &Options) -> Result<Vec<Driver>, PeersError> {
    let ours = Driver::new("DetGL", detgl(options)?, &[]).probed()?;
    let mut drivers = vec![ours];
    for (name, environment) in CHOICES {
        let Ok(driver) = Driver::new(name, SYSTEM.into(), environment).probed() else { continue };
        // Without hardware, Mesa selects one of the drivers that are in the list already.
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
        let answer = process::run_and_read(&mut self.command(&["--probe"]))?;
        let strings: process::Strings = serde_json::from_slice(&answer)?;
        (self.renderer, self.version) = (strings.renderer, strings.version);
        Ok(self)
    }

    /// Measures a scene in a new process.
    ///
    /// # Errors
    /// When the process fails.
    pub fn measure(&self, scene: &Scene, size: usize) -> Result<Measurement, PeersError> {
        let size = size.to_string();
        let answer = process::run_and_read(&mut self.command(&[
            "--scene",
            scene.name,
            "--size",
            size.as_str(),
        ]))?;
        Measurement::from_bytes(&answer)
    }

    /// The command that runs this program as the driver's client.
    fn command(&self, arguments: &[&str]) -> Command {
        let program = std::env::current_exe().unwrap_or_else(|_| "conformance".into());
        let mut command = Command::new(program);
        command.arg("peer").arg("--lib").arg(&self.library).args(arguments);
        command.envs(ALWAYS).envs(self.environment.iter().copied());
        command
    }
}
