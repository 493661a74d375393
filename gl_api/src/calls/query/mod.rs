//! State queries: GL 2.1, chapter 6.

pub(crate) mod arrays;
pub(crate) mod extensions;
pub(crate) mod flush;
pub(crate) mod get;
pub(crate) mod table;

use crate::base::error::{Result, invalid_operation};

/// Writes the answer to a query; the slice must have room for all of it.
pub(crate) fn put<T: Copy>(params: &mut [T], values: &[T]) -> Result<()> {
    let (needed, has) = (values.len(), params.len());
    match params.get_mut(..needed) {
        Some(params) => {
            params.copy_from_slice(values);
            Ok(())
        }
        None => invalid_operation(
            "GL 2.1, section 6.1",
            format!("the answer has {needed} values, params has room for {has}"),
        ),
    }
}
