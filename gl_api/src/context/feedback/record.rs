//! Feedback: the numbers that are written of each primitive (GL 2.1, section 5.3 and figure 5.1).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use crate::context::feedback::{Corner, Target};

/// `GL_FEEDBACK_BUFFER_TYPE`: what is written of each vertex (GL 2.1, table 5.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum FeedbackType {
    /// x, y.
    #[default]
    Plane,
    /// x, y, z.
    Space,
    /// x, y, z and the colour.
    Color,
    /// x, y, z, the colour and the texture coordinates of unit 0.
    Texture,
    /// x, y, z, w, the colour and the texture coordinates of unit 0.
    Homogeneous,
}

impl FeedbackType {
    pub const TABLE: Table<Self> = Table {
        section: "GL 2.1, table 5.2",
        rows: &[
            (GL_2D, Self::Plane),
            (GL_3D, Self::Space),
            (GL_3D_COLOR, Self::Color),
            (GL_3D_COLOR_TEXTURE, Self::Texture),
            (GL_4D_COLOR_TEXTURE, Self::Homogeneous),
        ],
    };
}

/// What a primitive is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PrimitiveToken {
    Point,
    Line,
    /// A line that begins the stipple anew.
    LineReset,
    Polygon,
    Bitmap,
    DrawPixels,
    CopyPixels,
}

impl PrimitiveToken {
    fn token(self) -> GLenum {
        match self {
            Self::Point => GL_POINT_TOKEN,
            Self::Line => GL_LINE_TOKEN,
            Self::LineReset => GL_LINE_RESET_TOKEN,
            Self::Polygon => GL_POLYGON_TOKEN,
            Self::Bitmap => GL_BITMAP_TOKEN,
            Self::DrawPixels => GL_DRAW_PIXEL_TOKEN,
            Self::CopyPixels => GL_COPY_PIXEL_TOKEN,
        }
    }
}

/// Feedback: the numbers so far.
#[derive(Debug, Default)]
pub(crate) struct Record {
    target: Option<Target>,
    size: usize,
    ty: FeedbackType,
    values: Vec<GLfloat>,
    state: Filling,
}

/// The fill state of the buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Filling {
    /// Nothing of this feedback is in it yet.
    #[default]
    Fresh,
    Some,
    /// More was written than it holds.
    Overflowed,
}

impl Record {
    pub fn new(size: usize, ty: FeedbackType, target: Target) -> Self {
        Self { target: Some(target), size, ty, ..Self::default() }
    }

    pub fn target(&self) -> Option<Target> {
        self.target
    }

    /// Numbers that the buffer holds.
    pub fn size(&self) -> usize {
        self.size
    }

    pub fn ty(&self) -> FeedbackType {
        self.ty
    }

    pub fn values(&self) -> &[GLfloat] {
        &self.values
    }

    /// A mode begins. What the last feedback wrote stays to be read until the next one.
    pub fn enter(&mut self) {
        self.state = Filling::Fresh;
    }

    /// Feedback ends: how many numbers there are, or -1 where the buffer was too small.
    pub fn leave(&mut self) -> GLint {
        if self.state == Filling::Fresh {
            self.values.clear();
        }
        if let Some(Target::Client(pointer)) = self.target {
            let bytes: &[u8] = bytemuck::cast_slice(&self.values);
            pointer.bytes_mut(bytes.len()).copy_from_slice(bytes);
        }
        match self.state {
            Filling::Overflowed => -1,
            Filling::Fresh | Filling::Some => self.values.len() as GLint,
        }
    }

    fn put(&mut self, value: f64) {
        if self.state == Filling::Fresh {
            self.values.clear();
            self.state = Filling::Some;
        }
        if self.values.len() < self.size {
            self.values.push(value as GLfloat);
        } else {
            self.state = Filling::Overflowed;
        }
    }

    pub fn pass_through(&mut self, token: GLfloat) {
        self.put(GL_PASS_THROUGH_TOKEN.into());
        self.put(token.into());
    }

    pub fn primitive(&mut self, kind: PrimitiveToken, corners: &[Corner]) {
        self.put(kind.token().into());
        if kind == PrimitiveToken::Polygon {
            self.put(corners.len() as f64);
        }
        for corner in corners {
            self.corner(corner);
        }
    }

    fn corner(&mut self, corner: &Corner) {
        let [x, y, z] = corner.window;
        let (color, texture) = (&corner.color[..], &corner.tex_coords[..]);
        let w = [corner.clip_w];
        let parts: [&[f64]; 4] = match self.ty {
            FeedbackType::Plane => [&[], &[], &[], &[]],
            FeedbackType::Space => [&[z], &[], &[], &[]],
            FeedbackType::Color => [&[z], &[], color, &[]],
            FeedbackType::Texture => [&[z], &[], color, texture],
            FeedbackType::Homogeneous => [&[z], &w, color, texture],
        };
        for &value in [x, y].iter().chain(parts.into_iter().flatten()) {
            self.put(value);
        }
    }
}
