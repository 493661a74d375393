//! State queries: GL 2.1, chapter 6.

pub(crate) mod get;
