//! Buffers that are deleted while vertex array objects have them.

use super::kinds::{KINDS, Kind, colored, colors_of, texture_of};
use super::{color_of, context, fine, quad};
use gl_api::*;

/// The two places of a vertex array object.
fn places() -> impl Iterator<Item = &'static Kind> {
    KINDS[..2].iter()
}

fn new_vertex_array(c: &mut Context) -> GLuint {
    let mut name = [0];
    c.gen_vertex_arrays(1, &mut name);
    name[0]
}

#[test]
fn one_that_is_not_bound_keeps_its_buffers() {
    for kind in places() {
        let what = kind.name;
        let mut c = context();
        let array = new_vertex_array(&mut c);
        c.bind_vertex_array(array);
        let name = (kind.new)(&mut c);
        (kind.fill)(&mut c, name, 7);
        c.bind_vertex_array(0);
        (kind.delete)(&mut c, name);
        assert!(!(kind.exists)(&mut c, name), "{what}");
        // Another buffer has the name now, and goes again.
        assert_eq!((kind.new)(&mut c), name, "{what}");
        (kind.fill)(&mut c, name, 9);
        c.bind_vertex_array(array);
        assert_eq!(((kind.number)(&mut c), (kind.bound)(&mut c)), (7, name), "{what}");
        (kind.delete)(&mut c, name);
        assert_eq!(((kind.number)(&mut c), (kind.bound)(&mut c)), (7, name), "{what}");
        fine(&mut c);
    }
}

/// The default one is no other than those with names.
#[test]
fn the_default_one_keeps_its_buffers_while_another_is_bound() {
    for kind in places() {
        let mut c = context();
        let name = (kind.new)(&mut c);
        (kind.fill)(&mut c, name, 7);
        let array = new_vertex_array(&mut c);
        c.bind_vertex_array(array);
        (kind.delete)(&mut c, name);
        c.bind_vertex_array(0);
        assert_eq!((kind.number)(&mut c), 7, "{}", kind.name);
    }
}

/// Where it is bound, deletion undoes the attachment.
#[test]
fn the_bound_one_loses_its_buffers() {
    for kind in places() {
        let mut c = context();
        let array = new_vertex_array(&mut c);
        c.bind_vertex_array(array);
        let name = (kind.new)(&mut c);
        (kind.fill)(&mut c, name, 7);
        (kind.delete)(&mut c, name);
        assert_eq!((kind.bound)(&mut c), 0, "{}", kind.name);
        c.bind_vertex_array(0);
        c.bind_vertex_array(array);
        assert_eq!((kind.bound)(&mut c), 0, "{}", kind.name);
    }
}

/// The object goes on, it is not a copy: what is written to it in one place is read in another.
#[test]
fn a_deleted_buffer_can_still_be_written_to() {
    let mut c = context();
    let [array, other] = [new_vertex_array(&mut c), new_vertex_array(&mut c)];
    c.bind_vertex_array(array);
    let mut name = [0];
    c.gen_buffers(1, &mut name);
    colors_of(&mut c, name[0], 7);
    c.bind_vertex_array(other);
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, name[0]);
    c.bind_vertex_array(0);
    c.delete_buffers(1, &name);
    c.bind_vertex_array(other);
    c.buffer_sub_data(GL_ELEMENT_ARRAY_BUFFER, 0, 16, Data::Bytes(&[9; 16]));
    c.bind_vertex_array(array);
    assert_eq!(colored(&mut c), 9);
}

/// What was pushed and then deleted comes back unbound.
#[test]
fn what_was_deleted_is_not_popped() {
    let mut c = context();
    let (mut texture, mut buffer, mut bound) = ([0], [0], [1]);
    c.gen_textures(1, &mut texture);
    c.gen_buffers(1, &mut buffer);
    texture_of(&mut c, texture[0], 7);
    c.bind_buffer(GL_ARRAY_BUFFER, buffer[0]);
    c.push_attrib(GL_TEXTURE_BIT);
    c.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    c.delete_textures(1, &texture);
    c.delete_buffers(1, &buffer);
    // Others have the names.
    texture_of(&mut c, texture[0], 9);
    c.bind_buffer(GL_ARRAY_BUFFER, buffer[0]);
    c.pop_client_attrib();
    c.pop_attrib();
    for pname in [GL_TEXTURE_BINDING_2D, GL_ARRAY_BUFFER_BINDING] {
        c.get_integerv(pname, &mut bound);
        assert_eq!(bound, [0]);
    }
    c.enable(GL_TEXTURE_2D);
    assert_eq!(color_of(&mut c, quad), [255; 4]);
    fine(&mut c);
}
