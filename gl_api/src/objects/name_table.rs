//! The names of one kind of object: GL 2.1, sections 2.9, 2.15 and 3.8.12.

use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::types::*;
use crate::objects::bound::{Bound, ObjectId};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// The names of one kind of object, and its objects.
#[derive(Debug)]
pub(crate) struct NameTable<T> {
    /// `None` is a name that `glGen…` returned and that was never bound.
    objects: BTreeMap<GLuint, Option<Named<T>>>,
    /// Every name up to this one is used or in `freed`.
    used: GLuint,
    /// Names of those that were deleted, the smallest first; binding may have used one again.
    freed: BinaryHeap<Reverse<GLuint>>,
    /// Objects that were deleted while referenced, sorted by number.
    pub(super) deleted: Vec<(GLuint, Named<T>)>,
    /// The last of these numbers.
    last_deleted: GLuint,
    /// How many of them the last sweep left.
    left: usize,
}

/// Fewer deleted objects than these are swept after each deletion.
const FEW: usize = 64;

/// When deleted objects without references are freed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Sweep {
    /// After deletions: if there are few, or twice as many as the last sweep left.
    Deleted,
    /// After a flush.
    Flushed,
}

#[derive(Debug)]
pub(super) struct Named<T> {
    object: T,
    /// References are copies of this one, which is made with the first.
    bound: Bound,
}

impl<T> Named<T> {
    fn new(object: T) -> Self {
        Self { object, bound: Bound::default() }
    }
}

impl<T> Default for NameTable<T> {
    fn default() -> Self {
        Self {
            objects: BTreeMap::new(),
            used: 0,
            freed: BinaryHeap::new(),
            deleted: Vec::new(),
            last_deleted: 0,
            left: 0,
        }
    }
}

impl<T> NameTable<T> {
    /// Allocates the smallest unused name.
    fn allocate(&mut self, object: Option<Named<T>>) -> GLuint {
        let name = loop {
            let name = match self.freed.pop() {
                Some(Reverse(name)) => name,
                None => {
                    self.used += 1;
                    self.used
                }
            };
            if !self.is_reserved(name) {
                break name;
            }
        };
        self.objects.insert(name, object);
        name
    }

    /// `glGen…`: reserves `n` names.
    pub(crate) fn reserve(
        &mut self,
        section: &'static str,
        n: GLsizei,
        names: &mut [GLuint],
    ) -> Result<()> {
        let n = listed(section, n, names)?.len();
        names[..n].fill_with(|| self.allocate(None));
        Ok(())
    }

    /// Adds an object under an unused name.
    pub(crate) fn add(&mut self, object: T) -> GLuint {
        self.allocate(Some(Named::new(object)))
    }

    /// `glCreate…`: adds `n` objects.
    pub(crate) fn add_each(
        &mut self,
        section: &'static str,
        n: GLsizei,
        names: &mut [GLuint],
        mut new: impl FnMut() -> T,
    ) -> Result<()> {
        let n = listed(section, n, names)?.len();
        names[..n].fill_with(|| self.add(new()));
        Ok(())
    }

    /// Creates the object of a name other than 0, if it has none: the first binding does.
    pub(crate) fn create(&mut self, name: GLuint, new: impl FnOnce() -> T) {
        if name != 0 {
            self.objects.entry(name).or_insert(None).get_or_insert_with(|| Named::new(new()));
        }
    }

    /// A reference to the object of a name; to none if there is none.
    pub fn hold(&mut self, name: GLuint) -> Bound {
        let Some(Some(named)) = self.objects.get_mut(&name) else { return Bound::default() };
        if named.bound.id().is_none() {
            named.bound = Bound::new(name);
        }
        named.bound.clone()
    }

    /// Whether there are references to the object of a name.
    pub(crate) fn is_held(&self, name: GLuint) -> bool {
        matches!(self.objects.get(&name), Some(Some(named)) if named.bound.is_shared())
    }

    /// Whether a name is used, with an object or without.
    pub(crate) fn is_reserved(&self, name: GLuint) -> bool {
        self.objects.contains_key(&name)
    }

    /// Refuses a name that no call has given, in core contexts (GL 3.3, appendix E.2.2).
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION`.
    pub(crate) fn check_given(&self, argument: &str, name: GLuint, given_by: &str) -> Result<()> {
        if name == 0 || self.is_reserved(name) {
            return Ok(());
        }
        invalid_operation(
            "GL 3.3, appendix E.2.2",
            format!(
                "{argument} = {name} must be a name that {given_by} gave: core profiles have no others"
            ),
        )
    }

    /// The object of a name.
    pub fn get(&self, name: GLuint) -> Option<&T> {
        Some(&self.objects.get(&name)?.as_ref()?.object)
    }

    /// The object of a name, to be changed.
    pub fn get_mut(&mut self, name: GLuint) -> Option<&mut T> {
        Some(&mut self.objects.get_mut(&name)?.as_mut()?.object)
    }

    /// The referenced object, deleted or not.
    pub fn bound(&self, bound: &Bound) -> Option<&T> {
        match bound.id()? {
            ObjectId::Named(name) => self.get(name),
            ObjectId::Deleted(number) => {
                let at = self.deleted.binary_search_by_key(&number, |(number, _)| *number).ok()?;
                Some(&self.deleted[at].1.object)
            }
        }
    }

    /// The referenced object, to be changed.
    pub fn bound_mut(&mut self, bound: &Bound) -> Option<&mut T> {
        match bound.id()? {
            ObjectId::Named(name) => self.get_mut(name),
            ObjectId::Deleted(number) => {
                let at = self.deleted.binary_search_by_key(&number, |(number, _)| *number).ok()?;
                Some(&mut self.deleted[at].1.object)
            }
        }
    }

    /// Every object.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.objects.values().flatten().map(|named| &named.object)
    }

    /// Every object, deleted ones too, to be changed.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        let deleted = self.deleted.iter_mut().map(|(_, named)| named);
        self.objects.values_mut().flatten().chain(deleted).map(|named| &mut named.object)
    }

    /// A program that binds and deletes one name repeatedly frees it as often: removes duplicates.
    fn forget_copies(&mut self) {
        if self.freed.len() / 4 > self.used as usize {
            let mut names = std::mem::take(&mut self.freed).into_vec();
            names.sort_unstable();
            names.dedup();
            self.freed = BinaryHeap::from(names);
        }
    }

    /// Frees a name, and its object unless it is referenced.
    pub(crate) fn remove(&mut self, name: GLuint) {
        let Some(named) = self.objects.remove(&name) else { return };
        if name <= self.used {
            self.freed.push(Reverse(name));
            self.forget_copies();
        }
        let Some(named) = named else { return };
        if named.bound.is_shared() {
            self.last_deleted = self.last_deleted.wrapping_add(1).max(1);
            named.bound.mark_deleted(self.last_deleted);
            self.deleted.push((self.last_deleted, named));
        }
    }

    /// Frees deleted objects without references.
    pub(crate) fn sweep(&mut self, when: Sweep) {
        let is_due = match when {
            Sweep::Flushed => true,
            // So that the cost of a deletion is constant on average.
            Sweep::Deleted => self.deleted.len() < FEW || self.deleted.len() >= 2 * self.left,
        };
        if is_due {
            self.deleted.retain(|(_, named)| named.bound.is_shared());
            self.left = self.deleted.len();
        }
    }
}

/// The names that a call lists.
pub(crate) fn listed<'a>(
    section: &'static str,
    n: GLsizei,
    names: &'a [GLuint],
) -> Result<&'a [GLuint]> {
    let n = not_negative(section, "n", n.into())?;
    match names.get(..n) {
        Some(names) => Ok(names),
        None => {
            let has = names.len();
            invalid_operation(section, format!("n = {n}, but the memory has {has} elements"))
        }
    }
}
