//! The rules of what a module declares: variables, varyings, outputs, the interface of a geometry module.

use super::super::{
    GeometryInterface, MAX_GEOMETRY_COMPONENTS, MAX_GEOMETRY_VERTICES, Module, Output, Stage, Ty,
};
use super::{Checked, IrError, MAX_VALUES, MAX_VARIABLE_WORDS};
use std::collections::BTreeSet;

impl Module {
    pub(super) fn declarations(&self) -> Checked {
        rule!(self.values.len() <= MAX_VALUES, "more than {MAX_VALUES} values");
        let mut words = 0;
        for (at, variable) in self.variables.iter().enumerate() {
            rule!(variable.len >= 1, "variable v{at} ({}) has no elements", variable.name);
            words += u64::from(variable.len);
            rule!(words <= MAX_VARIABLE_WORDS, "more than {MAX_VARIABLE_WORDS} variable elements");
        }
        rule!(
            self.stage == Stage::Fragment || self.varyings.is_empty(),
            "a {:?} module declares the interpolation of varyings",
            self.stage
        );
        self.geometry()
    }

    fn geometry(&self) -> Checked {
        let is_geometry = self.stage == Stage::Geometry;
        rule!(
            is_geometry == self.geometry.is_some(),
            "a {:?} module {} a geometry interface",
            self.stage,
            if is_geometry { "needs" } else { "has no" }
        );
        let Some(GeometryInterface { max_vertices, outputs, .. }) = &self.geometry else {
            return Ok(());
        };
        rule!(
            *max_vertices <= MAX_GEOMETRY_VERTICES,
            "a geometry module of {max_vertices} vertices, of at most {MAX_GEOMETRY_VERTICES}"
        );
        let components = outputs.len() as u64 * u64::from(*max_vertices);
        rule!(
            components <= MAX_GEOMETRY_COMPONENTS.into(),
            "a geometry module of {components} components, of at most {MAX_GEOMETRY_COMPONENTS}"
        );
        let mut seen = BTreeSet::new();
        for &output in outputs {
            let in_range = match output {
                Output::Position(component) => component < 4,
                Output::ClipDistance(plane) | Output::CullDistance(plane) => plane < 8,
                Output::PointSize
                | Output::Varying(_)
                | Output::Layer
                | Output::PrimitiveId
                | Output::ViewportIndex => true,
                Output::Color { .. }
                | Output::SecondColor(_)
                | Output::Depth
                | Output::StencilReference
                | Output::SampleMask => {
                    return Err(IrError(format!("output {output:?} in a Geometry module")));
                }
            };
            rule!(in_range, "output {output:?} has no such component");
            rule!(seen.insert(output), "output {output:?} twice");
        }
        Ok(())
    }

    pub(super) fn outputs(&self) -> Checked {
        let mut seen = BTreeSet::new();
        for &(output, var) in &self.outputs {
            let (stage, in_range) = match output {
                Output::Position(component) => (Stage::Vertex, component < 4),
                Output::PointSize | Output::Varying(_) => (Stage::Vertex, true),
                Output::ClipDistance(plane) | Output::CullDistance(plane) => {
                    (Stage::Vertex, plane < 8)
                }
                Output::Color { component, .. } | Output::SecondColor(component) => {
                    (Stage::Fragment, component < 4)
                }
                Output::Depth | Output::StencilReference | Output::SampleMask => {
                    (Stage::Fragment, true)
                }
                // Those of a geometry module are in its interface.
                Output::Layer | Output::ViewportIndex => (Stage::Vertex, true),
                Output::PrimitiveId => (Stage::Geometry, false),
            };
            rule!(stage == self.stage, "output {output:?} in a {:?} module", self.stage);
            rule!(in_range, "output {output:?} has no such component");
            rule!(seen.insert(output), "output {output:?} twice");
            let Some(variable) = self.variables.get(var.0 as usize) else {
                return Err(IrError(format!("output {output:?}: there is no v{}", var.0)));
            };
            // Colours may be integers, for attachments of integers.
            let fits = match output {
                Output::Color { .. } => variable.ty != Ty::Bool,
                Output::StencilReference
                | Output::SampleMask
                | Output::Layer
                | Output::ViewportIndex => variable.ty == Ty::I32,
                Output::Position(_)
                | Output::PointSize
                | Output::ClipDistance(_)
                | Output::CullDistance(_)
                | Output::Varying(_)
                | Output::SecondColor(_)
                | Output::Depth => variable.ty == Ty::F32,
                Output::PrimitiveId => false,
            };
            rule!(
                variable.len == 1 && fits,
                "output {output:?}: v{} is not one scalar of its type",
                var.0
            );
        }
        Ok(())
    }
}
