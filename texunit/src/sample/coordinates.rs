//! Coordinates of a batch: the cube face, the layer, and the coordinates to filter along.

use super::recorder::Recorder;
use super::{cube, wrap};
use crate::image::Shape;
use crate::lanes::{F32s, U32s};
use crate::plan::Texture;
use crate::trace::SampleStep;

/// The point that each lane samples.
pub(crate) struct Coordinates<'a> {
    /// s, t, r of the lookup; of a cube, the direction.
    pub given: [&'a F32s; 3],
    /// The layer of an array, else 0.
    pub layer: U32s,
    /// Where the direction meets a cube.
    pub projected: Option<cube::Projected>,
}

impl<'a> Coordinates<'a> {
    /// Of a texture without faces and layers; [`Self::locate`] sets those of others.
    #[inline(always)]
    pub fn in_plane(given: [&'a F32s; 3]) -> Self {
        Self { given, layer: U32s::ZERO, projected: None }
    }

    /// Sets face and layer. (In place: what a function returned would be copied.)
    #[inline(always)]
    pub fn locate(
        &mut self,
        texture: &Texture,
        layer: Option<&F32s>,
        recorder: &mut impl Recorder,
    ) {
        let given = self.given;
        match texture.shape {
            Shape::D1 | Shape::D2 | Shape::Rect | Shape::D3 => {}
            Shape::D1Array => self.layer = wrap::layer(given[1], texture.layers()),
            Shape::D2Array => self.layer = wrap::layer(given[2], texture.layers()),
            Shape::Cube | Shape::CubeArray => {
                let projected = self.projected.insert(cube::Projected::ZERO);
                cube::project(given, projected);
                recorder.record(|lane| SampleStep::Face {
                    face: projected.face[lane],
                    st: projected.st.map(|coord| coord[lane]),
                });
                if let Some(layer) = layer {
                    self.layer = wrap::layer(layer, texture.layers());
                }
            }
        }
        if texture.is_array() {
            recorder.record(|lane| SampleStep::Layer(self.layer[lane]));
        }
    }

    /// The face of a cube, else 0.
    #[inline(always)]
    pub fn face(&self) -> &U32s {
        match &self.projected {
            Some(projected) => &projected.face,
            None => &U32s::ZERO,
        }
    }

    /// The coordinates to filter along.
    #[inline(always)]
    pub fn filtered(&self) -> [&F32s; 3] {
        match &self.projected {
            Some(cube::Projected { st: [s, t], .. }) => [s, t, self.given[2]],
            None => self.given,
        }
    }
}
