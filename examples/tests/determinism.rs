//! Every picture has the same bits at every instruction set and thread count, and is the picture
//! that somebody has looked at (`examples/pictures/`, which the README shows).
//!
//! `DETGL_BLESS=1 cargo test -p examples --test determinism` writes those pictures anew; look at them
//! before you commit them.

use examples::picture::Picture;
use examples::programs;
use examples::window::{Program, render};
use gl_api::context::ContextDesc;
use golden::Golden;
use rasterizer::driver::{Device, DeviceDesc, LeaveOut};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use texunit::lanes::Isa;

/// Side of the pictures that are compared with each other.
const SIZE: usize = 128;
/// Side of the pictures that were looked at.
const GOLDEN_SIZE: usize = 256;
const THREADS: [usize; 3] = [1, 2, 8];

fn draw(program: &Program, size: usize, isa: Isa, threads: usize) -> Picture {
    let desc = DeviceDesc::from_env().expect("a valid environment");
    draw_on(program, size, DeviceDesc { isa, threads, ..desc })
}

fn draw_on(program: &Program, size: usize, desc: DeviceDesc) -> Picture {
    let device = Arc::new(Device::new(desc).expect("threads start"));
    let desc = ContextDesc { device: Some(device), ..ContextDesc::default() };
    let rendered = render(program, size, None, &desc).expect("a context of this size");
    assert!(rendered.errors.is_empty(), "{}: {:?}", program.name, rendered.errors);
    rendered.picture
}

fn plain(program: &Program, size: usize) -> Picture {
    draw(program, size, Isa::BASELINE, 1)
}

#[test]
fn every_picture_is_the_same_at_every_instruction_set_and_thread_count() {
    std::thread::scope(|scope| {
        for half in programs::ALL.chunks(programs::ALL.len().div_ceil(2)) {
            scope.spawn(|| are_the_same_everywhere(half));
        }
    });
}

fn are_the_same_everywhere(programs: &[Program]) {
    for program in programs {
        let expected = plain(program, SIZE);
        for isa in Isa::executions() {
            for threads in THREADS {
                let got = draw(program, SIZE, isa, threads);
                if got != expected {
                    let what = format!("{}-{}-{threads}", program.name, isa.name());
                    let [old, new] = [&expected, &got].map(comparable);
                    let said = golden().compare(Some(&old), &new, &what);
                    panic!("{}", said.expect_err("they differ"));
                }
            }
        }
    }
}

#[test]
fn every_picture_is_the_same_where_nothing_is_left_out() {
    for program in &programs::ALL {
        let desc = DeviceDesc::from_env().expect("a valid environment");
        let [with, without] = [LeaveOut::WithoutEffect, LeaveOut::Nothing]
            .map(|leave_out| draw_on(program, SIZE, DeviceDesc { leave_out, ..desc }));
        assert!(with == without, "{}", program.name);
    }
}

#[test]
fn every_picture_is_the_one_that_was_looked_at() {
    let golden = golden();
    let mut wrong = String::new();
    for program in &programs::ALL {
        let got = comparable(&plain(program, GOLDEN_SIZE));
        if let Err(said) = golden.check(&got, program.name) {
            writeln!(wrong, "{said}").unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

fn golden() -> Golden {
    let failures = Path::new(env!("CARGO_TARGET_TMPDIR")).join("difference");
    Golden::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures"), failures)
}

fn comparable(picture: &Picture) -> golden::Picture {
    let bytes = bytemuck::cast_slice(&picture.pixels);
    golden::Picture::rgb(picture.width as u32, picture.height as u32, bytes)
}
