//! Pixel zoom: which pixel of a rectangle each pixel of the window gets (GL 2.1, section 3.6.4).

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

#[cfg(test)]
mod tests {
    use crate::calls::pixels::zoom::*;
    use crate::draw::zoom::*;

    #[test]
    fn a_pixel_covers_what_its_zoomed_square_covers() {
        for (start, zoom, count) in [
            (3.0, 1.0, 5),
            (3.5, 1.0, 5),
            (3.25, 2.5, 3),
            (9.0, -1.0, 4),
            (9.0, -0.5, 8),
            (2.0, 0.5, 9),
        ] {
            let axis = Axis { start, zoom, count };
            let (first, taps) = axis.taps(0, 20);
            for pixel in 0..20 {
                let centre = f64::from(pixel) + 0.5;
                let covers = |i: &usize| {
                    let (a, b) = (start + zoom * *i as f64, start + zoom * (*i + 1) as f64);
                    a.min(b) <= centre && centre < a.max(b)
                };
                let want = (0..count).find(covers);
                let got = usize::try_from(pixel - first).ok().and_then(|at| taps.get(at).copied());
                assert_eq!(got, want, "{axis:?} at {pixel}");
            }
        }
    }
}
