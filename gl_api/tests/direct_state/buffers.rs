//! Buffers by name and bound.

use crate::{Twin, context, flags, integer, run};
use gl_api::*;

const T: GLenum = GL_ARRAY_BUFFER;
const BYTES: [u8; 32] = [
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
    27, 28, 29, 30, 31, 32,
];

macro_rules! twins {
    ($($name:ident: $named:expr, $bound:expr;)*) => {
        &[$(Twin { name: stringify!($name), named: $named, bound: $bound }),*]
    };
}

#[test]
fn data_copies_clears_and_mappings() {
    let (mut named, mut bound) = (context(), context());
    let mut names = [0; 2];
    named.create_buffers(2, &mut names);
    assert!(named.is_buffer(names[0]) && named.is_buffer(names[1]));
    bound.bind_buffer(GL_COPY_WRITE_BUFFER, 2);
    bound.bind_buffer(T, 1);
    run(
        &mut named,
        1,
        &mut bound,
        twins! {
            data: |c, b| c.named_buffer_data(b, 32, Data::Bytes(&BYTES), GL_STREAM_DRAW),
                |c| c.buffer_data(T, 32, Data::Bytes(&BYTES), GL_STREAM_DRAW);
            usage: |c, b| c.named_buffer_data(b, 32, Data::Bytes(&BYTES), GL_RGBA),
                |c| c.buffer_data(T, 32, Data::Bytes(&BYTES), GL_RGBA);
            sub: |c, b| c.named_buffer_sub_data(b, 3, 4, Data::Bytes(&BYTES)),
                |c| c.buffer_sub_data(T, 3, 4, Data::Bytes(&BYTES));
            outside: |c, b| c.named_buffer_sub_data(b, 30, 4, Data::Bytes(&BYTES)),
                |c| c.buffer_sub_data(T, 30, 4, Data::Bytes(&BYTES));
            storage: |c, _| c.named_buffer_storage(2, 64, Data::Null, GL_DYNAMIC_STORAGE_BIT),
                |c| c.buffer_storage(GL_COPY_WRITE_BUFFER, 64, Data::Null, GL_DYNAMIC_STORAGE_BIT);
            immutable: |c, _| c.named_buffer_data(2, 64, Data::Null, GL_STATIC_DRAW),
                |c| c.buffer_data(GL_COPY_WRITE_BUFFER, 64, Data::Null, GL_STATIC_DRAW);
            copy: |c, b| c.copy_named_buffer_sub_data(b, 2, 1, 10, 20),
                |c| c.copy_buffer_sub_data(T, GL_COPY_WRITE_BUFFER, 1, 10, 20);
            clear: |c, b| c.clear_named_buffer_sub_data(b, GL_R8UI, 8, 4, GL_RED_INTEGER, GL_UNSIGNED_BYTE, Data::Bytes(&[7])),
                |c| c.clear_buffer_sub_data(T, GL_R8UI, 8, 4, GL_RED_INTEGER, GL_UNSIGNED_BYTE, Data::Bytes(&[7]));
            clear_odd: |c, b| c.clear_named_buffer_sub_data(b, GL_R32UI, 1, 4, GL_RED_INTEGER, GL_UNSIGNED_INT, Data::Null),
                |c| c.clear_buffer_sub_data(T, GL_R32UI, 1, 4, GL_RED_INTEGER, GL_UNSIGNED_INT, Data::Null);
            map: |c, b| assert!(!c.map_named_buffer_range(b, 4, 8, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT).is_null()),
                |c| assert!(!c.map_buffer_range(T, 4, 8, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT).is_null());
            mapped: |c, b| c.named_buffer_sub_data(b, 0, 4, Data::Bytes(&BYTES)),
                |c| c.buffer_sub_data(T, 0, 4, Data::Bytes(&BYTES));
            flush: |c, b| c.flush_mapped_named_buffer_range(b, 2, 4), |c| c.flush_mapped_buffer_range(T, 2, 4);
            flush_past: |c, b| c.flush_mapped_named_buffer_range(b, 6, 4), |c| c.flush_mapped_buffer_range(T, 6, 4);
            unmap: |c, b| assert!(c.unmap_named_buffer(b)), |c| assert!(c.unmap_buffer(T));
            map_all: |c, b| assert!(!c.map_named_buffer(b, GL_READ_ONLY).is_null()),
                |c| assert!(!c.map_buffer(T, GL_READ_ONLY).is_null());
        },
    );
    let mut pointer = [std::ptr::null_mut()];
    named.get_named_buffer_pointerv(1, GL_BUFFER_MAP_POINTER, &mut pointer);
    assert!(!pointer[0].is_null());
    let state = [
        GL_BUFFER_SIZE,
        GL_BUFFER_USAGE,
        GL_BUFFER_ACCESS,
        GL_BUFFER_MAPPED,
        GL_BUFFER_MAP_LENGTH,
        GL_BUFFER_STORAGE_FLAGS,
    ];
    for pname in state {
        let (mut one, mut long, mut other) = ([-1], [-1], [-1]);
        named.get_named_buffer_parameteriv(1, pname, &mut one);
        named.get_named_buffer_parameteri64v(1, pname, &mut long);
        bound.get_buffer_parameteriv(T, pname, &mut other);
        assert_eq!((one, long[0]), (other, i64::from(other[0])), "{}", enum_name(pname));
    }
    assert!(named.unmap_named_buffer(1) && bound.unmap_buffer(T));
    named.clear_named_buffer_data(2, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, Data::Bytes(&[9]));
    bound.clear_buffer_data(
        GL_COPY_WRITE_BUFFER,
        GL_R8UI,
        GL_RED_INTEGER,
        GL_UNSIGNED_BYTE,
        Data::Bytes(&[9]),
    );
    named.copy_named_buffer_sub_data(1, 2, 0, 5, 16);
    bound.copy_buffer_sub_data(T, GL_COPY_WRITE_BUFFER, 0, 5, 16);
    let (mut one, mut other) = ([0; 64], [0; 64]);
    named.get_named_buffer_sub_data(2, 0, 64, DataOut::Bytes(&mut one));
    bound.get_buffer_sub_data(GL_COPY_WRITE_BUFFER, 0, 64, DataOut::Bytes(&mut other));
    assert_eq!(one, other);
    assert_eq!(one[5..8], [1, 2, 3]);
    assert_eq!((flags(&mut named), flags(&mut bound)), (GL_NO_ERROR, GL_NO_ERROR));
    assert_eq!(integer(&mut named, GL_ARRAY_BUFFER_BINDING), 0);
}
