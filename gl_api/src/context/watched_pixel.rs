//! The pixel that is watched, and notes of what was recorded meanwhile: what the state of a draw means in GL's names.
//!
//! `draw/watched_pixel.rs` makes the notes; [`crate::explain`] finds them by the labels of the driver's events.

use crate::interface::*;
use rasterizer::driver::{Topology, Watch};
use rasterizer::ir::{Axis, Input};

/// A note of a command.
#[derive(Debug)]
pub(crate) enum CommandNote {
    /// A draw.
    Draw(Box<DrawNote>),
    /// Clears.
    Clear,
}

/// What the state of a draw means, which the driver does not know.
#[derive(Clone, Debug, Default)]
pub(crate) struct DrawNote {
    /// What is drawn.
    pub title: String,
    /// By texture slot of the fragment stage.
    pub textures: Vec<String>,
    /// The formulas of the fixed function, each with its section.
    pub formulas: Vec<(String, &'static str)>,
    /// The program's own varyings: first slot, how many slots, name.
    pub varyings: Vec<(u16, u16, String)>,
}

/// The mode of primitives.
pub(crate) fn topology_name(topology: Topology) -> &'static str {
    match topology {
        Topology::Points => "GL_POINTS",
        Topology::Lines => "GL_LINES",
        Topology::LineStrip => "GL_LINE_STRIP",
        Topology::LineLoop => "GL_LINE_LOOP",
        Topology::Triangles => "GL_TRIANGLES",
        Topology::TriangleStrip => "GL_TRIANGLE_STRIP",
        Topology::TriangleFan => "GL_TRIANGLE_FAN",
        Topology::Quads => "GL_QUADS",
        Topology::QuadStrip => "GL_QUAD_STRIP",
        Topology::Polygon => "GL_POLYGON",
        Topology::LinesAdjacency => "GL_LINES_ADJACENCY",
        Topology::LineStripAdjacency => "GL_LINE_STRIP_ADJACENCY",
        Topology::TrianglesAdjacency => "GL_TRIANGLES_ADJACENCY",
        Topology::TriangleStripAdjacency => "GL_TRIANGLE_STRIP_ADJACENCY",
    }
}

impl DrawNote {
    /// Adds the mode of the primitives to the title.
    pub fn drawing(mut self, topology: Topology) -> Self {
        let name = topology_name(topology);
        self.title = format!("{name}, {}", self.title);
        self
    }

    /// The name of an input.
    pub fn input(&self, input: Input) -> String {
        let axis = |axis: Axis| match axis {
            Axis::X => "∂x",
            Axis::Y => "∂y",
        };
        match input {
            Input::Varying(slot) => self.varying(slot),
            Input::Gradient { slot, axis: along } => {
                format!("∂{}/{}", self.varying(slot), axis(along))
            }
            Input::FragCoord(component) => {
                format!("gl_FragCoord.{}", component_name("xyzw", component.into()))
            }
            Input::FrontFacing => "gl_FrontFacing".into(),
            Input::PointCoord(component) => {
                format!("gl_PointCoord.{}", component_name("st", component.into()))
            }
            Input::Coverage => "coverage".into(),
            Input::SampleId => "gl_SampleID".into(),
            Input::SamplePosition(Axis::X) => "gl_SamplePosition.x".into(),
            Input::SamplePosition(Axis::Y) => "gl_SamplePosition.y".into(),
            Input::LineDirection(Axis::X) => "direction of the line, x".into(),
            Input::LineDirection(Axis::Y) => "direction of the line, y".into(),
            Input::Attribute { location, component } => {
                format!("attribute {location}.{}", component_name("xyzw", component.into()))
            }
            Input::VertexId => "gl_VertexID".into(),
            Input::InstanceId => "gl_InstanceID".into(),
            Input::PrimitiveId => "gl_PrimitiveIDIn".into(),
            Input::OfVertex { vertex, output } => format!("{output:?} of vertex {vertex}"),
        }
    }

    /// The name of a varying's slot.
    fn varying(&self, slot: u16) -> String {
        let four = |name: &str, first: u16, letters: &str| {
            format!("{name}.{}", component_name(letters, (slot - first).into()))
        };
        let own =
            self.varyings.iter().find(|(first, len, _)| (*first..first + len).contains(&slot));
        match (own, slot) {
            (Some((_, 1, name)), _) => name.clone(),
            (Some((first, len, name)), _) if *len <= 4 => four(name, *first, "xyzw"),
            (Some((first, _, name)), _) => format!("{name}[{}]", slot - first),
            (None, VARYING_COLOR..VARYING_SECONDARY_COLOR) => {
                four("gl_Color", VARYING_COLOR, "rgba")
            }
            (None, VARYING_SECONDARY_COLOR..VARYING_TEX_COORD) => {
                four("gl_SecondaryColor", VARYING_SECONDARY_COLOR, "rgba")
            }
            (None, VARYING_TEX_COORD..VARYING_FOG) => {
                let unit = (slot - VARYING_TEX_COORD) / 4;
                let name = format!("gl_TexCoord[{unit}]");
                four(&name, VARYING_TEX_COORD + 4 * unit, "stpq")
            }
            (None, VARYING_FOG) => "gl_FogFragCoord".into(),
            (None, VARYING_BACK_COLOR..VARYING_CLIP_DISTANCE) => {
                let second = (slot - VARYING_BACK_COLOR) / 4;
                let name = ["gl_BackColor", "gl_BackSecondaryColor"][usize::from(second)];
                four(name, VARYING_BACK_COLOR + 4 * second, "rgba")
            }
            (None, VARYING_CLIP_DISTANCE..VARYING_USER) => {
                format!("gl_ClipDistance[{}]", slot - VARYING_CLIP_DISTANCE)
            }
            (None, _) => format!("varying {slot}, made of others at the vertices"),
        }
    }
}

/// A component's letter.
fn component_name(letters: &str, component: usize) -> String {
    letters.chars().nth(component).map_or_else(|| component.to_string(), String::from)
}

/// The pixel that is watched, and notes of the draws and clears that were recorded since.
#[derive(Debug)]
pub(crate) struct WatchedPixel {
    pub watch: Watch,
    /// By label.
    pub notes: Vec<CommandNote>,
}
