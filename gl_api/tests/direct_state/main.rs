//! `ARB_direct_state_access`: each call against its twin on a bound object. One context names its objects, the other one
//! binds them; both must answer the same, and refuse the same with the same flag. What the named calls leave bound is
//! nothing.

mod buffers;
mod framebuffers;
mod objects;
mod textures;

use gl_api::*;

/// A call on an object: named in the first context, bound in the second.
pub struct Twin {
    /// For messages.
    pub name: &'static str,
    /// With the object's name.
    pub named: fn(&mut Context, GLuint),
    /// On what is bound.
    pub bound: fn(&mut Context),
}

/// A context, small.
pub fn context() -> Context {
    Context::new(ContextDesc { width: 8, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// The flags of both calls, in order.
pub fn flags(c: &mut Context) -> GLenum {
    let error = c.get_error();
    assert_eq!(c.get_error(), GL_NO_ERROR);
    error
}

/// Runs twins one after the other in both contexts; the flags must be equal, as far as they are of what both say.
pub fn run(named: &mut Context, object: GLuint, bound: &mut Context, twins: &[Twin]) {
    for twin in twins {
        (twin.named)(named, object);
        (twin.bound)(bound);
        let (one, other) = (flags(named), flags(bound));
        let messages = [named.messages(), bound.messages()];
        assert_eq!(enum_name(one), enum_name(other), "{}: {messages:?}", twin.name);
    }
}

/// What `glGetIntegerv` answers.
pub fn integer(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [-1];
    c.get_integerv(pname, &mut value);
    value[0]
}
