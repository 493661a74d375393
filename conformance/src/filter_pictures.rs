//! A textured floor, drawn by the driver and by the formulas, with each of the six minification
//! filters.

use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Derivatives, Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::mipmap::{Storage, Volume};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{FIELD, ProbeError, Session};
use crate::tradeoff::{Picture, Scene, scenes};

/// Factor that differences are multiplied by.
const MAGNIFIED: f64 = 64.0;

/// For each filter: the driver's picture, the formula's, and their difference.
///
/// # Errors
/// When the driver reports an error.
pub fn pictures() -> Result<Vec<[Picture; 3]>, ProbeError> {
    let Some(scene) = scenes(FIELD).into_iter().find(|scene| scene.name == "floor-70") else {
        return Ok(Vec::new());
    };
    let image = mipmaps(&scene.image);
    let mut rows = Vec::new();
    for min in [Filter::Nearest, Filter::Linear] {
        for mipmap in [Mipmap::None, Mipmap::Nearest, Mipmap::Linear] {
            let filters = Filters { min, mipmap, mag: min };
            rows.push(compared(&scene, &image, filters)?);
        }
    }
    Ok(rows)
}

/// The mipmap of an image, by the formula.
fn mipmaps(base: &Level) -> Vec<Level> {
    let count = base.width * base.height;
    let texels = (0..count).map(|p| base.texel(p % base.width, p / base.width)).collect();
    let volume = Volume { size: [base.width, base.height, 1], texels };
    let smaller = volume.chain(Storage::Bytes, Variant::CORRECT).into_iter().map(|level| {
        let [w, h, _] = level.size;
        Level::from_fn(w, h, |i, j| level.texels[j * w + i].map(|c| (c * 255.0).round() as u8))
    });
    std::iter::once(base.clone()).chain(smaller).collect()
}

fn compared(scene: &Scene, image: &[Level], filters: Filters) -> Result<[Picture; 3], ProbeError> {
    let sampler = Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters,
        lod: LodState::default(),
        range: LevelRange { base: 0, last: image.len() - 1 },
    };
    // Coordinates and derivatives in f32, the same for both.
    let size = [scene.image.width as f64, scene.image.height as f64];
    let st = |x: f64, y: f64| {
        let ndc = [x, y].map(|c| 2.0 * c / FIELD as f64 - 1.0);
        let texels = scene.texels(ndc);
        [texels[0] / size[0], texels[1] / size[1]]
    };
    let cases: Vec<[[f32; 4]; 3]> = (0..FIELD * FIELD)
        .map(|p| {
            let (x, y) = ((p % FIELD) as f64 + 0.5, (p / FIELD) as f64 + 0.5);
            let ([s, t], right, up) = (st(x, y), st(x + 1.0, y), st(x, y + 1.0));
            let d = [right[0] - s, right[1] - t, up[0] - s, up[1] - t].map(|c| c as f32);
            [[s as f32, t as f32, 0.0, 0.0], d, [0.0; 4]]
        })
        .collect();
    let session = Session::open()?;
    session.texture_2d(image, &sampler)?;
    let body = "uniform sampler2D image;
                vec4 value() { return texture2DGradARB(image, a.xy, b.xy, b.zw); }";
    let driver = session.field(body, 4, &cases)?;
    let formula: Vec<[f64; 4]> = cases
        .iter()
        .map(|[a, d, _]| {
            let [sx, tx, sy, ty] = d.map(f64::from);
            let derivatives = Derivatives { dx: [sx, tx], dy: [sy, ty] };
            let st = [a[0].into(), a[1].into()];
            sample::sample(image, &sampler, st, &derivatives, Variant::CORRECT)
        })
        .collect();
    let difference = driver
        .iter()
        .zip(&formula)
        .map(|(a, b)| std::array::from_fn(|c| MAGNIFIED * (a[c] - b[c]).abs()))
        .collect();
    let name = format!("{:?}-mip-{:?}", filters.min, filters.mipmap).to_lowercase();
    let picture = |of: &str, pixels| Picture { name: format!("{name}-{of}"), pixels, side: FIELD };
    Ok([picture("driver", driver), picture("formula", formula), picture("difference", difference)])
}
