//! Whether a call may stand between `glBegin` and `glEnd`.

/// Whether a call is allowed between `glBegin` and `glEnd` (GL 2.1, section 2.6.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BeginEnd {
    /// The call is allowed there.
    Allowed,
    /// It is refused there with `GL_INVALID_OPERATION`.
    Refused,
}
