//! Buffer objects in the client's hands: GL 2.1, section 2.9, `ARB_map_buffer_range`,
//! `ARB_copy_buffer`; and what is known of a buffer.
//!
//! A mapped buffer's bytes are taken out of it, so that a draw that was recorded earlier keeps what
//! it saw and nothing else can read them; calls that would are refused.
