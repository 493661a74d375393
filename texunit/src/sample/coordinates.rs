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
    /// Where the direction meets a cube, if it is one; else the face is 0.
    pub projected: cube::Projected,
    pub is_cube: bool,
}

impl<'a> Coordinates<'a> {
    /// Of a texture without faces and layers.
    #[inline(always)]
    pub fn in_plane(given: [&'a F32s; 3]) -> Self {
        Self { given, layer: U32s::ZERO, projected: cube::Projected::ZERO, is_cube: false }
    }

    #[inline(always)]
    pub fn new(
        texture: &Texture,
        given: [&'a F32s; 3],
        layer: Option<&F32s>,
        recorder: &mut impl Recorder,
    ) -> Self {
        let mut at = Self::in_plane(given);
        at.locate(texture, layer, recorder);
        at
    }

    /// Sets face and layer.
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
                self.is_cube = true;
                let projected = &mut self.projected;
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

    /// The coordinates to filter along.
    #[inline(always)]
    pub fn filtered(&self) -> [&F32s; 3] {
        let cube::Projected { st: [s, t], .. } = &self.projected;
        if self.is_cube { [s, t, self.given[2]] } else { self.given }
    }
}
