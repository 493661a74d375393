//! GLX's names: functions that fail, and say so once.

use super::*;
use std::process::Command;

type Function = extern "C" fn() -> isize;

unsafe extern "C" {
    fn glXGetProcAddress(name: *const c_char) -> Option<Function>;
    fn glXGetProcAddressARB(name: *const c_char) -> Option<Function>;
}

/// The function of a name, which the two functions that look for it agree on.
fn function(name: &CStr) -> Option<Function> {
    // SAFETY: a zero ends the name.
    let found = unsafe { [glXGetProcAddress(name.as_ptr()), glXGetProcAddressARB(name.as_ptr())] };
    let [first, second] = found.map(|found| found.map(|f| f as usize));
    assert_eq!(first, second, "{name:?}");
    found[0]
}

/// What functions answer by GLX 1.4 and their extensions: `GLX_NO_EXTENSION` is 3, `GLX_BAD_CONTEXT` 5.
const ANSWERS: [(&CStr, isize); 16] = [
    (c"glXGetCurrentDisplay", 0),
    (c"glXQueryExtension", 0),
    (c"glXQueryVersion", 0),
    (c"glXChooseVisual", 0),
    (c"glXGetFBConfigs", 0),
    (c"glXGetClientString", 0),
    (c"glXMakeContextCurrent", 0),
    (c"glXCreateContextAttribsARB", 0),
    (c"glXGetConfig", 3),
    (c"glXGetFBConfigAttrib", 3),
    (c"glXQueryContext", 5),
    (c"glXSwapIntervalEXT", 0),
    (c"glXSwapIntervalMESA", 5),
    (c"glXSwapIntervalSGI", 5),
    (c"glXSwapBuffersMscOML", -1),
    (c"glXQueryHyperpipeNetworkSGIX", 0),
];

#[test]
fn functions_of_glx_fail_as_it_says() {
    for (name, answer) in ANSWERS {
        let function = function(name).unwrap_or_else(|| panic!("{name:?}"));
        assert_eq!(function(), answer, "{name:?}");
    }
    for name in [c"glXGetProcAddress", c"glXGetProcAddressARB", c"glClear", c"eglMakeCurrent"] {
        assert!(function(name).is_some(), "{name:?}");
    }
    for name in [c"glXDoesNotExist", c"glDoesNotExist", c""] {
        assert!(function(name).is_none(), "{name:?}");
    }
}

#[test]
fn one_line_is_printed_in_a_process() {
    let this = std::env::current_exe().expect("a path");
    let test = "glx::functions_of_glx_fail_as_it_says";
    let output = Command::new(this).args(["--exact", test, "--nocapture"]).output().expect("runs");
    assert!(output.status.success());
    let text = String::from_utf8_lossy(&output.stderr);
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("detgl: ")).collect();
    let line =
        "detgl: glXQueryVersion fails, as DetGL has no GLX: make contexts with EGL or OSMesa";
    assert_eq!(lines, [line]);
}
