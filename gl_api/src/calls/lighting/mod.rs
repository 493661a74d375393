//! Lights, materials and fog.

pub(crate) mod fog;
pub(crate) mod light;
pub(crate) mod material;
