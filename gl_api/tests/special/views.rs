//! Texture views: the oracle is a plain copy of the bytes that the storage holds (GL 4.3, section 8.18).

use super::{context, fine, pixel, shading};
use gl_api::*;

/// Formats of 32 bits, and how a client gives their bytes as they are.
const FORMATS: [(GLenum, GLenum, GLenum); 7] = [
    (GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE),
    (GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE),
    (GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE),
    (GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE),
    (GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT),
    (GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT),
    (GL_RGB10_A2UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV),
];

/// The sides of level 0, and how many levels there are.
const SIDE: usize = 8;
const LEVELS: usize = 4;

/// What immutable storage holds: by level, layer after layer.
struct Stored(Vec<Vec<u8>>);

fn side(level: usize) -> usize {
    SIDE >> level
}

/// Bytes of a layer of a level.
fn layer_bytes(target: GLenum, level: usize) -> usize {
    match target {
        GL_TEXTURE_1D | GL_TEXTURE_1D_ARRAY => 4 * side(level),
        _ => 4 * side(level) * side(level),
    }
}

pub fn name(c: &mut Context) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    name[0]
}

/// Width, height and depth of layers as calls on levels have them.
fn extent(target: GLenum, level: usize, layers: usize) -> [GLsizei; 3] {
    let (side, layers) = (side(level) as GLsizei, layers as GLsizei);
    match target {
        GL_TEXTURE_1D => [side, 1, 1],
        GL_TEXTURE_1D_ARRAY => [side, layers, 1],
        GL_TEXTURE_2D => [side, side, 1],
        _ => [side, side, layers],
    }
}

/// A texture with storage; layers of a volume are slices.
fn texture(c: &mut Context, target: GLenum, internal: GLenum, layers: usize) -> GLuint {
    let name = name(c);
    c.bind_texture(target, name);
    let (levels, [width, height, depth]) = (LEVELS as GLsizei, extent(target, 0, layers));
    match target {
        GL_TEXTURE_1D => c.tex_storage_1d(target, levels, internal, width),
        GL_TEXTURE_1D_ARRAY | GL_TEXTURE_2D | GL_TEXTURE_CUBE_MAP => {
            c.tex_storage_2d(target, levels, internal, width, height);
        }
        _ => c.tex_storage_3d(target, levels, internal, width, height, depth),
    }
    c.bind_texture(target, 0);
    fine(c);
    name
}

/// The bytes of layers of a level of a texture (its name, target, format, and the level of the storage that is its level
/// 0), by `glGetTextureSubImage`.
fn read(
    c: &mut Context,
    (name, target, format, first): (GLuint, GLenum, usize, usize),
    level: usize,
    layers: usize,
) -> Vec<u8> {
    let (_, format, ty) = FORMATS[format];
    let [width, height, depth] = extent(target, first + level, layers);
    let mut bytes = vec![0; (4 * width * height * depth) as usize];
    let (length, out) = (bytes.len() as GLsizei, DataOut::Bytes(&mut bytes));
    let level = level as GLint;
    c.get_texture_sub_image(name, level, 0, 0, 0, width, height, depth, format, ty, length, out);
    fine(c);
    bytes
}

/// Overwrites layers of a level.
fn write(
    c: &mut Context,
    (name, target, format, first): (GLuint, GLenum, usize, usize),
    level: usize,
    layers: usize,
    bytes: &[u8],
) {
    let (_, format, ty) = FORMATS[format];
    let [width, height, depth] = extent(target, first + level, layers);
    let (level, data) = (level as GLint, Data::Bytes(bytes));
    match target {
        GL_TEXTURE_1D => c.texture_sub_image_1d(name, level, 0, width, format, ty, data),
        GL_TEXTURE_1D_ARRAY | GL_TEXTURE_2D => {
            c.texture_sub_image_2d(name, level, 0, 0, width, height, format, ty, data);
        }
        _ => c.texture_sub_image_3d(name, level, 0, 0, 0, width, height, depth, format, ty, data),
    }
    fine(c);
}

/// Bytes that differ from call to call.
fn noise(seed: &mut u32, count: usize) -> Vec<u8> {
    let mut next = || {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (*seed >> 24) as u8
    };
    (0..count).map(|_| next()).collect()
}

/// A target and how many layers a texture of it has.
type Layered = (GLenum, usize);

/// Textures, and views of them.
const VIEWS: &[(Layered, &[Layered])] = &[
    ((GL_TEXTURE_1D, 1), &[(GL_TEXTURE_1D, 1), (GL_TEXTURE_1D_ARRAY, 1)]),
    ((GL_TEXTURE_2D, 1), &[(GL_TEXTURE_2D, 1), (GL_TEXTURE_2D_ARRAY, 1)]),
    ((GL_TEXTURE_1D_ARRAY, 5), &[(GL_TEXTURE_1D, 1), (GL_TEXTURE_1D_ARRAY, 3)]),
    (
        (GL_TEXTURE_2D_ARRAY, 14),
        &[
            (GL_TEXTURE_2D, 1),
            (GL_TEXTURE_2D_ARRAY, 5),
            (GL_TEXTURE_2D_ARRAY, 14),
            (GL_TEXTURE_CUBE_MAP, 6),
            (GL_TEXTURE_CUBE_MAP_ARRAY, 12),
        ],
    ),
    (
        (GL_TEXTURE_CUBE_MAP, 6),
        &[
            (GL_TEXTURE_2D, 1),
            (GL_TEXTURE_2D_ARRAY, 4),
            (GL_TEXTURE_CUBE_MAP, 6),
            (GL_TEXTURE_CUBE_MAP_ARRAY, 6),
        ],
    ),
    (
        (GL_TEXTURE_CUBE_MAP_ARRAY, 12),
        &[
            (GL_TEXTURE_2D, 1),
            (GL_TEXTURE_2D_ARRAY, 12),
            (GL_TEXTURE_CUBE_MAP, 6),
            (GL_TEXTURE_CUBE_MAP_ARRAY, 6),
        ],
    ),
];

/// What is written through a texture or a view of it is read through both, in every format and target, at every level; so is
/// what a view of the view shows.
#[test]
fn texels_are_those_of_the_storage_whichever_texture_names_them() {
    let (mut c, mut seed, mut checked) = (context(4, 4), 1, 0);
    for (number, &((target, layers), views)) in VIEWS.iter().enumerate() {
        for (at, &(view_target, view_layers)) in views.iter().enumerate() {
            for (format, &(internal, ..)) in FORMATS.iter().enumerate() {
                let of = (number + at) % FORMATS.len();
                let origin = texture(&mut c, target, FORMATS[of].0, layers);
                let mut stored = Stored(Vec::new());
                for level in 0..LEVELS {
                    let bytes = noise(&mut seed, layers * layer_bytes(target, level));
                    write(&mut c, (origin, target, of, 0), level, layers, &bytes);
                    stored.0.push(bytes);
                }
                // The middle of its layers, the upper levels.
                let first_layer = (layers - view_layers) / 2;
                let first_level = 1 + (number + format) % 2;
                let view = name(&mut c);
                let numbers = [first_level, 9, first_layer, view_layers].map(|n| n as GLuint);
                let [minlevel, numlevels, minlayer, numlayers] = numbers;
                c.texture_view(
                    view,
                    view_target,
                    origin,
                    internal,
                    minlevel,
                    numlevels,
                    minlayer,
                    numlayers,
                );
                // A view of the view: its last level and layers.
                let last = name(&mut c);
                let (a, b) = match view_target {
                    GL_TEXTURE_CUBE_MAP | GL_TEXTURE_CUBE_MAP_ARRAY => (GL_TEXTURE_2D, 5),
                    target => (target, view_layers - 1),
                };
                let level = (LEVELS - 1 - first_level) as GLuint;
                c.texture_view(last, a, view, FORMATS[of].0, level, 1, b as GLuint, 1);
                fine(&mut c);
                for through_view in [false, true, false, true] {
                    for level in first_level..LEVELS {
                        let bytes = layer_bytes(target, level);
                        let part = first_layer * bytes..(first_layer + view_layers) * bytes;
                        let shown = (view, view_target, format, first_level);
                        if through_view {
                            let new = noise(&mut seed, view_layers * bytes);
                            write(&mut c, shown, level - first_level, view_layers, &new);
                            stored.0[level][part.clone()].copy_from_slice(&new);
                        } else {
                            let new = noise(&mut seed, layers * bytes);
                            write(&mut c, (origin, target, of, 0), level, layers, &new);
                            stored.0[level] = new;
                        }
                        let found = read(&mut c, shown, level - first_level, view_layers);
                        assert_eq!(found, stored.0[level][part], "{target:X} {view_target:X}");
                        let found = read(&mut c, (origin, target, of, 0), level, layers);
                        assert_eq!(found, stored.0[level], "{target:X} {view_target:X}");
                        checked += 1;
                    }
                }
                let bytes = layer_bytes(target, LEVELS - 1);
                let from = (first_layer + b) * bytes;
                let found = read(&mut c, (last, a, of, LEVELS - 1), 0, 1);
                assert_eq!(found, stored.0[LEVELS - 1][from..from + bytes]);
                // Views live on without it.
                c.delete_textures(1, &[origin]);
                assert_eq!(read(&mut c, (last, a, of, LEVELS - 1), 0, 1), found);
                c.delete_textures(2, &[view, last]);
            }
        }
    }
    assert!(checked > 1000);
}

/// A framebuffer with one attachment, bound.
pub fn framebuffer(c: &mut Context) {
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(GL_FRAMEBUFFER, name[0]);
}

/// Draws and clears to attachments are seen through all textures, those of the same pass too.
#[test]
fn what_is_drawn_to_a_view_is_drawn_to_the_texture() {
    for is_cube in [false, true] {
        let mut c = context(4, 4);
        let target = if is_cube { GL_TEXTURE_CUBE_MAP } else { GL_TEXTURE_2D_ARRAY };
        let origin = texture(&mut c, target, GL_RGBA8, 6);
        let views: Vec<_> = (0..6).map(|_| name(&mut c)).collect();
        for (layer, &view) in views.iter().enumerate() {
            let internal = if layer == 4 { GL_RGBA8UI } else { GL_RGBA8 };
            c.texture_view(view, GL_TEXTURE_2D, origin, internal, 1, 2, layer as GLuint, 1);
        }
        framebuffer(&mut c);
        // Two views of one storage in one pass.
        for (at, view) in [(GL_COLOR_ATTACHMENT0, views[1]), (GL_COLOR_ATTACHMENT1, views[2])] {
            c.framebuffer_texture_2d(GL_FRAMEBUFFER, at, GL_TEXTURE_2D, view, 0);
        }
        c.draw_buffers(2, &[GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1]);
        c.clear_bufferfv(GL_COLOR, 0, &[1.0, 0.0, 0.0, 1.0]);
        c.clear_bufferfv(GL_COLOR, 1, &[0.0, 1.0, 0.0, 1.0]);
        // The origin's own level, and integers.
        framebuffer(&mut c);
        c.framebuffer_texture_layer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, origin, 1, 3);
        c.clear_color(0.0, 0.0, 1.0, 1.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        framebuffer(&mut c);
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, views[4], 0);
        c.clear_bufferuiv(GL_COLOR, 0, &[1, 2, 3, 4]);
        fine(&mut c);
        let bytes = read(&mut c, (origin, target, 0, 0), 1, 6);
        let colors = [[0; 4], [255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [1, 2, 3, 4]];
        for (layer, texels) in bytes.chunks_exact(4 * 16).enumerate() {
            let expected = colors.get(layer).unwrap_or(&[0; 4]);
            assert!(texels.chunks_exact(4).all(|texel| texel == expected), "{layer}");
        }
        assert_eq!(read(&mut c, (views[3], GL_TEXTURE_2D, 0, 1), 0, 1)[..4], [0, 0, 255, 255]);
        // The integer view after the layer was drawn to as colours.
        framebuffer(&mut c);
        c.framebuffer_texture_layer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, origin, 1, 4);
        c.enable(GL_SCISSOR_TEST);
        c.scissor(0, 0, 1, 1);
        c.clear_color(1.0, 1.0, 1.0, 0.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        let found = read(&mut c, (views[4], GL_TEXTURE_2D, 2, 1), 0, 1);
        assert_eq!(found[..8], [255, 255, 255, 0, 1, 2, 3, 4]);
        // Deleting the texture takes its own attachments away, not those of its views.
        framebuffer(&mut c);
        c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, views[0], 0);
        c.delete_textures(1, &[origin]);
        assert_eq!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
        c.delete_textures(1, &[views[0]]);
        assert_ne!(c.check_framebuffer_status(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    }
}

const FRAGMENT: &str = "#version 130
    uniform sampler2D image;
    void main() { gl_FragColor = texture(image, vec2(0.5)); }";

fn quad(c: &mut Context) {
    c.rectf(-1.0, -1.0, 1.0, 1.0);
}

/// A sampled view sees what was drawn and written to the texture before each draw, in its own format and with its own
/// levels and state.
#[test]
fn what_is_sampled_is_what_was_written_last() {
    let mut c = context(4, 4);
    let origin = texture(&mut c, GL_TEXTURE_2D, GL_RGBA8, 1);
    let [linear, srgb] = [name(&mut c), name(&mut c)];
    c.texture_view(linear, GL_TEXTURE_2D, origin, GL_RGBA8, 1, 2, 0, 1);
    c.texture_view(srgb, GL_TEXTURE_2D, origin, GL_SRGB8_ALPHA8, 1, 1, 0, 1);
    shading::use_program(&mut c, "", FRAGMENT);
    // Levels with a mean: the base level alone is sampled.
    for view in [linear, srgb] {
        c.bind_texture(GL_TEXTURE_2D, view);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    }
    for value in [10u8, 90, 200, 255] {
        for by_drawing in [false, true] {
            let value = if by_drawing { value } else { value / 2 };
            if by_drawing {
                framebuffer(&mut c);
                c.framebuffer_texture_2d(
                    GL_FRAMEBUFFER,
                    GL_COLOR_ATTACHMENT0,
                    GL_TEXTURE_2D,
                    origin,
                    1,
                );
                let part = f32::from(value) / 255.0;
                c.clear_color(part, part, part, 1.0);
                c.clear(GL_COLOR_BUFFER_BIT);
                c.bind_framebuffer(GL_FRAMEBUFFER, 0);
            } else {
                let bytes = [value, value, value, 255].repeat(16);
                write(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 1, 1, &bytes);
            }
            c.bind_texture(GL_TEXTURE_2D, linear);
            quad(&mut c);
            assert_eq!(pixel(&mut c, 1, 1), [value, value, value, 255]);
            c.bind_texture(GL_TEXTURE_2D, srgb);
            quad(&mut c);
            let encoded = f64::from(value) / 255.0;
            let decoded = if encoded <= 0.04045 {
                encoded / 12.92
            } else {
                ((encoded + 0.055) / 1.055).powf(2.4)
            };
            let found = f64::from(pixel(&mut c, 1, 1)[0]);
            assert!((found - decoded * 255.0).abs() <= 0.5 + 1e-3, "{value}");
        }
    }
    // With mipmaps, made through one view and sampled through the other.
    let bytes: Vec<u8> = (0..16u8).flat_map(|at| [at * 16, 0, 0, 255]).collect();
    write(&mut c, (linear, GL_TEXTURE_2D, 0, 1), 0, 1, &bytes);
    c.bind_texture(GL_TEXTURE_2D, linear);
    c.generate_mipmap(GL_TEXTURE_2D);
    fine(&mut c);
    let mean = read(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 2, 1);
    let reds: Vec<u8> = mean.chunks_exact(4).map(|texel| texel[0]).collect();
    assert_eq!(reds, [40, 72, 168, 200]);
    assert_eq!(read(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 3, 1), [0; 4], "no level of the view");
    // A draw that was recorded before a change keeps what it saw.
    c.bind_texture(GL_TEXTURE_2D, linear);
    write(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 1, 1, &[1, 2, 3, 255].repeat(16));
    quad(&mut c);
    write(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 1, 1, &[9, 9, 9, 255].repeat(16));
    assert_eq!(pixel(&mut c, 1, 1), [1, 2, 3, 255]);
}

/// `glCopyImageSubData` and `glClearTexSubImage` through views.
#[test]
fn texels_are_copied_and_cleared_through_views() {
    let (mut c, mut seed) = (context(4, 4), 7);
    let origin = texture(&mut c, GL_TEXTURE_2D_ARRAY, GL_RGBA8, 8);
    let mut bytes = noise(&mut seed, 8 * layer_bytes(GL_TEXTURE_2D_ARRAY, 0));
    write(&mut c, (origin, GL_TEXTURE_2D_ARRAY, 0, 0), 0, 8, &bytes);
    let cube = name(&mut c);
    c.texture_view(cube, GL_TEXTURE_CUBE_MAP, origin, GL_R32UI, 0, 4, 2, 6);
    // Face 1 is layer 3; the layer 0 is none of the view.
    let (d2, cubes) = (GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP);
    c.copy_image_sub_data(origin, d2, 0, 0, 0, 0, cube, cubes, 0, 0, 0, 1, 8, 8, 1);
    fine(&mut c);
    let layer = layer_bytes(d2, 0);
    bytes.copy_within(0..layer, 3 * layer);
    let value = 0x0403_0201u32.to_ne_bytes();
    let (format, ty) = (GL_RED_INTEGER, GL_UNSIGNED_INT);
    c.clear_tex_sub_image(cube, 0, 2, 1, 5, 1, 1, 1, format, ty, Data::Bytes(&value));
    fine(&mut c);
    let at = 7 * layer + 4 * (SIDE + 2);
    bytes[at..at + 4].copy_from_slice(&0x0403_0201u32.to_le_bytes());
    assert_eq!(read(&mut c, (origin, d2, 0, 0), 0, 8), bytes);
}

#[track_caller]
fn parameters(c: &mut Context, name: GLuint, expected: [GLint; 6]) {
    let names = [
        GL_TEXTURE_IMMUTABLE_FORMAT,
        GL_TEXTURE_IMMUTABLE_LEVELS,
        GL_TEXTURE_VIEW_MIN_LEVEL,
        GL_TEXTURE_VIEW_NUM_LEVELS,
        GL_TEXTURE_VIEW_MIN_LAYER,
        GL_TEXTURE_VIEW_NUM_LAYERS,
    ];
    let found = names.map(|pname| {
        let mut value = [-1];
        c.get_texture_parameteriv(name, pname, &mut value);
        value[0]
    });
    fine(c);
    assert_eq!(found, expected);
}

#[test]
fn a_view_says_what_it_shows() {
    let mut c = context(4, 4);
    let plain = name(&mut c);
    c.bind_texture(GL_TEXTURE_2D, plain);
    parameters(&mut c, plain, [0; 6]);
    let origin = texture(&mut c, GL_TEXTURE_2D_ARRAY, GL_RGBA8, 12);
    parameters(&mut c, origin, [1, 4, 0, 4, 0, 12]);
    let cube = texture(&mut c, GL_TEXTURE_CUBE_MAP, GL_RGBA8, 6);
    parameters(&mut c, cube, [1, 4, 0, 4, 0, 6]);
    let volume = texture(&mut c, GL_TEXTURE_3D, GL_RGBA8, 6);
    parameters(&mut c, volume, [1, 4, 0, 4, 0, 1]);
    let [view, inner] = [name(&mut c), name(&mut c)];
    c.texture_view(view, GL_TEXTURE_CUBE_MAP_ARRAY, origin, GL_SRGB8_ALPHA8, 1, 7, 6, 99);
    parameters(&mut c, view, [1, 4, 1, 3, 6, 6]);
    c.texture_view(inner, GL_TEXTURE_2D_ARRAY, view, GL_RGBA8UI, 1, 1, 2, 3);
    parameters(&mut c, inner, [1, 4, 2, 1, 8, 3]);
    let mut level = [0; 4];
    let names = [GL_TEXTURE_WIDTH, GL_TEXTURE_DEPTH, GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_TARGET];
    for (value, pname) in level.iter_mut().zip(&names[..3]) {
        c.get_texture_level_parameteriv(inner, 0, *pname, std::slice::from_mut(value));
    }
    c.get_texture_parameteriv(inner, names[3], std::slice::from_mut(&mut level[3]));
    fine(&mut c);
    let expected = [GL_RGBA8UI, GL_TEXTURE_2D_ARRAY].map(|name| name as GLint);
    assert_eq!(level, [2, 3, expected[0], expected[1]]);
    assert!(c.is_texture(view));
}

/// Contexts that share objects see through views what another wrote.
#[test]
fn contexts_share_views() {
    let mut c = context(4, 4);
    let mut other = c
        .new_shared(ContextDesc { width: 4, height: 4, ..ContextDesc::default() })
        .expect("a device");
    let origin = texture(&mut c, GL_TEXTURE_2D, GL_RGBA8, 1);
    let view = name(&mut other);
    other.texture_view(view, GL_TEXTURE_2D, origin, GL_RGBA8UI, 0, 4, 0, 1);
    for value in 0..3u8 {
        let bytes = [value; 4].repeat(SIDE * SIDE);
        write(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 0, 1, &bytes);
        assert_eq!(read(&mut other, (view, GL_TEXTURE_2D, 2, 0), 0, 1), bytes);
        let bytes = [value + 100; 4].repeat(SIDE * SIDE);
        write(&mut other, (view, GL_TEXTURE_2D, 2, 0), 0, 1, &bytes);
        assert_eq!(read(&mut c, (origin, GL_TEXTURE_2D, 0, 0), 0, 1), bytes);
    }
}
