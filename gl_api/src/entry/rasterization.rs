//! Rasterization: GL 2.1, chapter 3, and the enables of all chapters.

use crate::state::{enable, raster};
use crate::types::*;

entry_points! {
    RASTERIZATION;
    Outside in enable {
        /// Switches a capability on.
        enable: glEnable (cap: GLenum);
        /// Switches a capability off.
        disable: glDisable (cap: GLenum);
        /// Whether a capability is on.
        is_enabled: glIsEnabled (cap: GLenum) -> bool;
        /// Switches a client array on.
        enable_client_state: glEnableClientState (array: GLenum);
        /// Switches a client array off.
        disable_client_state: glDisableClientState (array: GLenum);
    }
    Outside in raster {
        /// Sets which faces `GL_CULL_FACE` leaves out.
        cull_face: glCullFace (mode: GLenum);
        /// Sets which winding is the front.
        front_face: glFrontFace (mode: GLenum);
        /// Sets whether colours are interpolated.
        shade_model: glShadeModel (mode: GLenum);
        /// Sets how polygons are drawn: filled.
        polygon_mode: glPolygonMode (face: GLenum, mode: GLenum);
        /// Sets what is added to the depth of polygons.
        polygon_offset: glPolygonOffset (factor: GLfloat, units: GLfloat);
        /// Sets the width of lines in pixels.
        line_width: glLineWidth (width: GLfloat);
        /// Sets the size of points in pixels.
        point_size: glPointSize (size: GLfloat);
        /// Accepted; DetGL has one quality.
        hint: glHint (target: GLenum, mode: GLenum);
    }
}
