//! The viewport transformation: GL 2.1, section 2.11.1.

use crate::state::per_viewport::PerViewport;
use rasterizer::driver::{ClipControl, ClipDepth, ClipOrigin, DepthClip};

/// The viewports, with their depth ranges.
pub(crate) type ViewportState = PerViewport<Viewport>;

/// A viewport and its depth range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Viewport {
    pub x: f32,
    pub y: f32,
    pub width: f32,
    pub height: f32,
    /// Window depth of the near and far planes, 0 to 1.
    pub depth: [f64; 2],
}

impl Viewport {
    pub fn new(width: u32, height: u32) -> Self {
        Self { x: 0.0, y: 0.0, width: width as f32, height: height as f32, depth: [0.0, 1.0] }
    }

    /// As `glGet` gives it.
    pub fn sides(&self) -> [f32; 4] {
        [self.x, self.y, self.width, self.height]
    }
}

/// How positions become window coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindowTransform<'a> {
    pub viewport: &'a Viewport,
    pub control: ClipControl,
    pub depth_clip: DepthClip,
}

impl WindowTransform<'_> {
    /// Window coordinates of clip coordinates (GL 2.1, section 2.11.1; `ARB_clip_control`). Depth beyond the planes is
    /// clamped to their range where they do not clip.
    pub fn window(&self, [x, y, z, w]: [f64; 4]) -> [f64; 3] {
        let Self { viewport, control, depth_clip } = self;
        let along =
            |c: f64, start: f32, size: f32| f64::from(start) + (c + 1.0) * f64::from(size) / 2.0;
        let y = match control.origin {
            ClipOrigin::LowerLeft => y / w,
            ClipOrigin::UpperLeft => -(y / w),
        };
        // From 0 at the near plane to 1 at the far plane.
        let part = match control.depth {
            ClipDepth::NegativeOneToOne => (z / w + 1.0) / 2.0,
            ClipDepth::ZeroToOne => z / w,
        };
        let [near, far] = viewport.depth;
        let depth = near + part * (far - near);
        [
            along(x / w, viewport.x, viewport.width),
            along(y, viewport.y, viewport.height),
            match depth_clip {
                DepthClip::Cut => depth,
                DepthClip::Clamp => within(depth, viewport.depth),
            },
        ]
    }
}

/// A depth between those of the near and the far plane.
fn within(depth: f64, [near, far]: [f64; 2]) -> f64 {
    depth.max(near.min(far)).min(near.max(far))
}
