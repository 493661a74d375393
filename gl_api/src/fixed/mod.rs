//! The fixed function as a shader generator: state in, modules of the rasterizer's IR out.
//!
//! A module is keyed by the state that changes its code and by nothing else; what changes from draw
//! to draw (matrices, products of lights and materials, environment colours, the alpha reference)
//! comes in uniform words ([`word`]).

mod combine;
mod environment;
mod fog;
mod fragment;
mod light;
mod vector;
mod vertex;
pub(crate) mod word;

pub(crate) use environment::{Environment, environment_base};
pub(crate) use fog::{FogKey, constants as fog_constants};
pub(crate) use fragment::{Coordinates, FragmentKey, UnitKey, add_alpha_test, set_shade_model};
pub(crate) use light::{LightKey, LightingKey, Place, Spot};
pub(crate) use vertex::{Generated, Normals, PointSize, VertexKey};

use rasterizer::driver::ShaderModule;
use rasterizer::ir::{IrError, Module};
use std::collections::HashMap;

/// More modules than this are forgotten and generated again.
const KEPT: usize = 1024;

/// The modules that were generated.
#[derive(Debug, Default)]
pub(crate) struct FixedModules {
    vertex: HashMap<VertexKey, ShaderModule>,
    fragment: HashMap<FragmentKey, ShaderModule>,
}

impl FixedModules {
    /// The vertex stage for this state.
    pub fn vertex(&mut self, key: &VertexKey) -> Result<ShaderModule, IrError> {
        cached(&mut self.vertex, key, vertex::module)
    }

    /// The fragment stage for this state.
    pub fn fragment(&mut self, key: &FragmentKey) -> Result<ShaderModule, IrError> {
        cached(&mut self.fragment, key, fragment::module)
    }
}

/// What a cache holds for a key, made if need be.
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
