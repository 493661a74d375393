//! Pictures that are drawn again and again, each in a context of its own, and what that takes.

use crate::probe::{OwnContext, ProbeError};
use cpu_time::ThreadTime;
use gl_api::constants::*;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::sync::Arc;
use std::time::Instant;

/// Rounds in which each stage draws in turn.
const ROUNDS: usize = 9;

/// Seconds that a stage draws in a round, if its picture takes less.
const PATIENCE: f64 = 1.5e-3;

/// The work of a stage, in errors.
const AFTER: &str = "drawing a scene";

/// What a stage does.
pub struct Frame {
    /// What is timed.
    pub timed: Box<dyn Fn()>,
    /// What is drawn for the picture after what is timed, if that draws none.
    pub drawn: Option<Box<dyn Fn()>>,
}

impl Frame {
    /// What is timed draws the picture.
    pub fn new(timed: impl Fn() + 'static) -> Self {
        Self { timed: Box::new(timed), drawn: None }
    }

    /// What is timed makes what is needed for the picture.
    pub fn made_by(timed: impl Fn() + 'static, drawn: impl Fn() + 'static) -> Self {
        Self { timed: Box::new(timed), drawn: Some(Box::new(drawn)) }
    }
}

/// The clock of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Time of the processor for this thread: what else runs on the machine does not count. The device has one thread.
    Processor,
    /// Time that passes.
    Wall,
}

/// A context that draws a picture.
pub struct Stage {
    context: OwnContext,
    frame: Frame,
    clock: Clock,
    side: usize,
}

/// The times of a stage in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The fastest round.
    pub fastest: f64,
    /// First quartile, median, third quartile of the rounds.
    pub quartiles: [f64; 3],
}

/// A device of one thread.
///
/// # Errors
/// When it cannot be made.
pub fn one_thread() -> Result<Arc<Device>, ProbeError> {
    device(|desc| DeviceDesc { threads: 1, ..desc })
}

/// The device of the environment, changed.
///
/// # Errors
/// When it cannot be made.
pub fn device(change: impl FnOnce(DeviceDesc) -> DeviceDesc) -> Result<Arc<Device>, ProbeError> {
    let device = DeviceDesc::from_env().map(change).and_then(Device::new);
    device.map(Arc::new).map_err(|error| ProbeError::Context(error.to_string()))
}

impl Stage {
    /// A picture of `side` × `side` pixels; `setup` is called once in its context.
    ///
    /// # Errors
    /// When there is no context, or a call of `setup` sets the error flag.
    pub fn new(
        device: &Arc<Device>,
        clock: Clock,
        side: usize,
        setup: impl FnOnce() -> Frame,
    ) -> Result<Self, ProbeError> {
        let mut context = OwnContext::new(device, side)?;
        let frame = context.run(AFTER, || {
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glPixelStorei(GL_PACK_ALIGNMENT, 1);
            setup()
        })?;
        Ok(Self { context, frame, clock, side })
    }

    /// Seconds of what is timed, done so often.
    fn seconds(&mut self, count: usize) -> Result<f64, ProbeError> {
        let (frame, clock) = (&self.frame, self.clock);
        self.context.run(AFTER, || {
            let (wall, processor) = (Instant::now(), ThreadTime::now());
            for _ in 0..count {
                (frame.timed)();
                glFinish();
            }
            let seconds = match clock {
                Clock::Processor => processor.elapsed().as_secs_f64(),
                Clock::Wall => wall.elapsed().as_secs_f64(),
            };
            seconds / count as f64
        })
    }

    /// The picture: the mean of `samples`² pixels each.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn picture(&mut self, samples: usize) -> Result<Vec<[f64; 4]>, ProbeError> {
        let (large, frame) = (self.side, &self.frame);
        let bytes = self.context.picture(AFTER, || {
            (frame.timed)();
            if let Some(drawn) = &frame.drawn {
                drawn();
            }
        })?;
        Ok(resolve(&bytes, large / samples, samples))
    }
}

/// The times of stages that draw in turn, so that what slows the machine for a while slows all of them.
///
/// # Errors
/// When a call sets the error flag.
pub fn interleaved(stages: &mut [&mut Stage]) -> Result<Vec<Times>, ProbeError> {
    // The first frame of a scene, and one for which shaders may have been compiled again.
    let mut counts = Vec::with_capacity(stages.len());
    for stage in stages.iter_mut() {
        stage.seconds(2)?;
        counts.push((PATIENCE / stage.seconds(1)?.max(1e-6)).ceil().clamp(1.0, 64.0) as usize);
    }
    let mut rounds = vec![Vec::with_capacity(ROUNDS); stages.len()];
    for _ in 0..ROUNDS {
        for ((stage, count), rounds) in stages.iter_mut().zip(&counts).zip(&mut rounds) {
            rounds.push(stage.seconds(*count)?);
        }
    }
    Ok(rounds.into_iter().map(Times::of).collect())
}

impl Times {
    fn of(mut rounds: Vec<f64>) -> Self {
        rounds.sort_by(f64::total_cmp);
        let quartile = |part: usize| rounds[(rounds.len() - 1) * part / 4];
        Self { fastest: rounds[0], quartiles: [quartile(1), quartile(2), quartile(3)] }
    }
}

/// The mean of `samples`² pixels each.
fn resolve(bytes: &[u8], side: usize, samples: usize) -> Vec<[f64; 4]> {
    let large = side * samples;
    let mut pixels = vec![[0.0; 4]; side * side];
    for (p, texel) in bytes.chunks_exact(4).enumerate() {
        let (x, y) = (p % large / samples, p / large / samples);
        for (sum, &c) in pixels[y * side + x].iter_mut().zip(texel) {
            *sum += f64::from(c) / (255.0 * (samples * samples) as f64);
        }
    }
    pixels
}

/// Links and uses a program.
pub fn use_program(vertex: Option<&str>, fragment: &str) -> u32 {
    let program = glCreateProgram();
    let sources = [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, Some(fragment))];
    for (stage, source) in sources {
        let Some(source) = source else { continue };
        let shader = glCreateShader(stage);
        glShaderSource(shader, 1, source, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    program
}

/// Draws a square over the picture, whose texture coordinates are its places from -1 to 1.
pub fn square() {
    glBegin(GL_QUADS);
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0f32]] {
        glTexCoord2f(x, y);
        glVertex2f(x, y);
    }
    glEnd();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_rounds() {
        let times = Times::of(vec![5.0, 1.0, 3.0, 2.0, 4.0]);
        assert_eq!((times.fastest, times.quartiles), (1.0, [2.0, 3.0, 4.0]));
    }

    #[test]
    fn pixels_are_means_of_their_samples() {
        let bytes = [0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255];
        assert_eq!(resolve(&bytes, 1, 2), [[0.25, 0.25, 0.25, 1.0]]);
    }
}
