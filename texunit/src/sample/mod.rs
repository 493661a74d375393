//! The steps of a sample, in the order of the specification's chapter:
//! face → LOD → wrap → fetch and border → compare → filter → mip → probes → expand → swizzle.
//!
//! The modules from below: `wrap`, `cube`, `compare` and `expand` are single steps; `level_view`, `fetch`,
//! `interpolate`, `fast` and `filter` sample one level; `footprint`, `row_scan` and `level_taps` say which levels and
//! how; `general`, `uniform`, `direct`, `scattered` and `fused` are the kernels of whole samples, which `dispatch` chooses from.

mod call;
mod compare;
mod coordinates;
mod cube;
mod derivatives;
mod direct;
mod dispatch;
mod expand;
mod fast;
mod fetch;
mod filter;
mod footprint;
mod fused;
mod gather;
mod general;
mod interpolate;
mod level_taps;
mod level_view;
mod lod_query;
mod lookup;
mod prefetch;
mod recorder;
mod row_scan;
mod scattered;
mod scratch;
mod seamless;
mod texel_fetch;
mod uniform;
mod uniform_levels;
mod wrap;

pub use dispatch::NotDirect;
pub use fast::Addresses;
pub use fused::{FilteredTexels, TexelConsumer};
pub use lookup::{Lod, Points};
pub use prefetch::LevelHint;
pub use scratch::{AxisTexels, KEPT_AXES};
pub use scratch::{LookupScratch, SelectedLevels};
pub use uniform_levels::UniformLevels;
