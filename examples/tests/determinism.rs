//! Every picture has the same bits at every instruction set and thread count, and is the picture
//! that somebody has looked at (`golden.txt`).
//!
//! `DETGL_BLESS=1 cargo test -p examples --test determinism` writes `golden.txt` anew, and the
//! pictures it stands for into `target/golden/`, which is where an old picture is looked for when
//! one differs.

use examples::picture::{self, Picture, packed_pixel_t};
use examples::programs;
use examples::window::{Program, render};
use gl_api::context::ContextDesc;
use rasterizer::driver::{Device, DeviceDesc};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use texunit::lanes::Isa;

const SIZE: usize = 128;
const THREADS: [usize; 3] = [1, 2, 8];

fn draw(program: &Program, isa: Isa, threads: usize) -> Picture {
    let desc = DeviceDesc { isa, threads, ..DeviceDesc::from_env().expect("a valid environment") };
    let device = Arc::new(Device::new(desc).expect("threads start"));
    let desc = ContextDesc { device: Some(device), ..ContextDesc::default() };
    let rendered = render(program, SIZE, None, &desc).expect("a context of this size");
    assert!(rendered.errors.is_empty(), "{}: {:?}", program.name, rendered.errors);
    rendered.picture
}

fn plain(program: &Program) -> Picture {
    draw(program, Isa::BASELINE, 1)
}

#[test]
fn every_picture_is_the_same_at_every_instruction_set_and_thread_count() {
    for program in &programs::ALL {
        let expected = plain(program);
        for isa in Isa::available() {
            for threads in THREADS {
                let got = draw(program, isa, threads);
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
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden.txt");
    if std::env::var_os("DETGL_BLESS").is_some() {
        bless(&golden);
    }
    let text = std::fs::read_to_string(&golden).expect("tests/golden.txt; see DETGL_BLESS above");
    let expected: BTreeMap<&str, &str> =
        text.lines().filter_map(|line| line.split_once(' ')).collect();
    let mut wrong = String::new();
    for program in &programs::ALL {
        let got = plain(program);
        let checksum = format!("{:016x}", got.checksum());
        if expected.get(program.name) != Some(&checksum.as_str()) {
            let old = picture::load(&blessed(program)).ok();
            writeln!(wrong, "{}", difference(program.name, old.as_ref(), &got)).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

fn bless(golden: &Path) {
    std::fs::create_dir_all(target().join("golden")).expect("target is writable");
    let mut text = String::new();
    for program in &programs::ALL {
        let picture = plain(program);
        picture::save(&picture, &blessed(program)).expect("target is writable");
        writeln!(text, "{} {:016x}", program.name, picture.checksum()).unwrap();
    }
    std::fs::write(golden, text).expect("the source is writable");
}

fn target() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("..")
}

fn blessed(program: &Program) -> PathBuf {
    target().join("golden").join(format!("{}.png", program.name))
}

/// Writes the old, the new, and the difference to `target/difference/`, and says where they differ.
fn difference(what: &str, old: Option<&Picture>, new: &Picture) -> String {
    let directory = target().join("difference");
    std::fs::create_dir_all(&directory).expect("target is writable");
    let save = |kind: &str, picture: &Picture| {
        let path = directory.join(format!("{what}-{kind}.png"));
        picture::save(picture, &path).expect("target is writable");
    };
    save("new", new);
    let Some(old) = old.filter(|old| (old.width, old.height) == (new.width, new.height)) else {
        return format!("{what}: not the picture of golden.txt; see {}", directory.display());
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
