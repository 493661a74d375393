//! The viewport, and the treatment of depths outside [0, 1].

/// The viewport in pixels (GL 2.1, section 2.11.1). It may extend beyond the attachments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Left edge in pixels.
    pub x: f32,
    /// Lower edge in pixels.
    pub y: f32,
    /// Width in pixels.
    pub width: f32,
    /// Height in pixels.
    pub height: f32,
    /// Window depth of the near plane, 0 to 1.
    pub near: f32,
    /// Window depth of the far plane, 0 to 1.
    pub far: f32,
    /// The treatment of depths beyond the near and the far plane.
    pub depth_clip: DepthClip,
    /// How clip coordinates become window coordinates.
    pub clip_control: ClipControl,
}

/// How clip coordinates become window coordinates (`ARB_clip_control`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ClipControl {
    /// Where y = -w is in the viewport.
    pub origin: ClipOrigin,
    /// The depths between the near and the far plane.
    pub depth: ClipDepth,
}

/// Where y = -w is in the viewport.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ClipOrigin {
    /// At its lower edge.
    #[default]
    LowerLeft,
    /// At its upper edge: pictures are upside down.
    UpperLeft,
}

/// The depths in clip coordinates between the near and the far plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ClipDepth {
    /// From -w to w.
    #[default]
    NegativeOneToOne,
    /// From 0 to w.
    ZeroToOne,
}

/// The treatment of depths beyond the near and the far plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthClip {
    /// Primitives are clipped.
    #[default]
    Cut,
    /// Depths are clamped to the range of both planes (`ARB_depth_clamp`).
    Clamp,
}

impl Viewport {
    /// The least and the largest depth of fragments, after planes, offsets and shaders.
    pub(crate) fn depths(&self) -> [f32; 2] {
        match self.depth_clip {
            DepthClip::Cut => [0.0, 1.0],
            DepthClip::Clamp if self.near < self.far => [self.near, self.far],
            DepthClip::Clamp => [self.far, self.near],
        }
    }

    /// Pixels per unit of normalized device coordinates. The second is negative where y points down.
    pub(crate) fn half(&self) -> [f64; 2] {
        let [x, y] = [f64::from(self.width) * 0.5, f64::from(self.height) * 0.5];
        match self.clip_control.origin {
            ClipOrigin::LowerLeft => [x, y],
            ClipOrigin::UpperLeft => [x, -y],
        }
    }

    /// The window position of clip coordinates (0, 0).
    pub(crate) fn center(&self) -> [f64; 2] {
        [
            f64::from(self.x) + f64::from(self.width) * 0.5,
            f64::from(self.y) + f64::from(self.height) * 0.5,
        ]
    }

    /// Window depth is `scale · z/w + bias` (GL 2.1, section 2.11.1; `ARB_clip_control`).
    pub(crate) fn depth_transform(&self) -> DepthTransform {
        let (near, far) = (f64::from(self.near), f64::from(self.far));
        match self.clip_control.depth {
            ClipDepth::NegativeOneToOne => {
                DepthTransform { scale: (far - near) * 0.5, bias: (near + far) * 0.5 }
            }
            ClipDepth::ZeroToOne => DepthTransform { scale: far - near, bias: near },
        }
    }

    /// The pixels whose centres it holds: the first, and one past the last.
    pub(crate) fn pixels(&self) -> [[i32; 2]; 2] {
        let sides = [(self.x, self.width), (self.y, self.height)];
        let [x, y] = sides.map(|(start, size)| {
            let (start, size) = (f64::from(start), f64::from(size));
            [(start - 0.5).ceil() as i32, (start + size - 0.5).ceil() as i32]
        });
        [[x[0], y[0]], [x[1], y[1]]]
    }

    /// Window x and y of clip coordinates; meaningless unless `w > 0`.
    pub(crate) fn window(&self, clip: &[f64; 4]) -> [f64; 2] {
        let (half, center) = (self.half(), self.center());
        [clip[0] / clip[3] * half[0] + center[0], clip[1] / clip[3] * half[1] + center[1]]
    }
}

/// Window depth is `scale · z/w + bias`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthTransform {
    pub scale: f64,
    pub bias: f64,
}

/// A viewport of several, and the scissor rectangle of what is drawn in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScissoredViewport {
    /// The viewport.
    pub viewport: Viewport,
    /// The scissor rectangle; `None` lets every pixel of the attachments through.
    pub scissor: Option<Rect>,
}

/// The most viewports of a draw.
pub const MAX_VIEWPORTS: usize = 16;

/// A rectangle of pixels; row 0 is the lowest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Left.
    pub x: i32,
    /// Lowest row.
    pub y: i32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}
