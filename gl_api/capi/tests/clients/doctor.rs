//! `detgl doctor`.

use super::{detgl, folder, run};
use std::process::Stdio;

#[test]
fn doctor_says_what_shadows_the_library_and_which_contexts_there_are() {
    let folder = folder("doctor");
    let broken = folder.join("libGL.so.1");
    std::fs::write(&broken, "no library").expect("the folder is writable");
    let mut command = detgl();
    command.arg("doctor").env("LD_LIBRARY_PATH", &folder).env("DETGL_THREADS", "3");
    command.env_remove("LD_PRELOAD").env_remove("DETGL_GL_VERSION");
    let output = run(&mut command).unwrap_or_else(|said| panic!("{said}"));
    let text = String::from_utf8_lossy(&output.stdout);
    let (as_it_is, by_run) = text.split_once("a program that `detgl run` starts").expect("both");
    let broken = broken.display();
    for said in [
        "threads=3".to_owned(),
        "\n  DETGL_THREADS=3\n".to_owned(),
        format!("\n  libGL.so.1      1. {broken} (LD_LIBRARY_PATH)\n"),
        format!("\n  libGL.so.1      none: {broken}: "),
    ] {
        assert!(as_it_is.contains(&said), "{said}: {text}");
    }
    for said in [
        "\n  libGL.so.1      DetGL: ",
        "\n  libOSMesa.so.8  DetGL: ",
        "\n  EGL, OpenGL 3.3 core             yes: 3.3 (Core Profile) DetGL ",
        "\n  EGL, OpenGL ES 3.0               yes: OpenGL ES 3.0 DetGL ",
        "\n  EGL, OpenGL 4.6 core             no: eglCreateContext: EGL_BAD_MATCH\n",
        "\n  OSMesa, OpenGL 2.1               yes: 3.3 (Compatibility Profile) DetGL ",
    ] {
        assert!(by_run.contains(said), "{said}: {text}");
    }
    assert!(!by_run.contains("another driver"), "{text}");
}

/// As in `detgl doctor | head -1`.
#[test]
fn doctor_ends_in_silence_where_its_reader_does() {
    let mut command = detgl();
    command.arg("doctor").stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("it starts");
    // Nothing is printed before the reader is gone, or all of it is in a pipe without one.
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert!(!output.status.success());
}
