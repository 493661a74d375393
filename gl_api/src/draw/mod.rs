//! The way of a draw from validated state to commands of the driver; `docs/draws.md` tells it from the entry point on.
//!
//! | module | does |
//! |---|---|
//! | `vertex_range`, `array_names` | takes what a draw reads of its vertex arrays; names arrays in messages |
//! | `pending_primitives`, `pending_bitmaps` | puts `glEnd`s, and bitmaps, that follow one another into one draw |
//! | `batching`, `draw_reuse` | takes over what was decided for the draw before |
//! | `record` | checks the state and goes through the steps of a draw, in order |
//! | `completeness`, `pass` | whether the framebuffer can be drawn to; opens its pass, and submits |
//! | `stages` | chooses the vertex and the fragment stage: programs (`assembly_stage`), or `fixed_function` |
//! | `textures`, `texture_buffer` | what stages sample |
//! | `state_words`, `assembly_words`, `uniform_blocks` | the uniform words of stages |
//! | `program_pipeline` | the programs of a pipeline as one |
//! | `pipeline`, `raster_state`, `color_clamp`, `material` | other state in the driver's terms |
//! | `emitted_state` | emits to the pass what differs from the draw before |
//! | `capture`, `feedback`, `vertex_stage` | transform feedback, selection and feedback: primitives beside the pass |
//! | `pixel_rectangle`, `pixel_zoom` | rectangles of pixels and bitmaps as draws |
//! | `warnings`, `watched_pixel`, `mirror` | what is said of a draw, what is noted of it, who is shown the picture |
//!
//! What these keep from one draw to the next is in [`crate::context`], in modules of the same names.

pub(crate) mod alpha_test;
pub(crate) mod sampler;

pub(crate) mod array_names;
pub(crate) mod assembly_stage;
pub(crate) mod assembly_words;
pub(crate) mod batching;
pub(crate) mod capture;
pub(crate) mod color_clamp;
pub(crate) mod completeness;
pub(crate) mod draw_reuse;
pub(crate) mod emitted_state;
pub(crate) mod es_capture;
pub(crate) mod es_completeness;
pub(crate) mod feedback;
pub(crate) mod fixed_function;
#[cfg(test)]
mod geometry_tests;
pub(crate) mod implicit_samples;
pub(crate) mod material;
mod mirror;
pub(crate) mod no_effect;
pub(crate) mod pass;
pub(crate) mod pending_bitmaps;
pub(crate) mod pending_primitives;
pub(crate) mod pipeline;
pub(crate) mod pixel_rectangle;
pub(crate) mod pixel_zoom;
pub(crate) mod program_pipeline;
pub(crate) mod raster_state;
pub(crate) mod record;
pub(crate) mod stages;
pub(crate) mod state_words;
pub(crate) mod texture_buffer;
pub(crate) mod textures;
pub(crate) mod uniform_blocks;
pub(crate) mod validate;
pub(crate) mod vertex_facts;
pub(crate) mod vertex_range;
pub(crate) mod vertex_stage;
pub(crate) mod warnings;
pub(crate) mod watched_pixel;
