//! The one runner of rows that a call is refused: the flag, the words of its message, and that no
//! query answers anything else than before.

use super::digest::{differences, digest};
use gl_api::*;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// What a row prepares (nothing, mostly), a call, the flag it must set, and words that its message
/// must have.
pub struct Row<'a> {
    /// Names the row where it fails.
    pub name: String,
    pub call: &'a dyn Fn(&mut Context),
    pub flag: GLenum,
    pub words: &'a str,
}

/// The calls that some row of this run was refused by.
static REFUSED: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// What has been refused so far.
pub fn refused() -> BTreeSet<String> {
    REFUSED.lock().expect("no runner panicked with it").clone()
}

/// Runs a row on a context, and checks all that a refusal promises; gives what is wrong. What a row
/// calls before the call that is refused shows up as a difference, so rows restore it, or
/// `prepared` says which answers they change.
pub fn run(c: &mut Context, row: &Row<'_>) -> Result<(), String> {
    let Row { name, call, flag, words } = row;
    if words.is_empty() {
        return Err(format!("{name}: no words that the message must have"));
    }
    let before = digest(c);
    call(c);
    let messages: Vec<String> = c.messages().iter().map(ToString::to_string).collect();
    let text = messages.join("\n");
    let error = c.get_error();
    if error != *flag {
        return Err(format!(
            "{name}: {} instead of {}: {text}",
            enum_name(error),
            enum_name(*flag)
        ));
    }
    if !text.contains(words) {
        return Err(format!("{name}: {text:?} lacks {words:?}"));
    }
    if c.get_error() != GL_NO_ERROR {
        return Err(format!("{name}: the flag was taken"));
    }
    let changed = differences(&before, &digest(c));
    if !changed.is_empty() {
        return Err(format!("{name}, {words:?}: {}", changed.join("; ")));
    }
    let mut refused = REFUSED.lock().expect("no runner panicked with it");
    for message in messages {
        let call = message.strip_prefix("error: ").and_then(|text| text.split(':').next());
        refused.extend(call.map(str::to_owned));
    }
    Ok(())
}
