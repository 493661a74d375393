//! EGL's constants, from the Khronos registry.
#![expect(dead_code, non_upper_case_globals, reason = "the whole registry with its own names")]

include!(concat!(env!("OUT_DIR"), "/egl.rs"));
