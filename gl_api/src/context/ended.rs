//! `glEnd` without a draw of its own: vertices that ended wait for more of their kind, and so do bitmaps.
//!
//! A program that draws face by face calls `glBegin` and `glEnd` by the thousand, and a draw costs what
//! hundreds of vertices do. The first of them is drawn. As long as nothing but vertices follows, what
//! was true of it is true of the next: they can be drawn without an error, with the same state, at any
//! time before something else happens ([`draw_ended`]).

use crate::context::bitmaps as bitmap;
use crate::context::bitmaps::Bitmaps;
use crate::context::immediate::Immediate;
use rasterizer::driver::Topology;

/// What waits.
#[derive(Debug)]
pub(crate) enum Ended {
    /// Primitives.
    Vertices(Immediate),
    /// Bitmaps.
    Bitmaps(Box<Bitmaps>),
}

impl Ended {
    /// Whether it may wait while a call is made that may not stand between `glBegin` and `glEnd`.
    pub fn outlasts(&self, call: &str) -> bool {
        match self {
            Self::Vertices(_) => false,
            Self::Bitmaps(_) => bitmap::outlast(call),
        }
    }
}

/// How many vertices a primitive has, if it has none in common with others.
pub(crate) fn vertices_of_primitive(topology: Topology) -> Option<usize> {
    match topology {
        Topology::Points => Some(1),
        Topology::Lines => Some(2),
        Topology::Triangles => Some(3),
        Topology::Quads => Some(4),
        Topology::LineStrip
        | Topology::LineLoop
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::QuadStrip
        | Topology::Polygon => None,
    }
}

#[cfg(test)]
mod tests {
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
        c.matrix_mode(GL_PROJECTION);
        assert_eq!(draws(&c), [1, 9]);
        c.new_list(1, GL_COMPILE);
        ten_points(&mut c);
        c.end_list();
        c.call_list(1);
        assert_eq!(draws(&c), [1, 9, 10]);
    }
}
