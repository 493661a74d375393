//! The sticky error flag, and the messages that say what was wrong.
//!
//! Messages are queued and never call back, so that nothing happens in the middle of a call.

use crate::error::{ErrorCode, GlError};
use std::collections::{BTreeSet, VecDeque};
use std::fmt;

/// The queue keeps this many messages; older ones are dropped.
const KEPT: usize = 1024;

/// How much a message matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// A call was refused; an error flag was set.
    Error,
    /// The call was carried out, but the picture may not be what was meant.
    Warning,
}

/// Something that the context has to say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// How much it matters.
    pub severity: Severity,
    /// The call, the argument and the rule.
    pub text: String,
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        write!(f, "{severity}: {}", self.text)
    }
}

/// Whether messages are printed as they come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Echo {
    Off,
    Stderr,
}

/// The flag and the queue.
#[derive(Debug)]
pub(crate) struct Debug {
    /// The first error since `glGetError`.
    flag: Option<ErrorCode>,
    queue: VecDeque<Message>,
    /// Warnings that were given: a draw that repeats says them once.
    given: BTreeSet<String>,
    echo: Echo,
}

impl Debug {
    /// Prints to stderr if `DETGL_DEBUG` is set to anything but 0.
    pub fn from_env() -> Self {
        let on = std::env::var_os("DETGL_DEBUG").is_some_and(|value| value != "0");
        Self {
            flag: None,
            queue: VecDeque::new(),
            given: BTreeSet::new(),
            echo: if on { Echo::Stderr } else { Echo::Off },
        }
    }

    /// Sets the flag and says why.
    pub fn error(&mut self, call: &str, error: &GlError) {
        self.flag.get_or_insert(error.code);
        self.push(Message { severity: Severity::Error, text: format!("{call}: {error}") });
    }

    /// Says something once.
    pub fn warn(&mut self, text: String) {
        if self.given.len() >= KEPT {
            self.given.clear();
        }
        if self.given.insert(text.clone()) {
            self.push(Message { severity: Severity::Warning, text });
        }
    }

    /// Takes the flag.
    pub fn take_flag(&mut self) -> Option<ErrorCode> {
        self.flag.take()
    }

    /// Takes the messages, oldest first.
    pub fn drain(&mut self) -> Vec<Message> {
        self.queue.drain(..).collect()
    }

    fn push(&mut self, message: Message) {
        if self.echo == Echo::Stderr {
            eprintln!("detgl: {message}");
        }
        if self.queue.len() == KEPT {
            self.queue.pop_front();
        }
        self.queue.push_back(message);
    }
}
