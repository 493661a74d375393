//! `KHR_debug` and `ARB_sync`: what the log has, who is called, what is filtered, and the errors.

use gl_api::*;
use std::ffi::CStr;
use std::sync::Mutex;

fn context() -> Context {
    Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() }).expect("a device")
}

fn integer(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [0];
    c.get_integerv(pname, &mut value);
    value[0]
}

/// Takes all messages: ids and texts.
fn log(c: &mut Context) -> Vec<(GLuint, String)> {
    let mut ids = [0; 16];
    let mut text = String::new();
    let none: &mut [GLenum] = &mut [];
    let count = c.get_debug_message_log(
        16,
        GLsizei::MAX,
        none,
        &mut [],
        &mut ids,
        &mut [],
        &mut [],
        TextOut::String(&mut text),
    );
    let texts = text.split('\0').map(str::to_owned);
    ids.into_iter().zip(texts).take(count as usize).collect()
}

#[test]
fn errors_come_to_the_log_if_it_is_on() {
    let mut c = context();
    c.enable(GL_TEXTURE_BINDING_2D);
    assert_eq!(integer(&mut c, GL_DEBUG_LOGGED_MESSAGES), 0);
    c.enable(GL_DEBUG_OUTPUT);
    c.enable(GL_TEXTURE_BINDING_2D);
    c.line_width(-1.0);
    assert_eq!(integer(&mut c, GL_DEBUG_LOGGED_MESSAGES), 2);
    let length = integer(&mut c, GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH) as usize;
    let messages = log(&mut c);
    assert_eq!(
        messages.iter().map(|m| m.0).collect::<Vec<_>>(),
        [GL_INVALID_ENUM, GL_INVALID_VALUE]
    );
    assert!(messages[0].1.starts_with("glEnable: cap"), "{messages:?}");
    assert_eq!(messages[0].1.len() + 1, length);
    assert!(messages[1].1.starts_with("glLineWidth"), "{messages:?}");
    assert_eq!(log(&mut c), []);
}

#[test]
fn filters_and_groups_decide_what_is_kept() {
    let mut c = context();
    c.enable(GL_DEBUG_OUTPUT);
    let say = |c: &mut Context, id, severity| {
        let (source, ty) = (GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_MARKER);
        c.debug_message_insert(source, ty, id, severity, -1, "here");
    };
    say(&mut c, 1, GL_DEBUG_SEVERITY_LOW);
    say(&mut c, 2, GL_DEBUG_SEVERITY_HIGH);
    c.push_debug_group(GL_DEBUG_SOURCE_APPLICATION, 9, 3, "group");
    let (source, ty) = (GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_MARKER);
    c.debug_message_control(source, ty, GL_DONT_CARE, 1, &[2], false);
    c.debug_message_control(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_LOW, 0, &[], true);
    say(&mut c, 2, GL_DEBUG_SEVERITY_HIGH);
    say(&mut c, 3, GL_DEBUG_SEVERITY_LOW);
    assert_eq!(integer(&mut c, GL_DEBUG_GROUP_STACK_DEPTH), 2);
    c.pop_debug_group();
    say(&mut c, 2, GL_DEBUG_SEVERITY_HIGH);
    say(&mut c, 4, GL_DEBUG_SEVERITY_LOW);
    let got: Vec<(GLuint, String)> = log(&mut c);
    let got: Vec<(GLuint, &str)> = got.iter().map(|(id, text)| (*id, text.as_str())).collect();
    assert_eq!(got, [(2, "here"), (9, "gro"), (3, "here"), (9, "gro"), (2, "here")]);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

static CALLED: Mutex<Vec<String>> = Mutex::new(Vec::new());

extern "system" fn called(
    _: GLenum,
    _: GLenum,
    id: GLuint,
    _: GLenum,
    length: GLsizei,
    _: *const GLchar,
    user: *mut GLvoid,
) {
    CALLED.lock().expect("nobody panics").push(format!("{id} {length} {}", user as usize));
}

#[test]
fn a_callback_is_called_when_the_call_is_over() {
    let mut c = context();
    c.enable(GL_DEBUG_OUTPUT);
    let (source, ty) = (GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER);
    // What was logged before stays in the log.
    c.debug_message_insert(source, ty, 4, GL_DEBUG_SEVERITY_HIGH, -1, "three");
    c.debug_message_callback(Some(called), 77 as *const GLvoid);
    c.debug_message_insert(source, ty, 5, GL_DEBUG_SEVERITY_HIGH, -1, "four");
    assert_eq!(*CALLED.lock().expect("nobody panics"), ["5 4 77"]);
    let mut pointers = [std::ptr::null_mut()];
    c.get_pointerv(GL_DEBUG_CALLBACK_USER_PARAM, &mut pointers);
    assert_eq!(pointers[0] as usize, 77);
    assert_eq!(log(&mut c), [(4, "three".to_owned())]);
}

#[test]
fn objects_and_fences_have_labels() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D, 3);
    c.object_label(GL_TEXTURE, 3, -1, "brick");
    let mut label = [1; 4];
    let mut length = [0];
    c.get_object_label(GL_TEXTURE, 3, 4, &mut length, TextOut::Bytes(&mut label));
    let label = CStr::from_bytes_until_nul(&label).expect("ends with zero");
    assert_eq!((label.to_bytes(), length[0]), (&b"bri"[..], 3));
    c.begin_query(GL_SAMPLES_PASSED, 7);
    c.end_query(GL_SAMPLES_PASSED);
    c.object_label(GL_QUERY, 7, -1, "count");
    let mut text = String::new();
    c.get_object_label(GL_QUERY, 7, 100, &mut length, TextOut::String(&mut text));
    assert_eq!(text, "count");
    let fence = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    c.object_ptr_label(fence, 2, "fence");
    let mut text = String::new();
    c.get_object_ptr_label(fence, 100, &mut length, TextOut::String(&mut text));
    assert_eq!(text, "fe");
    let mut status = [0];
    c.get_synciv(fence, GL_SYNC_STATUS, 1, &mut length, &mut status);
    assert_eq!(status[0] as GLenum, GL_UNSIGNALED);
    assert_eq!(c.client_wait_sync(fence, 0, 5), GL_CONDITION_SATISFIED);
    assert_eq!(c.client_wait_sync(fence, 0, 5), GL_ALREADY_SIGNALED);
    let other = c.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    assert_eq!(c.client_wait_sync(other, 0, 0), GL_ALREADY_SIGNALED);
    assert!(c.is_sync(fence));
    assert_eq!(c.client_wait_sync(std::ptr::null_mut(), 0, 0), GL_WAIT_FAILED);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
    c.delete_sync(fence);
    assert!(!c.is_sync(fence));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn deleting_no_fence_is_nothing() {
    let mut c = context();
    c.delete_sync(std::ptr::null_mut());
    assert_eq!(c.get_error(), GL_NO_ERROR);
}
