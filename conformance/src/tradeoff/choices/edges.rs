//! Edges of polygons: one sample, smooth polygons, several samples, supersampling.

use super::super::stage::{Clock, Frame, Stage, one_thread};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::oracle::polygon::shared_area;
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;

/// Edges.
pub const EDGES: Choice = Choice {
    name: "edges",
    what: "twelve white triangles about a point; error against the areas that they share with pixels; resolving is timed, too",
    cost: Cost::Time,
    alternatives,
};

/// The triangles that do not meet, in a picture from -1 to 1.
fn triangles() -> Vec<[[f64; 2]; 3]> {
    let at = |turn: f64, radius: f64| {
        let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
        // Multiples of 1/1024 of half the picture, which snap to themselves.
        [cos * radius + 0.03, sin * radius - 0.05].map(|c| (c * 1024.0).round() / 1024.0)
    };
    (0..12)
        .map(|k| {
            let turn = f64::from(k) / 12.0 + 0.01;
            [at(turn, 0.1), at(turn + 0.004, 0.93), at(turn + 0.004 * f64::from(k + 1), 0.93)]
        })
        .collect()
}

/// How edges are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edges {
    OneSample,
    Smooth,
    Samples(usize),
    Supersampled(usize),
}

const ALL: [(Edges, &str); 6] = [
    (Edges::OneSample, "one sample"),
    (Edges::Smooth, "GL_POLYGON_SMOOTH"),
    (Edges::Samples(4), "4 samples a pixel"),
    (Edges::Supersampled(2), "supersampled 2×2"),
    (Edges::Supersampled(4), "supersampled 4×4"),
    (Edges::Supersampled(8), "supersampled 8×8"),
];

fn draw() {
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for [x, y] in triangles().into_iter().flatten() {
        glVertex2f(x as f32, y as f32);
    }
    glEnd();
}

/// A framebuffer of one renderbuffer.
fn target(side: usize, samples: usize) -> u32 {
    let (mut framebuffer, mut renderbuffer) = (0u32, 0u32);
    glGenFramebuffers(1, &mut framebuffer);
    glGenRenderbuffers(1, &mut renderbuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, side, side);
    let point = GL_COLOR_ATTACHMENT0;
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
    framebuffer
}

fn blit(from: (u32, usize), to: (u32, usize)) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.0);
    let (a, b) = (from.1 as i32, to.1 as i32);
    let filter = if a == b { GL_NEAREST } else { GL_LINEAR };
    glBlitFramebuffer(0, 0, a, a, 0, 0, b, b, GL_COLOR_BUFFER_BIT, filter);
}

fn frame(edges: Edges, side: usize) -> Frame {
    match edges {
        Edges::OneSample => Frame::new(draw),
        Edges::Smooth => {
            glEnable(GL_POLYGON_SMOOTH);
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE);
            Frame::new(draw)
        }
        Edges::Samples(samples) => {
            let large = target(side, samples);
            Frame::new(move || {
                glBindFramebuffer(GL_FRAMEBUFFER, large);
                draw();
                blit((large, side), (0, side));
                glBindFramebuffer(GL_FRAMEBUFFER, 0);
            })
        }
        Edges::Supersampled(n) => {
            // Halved until it is small enough: at half the size a linear filter is the mean of 2×2.
            let sides: Vec<usize> = (1..=n.ilog2()).rev().map(|k| side << k).collect();
            let mut chain: Vec<(u32, usize)> =
                sides.into_iter().map(|side| (target(side, 0), side)).collect();
            chain.push((0, side));
            Frame::new(move || {
                let (framebuffer, large) = chain[0];
                glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
                glViewport(0, 0, large, large);
                draw();
                chain.windows(2).for_each(|pair| blit(pair[0], pair[1]));
                glBindFramebuffer(GL_FRAMEBUFFER, 0);
            })
        }
    }
}

fn alternatives(side: usize) -> Result<Alternatives, ProbeError> {
    let device = one_thread()?;
    let mut all = Vec::new();
    for (edges, name) in ALL {
        let stage = Stage::new(&device, Clock::Processor, side, || frame(edges, side))?;
        all.push(Alternative::new(name, stage));
    }
    let half = side as f64 / 2.0;
    let corners: Vec<_> =
        triangles().into_iter().map(|of| of.map(|p| p.map(|c| (c + 1.0) * half))).collect();
    let reference = pictured(side, |pixel| {
        let area: f64 = corners.iter().map(|of| shared_area(of, pixel)).sum();
        [area, area, area, 1.0]
    });
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
