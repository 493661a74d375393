//! Display lists and attribute stacks: GL 2.1, sections 5.4 and 6.1.17.

use crate::base::args::Data;
use crate::base::types::*;
use crate::record::lists as calls;
use crate::record::{attrib, client_attrib};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_lists {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in calls {
        /// Begins to compile a list.
        new_list: glNewList (list: GLuint, mode: GLenum), not_compiled;
        /// Ends the list; it takes the place of an older one.
        end_list: glEndList (), not_compiled;
        /// Reserves `range` names of empty lists in a row and gives the first, or 0 if there are no
        /// such names.
        gen_lists: glGenLists (range: GLsizei) -> GLuint;
        /// Deletes lists; names without a list are ignored.
        delete_lists: glDeleteLists (list: GLuint, range: GLsizei), not_compiled;
        /// Where `glCallLists` counts from.
        list_base: glListBase (base: GLuint);
        /// Whether there is a list of that name.
        is_list: glIsList (list: GLuint) -> bool;
    }
    Setter in attrib {
        /// Keeps groups of the context's state.
        push_attrib: glPushAttrib (mask: GLbitfield);
        /// Puts the groups back that were kept last.
        pop_attrib: glPopAttrib ();
    }
    Refused in client_attrib {
        /// Keeps groups of the client's state.
        push_client_attrib: glPushClientAttrib (mask: GLbitfield), not_compiled;
        /// Puts the groups of the client's state back that were kept last.
        pop_client_attrib: glPopClientAttrib (), not_compiled;
    }
    Allowed in calls {
        /// Carries out a list; without one, nothing happens.
        call_list: glCallList (list: GLuint);
        /// Carries out several lists, counted from `glListBase`.
        call_lists: glCallLists (n: GLsizei, ty: GLenum, lists: Data<'a>);
    }
    } };
}
entry_points_lists!(implement);
