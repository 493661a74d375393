//! What each entry point refuses: rows of calls, each with its flag and words of its message, and
//! that no query answers anything else afterwards. In the end every entry point has had a row, or
//! is named in [`coverage`] among those that cannot fail.

#[path = "../common/mod.rs"]
mod common;

mod assembly;
mod basic;
mod blends;
mod buffer_textures;
mod coverage;
mod direct_state;
mod egl_images;
mod fixed;
mod fragments;
mod framebuffers;
mod get_texture_sub_image;
mod packed;
mod pipelines;
mod programs;
mod queries;
mod reading;
mod samplers;
mod short_slices;
mod sibling_forms;
mod special_functions;
mod stored_texels;
mod texture_storage;
mod texture_views;
mod textures;
mod transform_feedback;
mod uniform_buffers;
mod vertex_arrays;
mod vertices;
mod viewports;

use common::refusal::{Row, run};
use gl_api::*;

/// A call, the flag it must set, and words that its message must have.
type Case = (fn(&mut Context), GLenum, &'static str);

fn context() -> Context {
    Context::new(ContextDesc { width: 16, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// Runs a row on a context that is prepared.
#[track_caller]
fn row(c: &mut Context, name: String, call: &dyn Fn(&mut Context), flag: GLenum, words: &str) {
    while c.get_error() != GL_NO_ERROR {}
    if let Err(problem) = run(c, &Row { name, call, flag, words }) {
        panic!("{problem}");
    }
}

/// Runs the rows of a table, each on a context of its own.
fn table<'a>(
    name: &str,
    context: fn() -> Context,
    rows: impl Iterator<Item = (&'a fn(&mut Context), GLenum, &'static str)>,
) {
    for (number, (call, flag, words)) in rows.enumerate() {
        row(&mut context(), format!("{name} {number}"), call, flag, words);
    }
}

#[test]
fn each_refusal_sets_its_flag_says_why_and_changes_nothing_and_each_call_has_one() {
    let tables = [
        assembly::run,
        basic::run,
        buffer_textures::run,
        direct_state::run,
        blends::run,
        egl_images::run,
        fixed::run,
        fragments::run,
        framebuffers::run,
        special_functions::run,
        packed::run,
        pipelines::run,
        get_texture_sub_image::run,
        stored_texels::run,
        programs::run,
        queries::run,
        reading::run,
        sibling_forms::run,
        samplers::run,
        short_slices::run,
        texture_storage::run,
        texture_views::run,
        textures::run,
        transform_feedback::run,
        uniform_buffers::run,
        vertex_arrays::run,
        vertices::run,
        viewports::run,
    ];
    std::thread::scope(|scope| {
        for table in tables {
            scope.spawn(table);
        }
    });
    coverage::check(&common::refusal::refused());
}
