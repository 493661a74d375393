//! The state that the commands of a pass set, and what draws decided from it.

use super::command::Command;
use crate::desc::{Counter, RasterState, Rect, ScissoredViewport, VertexBinding, Viewport};
use crate::plan::{DrawPlan, Pipeline, Textures, arrays, same_textures};
use crate::shader::Prepared;
use std::sync::Arc;

/// The state that the commands of a pass have set.
pub struct BoundState {
    pub pipeline: Option<Pipeline>,
    pub vertices: Arc<[VertexBinding]>,
    pub vertex_textures: Textures,
    pub geometry_textures: Textures,
    pub fragment_textures: Textures,
    pub uniforms: Arc<[u32]>,
    pub viewport: Viewport,
    pub scissor: Option<Rect>,
    /// The viewports from number 1 on.
    pub more_viewports: Arc<[ScissoredViewport]>,
    pub raster: Arc<RasterState>,
    pub counter: Option<Counter>,
    pub budget: u64,
    pub first_primitive: u32,
    /// The decisions of the previous draw, as long as no state that they depend on has changed.
    pub decided: Option<DrawDecisions>,
    /// The label of a watched pixel.
    pub label: u32,
}

/// Decisions that draws with equal state share.
#[derive(Clone)]
pub struct DrawDecisions {
    pub plan: Arc<DrawPlan>,
    /// The plans of the viewports from number 1 on, where primitives choose.
    pub more_plans: Arc<[Arc<DrawPlan>]>,
    /// The per-draw values of the vertex program.
    pub vertex: Arc<Prepared>,
    /// Those of the geometry program.
    pub geometry: Option<Arc<Prepared>>,
}

impl BoundState {
    /// The state at the beginning of a pass.
    pub fn new(budget: u64) -> Self {
        let none: Textures = Arc::new([]);
        Self {
            pipeline: None,
            vertices: Arc::new([]),
            vertex_textures: none.clone(),
            geometry_textures: none.clone(),
            fragment_textures: none,
            uniforms: Arc::new([]),
            viewport: Viewport {
                x: 0.0,
                y: 0.0,
                width: 0.0,
                height: 0.0,
                near: 0.0,
                far: 1.0,
                depth_clip: Default::default(),
                clip_control: Default::default(),
            },
            scissor: None,
            more_viewports: Arc::new([]),
            counter: None,
            budget,
            first_primitive: 0,
            raster: Arc::default(),
            decided: None,
            label: 0,
        }
    }

    /// Applies a command that sets state, and drops decisions that depend on it.
    pub fn set(&mut self, command: &Command) {
        match command {
            Command::BindPipeline(pipeline) => self.pipeline = Some(pipeline.clone()),
            Command::BindGeometryTextures(textures) => {
                if same_textures(textures, &self.geometry_textures) {
                    return;
                }
                self.geometry_textures = textures.clone();
            }
            Command::BindTextures { vertex, fragment } => {
                if same_textures(vertex, &self.vertex_textures)
                    && same_textures(fragment, &self.fragment_textures)
                {
                    return;
                }
                self.vertex_textures = vertex.clone();
                self.fragment_textures = fragment.clone();
            }
            Command::SetUniforms(words) => self.uniforms = words.clone(),
            Command::SetRaster(raster) => self.raster = raster.clone(),
            Command::SetViewport(viewport) => self.viewport = *viewport,
            Command::SetMoreViewports(all) => self.more_viewports = all.clone(),
            Command::SetCounter(counter) => self.counter = counter.clone(),
            Command::BindVertices(bindings) => {
                let same = arrays(bindings) == arrays(&self.vertices);
                self.vertices = bindings.clone();
                if same {
                    return;
                }
            }
            Command::SetScissor(scissor) => {
                self.scissor = *scissor;
                return;
            }
            Command::SetBudget(budget) => {
                self.budget = *budget;
                return;
            }
            Command::SetFirstPrimitive(number) => {
                self.first_primitive = *number;
                return;
            }
            Command::BeginPass(_)
            | Command::EndPass
            | Command::Watch(_)
            | Command::Clear { .. }
            | Command::Draw { .. }
            | Command::DrawIndexed { .. } => return,
        }
        self.decided = None;
    }
}
