//! Buffers and vertex arrays.

use crate::Use;
use gl_api::*;

const TARGET: GLenum = GL_ARRAY_BUFFER;

/// A bound buffer.
fn buffer(c: &mut Context) {
    let mut name = [0];
    c.gen_buffers(1, &mut name);
    c.bind_buffer(TARGET, name[0]);
}

/// The bytes of the bound buffer, as a mapping shows them.
fn contents(c: &mut Context, size: GLsizeiptr) -> Vec<u8> {
    assert!(!c.map_buffer_range(TARGET, 0, size, GL_MAP_READ_BIT).is_null());
    let bytes = c.mapped_bytes(TARGET).expect("it is mapped").to_vec();
    assert!(c.unmap_buffer(TARGET));
    bytes
}

pub const USES: &[Use] = &[
    ("EXT_buffer_storage", |c| {
        buffer(c);
        let flags = GL_MAP_WRITE_BIT | GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT_EXT;
        let flags = flags | GL_MAP_COHERENT_BIT_EXT;
        c.buffer_storage(TARGET, 4, Data::Bytes(&[1, 2, 3, 4]), flags);
        assert!(!c.map_buffer_range(TARGET, 0, 4, flags).is_null());
        c.mapped_bytes(TARGET).expect("it is mapped")[1] = 9;
        // It stays mapped while it is used.
        let mut other = [0];
        c.gen_buffers(1, &mut other);
        c.bind_buffer(GL_COPY_WRITE_BUFFER, other[0]);
        c.buffer_data(GL_COPY_WRITE_BUFFER, 4, Data::Null, GL_STATIC_DRAW);
        c.copy_buffer_sub_data(TARGET, GL_COPY_WRITE_BUFFER, 0, 0, 4);
        assert!(c.unmap_buffer(TARGET));
        c.bind_buffer(TARGET, other[0]);
        assert_eq!(contents(c, 4), [1, 9, 3, 4]);
    }),
    ("EXT_map_buffer_range", |c| {
        buffer(c);
        c.buffer_data(TARGET, 4, Data::Bytes(&[1, 2, 3, 4]), GL_STATIC_DRAW);
        let flags = GL_MAP_WRITE_BIT_EXT | GL_MAP_FLUSH_EXPLICIT_BIT_EXT;
        assert!(!c.map_buffer_range(TARGET, 1, 2, flags).is_null());
        c.mapped_bytes(TARGET).expect("it is mapped").copy_from_slice(&[8, 9]);
        c.flush_mapped_buffer_range(TARGET, 0, 2);
        assert!(c.unmap_buffer(TARGET));
        assert_eq!(contents(c, 4), [1, 8, 9, 4]);
    }),
    ("OES_mapbuffer", |c| {
        buffer(c);
        c.buffer_data(TARGET, 2, Data::Bytes(&[1, 2]), GL_STATIC_DRAW);
        assert!(!c.map_buffer(TARGET, GL_WRITE_ONLY_OES).is_null());
        c.mapped_bytes(TARGET).expect("it is mapped")[0] = 7;
        let mut mapped = [0];
        c.get_buffer_parameteriv(TARGET, GL_BUFFER_MAPPED_OES, &mut mapped);
        assert_eq!(mapped, [1]);
        assert!(c.unmap_buffer(TARGET));
        assert_eq!(contents(c, 2), [7, 2]);
    }),
    ("OES_vertex_array_object", |c| {
        let mut names = [0; 2];
        c.gen_vertex_arrays(2, &mut names);
        let enabled = |c: &mut Context, name: GLuint| {
            c.bind_vertex_array(name);
            let mut enabled = [9];
            c.get_vertex_attribiv(3, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &mut enabled);
            enabled[0]
        };
        c.bind_vertex_array(names[0]);
        c.enable_vertex_attrib_array(3);
        assert_eq!([names[0], names[1], 0].map(|name| enabled(c, name)), [1, 0, 0]);
        assert!(c.is_vertex_array(names[0]));
        c.delete_vertex_arrays(1, &names[..1]);
        assert!(!c.is_vertex_array(names[0]));
    }),
];
