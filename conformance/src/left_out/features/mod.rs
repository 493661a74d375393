//! The features, by what they are state of.

mod calls;
mod fragments;
mod shaders;
mod textures;
mod vertices;

use super::feature::Feature;

/// Every feature.
pub fn features() -> impl Iterator<Item = &'static Feature> + Clone {
    let lists: [&'static [Feature]; 5] =
        [textures::LIST, fragments::LIST, vertices::LIST, shaders::LIST, calls::LIST];
    lists.into_iter().flatten()
}
