//! Depths beyond the near and the far plane, clamped.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::{Dialect, ProbeError, Stages};
use gl_api::constants::*;

/// Depth clamp.
pub const CLAMP: Check = Check {
    name: "depth-clamp",
    citation: "GL 3.2, 2.19 and 4.1.5: GL_DEPTH_CLAMP",
    what: "the depth of each pixel of planes from far before the near plane to far behind the far one, \
           with depth ranges of either direction",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 22) as f64,
    why: "f32: window depths up to 4 in magnitude are rounded by 2^-23 where they are clamped to, and \
          by as much where they are interpolated",
    run,
};

const SIZE: [usize; 2] = [64, 16];
const CLEARED: f64 = 0.625;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let cases: Vec<[usize; 2]> =
        (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y])).collect();
    let mut beyond = 0;
    for range in [[0.0, 1.0], [0.25, 0.75], [1.0, 0.0], [0.875, 0.5]] {
        // z at the left, and its slopes along x and y, of normalized device coordinates.
        for [left, by_x, by_y] in [[-3.1, 6.3, 0.0], [1.9, -3.7, 0.3], [-1.3, 0.1, 2.9]] {
            let z = |[x, y]: [f64; 2]| left + by_x * x + by_y * y;
            let at = |[x, y]: [usize; 2]| {
                z([(x as f64 + 0.5) / SIZE[0] as f64, (y as f64 + 0.5) / SIZE[1] as f64])
            };
            beyond += cases.iter().filter(|pixel| at(**pixel).abs() > 1.0).count();
            let expect = |&pixel: &[usize; 2], variant: Variant| {
                let z = at(pixel);
                if z.abs() > 1.0 && variant.has(Mutation::DepthClampIgnored) {
                    return [CLEARED, 0.0, 0.0, 0.0];
                }
                let [near, far]: [f64; 2] =
                    if variant.has(Mutation::DepthRangeIgnored) { [0.0, 1.0] } else { range };
                let window = (far - near) / 2.0 * z + (near + far) / 2.0;
                let [low, high] = if variant.has(Mutation::DepthClampedToOne) {
                    [0.0, 1.0]
                } else {
                    [near.min(far), near.max(far)]
                };
                [window.clamp(low, high), 0.0, 0.0, 0.0]
            };
            let scene = (range, left, by_x, by_y);
            harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
                session.frame(GL_RGBA8, SIZE, 0)?;
                let mut depth = 0u32;
                glGenRenderbuffers(1, &mut depth);
                glBindRenderbuffer(GL_RENDERBUFFER, depth);
                let format = GL_DEPTH_COMPONENT32F;
                glRenderbufferStorage(GL_RENDERBUFFER, format, SIZE[0], SIZE[1]);
                let point = GL_DEPTH_ATTACHMENT;
                glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, depth);
                session.stages(&Stages {
                    vertex: "layout(location = 0) in vec3 at;
                        void main() { gl_Position = vec4(at.xy * 2.0 - 1.0, at.z, 1.0); }",
                    geometry: "",
                    fragment: "out vec4 color; void main() { color = vec4(1.0); }",
                })?;
                let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
                let places: Vec<f32> = corners
                    .iter()
                    .flat_map(|&[x, y]| [x as f32, y as f32, z([x, y]) as f32])
                    .collect();
                session.float_array(0, 3, &places)?;
                glEnable(GL_DEPTH_CLAMP);
                glEnable(GL_DEPTH_TEST);
                glDepthFunc(GL_ALWAYS);
                glClearDepth(CLEARED);
                glClear(GL_DEPTH_BUFFER_BIT);
                session.depth_range(range);
                glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
                let mut depths = vec![0.0f32; SIZE[0] * SIZE[1]];
                let (format, ty) = (GL_DEPTH_COMPONENT, GL_FLOAT);
                glReadPixels(0, 0, SIZE[0], SIZE[1], format, ty, &mut depths);
                session.check("drawing depths")?;
                Ok(depths.into_iter().map(|depth| [depth.into(), 0.0, 0.0, 0.0]).collect())
            })?;
        }
    }
    tally.reach("pixels beyond the planes", beyond, 4 * cases.len());
    Ok(())
}
