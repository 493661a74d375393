//! An explanation of a pixel, and its page of text.

use crate::context::watched_pixel::CommandNote;
use crate::explain::page::Page;
use rasterizer::trace::{Cleared, Fate, PixelEvent, Texel};
use std::fmt;
use thiserror::Error;

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
#[non_exhaustive]
pub struct Explanation {
    /// Column and row; row 0 is the lowest.
    pub pixel: [u32; 2],
    /// Columns and rows of the default framebuffer.
    pub size: [u32; 2],
    /// What happened, oldest first.
    pub events: Vec<PixelEvent>,
    /// What the pixel holds now: red, green, blue, alpha as stored.
    pub value: [f32; 4],
    pub(crate) notes: Vec<CommandNote>,
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

    fn note(&self, label: u32) -> Option<&CommandNote> {
        self.notes.get(label as usize)
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut page = Page::default();
        let ([x, y], [width, height]) = (self.pixel, self.size);
        page.line(
            0,
            &format!("pixel ({x}, {y}) of {width}×{height}: column {x}, row {y} from the bottom"),
            "",
        );
        if self.events.is_empty() {
            page.line(0, "nothing was drawn here, and nothing cleared", "");
        }
        for event in &self.events {
            page.gap();
            match event {
                PixelEvent::Clear(clear) => crate::explain::event::clear(&mut page, clear),
                PixelEvent::Fragment(fragment) => {
                    let note = match self.note(fragment.label) {
                        Some(CommandNote::Draw(note)) => Some(&**note),
                        Some(CommandNote::Clear) | None => None,
                    };
                    crate::explain::event::fragment(&mut page, fragment, note);
                }
            }
        }
        page.gap();
        crate::explain::output::value(&mut page, self);
        f.write_str(&page.text())
    }
}
