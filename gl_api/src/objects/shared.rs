//! Share groups: objects that several contexts share (GL 2.1, appendix D; GL 3.1, appendix D).
//!
//! **What a group owns.** A [`ShareGroup`] owns the names and the objects of textures, samplers, buffers,
//! renderbuffers, shaders and programs, assembly programs, sync objects and display lists, behind its lock. Every
//! context belongs to one; most groups have one context. Framebuffer objects, vertex array objects, queries, the
//! objects named 0 and all state are each context's own.
//!
//! **When the lock is taken.** With the first access of a call to an object of the group ([`GroupAccess`]), and it is
//! held until the call ends. So each call sees and leaves the objects in a state in which no other call is half done,
//! and a call that needs none, as most that set state, takes no lock. The calls of a display list are calls of their
//! own: others may run between them. `glFlush`, `glFinish` and the end of a picture release the lock while the recorded
//! draws are executed, so contexts of one group draw at the same time; a wait for a fence releases it, too.
//!
//! **What another context sees.** Names, parameters and uploaded texels and bytes: with its next call. What was drawn:
//! after `glFlush` or `glFinish`, as draws are recorded until then; a recorded draw keeps the contents that it had when
//! it was recorded.

use crate::base::types::GLuint;
use crate::objects::assemblies::Assembly;
use crate::objects::buffers::{BufferObject, Map, WaitingDraws};
use crate::objects::lists::ListNames;
use crate::objects::name_table::{NameTable, Sweep};
use crate::objects::programs::ShaderOrProgram;
use crate::objects::renderbuffers::Renderbuffer;
use crate::objects::sampler::SamplerState;
use crate::objects::syncs::Syncs;
use crate::objects::texture::Texture;
use parking_lot::{ArcMutexGuard, Mutex, RawMutex};
use std::cell::OnceCell;
use std::fmt;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The objects of a share group.
#[derive(Debug, Default)]
pub(crate) struct SharedObjects {
    pub textures: NameTable<Texture>,
    pub samplers: NameTable<SamplerState>,
    pub buffers: NameTable<BufferObject>,
    /// Buffers that have been mapped persistently.
    persistent: Vec<GLuint>,
    pub renderbuffers: NameTable<Renderbuffer>,
    /// Shaders and programs share one space of names.
    pub programs: NameTable<ShaderOrProgram>,
    /// Programs that were deleted while a context used them: they keep their names.
    pub doomed_programs: Vec<GLuint>,
    pub assemblies: NameTable<Assembly>,
    pub syncs: Syncs,
    /// Display lists.
    pub lists: ListNames,
}

impl SharedObjects {
    /// Takes over what clients have written to persistent mappings; whether there are any.
    fn take_client_writes(&mut self, recorder: &mut impl WaitingDraws) -> bool {
        let buffers = &mut self.buffers;
        self.persistent.retain(|name| match buffers.get_mut(*name) {
            Some(object) if object.map.as_ref().is_some_and(Map::is_persistent) => {
                object.take_client_writes(recorder);
                true
            }
            Some(_) | None => false,
        });
        !self.persistent.is_empty()
    }

    /// Frees deleted objects without references; textures before buffers, which they reference.
    pub fn sweep(&mut self, when: Sweep) {
        self.textures.sweep(when);
        self.samplers.sweep(when);
        self.buffers.sweep(when);
        self.renderbuffers.sweep(when);
        self.assemblies.sweep(when);
        self.sweep_programs();
    }
}

/// A share group. Clones are the same group.
#[derive(Clone, Debug, Default)]
pub(crate) struct ShareGroup(Arc<Group>);

#[derive(Debug, Default)]
struct Group {
    objects: Arc<Mutex<SharedObjects>>,
    /// Whether others may change what is in the objects: a second context has ever joined, or an EGL image has ever had
    /// the storage of one.
    has_others: AtomicBool,
    /// Whether a buffer may be mapped persistently. It changes under the lock of the objects, and is read without.
    has_persistent: AtomicBool,
}

impl ShareGroup {
    /// The group, for a further context.
    pub fn join(&self) -> Self {
        self.shared_with_others();
        self.clone()
    }

    /// Notes that others may change what is in the objects from now on.
    pub fn shared_with_others(&self) {
        self.0.has_others.store(true, Ordering::Release);
    }

    /// Its objects, for callers outside of the calls of its contexts.
    #[inline(never)]
    pub fn lock(&self) -> ArcMutexGuard<RawMutex, SharedObjects> {
        self.0.objects.lock_arc()
    }
}

/// A context's access to the objects of its group: locked by the first use in a call, released at the call's end.
pub(crate) struct GroupAccess {
    group: ShareGroup,
    locked: OnceCell<ArcMutexGuard<RawMutex, SharedObjects>>,
}

impl GroupAccess {
    pub fn new(group: ShareGroup) -> Self {
        Self { group, locked: OnceCell::new() }
    }

    pub fn group(&self) -> &ShareGroup {
        &self.group
    }

    /// Whether nobody else changes its objects: no other context has ever joined the group, and no EGL image was made
    /// or used in it.
    pub fn is_exclusive(&self) -> bool {
        !self.group.0.has_others.load(Ordering::Acquire)
    }

    /// Notes that a buffer has been mapped persistently.
    pub fn mapped_persistently(&mut self, name: GLuint) {
        if !self.persistent.contains(&name) {
            self.persistent.push(name);
        }
        self.group.0.has_persistent.store(true, Ordering::Release);
    }

    /// Takes over what clients have written to persistent mappings; whether there are any. Draws ask, so without the lock
    /// where no buffer is mapped so.
    pub fn take_client_writes(&mut self, recorder: &mut impl WaitingDraws) -> bool {
        if !self.group.0.has_persistent.load(Ordering::Acquire) {
            return false;
        }
        let is_any = SharedObjects::take_client_writes(self, recorder);
        self.group.0.has_persistent.store(is_any, Ordering::Release);
        is_any
    }

    /// Whether a call has the objects.
    #[cfg(test)]
    pub fn is_locked(&self) -> bool {
        self.locked.get().is_some()
    }

    /// Lets other contexts use the objects: at the end of a call, and where it needs them no more.
    #[inline]
    pub fn release(&mut self) {
        if self.locked.get().is_some() {
            self.unlock();
        }
    }

    #[inline(never)]
    fn unlock(&mut self) {
        self.locked.take();
    }
}

impl fmt::Debug for GroupAccess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.group.fmt(f)
    }
}

impl Deref for GroupAccess {
    type Target = SharedObjects;

    #[inline]
    fn deref(&self) -> &SharedObjects {
        self.locked.get_or_init(|| self.group.lock())
    }
}

impl DerefMut for GroupAccess {
    #[inline]
    fn deref_mut(&mut self) -> &mut SharedObjects {
        self.locked.get_or_init(|| self.group.lock());
        match self.locked.get_mut() {
            Some(objects) => objects,
            None => unreachable!("locked above"),
        }
    }
}
