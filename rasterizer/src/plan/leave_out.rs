//! Whether anything is left out at all.

/// What draws leave out (`DETGL_LEAVE_OUT`). Pictures have the same bits either way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LeaveOut {
    /// What state, uniform values, textures or other shapes make without effect.
    #[default]
    WithoutEffect,
    /// Nothing: to find out whether leaving out is to blame for a picture, and to test that it is not.
    Nothing,
}
