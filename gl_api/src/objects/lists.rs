//! Names of display lists. Names that `glGenLists` returns are those of empty lists (GL 2.1, section 5.4).

use crate::base::types::*;
use std::any::Any;
use std::collections::BTreeMap;
use std::sync::Arc;

/// One more than the largest name.
const END: u64 = 1 << 32;

/// The compiled commands of a list; their type is known to the layer that compiles them.
pub(crate) type CompiledList = Arc<dyn Any + Send + Sync>;

/// The lists by name.
#[derive(Debug, Default)]
pub(crate) struct ListNames {
    /// The names in use, from each key up to, and without, its value; no two runs touch.
    runs: BTreeMap<u64, u64>,
    /// The lists that were compiled.
    compiled: BTreeMap<GLuint, CompiledList>,
}

impl ListNames {
    pub fn contains(&self, name: GLuint) -> bool {
        let name = u64::from(name);
        self.runs.range(..=name).next_back().is_some_and(|(_, &end)| name < end)
    }

    /// The compiled list of a name.
    pub fn get(&self, name: GLuint) -> Option<&CompiledList> {
        self.compiled.get(&name)
    }

    pub(crate) fn insert(&mut self, name: GLuint, list: CompiledList) {
        self.compiled.insert(name, list);
        self.add(name.into(), u64::from(name) + 1);
    }

    /// Allocates so many consecutive unused names for empty lists; gives the first one.
    pub(crate) fn take(&mut self, count: u64) -> Option<GLuint> {
        let mut first = 1;
        for (&used, &end) in &self.runs {
            if used >= first + count {
                break;
            }
            first = end;
        }
        let end = first + count;
        if end > END {
            return None;
        }
        self.add(first, end);
        Some(first as GLuint)
    }

    /// Adds a run of names and merges it with adjacent ones.
    fn add(&mut self, mut first: u64, mut end: u64) {
        while let Some((&at, &until)) = self.runs.range(..=end).next_back()
            && until >= first
        {
            self.runs.remove(&at);
            (first, end) = (first.min(at), end.max(until));
        }
        self.runs.insert(first, end);
    }

    /// Deletes the lists of so many consecutive names.
    pub(crate) fn remove(&mut self, first: GLuint, count: u64) {
        let (first, end) = (u64::from(first), u64::from(first) + count);
        while let Some((&at, &until)) = self.runs.range(..end).next_back()
            && until > first
        {
            self.runs.remove(&at);
            self.runs.extend([(at, first), (end, until)].into_iter().filter(|run| run.0 < run.1));
        }
        let last = end.min(END).saturating_sub(1) as GLuint;
        while count > 0
            && let Some((&name, _)) = self.compiled.range(first as GLuint..=last).next()
        {
            self.compiled.remove(&name);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::objects::lists::*;
    use std::collections::BTreeSet;

    /// Against a set of names, around the first and the last.
    #[test]
    fn runs_are_the_names_that_are_in_them() {
        let mut names = ListNames::default();
        let mut model: BTreeSet<GLuint> = BTreeSet::new();
        let mut random = 1u32;
        let mut below = |limit: u32| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 16) % limit
        };
        for _ in 0..3000 {
            let first = if below(2) == 0 { 1 + below(40) } else { GLuint::MAX - below(40) };
            let count = u64::from(below(6));
            let run = u64::from(first)..(u64::from(first) + count).min(END);
            match below(3) {
                0 => {
                    names.remove(first, count);
                    model.retain(|&name| !run.contains(&name.into()));
                }
                1 => {
                    names.insert(first, Arc::new(()));
                    model.insert(first);
                }
                _ if count > 0 => {
                    let free = |first: &u32| {
                        (*first..).take(count as usize).all(|name| !model.contains(&name))
                    };
                    let expected = (1..).find(free);
                    assert_eq!(names.take(count), expected);
                    model.extend((expected.expect("many")..).take(count as usize));
                }
                _ => {}
            }
            for name in (1..60).chain(GLuint::MAX - 60..=GLuint::MAX) {
                assert_eq!(names.contains(name), model.contains(&name), "{name}");
            }
            assert!(names.compiled.keys().all(|name| model.contains(name)));
        }
    }
}
