//! The sticky error flag, and the messages that say what was wrong.
//!
//! Messages are queued and never call back, so that nothing happens in the middle of a call.

use super::log::{GLDEBUGPROC, Kind, Log, Logged};
use crate::constants::*;
use crate::error::{ErrorCode, GlError};
use crate::types::*;
use std::collections::{BTreeSet, VecDeque};
use std::ffi::CString;
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
    /// What `KHR_debug` reads.
    pub log: Log,
    /// Whether it is kept (`GL_DEBUG_OUTPUT`).
    pub output: Output,
}

/// Whether messages go to the log of `KHR_debug`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Output {
    Off,
    On,
}

impl Debug {
    /// Prints to stderr if `DETGL_DEBUG` is set to anything but 0.
    pub fn from_env() -> Self {
        let on = std::env::var_os("DETGL_DEBUG").is_some_and(|value| value != "0");
        Self {
            flag: None,
            queue: VecDeque::new(),
            given: BTreeSet::new(),
            log: Log::default(),
            output: Output::Off,
            echo: if on { Echo::Stderr } else { Echo::Off },
        }
    }

    /// Sets the flag and says why.
    pub fn error(&mut self, call: &str, error: &GlError) {
        self.flag.get_or_insert(error.code);
        let text = format!("{call}: {error}");
        self.log(GL_DEBUG_TYPE_ERROR, error.code.to_gl(), GL_DEBUG_SEVERITY_HIGH, &text);
        self.push(Message { severity: Severity::Error, text });
    }

    /// Says something once.
    pub fn warn(&mut self, text: String) {
        if self.given.len() >= KEPT {
            self.given.clear();
        }
        if self.given.insert(text.clone()) {
            self.log(GL_DEBUG_TYPE_OTHER, 0, GL_DEBUG_SEVERITY_MEDIUM, &text);
            self.push(Message { severity: Severity::Warning, text });
        }
    }

    /// Adds a message of ours to the log, if it is kept.
    fn log(&mut self, ty: GLenum, id: GLuint, severity: GLenum, text: &str) {
        if self.output == Output::On {
            let kind = Kind { source: GL_DEBUG_SOURCE_API, ty, severity };
            self.log.push(Logged { kind, id, text: text.to_owned() });
        }
    }

    /// Calls the program's callback with what the log has gathered.
    pub fn deliver(&mut self) {
        if let Some((procedure, user, messages)) = self.log.deliver() {
            hand_over(procedure, user, messages);
        }
    }

    /// Whether somebody asks for messages as they come.
    pub fn listens(&self) -> bool {
        self.echo == Echo::Stderr || self.output == Output::On
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

#[cold]
#[inline(never)]
fn hand_over(procedure: GLDEBUGPROC, user: usize, messages: VecDeque<Logged>) {
    let Some(procedure) = procedure else { return };
    for Logged { kind, id, text } in messages {
        let length = text.len() as GLsizei;
        let bytes = CString::new(text.replace('\0', " ")).unwrap_or_default();
        let (source, ty, severity) = (kind.source, kind.ty, kind.severity);
        procedure(source, ty, id, severity, length, bytes.as_ptr(), user as *mut GLvoid);
    }
}
