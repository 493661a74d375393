//! Why a pixel has its colour: every clear and fragment that reached it, with the numbers it was
//! drawn with and the formula that each follows.
//!
//! [`Context::watch_pixel`] makes the driver write down what it does to one pixel of the default
//! framebuffer ([`rasterizer::trace`]); [`Context::explain_pixel`] puts GL's names to it. What is
//! written down is what ran: the last line is the picture's pixel, bit for bit.
//!
//! The modules in the order of the text:
//!
//! | module | says |
//! |---|---|
//! | `note` | what the state of a draw means: its units, its environments, the names of varyings |
//! | `event` | clears; the primitive, its inputs |
//! | `sample` | a texture access: λ, levels, texels with weights |
//! | `shader` | the arithmetic of the fragment stage |
//! | `output` | tests, blending, what is stored |

use crate::context::draw_note::Note;
use rasterizer::driver::Watch;

/// A pixel that is watched, and what is known of the draws and clears that were recorded.
#[derive(Debug)]
pub(crate) struct Watched {
    pub watch: Watch,
    /// By label.
    pub notes: Vec<Note>,
}
