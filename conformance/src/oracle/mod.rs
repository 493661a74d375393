//! The formulas in `f64`, written from the specification, one file a chapter.
//!
//! Each takes a [`Variant`](crate::mutation::Variant), which may have a mistake that the formula
//! then makes. Sections are those of the OpenGL 2.1 specification (December 2006).

pub mod adjacency;
pub mod anisotropy;
pub mod bernstein;
pub mod blend;
pub mod blit;
pub mod block;
pub mod bptc;
pub mod builtin;
pub mod combine;
pub mod compare;
pub mod coverage;
pub mod cube;
pub mod eac;
pub mod env;
pub mod etc;
pub mod filter;
pub mod format;
pub mod format_table;
pub mod fragment;
pub mod glsl;
pub mod glsl_matrix;
pub mod interpolation;
pub mod lecture;
pub mod line;
pub mod lod;
pub mod matrix;
pub mod mipmap;
pub mod packing;
pub mod painter;
pub mod pixel;
pub mod point;
pub mod polygon;
pub mod probes;
pub mod projection;
pub mod pyramid;
pub mod sample;
pub mod samples;
pub mod seamless;
pub mod second_color;
pub mod srgb;
pub mod std140;
pub mod swizzle;
pub mod target;
pub mod texture;
pub mod transform;
pub mod vertex;
pub mod vertex_array;
pub mod wrap;
