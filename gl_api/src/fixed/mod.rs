//! The fixed function as a shader generator: state in, modules of the rasterizer's IR out.
//!
//! A module is keyed by the state that changes its code and by nothing else; what changes from draw
//! to draw (matrices, environment colours, the alpha reference) comes in uniform words.

mod environment;
mod fragment;
mod rewrite;
mod vertex;

pub(crate) use fragment::{
    FragmentKey, UnitKey, add_alpha_test, environment_base, set_shade_model,
};
pub(crate) use rewrite::{add_coverage, add_two_sides};
pub(crate) use vertex::VertexKey;

use crate::interface::MAX_TEXTURE_UNITS;
use rasterizer::driver::ShaderModule;
use rasterizer::ir::{Builder, IrError, Module, Op, Value};
use std::collections::HashMap;

/// The uniform words of the fixed function, counted from the first one. They follow those of the
/// program where one stage is a program's.
pub(crate) mod word {
    use super::MAX_TEXTURE_UNITS;

    /// Model-view-projection matrix, 16 words column by column.
    pub const MVP: u32 = 0;
    /// Texture matrices, 16 words a unit.
    pub const TEXTURE_MATRIX: u32 = MVP + 16;
    /// Environment colours, 4 words a unit.
    pub const ENV_COLOR: u32 = TEXTURE_MATRIX + 16 * MAX_TEXTURE_UNITS as u32;
    /// Reference of the alpha test.
    pub const ALPHA_REF: u32 = ENV_COLOR + 4 * MAX_TEXTURE_UNITS as u32;
    /// How many there are.
    pub const COUNT: u32 = ALPHA_REF + 1;
}

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
    pub fn vertex(&mut self, key: VertexKey) -> Result<ShaderModule, IrError> {
        cached(&mut self.vertex, key, vertex::module)
    }

    /// The fragment stage for this state.
    pub fn fragment(&mut self, key: FragmentKey) -> Result<ShaderModule, IrError> {
        cached(&mut self.fragment, key, fragment::module)
    }
}

/// What a cache holds for a key, made if need be.
pub(crate) fn cached<K: Clone + Eq + std::hash::Hash>(
    modules: &mut HashMap<K, ShaderModule>,
    key: K,
    make: impl FnOnce(&K) -> Module,
) -> Result<ShaderModule, IrError> {
    if let Some(module) = modules.get(&key) {
        return Ok(module.clone());
    }
    if modules.len() >= KEPT {
        modules.clear();
    }
    let module = ShaderModule::new(make(&key))?;
    modules.insert(key, module.clone());
    Ok(module)
}

/// Clamped to [0, 1]; NaN gives 0.
fn clamp(b: &mut Builder, value: Value) -> Value {
    let (zero, one) = (b.float(0.0), b.float(1.0));
    let value = b.op(Op::Max, &[value, zero]);
    b.op(Op::Min, &[value, one])
}
