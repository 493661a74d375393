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
        (3, 2, false),
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
    // SAFETY: no pointers.
    assert_eq!(unsafe { eglBindAPI(EGL_OPENGL_ES_API) }, 0);
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
        ("OpenGL ES 2", &[0x3040, 4], false),
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
        ("3.0, forward compatible", &[0x3098, 3, 0x30FB, 0, 0x31B1, 1], EGL_BAD_MATCH),
        ("3.1", &[0x3098, 3, 0x30FB, 1], EGL_SUCCESS),
        ("3.1, core, which 3.1 ignores", &[0x3098, 3, 0x30FB, 1, 0x30FD, 1], EGL_SUCCESS),
        ("3.1, forward compatible", &[0x3098, 3, 0x30FB, 1, 0x31B1, 1], EGL_BAD_MATCH),
        ("3.2", &[0x3098, 3, 0x30FB, 2], EGL_BAD_MATCH),
        ("debug", &[0x31B0, 1], EGL_SUCCESS),
        ("robust", &[0x31B2, 1], EGL_SUCCESS),
        ("flags: debug", &[0x30FC, 1], EGL_SUCCESS),
        ("flags: forward compatible", &[0x30FC, 2], EGL_BAD_MATCH),
        ("forward compatible", &[0x31B1, 1], EGL_BAD_MATCH),
        ("flags that are none", &[0x30FC, 64], 0x3004),
        ("3.2 core", &[0x3098, 3, 0x30FB, 2, 0x30FD, 1], EGL_BAD_MATCH),
        ("4.6 compatibility", &[0x3098, 4, 0x30FB, 6, 0x30FD, 2], EGL_BAD_MATCH),
        ("a version that never was", &[0x3098, 2, 0x30FB, 7], EGL_BAD_MATCH),
        ("an attribute of surfaces", &[0x3057, 4], 0x3004),
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
    assert!(lines[1].contains("none meets attribute 0x3025 = 64"), "{said}");
}
