//! Depth buffers: the precision of stored depths.

use super::definition::{Sweep, decades};
use crate::plot::Line;
use crate::probe::{DepthBuffer, ProbeError, Session};

/// Near and far planes.
pub const PRECISION: Sweep = Sweep {
    name: "depth-precision",
    what: "window depth kept of planes between the near and the far plane, in 16 and 24 bits and \
           floats",
    parameter: "far over near",
    unit: "steps of the buffer",
    bound: 1.0,
    why: "half a step of rounding, and the f32 clip coordinates of the plane",
    before: &[],
    run: precision,
};

fn precision() -> Result<Vec<Line>, ProbeError> {
    let mut lines = Vec::new();
    let buffers = [
        (DepthBuffer::Bits16, 65535.0),
        (DepthBuffer::Bits24, 16_777_215.0),
        // A float's step below 1 is 2^-24.
        (DepthBuffer::Float, 16_777_216.0),
    ];
    for (buffer, steps) in buffers {
        let session = Session::open()?;
        session.depth_buffer(buffer)?;
        lines.push(decades(buffer.name(), 1..=12, |ratio| {
            let (near, far) = (1e-3, 1e-3 * ratio);
            let mut largest: f64 = 0.0;
            for k in 1..32 {
                // Places between the planes, evenly by their logarithm.
                let z = near * ratio.powf(f64::from(k) / 32.0);
                let clip_z = (far + near) / (far - near) * z - 2.0 * far * near / (far - near);
                let (clip_z, w) = (clip_z as f32, z as f32);
                let exact = f64::from(clip_z) / f64::from(w) * 0.5 + 0.5;
                let kept = session.kept_depth(clip_z, w)?;
                largest = largest.max((kept - exact).abs() * steps);
            }
            Ok(largest)
        })?);
    }
    Ok(lines)
}
