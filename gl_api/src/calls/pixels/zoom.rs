//! `glPixelZoom`: GL 2.1, section 3.6.4.

use crate::base::error::{Result, invalid_value};
use crate::base::types::*;
use crate::context::Context;

pub(crate) fn pixel_zoom(context: &mut Context, xfactor: GLfloat, yfactor: GLfloat) -> Result<()> {
    if !xfactor.is_finite() || !yfactor.is_finite() {
        return invalid_value(
            "GL 2.1, section 3.6.4",
            format!("xfactor = {xfactor} and yfactor = {yfactor} must be numbers"),
        );
    }
    context.state.pixel_zoom = [xfactor, yfactor];
    Ok(())
}
