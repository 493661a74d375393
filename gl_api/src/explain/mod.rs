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

mod event;
mod note;
mod output;
mod page;
mod sample;
mod shader;

use crate::context::Context;
use crate::draw;
use note::Note;
use page::Page;
use rasterizer::driver::{Command, PassDesc, Watch};
use rasterizer::trace::{Cleared, Fate, PixelEvent, Texel};
use std::fmt;
use thiserror::Error;

pub(crate) use note::DrawNote;

/// A pixel that is watched, and what is known of the draws and clears that were recorded.
#[derive(Debug)]
pub(crate) struct Watched {
    watch: Watch,
    /// By label.
    notes: Vec<Note>,
}

/// A pixel outside of the default framebuffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error(
    "pixel ({x}, {y}) is not in a default framebuffer of {width}×{height}: columns count from 0 at \
     the left, rows from 0 at the bottom"
)]
pub struct OutsideWindow {
    /// The column.
    pub x: u32,
    /// The row.
    pub y: u32,
    /// Columns that there are.
    pub width: u32,
    /// Rows that there are.
    pub height: u32,
}

/// How a pixel of the default framebuffer came to be. Its text ([`fmt::Display`]) is a page: what
/// happened, in order, and beside it the section of the specification.
#[derive(Debug)]
pub struct Explanation {
    /// Column and row; row 0 is the lowest.
    pub pixel: [u32; 2],
    /// Columns and rows of the default framebuffer.
    pub size: [u32; 2],
    /// What happened, oldest first.
    pub events: Vec<PixelEvent>,
    /// What the pixel holds now: red, green, blue, alpha as stored.
    pub value: [f32; 4],
    notes: Vec<Note>,
}

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
        // What was recorded before is not watched.
        draw::submit(self);
        self.watched = Some(Box::new(Watched { watch: Watch::new(x, y), notes: Vec::new() }));
        Ok(())
    }

    /// What happened to the watched pixel; `None` if none is watched. Ends the watch.
    pub fn explain_pixel(&mut self) -> Option<Explanation> {
        draw::submit(self);
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

/// Whether what a pass draws to is watched.
pub(crate) fn is_watched(context: &Context, pass: &PassDesc) -> bool {
    let window = &context.window.color;
    context.watched.is_some()
        && pass.colors.iter().flatten().any(|attachment| attachment.image.same(window))
}

/// Records that what comes next in the open pass, which is watched, is a draw.
pub(crate) fn watch_draw(context: &mut Context, note: DrawNote) {
    watch(context, Note::Draw(Box::new(note)));
}

/// Records that what comes next in the open pass, which is watched, are clears.
pub(crate) fn watch_clear(context: &mut Context) {
    watch(context, Note::Clear);
}

fn watch(context: &mut Context, note: Note) {
    let Some(watched) = &mut context.watched else { return };
    let label = watched.notes.len() as u32;
    watched.notes.push(note);
    context.recorder.push(Command::Watch(watched.watch.labelled(label)));
}

impl Explanation {
    /// What the last event left in the first sample of the pixel; `None` if nothing wrote a colour.
    pub fn last_write(&self) -> Option<Texel> {
        self.events.iter().rev().find_map(|event| match event {
            PixelEvent::Clear(clear) => match clear.target {
                Cleared::Color(0) => Some(clear.after),
                Cleared::Color(_) | Cleared::Depth | Cleared::Stencil => None,
            },
            PixelEvent::Fragment(fragment) => match fragment.fate {
                Fate::Written => {
                    let of_window = fragment.writes.iter().filter(|write| write.target == 0);
                    of_window.filter(|write| write.sample == 0).map(|write| write.after).next_back()
                }
                Fate::TestFailed | Fate::Discarded | Fate::NoColor | Fate::OverBudget => None,
            },
        })
    }

    fn note(&self, label: u32) -> Option<&Note> {
        self.notes.get(label as usize)
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut page = Page::default();
        let ([x, y], [width, height]) = (self.pixel, self.size);
        page.line(
            0,
            &format!(
                "pixel ({x}, {}) of {width}×{height}: column {x}, row {y} from the bottom",
                height - 1 - y
            ),
            "",
        );
        if self.events.is_empty() {
            page.line(0, "nothing was drawn here, and nothing cleared", "");
        }
        for event in &self.events {
            page.gap();
            match event {
                PixelEvent::Clear(clear) => event::clear(&mut page, clear),
                PixelEvent::Fragment(fragment) => {
                    let note = match self.note(fragment.label) {
                        Some(Note::Draw(note)) => Some(&**note),
                        Some(Note::Clear) | None => None,
                    };
                    event::fragment(&mut page, fragment, note);
                }
            }
        }
        page.gap();
        output::value(&mut page, self);
        f.write_str(&page.text())
    }
}
