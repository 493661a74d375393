//! DetGL's own functions.

use super::*;

/// What a function writes to memory of `size` bytes, and what it returns.
fn written(function: unsafe extern "C" fn(*mut c_char, i32) -> i32, size: usize) -> (String, i32) {
    let mut memory = vec![0x55_u8; size + 1];
    // SAFETY: the memory has that size.
    let length = unsafe { function(memory.as_mut_ptr().cast(), size as i32) };
    assert_eq!(memory[size], 0x55, "not its memory");
    let text = CStr::from_bytes_until_nul(&memory).expect("a final zero").to_str().expect("UTF-8");
    (text.to_owned(), length)
}

unsafe extern "C" {
    fn detglInfo(out: *mut c_char, size: i32) -> i32;
    fn detglNextMessage(out: *mut c_char, size: i32) -> i32;
}

#[test]
fn what_contexts_have_is_known_without_one() {
    let (text, length) = written(detglInfo, 4096);
    assert_eq!(text.len(), length as usize);
    for line in ["isa=", "threads=", "gl=3.3", "es=3.0", "max_texture_size=8192"] {
        assert!(text.lines().any(|found| found.starts_with(line)), "{text}");
    }
    assert_eq!(written(detglInfo, 8), (text[..7].to_owned(), length));
    // SAFETY: null, and memory of no size, are not written to.
    unsafe {
        assert_eq!(detglInfo(null_mut(), 8), length);
        assert_eq!(detglInfo(&mut 0, 0), length);
        assert_eq!(detglInfo(&mut 0, -1), length);
    }
}

#[test]
fn messages_are_taken_one_by_one() {
    assert_eq!(written(detglNextMessage, 64), (String::new(), 0));
    let (dpy, config) = display();
    // SAFETY: the list ends with EGL_NONE, and handles are only looked up.
    unsafe {
        let surface = eglCreatePbufferSurface(dpy, config, SURFACE.as_ptr());
        let context = eglCreateContext(dpy, config, null_mut(), null_mut());
        assert_eq!(eglMakeCurrent(dpy, surface, surface, context), 1);
        glEnable(1);
        glDisable(2);
    }
    let (first, length) = written(detglNextMessage, 17);
    assert_eq!(first, "error: glEnable:");
    assert!(length > 17);
    assert!(written(detglNextMessage, 4096).0.starts_with("error: glDisable: "));
    assert_eq!(written(detglNextMessage, 64), (String::new(), 0));
}
