//! Every picture has the same bits at every instruction set and thread count, and is the picture
//! that somebody has looked at (`examples/pictures/`, which the README shows).
//!
//! `DETGL_BLESS=1 cargo test -p examples --test determinism` writes those pictures anew; look at them
//! before you commit them.

use examples::picture::{self, Picture, packed_pixel_t};
use examples::programs;
use examples::window::{Program, render};
use gl_api::context::ContextDesc;
use rasterizer::driver::{Device, DeviceDesc};
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
    let desc = DeviceDesc { isa, threads, ..DeviceDesc::from_env().expect("a valid environment") };
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
        for isa in Isa::available() {
            for threads in THREADS {
                let got = draw(program, SIZE, isa, threads);
                if got != expected {
                    let what = format!("{}-{}-{threads}", program.name, isa.name());
                    panic!("{}", difference(&what, Some(&expected), &got));
                }
            }
        }
    }
}

#[test]
fn every_picture_is_the_one_that_was_looked_at() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures");
    let mut wrong = String::new();
    for program in &programs::ALL {
        let got = plain(program, GOLDEN_SIZE);
        let path = golden.join(format!("{}.png", program.name));
        if std::env::var_os("DETGL_BLESS").is_some() {
            picture::save(&got, &path).expect("the source is writable");
        }
        let old = picture::load(&path).ok();
        if old.as_ref() != Some(&got) {
            writeln!(wrong, "{}", difference(program.name, old.as_ref(), &got)).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Writes the old, the new, and the difference to `target/tmp/difference/`, and says where they
/// differ.
fn difference(what: &str, old: Option<&Picture>, new: &Picture) -> String {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("difference");
    std::fs::create_dir_all(&directory).expect("target is writable");
    let save = |kind: &str, picture: &Picture| {
        let path = directory.join(format!("{what}-{kind}.png"));
        picture::save(picture, &path).expect("target is writable");
    };
    save("new", new);
    let Some(old) = old.filter(|old| (old.width, old.height) == (new.width, new.height)) else {
        return format!(
            "{what}: no picture of this size to compare with; see {}",
            directory.display()
        );
    };
    save("old", old);
    let apart = |(a, b): (&packed_pixel_t, &packed_pixel_t)| packed_pixel_t {
        r: a.r.abs_diff(b.r),
        g: a.g.abs_diff(b.g),
        b: a.b.abs_diff(b.b),
    };
    let pixels: Vec<_> = old.pixels.iter().zip(&new.pixels).map(apart).collect();
    let largest = |p: &packed_pixel_t| p.r.max(p.g).max(p.b);
    let count = pixels.iter().filter(|p| largest(p) > 0).count();
    let most = pixels.iter().map(largest).max().unwrap_or(0);
    let first = pixels.iter().position(|p| largest(p) > 0).unwrap_or(0);
    let (x, y) = (first % new.width, first / new.width);
    // Stretched so that a difference of one step can be seen.
    let bright = |v: u8| if v == 0 { 0 } else { v.saturating_mul(8).max(64) };
    let pixels =
        pixels.iter().map(|p| packed_pixel_t { r: bright(p.r), g: bright(p.g), b: bright(p.b) });
    save("difference", &Picture { pixels: pixels.collect(), ..*new });
    format!(
        "{what}: {count} pixels differ, by up to {most}, the first at ({x}, {y}); see {}",
        directory.display()
    )
}
