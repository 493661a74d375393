//! References to objects, which binding points, vertex arrays and container objects hold.
//!
//! Deletion frees the name at once, and unbinds the object in the context that deletes it; other contexts and unbound
//! containers keep using the object (GL 3.1, section 2.9 and appendix D.1). It moves to the deleted objects of
//! [`NameTable`](super::NameTable), and is freed with its last reference ([`Bound`]).

use crate::base::types::GLuint;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

/// An object's name and whether it was deleted; changed only while the share group is locked.
#[derive(Debug)]
struct Identity {
    name: GLuint,
    /// Its number among the deleted objects; 0 while it has its name.
    deleted: AtomicU32,
}

/// A reference to an object, deleted or not, or to none.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bound(Option<Arc<Identity>>);

/// Whether both refer to the same object, or both to none.
impl PartialEq for Bound {
    fn eq(&self, other: &Self) -> bool {
        let at = |bound: &Self| bound.0.as_ref().map(Arc::as_ptr);
        at(self) == at(other)
    }
}

impl Eq for Bound {}

/// How an object is looked up: by name, or by its number among the deleted ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ObjectId {
    Named(GLuint),
    Deleted(GLuint),
}

impl Bound {
    /// The first reference to a new object.
    pub(crate) fn new(name: GLuint) -> Self {
        Self(Some(Arc::new(Identity { name, deleted: AtomicU32::new(0) })))
    }

    /// The object's name, which another may have by now; 0 for nothing.
    pub fn name(&self) -> GLuint {
        self.0.as_ref().map_or(0, |identity| identity.name)
    }

    pub(crate) fn id(&self) -> Option<ObjectId> {
        let identity = self.0.as_ref()?;
        Some(match identity.deleted.load(Ordering::Relaxed) {
            0 => ObjectId::Named(identity.name),
            number => ObjectId::Deleted(number),
        })
    }

    /// The object was deleted.
    pub(crate) fn mark_deleted(&self, number: GLuint) {
        if let Some(identity) = &self.0 {
            identity.deleted.store(number, Ordering::Relaxed);
        }
    }

    /// Whether there are other references to the object.
    pub(crate) fn is_shared(&self) -> bool {
        self.0.as_ref().is_some_and(|identity| Arc::strong_count(identity) > 1)
    }

    /// Becomes a reference to none if it is to `gone`, which is deleted.
    pub fn forget(&mut self, gone: &Self) {
        if self == gone {
            *self = Self::default();
        }
    }

    /// `glPop…` of what was pushed, see [`Self::restored`].
    pub fn restore(&mut self, pushed: Self) {
        *self = pushed.restored(self);
    }

    /// What `glPop…` binds: what was pushed, unless it was deleted and unbound meanwhile.
    pub fn restored(self, current: &Self) -> Self {
        match self.id() {
            Some(ObjectId::Deleted(_)) if self != *current => Self::default(),
            Some(_) | None => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::base::args::Data;
    use crate::base::constants::*;
    use crate::base::types::GLuint;
    use crate::context::sharing::CallScope;
    use crate::context::{Context, ContextDesc};

    /// How many deleted buffers, textures and programs there are in a context's group.
    fn deleted(c: &mut Context) -> [usize; 3] {
        let scope = CallScope { context: c };
        let objects = &scope.context.objects;
        let (buffers, textures) =
            (&objects.shared.buffers.deleted, &objects.shared.textures.deleted);
        [buffers.len(), textures.len(), objects.shared.doomed_programs.len()]
    }

    fn desc() -> ContextDesc {
        ContextDesc { width: 1, height: 1, ..ContextDesc::default() }
    }

    /// A buffer, a texture that is made of it and a program, in use.
    fn bind(c: &mut Context) -> GLuint {
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.buffer_data(GL_ARRAY_BUFFER, 4, Data::Null, GL_STATIC_DRAW);
        c.bind_texture(GL_TEXTURE_BUFFER, 1);
        c.tex_buffer(GL_TEXTURE_BUFFER, GL_RGBA8, 1);
        let (program, shader) = (c.create_program(), c.create_shader(GL_FRAGMENT_SHADER));
        c.shader_source(shader, 1, crate::base::args::Strings(vec!["void main() {}"]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
        c.link_program(program);
        c.use_program(program);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        program
    }

    fn delete(c: &mut Context, program: GLuint) {
        c.delete_buffers(1, &[1]);
        c.delete_textures(1, &[1]);
        c.delete_program(program);
    }

    #[test]
    fn what_nothing_is_bound_to_is_freed() {
        let mut c = Context::new(desc()).expect("a device");
        let program = bind(&mut c);
        delete(&mut c, program);
        assert_eq!(deleted(&mut c), [0, 0, 1]);
        c.use_program(0);
        assert_eq!(deleted(&mut c), [0; 3]);
        // An idle context that binds nothing keeps nothing.
        let _idle = c.new_shared(desc()).expect("a context");
        let program = bind(&mut c);
        c.use_program(0);
        delete(&mut c, program);
        assert_eq!(deleted(&mut c), [0; 3]);
    }

    /// Deleted objects are swept now and then, and at the end of a frame.
    #[test]
    fn many_are_freed_too() {
        let mut c = Context::new(desc()).expect("a device");
        let mut arrays = [0; 500];
        c.gen_vertex_arrays(500, &mut arrays);
        for array in arrays {
            let mut buffer = [0];
            c.gen_buffers(1, &mut buffer);
            assert_eq!(buffer, [1], "its name is free again");
            c.bind_vertex_array(array);
            c.bind_buffer(GL_ARRAY_BUFFER, 1);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
            c.bind_vertex_array(0);
            c.delete_buffers(1, &buffer);
        }
        assert_eq!(deleted(&mut c), [500, 0, 0]);
        c.delete_vertex_arrays(500, &arrays);
        c.flush();
        assert_eq!(deleted(&mut c), [0; 3]);
    }

    #[test]
    fn vertex_arrays_free_their_buffers() {
        let mut c = Context::new(desc()).expect("a device");
        let mut array = [0];
        c.gen_vertex_arrays(1, &mut array);
        c.bind_vertex_array(array[0]);
        bind(&mut c);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.bind_vertex_array(0);
        c.delete_buffers(1, &[1]);
        assert_eq!(deleted(&mut c), [1, 0, 0]);
        c.delete_textures(1, &[1]);
        assert_eq!(deleted(&mut c), [1, 0, 0]);
        c.delete_vertex_arrays(1, &array);
        assert_eq!(deleted(&mut c), [0; 3]);
    }

    #[test]
    fn the_last_context_frees_what_it_lets_go_of() {
        let mut c = Context::new(desc()).expect("a device");
        let mut other = c.new_shared(desc()).expect("a context");
        let program = bind(&mut other);
        delete(&mut c, program);
        assert_eq!(deleted(&mut c), [1, 1, 1]);
        other.bind_buffer(GL_ARRAY_BUFFER, 0);
        other.bind_texture(GL_TEXTURE_BUFFER, 0);
        other.use_program(0);
        other.flush();
        assert_eq!(deleted(&mut c), [0; 3]);
        // So does one that is destroyed.
        let program = bind(&mut other);
        delete(&mut c, program);
        drop(other);
        c.flush();
        assert_eq!(deleted(&mut c), [0; 3]);
    }
}
