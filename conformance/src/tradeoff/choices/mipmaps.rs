//! How mipmaps are made, and how far anisotropic filters go: a floor against the exact area integral.

use super::super::draw::{corners, draw_corners, set_texture};
use super::super::stage::{Clock, Frame, Stage, one_thread};
use super::super::{Scene, scene::Surface};
use super::{Alternative, Alternatives, Choice, Cost, everywhere, pictured};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::glu::gluBuild2DMipmaps;
use gl_api::*;

/// Of a power of two.
pub const EVEN: Choice = Choice {
    name: "mipmaps",
    what: "levels of a texture of 256×256 on a floor at 70°, trilinear; the time is that of making them, a pixel of the \
           picture; error against the area integral",
    cost: Cost::Time,
    alternatives: |side| made(&super::scene("floor-70", side)?, side),
};

/// Of an odd size.
pub const ODD: Choice = Choice {
    name: "mipmaps-odd",
    what: "the same of 251×251 texels, of which GLU makes 256×256",
    cost: Cost::Time,
    alternatives: |side| {
        let scene = super::scene("floor-70", side)?;
        let image = Level::from_fn(251, 251, |i, j| scene.image.texels[j * 256 + i]);
        made(&Scene { image, ..scene }, side)
    },
};

/// Anisotropic filters.
pub const ANISOTROPY: Choice = Choice {
    name: "anisotropy",
    what: "a floor at 80°, a trilinear filter of more and more texels; error against the area integral",
    cost: Cost::Time,
    alternatives: anisotropic,
};

/// How levels are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Maker {
    Generate,
    Automatic,
    Glu,
    Kaiser,
}

const MAKERS: [(Maker, &str); 4] = [
    (Maker::Generate, "glGenerateMipmap"),
    (Maker::Automatic, "GL_GENERATE_MIPMAP"),
    (Maker::Glu, "gluBuild2DMipmaps"),
    (Maker::Kaiser, "Kaiser filter, uploaded"),
];

fn made(scene: &Scene, side: usize) -> Result<Alternatives, ProbeError> {
    let device = one_thread()?;
    let mut all = Vec::new();
    for (maker, name) in MAKERS {
        let stage = Stage::new(&device, Clock::Processor, side, || {
            set_texture(scene, GL_LINEAR_MIPMAP_LINEAR, 1);
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            let corners = corners(scene);
            let image = scene.image.clone();
            Frame::made_by(move || make(maker, &image), move || draw_corners(&corners))
        })?;
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |pixel| scene.reference(pixel, side));
    Ok(Alternatives { side, reference, counts: everywhere, all })
}

fn make(maker: Maker, image: &Level) {
    let target = GL_TEXTURE_2D;
    let (w, h, texels) = (image.width, image.height, image.texels.as_flattened());
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    match maker {
        Maker::Generate => {
            glTexImage2D(target, 0, GL_RGBA8, w, h, 0, format, ty, texels);
            glGenerateMipmap(target);
        }
        Maker::Automatic => {
            glTexParameteri(target, GL_GENERATE_MIPMAP, 1);
            glTexImage2D(target, 0, GL_RGBA8, w, h, 0, format, ty, texels);
        }
        Maker::Glu => {
            gluBuild2DMipmaps(target, GL_RGBA8, w as i32, h as i32, format, ty, texels);
        }
        Maker::Kaiser => {
            let mut level = image.clone();
            glTexImage2D(target, 0, GL_RGBA8, w, h, 0, format, ty, texels);
            for number in 1..level_count([w, h]) {
                level = halved(&level, level_size([w, h], number));
                let texels = level.texels.as_flattened();
                let (w, h) = (level.width, level.height);
                glTexImage2D(target, number, GL_RGBA8, w, h, 0, format, ty, texels);
            }
        }
    }
}

/// Texels of the old level on each side of a new one that a Kaiser filter weighs, in widths of the new one.
const REACH: f64 = 3.0;

/// sinc(x) under a Kaiser window of α = 4 over [-REACH, REACH].
fn kaiser(x: f64) -> f64 {
    if x.abs() >= REACH {
        return 0.0;
    }
    // The modified Bessel function of order 0, by its series.
    let bessel = |x: f64| {
        let (mut sum, mut term) = (1.0, 1.0);
        for k in 1..24 {
            term *= (x / (2.0 * f64::from(k))).powi(2);
            sum += term;
        }
        sum
    };
    let phase = std::f64::consts::PI * x;
    let sinc = if x == 0.0 { 1.0 } else { phase.sin() / phase };
    sinc * bessel(4.0 * (1.0 - (x / REACH).powi(2)).sqrt()) / bessel(4.0)
}

/// The next level by a Kaiser filter, along rows and then along columns; the image repeats.
fn halved(level: &Level, [width, height]: [usize; 2]) -> Level {
    let weights = |at: usize, old: usize, new: usize| -> Vec<(usize, f64)> {
        let scale = old as f64 / new as f64;
        let centre = (at as f64 + 0.5) * scale;
        let (low, high) = (centre - REACH * scale, centre + REACH * scale);
        let taps = (low.floor() as i64..=high.ceil() as i64).map(|i| {
            let weight = kaiser((i as f64 + 0.5 - centre) / scale);
            (i.rem_euclid(old as i64) as usize, weight)
        });
        let taps: Vec<(usize, f64)> = taps.filter(|(_, weight)| *weight != 0.0).collect();
        let sum: f64 = taps.iter().map(|(_, weight)| weight).sum();
        taps.into_iter().map(|(i, weight)| (i, weight / sum)).collect()
    };
    let texel = |i: usize, j: usize| level.texels[j * level.width + i].map(f64::from);
    let mix = |taps: &[(usize, f64)], of: &dyn Fn(usize) -> [f64; 4]| {
        let mut sum = [0.0; 4];
        for (i, weight) in taps {
            of(*i).iter().zip(&mut sum).for_each(|(c, sum)| *sum += weight * c);
        }
        sum
    };
    let mut rows = Vec::with_capacity(width * level.height);
    let across: Vec<_> = (0..width).map(|i| weights(i, level.width, width)).collect();
    for j in 0..level.height {
        rows.extend(across.iter().map(|taps| mix(taps, &|i| texel(i, j))));
    }
    let up: Vec<_> = (0..height).map(|j| weights(j, level.height, height)).collect();
    Level::from_fn(width, height, |i, j| {
        mix(&up[j], &|j| rows[j * width + i]).map(|c| c.round().clamp(0.0, 255.0) as u8)
    })
}

fn anisotropic(side: usize) -> Result<Alternatives, ProbeError> {
    let scene = super::scene("floor-80", side)?;
    debug_assert!(matches!(scene.surface, Surface::Plane(_)));
    let device = one_thread()?;
    let mut all = Vec::new();
    for limit in [1u32, 2, 4, 8, 16] {
        let stage = Stage::new(&device, Clock::Processor, side, || {
            set_texture(&scene, GL_LINEAR_MIPMAP_LINEAR, limit);
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            let corners = corners(&scene);
            Frame::new(move || draw_corners(&corners))
        })?;
        let name = if limit == 1 { "trilinear".to_owned() } else { format!("up to {limit}") };
        all.push(Alternative::new(name, stage));
    }
    let reference = pictured(side, |pixel| scene.reference(pixel, side));
    Ok(Alternatives { side, reference, counts: everywhere, all })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kaiser_filter_keeps_what_is_even() {
        let even = Level::from_fn(8, 4, |_, _| [100, 0, 255, 7]);
        let half = halved(&even, [4, 2]);
        assert!(half.texels.iter().all(|texel| *texel == [100, 0, 255, 7]));
        assert_eq!((kaiser(0.0), kaiser(REACH)), (1.0, 0.0));
    }
}
