//! The viewport transformation: GL 2.1, section 2.11.1.

/// The viewport and the depth range.
#[derive(Clone, Debug)]
pub(crate) struct ViewportState {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
    /// Window depth of the near and far planes, 0 to 1.
    pub depth: [f64; 2],
}

impl ViewportState {
    pub fn new(width: u32, height: u32) -> Self {
        Self { x: 0, y: 0, width: width as i32, height: height as i32, depth: [0.0, 1.0] }
    }
}

/// A depth between those of the near and the far plane.
pub(crate) fn within(depth: f64, [near, far]: [f64; 2]) -> f64 {
    depth.max(near.min(far)).min(near.max(far))
}
