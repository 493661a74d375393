//! The fixed function as a shader generator: state in, modules of the rasterizer's IR out.
//!
//! A module's key is the state that its code depends on, and nothing else; values that change from draw
//! to draw (matrices, products of lights and materials, environment colours, the alpha reference)
//! are uniform words ([`word`]).

pub(crate) mod clamp;
pub(crate) mod combine;
pub(crate) mod environment;
pub(crate) mod fog;
pub(crate) mod formula;
pub(crate) mod fragment;
pub(crate) mod light;
pub(crate) mod rewrite;
pub(crate) mod vertex;
pub(crate) mod word;

pub(crate) use crate::generate::fixed::fragment::FragmentKey;
pub(crate) use crate::generate::fixed::vertex::VertexKey;

use rasterizer::driver::ShaderModule;
use rasterizer::ir::{IrError, Module};
use std::collections::HashMap;

/// With more modules than this, the cache is emptied.
const KEPT: usize = 1024;

/// The cache of generated modules.
#[derive(Debug, Default)]
pub(crate) struct FixedModules {
    vertex: Modules<VertexKey>,
    fragment: Modules<FragmentKey>,
}

/// The modules of a stage, and the last one used: consecutive draws mostly use the same.
#[derive(Debug)]
struct Modules<K> {
    all: HashMap<K, ShaderModule>,
    last: Option<(K, ShaderModule)>,
}

impl<K> Default for Modules<K> {
    fn default() -> Self {
        Self { all: HashMap::new(), last: None }
    }
}

impl<K: Clone + Eq + std::hash::Hash> Modules<K> {
    fn get(&mut self, key: &K, make: fn(&K) -> Module) -> Result<ShaderModule, IrError> {
        if let Some((last, module)) = &self.last
            && last == key
        {
            return Ok(module.clone());
        }
        let module = cached(&mut self.all, key, make)?;
        self.last = Some((key.clone(), module.clone()));
        Ok(module)
    }
}

impl FixedModules {
    /// The vertex stage for this state.
    pub fn vertex(&mut self, key: &VertexKey) -> Result<ShaderModule, IrError> {
        self.vertex.get(key, vertex::module)
    }

    /// The fragment stage for this state.
    pub fn fragment(&mut self, key: &FragmentKey) -> Result<ShaderModule, IrError> {
        self.fragment.get(key, fragment::module)
    }
}

/// The cached value of a key, made if there is none.
pub(crate) fn cached<K: Clone + Eq + std::hash::Hash>(
    modules: &mut HashMap<K, ShaderModule>,
    key: &K,
    make: impl FnOnce(&K) -> Module,
) -> Result<ShaderModule, IrError> {
    if let Some(module) = modules.get(key) {
        return Ok(module.clone());
    }
    if modules.len() >= KEPT {
        modules.clear();
    }
    let module = ShaderModule::new(make(key))?;
    modules.insert(key.clone(), module.clone());
    Ok(module)
}
