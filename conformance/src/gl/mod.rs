//! GL's functions under their own names: DetGL's, or, where a library was chosen, those that it exports to C. Checks call
//! these, so that they judge any GL.
//!
//! | module | is |
//! |---|---|
//! | `functions` | a function for each entry point of DetGL's table, which asks where it is to go |
//! | `value` | Rust's arguments as C takes them, and C's results |
//! | [`library`] | libEGL and the functions of its GL; contexts |
//!
//! `unsafe` code calls functions of another library; lengths of memory are what the checks pass.

#![allow(unsafe_code)]

mod functions;
pub mod library;
mod value;

pub use functions::*;
pub use gl_api::{Arg, BUFFER_OFFSET, Data, DataOut, NULL};

use gl_api::context::{Context, ContextDesc, Message, Severity};
use gl_api::{Current, with_current};
use library::ForeignContext;

/// A context that is current on this thread until it is dropped.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one at a time")]
pub enum CurrentContext {
    /// DetGL's.
    Own(Current),
    /// Another library's.
    Foreign(ForeignContext),
}

/// Makes a new context current, of the library that was chosen.
///
/// # Errors
/// The words of who refuses it.
pub fn open(desc: ContextDesc) -> Result<CurrentContext, String> {
    match library::chosen() {
        Some(library) => {
            library.context(&desc).map(CurrentContext::Foreign).map_err(|error| error.to_string())
        }
        None => {
            let context = Context::new(desc).map_err(|error| error.to_string())?;
            Ok(CurrentContext::Own(context.make_current()))
        }
    }
}

/// DetGL's message about its last error, or the functions that another library lacks.
pub fn last_error() -> String {
    if library::chosen().is_some() {
        return library::missing();
    }
    let messages = with_current(Context::messages).unwrap_or_default();
    let error = |message: &&Message| message.severity == Severity::Error;
    messages.iter().rfind(error).map_or_else(String::new, |message| message.text.clone())
}

/// What `glFeedbackBuffer` with [`NULL`] keeps.
pub fn feedback() -> Vec<f32> {
    match library::chosen() {
        Some(_) => value::kept_words().into_iter().map(f32::from_bits).collect(),
        None => with_current(|context| context.feedback().to_vec()).unwrap_or_default(),
    }
}

/// What `glSelectBuffer` with [`NULL`] keeps.
pub fn selection() -> Vec<u32> {
    match library::chosen() {
        Some(_) => value::kept_words(),
        None => with_current(|context| context.selection().to_vec()).unwrap_or_default(),
    }
}
