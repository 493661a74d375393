//! Methods that a layer adds to a type of another.

use crate::resolve::{Target, resolve};
use crate::sources::Sources;
use std::collections::{BTreeMap, BTreeSet};

/// A method that one file alone defines, outside of the layer of its type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extension {
    /// The file that defines it.
    pub file: usize,
    /// The type.
    pub of: Target,
}

/// The methods outside of the layers of their types, under names that no other type and no trait of the crate has:
/// a name that two types have says nothing about which is called.
pub fn extensions(sources: &Sources) -> BTreeMap<&str, Extension> {
    let layer = |file: usize| sources.files[file].layer.as_deref();
    let mut definitions: BTreeMap<&str, Vec<Option<Extension>>> = BTreeMap::new();
    for (index, module) in sources.modules.iter().enumerate() {
        for method in &module.methods {
            let of = item(resolve(sources, index, &method.of.segments));
            let extension = of.and_then(|of| {
                let Target::Item(home, _) = &of else { return None };
                let is_outside = layer(sources.modules[*home].file) != layer(module.file);
                is_outside.then_some(Extension { file: module.file, of })
            });
            definitions.entry(&method.name).or_default().push(extension);
        }
        for method in &module.trait_methods {
            definitions.entry(method).or_default().push(None);
        }
    }
    definitions
        .into_iter()
        .filter_map(|(name, found)| match found.as_slice() {
            [Some(extension)] => Some((name, extension.clone())),
            _ => None,
        })
        .collect()
}

/// The item among what a path names.
pub fn item(targets: BTreeSet<Target>) -> Option<Target> {
    targets.into_iter().find(|target| matches!(target, Target::Item(..)))
}
