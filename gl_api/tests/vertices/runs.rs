//! Several draws by one call, and arrays that are counted or locked.

use super::{CORNERS, SIZE, context, integer, picture};
use gl_api::*;

/// A call that is refused for one of its runs draws none of them.
#[test]
fn several_runs_are_checked_before_the_first_is_drawn() {
    type Row = (fn(&mut Context, [Data<'_>; 2]), GLenum);
    let rows: [Row; 12] = [
        // What is not there, in memory, in a buffer and in no buffer.
        (|c, _| c.multi_draw_arrays(GL_TRIANGLES, &[0, 4], &[3, 3], 2), GL_INVALID_OPERATION),
        (
            |c, runs| {
                let runs = Pointers(vec![runs[0], Data::Bytes(&[3, 4])]);
                c.multi_draw_elements(GL_TRIANGLES, &[3, 3], GL_UNSIGNED_BYTE, runs, 2);
            },
            GL_INVALID_OPERATION,
        ),
        (
            |c, runs| {
                let runs = Pointers(vec![runs[0], Data::Null]);
                c.multi_draw_elements(GL_TRIANGLES, &[3, 3], GL_UNSIGNED_BYTE, runs, 2);
            },
            GL_INVALID_OPERATION,
        ),
        (
            |c, _| {
                c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 1);
                let (target, indices) = (GL_ELEMENT_ARRAY_BUFFER, Data::Bytes(&[0, 1, 2, 3, 4]));
                c.buffer_data(target, 5, indices, GL_STATIC_DRAW);
                let (runs, ty) = (Pointers([0, 3].map(Data::Offset).to_vec()), GL_UNSIGNED_BYTE);
                c.multi_draw_elements_base_vertex(GL_TRIANGLES, &[3, 3], ty, runs, 2, &[0, 0]);
            },
            GL_INVALID_OPERATION,
        ),
        (|c, _| c.multi_draw_arrays(GL_TRIANGLES, &[0, 3], &[3, -1], 2), GL_INVALID_VALUE),
        (|c, _| c.multi_draw_arrays(GL_TRIANGLES, &[0, -3], &[3, 3], 2), GL_INVALID_VALUE),
        (|c, _| c.multi_draw_arrays(GL_FRONT, &[], &[], 0), GL_INVALID_ENUM),
        (
            |c, runs| {
                let runs = Pointers(runs.to_vec());
                c.multi_draw_elements(GL_TRIANGLES, &[3, -1], GL_UNSIGNED_BYTE, runs, 2);
            },
            GL_INVALID_VALUE,
        ),
        (
            |c, _| {
                let none = Pointers(Vec::new());
                c.multi_draw_elements(GL_FRONT, &[], GL_UNSIGNED_BYTE, none, 0);
            },
            GL_INVALID_ENUM,
        ),
        (
            |c, _| {
                let none = Pointers(Vec::new());
                c.multi_draw_elements(GL_TRIANGLES, &[], GL_BYTE, none, 0);
            },
            GL_INVALID_ENUM,
        ),
        (
            |c, runs| {
                let (runs, ty) = (Pointers(runs.to_vec()), GL_UNSIGNED_BYTE);
                c.multi_draw_elements_base_vertex(GL_TRIANGLES, &[3, -1], ty, runs, 2, &[0, 0]);
            },
            GL_INVALID_VALUE,
        ),
        (
            |c, runs| {
                let (runs, ty) = (Pointers(runs.to_vec()), GL_UNSIGNED_BYTE);
                c.multi_draw_elements_base_vertex(GL_TRIANGLES, &[3, 3], ty, runs, 2, &[0]);
            },
            GL_INVALID_OPERATION,
        ),
    ];
    for (row, (draw, error)) in rows.into_iter().enumerate() {
        let mut c = context();
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
        draw(&mut c, [Data::Bytes(&[0, 1, 2]), Data::Bytes(&[3, 4, 5])]);
        assert_eq!(c.get_error(), error, "{row}: {:?}", c.messages());
        let mut pixels = vec![0; (SIZE * SIZE * 4) as usize];
        let out = DataOut::Bytes(&mut pixels);
        c.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, out);
        assert!(pixels.chunks(4).all(|pixel| pixel == &pixels[..4]), "{row} draws a part");
    }
}

/// `EXT_vertex_array`: the calls that came before GL 1.1, which say how many elements there are.
#[test]
fn arrays_with_a_count_are_arrays() {
    let mut plain = context();
    plain.enable_client_state(GL_VERTEX_ARRAY);
    plain.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
    plain.draw_arrays(GL_TRIANGLES, 0, 6);
    let mut c = context();
    c.enable(GL_VERTEX_ARRAY);
    c.vertex_pointer_ext(2, GL_FLOAT, 0, 6, CORNERS.as_slice().arg());
    c.draw_arrays(GL_TRIANGLES, 0, 6);
    assert_eq!(picture(&mut c), picture(&mut plain));
    // What was said is answered, until a call without a count.
    c.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    c.normal_pointer_ext(GL_FLOAT, 0, 1, Data::Null);
    c.color_pointer_ext(3, GL_UNSIGNED_BYTE, 0, 2, Data::Null);
    c.tex_coord_pointer_ext(2, GL_SHORT, 0, 3, Data::Null);
    c.index_pointer_ext(GL_INT, 0, 4, Data::Null);
    c.edge_flag_pointer_ext(0, 5, Data::Null);
    let counts = |c: &mut Context| {
        [
            GL_VERTEX_ARRAY_COUNT_EXT,
            GL_NORMAL_ARRAY_COUNT_EXT,
            GL_COLOR_ARRAY_COUNT_EXT,
            GL_TEXTURE_COORD_ARRAY_COUNT_EXT,
            GL_INDEX_ARRAY_COUNT_EXT,
            GL_EDGE_FLAG_ARRAY_COUNT_EXT,
        ]
        .map(|pname| integer(c, pname))
    };
    assert_eq!(counts(&mut c), [6, 1, 2, 3, 4, 5]);
    assert_eq!(integer(&mut c, GL_TEXTURE_COORD_ARRAY_TYPE), GL_SHORT as i32);
    c.normal_pointer(GL_FLOAT, 0, Data::Null);
    assert_eq!(counts(&mut c), [6, 0, 2, 3, 4, 5]);
    c.pop_client_attrib();
    assert_eq!(counts(&mut c), [6, 0, 0, 0, 0, 0]);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

#[test]
fn locked_arrays_draw_what_they_draw_unlocked() {
    let pictures = [None, Some((0, 3)), Some((1, 2))].map(|locked| {
        let mut c = context();
        c.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
        c.enable_client_state(GL_VERTEX_ARRAY);
        let asked = |c: &mut Context| {
            [GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, GL_ARRAY_ELEMENT_LOCK_COUNT_EXT]
                .map(|pname| integer(c, pname))
        };
        if let Some((first, count)) = locked {
            c.lock_arrays(first, count);
            assert_eq!(asked(&mut c), [first, count]);
        }
        c.draw_arrays(GL_TRIANGLES, 0, 6);
        if locked.is_some() {
            c.unlock_arrays();
        }
        assert_eq!(asked(&mut c), [0, 0]);
        picture(&mut c)
    });
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
}

/// Runs that only repeat the draw before leave nothing to the draw that follows them.
#[test]
fn what_follows_several_runs_has_arrays_of_its_own() {
    let outcome = |between: fn(&mut Context)| {
        let mut c = context();
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.vertex_pointer(2, GL_FLOAT, 0, CORNERS.as_slice().arg());
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        between(&mut c);
        c.begin(GL_TRIANGLES);
        for [x, y] in [[0.9, -0.9], [0.9, -0.2], [0.2, -0.9]] {
            c.vertex_2f(x, y);
        }
        c.end();
        picture(&mut c)
    };
    let runs = |c: &mut Context| c.multi_draw_arrays(GL_TRIANGLES, &[0, 0], &[3, 3], 2);
    assert_eq!(outcome(runs), outcome(|_| ()));
}
