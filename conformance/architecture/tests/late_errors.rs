//! A call that fails has no effect: the functions of `calls` and `record` assign nothing before their last error.

use architecture::{LateError, fallible_requests, late_errors};
use std::error::Error;
use std::fs;
use std::path::Path;

/// Functions of which what is found is none, and why.
const HARMLESS: &[(&str, &str, &str)] = &[(
    "vertex/elements.rs",
    "draw_runs",
    "`first_primitive` counts within the draw; `draw_indexed` takes it back, whether it is drawn or not",
)];

#[test]
fn calls_validate_before_they_assign() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = late_errors(&root, &root.join("gl_api/src/calls"))?;
    found.extend(late_errors(&root, &root.join("gl_api/src/record"))?);
    let is_of = |late: &LateError, (file, function, _): &(&str, &str, &str)| {
        late.file.ends_with(file) && late.function == *function
    };
    let wrong: Vec<String> = found
        .iter()
        .filter(|late| !HARMLESS.iter().any(|row| is_of(late, row)))
        .map(|late| {
            let LateError { file, function, assigned, fails } = late;
            format!("{file}:{fails}: `{function}` may fail here, after it assigned in line {assigned}: validate first")
        })
        .collect();
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
    for row in HARMLESS {
        assert!(found.iter().any(|late| is_of(late, row)), "{row:?} has no late error any more");
    }
    Ok(())
}

/// Requests that need memory, or the client's, when they are applied, and what of it may be missing.
const NEED_MEMORY: &[(&str, &str, &str)] = &[
    ("framebuffer/blit.rs", "BlitRequest", "pixels and rows that are written"),
    (
        "framebuffer/read.rs",
        "ReadPixelsRequest",
        "the memory that is written to is known only then",
    ),
    ("framebuffer/renderbuffers.rs", "StorageRequest", "texels"),
    ("pixels/copy.rs", "CopyPixelsRequest", "converted pixels"),
    ("pixels/draw.rs", "DrawPixelsRequest", "converted pixels"),
    ("texture/clear_image.rs", "ClearRequest", "a copy of a level that others share"),
    ("texture/copy.rs", "CopyTexImageRequest", "texels of the level"),
    ("texture/copy_image.rs", "CopyRequest", "a copy of a level that others share"),
    ("texture/level_request.rs", "LevelRequest", "the levels that GL_GENERATE_MIPMAP makes"),
    ("texture/sub.rs", "BoxRequest", "a copy of a level that others share"),
    ("texture/sub.rs", "TexSubImageRequest", "converted pixels"),
];

#[test]
fn requests_fail_at_most_for_memory_when_they_are_applied() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let calls = root.join("gl_api/src/calls");
    let found = fallible_requests(&calls, &calls)?;
    let known: Vec<(String, String)> = NEED_MEMORY
        .iter()
        .map(|(file, request, _)| ((*file).to_owned(), (*request).to_owned()))
        .collect();
    assert_eq!(found, known, "`apply` returns nothing, or has a row above that says what it needs");
    Ok(())
}

/// The functions in which a late error is found.
fn found_in(source: &str) -> Result<Vec<String>, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    fs::write(folder.path().join("calls.rs"), source)?;
    let found = late_errors(folder.path(), folder.path())?;
    Ok(found.into_iter().map(|late| late.function).collect())
}

#[test]
fn late_errors_are_found() -> Result<(), Box<dyn Error>> {
    let planted = "
        fn question(context: &mut Context) -> Result<()> { context.a = 1; check()?; Ok(()) }
        fn returned(context: &mut Context) -> Result<()> {
            let object = context.object()?;
            object.size += 1;
            if object.size > 3 { return invalid_value(\"\"); }
            Ok(())
        }
        fn in_a_loop(context: &mut Context) -> Result<()> {
            for x in 0..2 { check(x)?; context.a[x] = x; }
            Ok(())
        }
        fn after_a_branch(context: &mut Context) -> Result<()> {
            if context.is_es() { *context.object_mut() = 1; }
            check()?;
            Ok(())
        }";
    assert_eq!(found_in(planted)?, ["after_a_branch", "in_a_loop", "question", "returned"]);
    Ok(())
}

#[test]
fn what_validates_first_passes() -> Result<(), Box<dyn Error>> {
    let clean = "
        fn first(context: &mut Context) -> Result<()> { check()?; context.a = 1; Ok(()) }
        fn own(context: &mut Context) -> Result<()> {
            let mut request = Request::default();
            request.size = 3;
            check(&request)?;
            Ok(())
        }
        fn answers(context: &mut Context, count: &mut [i32]) -> Result<()> {
            if let Some(count) = count.first_mut() { *count = 1; }
            check()?;
            Ok(())
        }
        fn other_branch(context: &mut Context) -> Result<()> {
            match context.kind { A => context.a = 1, B => check()? }
            Ok(())
        }
        fn not_fallible(context: &mut Context) { context.a = 1; }";
    assert_eq!(found_in(clean)?, [""; 0]);
    Ok(())
}
