//! `gluProject` and its inverses, `gluPickMatrix`: the way between object and window coordinates
//! (GL 2.1, section 2.11), in `f64`.

use crate::base::types::GLint;
use crate::entry::{Arg, glScaled, glTranslated};
use glam::{DMat4, DVec3, DVec4};
use texunit::lanes::FloatEnv;

/// Where a point of an object comes to lie in the window: `x`, `y`, and a depth from 0 to 1.
/// `model` and `projection` are matrices as `glGetDoublev` gives them, `viewport` as `glGetIntegerv`
/// does. `None` for a point in the plane of the eye.
pub fn gluProject(
    x: impl Arg<f64>,
    y: impl Arg<f64>,
    z: impl Arg<f64>,
    model: &[f64; 16],
    projection: &[f64; 16],
    viewport: &[GLint; 4],
) -> Option<[f64; 3]> {
    let _float_env = FloatEnv::enter();
    let object = DVec4::new(x.arg(), y.arg(), z.arg(), 1.0);
    let eye = DMat4::from_cols_array(model) * object;
    let clip = DMat4::from_cols_array(projection) * eye;
    if clip.w == 0.0 {
        return None;
    }
    let unit = clip.truncate() / clip.w * 0.5 + 0.5;
    let [left, bottom, width, height] = viewport.map(f64::from);
    Some([unit.x * width + left, unit.y * height + bottom, unit.z])
}

/// The point of an object that comes to lie at `x`, `y` and depth `z` of the window: the inverse of
/// [`gluProject`]. `None` where the matrices have no inverse, or the point is infinitely far.
pub fn gluUnProject(
    x: impl Arg<f64>,
    y: impl Arg<f64>,
    z: impl Arg<f64>,
    model: &[f64; 16],
    projection: &[f64; 16],
    viewport: &[GLint; 4],
) -> Option<[f64; 3]> {
    let _float_env = FloatEnv::enter();
    let object = gluUnProject4(x, y, z, 1.0, model, projection, viewport, 0.0, 1.0)?;
    let object = DVec4::from_array(object);
    (object.w != 0.0).then(|| (object.truncate() / object.w).to_array())
}

/// [`gluUnProject`] with a clip coordinate `w`, depths from `near` to `far` (`glDepthRange`), and
/// homogeneous coordinates.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluUnProject4(
    x: impl Arg<f64>,
    y: impl Arg<f64>,
    z: impl Arg<f64>,
    clip_w: impl Arg<f64>,
    model: &[f64; 16],
    projection: &[f64; 16],
    viewport: &[GLint; 4],
    near: impl Arg<f64>,
    far: impl Arg<f64>,
) -> Option<[f64; 4]> {
    let _float_env = FloatEnv::enter();
    let [left, bottom, width, height] = viewport.map(f64::from);
    let (near, far) = (near.arg(), far.arg());
    let window = DVec3::new(x.arg(), y.arg(), z.arg());
    let unit = (window - DVec3::new(left, bottom, near)) / DVec3::new(width, height, far - near);
    let matrix = DMat4::from_cols_array(projection) * DMat4::from_cols_array(model);
    if !unit.is_finite() || matrix.determinant() == 0.0 || !matrix.is_finite() {
        return None;
    }
    let w = clip_w.arg();
    Some((matrix.inverse() * ((unit * 2.0 - 1.0) * w).extend(w)).to_array())
}

/// Multiplies onto the current matrix what enlarges a rectangle around `x`, `y` of the window,
/// `width` by `height` pixels, to the whole viewport. A rectangle of nothing changes nothing.
pub fn gluPickMatrix(
    x: impl Arg<f64>,
    y: impl Arg<f64>,
    width: impl Arg<f64>,
    height: impl Arg<f64>,
    viewport: &[GLint; 4],
) {
    let _float_env = FloatEnv::enter();
    let (width, height) = (width.arg(), height.arg());
    if width <= 0.0 || height <= 0.0 {
        return;
    }
    let [left, bottom, across, up] = viewport.map(f64::from);
    glTranslated(
        (across - 2.0 * (x.arg() - left)) / width,
        (up - 2.0 * (y.arg() - bottom)) / height,
        0.0,
    );
    glScaled(across / width, up / height, 1.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const VIEWPORT: [GLint; 4] = [10, 20, 400, 300];
    /// A frustum from 1 to 9, as `gluPerspective(90, 1, 1, 9)`.
    const FRUSTUM: [f64; 16] = {
        let mut m = [0.0; 16];
        m[0] = 1.0;
        m[5] = 1.0;
        m[10] = -1.25;
        m[11] = -1.0;
        m[14] = -2.25;
        m
    };
    const IDENTITY: [f64; 16] = DMat4::IDENTITY.to_cols_array();

    #[test]
    fn the_frustums_corners_are_the_viewports() {
        for (object, window) in [
            ([-1.0, -1.0, -1.0], [10.0, 20.0, 0.0]),
            ([9.0, 9.0, -9.0], [410.0, 320.0, 1.0]),
            ([0.0, 0.0, -1.8], [210.0, 170.0, 0.5]),
        ] {
            let [x, y, z] = object;
            let found = gluProject(x, y, z, &IDENTITY, &FRUSTUM, &VIEWPORT).unwrap();
            assert!(found.iter().zip(window).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        }
        assert_eq!(gluProject(1, 1, 0, &IDENTITY, &FRUSTUM, &VIEWPORT), None);
    }

    #[test]
    fn what_has_no_inverse_is_refused() {
        let flat = [0.0; 16];
        assert_eq!(gluUnProject(1, 1, 0, &flat, &FRUSTUM, &VIEWPORT), None);
        assert_eq!(gluUnProject(1, 1, 0, &IDENTITY, &FRUSTUM, &[0; 4]), None);
        assert_eq!(gluUnProject(f64::NAN, 1, 0, &IDENTITY, &FRUSTUM, &VIEWPORT), None);
    }

    proptest! {
        #[test]
        fn there_and_back_is_the_same_point(x in -3.0..3.0, y in -3.0..3.0, z in -8.0..-1.1) {
            let turn = DMat4::from_cols_array(&[
                0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.25, 0.0, 1.0,
            ]).to_cols_array();
            let [wx, wy, wz] = gluProject(x, y, z, &turn, &FRUSTUM, &VIEWPORT).unwrap();
            let back = gluUnProject(wx, wy, wz, &turn, &FRUSTUM, &VIEWPORT).unwrap();
            prop_assert!(back.iter().zip([x, y, z]).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-9), "{back:?}");
        }
    }
}
