//! Whether a call may stand between `glBegin` and `glEnd`.

/// Whether a call is allowed between `glBegin` and `glEnd` (GL 2.1, section 2.6.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BeginEnd {
    /// It is.
    Allowed,
    /// It is refused there with `GL_INVALID_OPERATION`.
    Refused,
}
