//! The explanation of a pixel ends in the pixel of the picture, and does not change it.

use examples::programs;
use examples::window::{explain, render};
use gl_api::context::ContextDesc;
use rasterizer::driver::{Device, DeviceDesc};
use rasterizer::trace::{PixelEvent, Step};
use std::sync::Arc;
use texunit::lanes::Isa;

const SIZE: usize = 96;

/// A device with every instruction set in turn.
fn desc(round: usize) -> ContextDesc {
    let all = Isa::available();
    let isa = all[round % all.len()];
    let desc =
        DeviceDesc { isa, threads: 2, ..DeviceDesc::from_env().expect("a valid environment") };
    let device = Arc::new(Device::new(desc).expect("threads start"));
    ContextDesc { device: Some(device), ..ContextDesc::default() }
}

#[test]
fn every_explanation_ends_in_the_pixel_of_the_picture() {
    for (round, program) in programs::ALL.iter().enumerate() {
        let plain = render(program, SIZE, None, &desc(0)).expect("a context of this size").picture;
        let [width, height] = program.sides(SIZE);
        for pixel in [[width / 3, height / 2], [width * 5 / 8, height * 2 / 5], [width - 9, 7]] {
            let (rendered, explanation) =
                explain(program, SIZE, None, &desc(round), pixel).expect("the pixel is inside");
            let name = program.name;
            assert_eq!(rendered.picture, plain, "{name}: watching {pixel:?} changes the picture");
            let shown = plain.pixels[pixel[1] * width + pixel[0]];
            let of = |texel: [f32; 4]| texel.map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8);
            let [r, g, b, _] = of(explanation.value);
            assert_eq!([r, g, b], [shown.r, shown.g, shown.b], "{name} {pixel:?}");
            let last = explanation.last_write().map(|texel| texel.color);
            assert_eq!(last, Some(explanation.value), "{name} {pixel:?}:\n{explanation}");
            lookups_end_in_what_was_sampled(&explanation.events, name);
        }
    }
}

/// The texture unit's trace of each lookup gives the words that the shader went on with.
fn lookups_end_in_what_was_sampled(events: &[PixelEvent], name: &str) {
    for event in events {
        let PixelEvent::Fragment(fragment) = event else { continue };
        for step in &fragment.steps {
            let Step::Lookup(lookup) = step else { continue };
            let Some(trace) = &lookup.trace else { continue };
            for (got, want) in trace.result.iter().zip(lookup.result) {
                assert!(want.is_none_or(|want| want == got.to_bits()), "{name}: {lookup:?}");
            }
        }
    }
}

#[test]
fn a_pixel_outside_of_the_picture_is_refused_by_name() {
    let [program, ..] = programs::ALL;
    let error = explain(&program, SIZE, None, &ContextDesc::default(), [SIZE, 0]).unwrap_err();
    assert!(error.to_string().contains("columns count from 0 at the left"), "{error}");
}
