//! The process that measures one scene with one driver, and its output.

use super::client::Client;
use super::error::PeersError;
use super::median::median;
use super::replay::Replayer;
use super::scene::scenes;
use gl_api::constants::*;
use serde::{Deserialize, Serialize};
use std::io::Write;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

/// What a child is to do.
#[derive(Clone, Debug, clap::Args)]
pub struct Task {
    /// The driver's libEGL.
    #[arg(long)]
    lib: PathBuf,
    /// Says what the driver calls itself.
    #[arg(long)]
    probe: bool,
    /// The scene to draw.
    #[arg(long, default_value = "clear")]
    scene: String,
    /// Pixels across and up.
    #[arg(long, default_value_t = 64)]
    size: usize,
}

/// The name strings of a driver.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Strings {
    /// `GL_RENDERER`.
    pub renderer: String,
    /// `GL_VERSION`.
    pub version: String,
}

/// The result of one process.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measurement {
    /// Milliseconds from opening the library to the first picture in memory.
    pub first_ms: f64,
    /// Milliseconds of a frame after the first ones: the median.
    pub frame_ms: f64,
    /// The number of frames that were timed.
    pub frames: usize,
    /// Processor milliseconds of a frame, of all threads together.
    pub processor_ms: f64,
    /// Peak memory of the process in KiB.
    pub peak_kib: u64,
    /// RGBA bytes, rows from the lowest.
    #[serde(skip)]
    pub picture: Vec<u8>,
}

/// Frames that are drawn before any is timed.
const WARM_UP: usize = 3;
/// The least number of timed frames.
const FRAMES: usize = 5;
/// The least time for which frames are timed.
const DURATION: Duration = Duration::from_millis(400);
/// The time after which no frame is begun: some drivers take seconds for a frame.
const PATIENCE: Duration = Duration::from_secs(3);

impl Task {
    /// Runs the measurement and writes the result to the standard output.
    ///
    /// # Errors
    /// When the driver refuses anything, or the output cannot be written.
    pub fn run(&self) -> Result<(), PeersError> {
        let bytes = if self.probe { self.strings()? } else { self.measure()?.to_bytes()? };
        std::io::stdout().write_all(&bytes).map_err(PeersError::Process)
    }

    fn strings(&self) -> Result<Vec<u8>, PeersError> {
        let client = Client::open(&self.lib, self.size)?;
        let [renderer, version] = [GL_RENDERER, GL_VERSION].map(|name| client.gl.string(name));
        Ok(serde_json::to_vec(&Strings { renderer, version })?)
    }

    fn measure(&self) -> Result<Measurement, PeersError> {
        let scene = scenes()
            .find(|scene| scene.name == self.scene)
            .ok_or_else(|| PeersError::NoScene(self.scene.clone()))?;
        // Building the scene, and making its picture's memory resident by writing to it, is not the driver's work and
        // is not timed.
        let recipe = (scene.recipe)(self.size);
        let picture = vec![u8::MAX; 4 * self.size * self.size];
        let start = Instant::now();
        let client = Client::open(&self.lib, self.size)?;
        let mut player = Replayer::new(&client.gl, &recipe, self.size, picture)?;
        player.frame();
        player.read();
        let first = start.elapsed();
        client.gl.check("the first frame")?;
        for _ in 0..WARM_UP {
            if start.elapsed() < PATIENCE {
                player.frame();
            }
        }
        let (start, processor) = (Instant::now(), processor_time());
        let mut times = Vec::new();
        while times.is_empty()
            || start.elapsed() < DURATION
            || times.len() < FRAMES && start.elapsed() < PATIENCE
        {
            let frame = Instant::now();
            player.frame();
            times.push(milliseconds(frame.elapsed()));
        }
        let processor = processor_time().saturating_sub(processor);
        Ok(Measurement {
            first_ms: milliseconds(first),
            frames: times.len(),
            processor_ms: milliseconds(processor) / times.len() as f64,
            frame_ms: median(times),
            peak_kib: peak_memory(),
            picture: player.picture()?,
        })
    }
}

impl Measurement {
    /// A line of JSON, then the picture.
    fn to_bytes(&self) -> Result<Vec<u8>, PeersError> {
        let mut bytes = serde_json::to_vec(self)?;
        bytes.push(b'\n');
        bytes.extend(&self.picture);
        Ok(bytes)
    }

    /// Parses the output of a measuring process.
    ///
    /// # Errors
    /// When it is not in that form.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, PeersError> {
        let end = bytes.iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len());
        let measured: Self = serde_json::from_slice(&bytes[..end])?;
        let picture = bytes.get(end + 1..).unwrap_or_default().to_vec();
        Ok(Self { picture, ..measured })
    }
}

/// The output of a measuring process.
///
/// # Errors
/// When it cannot be started, or fails.
pub fn run_and_read(command: &mut Command) -> Result<Vec<u8>, PeersError> {
    let output = command.output().map_err(PeersError::Process)?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    Err(PeersError::Child(format!("{} ({})", said, output.status)))
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// `VmHWM` of Linux; 0 elsewhere.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|rest| rest.split_whitespace().next()?.parse().ok()).unwrap_or(0)
}

/// User and system time of all threads, in Linux's hundredths of a second; 0 elsewhere.
fn processor_time() -> Duration {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The second field is a name in parentheses, which may have blanks in it.
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    let hundredths: u64 =
        fields.skip(11).take(2).filter_map(|field| field.parse::<u64>().ok()).sum();
    Duration::from_millis(hundredths * 10)
}
