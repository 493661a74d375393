//! `KHR_debug`: the message log, its filters, groups and labels, and the callback.
//!
//! The log has the messages of [`super::debug`], and those that the application inserts. The callback is called when the
//! call that caused a message is over, never in its middle.

use crate::base::constants::*;
use crate::base::types::*;
use std::collections::{BTreeMap, VecDeque};

/// `GL_MAX_DEBUG_LOGGED_MESSAGES`.
pub(crate) const MAX_LOGGED: usize = 256;
/// `GL_MAX_DEBUG_MESSAGE_LENGTH`, with C's final zero.
pub(crate) const MAX_LENGTH: usize = 4096;
/// `GL_MAX_DEBUG_GROUP_STACK_DEPTH`, with the one that is always there.
pub(crate) const MAX_GROUPS: usize = 64;
/// `GL_MAX_LABEL_LENGTH`, with C's final zero.
pub(crate) const MAX_LABEL: usize = 256;
/// More filters than this in a group are forgotten, oldest first.
const MAX_FILTERS: usize = 1024;

/// The callback of an application: source, type, id, severity, length, text, and its own pointer.
pub type GLDEBUGPROC =
    Option<extern "system" fn(GLenum, GLenum, GLuint, GLenum, GLsizei, *const GLchar, *mut GLvoid)>;

/// Source, type and severity of a message; each may be `GL_DONT_CARE` in a filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MessageClass {
    pub source: GLenum,
    pub ty: GLenum,
    pub severity: GLenum,
}

/// A message of the log.
#[derive(Clone, Debug)]
pub(crate) struct LogMessage {
    pub kind: MessageClass,
    pub id: GLuint,
    pub text: String,
}

/// A filter; the last one that fits a message decides whether it is logged.
#[derive(Clone, Debug)]
pub(crate) struct Filter {
    pub kind: MessageClass,
    /// Only messages with these ids, unless there are none.
    pub ids: Vec<GLuint>,
    pub on: bool,
}

impl Filter {
    fn fits(&self, message: &LogMessage) -> bool {
        let fits = |filter: GLenum, value: GLenum| filter == GL_DONT_CARE || filter == value;
        fits(self.kind.source, message.kind.source)
            && fits(self.kind.ty, message.kind.ty)
            && fits(self.kind.severity, message.kind.severity)
            && (self.ids.is_empty() || self.ids.contains(&message.id))
    }
}

/// A debug group: the message that began it, and its filters.
#[derive(Clone, Debug, Default)]
struct MessageGroup {
    begin: Option<LogMessage>,
    filters: Vec<Filter>,
}

/// The callback, which gets messages instead of the log.
#[derive(Clone, Copy, Debug, Default)]
struct Callback {
    procedure: GLDEBUGPROC,
    /// The application's pointer.
    user: usize,
}

/// The log.
#[derive(Debug)]
pub(crate) struct Log {
    queue: VecDeque<LogMessage>,
    /// Messages for the callback; those that were logged before it was set stay in the log.
    pending: VecDeque<LogMessage>,
    callback: Callback,
    /// The groups that are open; the first always is.
    groups: Vec<MessageGroup>,
    /// Labels by kind and name of the object.
    pub labels: BTreeMap<(GLenum, usize), String>,
}

impl Default for Log {
    fn default() -> Self {
        Self {
            queue: VecDeque::new(),
            pending: VecDeque::new(),
            callback: Callback::default(),
            groups: vec![MessageGroup::default()],
            labels: BTreeMap::new(),
        }
    }
}

impl Log {
    fn lets_through(&self, message: &LogMessage) -> bool {
        let filters = self.groups.last().map_or(&[][..], |group| &group.filters);
        match filters.iter().rev().find(|filter| filter.fits(message)) {
            Some(filter) => filter.on,
            // KHR_debug, section 5.5.4: messages of low severity are off at first.
            None => message.kind.severity != GL_DEBUG_SEVERITY_LOW,
        }
    }

    /// Adds a message, if the filters let it through; a full log drops it.
    pub fn push(&mut self, message: LogMessage) {
        let lets_through = self.lets_through(&message);
        let queue = match self.callback.procedure {
            Some(_) => &mut self.pending,
            None => &mut self.queue,
        };
        if queue.len() < MAX_LOGGED && lets_through {
            queue.push_back(message);
        }
    }

    /// Takes the messages for the callback, if there is one.
    pub fn deliver(&mut self) -> Option<(GLDEBUGPROC, usize, VecDeque<LogMessage>)> {
        if self.callback.procedure.is_none() || self.pending.is_empty() {
            return None;
        }
        let Callback { procedure, user } = self.callback;
        Some((procedure, user, std::mem::take(&mut self.pending)))
    }

    pub fn set_callback(&mut self, procedure: GLDEBUGPROC, user: usize) {
        self.callback = Callback { procedure, user };
    }

    /// The callback's user pointer.
    pub fn user(&self) -> usize {
        self.callback.user
    }

    /// The callback as an address.
    pub fn procedure(&self) -> usize {
        self.callback.procedure.map_or(0, |procedure| procedure as usize)
    }

    pub fn add_filter(&mut self, filter: Filter) {
        let Some(group) = self.groups.last_mut() else { return };
        if group.filters.len() == MAX_FILTERS {
            group.filters.remove(0);
        }
        group.filters.push(filter);
    }

    /// How many groups are open.
    pub fn depth(&self) -> usize {
        self.groups.len()
    }

    /// Opens a group; there must be room.
    pub fn push_group(&mut self, begin: LogMessage) {
        self.push(begin.clone());
        let filters = self.groups.last().map_or(Vec::new(), |group| group.filters.clone());
        self.groups.push(MessageGroup { begin: Some(begin), filters });
    }

    /// Closes a group; one besides the first must be open.
    pub fn pop_group(&mut self) {
        let Some(mut begin) = self.groups.pop().and_then(|group| group.begin) else { return };
        begin.kind.ty = GL_DEBUG_TYPE_POP_GROUP;
        self.push(begin);
    }

    /// How many messages are in the log.
    pub fn len(&self) -> usize {
        self.queue.len()
    }

    /// The oldest message.
    pub fn first(&self) -> Option<&LogMessage> {
        self.queue.front()
    }

    /// Takes the oldest message.
    pub fn pop(&mut self) -> Option<LogMessage> {
        self.queue.pop_front()
    }
}
