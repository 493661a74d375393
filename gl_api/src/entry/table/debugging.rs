//! Messages, labels and fences: `KHR_debug` and `ARB_sync`.

use crate::base::args::TextOut;
use crate::base::types::*;
use crate::calls::debug as log_calls;
use crate::calls::sync::fences as syncs;
use crate::context::GLDEBUGPROC;
use crate::query::pointers;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_debugging {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Allowed in log_calls {
        /// Says which messages the log lets through.
        debug_message_control: glDebugMessageControl | glDebugMessageControlARB | glDebugMessageControlKHR (
            source: GLenum, ty: GLenum, severity: GLenum, count: GLsizei, ids: &'a [GLuint],
            enabled: bool
        ), not_compiled;
        /// Adds a message of the program's to the log.
        debug_message_insert: glDebugMessageInsert | glDebugMessageInsertARB | glDebugMessageInsertKHR (
            source: GLenum, ty: GLenum, id: GLuint, severity: GLenum, length: GLsizei,
            message: &'a str
        ), not_compiled;
        /// What is called with messages, at the end of the call that causes them.
        debug_message_callback: glDebugMessageCallback | glDebugMessageCallbackARB | glDebugMessageCallbackKHR
            (callback: GLDEBUGPROC, user: *const GLvoid), not_compiled;
        /// Takes messages from the log, oldest first; gives how many.
        get_debug_message_log: glGetDebugMessageLog | glGetDebugMessageLogARB | glGetDebugMessageLogKHR (
            count: GLuint, bufsize: GLsizei, sources: &'a mut [GLenum], types: &'a mut [GLenum],
            ids: &'a mut [GLuint], severities: &'a mut [GLenum], lengths: &'a mut [GLsizei],
            text: TextOut<'a>
        ) -> GLuint;
        /// Opens a group, which keeps the filters.
        push_debug_group: glPushDebugGroup | glPushDebugGroupKHR
            (source: GLenum, id: GLuint, length: GLsizei, message: &'a str), not_compiled;
        /// Closes a group, and takes its filters back.
        pop_debug_group: glPopDebugGroup | glPopDebugGroupKHR (), not_compiled;
        /// Labels an object.
        object_label: glObjectLabel | glObjectLabelKHR
            (identifier: GLenum, name: GLuint, length: GLsizei, label: &'a str), not_compiled;
        /// Reads the label of an object.
        get_object_label: glGetObjectLabel | glGetObjectLabelKHR (
            identifier: GLenum, name: GLuint, bufsize: GLsizei, length: &'a mut [GLsizei],
            label: TextOut<'a>
        );
        /// Labels a fence.
        object_ptr_label: glObjectPtrLabel | glObjectPtrLabelKHR (ptr: *const GLvoid, length: GLsizei, label: &'a str), not_compiled;
        /// Reads the label of a fence.
        get_object_ptr_label: glGetObjectPtrLabel | glGetObjectPtrLabelKHR (
            ptr: *const GLvoid, bufsize: GLsizei, length: &'a mut [GLsizei], label: TextOut<'a>
        );
    }
    Refused in pointers {
        /// Where arrays and callbacks are; an offset for an array in a buffer.
        get_pointerv: glGetPointerv | glGetPointervEXT | glGetPointervKHR
            (pname: GLenum, params: &'a mut [*mut GLvoid]);
    }
    Refused in syncs {
        /// Makes a fence after everything recorded so far.
        fence_sync: glFenceSync (condition: GLenum, flags: GLbitfield) -> GLsync;
        /// Whether a handle is a fence.
        is_sync: glIsSync (sync: GLsync) -> bool;
        /// Deletes a fence.
        delete_sync: glDeleteSync (sync: GLsync), not_compiled;
        /// Carries out everything before a fence.
        client_wait_sync: glClientWaitSync (sync: GLsync, flags: GLbitfield, timeout: GLuint64)
            -> GLenum;
        /// Orders what follows after a fence, as it is in any case.
        wait_sync: glWaitSync (sync: GLsync, flags: GLbitfield, timeout: GLuint64), not_compiled;
        /// Reads what is known of a fence.
        get_synciv: glGetSynciv (
            sync: GLsync, pname: GLenum, bufsize: GLsizei, length: &'a mut [GLsizei],
            values: &'a mut [GLint]
        );
    }
    } };
}
entry_points_debugging!(implement);
