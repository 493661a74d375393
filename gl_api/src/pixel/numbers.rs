//! Which numbers stored texels are.

use crate::pixel::client::format::Numbers;
use texunit::format::Format;

/// The numbers of what is read, for a copy.
pub(crate) fn numbers_of(format: Format) -> Numbers {
    if format.is_integer() { Numbers::Integer } else { Numbers::Fixed }
}
