//! Vertices after `glEnd`, and bitmaps, that wait to be batched with more of their kind into one draw.
//!
//! A program that draws face by face calls `glBegin` and `glEnd` by the thousand, and a draw costs what hundreds of
//! vertices do. So `glEnd` draws only the first of primitives that follow one another. As long as nothing but vertices
//! follows, the state is the same and no error is possible: the vertices wait until something else happens.
//! [`crate::draw::pending_primitives`] decides which wait, and draws them.

use crate::context::immediate::Immediate;
use crate::context::pending_bitmaps::{PendingBitmaps, bitmaps_survive};
use crate::state::plain::PlainState;
use rasterizer::driver::Topology;

/// What is pending.
#[derive(Debug)]
pub(crate) enum PendingPrimitives {
    /// Vertices of one topology, with one set of attributes that vary.
    Vertices(Immediate),
    /// Pixels of bitmaps.
    Bitmaps(Box<PendingBitmaps>),
}

/// The plain state that pending vertices are drawn with, kept where setters were called since.
#[derive(Debug)]
pub(crate) struct PendingState {
    pub state: Box<PlainState>,
    /// The number of the call when it was last known to be that of the context.
    pub call: u64,
}

impl PendingPrimitives {
    /// Whether they may stay pending during a call that may not stand between `glBegin` and `glEnd`.
    pub fn survives(&self, call: &str) -> bool {
        match self {
            Self::Vertices(_) => false,
            Self::Bitmaps(_) => bitmaps_survive(call),
        }
    }
}

/// How many vertices a primitive has; `None` where primitives of the topology share vertices.
pub(crate) fn vertices_of_primitive(topology: Topology) -> Option<usize> {
    match topology {
        Topology::Points => Some(1),
        Topology::Lines => Some(2),
        Topology::Triangles => Some(3),
        Topology::Quads | Topology::LinesAdjacency => Some(4),
        Topology::TrianglesAdjacency => Some(6),
        Topology::LineStripAdjacency
        | Topology::TriangleStripAdjacency
        | Topology::LineStrip
        | Topology::LineLoop
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::QuadStrip
        | Topology::Polygon => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::base::args::DataOut;
    use crate::base::constants::*;
    use crate::context::{Context, ContextDesc};
    use rasterizer::driver::Command;

    fn ten_points(c: &mut Context) {
        for x in 0..10 {
            c.begin(GL_POINTS);
            c.color_3f(1.0, 0.0, 0.0);
            c.vertex_2f(x as f32 / 10.0, 0.0);
            c.end();
        }
    }

    fn draws(c: &Context) -> Vec<u32> {
        let commands = c.recorder.commands.commands.iter();
        let counts = commands.filter_map(|command| match command {
            Command::Draw { count, .. } => Some(*count),
            _ => None,
        });
        counts.collect()
    }

    #[test]
    fn what_follows_the_first_is_one_draw_and_a_list_is_one() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        ten_points(&mut c);
        assert_eq!(draws(&c), [1]);
        c.lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 1.0);
        assert_eq!(draws(&c), [1, 9]);
        c.new_list(1, GL_COMPILE);
        ten_points(&mut c);
        c.end_list();
        c.call_list(1);
        assert_eq!(draws(&c), [1, 9, 10]);
    }

    #[test]
    fn setters_end_nothing_unless_the_state_is_another_when_more_vertices_come() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        for _ in 0..3 {
            ten_points(&mut c);
            c.enable(GL_BLEND);
            c.blend_func(GL_SRC_ALPHA, GL_ONE);
            c.disable(GL_BLEND);
            c.blend_func(GL_ONE, GL_ZERO);
            c.matrix_mode(GL_MODELVIEW);
            c.bind_texture(GL_TEXTURE_2D, 0);
            c.use_program(0);
            assert_eq!(c.get_error(), GL_NO_ERROR);
            assert!(!c.is_enabled(GL_BLEND));
        }
        assert_eq!(draws(&c), [1]);
        c.depth_func(GL_ALWAYS);
        ten_points(&mut c);
        assert_eq!(draws(&c), [1, 29, 1]);
        c.enable(GL_TEXTURE_2D);
        assert_eq!(draws(&c), [1, 29, 1, 9]);
    }

    #[test]
    fn matrices_and_stacks_end_nothing_unless_the_state_is_another_when_more_vertices_come() {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        for _ in 0..3 {
            ten_points(&mut c);
            c.matrix_mode(GL_PROJECTION);
            c.load_identity();
            c.ortho(-1.0, 1.0, -1.0, 1.0, 1.0, -1.0);
            c.matrix_mode(GL_TEXTURE);
            c.push_matrix();
            c.load_identity();
            c.pop_matrix();
            c.matrix_mode(GL_MODELVIEW);
            c.push_matrix();
            c.translatef(0.5, 0.0, 0.0);
            c.pop_matrix();
            c.push_attrib(GL_ALL_ATTRIB_BITS);
            c.enable(GL_BLEND);
            c.color_3f(0.0, 1.0, 0.0);
            c.pop_attrib();
            assert_eq!(c.get_error(), GL_NO_ERROR);
        }
        assert_eq!(draws(&c), [1]);
        c.translatef(0.5, 0.0, 0.0);
        ten_points(&mut c);
        assert_eq!(draws(&c), [1, 29, 1]);
        c.push_attrib(GL_TEXTURE_BIT);
        c.enable(GL_TEXTURE_2D);
        assert_eq!(draws(&c), [1, 29, 1, 9]);
        ten_points(&mut c);
        // The units are others than before.
        c.pop_attrib();
        assert_eq!(draws(&c), [1, 29, 1, 9, 1, 9]);
    }

    #[test]
    fn pending_vertices_have_the_matrix_and_the_lights_from_before() {
        let picture = |is_pending: bool| {
            let mut c = Context::new(ContextDesc::default()).expect("a device");
            c.enable(GL_LIGHTING);
            c.enable(GL_LIGHT0);
            let settle = |c: &mut Context| match is_pending {
                true => {}
                false => c.flush(),
            };
            ten_points(&mut c);
            settle(&mut c);
            c.translatef(0.0, 0.25, 0.0);
            ten_points(&mut c);
            settle(&mut c);
            c.push_attrib(GL_LIGHTING_BIT | GL_ENABLE_BIT);
            c.disable(GL_LIGHT0);
            c.translatef(0.0, 0.25, 0.0);
            ten_points(&mut c);
            settle(&mut c);
            c.pop_attrib();
            c.translatef(0.0, 0.25, 0.0);
            ten_points(&mut c);
            let mut bytes = vec![0u8; 512 * 512 * 4];
            let out = DataOut::Bytes(&mut bytes);
            c.read_pixels(0, 0, 512, 512, GL_RGBA, GL_UNSIGNED_BYTE, out);
            assert_eq!(c.get_error(), GL_NO_ERROR);
            bytes
        };
        assert!(picture(true) == picture(false));
    }
}
