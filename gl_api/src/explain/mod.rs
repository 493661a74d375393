//! The explanation of a pixel: every clear and fragment that reached it, with the numbers it was drawn with and the
//! formula that each follows.
//!
//! [`Context::watch_pixel`] makes the driver write down what it does to one pixel of the default framebuffer
//! ([`rasterizer::trace`]); [`Context::explain_pixel`] puts GL's names to it, by the notes of the recorded draws
//! ([`crate::context::watched_pixel`]). What is written down is what ran: the last line is the picture's pixel, bit for
//! bit.
//!
//! The modules in the order of the text:
//!
//! | module | writes |
//! |---|---|
//! | `explanation` | the page of all events |
//! | `event` | clears; the primitive of a fragment, and its inputs |
//! | `texture_access` | a texture access: λ, levels, texels with weights |
//! | `texel_table` | the texels of a level, and their addresses |
//! | `shader` | the arithmetic of the fragment stage |
//! | `output` | tests, blending, what is stored |
//! | `plan_names` | GL's names in the texture unit's description of a plan |
//! | `page` | lines and tables of text |

pub(crate) mod event;
pub(crate) mod explanation;
pub(crate) mod output;
pub(crate) mod page;
pub(crate) mod plan_names;
pub(crate) mod shader;
pub(crate) mod texel_table;
pub(crate) mod texture_access;

use crate::context::Context;
use crate::context::watched_pixel::WatchedPixel;
pub use crate::explain::explanation::{Explanation, OutsideWindow};
use rasterizer::driver::Watch;
use texunit::lanes::FloatEnv;

impl Context {
    /// From now on, until [`Context::explain_pixel`], writes down what happens to pixel `(x, y)` of
    /// the default framebuffer; row 0 is the lowest. Draws stay the same to the bit, but those that
    /// reach the pixel take longer.
    ///
    /// # Errors
    /// When there is no such pixel.
    pub fn watch_pixel(&mut self, x: u32, y: u32) -> Result<(), OutsideWindow> {
        let (width, height) = self.size();
        if x >= width || y >= height {
            return Err(OutsideWindow { x, y, width, height });
        }
        let _float_env = FloatEnv::enter();
        // What was recorded before is not watched.
        crate::draw::pass::submit(self);
        self.watched = Some(Box::new(WatchedPixel { watch: Watch::new(x, y), notes: Vec::new() }));
        Ok(())
    }

    /// What happened to the watched pixel; `None` if none is watched. Ends the watch.
    pub fn explain_pixel(&mut self) -> Option<Explanation> {
        let _float_env = FloatEnv::enter();
        crate::draw::pass::submit(self);
        let watched = self.watched.take()?;
        let [x, y] = watched.watch.pixel();
        let (width, height) = self.size();
        let texels = self.window.color.texels();
        let level = texels.level(0, 0);
        let value = level.and_then(|level| level.color_at([x as i32, y as i32, 0]));
        Some(Explanation {
            pixel: [x, y],
            size: [width, height],
            events: watched.watch.take(),
            value: value.unwrap_or_default(),
            notes: watched.notes,
        })
    }
}
