//! The layouts and the inputs of the geometry stage (GLSL 1.50 sections 4.3.4 and 4.3.8).

use super::Checker;
use crate::ast::{PrimitiveLayout, Qualifier};
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::limits::MAX_GEOMETRY_OUTPUT_VERTICES;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::Type;
use rasterizer::ir::{GeometryInput, GeometryOutput, Stage};

const INPUTS: &str = "4.3.8.1";
const OUTPUTS: &str = "4.3.8.2";

/// The primitives that a layout lets the stage take.
fn taken(primitive: PrimitiveLayout) -> Option<GeometryInput> {
    match primitive {
        PrimitiveLayout::Points => Some(GeometryInput::Points),
        PrimitiveLayout::Lines => Some(GeometryInput::Lines),
        PrimitiveLayout::LinesAdjacency => Some(GeometryInput::LinesAdjacency),
        PrimitiveLayout::Triangles => Some(GeometryInput::Triangles),
        PrimitiveLayout::TrianglesAdjacency => Some(GeometryInput::TrianglesAdjacency),
        PrimitiveLayout::LineStrip | PrimitiveLayout::TriangleStrip => None,
    }
}

/// The primitives that a layout lets the stage make.
fn made(primitive: PrimitiveLayout) -> Option<GeometryOutput> {
    match primitive {
        PrimitiveLayout::Points => Some(GeometryOutput::Points),
        PrimitiveLayout::LineStrip => Some(GeometryOutput::LineStrip),
        PrimitiveLayout::TriangleStrip => Some(GeometryOutput::TriangleStrip),
        PrimitiveLayout::Lines
        | PrimitiveLayout::LinesAdjacency
        | PrimitiveLayout::Triangles
        | PrimitiveLayout::TrianglesAdjacency => None,
    }
}

/// Whether a variable of the geometry stage has an element for each vertex of a primitive.
fn is_per_vertex(variable: &Variable) -> bool {
    matches!(variable.storage, Storage::Input(_) | Storage::Builtin(Builtin::Incoming(_)))
}

impl Checker<'_> {
    /// `layout(triangles) in;`
    pub(super) fn input_layout(&mut self, words: &[(Qualifier, Span)], span: Span) {
        if self.stage != Stage::Geometry {
            let message = "only the geometry stage has a layout of all inputs";
            self.error(span, INPUTS, message);
            return;
        }
        let mut seen = 0;
        for &(word, span) in words.iter().filter(|(word, _)| *word != Qualifier::In) {
            let input = if let Qualifier::Primitive(word) = word { taken(word) } else { None };
            let Some(input) = input else {
                let message = "the layout of the inputs is points, lines, lines_adjacency, triangles \
                               or triangles_adjacency";
                self.error(span, INPUTS, message);
                continue;
            };
            seen += 1;
            if seen == 2 {
                self.error(span, INPUTS, "the inputs have one primitive: this is a second one");
            }
            let known = *self.unit.geometry.input.get_or_insert(input);
            if known != input {
                let message = "another layout of the inputs stands before";
                self.error(span, INPUTS, message);
            }
        }
        self.size_inputs(span);
    }

    /// `layout(triangle_strip, max_vertices = 3) out;`
    pub(super) fn output_layout(&mut self, words: &[(Qualifier, Span)], span: Span) {
        if self.stage != Stage::Geometry {
            let message = "only the geometry stage has a layout of all outputs";
            self.error(span, OUTPUTS, message);
            return;
        }
        for &(word, span) in words.iter().filter(|(word, _)| *word != Qualifier::Out) {
            let output = if let Qualifier::Primitive(word) = word { made(word) } else { None };
            if let Some(output) = output {
                if *self.unit.geometry.output.get_or_insert(output) != output {
                    self.error(span, OUTPUTS, "another primitive of the outputs stands before");
                }
            } else if let Qualifier::MaxVertices(count) = word {
                if count > MAX_GEOMETRY_OUTPUT_VERTICES {
                    let message = format!(
                        "max_vertices = {count}: gl_MaxGeometryOutputVertices is \
                         {MAX_GEOMETRY_OUTPUT_VERTICES}"
                    );
                    self.error(span, OUTPUTS, message);
                } else if *self.unit.geometry.max_vertices.get_or_insert(count) != count {
                    self.error(span, OUTPUTS, "another max_vertices stands before");
                }
            } else {
                let message = "the layout of the outputs is points, line_strip or triangle_strip, \
                               and max_vertices = n";
                self.error(span, OUTPUTS, message);
            }
        }
    }

    /// Gives the inputs that are declared the size that their layout says.
    fn size_inputs(&mut self, span: Span) {
        let Some(vertices) = self.unit.geometry.input.map(|input| u32::from(input.vertices()))
        else {
            return;
        };
        let mut wrong = Vec::new();
        for variable in self.unit.globals.iter_mut().filter(|variable| is_per_vertex(variable)) {
            let (name, min_len) = (variable.name.clone(), variable.min_len);
            let Type::Array(_, len) = &mut variable.ty else { continue };
            match *len {
                Some(len) if len != vertices => {
                    wrong.push(format!("`{name}` has {len} elements, and"));
                }
                None if min_len > vertices => {
                    wrong.push(format!("element {} of `{name}` is used, and", min_len - 1));
                }
                Some(_) | None => *len = Some(vertices),
            }
        }
        if let Some(len) = self.input_len.filter(|len| *len != vertices) {
            wrong.push(format!("the inputs have {len} elements, and"));
        }
        if let Some(first) = wrong.first() {
            self.error(span, INPUTS, format!("{first} these primitives have {vertices} vertices"));
        }
        self.input_len = Some(vertices);
    }

    /// The type of what passes between stages: an input of the geometry stage is an array with an
    /// element for each vertex of the primitive.
    pub(super) fn passed_type(&mut self, ty: Type, storage: Storage, span: Span) -> Type {
        if self.stage != Stage::Geometry || !matches!(storage, Storage::Input(_)) {
            return ty;
        }
        self.per_vertex_type(ty, span)
    }

    pub(super) fn per_vertex_type(&mut self, ty: Type, span: Span) -> Type {
        match ty {
            Type::Array(element, Some(len)) => {
                if let Some(known) = self.input_len.filter(|known| *known != len) {
                    let message = format!("{len} elements: the other inputs have {known}");
                    let problem = Diagnostic::error(span, message).rule(self.rule(INPUTS));
                    self.log.push(problem.help("write `[]`: the layout gives the size"));
                }
                self.input_len.get_or_insert(len);
                Type::Array(element, Some(len))
            }
            Type::Array(element, None) => {
                let vertices = self.unit.geometry.input.map(|input| u32::from(input.vertices()));
                Type::Array(element, vertices)
            }
            Type::Error => Type::Error,
            Type::Void
            | Type::Vector(..)
            | Type::Matrix(..)
            | Type::Sampler(_)
            | Type::Struct(_) => {
                let message = "an input of the geometry stage is an array, with an element for each \
                               vertex";
                let problem = Diagnostic::error(span, message).rule(self.rule("4.3.4"));
                self.log.push(problem.help("write `[]` behind it"));
                Type::Error
            }
        }
    }
}
