//! The calls, by subject. All have one shape:
//!
//! 1. **Convert**: enums and signed sizes become closed enums and unsigned numbers, with `Table::decode` and
//!    `not_negative`.
//! 2. **Validate** into a request (`…Request::new`): every rule is checked, in the order in which errors are reported. State
//!    is read only; draws that were recorded may be submitted, and warnings said. The request has what was checked, so
//!    nothing is converted, looked up or checked again.
//! 3. **Apply** (`…Request::apply`): changes state and objects. What fails here is memory: `GL_OUT_OF_MEMORY` leaves the
//!    state from before. Calls that write to the client's memory check that memory here, where they write
//!    ([`pixels::memory::write_pixels`]).
//!
//! A call whose body is one check and one assignment has no request type; nor has a query, which changes nothing. A call
//! needs one where several rules come before the change, or several calls share the rules or the change.
//!
//! The models are `texture/level_request.rs` (shared by all calls that specify a level; a proxy is a request of its own),
//! `texture/sub.rs` (a box of a level), `framebuffer/blit.rs` (several images, all read before one is written) and
//! `buffer/map.rs` (a request that borrows its object).

pub(crate) mod buffer;
pub(crate) mod captured_buffers;
pub(crate) mod color_index;
pub(crate) mod debug;
pub(crate) mod dispatch;
pub(crate) mod display_list;
pub(crate) mod enable;
pub(crate) mod evaluate;
pub(crate) mod flush;
pub(crate) mod fragment;
pub(crate) mod framebuffer;
pub(crate) mod lighting;
pub(crate) mod parameter_forms;
pub(crate) mod pixels;
pub(crate) mod program;
pub(crate) mod raster;
pub(crate) mod robustness;
pub(crate) mod sync;
pub(crate) mod texture;
pub(crate) mod transform;
pub(crate) mod transform_feedback;
pub(crate) mod vertex;
