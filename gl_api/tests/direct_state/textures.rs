//! Textures by name and bound.

use crate::{Twin, context, flags, integer, run};
use gl_api::*;

const BYTE: GLenum = GL_UNSIGNED_BYTE;

/// The texels of a call: no two are equal.
const TEXELS: [u8; 4096] = {
    let mut bytes = [0; 4096];
    let mut at = 0;
    while at < bytes.len() {
        bytes[at] = (at * 7 + at / 256 * 31) as u8;
        at += 1;
    }
    bytes
};

fn texels() -> Data<'static> {
    Data::Bytes(&TEXELS)
}

/// The bytes of levels of a texture that is bound to a target, faces one after the other.
fn levels(c: &mut Context, targets: &[GLenum]) -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    for &target in targets {
        for level in 0..4 {
            let mut bytes = vec![0; 8 * 8 * 6 * 4];
            c.get_tex_image(target, level, GL_RGBA, BYTE, DataOut::Bytes(&mut bytes));
            all.push(bytes);
        }
    }
    all
}

const FACES: [GLenum; 6] = [
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
    GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
    GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
];

/// Pixels in the framebuffer that calls copy from.
fn painted(c: &mut Context) {
    c.window_pos_2i(0, 0);
    c.draw_pixels(8, 8, GL_RGBA, BYTE, texels());
    assert_eq!(flags(c), GL_NO_ERROR, "{:?}", c.messages());
}

/// Runs twins on a texture of a target, and compares what its images have at the end.
fn compare(target: GLenum, images: &[GLenum], twins: &[Twin]) {
    let (mut named, mut bound) = (context(), context());
    painted(&mut named);
    painted(&mut bound);
    let mut names = [0; 1];
    named.create_textures(target, 1, &mut names);
    assert!(named.is_texture(names[0]));
    bound.bind_texture(target, names[0]);
    run(&mut named, names[0], &mut bound, twins);
    let binding = integer(&mut named, GL_TEXTURE_BINDING_2D);
    assert_eq!(binding, 0, "named calls bind nothing");
    named.bind_texture(target, names[0]);
    assert_eq!(flags(&mut named), GL_NO_ERROR);
    let (one, other) = (levels(&mut named, images), levels(&mut bound, images));
    assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR));
    assert!(one.iter().flatten().any(|byte| *byte != 0), "there is something");
    assert_eq!(one, other);
}

macro_rules! twins {
    ($($name:ident: $named:expr, $bound:expr;)*) => {
        &[$(Twin { name: stringify!($name), named: $named, bound: $bound }),*]
    };
}

#[test]
fn lines() {
    const T: GLenum = GL_TEXTURE_1D;
    compare(
        T,
        &[T],
        twins! {
            storage: |c, t| c.texture_storage_1d(t, 4, GL_RGBA8, 8), |c| c.tex_storage_1d(T, 4, GL_RGBA8, 8);
            again: |c, t| c.texture_storage_1d(t, 4, GL_RGBA8, 8), |c| c.tex_storage_1d(T, 4, GL_RGBA8, 8);
            sub: |c, t| c.texture_sub_image_1d(t, 0, 2, 5, GL_RGBA, BYTE, texels()),
                |c| c.tex_sub_image_1d(T, 0, 2, 5, GL_RGBA, BYTE, texels());
            outside: |c, t| c.texture_sub_image_1d(t, 0, 5, 5, GL_RGBA, BYTE, texels()),
                |c| c.tex_sub_image_1d(T, 0, 5, 5, GL_RGBA, BYTE, texels());
            copy: |c, t| c.copy_texture_sub_image_1d(t, 1, 1, 3, 2, 2), |c| c.copy_tex_sub_image_1d(T, 1, 1, 3, 2, 2);
            blocks: |c, t| c.compressed_texture_sub_image_1d(t, 0, 0, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, texels()),
                |c| c.compressed_tex_sub_image_1d(T, 0, 0, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, texels());
        },
    );
}

#[test]
fn planes() {
    const T: GLenum = GL_TEXTURE_2D;
    compare(
        T,
        &[T],
        twins! {
            storage: |c, t| c.texture_storage_2d(t, 4, GL_RGBA8, 8, 8), |c| c.tex_storage_2d(T, 4, GL_RGBA8, 8, 8);
            sub: |c, t| c.texture_sub_image_2d(t, 0, 1, 2, 5, 6, GL_BGRA, BYTE, texels()),
                |c| c.tex_sub_image_2d(T, 0, 1, 2, 5, 6, GL_BGRA, BYTE, texels());
            kind: |c, t| c.texture_sub_image_2d(t, 0, 1, 2, 5, 6, GL_DEPTH_COMPONENT, BYTE, texels()),
                |c| c.tex_sub_image_2d(T, 0, 1, 2, 5, 6, GL_DEPTH_COMPONENT, BYTE, texels());
            null: |c, t| c.texture_sub_image_2d(t, 0, 1, 2, 5, 6, GL_RGBA, BYTE, Data::Null),
                |c| c.tex_sub_image_2d(T, 0, 1, 2, 5, 6, GL_RGBA, BYTE, Data::Null);
            level: |c, t| c.texture_sub_image_2d(t, -1, 0, 0, 1, 1, GL_RGBA, BYTE, texels()),
                |c| c.tex_sub_image_2d(T, -1, 0, 0, 1, 1, GL_RGBA, BYTE, texels());
            mipmap: |c, t| c.generate_texture_mipmap(t), |c| c.generate_mipmap(T);
            copy: |c, t| c.copy_texture_sub_image_2d(t, 0, 0, 1, 3, 2, 4, 5),
                |c| c.copy_tex_sub_image_2d(T, 0, 0, 1, 3, 2, 4, 5);
            blocks: |c, t| c.compressed_texture_sub_image_2d(t, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, texels()),
                |c| c.compressed_tex_sub_image_2d(T, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, texels());
            image: |c, t| c.get_texture_image(t, 0, GL_RGBA, BYTE, 256, DataOut::Bytes(&mut [0; 256])),
                |c| c.get_tex_image(T, 0, GL_RGBA, BYTE, DataOut::Bytes(&mut [0; 256]));
        },
    );
}

#[test]
fn compressed_planes() {
    const T: GLenum = GL_TEXTURE_2D;
    const F: GLenum = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    compare(
        T,
        &[T],
        twins! {
            storage: |c, t| c.texture_storage_2d(t, 4, F, 8, 8), |c| c.tex_storage_2d(T, 4, F, 8, 8);
            blocks: |c, t| c.compressed_texture_sub_image_2d(t, 0, 4, 0, 4, 8, F, 32, texels()),
                |c| c.compressed_tex_sub_image_2d(T, 0, 4, 0, 4, 8, F, 32, texels());
            cut: |c, t| c.compressed_texture_sub_image_2d(t, 0, 2, 0, 4, 8, F, 32, texels()),
                |c| c.compressed_tex_sub_image_2d(T, 0, 2, 0, 4, 8, F, 32, texels());
            size: |c, t| c.compressed_texture_sub_image_2d(t, 0, 4, 0, 4, 8, F, 31, texels()),
                |c| c.compressed_tex_sub_image_2d(T, 0, 4, 0, 4, 8, F, 31, texels());
            read: |c, t| {
                let mut bytes = [0; 64];
                c.get_compressed_texture_image(t, 0, 64, DataOut::Bytes(&mut bytes));
                assert_eq!(bytes[16..32], TEXELS[..16]);
            }, |c| {
                let mut bytes = [0; 64];
                c.get_compressed_tex_image(T, 0, DataOut::Bytes(&mut bytes));
                assert_eq!(bytes[16..32], TEXELS[..16]);
            };
        },
    );
}

#[test]
fn volumes() {
    for target in [GL_TEXTURE_3D, GL_TEXTURE_2D_ARRAY] {
        let (mut named, mut bound) = (context(), context());
        painted(&mut named);
        painted(&mut bound);
        let mut name = [0];
        named.create_textures(target, 1, &mut name);
        bound.bind_texture(target, 1);
        named.texture_storage_3d(1, 3, GL_RGBA8, 8, 8, 4);
        bound.tex_storage_3d(target, 3, GL_RGBA8, 8, 8, 4);
        named.texture_sub_image_3d(1, 0, 1, 2, 1, 6, 5, 3, GL_RGBA, BYTE, texels());
        bound.tex_sub_image_3d(target, 0, 1, 2, 1, 6, 5, 3, GL_RGBA, BYTE, texels());
        named.copy_texture_sub_image_3d(1, 0, 0, 0, 0, 1, 1, 5, 5);
        bound.copy_tex_sub_image_3d(target, 0, 0, 0, 0, 1, 1, 5, 5);
        named.generate_texture_mipmap(1);
        bound.generate_mipmap(target);
        let mut whole = vec![0; 8 * 8 * 4 * 4];
        named.get_texture_image(1, 0, GL_RGBA, BYTE, 1024, DataOut::Bytes(&mut whole));
        named.bind_texture(target, 1);
        let (one, other) = (levels(&mut named, &[target]), levels(&mut bound, &[target]));
        assert_eq!(one, other);
        assert_eq!(whole, one[0][..whole.len()]);
        assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR));
    }
}

#[test]
fn faces_of_cube_maps_are_layers() {
    let (mut named, mut bound) = (context(), context());
    painted(&mut named);
    painted(&mut bound);
    let mut name = [0];
    named.create_textures(GL_TEXTURE_CUBE_MAP, 1, &mut name);
    bound.bind_texture(GL_TEXTURE_CUBE_MAP, 1);
    named.texture_storage_2d(1, 3, GL_RGBA8, 4, 4);
    bound.tex_storage_2d(GL_TEXTURE_CUBE_MAP, 3, GL_RGBA8, 4, 4);
    // Faces 1 to 4 of a call are one after the other in its pixels.
    named.texture_sub_image_3d(1, 0, 0, 1, 1, 4, 3, 4, GL_RGBA, BYTE, texels());
    for face in 1..5 {
        let texels = Data::Bytes(&TEXELS[(face - 1) * 48..face * 48]);
        bound.tex_sub_image_2d(FACES[face], 0, 0, 1, 4, 3, GL_RGBA, BYTE, texels);
    }
    named.copy_texture_sub_image_3d(1, 0, 1, 1, 5, 0, 0, 3, 3);
    bound.copy_tex_sub_image_2d(FACES[5], 0, 1, 1, 0, 0, 3, 3);
    named.generate_texture_mipmap(1);
    bound.generate_mipmap(GL_TEXTURE_CUBE_MAP);
    let mut whole = vec![0; 6 * 64];
    named.get_texture_image(1, 0, GL_RGBA, BYTE, 384, DataOut::Bytes(&mut whole));
    named.bind_texture(GL_TEXTURE_CUBE_MAP, 1);
    let (one, other) = (levels(&mut named, &FACES), levels(&mut bound, &FACES));
    assert_eq!(one, other);
    let faces: Vec<u8> = (0..6).flat_map(|face| one[face * 4][..64].to_vec()).collect();
    assert_eq!(whole, faces);
    let messages = named.messages();
    assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR), "{messages:?}");
    // Too small a buffer for all of them.
    named.get_texture_image(1, 0, GL_RGBA, BYTE, 383, DataOut::Bytes(&mut whole));
    assert_eq!(flags(&mut named), GL_INVALID_OPERATION);
}

#[test]
fn parameters() {
    let (mut named, mut bound) = (context(), context());
    const T: GLenum = GL_TEXTURE_2D;
    let mut name = [0];
    named.create_textures(T, 1, &mut name);
    bound.bind_texture(T, 1);
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            i: |c, t| c.texture_parameteri(t, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as i32),
                |c| c.tex_parameteri(T, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as i32);
            f: |c, t| c.texture_parameterf(t, GL_TEXTURE_LOD_BIAS, 0.5), |c| c.tex_parameterf(T, GL_TEXTURE_LOD_BIAS, 0.5);
            iv: |c, t| c.texture_parameteriv(t, GL_TEXTURE_SWIZZLE_RGBA, &[GL_RED as i32; 4]),
                |c| c.tex_parameteriv(T, GL_TEXTURE_SWIZZLE_RGBA, &[GL_RED as i32; 4]);
            fv: |c, t| c.texture_parameterfv(t, GL_TEXTURE_BORDER_COLOR, &[0.5, 0.25, 2.0, -1.0]),
                |c| c.tex_parameterfv(T, GL_TEXTURE_BORDER_COLOR, &[0.5, 0.25, 2.0, -1.0]);
            level: |c, t| c.texture_parameteri(t, GL_TEXTURE_BASE_LEVEL, -1),
                |c| c.tex_parameteri(T, GL_TEXTURE_BASE_LEVEL, -1);
            value: |c, t| c.texture_parameteri(t, GL_TEXTURE_MIN_FILTER, 3), |c| c.tex_parameteri(T, GL_TEXTURE_MIN_FILTER, 3);
            vector: |c, t| c.texture_parameteri(t, GL_TEXTURE_BORDER_COLOR, 3),
                |c| c.tex_parameteri(T, GL_TEXTURE_BORDER_COLOR, 3);
        },
    );
    let names = [
        GL_TEXTURE_WRAP_S,
        GL_TEXTURE_LOD_BIAS,
        GL_TEXTURE_SWIZZLE_RGBA,
        GL_TEXTURE_BORDER_COLOR,
        GL_TEXTURE_MIN_FILTER,
        GL_TEXTURE_TARGET,
    ];
    for pname in names {
        let (mut one, mut other) = ([-1.0; 4], [-1.0; 4]);
        named.get_texture_parameterfv(1, pname, &mut one);
        bound.get_tex_parameterfv(T, pname, &mut other);
        assert_eq!(one, other, "{}", enum_name(pname));
        let (mut one, mut other) = ([-1; 4], [-1; 4]);
        named.get_texture_parameteriv(1, pname, &mut one);
        bound.get_tex_parameteriv(T, pname, &mut other);
        assert_eq!(one, other, "{}", enum_name(pname));
    }
    let (mut signed, mut unsigned) = ([0; 4], [0; 4]);
    named.texture_parameter_i_iv(1, GL_TEXTURE_BORDER_COLOR, &[-3, 4, 5, 6]);
    named.get_texture_parameter_i_iv(1, GL_TEXTURE_BORDER_COLOR, &mut signed);
    named.texture_parameter_i_uiv(1, GL_TEXTURE_BORDER_COLOR, &[7, 8, 9, u32::MAX]);
    named.get_texture_parameter_i_uiv(1, GL_TEXTURE_BORDER_COLOR, &mut unsigned);
    assert_eq!((signed, unsigned), ([-3, 4, 5, 6], [7, 8, 9, u32::MAX]));
    let mut target = [0];
    named.get_texture_parameteriv(1, GL_TEXTURE_TARGET, &mut target);
    assert_eq!((target[0] as GLenum, flags(&mut named)), (T, GL_NO_ERROR));
}

#[test]
fn levels_and_samples() {
    let mut c = context();
    let mut names = [0; 3];
    c.create_textures(GL_TEXTURE_2D_MULTISAMPLE, 1, &mut names);
    c.create_textures(GL_TEXTURE_2D_MULTISAMPLE_ARRAY, 1, &mut names[1..]);
    c.create_textures(GL_TEXTURE_BUFFER, 1, &mut names[2..]);
    c.texture_storage_2d_multisample(1, 4, GL_RGBA8, 5, 6, true);
    c.texture_storage_3d_multisample(2, 4, GL_RGBA8, 5, 6, 7, true);
    c.create_buffers(1, &mut [0]);
    c.named_buffer_data(1, 64, Data::Null, GL_STATIC_DRAW);
    c.texture_buffer(3, GL_RGBA8, 1);
    assert_eq!(flags(&mut c), GL_NO_ERROR, "{:?}", c.messages());
    let of = |c: &mut Context, name, pname| {
        let (mut number, mut float) = ([-1], [-1.0]);
        c.get_texture_level_parameteriv(name, 0, pname, &mut number);
        c.get_texture_level_parameterfv(name, 0, pname, &mut float);
        assert_eq!(number[0] as f32, float[0]);
        number[0]
    };
    assert_eq!(of(&mut c, 1, GL_TEXTURE_HEIGHT), 6);
    assert_eq!(of(&mut c, 2, GL_TEXTURE_DEPTH), 7);
    assert_eq!(of(&mut c, 1, GL_TEXTURE_SAMPLES), 4);
    assert_eq!(of(&mut c, 3, GL_TEXTURE_WIDTH), 16);
    c.texture_buffer_range(3, GL_RGBA8, 1, 32, 16);
    assert_eq!(of(&mut c, 3, GL_TEXTURE_WIDTH), 4);
    assert_eq!(of(&mut c, 3, GL_TEXTURE_BUFFER_OFFSET), 32);
    assert_eq!(flags(&mut c), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn units_are_bound_by_their_numbers() {
    let mut c = context();
    let mut names = [0; 2];
    c.create_textures(GL_TEXTURE_2D, 1, &mut names);
    c.create_textures(GL_TEXTURE_3D, 1, &mut names[1..]);
    c.bind_texture_unit(3, names[0]);
    c.bind_texture_unit(3, names[1]);
    let bound = |c: &mut Context| {
        [GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP].map(|pname| {
            let mut value = [-1];
            c.get_integeri_v(pname, 3, &mut value);
            value[0]
        })
    };
    assert_eq!(bound(&mut c), [1, 2, 0]);
    assert_eq!(integer(&mut c, GL_TEXTURE_BINDING_2D), 0, "unit 0 is active");
    assert_eq!(integer(&mut c, GL_ACTIVE_TEXTURE), GL_TEXTURE0 as i32);
    c.bind_texture_unit(3, 0);
    assert_eq!(bound(&mut c), [0; 3]);
    c.get_integeri_v(GL_TEXTURE_BINDING_2D, 999, &mut [0]);
    assert_eq!(flags(&mut c), GL_INVALID_VALUE);
}
