//! Rasterization: GL 2.1, chapter 3, and the enables of all chapters.

use crate::base::args::{Data, DataOut};
use crate::base::types::*;
use crate::calls::enable;
use crate::calls::raster::{lines as raster, multisample, points, polygon};
use crate::calls::vertex::arrays;
use crate::query::enabled;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_rasterization {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Setter in enable {
        /// Switches a capability on.
        enable: glEnable (cap: GLenum);
        /// Switches a capability off.
        disable: glDisable (cap: GLenum);
    }
    Query in enabled {
        /// Whether a capability is on.
        is_enabled: glIsEnabled (cap: GLenum) -> bool;
    }
    Refused in enable {
        /// Switches a client array on.
        enable_client_state: glEnableClientState (array: GLenum), not_compiled;
        /// Switches a client array off.
        disable_client_state: glDisableClientState (array: GLenum), not_compiled;
    }
    Setter in raster {
        /// Sets which faces `GL_CULL_FACE` leaves out.
        cull_face: glCullFace (mode: GLenum);
        /// Sets which winding is the front.
        front_face: glFrontFace (mode: GLenum);
        /// Sets whether colours are interpolated.
        shade_model: glShadeModel (mode: GLenum);
        /// Sets which vertex of a primitive flat colours are of.
        provoking_vertex: glProvokingVertex | glProvokingVertexEXT (mode: GLenum);
        /// Sets the width of lines in pixels.
        line_width: glLineWidth (width: GLfloat);
        /// Sets which fragments of lines are left: `factor` fragments a bit of `pattern`.
        line_stipple: glLineStipple (factor: GLint, pattern: GLushort);
        /// Accepted; DetGL has one quality.
        hint: glHint (target: GLenum, mode: GLenum);
    }
    Setter in multisample {
        /// Sets which part of the samples of a pixel `GL_SAMPLE_COVERAGE` leaves.
        sample_coverage: glSampleCoverage | glSampleCoverageARB (value: GLclampf, invert: bool);
        /// Sets which samples `GL_SAMPLE_MASK` leaves, bit by sample.
        sample_maski: glSampleMaski (mask_number: GLuint, mask: GLbitfield);
        /// Sets which part of the samples of a pixel is shaded each by itself, where `GL_SAMPLE_SHADING` is enabled.
        min_sample_shading: glMinSampleShading | glMinSampleShadingARB (value: GLfloat);
        /// Reads where a sample of the draw framebuffer lies in its pixel.
        get_multisamplefv: glGetMultisamplefv
            (pname: GLenum, index: GLuint, val: &'a mut [GLfloat]);
    }
    Setter in polygon {
        /// Sets whether polygons are filled, or drawn by their edges or vertices.
        polygon_mode: glPolygonMode (face: GLenum, mode: GLenum);
        /// Sets what is added to the depth of polygons.
        polygon_offset: glPolygonOffset (factor: GLfloat, units: GLfloat);
        /// As `glPolygonOffset`; a positive `clamp` is the most that is added, a negative one the least.
        polygon_offset_clamp: glPolygonOffsetClamp | glPolygonOffsetClampEXT
            (factor: GLfloat, units: GLfloat, clamp: GLfloat);
        /// Sets which pixels of filled polygons are left: 32 rows of 32 bits.
        polygon_stipple: glPolygonStipple (mask: Data<'a>);
        /// Gives the polygon stipple.
        get_polygon_stipple: glGetPolygonStipple (mask: DataOut<'a>);
    }
    Allowed in polygon {
        /// Sets whether the edges that begin at the vertices to come are boundaries.
        edge_flag: glEdgeFlag (flag: bool);
        /// The same from memory.
        edge_flagv: glEdgeFlagv (flag: &'a [GLboolean]);
    }
    Setter in points {
        /// Sets the size of points in pixels.
        point_size: glPointSize (size: GLfloat);
        /// Sets a limit of the size of points, the threshold of fading, or where t of a sprite is 0.
        point_parameterf: glPointParameterf | glPointParameterfARB | glPointParameterfEXT
            (pname: GLenum, param: GLfloat);
        /// The same, or the attenuation of the size by distance.
        point_parameterfv: glPointParameterfv | glPointParameterfvARB | glPointParameterfvEXT
            (pname: GLenum, params: &'a [GLfloat]);
        /// As `glPointParameterf`.
        point_parameteri: glPointParameteri (pname: GLenum, param: GLint);
        /// As `glPointParameterfv`.
        point_parameteriv: glPointParameteriv (pname: GLenum, params: &'a [GLint]);
    }
    Refused in arrays {
        /// Says where edge flags are. A slice is copied now; later writes to it are not seen.
        edge_flag_pointer: glEdgeFlagPointer (stride: GLsizei, pointer: Data<'a>), not_compiled;
    }
    } };
}
entry_points_rasterization!(implement);
