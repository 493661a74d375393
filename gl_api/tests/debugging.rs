//! `KHR_debug` and `ARB_sync`: what the log has, who is called, what is filtered, and the errors.

use gl_api::*;
use std::ffi::CStr;
use std::process::Command;
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

/// A shader whose every line is wrong, so that its log is longer than the longest message.
fn broken_shader(c: &mut Context) -> GLuint {
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let comment = "☃".repeat(100);
    let lines: String =
        (0..60).map(|at| format!("    gl_FragColor = vec4(size{at}); // {comment}\n")).collect();
    c.shader_source(shader, 1, Strings(vec![&format!("void main() {{\n{lines}}}\n")]), &[]);
    shader
}

#[test]
fn a_message_is_cut_to_what_a_reader_has_room_for() {
    let mut c = context();
    c.enable(GL_DEBUG_OUTPUT);
    let shader = broken_shader(&mut c);
    c.compile_shader(shader);
    let mut length = [0];
    c.get_shaderiv(shader, GL_INFO_LOG_LENGTH, &mut length);
    let most = integer(&mut c, GL_MAX_DEBUG_MESSAGE_LENGTH);
    assert!(length[0] > most, "{length:?}");
    c.line_width(-1.0);
    let mut text = vec![0; most as usize];
    let mut lengths = [0];
    let none: &mut [GLenum] = &mut [];
    let (severities, ids) = (&mut [][..], &mut [][..]);
    let room = TextOut::Bytes(&mut text);
    let taken =
        c.get_debug_message_log(1, most, none, &mut [], ids, severities, &mut lengths, room);
    assert_eq!(taken, 1);
    assert!((most - 3..=most).contains(&lengths[0]), "{lengths:?}");
    let text = CStr::from_bytes_until_nul(&text).expect("ends with zero").to_str();
    let text = text.expect("cut between two characters");
    assert!(text.starts_with("glCompileShader: shader 1 did not compile:\n"), "{text}");
    assert_eq!(text.len() + 1, lengths[0] as usize);
    assert_eq!(log(&mut c).len(), 1, "the next one can be read");
}

#[test]
fn what_comes_of_a_call_is_said_each_time_and_what_each_draw_would_say_once() {
    let mut c = context();
    let shader = broken_shader(&mut c);
    c.compile_shader(shader);
    c.enable(GL_DEBUG_OUTPUT);
    c.compile_shader(shader);
    c.compile_shader(shader);
    assert_eq!(log(&mut c).len(), 2);
    let program = c.create_program();
    c.attach_shader(program, shader);
    c.link_program(program);
    c.link_program(program);
    assert_eq!(log(&mut c).len(), 2);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    assert_ne!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    assert_ne!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    assert_eq!(log(&mut c).len(), 2);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.disable(GL_DEBUG_OUTPUT);
    for _ in 0..2 {
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        c.enable(GL_DEBUG_OUTPUT);
    }
    assert_eq!(log(&mut c).len(), 1, "a log that was off has not heard of it");
}

#[test]
fn a_kind_of_warning_can_be_switched_off_by_its_number() {
    let mut c = context();
    c.enable(GL_DEBUG_OUTPUT);
    let other = c.create_program();
    let shader = broken_shader(&mut c);
    c.compile_shader(shader);
    c.link_program(other);
    let compiled = log(&mut c)[0].0;
    assert_ne!(compiled, 0);
    let (source, ty) = (GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_OTHER);
    c.debug_message_control(source, ty, GL_DONT_CARE, 1, &[compiled], false);
    let next = broken_shader(&mut c);
    c.compile_shader(next);
    c.attach_shader(other, next);
    c.link_program(other);
    let rest = log(&mut c);
    assert_eq!(rest.len(), 1, "{rest:?}");
    assert!(rest[0].1.starts_with("glLinkProgram"), "{rest:?}");
    assert_ne!(rest[0].0, compiled);
}

/// Nothing by itself: [`messages_are_announced`] runs it in a process of its own.
#[test]
fn makes_two_contexts() {
    drop((context(), context()));
}

#[test]
fn messages_are_announced() {
    let program = std::env::current_exe().expect("this program");
    let said = |value: &str| {
        let mut child = Command::new(&program);
        child.args(["--exact", "makes_two_contexts", "--nocapture"]);
        child.env("DETGL_DEBUG", value).env("DETGL_THREADS", "2").env("DETGL_ISA", "baseline");
        let output = child.output().expect("it runs");
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        text.lines()
            .filter(|line| line.starts_with("detgl:"))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let announced =
        concat!("detgl: DetGL ", env!("CARGO_PKG_VERSION"), ", OpenGL 3.3, baseline, 2 threads");
    assert_eq!(said("1"), Vec::from([announced.to_owned()]));
    assert_eq!(said("0"), Vec::<String>::new());
}

/// Draws a picture with an error and a warning, which only the environment's way reads:
/// [`messages_that_nobody_reads_are_announced`] runs it in a process of its own.
#[test]
fn draws_wrongly() {
    let Some(reads) = std::env::var_os("READS") else { return };
    let mut c = context();
    if reads == "callback" {
        c.enable(GL_DEBUG_OUTPUT);
        c.debug_message_callback(Some(ignored), std::ptr::null());
    }
    let mut pixel = [0_u8; 4];
    for _ in 0..3 {
        c.begin(99);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        match reads.to_str() {
            Some("messages") => drop(c.messages()),
            Some("log") => drop(log(&mut c)),
            Some("error") => assert_eq!(c.get_error(), GL_INVALID_ENUM),
            Some(_) | None => {}
        }
        c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    }
}

extern "system" fn ignored(
    _: GLenum,
    _: GLenum,
    _: GLuint,
    _: GLenum,
    _: GLsizei,
    _: *const GLchar,
    _: *mut GLvoid,
) {
}

#[test]
fn messages_that_nobody_reads_are_announced() {
    let said = |reads: &str, value: Option<&str>| {
        let mut child = Command::new(std::env::current_exe().expect("this program"));
        child.args(["--exact", "draws_wrongly", "--nocapture"]).env("READS", reads);
        match value {
            Some(value) => child.env("DETGL_DEBUG", value),
            None => child.env_remove("DETGL_DEBUG"),
        };
        let output = child.output().expect("it runs");
        assert!(output.status.success());
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let lines = text.lines().filter(|line| line.starts_with("detgl:"));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    for reads in ["nothing", "error"] {
        let lines = said(reads, None);
        assert_eq!(lines.len(), 1, "{reads}: {lines:?}");
        let begin =
            "detgl: 1 error and 1 warning that nobody read; the first, error: glBegin: mode = ";
        assert!(lines[0].starts_with(begin), "{lines:?}");
        assert!(lines[0].ends_with("(DETGL_DEBUG=1 prints all, DETGL_DEBUG=0 not even this)"));
        assert_eq!(said(reads, Some("0")), [""; 0], "{reads}");
    }
    for reads in ["messages", "log", "callback"] {
        assert_eq!(said(reads, None), [""; 0], "{reads}");
    }
    let all = said("nothing", Some("1"));
    assert!(all.iter().all(|line| !line.contains("nobody read")), "{all:?}");
    assert!(all.len() > 3, "{all:?}");
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
