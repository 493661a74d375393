//! Objects that several contexts share: GL 2.1, appendix D.
//!
//! The contexts of a group take turns: a call puts the group's objects in the place of the
//! context's own for as long as it runs, under the group's lock. A context without a group does
//! none of this. What one context records another sees after `glFlush` or `glFinish`.
