//! What binding points, arrays and containers hold of an object: a share of its life.
//!
//! Deletion takes an object's name away at once, and its bindings in the context that deletes it; other
//! contexts and containers that are not bound go on with the object (GL 3.1, section 2.9 and appendix
//! D.1). It leaves the names for the departed of [`Names`](super::Names), and is freed once nothing is
//! [`Bound`] to it.

use crate::base::types::GLuint;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

/// An object's name, and what became of it; only its group's turns change it.
#[derive(Debug)]
struct Identity {
    name: GLuint,
    /// Its number among the departed; 0 while it has its name.
    departed: AtomicU32,
}

/// What is bound: an object, deleted or not, or nothing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bound(Option<Arc<Identity>>);

/// The same object, or nothing both.
impl PartialEq for Bound {
    fn eq(&self, other: &Self) -> bool {
        let at = |bound: &Self| bound.0.as_ref().map(Arc::as_ptr);
        at(self) == at(other)
    }
}

impl Eq for Bound {}

/// Where an object is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Named(GLuint),
    Departed(GLuint),
}

impl Bound {
    /// A new object's.
    pub(crate) fn new(name: GLuint) -> Self {
        Self(Some(Arc::new(Identity { name, departed: AtomicU32::new(0) })))
    }

    /// The object's name, which another may have by now; 0 for nothing.
    pub fn name(&self) -> GLuint {
        self.0.as_ref().map_or(0, |identity| identity.name)
    }

    pub(crate) fn place(&self) -> Option<Place> {
        let identity = self.0.as_ref()?;
        Some(match identity.departed.load(Ordering::Relaxed) {
            0 => Place::Named(identity.name),
            number => Place::Departed(number),
        })
    }

    /// Notes that the object has lost its name.
    pub(crate) fn depart(&self, number: GLuint) {
        if let Some(identity) = &self.0 {
            identity.departed.store(number, Ordering::Relaxed);
        }
    }

    /// Whether anything else is bound to the object.
    pub(crate) fn is_shared(&self) -> bool {
        self.0.as_ref().is_some_and(|identity| Arc::strong_count(identity) > 1)
    }

    /// Binds nothing where this was bound, which is deleted.
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
        match self.place() {
            Some(Place::Departed(_)) if self != *current => Self::default(),
            Some(_) | None => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::base::args::Data;
    use crate::base::constants::*;
    use crate::base::types::GLuint;
    use crate::context::sharing::SharedObjectsGuard;
    use crate::context::{Context, ContextDesc};

    /// How many deleted buffers, textures and programs there are in a context's group.
    fn departed(c: &mut Context) -> [usize; 3] {
        let objects = &SharedObjectsGuard::lock(c).context.objects;
        let (buffers, textures) = (&objects.buffers.departed, &objects.textures.departed);
        [buffers.len(), textures.len(), objects.doomed_programs.len()]
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
        assert_eq!(departed(&mut c), [0, 0, 1]);
        c.use_program(0);
        assert_eq!(departed(&mut c), [0; 3]);
        // An idle context that binds nothing keeps nothing.
        let _idle = c.new_shared(desc()).expect("a context");
        let program = bind(&mut c);
        c.use_program(0);
        delete(&mut c, program);
        assert_eq!(departed(&mut c), [0; 3]);
    }

    /// They are looked through now and then, and where a frame ends.
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
        assert_eq!(departed(&mut c), [500, 0, 0]);
        c.delete_vertex_arrays(500, &arrays);
        c.flush();
        assert_eq!(departed(&mut c), [0; 3]);
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
        assert_eq!(departed(&mut c), [1, 0, 0]);
        c.delete_textures(1, &[1]);
        assert_eq!(departed(&mut c), [1, 0, 0]);
        c.delete_vertex_arrays(1, &array);
        assert_eq!(departed(&mut c), [0; 3]);
    }

    #[test]
    fn the_last_context_frees_what_it_lets_go_of() {
        let mut c = Context::new(desc()).expect("a device");
        let mut other = c.new_shared(desc()).expect("a context");
        let program = bind(&mut other);
        delete(&mut c, program);
        assert_eq!(departed(&mut c), [1, 1, 1]);
        other.bind_buffer(GL_ARRAY_BUFFER, 0);
        other.bind_texture(GL_TEXTURE_BUFFER, 0);
        other.use_program(0);
        other.flush();
        assert_eq!(departed(&mut c), [0; 3]);
        // So does one that is destroyed.
        let program = bind(&mut other);
        delete(&mut c, program);
        drop(other);
        c.flush();
        assert_eq!(departed(&mut c), [0; 3]);
    }
}
