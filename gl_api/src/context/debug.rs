//! The error flag of `glGetError`, and the queue of messages that say what was wrong.
//!
//! Messages are queued; a callback ([`super::log`]) is called only when the call is over.

use super::log::{GLDEBUGPROC, Log, LogMessage, MAX_LENGTH, MessageClass};
use super::unoptimized;
use super::unread::{Unread, UnreadReport};
use crate::base::constants::*;
use crate::base::error::{ErrorCode, GlError};
use crate::base::types::*;
use crate::base::{float_environment, version};
use rasterizer::driver::DeviceDesc;
use std::collections::{BTreeSet, VecDeque};
use std::ffi::CString;
use std::io::Write;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};
use std::{fmt, io};
use texunit::lanes::FloatEnv;

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

/// An error or a warning of a context.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
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

/// Which messages are printed to stderr as they come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Echo {
    /// None, not even what is printed unasked: `DETGL_DEBUG=0`.
    Nothing,
    /// Only what is printed unasked: `DETGL_DEBUG` is not set.
    Unasked,
    /// All: `DETGL_DEBUG` is anything else.
    All,
}

impl Echo {
    /// What the environment variable `DETGL_DEBUG` asks for.
    pub fn from_env() -> Self {
        match std::env::var_os("DETGL_DEBUG") {
            Some(value) if value == "0" => Self::Nothing,
            Some(_) => Self::All,
            None => Self::Unasked,
        }
    }
}

/// The error flag, the queue of messages, and the log.
#[derive(Debug)]
pub(crate) struct Debug {
    /// The first error since `glGetError`.
    flag: Option<ErrorCode>,
    queue: VecDeque<Message>,
    /// Warnings that were given while the log was off, and while it was on: each is given once, and once more to a log
    /// that was off.
    given: [BTreeSet<String>; 2],
    echo: Echo,
    /// Messages that nobody has read.
    unread: Unread,
    /// What `KHR_debug` reads.
    pub log: Log,
    /// Whether messages are logged (`GL_DEBUG_OUTPUT`).
    pub output: Output,
    /// What it was initially: on in debug contexts.
    at_first: Output,
}

/// Whether messages go to the log of `KHR_debug`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Output {
    Off,
    On,
}

impl Debug {
    /// Prints what `DETGL_DEBUG` asks for to stderr, first the version. Where it is not set, one line says that there are
    /// messages.
    pub fn from_env(device: &DeviceDesc) -> Self {
        static GREETED: Once = Once::new();
        let echo = Echo::from_env();
        let report = match echo {
            Echo::Unasked => UnreadReport::Due,
            Echo::Nothing | Echo::All => UnreadReport::Off,
        };
        match echo {
            Echo::Nothing => {}
            Echo::Unasked => unoptimized::warn_once(print),
            Echo::All => {
                unoptimized::warn_once(print);
                GREETED.call_once(|| print(&greeting(device)));
            }
        }
        let mut debug = Self {
            flag: None,
            queue: VecDeque::new(),
            given: [const { BTreeSet::new() }; 2],
            log: Log::default(),
            output: Output::Off,
            at_first: Output::Off,
            echo,
            unread: Unread::new(report),
        };
        if !FloatEnv::IS_KNOWN {
            float_environment::warning().into_iter().for_each(|text| debug.warn(text));
        }
        debug
    }

    /// Sets the error flag and queues a message that says why.
    pub fn error(&mut self, call: &str, error: &GlError) {
        self.flag.get_or_insert(error.code());
        let text = format!("{call}: {error}");
        self.log(GL_DEBUG_TYPE_ERROR, error.code().to_gl(), GL_DEBUG_SEVERITY_HIGH, &text);
        self.push(Message { severity: Severity::Error, text });
    }

    /// Gives a warning once, which each draw would repeat.
    pub fn warn(&mut self, text: String) {
        let given = &mut self.given[self.output as usize];
        if given.len() >= KEPT {
            given.clear();
        }
        if given.insert(text.clone()) {
            self.warn_each_time(text);
        }
    }

    /// As [`Self::warn`]; the first of the process is printed to stderr even where nothing else is, unless
    /// `DETGL_DEBUG=0` wants nothing at all.
    pub fn warn_unasked(&mut self, text: &str) {
        static PRINTED: AtomicBool = AtomicBool::new(false);
        if self.echo == Echo::Unasked && !PRINTED.swap(true, Ordering::Relaxed) {
            print(&text);
        }
        self.warn(text.to_owned());
    }

    /// Gives a warning as often as it happens: of a compile or a link, which the application asked for.
    pub fn warn_each_time(&mut self, text: String) {
        self.log(GL_DEBUG_TYPE_OTHER, warning_id(&text), GL_DEBUG_SEVERITY_MEDIUM, &text);
        self.push(Message { severity: Severity::Warning, text });
    }

    /// Adds a message to the log, if that is on, cut to the length that its readers have room for (`KHR_debug`, section
    /// 5.5.1).
    fn log(&mut self, ty: GLenum, id: GLuint, severity: GLenum, text: &str) {
        if self.output == Output::On {
            let kind = MessageClass { source: GL_DEBUG_SOURCE_API, ty, severity };
            let text = &text[..text.floor_char_boundary(MAX_LENGTH - 1)];
            self.log.push(LogMessage { kind, id, text: text.to_owned() });
        }
    }

    /// Sets what a new context begins with.
    pub fn begin_with(&mut self, output: Output) {
        (self.output, self.at_first) = (output, output);
    }

    /// The bit of debug contexts in `GL_CONTEXT_FLAGS` (GL 3.0, table 6.47).
    pub fn context_flags(&self) -> GLenum {
        match self.at_first {
            Output::On => GL_CONTEXT_FLAG_DEBUG_BIT,
            Output::Off => 0,
        }
    }

    /// Calls the application's callback with the messages since its last call.
    pub fn deliver(&mut self) {
        if let Some((procedure, user, messages)) = self.log.deliver() {
            hand_over(procedure, user, messages);
        }
    }

    /// Whether messages are printed or logged as they come.
    pub fn listens(&self) -> bool {
        self.echo == Echo::All || self.output == Output::On
    }

    /// Takes the error flag.
    pub fn take_flag(&mut self) -> Option<ErrorCode> {
        self.flag.take()
    }

    /// Takes the messages, oldest first.
    pub fn drain(&mut self) -> Vec<Message> {
        self.unread.read();
        self.queue.drain(..).collect()
    }

    /// Notes that the application reads messages: it took the queue, read the log, or set a callback.
    pub fn read(&mut self) {
        self.unread.read();
    }

    /// At the end of a frame, says once that there are messages which nobody has read.
    pub fn end_of_frame(&mut self) {
        if let Some(line) = self.unread.end_of_frame() {
            print(&line);
        }
    }

    fn push(&mut self, message: Message) {
        self.unread.count(&message);
        if self.echo == Echo::All {
            print(&message);
        }
        if self.queue.len() == KEPT {
            self.queue.pop_front();
        }
        self.queue.push_back(message);
    }
}

/// Prints to stderr, ignoring that it may be closed.
fn print(what: &impl fmt::Display) {
    let _ = writeln!(io::stderr(), "detgl: {what}");
}

/// The first line on stderr: it shows that messages are on.
fn greeting(device: &DeviceDesc) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let (gl, isa, threads) = (version::reported(), device.isa.name(), device.threads);
    let s = if threads == 1 { "" } else { "s" };
    format!("DetGL {version}, OpenGL {gl}, {isa}, {threads} thread{s}")
}

/// The id of a warning in the log: a hash (FNV-1a) of the lowercase letters of its first
/// line, without what is quoted. So it is the same for all values, objects and names of constants.
fn warning_id(text: &str) -> GLuint {
    let line = text.lines().next().unwrap_or_default();
    let letters = line.split('"').step_by(2).flat_map(str::bytes).filter(u8::is_ascii_lowercase);
    letters.fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

#[cold]
#[inline(never)]
fn hand_over(procedure: GLDEBUGPROC, user: usize, messages: VecDeque<LogMessage>) {
    let Some(procedure) = procedure else { return };
    for LogMessage { kind, id, text } in messages {
        let length = text.len() as GLsizei;
        let bytes = CString::new(text.replace('\0', " ")).unwrap_or_default();
        let (source, ty, severity) = (kind.source, kind.ty, kind.severity);
        let user = user as *mut GLvoid;
        FloatEnv::in_host(|| procedure(source, ty, id, severity, length, bytes.as_ptr(), user));
    }
}
