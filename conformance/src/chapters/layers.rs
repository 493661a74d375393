//! Layered framebuffers: draws to the layer that the geometry stage chooses, and clears of all.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::painter::Rect;
use crate::probe::{Dialect, ProbeError, Session, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

/// Draws.
pub const DRAW: Check = Check {
    name: "layered-draw",
    citation: "GL 3.2, 2.12.4 and 4.4.7: gl_Layer",
    what: "every texel of every layer of 2D arrays, 3D images and cube maps after rectangles in random \
           layers, one over the other",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run: draw,
};

/// Clears.
pub const CLEAR: Check = Check {
    name: "layered-clear",
    citation: "GL 3.2, 4.4.7: clears of a layered framebuffer clear all layers; 4.2.3",
    what: "every texel of every layer after clears within scissors and under masks",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run: clear,
};

/// A layered image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Array,
    Volume,
    Cube,
}

const SHAPES: [Shape; 3] = [Shape::Array, Shape::Volume, Shape::Cube];
const SIDE: usize = 16;
const LAYERS: usize = 6;

impl Shape {
    fn target(self) -> u32 {
        match self {
            Self::Array => GL_TEXTURE_2D_ARRAY,
            Self::Volume => GL_TEXTURE_3D,
            Self::Cube => GL_TEXTURE_CUBE_MAP,
        }
    }

    /// Attaches an image of zeros, all of its layers.
    fn attach(self, session: &Session) -> Result<(), ProbeError> {
        let (mut texture, mut framebuffer) = (0u32, 0u32);
        glGenTextures(1, &mut texture);
        glGenFramebuffers(1, &mut framebuffer);
        let target = self.target();
        glBindTexture(target, texture);
        let zeros = vec![0u32; SIDE * SIDE * LAYERS * 4];
        let (internal, format, ty) = (GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
        match self {
            Self::Array | Self::Volume => {
                glTexImage3D(target, 0, internal, SIDE, SIDE, LAYERS, 0, format, ty, &zeros);
            }
            Self::Cube => {
                for face in 0..6 {
                    let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
                    glTexImage2D(face, 0, internal, SIDE, SIDE, 0, format, ty, &zeros);
                }
            }
        }
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0);
        glViewport(0, 0, SIDE, SIDE);
        session.check("attaching a layered image")
    }

    /// Every texel, layer by layer.
    fn texels(self, session: &Session) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut texels = vec![[0u32; 4]; SIDE * SIDE * LAYERS];
        let (format, ty) = (GL_RGBA_INTEGER, GL_UNSIGNED_INT);
        match self {
            Self::Array | Self::Volume => {
                glGetTexImage(self.target(), 0, format, ty, texels.as_flattened_mut());
            }
            Self::Cube => {
                let faces = GL_TEXTURE_CUBE_MAP_POSITIVE_X..;
                for (face, texels) in faces.zip(texels.chunks_exact_mut(SIDE * SIDE)) {
                    glGetTexImage(face, 0, format, ty, texels.as_flattened_mut());
                }
            }
        }
        session.check("reading a layered image")?;
        Ok(texels.into_iter().map(|texel| texel.map(f64::from)).collect())
    }
}

/// A texel: layer, column, row.
type Case = [usize; 3];

fn texels() -> Vec<Case> {
    let rows = (0..LAYERS).flat_map(|layer| (0..SIDE).map(move |y| (layer, y)));
    rows.flat_map(|(layer, y)| (0..SIDE).map(move |x| [layer, x, y])).collect()
}

fn rect(rng: &mut Rng) -> Rect {
    let mut side = |least, most| rng.integer(least, most) as usize;
    let low = [side(0, 12), side(0, 12)];
    Rect { low, size: low.map(|low| side(1, (SIDE - low) as i64)) }
}

const RECTANGLES: Stages<'_> = Stages {
    vertex: "layout(location = 0) in uvec4 rect; layout(location = 1) in uint layer;
        flat out uvec4 place; flat out uvec2 name;
        void main() { place = rect; name = uvec2(layer, gl_VertexID); }",
    geometry: "layout(points) in; layout(triangle_strip, max_vertices = 4) out;
        flat in uvec4 place[]; flat in uvec2 name[]; flat out uvec2 color;
        void main() {
            for (int corner = 0; corner < 4; corner++) {
                vec2 at = vec2(place[0].xy) + vec2(corner & 1, corner >> 1) * vec2(place[0].zw);
                gl_Layer = int(name[0].x);
                color = name[0];
                gl_Position = vec4(at / 8.0 - 1.0, 0.0, 1.0);
                EmitVertex();
            }
        }",
    fragment: "flat in uvec2 color; out uvec4 result;
        void main() { result = uvec4(color.y + 1u, color.x, 0, 1); }",
};

fn draw(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("layered-draw");
    let cases = texels();
    for round in 0..harness.cases(8) {
        for shape in SHAPES {
            let rects: Vec<(Rect, usize)> = (0..60)
                .map(|_| (rect(&mut rng), rng.integer(0, LAYERS as i64 - 1) as usize))
                .collect();
            let covers = |&(rect, at): &(Rect, usize), &[layer, x, y]: &Case| {
                at == layer && rect.has([x, y])
            };
            let drawn = cases.iter().filter(|case| rects.iter().any(|r| covers(r, case))).count();
            tally.reach(format!("round {round}, {shape:?}, texels drawn"), drawn, cases.len() / 3);
            let expect = |case: &Case, variant: Variant| {
                let [layer, x, y] = *case;
                let layer =
                    if variant.has(Mutation::LayersReversed) { LAYERS - 1 - layer } else { layer };
                let zero_only = variant.has(Mutation::LayerIgnored);
                let over = rects.iter().enumerate().rev().find(|(_, drawn)| {
                    if zero_only {
                        layer == 0 && drawn.0.has([x, y])
                    } else {
                        covers(drawn, &[layer, x, y])
                    }
                });
                over.map_or([0.0; 4], |(number, &(_, at))| {
                    [number as f64 + 1.0, at as f64, 0.0, 1.0]
                })
            };
            harness.compare_with(Dialect::Core, tally, &shape, &cases, expect, |session| {
                session.stages(&RECTANGLES)?;
                shape.attach(session)?;
                let places: Vec<u32> = rects
                    .iter()
                    .flat_map(|(r, _)| [r.low[0], r.low[1], r.size[0], r.size[1]].map(|c| c as u32))
                    .collect();
                let layers: Vec<u32> = rects.iter().map(|&(_, layer)| layer as u32).collect();
                session.word_array(0, 4, &places)?;
                session.word_array(1, 1, &layers)?;
                glDrawArrays(GL_POINTS, 0, rects.len());
                shape.texels(session)
            })?;
        }
    }
    Ok(())
}

/// A clear: the scissor, the mask and the value.
type ClearStep = (Rect, [bool; 4], [u32; 4]);

fn clear(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("layered-clear");
    let cases = texels();
    for round in 0..harness.cases(8) {
        for shape in SHAPES {
            let steps: Vec<ClearStep> = (0..8)
                .map(|_| {
                    let mask = [0; 4].map(|_: i32| rng.integer(0, 3) > 0);
                    let value = [0; 4].map(|_: i32| rng.integer(1, 1 << 24) as u32);
                    (rect(&mut rng), mask, value)
                })
                .collect();
            let touched =
                cases.iter().filter(|c| steps.iter().any(|s| s.0.has([c[1], c[2]]))).count();
            tally.reach(
                format!("round {round}, {shape:?}, texels cleared"),
                touched,
                cases.len() / 4,
            );
            let expect = |&[layer, x, y]: &Case, variant: Variant| {
                let mut texel = [0.0; 4];
                if variant.has(Mutation::LayerIgnored) && layer > 0 {
                    return texel;
                }
                for (rect, mask, value) in &steps {
                    if !rect.has([x, y]) && !variant.has(Mutation::ScissorIgnored) {
                        continue;
                    }
                    for i in (0..4).filter(|&i| mask[i]) {
                        texel[i] = value[i].into();
                    }
                }
                texel
            };
            harness.compare_with(Dialect::Core, tally, &shape, &cases, expect, |session| {
                shape.attach(session)?;
                glEnable(GL_SCISSOR_TEST);
                for (rect, [r, g, b, a], value) in &steps {
                    glScissor(rect.low[0], rect.low[1], rect.size[0], rect.size[1]);
                    glColorMask(*r, *g, *b, *a);
                    glClearBufferuiv(GL_COLOR, 0, value);
                }
                glDisable(GL_SCISSOR_TEST);
                shape.texels(session)
            })?;
        }
    }
    Ok(())
}
