//! What EGL refuses, and why (EGL 1.5, section 3.1).

use super::constants::*;
use super::raw::Int;
use super::thread::thread;
use crate::guard::enter_computing;
use gl_api::host::Echo;

/// EGL's name of a value, or its digits.
pub(super) fn name_of(value: impl TryInto<i64>) -> String {
    let Ok(value) = value.try_into() else { return "a value that EGL does not have".to_owned() };
    let found = i32::try_from(value).ok().and_then(|value| {
        let row = NAMES.binary_search_by_key(&value, |row| row.0).ok()?;
        Some(NAMES[row].1.to_owned())
    });
    found.unwrap_or_else(|| format!("{value:#x}"))
}

/// The error codes of EGL 1.5, table 3.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Code {
    NotInitialized,
    BadAccess,
    BadAlloc,
    BadAttribute,
    BadConfig,
    BadContext,
    BadDisplay,
    BadMatch,
    BadNativePixmap,
    BadNativeWindow,
    BadParameter,
    BadSurface,
    BadDevice,
}

impl Code {
    pub fn to_egl(self) -> Int {
        match self {
            Self::NotInitialized => EGL_NOT_INITIALIZED,
            Self::BadAccess => EGL_BAD_ACCESS,
            Self::BadAlloc => EGL_BAD_ALLOC,
            Self::BadAttribute => EGL_BAD_ATTRIBUTE,
            Self::BadConfig => EGL_BAD_CONFIG,
            Self::BadContext => EGL_BAD_CONTEXT,
            Self::BadDisplay => EGL_BAD_DISPLAY,
            Self::BadMatch => EGL_BAD_MATCH,
            Self::BadNativePixmap => EGL_BAD_NATIVE_PIXMAP,
            Self::BadNativeWindow => EGL_BAD_NATIVE_WINDOW,
            Self::BadParameter => EGL_BAD_PARAMETER,
            Self::BadSurface => EGL_BAD_SURFACE,
            Self::BadDevice => EGL_BAD_DEVICE_EXT,
        }
    }
}

impl Code {
    fn name(self) -> &'static str {
        match self {
            Self::NotInitialized => "EGL_NOT_INITIALIZED",
            Self::BadAccess => "EGL_BAD_ACCESS",
            Self::BadAlloc => "EGL_BAD_ALLOC",
            Self::BadAttribute => "EGL_BAD_ATTRIBUTE",
            Self::BadConfig => "EGL_BAD_CONFIG",
            Self::BadContext => "EGL_BAD_CONTEXT",
            Self::BadDisplay => "EGL_BAD_DISPLAY",
            Self::BadMatch => "EGL_BAD_MATCH",
            Self::BadNativePixmap => "EGL_BAD_NATIVE_PIXMAP",
            Self::BadNativeWindow => "EGL_BAD_NATIVE_WINDOW",
            Self::BadParameter => "EGL_BAD_PARAMETER",
            Self::BadSurface => "EGL_BAD_SURFACE",
            Self::BadDevice => "EGL_BAD_DEVICE_EXT",
        }
    }
}

/// A refused call.
#[derive(Debug)]
pub(crate) struct Error {
    pub code: Code,
    pub rule: String,
}

pub(crate) type Result<T> = std::result::Result<T, Error>;

pub(crate) fn fail<T>(code: Code, rule: impl Into<String>) -> Result<T> {
    Err(Error { code, rule: rule.into() })
}

/// What a function answers when it has failed.
pub(crate) trait Answer {
    const FAILURE: Self;
}

impl Answer for u32 {
    const FAILURE: u32 = 0;
}

impl<T> Answer for *const T {
    const FAILURE: *const T = std::ptr::null();
}

impl<T> Answer for *mut T {
    const FAILURE: *mut T = std::ptr::null_mut();
}

/// Prints a message if `DETGL_DEBUG` asks for them.
pub(super) fn say(severity: &str, text: &str) {
    if Echo::from_env() == Echo::All {
        eprintln!("detgl: {severity}: {text}");
    }
}

/// Runs a function: sets what `eglGetError` answers, and says why it failed if `DETGL_DEBUG` asks.
/// A panic is `EGL_BAD_ALLOC`.
pub(crate) fn call<R: Answer>(name: &str, f: impl FnOnce() -> Result<R>) -> R {
    let result = enter_computing(f)
        .unwrap_or_else(|_| fail(Code::BadAlloc, "DetGL failed inside this call"));
    match result {
        Ok(value) => {
            thread(|thread| thread.error.set(EGL_SUCCESS));
            value
        }
        Err(Error { code, rule }) => {
            say("error", &format!("{name}: {rule}; {}", code.name()));
            thread(|thread| thread.error.set(code.to_egl()));
            R::FAILURE
        }
    }
}
