//! A context's default framebuffer can be another one, or none: EGL's surfaces, OSMesa's memory.

use crate::context::Context;
use crate::context::window::Window;
use crate::state::State;

impl Context {
    /// Puts another default framebuffer in place of one to which everything was drawn. Which of its
    /// buffers are drawn to and read from is the context's.
    pub(crate) fn swap_window(&mut self, mut window: Window) -> Window {
        window.selection = self.window.selection.clone();
        std::mem::replace(&mut self.window, window)
    }

    /// The default framebuffer that is read from: another one than is drawn to, if there is one.
    pub(crate) fn read_window(&self) -> &Window {
        self.read_window.as_ref().unwrap_or(&self.window)
    }

    /// Puts another default framebuffer in place to be read from, or that which is drawn to; nothing
    /// that was recorded reads it.
    pub(crate) fn swap_read_window(&mut self, window: Option<Window>) -> Option<Window> {
        std::mem::replace(&mut self.read_window, window)
    }

    /// Viewport and scissor take the size of the first default framebuffer (GL 2.1, sections 2.11.1
    /// and 4.1.2).
    pub(crate) fn first_window(&mut self, width: u32, height: u32) {
        let fresh = State::new(width, height);
        self.state.viewport = fresh.viewport;
        self.state.fragment.scissor = fresh.fragment.scissor;
    }
}
