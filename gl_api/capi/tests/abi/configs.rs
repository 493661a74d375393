//! Platforms, devices, configs and the attributes of contexts.

use super::*;
use std::ffi::CStr;
use std::ptr::null;

#[test]
fn versions_that_are_not_there_are_refused() {
    let (dpy, config) = display();
    for (major, minor, there) in [
        (1, 0, true),
        (1, 5, true),
        (2, 1, true),
        (2, 2, false),
        (3, 0, true),
        (3, 1, true),
        (3, 2, true),
        (3, 3, true),
        (4, 0, false),
    ] {
        let list = [0x3098, major, 0x30FB, minor, EGL_NONE];
        // SAFETY: the list ends with EGL_NONE.
        unsafe {
            let context = eglCreateContext(dpy, config, null_mut(), list.as_ptr());
            assert_eq!(!context.is_null(), there, "{major}.{minor}");
            assert_eq!(eglGetError(), if there { EGL_SUCCESS } else { EGL_BAD_MATCH });
            eglDestroyContext(dpy, context);
        }
    }
}

/// Contexts of OpenGL ES 2.0 and 3.0 are there once its API is bound, which it is at first; they share objects with each
/// other, not with those of OpenGL.
#[test]
fn contexts_of_opengl_es_are_made_by_their_versions() {
    let (dpy, config) = display();
    // SAFETY: lists end with EGL_NONE.
    let context = |major, share| unsafe {
        let list = [0x3098, major, EGL_NONE];
        eglCreateContext(dpy, config, share, list.as_ptr())
    };
    // SAFETY: no pointers.
    let error = || unsafe { eglGetError() };
    // SAFETY: no pointers.
    assert_eq!(unsafe { eglBindAPI(EGL_OPENGL_API) }, 1);
    let desktop = context(3, null_mut());
    assert!(!desktop.is_null());
    // SAFETY: no pointers.
    assert_eq!(unsafe { eglBindAPI(EGL_OPENGL_ES_API) }, 1);
    let first = context(2, null_mut());
    let second = context(3, first);
    assert!(!first.is_null() && !second.is_null());
    assert!(context(1, null_mut()).is_null());
    assert_eq!(error(), EGL_BAD_MATCH);
    assert!(context(3, desktop).is_null());
    assert_eq!(error(), EGL_BAD_CONTEXT);
    // SAFETY: the handles are those above; what is written to is a number.
    unsafe {
        let mut client = 0;
        assert_eq!(eglQueryContext(dpy, first, 0x3097, &raw mut client), 1);
        assert_eq!(client, EGL_OPENGL_ES_API as i32);
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), second), 1);
        let version = CStr::from_ptr(glGetString(0x1F02)).to_str().expect("ASCII");
        assert!(version.starts_with("OpenGL ES 3.0"), "{version}");
        eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut());
        for context in [desktop, first, second] {
            eglDestroyContext(dpy, context);
        }
        eglBindAPI(EGL_OPENGL_API);
    }
}

/// Words of a string that the library keeps.
fn words(dpy: Handle, name: i32) -> Vec<&'static str> {
    // SAFETY: null or the library's own, ended by a zero.
    let text = unsafe { CStr::from_ptr(eglQueryString(dpy, name)) };
    text.to_str().expect("ASCII").split(' ').collect()
}

#[test]
fn every_platform_has_a_display_that_draws() {
    let clients = words(null_mut(), 0x3055);
    for name in [
        "EGL_EXT_client_extensions",
        "EGL_EXT_device_enumeration",
        "EGL_EXT_device_query",
        "EGL_EXT_platform_base",
        "EGL_EXT_platform_device",
        "EGL_MESA_platform_surfaceless",
    ] {
        assert!(clients.contains(&name), "{name}");
    }
    let (mut device, mut number) = (null_mut(), 0);
    // SAFETY: every pointer is a local that is large enough.
    unsafe {
        assert_eq!(eglQueryDevicesEXT(1, &mut device, &mut number), 1);
        assert_eq!(number, 1);
        let platforms = [
            eglGetDisplay(null_mut()),
            eglGetPlatformDisplay(0x31DD, null_mut(), null()),
            eglGetPlatformDisplay(0x313F, device, null()),
        ];
        for dpy in platforms {
            assert_eq!(eglInitialize(dpy, null_mut(), null_mut()), 1);
            let extensions = words(dpy, 0x3055);
            for name in [
                "EGL_KHR_create_context",
                "EGL_KHR_surfaceless_context",
                "EGL_KHR_no_config_context",
            ] {
                assert!(extensions.contains(&name), "{name}");
            }
            assert_eq!(eglBindAPI(EGL_OPENGL_API), 1);
            let context = eglCreateContext(dpy, null_mut(), null_mut(), null());
            assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
            assert_eq!(glGetError(), gl_api::GL_NO_ERROR);
            assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
        }
        for (platform, native) in [(0x31D7, null_mut()), (0x313F, null_mut()), (0x31DD, device)] {
            assert!(eglGetPlatformDisplay(platform, native, null()).is_null(), "{platform:#x}");
            assert_eq!(eglGetError(), 0x300C, "{platform:#x}");
        }
        // What is gone with its display; nothing else of this test program uses it.
        assert_eq!(eglTerminate(platforms[2]), 1);
        assert!(eglCreateContext(platforms[2], null_mut(), null_mut(), null()).is_null());
        assert_eq!(eglGetError(), 0x3001);
    }
}

#[test]
fn configs_are_found_by_what_they_have() {
    let (dpy, _) = display();
    let number = |list: &[i32]| {
        let mut number = 0;
        // SAFETY: the list ends with EGL_NONE; only the number is asked for.
        unsafe { eglChooseConfig(dpy, list.as_ptr(), null_mut(), 0, &mut number) };
        number
    };
    let pbuffer = [0x3033, 1];
    for (what, wanted, there) in [
        ("pbuffers of any API", &[][..], true),
        ("OpenGL", &[0x3040, 8], true),
        ("OpenGL ES 2", &[0x3040, 4], true),
        ("OpenGL ES 3", &[0x3040, 0x40], true),
        ("OpenGL ES 1", &[0x3040, 1], false),
        ("RGBA8, depth 24, stencil 8", &[0x3021, 8, 0x3025, 24, 0x3026, 8], true),
        ("depth 16 at least", &[0x3025, 16], true),
        ("depth 32", &[0x3025, 32], false),
        ("4 samples", &[0x3032, 1, 0x3031, 4], true),
        ("8 samples", &[0x3032, 1, 0x3031, 8], false),
        ("10 bits of red", &[0x3024, 10], false),
    ] {
        let list = [&pbuffer[..], wanted, &[EGL_NONE]].concat();
        assert_eq!(number(&list) > 0, there, "{what}");
    }
    // Windows are what EGL looks for when nothing is said.
    assert_eq!(number(&[EGL_NONE]), 0);
    assert_eq!(number(&[0x3033, 4, EGL_NONE]), 0);
}

#[test]
fn contexts_are_what_was_asked_for_or_refused() {
    let (dpy, config) = display();
    for (what, list, error) in [
        ("2.1, compatibility", &[0x3098, 2, 0x30FB, 1, 0x30FD, 2][..], EGL_SUCCESS),
        ("2.1, core, which 2.1 ignores", &[0x3098, 2, 0x30FB, 1, 0x30FD, 1], EGL_SUCCESS),
        ("3.0", &[0x3098, 3, 0x30FB, 0], EGL_SUCCESS),
        ("3.0, forward compatible: core", &[0x3098, 3, 0x30FB, 0, 0x31B1, 1], EGL_SUCCESS),
        ("3.1", &[0x3098, 3, 0x30FB, 1], EGL_SUCCESS),
        ("3.1, core, which 3.1 ignores", &[0x3098, 3, 0x30FB, 1, 0x30FD, 1], EGL_SUCCESS),
        ("3.1, forward compatible: core", &[0x3098, 3, 0x30FB, 1, 0x31B1, 1], EGL_SUCCESS),
        ("3.2: core", &[0x3098, 3, 0x30FB, 2], EGL_SUCCESS),
        ("debug", &[0x31B0, 1], EGL_SUCCESS),
        ("robust", &[0x31B2, 1], EGL_SUCCESS),
        ("flags: debug", &[0x30FC, 1], EGL_SUCCESS),
        ("flags: forward compatible", &[0x30FC, 2], EGL_BAD_MATCH),
        ("forward compatible", &[0x31B1, 1], EGL_BAD_MATCH),
        ("flags that are none", &[0x30FC, 64], EGL_BAD_ATTRIBUTE),
        ("3.2: core, asked for", &[0x3098, 3, 0x30FB, 2, 0x30FD, 1], EGL_SUCCESS),
        ("3.3: core, forward compatible", &[0x3098, 3, 0x30FB, 3, 0x30FC, 2], EGL_SUCCESS),
        ("3.3, compatibility", &[0x3098, 3, 0x30FB, 3, 0x30FD, 2], EGL_SUCCESS),
        ("3.3, of no profile", &[0x3098, 3, 0x30FB, 3, 0x30FD, 0], EGL_BAD_MATCH),
        ("3.3, of both profiles", &[0x3098, 3, 0x30FB, 3, 0x30FD, 3], EGL_BAD_MATCH),
        ("4.6 compatibility", &[0x3098, 4, 0x30FB, 6, 0x30FD, 2], EGL_BAD_MATCH),
        ("a version that never was", &[0x3098, 2, 0x30FB, 7], EGL_BAD_MATCH),
        ("an attribute of surfaces", &[0x3057, 4], EGL_BAD_ATTRIBUTE),
        ("no reset notification", &[0x31BD, 0x31BE], EGL_SUCCESS),
        ("lose the context on reset, as of EXT", &[0x3138, 0x31BF], EGL_SUCCESS),
        ("a strategy that is none", &[0x31BD, 0x77], EGL_BAD_ATTRIBUTE),
        ("a strategy of EXT that is none", &[0x3138, 0x77], EGL_BAD_ATTRIBUTE),
        ("without errors", &[0x31B3, 1], EGL_SUCCESS),
        ("without errors, but with debugging", &[0x31B3, 1, 0x31B0, 1], EGL_BAD_MATCH),
        ("without errors, flags: with debugging", &[0x30FC, 1, 0x31B3, 1], EGL_BAD_MATCH),
        ("without errors, but robust", &[0x31B2, 1, 0x31B3, 1], EGL_BAD_MATCH),
        ("with errors and debugging", &[0x31B3, 0, 0x31B0, 1], EGL_SUCCESS),
    ] {
        let list = [list, &[EGL_NONE]].concat();
        // SAFETY: the list ends with EGL_NONE.
        unsafe {
            let context = eglCreateContext(dpy, config, null_mut(), list.as_ptr());
            assert_eq!(eglGetError(), error, "{what}");
            assert_eq!(context.is_null(), error != EGL_SUCCESS, "{what}");
            if !context.is_null() {
                // The log of messages is on in debug contexts (`KHR_debug`).
                let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
                assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
                let logs = glIsEnabled(gl_api::GL_DEBUG_OUTPUT) != 0;
                assert_eq!(logs, what.contains("debug"), "{what}");
                let mut flags = -1;
                glDisable(gl_api::GL_DEBUG_OUTPUT);
                glGetIntegerv(gl_api::GL_CONTEXT_FLAGS, &mut flags);
                let mut bit = if logs { gl_api::GL_CONTEXT_FLAG_DEBUG_BIT } else { 0 };
                if what.contains("forward compatible") {
                    bit |= gl_api::GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT;
                }
                let mut mask = -1;
                glGetIntegerv(gl_api::GL_CONTEXT_PROFILE_MASK, &mut mask);
                assert_eq!(mask, if what.contains(": core") { 1 } else { 2 }, "{what}");
                assert_eq!(flags as u32, bit, "{what}: of the context, whatever is enabled later");
                let mut strategy = -1;
                glGetIntegerv(gl_api::GL_RESET_NOTIFICATION_STRATEGY, &mut strategy);
                let asked = if what.contains("lose") {
                    gl_api::GL_LOSE_CONTEXT_ON_RESET
                } else {
                    gl_api::GL_NO_RESET_NOTIFICATION
                };
                assert_eq!(strategy as u32, asked, "{what}");
                assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), null_mut()), 1);
            }
        }
    }
}

/// Where this is set, the test below is the child that asks for configs.
const CHILD: &str = "DETGL_TEST_CONFIGS";

/// Runs itself once more, to read what is printed.
#[test]
fn a_request_that_no_config_meets_says_why() {
    const NAME: &str = "configs::a_request_that_no_config_meets_says_why";
    if std::env::var_os(CHILD).is_some() {
        let (dpy, _) = display();
        let choose = |list: &[i32]| {
            let (mut config, mut count) = (null_mut(), 9);
            // SAFETY: the list ends with EGL_NONE, and there is room for one config.
            let answer = unsafe { eglChooseConfig(dpy, list.as_ptr(), &mut config, 1, &mut count) };
            (answer, count)
        };
        assert_eq!(choose(&[EGL_NONE]), (1, 0));
        assert_eq!(choose(&[0x3033, 1, 0x3025, 64, EGL_NONE]), (1, 0));
        assert_eq!(choose(&[0x3033, 1, 0x3040, 8, EGL_NONE]), (1, 1));
        return;
    }
    let mut child = std::process::Command::new(std::env::current_exe().expect("a file"));
    child.args(["--exact", NAME, "--nocapture"]).env(CHILD, "1").env("DETGL_DEBUG", "1");
    let output = child.output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    let lines: Vec<&str> = said.lines().filter(|line| line.contains("eglChooseConfig")).collect();
    assert_eq!(lines.len(), 2, "{said}");
    assert!(lines[0].contains("there are no windows: ask for EGL_PBUFFER_BIT"), "{said}");
    assert!(lines[1].contains("none meets attribute EGL_DEPTH_SIZE = 64"), "{said}");
}

/// Attributes of configs, a value that is a possible one and one that is none.
const VALUES: [(i32, i32, i32); 18] = [
    (0x3024, 0, -5),
    (0x3024, -1, -2),
    (0x3031, 8, -2),
    (0x3032, 1, 2),
    (0x3039, 1, 3),
    (0x3039, -1, -3),
    (0x303F, 0x308F, 77),
    (0x3027, 0x3051, 77),
    (0x3028, 9999, 0),
    (0x3028, -1, -3),
    (0x3042, 0x48, 0x10_0000),
    (0x3040, -1, 0x10_0000),
    (0x3033, 0x400, i32::MIN),
    (0x3029, -5, -1),
    (0x302D, 1, 5),
    (0x3034, 0x3052, 77),
    (0x302C, 100, -2),
    (0x3339, 0x333B, 77),
];

#[test]
fn values_that_no_config_could_have_are_refused() {
    let (dpy, _) = display();
    for (attribute, possible, impossible) in VALUES {
        for (value, there) in [(possible, 1), (impossible, 0)] {
            let (list, mut number) = ([attribute, value, EGL_NONE], -7);
            // SAFETY: the list ends with EGL_NONE; only the number is asked for.
            let found = unsafe { eglChooseConfig(dpy, list.as_ptr(), null_mut(), 0, &mut number) };
            assert_eq!(found, there, "{attribute:#x} {value:#x}");
            assert_eq!(number == -7, there == 0, "{attribute:#x} {value:#x}");
            // SAFETY: no pointers.
            let error = unsafe { eglGetError() };
            assert_eq!(error, [EGL_BAD_ATTRIBUTE, EGL_SUCCESS][found as usize]);
        }
    }
}

#[test]
fn values_of_surfaces_attributes_are_refused_as_unknown_or_as_not_there() {
    let (dpy, config) = display();
    for (attribute, value, error) in [
        (0x3080, 0x305C, EGL_SUCCESS),
        (0x3080, 0x305E, EGL_BAD_MATCH),
        (0x3080, 0x77, EGL_BAD_ATTRIBUTE),
        (0x3081, 0x305C, EGL_SUCCESS),
        (0x3081, 0x305F, EGL_BAD_MATCH),
        (0x3081, 0x77, EGL_BAD_ATTRIBUTE),
        (0x3087, 0x3089, EGL_SUCCESS),
        (0x309D, 0x308A, EGL_SUCCESS),
        (0x309D, 0x3089, EGL_BAD_MATCH),
        (0x309D, 1, EGL_BAD_ATTRIBUTE),
    ] {
        let list = [0x3057, 4, 0x3056, 4, attribute, value, EGL_NONE];
        // SAFETY: the list ends with EGL_NONE.
        unsafe {
            let surface = eglCreatePbufferSurface(dpy, config, list.as_ptr());
            assert_eq!(eglGetError(), error, "{attribute:#x} {value:#x}");
            assert_eq!(surface.is_null(), error != EGL_SUCCESS, "{attribute:#x} {value:#x}");
        }
    }
    // SAFETY: the list ends with EGL_NONE; handles are only looked up.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        for (attribute, value, error) in [
            (0x3093, 0x3094, EGL_SUCCESS),
            (0x3093, 0x3095, EGL_SUCCESS),
            (0x3093, 77, EGL_BAD_ATTRIBUTE),
            (0x3099, 0x309A, EGL_SUCCESS),
            (0x3099, 0x309B, EGL_BAD_MATCH),
            (0x3099, 7, EGL_BAD_ATTRIBUTE),
            (0x3057, 1, EGL_BAD_ATTRIBUTE),
        ] {
            let set = eglSurfaceAttrib(dpy, surface, attribute, value);
            assert_eq!(eglGetError(), error, "{attribute:#x} {value:#x}");
            assert_eq!(set == 1, error == EGL_SUCCESS, "{attribute:#x} {value:#x}");
        }
        // EGL_SWAP_BEHAVIOR and EGL_MIPMAP_LEVEL are what they were set to.
        for (attribute, values) in [(0x3093, [0x3095, 0x3094]), (0x3083, [3, 0])] {
            for value in values {
                assert_eq!(eglSurfaceAttrib(dpy, surface, attribute, value), 1);
                let mut found = -1;
                assert_eq!(eglQuerySurface(dpy, surface, attribute, &mut found), 1);
                assert_eq!(found, value, "{attribute:#x}");
            }
        }
    }
}
