//! What buffers are given again and again: they hold it, and what was drawn before does not.

use super::*;

/// Bytes that differ from call to call.
fn bytes(size: usize, seed: usize) -> Vec<u8> {
    (0..size).map(|at| (at * 31 + at / 251 + seed * 97) as u8).collect()
}

#[test]
fn buffers_hold_what_they_were_given_last_however_large() {
    let mut c = context();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    // About where several threads copy, and where the memory of the last time is used again.
    let sizes = [10, 10, (1 << 20) - 1, 1 << 20, 3 << 20, 3 << 20, (3 << 20) + 5, 0, 7];
    for (seed, size) in sizes.into_iter().enumerate() {
        let given = bytes(size, seed);
        c.buffer_data(GL_ARRAY_BUFFER, size as GLsizeiptr, Data::Bytes(&given), GL_STREAM_DRAW);
        let mut got = vec![1; size];
        c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, size as GLsizeiptr, DataOut::Bytes(&mut got));
        assert!(got == given, "{size} bytes");
        if size > 9 {
            let part = bytes(size - 9, seed + 50);
            let length = part.len() as GLsizeiptr;
            c.buffer_sub_data(GL_ARRAY_BUFFER, 4, length, Data::Bytes(&part));
            c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, size as GLsizeiptr, DataOut::Bytes(&mut got));
            let end = size - 5;
            assert!(got[4..end] == part, "{size} bytes");
            assert!(got[..4] == given[..4] && got[end..] == given[end..], "{size} bytes");
        }
        c.buffer_data(GL_ARRAY_BUFFER, size as GLsizeiptr, Data::Null, GL_STREAM_DRAW);
        c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, size as GLsizeiptr, DataOut::Bytes(&mut got));
        assert!(got.iter().all(|&byte| byte == 0), "{size} bytes that nobody gave");
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn a_draw_keeps_what_its_buffer_held() {
    let mut want = context();
    want.enable_client_state(GL_VERTEX_ARRAY);
    want.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
    want.draw_arrays(GL_TRIANGLES, 0, 6);
    for size in [size_of_val(&CORNERS), 2 << 20] {
        let mut c = context();
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        let mut given = vec![0; size];
        given[..size_of_val(&CORNERS)].copy_from_slice(bytemuck::cast_slice(&CORNERS));
        let length = size as GLsizeiptr;
        c.buffer_data(GL_ARRAY_BUFFER, length, Data::Bytes(&given), GL_STREAM_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.draw_arrays(GL_TRIANGLES, 0, 6);
        c.buffer_data(GL_ARRAY_BUFFER, length, Data::Bytes(&vec![0; size]), GL_STREAM_DRAW);
        assert!(picture(&mut c) == picture(&mut want), "{size} bytes");
    }
}

/// Sums of an index and the base vertex wrap, also where a draw copies the vertices that it reads.
#[test]
fn base_vertices_wrap_in_buffers_that_are_written_between_draws() {
    let mut want = context();
    want.enable_client_state(GL_VERTEX_ARRAY);
    want.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
    want.draw_arrays(GL_TRIANGLES, 0, 6);
    let want = picture(&mut want);
    // Vertices that lie together, and some far apart.
    for places in [[0, 1, 2, 3, 4, 5], [0, 1, 2, 3, 9000, 9001]] {
        let mut c = context();
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        let mut given = vec![0.0_f32; 20_000];
        for (corner, place) in CORNERS.chunks(2).zip(places) {
            given[2 * place as usize..][..2].copy_from_slice(corner);
        }
        let bytes = bytemuck::cast_slice(&given);
        c.buffer_data(
            GL_ARRAY_BUFFER,
            bytes.len() as GLsizeiptr,
            Data::Bytes(bytes),
            GL_STREAM_DRAW,
        );
        for base in [8, i32::MAX, i32::MIN, -1] {
            let indices = places.map(|place: u32| place.wrapping_sub(base as u32));
            let indices = bytemuck::cast_slice(&indices);
            c.clear(GL_COLOR_BUFFER_BIT);
            let (mode, ty) = (GL_TRIANGLES, GL_UNSIGNED_INT);
            c.draw_elements_base_vertex(mode, 6, ty, Data::Bytes(indices), base);
            c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 8, Data::Bytes(&bytes[..8]));
            assert!(picture(&mut c) == want, "{places:?} from {base}");
        }
    }
}
