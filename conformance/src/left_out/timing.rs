//! The times of two frames, taken in turns.

use serde::{Deserialize, Serialize};

/// What a frame costs with a feature and without.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// Median time of a frame without it, in milliseconds.
    pub plain_ms: f64,
    /// Median over the rounds of the ratio of the times with and without it.
    pub ratio: f64,
    /// Half the distance of the quartiles of the ratios.
    pub noise: f64,
}

/// The shortest time that is measured, in seconds.
const SHORTEST: f64 = 2e-3;

impl Timing {
    /// Measures so many rounds; each function gives the seconds of one frame, of so many that it draws. Without rounds
    /// all is NaN.
    pub(super) fn of<E>(
        mut plain: impl FnMut(u32) -> Result<f64, E>,
        mut asked: impl FnMut(u32) -> Result<f64, E>,
        rounds: usize,
    ) -> Result<Self, E> {
        let frames = (SHORTEST / plain(2)?.max(1e-5)).ceil().clamp(1.0, 50.0) as u32;
        let (mut ratios, mut times) = (Vec::new(), Vec::new());
        for round in 0..rounds {
            // The first of two is not always the same one.
            let [without, with] = match round % 2 {
                0 => {
                    let without = plain(frames)?;
                    [without, asked(frames)?]
                }
                _ => {
                    let with = asked(frames)?;
                    [plain(frames)?, with]
                }
            };
            ratios.push(with / without);
            times.push(without * 1e3);
        }
        Ok(Self::of_rounds(ratios, times))
    }

    /// Measures so many rounds; each function gives the milliseconds of a frame.
    pub(crate) fn of_processes<E>(
        plain: impl Fn() -> Result<f64, E>,
        asked: impl Fn() -> Result<f64, E>,
        rounds: usize,
    ) -> Result<Self, E> {
        let (mut ratios, mut times) = (Vec::new(), Vec::new());
        for _ in 0..rounds {
            let without = plain()?;
            ratios.push(asked()? / without);
            times.push(without);
        }
        Ok(Self::of_rounds(ratios, times))
    }

    fn of_rounds(mut ratios: Vec<f64>, mut times: Vec<f64>) -> Self {
        ratios.sort_by(f64::total_cmp);
        times.sort_by(f64::total_cmp);
        Self {
            plain_ms: quantile(&times, 0.5),
            ratio: quantile(&ratios, 0.5),
            noise: (quantile(&ratios, 0.75) - quantile(&ratios, 0.25)) / 2.0,
        }
    }
}

/// The quantile of sorted numbers.
fn quantile(sorted: &[f64], at: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((at * last as f64).round() as usize).copied().unwrap_or(f64::NAN)
}
