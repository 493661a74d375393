//! A draw of a pass: its plan, its chunks, and when bins are emptied.

use super::account::{Account, Extent};
use super::{Pass, SMALL_DRAW, within};
use crate::attachment::DepthFormat;
use crate::driver::bound::DrawDecisions;
use crate::driver::chunk::{DrawState, GeometryProgram, MergedDraws};
use crate::driver::report::SubmitReport;
use crate::driver::resources::{DeviceDesc, Resources};
use crate::driver::visibility::Visibility;
use crate::plan::{
    Counting, DrawPlan, LeaveOut, Pipeline, PlanInput, draws_lines, has_unit_scale_factor,
    possible_samples, sprite_slots,
};
use crate::primitive::Setup;
use crate::raster::{DrawBudget, DrawJob};
use crate::shader::OverBudget;
use crate::vertex::{EdgeFlags, VertexIds, primitives};
use std::ops::Range;
use std::sync::atomic::AtomicU64;
use std::sync::{Arc, OnceLock};

/// The number of binned shapes at which tiles run before the pass ends. The next chunks then reuse memory that is in
/// the cache.
const BINS_FULL: usize = 1 << 15;

/// The most plans that a pass keeps for reuse by later draws.
const KEPT_PLANS: usize = 8;

impl Pass<'_> {
    pub(super) fn draw(
        &mut self,
        command: usize,
        ids: &VertexIds<'_>,
        count: u32,
        instances: &Range<u32>,
        report: &mut SubmitReport,
    ) {
        let Some(pipeline) = self.bound.pipeline.clone() else { return };
        let pipeline = match sprite_slots(pipeline.desc(), &self.bound.raster) {
            [] => pipeline,
            _ => pipeline.of_sprites(),
        };
        let pipeline = match draws_lines(pipeline.desc(), &self.bound.raster) {
            true => pipeline.of_lines(),
            false if has_unit_scale_factor(pipeline.desc(), &self.bound.raster) => {
                pipeline.of_unit_scale_factor()
            }
            false => pipeline,
        };
        let pipeline = pipeline.of_arrays(&self.bound.vertices);
        let area = self.area(self.bound.scissor);
        let chooses = !self.bound.more_viewports.is_empty() && pipeline.chooses_viewports();
        if (area[0][0] >= area[1][0] || area[0][1] >= area[1][1]) && !chooses {
            return;
        }
        let area_in_viewport = within(area, &self.bound.viewport);
        let DrawDecisions { plan, more_plans, vertex, geometry } = match &self.bound.decided {
            Some(decided) => decided.clone(),
            None => self.decide(&pipeline),
        };
        if plan.has_no_effect() && self.job.watch.is_none() {
            // It has a warning of its own.
            report.visibility.add(Visibility::Visible);
            return;
        }
        let raster = plan.raster.clone();
        let draw = self.job.draws.len();
        self.push_job(command, plan, area_in_viewport);
        let more_viewports = self.bound.more_viewports.clone();
        let more_areas = more_viewports.iter().zip(&*more_plans).map(|(own, plan)| {
            let area = self.area(own.scissor);
            let area_in_viewport = within(area, &own.viewport);
            self.push_job(command, plan.clone(), area_in_viewport);
            (own.viewport, area, area_in_viewport)
        });
        let more_areas: Vec<_> = more_areas.collect();

        let compiled = pipeline.compiled();
        let desc = pipeline.desc();
        let resolution =
            self.depth_format().and_then(DepthFormat::of).and_then(DepthFormat::resolution);
        let primitives = primitives(desc.topology, desc.provoking, count)
            .numbered_from(self.bound.first_primitive);
        let vertices = self.bound.vertices.clone();
        let textures = self.bound.vertex_textures.clone();
        let geometry_textures = self.bound.geometry_textures.clone();
        let geometry = compiled.geometry.as_deref().zip(geometry).map(|(program, prepared)| {
            GeometryProgram { program, prepared, textures: &geometry_textures }
        });
        let setup = Setup {
            isa: self.job.isa,
            viewport: self.bound.viewport,
            cull: desc.cull,
            front_face: desc.front_face,
            raster: &raster,
            edge_flags: match geometry {
                None => primitives.edge_flags(),
                Some(_) => EdgeFlags::AllSet,
            },
            drawable_area: area,
            area_in_viewport,
            resolution,
        };
        let mut state = DrawState {
            draw,
            isa: self.job.isa,
            budget: DeviceDesc::batch_budget_after(self.bound.budget, report.spent.operations),
            thread_pool: self.thread_pool,
            machines: &self.resources.machines,
            geometries: &self.resources.geometries,
            lists: &self.resources.lists,
            pipeline: &pipeline,
            ids,
            primitives,
            bindings: &vertices,
            textures: &textures,
            stipple: 0,
            operations: AtomicU64::new(0),
            instances: instances.clone(),
            max_reasons: report.visibility.reasons_left(),
            invisible_reasons: OnceLock::new(),
            prepared: vertex,
            slots: &compiled.slots,
            geometry: geometry.clone(),
            layers: self.desc.layers.into(),
            setup,
            more_setups: more_areas
                .into_iter()
                .map(|(viewport, drawable_area, area_in_viewport)| Setup {
                    viewport,
                    drawable_area,
                    area_in_viewport,
                    ..setup
                })
                .collect(),
        };
        // Edge flags belong to one draw, and so do lines that only advance a stipple.
        let is_small = raster.polygon.edge_flag.is_none()
            && raster.line.stipple.is_none()
            && self.job.watch.is_none()
            && state.more_setups.is_empty()
            && (1..=SMALL_DRAW).contains(&state.drawn_len())
            && instances.len() <= state.instances_per_chunk() as usize;
        let drawn = match is_small {
            true => self.merge_small_draw(&state),
            false => self.draw_in_own_chunks(&mut state, count, report),
        };
        let Ok(is_visible) = drawn else {
            report.spent.exhaust(self.bound.budget);
            self.job.draws[draw..].iter_mut().for_each(|job| job.budget.is_stopped = true);
            return;
        };
        if self.shapes >= BINS_FULL {
            self.run_tiles(report);
        }
        report.visibility.add(match (is_visible, state.invisible_reasons.into_inner()) {
            (true, _) => Visibility::Visible,
            (false, None) => Visibility::NothingDrawn,
            (false, Some(reasons)) => Visibility::Invisible(reasons),
        });
    }

    /// Appends a draw of an area with what is bound.
    fn push_job(&mut self, command: usize, plan: Arc<DrawPlan>, area: [[i32; 2]; 2]) {
        let (counter, budget) = (self.bound.counter.clone(), DrawBudget::new(self.bound.budget));
        self.job.draws.push(DrawJob { plan, area, counter, budget, label: self.bound.label });
        self.commands.push(command);
    }

    /// Appends a small draw to the chunk of the draws before it, if their state is equal; returns whether it has shapes.
    fn merge_small_draw(&mut self, state: &DrawState<'_>) -> Result<bool, OverBudget> {
        let draws = &self.job.draws;
        let can_append = |all: &MergedDraws| {
            !all.is_full() && draws[all.draw].can_share_chunk(&draws[state.draw])
        };
        if !self.merged.as_ref().is_some_and(can_append) {
            self.bin_merged();
        }
        let Resources { geometries, lists, .. } = self.resources;
        let new = || MergedDraws::new(state.draw, geometries.take(), lists.take());
        let all = self.merged.get_or_insert_with(new);
        let before = all.len();
        state.append_to(all)?;
        Ok(all.len() > before)
    }

    /// Divides a draw into its own chunks; returns whether it has shapes.
    fn draw_in_own_chunks(
        &mut self,
        state: &mut DrawState<'_>,
        count: u32,
        report: &mut SubmitReport,
    ) -> Result<bool, OverBudget> {
        self.bin_merged();
        if state.primitives.len == 0 {
            return Ok(false);
        }
        let (budget, spent) = (self.bound.budget, report.spent.operations);
        let left = budget.saturating_sub(spent);
        let extent = match Extent::of(count, state) {
            extent if spent > 0 && left == 0 => extent.in_spent_frame(),
            extent => extent,
        };
        state.budget = extent.batch_budget(budget, spent);
        let jobs = &mut self.job.draws[state.draw..];
        jobs.iter_mut().for_each(|job| job.budget = extent.fragment_budget(budget));
        let plan = &self.job.draws[state.draw].plan;
        let mut account = Account::new(extent, left, count, state, plan);
        let drawn = self.draw_chunks(state, (extent, &mut account), report);
        match extent {
            Extent::Endless => report.spent.add(account.spent()),
            Extent::Held { .. } | Extent::Allowed => {}
        }
        drawn
    }

    /// Divides a draw into chunks, as long as it may run.
    fn draw_chunks(
        &mut self,
        state: &mut DrawState<'_>,
        (extent, account): (Extent, &mut Account),
        report: &mut SubmitReport,
    ) -> Result<bool, OverBudget> {
        // Of a draw that has nothing left, no chunk is made.
        account.spend(1)?;
        let mut is_visible = false;
        let (instances, instances_per_chunk) =
            (state.instances.clone(), state.instances_per_chunk());
        for first in instances.clone().step_by(instances_per_chunk as usize) {
            state.instances = first..instances.end.min(first.saturating_add(instances_per_chunk));
            state.stipple = 0;
            let mut start = 0;
            while start < state.primitives.len {
                let range = start..state.primitives.len.min(start + state.run_len());
                start = range.end;
                let chunks = state.chunks(range.clone())?;
                account.charge(state, range, chunks.iter().map(|(chunk, _)| chunk))?;
                is_visible |= self.bin_chunks(chunks);
                if self.shapes >= BINS_FULL {
                    self.run_tiles(report);
                    match extent {
                        // Loops of their fragments have a budget of their own.
                        Extent::Held { .. } => {}
                        Extent::Allowed | Extent::Endless => {
                            let jobs = self.job.draws[state.draw..].iter_mut();
                            let looped = jobs.map(|job| std::mem::take(&mut job.budget.looped));
                            account.spend(looped.fold(0, u64::saturating_add))?;
                        }
                    }
                }
            }
        }
        Ok(is_visible)
    }

    /// Decides how to draw with what is bound.
    fn decide(&mut self, pipeline: &Pipeline) -> DrawDecisions {
        let viewport = self.bound.viewport;
        let decided = self.decide_for(pipeline);
        if !pipeline.chooses_viewports() {
            return decided;
        }
        let more_viewports = self.bound.more_viewports.clone();
        let more_plans = more_viewports.iter().map(|own| {
            self.bound.viewport = own.viewport;
            self.decide_for(pipeline).plan
        });
        let more_plans = more_plans.collect();
        self.bound.viewport = viewport;
        let decided = DrawDecisions { more_plans, ..decided };
        self.bound.decided = Some(decided.clone());
        decided
    }

    /// Decides how to draw to the first viewport.
    fn decide_for(&mut self, pipeline: &Pipeline) -> DrawDecisions {
        let leave_out = self.resources.desc.leave_out;
        let (isa, depth, bound) = (self.job.isa, self.depth_format(), &mut self.bound);
        // Uniforms, such as matrices, are mostly not the fragments'.
        let prepare = |pipeline: &Pipeline| {
            let fragment = &pipeline.compiled().fragment;
            let prepare = || fragment.prepare(isa, &bound.uniforms, &bound.fragment_textures);
            fragment.depends_on_uniforms().then(prepare)
        };
        let mut prepared = prepare(pipeline);
        // An explanation of a pixel names everything that its program computes.
        let specialized = match self.job.watch {
            None if leave_out == LeaveOut::WithoutEffect => {
                pipeline.specialized(prepared.as_ref(), &bound.fragment_textures)
            }
            None | Some(_) => None,
        };
        if let Some(specialized) = &specialized {
            prepared = prepare(specialized);
        }
        let pipeline = specialized.as_ref().unwrap_or(pipeline);
        let compiled = pipeline.compiled();
        let surface = self.colors.iter().flatten().chain(&self.depth).next();
        let samples =
            surface.map_or_else(|| possible_samples(self.desc.samples), |surface| surface.samples);
        let input = PlanInput {
            isa,
            colors: &self.formats,
            depth,
            samples,
            uniforms: &bound.uniforms,
            textures: bound.fragment_textures.clone(),
            viewport: bound.viewport,
            raster: bound.raster.clone().for_samples(samples),
            counting: match bound.counter {
                Some(_) => Counting::On,
                None => Counting::Off,
            },
            leave_out,
            vertices: &bound.vertices,
        };
        let mut recent = self.recent.iter().rev();
        let plan =
            match recent.find(|plan| plan.is_reusable_for(pipeline, &input, prepared.as_ref())) {
                Some(plan) => plan.clone(),
                None => {
                    let plan = Arc::new(DrawPlan::new(pipeline, input));
                    if self.recent.len() == KEPT_PLANS {
                        self.recent.remove(0);
                    }
                    self.recent.push(plan.clone());
                    plan
                }
            };
        self.resources.explain(&|| plan.describe());
        let vertex = compiled.vertex.prepare(isa, &bound.uniforms, &bound.vertex_textures);
        let vertex = Arc::new(vertex);
        let geometry = compiled.geometry.as_ref().map(|program| {
            Arc::new(program.prepare(isa, &bound.uniforms, &bound.geometry_textures))
        });
        let decided = DrawDecisions { plan, more_plans: Arc::new([]), vertex, geometry };
        bound.decided = Some(decided.clone());
        decided
    }
}
