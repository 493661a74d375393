//! State queries: GL 2.1, chapter 6; and the end of commands: section 5.5.

use crate::base::types::*;
use crate::calls::flush;
use crate::calls::sync::{conditional, queries};
use crate::query::extensions;
use crate::query::get;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_queries {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Query in extensions {
        /// Vendor, renderer, version, extensions; empty for other names.
        get_string: glGetString (name: GLenum) -> &'static str;
        /// The name of an extension.
        get_stringi: glGetStringi (name: GLenum, index: GLuint) -> &'static str;
    }
    Query in get {
        /// The first error since the last call, or `GL_NO_ERROR`.
        get_error: glGetError () -> GLenum;
        /// Reads state as truth values.
        get_booleanv: glGetBooleanv (pname: GLenum, params: &'a mut [GLboolean]);
        /// Reads state as integers.
        get_integerv: glGetIntegerv (pname: GLenum, params: &'a mut [GLint]);
        /// Reads state as integers of 64 bits.
        get_integer64v: glGetInteger64v (pname: GLenum, params: &'a mut [GLint64]);
        /// Reads state as single precision.
        get_floatv: glGetFloatv (pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads state as double precision.
        get_doublev: glGetDoublev (pname: GLenum, params: &'a mut [GLdouble]);
    }
    Refused in queries {
        /// Makes `n` unused names of queries.
        gen_queries: glGenQueries | glGenQueriesARB | glGenQueriesEXT (n: GLsizei, ids: &'a mut [GLuint]);
        /// Deletes queries; an active one ends.
        delete_queries: glDeleteQueries | glDeleteQueriesARB | glDeleteQueriesEXT (n: GLsizei, ids: &'a [GLuint]), not_compiled;
        /// Whether a name is a query that has begun.
        is_query: glIsQuery | glIsQueryARB | glIsQueryEXT (id: GLuint) -> bool;
        /// Begins to count samples, or time.
        begin_query: glBeginQuery | glBeginQueryARB | glBeginQueryEXT (target: GLenum, id: GLuint);
        /// Ends the query of a target.
        end_query: glEndQuery | glEndQueryARB | glEndQueryEXT (target: GLenum);
        /// Begins a query of one vertex stream.
        begin_query_indexed: glBeginQueryIndexed (target: GLenum, index: GLuint, id: GLuint);
        /// Ends the query of one vertex stream.
        end_query_indexed: glEndQueryIndexed (target: GLenum, index: GLuint);
        /// Reads what is known of a target of queries of one vertex stream.
        get_query_indexediv: glGetQueryIndexediv
            (target: GLenum, index: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Takes the time when everything so far is carried out.
        query_counter: glQueryCounter | glQueryCounterEXT (id: GLuint, target: GLenum);
        /// Reads what is known of a target of queries.
        get_queryiv: glGetQueryiv | glGetQueryivARB | glGetQueryivEXT
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads the result of a query.
        get_query_objectiv: glGetQueryObjectiv | glGetQueryObjectivARB | glGetQueryObjectivEXT
            (id: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads the result of a query.
        get_query_objectuiv: glGetQueryObjectuiv | glGetQueryObjectuivARB | glGetQueryObjectuivEXT
            (id: GLuint, pname: GLenum, params: &'a mut [GLuint]);
        /// Reads the result of a query.
        get_query_objecti64v: glGetQueryObjecti64v | glGetQueryObjecti64vEXT
            (id: GLuint, pname: GLenum, params: &'a mut [GLint64]);
        /// Reads the result of a query.
        get_query_objectui64v: glGetQueryObjectui64v | glGetQueryObjectui64vEXT
            (id: GLuint, pname: GLenum, params: &'a mut [GLuint64]);
    }
    Refused in conditional {
        /// Lets draws and clears have an effect only if a query found samples.
        begin_conditional_render: glBeginConditionalRender | glBeginConditionalRenderNV
            (id: GLuint, mode: GLenum);
        /// Lets draws and clears have their effect again.
        end_conditional_render: glEndConditionalRender | glEndConditionalRenderNV ();
    }
    Refused in flush {
        /// Carries out what was recorded.
        flush: glFlush (), not_compiled;
        /// Lets lookups of the next draw see what was drawn to their own texture.
        texture_barrier: glTextureBarrier | glTextureBarrierNV ();
        /// Carries out what was recorded and waits for it.
        finish: glFinish (), not_compiled;
    }
    } };
}
entry_points_queries!(implement);
