//! Errors and warnings that nobody reads: one line on stderr at the end of a frame says so, once in a process.
//!
//! A program without a callback, that reads no log and runs without `DETGL_DEBUG`, would else not know that there is
//! anything to read.

use super::debug::{Message, Severity};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the line is to be printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnreadReport {
    /// At the end of the first frame with messages.
    Due,
    /// Somebody reads messages, or does not want to: `DETGL_DEBUG` is set.
    Off,
}

/// The messages since the context was made, as long as nobody has read one.
#[derive(Debug)]
pub(crate) struct Unread {
    report: UnreadReport,
    errors: u32,
    warnings: u32,
    /// The first line of the first message.
    first: Option<String>,
}

impl Unread {
    pub fn new(report: UnreadReport) -> Self {
        Self { report, errors: 0, warnings: 0, first: None }
    }

    /// Counts a message.
    pub fn count(&mut self, message: &Message) {
        if self.report == UnreadReport::Off {
            return;
        }
        match message.severity {
            Severity::Error => self.errors = self.errors.saturating_add(1),
            Severity::Warning => self.warnings = self.warnings.saturating_add(1),
        }
        let line = || message.to_string().lines().next().unwrap_or_default().to_owned();
        self.first.get_or_insert_with(line);
    }

    /// Notes that the application reads messages.
    pub fn read(&mut self) {
        *self = Self::new(UnreadReport::Off);
    }

    /// The line for the end of a frame, if it is due.
    pub fn end_of_frame(&mut self) -> Option<String> {
        static PRINTED: AtomicBool = AtomicBool::new(false);
        let first = self.first.take()?;
        let counted = |count: u32, one: &str| match count {
            0 => None,
            1 => Some(format!("1 {one}")),
            _ => Some(format!("{count} {one}s")),
        };
        let counts = [counted(self.errors, "error"), counted(self.warnings, "warning")];
        let counts = counts.into_iter().flatten().collect::<Vec<_>>().join(" and ");
        self.read();
        let is_first = !PRINTED.swap(true, Ordering::Relaxed);
        is_first.then(|| {
            format!(
                "{counts} that nobody read; the first, {first} (DETGL_DEBUG=1 prints all, DETGL_DEBUG=0 not even this)"
            )
        })
    }
}
